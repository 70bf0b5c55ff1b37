#include "cli/report/report_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/report/report_cpu_page.hpp"
#include "cli/report/report_html.hpp"
#include "cli/report/report_paper2_hardware.hpp"
#include "cli/report/report_paper2_page.hpp"
#include "cli/report/report_paper_page.hpp"
#include "glint/hard_cases.hpp"
#include "glint/lobes.hpp"

namespace glint::cli {
namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --text: #1f2328; --muted: #59636e; --page: #ffffff; --line: #d5dbe1;
  --soft: #f5f7f9; --accent: #0b5cad; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6edf3; --muted: #9aa4af; --page: #0d1117; --line: #30363d; --soft: #151b23; --accent: #6cb6ff;
    --bad: #ff8a80; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 66rem; padding: 1.5rem 1.25rem 4rem; background: var(--page); color: var(--text);
  font: 1rem/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  overflow-wrap: break-word; }
h1 { margin: .5rem 0 .75rem; font-size: 1.9rem; line-height: 1.2; letter-spacing: -.01em; }
h2 { margin: 3rem 0 .75rem; padding-top: .75rem; border-top: 1px solid var(--line); font-size: 1.3rem; }
h3 { margin: 1.75rem 0 .5rem; font-size: 1.05rem; }
p, dl { max-width: 46rem; }
a { color: var(--accent); }
code { font: .875em/1.45 ui-monospace, SFMono-Regular, Menlo, Consolas, monospace; }
code span { display: inline-block; max-width: 100%; }
sup, sub { font-size: .72em; line-height: 0; }
dt { margin-top: .6rem; font-weight: 600; }
dd { margin: 0; }
.scroll { overflow-x: auto; }
table { width: 100%; border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; }
th, td { padding: .45rem .6rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
thead th { border-bottom: 2px solid var(--line); color: var(--muted); font-weight: 600; vertical-align: bottom; }
td.number, th.number { text-align: right; }
tbody th { white-space: nowrap; }
td span, td small { white-space: nowrap; }
td.words, tbody th.words { min-width: 8.5rem; }
td.words span, tbody th.words { white-space: normal; }
td small, tbody th small { display: block; color: var(--muted); font-size: .78rem; font-weight: 400; }
.bad { color: var(--bad); font-weight: 700; }
p.bad { padding: .6rem .8rem; border: 2px solid; border-radius: .4rem; }
figure { margin: 1.5rem 0 0; }
figure img { display: block; width: 100%; height: auto; }
figcaption { max-width: 46rem; margin-top: .5rem; color: var(--muted); font-size: .9rem; }
figcaption p { margin: .35rem 0; }
.commands { padding-left: 2.2rem; font-size: .9rem; }
.commands li { margin: .3rem 0; }
footer { margin-top: 3rem; color: var(--muted); font-size: .9rem; }
@media (max-width: 46rem) {
  h1 { font-size: 1.55rem; }
  thead { display: none; }
  tbody tr { display: block; margin: 0 0 1rem; padding: .5rem .8rem; border: 1px solid var(--line);
    border-radius: .5rem; background: var(--soft); }
  tbody th, tbody td, td.number { display: flex; justify-content: space-between; gap: 1rem; padding: .25rem 0;
    border: 0; text-align: right; white-space: normal; }
  tbody th { font-size: 1rem; }
  td::before { content: attr(data-label); flex: none; max-width: 45%; color: var(--muted); text-align: left; }
  tbody td.words { display: block; text-align: left; }
  td.words::before { display: block; max-width: none; font-size: .78rem; }
}
)";

std::string place(const Worst& worst, int F) {
    return fmt::format("n&nbsp;=&nbsp;{}, cos&nbsp;{:.6f} (code&nbsp;{})", worst.n, std::ldexp(worst.cos_code, -F),
                       worst.cos_code);
}

std::string small_place(const Worst& worst, int F) {
    return fmt::format("<small>n = {}, cos {:.6f}<br>code {}</small>", worst.n, std::ldexp(worst.cos_code, -F),
                       worst.cos_code);
}

/// `code` of Markdown, which is all of it that occurs.
std::string markdown_html(std::string_view text) {
    std::string out;
    bool code = false;
    for (const char c : text) {
        if (c == '`') {
            code = !code;
            out += code ? "<code>" : "</code>";
        } else {
            out += escaped({&c, 1});
        }
    }
    return out;
}

class Page {
public:
    explicit Page(const PageData& data) : data_(data) {}

    std::string html() const {
        std::string out =
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" "
            "content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">\n"
            "<title>Glint: measured results</title>\n<style>";
        out += style;
        out += "</style>\n</head>\n<body>\n";
        out += introduction() + choosing_section(data_.plots.paper, data_.cpu);
        out += cost_section(data_.cost, data_.pictures);
        out += accuracy_section() + proofs_section() + runs_section() + plots_section();
        out += paper_sections(data_.plots.paper, data_.cpu, data_.pictures, data_.command);
        out += paper2_section(data_.plots.paper2, data_.models, data_.pictures, data_.command);
        out += paper2_hardware_section(data_.cost);
        out += speed_section(data_.cpu, data_.files);
        out += hard_cases_section() + commands_section();
        return out + "</body>\n</html>\n";
    }

private:
    /// A reference to the command that made the runs of a file.
    std::string source(const ResultFile& file) const {
        const auto number = &file - data_.files.data() + 1;
        return fmt::format("<a href=\"#command-{0}\">[{0}]</a>", number);
    }

    std::string introduction() const {
        std::size_t runs = 0;
        std::size_t failed = 0;
        for (const ResultFile& file : data_.files) {
            runs += file.runs.size();
            failed += static_cast<std::size_t>(
                std::count_if(file.runs.begin(), file.runs.end(),
                              [](const io::RunResult& run) { return run.hardware && run.hardware->mismatches > 0; }));
        }
        std::string out =
            "<header>\n<h1>Glint: measured results</h1>\n"
            "<p>Glint computes specular highlights on FPGAs. A lobe such as <code>bps</code> stands in for the "
            "Blinn-Phong highlight c<sup>n</sup>; c is the cosine of the angle between the surface normal and the "
            "half vector, n the specular exponent. A golden model states every bit of the fixed-point result, and the "
            "Verilog has to match it bit for bit. This page shows how far the results are from the real functions, "
            "and which runs held the hardware against the model. Every figure says at which input its worst case lies, "
            "how many inputs were tried, and which command measured it.</p>\n";
        if (failed > 0) {
            out += fmt::format("<p class=\"bad\">{} of {} runs found results that differ from the golden model.</p>\n",
                               failed, runs);
        }
        return out + "</header>\n";
    }

    std::string accuracy_section() const {
        std::string out =
            "<h2 id=\"accuracy\">Errors</h2>\n<dl>\n"
            "<dt>Rounding error</dt><dd>The fixed-point result against the lobe's own real function at the same input "
            "code, in units of the output's last bit (ulp). Below 1 ulp the result is faithful.</dd>\n"
            "<dt>Approximation error</dt><dd>The fixed-point result against c<sup>n</sup>, absolute; a full highlight "
            "is 1. <em>At the rounded cosine</em>, c is the value of the input code. <em>At the exact cosine</em>, it "
            "is the worse end of all cosines that round to the code, which adds what the input's own rounding costs."
            "</dd>\n<dt>Epicentre error</dt><dd>The approximation error at the rounded cosine, relative to "
            "c<sup>n</sup>, in the epicentre zone: from the highlight's centre to the inflection point of "
            "cos<sup>n</sup>, for n of 2 and more.</dd>\n</dl>\n";
        if (data_.measured.empty()) return out + "<p>None of the result files holds measured errors.</p>\n";
        std::vector<std::vector<Cell>> rows;
        for (const MeasuredRun& measured : data_.measured) {
            rows.push_back(accuracy_cells(measured, measured.accuracy().total));
            if (const Accuracy part = published_part(measured.accuracy()); part.inputs > 0) {
                rows.push_back(accuracy_cells(measured, part));
            }
        }
        return out + table_html(rows);
    }

    /// The lobe `bps` was published for n from here on; the smaller ones, where it errs most, would hide its error
    /// there.
    static constexpr int least_published_n = 8;

    /// Empty when the rows begin there anyway.
    static Accuracy published_part(const SweepResult& accuracy) {
        Accuracy out;
        if (accuracy.rows.empty() || accuracy.rows.front().n >= least_published_n) return out;
        for (const AccuracyRow& row : accuracy.rows) {
            if (row.n >= least_published_n) out.merge(row.accuracy);
        }
        return out;
    }

    /// The exponents of the rows from `least` on.
    static std::string exponents(const std::vector<AccuracyRow>& rows, int least) {
        const auto first =
            std::find_if(rows.begin(), rows.end(), [&](const AccuracyRow& row) { return row.n >= least; });
        const auto count = rows.end() - first;
        if (count == 0) return "–";
        if (count == 1) return fmt::format("{}", first->n);
        const int last = rows.back().n;
        const bool all = count == last - first->n + 1;
        return fmt::format("{} to {}{}", first->n, last, all ? "" : fmt::format("<small>{} values</small>", count));
    }

    std::vector<Cell> accuracy_cells(const MeasuredRun& measured, const Accuracy& a) const {
        const int F = measured.run->F;
        const auto with_place = [F](const std::string& value, const Worst& worst) {
            return value + small_place(worst, F);
        };
        const bool total = &a == &measured.accuracy().total;
        return {
            {"profile", measured.name(), Cell::name},
            {"n", exponents(measured.accuracy().rows, total ? 1 : least_published_n)},
            {"inputs", grouped(a.inputs) + (total && measured.run->exhaustive ? "<small>every legal one</small>" : "")},
            {"rounding, ulp", with_place(fmt::format("{:.4f}", a.rounding.value), a.rounding)},
            {"approximation, rounded cosine",
             with_place(fmt::format("{:.5f}", a.approximation.value), a.approximation)},
            {"approximation, exact cosine",
             with_place(fmt::format("{:.5f}", a.approximation_exact.value), a.approximation_exact)},
            {"epicentre, relative",
             a.epicentre.seen() ? with_place(fmt::format("{:.3f} %", 100 * a.epicentre.value), a.epicentre) : "–"},
            {"from", source(*measured.file)}};
    }

    std::string proofs_section() const {
        std::string out = "<h2 id=\"proven\">Proven bounds</h2>\n";
        if (!data_.proofs) {
            return out +
                   "<p>For this table write <code>proofs.json</code> with "
                   "<code>proofs/gappa/run.py --measured RESULTS --json proofs.json</code>, which needs the package "
                   "<code>gappa</code>, and give <code>--proofs proofs.json</code> to <code>glint report</code>.</p>\n";
        }
        out += fmt::format(
            "<p>What Gappa proves of the rounding error, for all real cosines in [0, 1] and all real n in [1, {0}], so "
            "for every input, tried or not; beside it the largest error measured. The nearer their ratio is to 1, the "
            "less the proof gives away. Proven and compared by <a href=\"#command-{1}\">[{1}]</a>.</p>\n",
            max_n, data_.files.size() + 1);
        std::vector<std::vector<Cell>> rows;
        for (const Proof& proof : data_.proofs->proofs) {
            for (const std::string& failure : proof.failures) {
                out += fmt::format("<p class=\"bad\">{}: {}</p>\n", proof.name(), escaped(failure));
            }
            out += contradiction(proof);
            rows.push_back(proof_cells(proof));
        }
        return out + table_html(rows);
    }

    /// The measured errors of this page need not be those that the proofs were compared with.
    std::string contradiction(const Proof& proof) const {
        for (const MeasuredRun& measured : data_.measured) {
            const double ulp = measured.accuracy().total.rounding.value;
            if (measured.name() == proof.name() && proof.ulp && ulp > *proof.ulp) {
                return fmt::format(
                    "<p class=\"bad\">{}: the rounding error of the results, {:.6f} ulp, is above the "
                    "proven bound.</p>\n",
                    proof.name(), ulp);
            }
        }
        return {};
    }

    static std::vector<Cell> proof_cells(const Proof& proof) {
        std::vector<Cell> out{
            {"profile", proof.name(), Cell::name},
            // Rounded up: what is shown is proven, too.
            {"proven, ulp", proof.ulp ? fmt::format("{:.4f}", std::ceil(*proof.ulp * 1e4) / 1e4) : std::string("–")}};
        if (!proof.measured) {
            for (const std::string_view label : {"measured, ulp", "measured / proven", "inputs measured"}) {
                out.push_back({label, "–"});
            }
            return out;
        }
        const Proof::Measured& measured = *proof.measured;
        out.push_back({"measured, ulp", fmt::format("{:.4f}", measured.ulp) +
                                            (measured.worst ? small_place(*measured.worst, measured.F) : "")});
        out.push_back(
            {"measured / proven", proof.ulp ? fmt::format("{:.3f}", measured.ulp / *proof.ulp) : std::string("–")});
        out.push_back({"inputs measured",
                       grouped(measured.inputs) + (measured.exhaustive ? "<small>every legal one</small>" : "")});
        return out;
    }

    std::string hard_cases_section() const {
        std::string out =
            fmt::format("<h2 id=\"hard-cases\">Hard cases</h2>\n<p>{}</p>\n", markdown_html(hard_case_legend()));
        for (const Lobe& lobe : lobes()) {
            const bool reported = std::any_of(data_.files.begin(), data_.files.end(), [&](const ResultFile& file) {
                return std::any_of(file.runs.begin(), file.runs.end(),
                                   [&](const io::RunResult& run) { return run.lobe == lobe.name; });
            });
            if (reported) out += hard_cases_html(hard_case_table(lobe));
        }
        return out + hard_cases_html(stream_case_table());
    }

    static std::string hard_cases_html(const HardCaseTable& table) {
        std::vector<std::vector<Cell>> rows;
        for (const std::vector<std::string>& texts : table.rows) {
            std::vector<Cell>& row = rows.emplace_back();
            for (std::size_t i = 0; i < texts.size(); ++i) {
                std::string html = escaped(texts[i]);
                // Input and result on a line each: three profiles fit a screen side by side.
                if (const std::size_t arrow = html.find("-&gt;"); i >= table.sentences && arrow != std::string::npos) {
                    html.insert(arrow, "<br>");
                }
                row.push_back({table.columns[i], html, i < table.sentences ? Cell::words : Cell::number});
            }
        }
        return fmt::format("<h3>{}</h3>\n", escaped(table.title)) + table_html(rows);
    }

    std::string runs_section() const {
        std::string out =
            "<h2 id=\"runs\">Runs</h2>\n<p>Units: <code>core</code> and <code>axis</code> are the simulated Verilog, "
            "with plain handshakes and with AXI4-Stream; <code>model</code> is the golden model alone, which has no "
            "clock and nothing to mismatch. A mismatch is a result that differs from the golden model in any bit. "
            "Vectors per second is the speed of the run itself, on the machine that ran it.</p>\n";
        std::vector<std::vector<Cell>> rows;
        for (const ResultFile& file : data_.files) {
            for (const io::RunResult& run : file.runs) rows.push_back(run_cells(file, run));
        }
        return out + table_html(rows);
    }

    std::vector<Cell> run_cells(const ResultFile& file, const io::RunResult& run) const {
        std::vector<Cell> out{{"profile", run.lobe + " " + run.profile, Cell::name},
                              {"architecture", run.architecture.empty() ? "–" : escaped(run.architecture), Cell::name},
                              {"unit", run.unit, Cell::name}};
        std::string test = run.test;
        if (run.hardware) {
            test += fmt::format("<small>stall probability {:g}, seed {}</small>", run.hardware->stall_probability,
                                run.hardware->seed);
        }
        out.push_back({"test", test, Cell::name});
        out.push_back({"inputs", grouped(run.inputs) + (run.exhaustive ? "<small>every legal one</small>" : "")});
        if (run.hardware) {
            const io::HardwareResult& hardware = *run.hardware;
            const bool bad = hardware.mismatches > 0;
            out.push_back(
                {"mismatches",
                 bad ? fmt::format("<span class=\"bad\">{}</span>", grouped(hardware.mismatches)) : std::string("0")});
            out.push_back(
                {"latency, cycles", hardware.latency_cycles > 0 ? fmt::format("{}", hardware.latency_cycles) : "–"});
            out.push_back({"results per cycle",
                           hardware.results_per_cycle > 0 ? fmt::format("{:.3f}", hardware.results_per_cycle) : "–"});
        } else {
            for (const std::string_view label : {"mismatches", "latency, cycles", "results per cycle"}) {
                out.push_back({label, "–"});
            }
        }
        out.push_back(
            {"vectors per second",
             run.seconds > 0 ? fmt::format("{:.2f} M", static_cast<double>(run.inputs) / run.seconds / 1e6) : "–"});
        out.push_back({"from", source(file)});
        return out;
    }

    std::string own_command() const { return fmt::format("<p>Computed by {}</p>", command_html(data_.command)); }

    std::string plots_section() const {
        const Curves& curves = data_.plots.curves;
        const ErrorMap& map = data_.plots.map;
        std::string out = fmt::format("<h2 id=\"shape\">The highlight at n = {}</h2>\n", curves.n);
        out += figure_html(
            data_.pictures, curves_plot,
            fmt::format("The highlight over the angle at n = {}: the curve of bps lies close to Blinn-Phong's "
                        "c^n, Schlick's falls off too slowly.",
                        curves.n),
            fmt::format("<p>The real functions, in double: Blinn-Phong's c<sup>n</sup>, Schlick's "
                        "f<sub>s</sub>, and f<sub>bps</sub>, a cubic polynomial in f<sub>s</sub>. Largest "
                        "absolute error against c<sup>n</sup> at this n, over {} angles from 0° to 90°: "
                        "f<sub>s</sub> {:.4f} at {:.2f}°, f<sub>bps</sub> {:.4f} at {:.2f}°.</p>{}",
                        grouped(angles), curves.schlick.value, curves.schlick.degrees, curves.bps.value,
                        curves.bps.degrees, own_command()));
        out += fmt::format("<h2 id=\"map\">Where {} errs</h2>\n", map.profile.name);
        out += figure_html(
            data_.pictures, map_plot,
            "Map of the signed error over the exponent and the angle. Above n = 10 it forms bands along the "
            "highlight's "
            "width, within 0.03; below n = 8 the bands are deeper.",
            fmt::format("<p>Signed approximation error of golden <code>bps</code> at <code>{}</code> at the rounded "
                        "cosine, result minus c<sup>n</sup>; both axes are logarithmic. The colours end at ±{:g}. The "
                        "broken line is the edge of the epicentre zone. Largest absolute error in the map: {:.4f} at "
                        "{}; inputs tried: {}.</p>{}",
                        map.profile.name, map_scale, map.worst.value, place(map.worst, map.profile.F),
                        grouped(map.inputs), own_command()));
        if (data_.plots.measured.empty()) {
            return out +
                   "<p>None of the result files holds errors per n, so there are no plots over n. Both "
                   "<code>glint sweep --json</code> and <code>glint-cosim --json</code> measure them.</p>\n";
        }
        out += "<h2 id=\"approximation\">Approximation error over n</h2>\n";
        out +=
            figure_html(data_.pictures, approximation_plot,
                        "Largest absolute error against c^n over the exponent, at the rounded and at the exact cosine, "
                        "for Schlick's function and for every profile.",
                        approximation_caption());
        out += "<h2 id=\"rounding\">Rounding error over n</h2>\n";
        out += figure_html(data_.pictures, rounding_plot,
                           "Largest rounding error in ulp over the exponent for every profile, with a line at 1 ulp.",
                           rounding_caption());
        return out;
    }

    std::string approximation_caption() const {
        const std::vector<AngleError>& schlick = data_.plots.schlick;
        const auto worst = std::max_element(schlick.begin(), schlick.end(),
                                            [](const AngleError& a, const AngleError& b) { return a.value < b.value; });
        std::string out =
            "<p>Largest absolute error against c<sup>n</sup> at each n, of the fixed-point results. f<sub>s</sub> is "
            "exact at n = 1, so its curve begins at n = 2.</p><ul>";
        for (const MeasuredRun& measured : data_.plots.measured) {
            const Accuracy& total = measured.accuracy().total;
            const int F = measured.run->F;
            out += fmt::format(
                "<li>{}: at the rounded cosine {:.5f} at {}; at the exact cosine {:.5f} at {}; inputs "
                "tried: {}. {}</li>",
                measured.name(), total.approximation.value, place(total.approximation, F),
                total.approximation_exact.value, place(total.approximation_exact, F), grouped(total.inputs),
                command_html(measured.file->command));
        }
        out += fmt::format(
            "<li>f<sub>s</sub>, the real function in double, for comparison: {:.5f} at n = {}, {:.2f}°; "
            "inputs tried: {}. {}</li></ul>",
            worst->value, worst - schlick.begin() + 1, worst->degrees,
            grouped(static_cast<std::uint64_t>(angles) * schlick.size()), command_html(data_.command));
        return out;
    }

    std::string rounding_caption() const {
        std::string out =
            "<p>Largest error at each n against the lobe's own real function at the same input code.</p><ul>";
        for (const MeasuredRun& measured : data_.plots.measured) {
            const Accuracy& total = measured.accuracy().total;
            out += fmt::format("<li>{}: {:.4f} ulp at {}; inputs tried: {}. {}</li>", measured.name(),
                               total.rounding.value, place(total.rounding, measured.run->F), grouped(total.inputs),
                               command_html(measured.file->command));
        }
        return out + "</ul>";
    }

    std::string commands_section() const {
        std::string out =
            "<h2 id=\"commands\">Commands</h2>\n<p>Each of them wrote one file of results.</p>\n<ol "
            "class=\"commands\">\n";
        for (std::size_t i = 0; i < data_.files.size(); ++i) {
            const ResultFile& file = data_.files[i];
            out += fmt::format("<li id=\"command-{}\">{} ({} {})</li>\n", i + 1, command_html(file.command),
                               escaped(file.tool), escaped(file.version));
        }
        if (data_.proofs) {
            out += fmt::format("<li id=\"command-{}\">{}</li>\n", data_.files.size() + 1,
                               command_html(data_.proofs->command));
        }
        out += "</ol>\n";
        return out + fmt::format("<footer><p>This page: {} (glint {})</p></footer>\n", command_html(data_.command),
                                 GLINT_VERSION);
    }

    const PageData& data_;
};

}  // namespace

std::string page(const PageData& data) { return Page(data).html(); }

}  // namespace glint::cli
