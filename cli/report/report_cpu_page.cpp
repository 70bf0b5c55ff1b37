#include "cli/report/report_cpu_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/report/report_html.hpp"
#include "glint/lobes.hpp"
#include "studies/forms.hpp"
#include "studies/paper.hpp"

namespace glint::cli {
namespace {

/// f_kv as f with an index; nothing for lobes that are not of the paper.
std::string symbol_html(std::string_view lobe) {
    for (const studies::paper::TableRow& row : studies::paper::table_1()) {
        if (row.lobe == lobe) return fmt::format("f<sub>{}</sub>", row.symbol.substr(2));
    }
    return {};
}

// ---- Table 1 -----------------------------------------------------------------------------------------------------

std::string operations_text(const Operations& o) {
    return fmt::format("{} {} {} {} {}", o.multiplications, o.divisions, o.additions, o.increments, o.comparisons);
}

/// What the code has more or less than the paper prints.
std::string count_remark(const Operations& printed, const Operations& counted) {
    std::string out;
    const auto compare = [&](int p, int c, std::string_view what) {
        if (p != c) out += fmt::format("<small>{} {:+}</small>", what, c - p);
    };
    compare(printed.multiplications, counted.multiplications, "multiplications");
    compare(printed.divisions, counted.divisions, "divisions");
    compare(printed.additions, counted.additions, "additions");
    compare(printed.increments, counted.increments, "increments");
    compare(printed.comparisons, counted.comparisons, "comparisons");
    return out;
}

const studies::paper::TableRow* table_row(std::string_view lobe) {
    const auto rows = studies::paper::table_1();
    const auto it =
        std::find_if(rows.begin(), rows.end(), [&](const studies::paper::TableRow& row) { return row.lobe == lobe; });
    return it == rows.end() ? nullptr : &*it;
}

std::string with_ratio(const std::string& text, double own, double other) {
    return fmt::format("{}<small>{:.2f}</small>", text, own / other);
}

/// A measure of an evaluation in double, and where it stands.
struct Measured {
    std::string_view label, name;
    std::string_view form;
    std::optional<double> (*value)(const CpuPrice&);
};
constexpr Measured measured_costs[] = {
    {"latency, ns", "latency", "scalar", [](const CpuPrice& price) { return price.latency; }},
    {"throughput, ns", "throughput", "scalar", [](const CpuPrice& price) { return std::optional(price.throughput); }},
    {"instructions", "instructions", "scalar", [](const CpuPrice& price) { return price.instructions; }},
    {"batch, ns", "batch", "batch", [](const CpuPrice& price) { return std::optional(price.throughput); }},
};

std::optional<double> cost(const CpuPrices& cpu, std::string_view name, std::string_view type,
                           const Measured& measured) {
    const CpuPrice* price = cpu.find(name, type, measured.form);
    return price == nullptr ? std::nullopt : measured.value(*price);
}

void add_prices(std::vector<Cell>& row, const CpuPrices& cpu, std::string_view name) {
    for (const Measured& measured : measured_costs) {
        const auto own = cost(cpu, name, "double", measured);
        const auto base = cost(cpu, "schlick", "double", measured);
        row.push_back({measured.label, own && base ? with_ratio(fmt::format("{:.2f}", *own), *own, *base) : "–"});
    }
}

/// How far from the printed ratio a measured one may be to count as the same.
constexpr double ratio_tolerance = 0.1;

/// Which measures bear out what Table 1 says of f_bps, and which do not.
std::string headline(const CpuPrices& cpu, double printed) {
    std::string agree, differ;
    for (const Measured& measured : measured_costs) {
        const auto own = cost(cpu, "bps", "double", measured);
        const auto base = cost(cpu, "schlick", "double", measured);
        if (!own || !base) continue;
        const double ratio = *own / *base;
        std::string& list = std::abs(ratio / printed - 1.0) <= ratio_tolerance ? agree : differ;
        list += fmt::format("{}{} {:.2f}", list.empty() ? "" : ", ", measured.name, ratio);
    }
    return fmt::format(
        "<p>f<sub>bps</sub> is said to take {:.2f} times as long as f<sub>s</sub>. In double, within {:g} % of that: "
        "{}. Not so: {}.</p>\n",
        printed, 100.0 * ratio_tolerance, agree.empty() ? "nothing" : agree, differ.empty() ? "nothing" : differ);
}

/// “f_bps costs 28 cycles where f_s costs 15”, and the other rows, against what is measured.
std::string claim_of_table_1(const CpuPrices& cpu) {
    const double base_cycles = table_row("schlick")->cycles;
    std::string out =
        "<h3>What is true of it</h3>\n<p>The ratio of each row to f<sub>s</sub>: printed, and measured in double and "
        "in float.</p>\n";
    out += headline(cpu, table_row("bps")->cycles / base_cycles);
    std::vector<std::vector<Cell>> rows;
    for (const studies::paper::TableRow& printed : studies::paper::table_1()) {
        if (printed.lobe == "schlick") continue;
        std::vector<Cell> row{{"lobe", lobe_html(printed.lobe), Cell::name},
                              {"printed", fmt::format("{:.2f}", printed.cycles / base_cycles)}};
        static const std::string labels[] = {
            "latency",        "throughput",        "instructions",        "batch",
            "latency, float", "throughput, float", "instructions, float", "batch, float"};
        const std::string* label = labels;
        for (const std::string_view type : {"double", "float"}) {
            for (const Measured& measured : measured_costs) {
                const auto own = cost(cpu, printed.lobe, type, measured);
                const auto base = cost(cpu, "schlick", type, measured);
                row.push_back({*label++, own && base ? fmt::format("{:.2f}", *own / *base) : "–"});
            }
        }
        rows.push_back(std::move(row));
    }
    return out + table_html(rows);
}

}  // namespace

std::string measured_by(const CpuPrices& cpu) {
    return fmt::format("Measured on {} by {} ({}; {}).", escaped(cpu.cpu), command_html(cpu.command),
                       escaped(cpu.compiler), escaped(cpu.date));
}

std::string missing_cpu_prices(std::string_view program, std::string_view option) {
    return fmt::format(
        "<p>For measured times write <code>{1}.json</code> with <code>bench/run.py --bench build/release/{0} --json "
        "{1}.json</code>, and give <code>--{1} {1}.json</code> to <code>glint report</code>.</p>\n",
        program, option);
}

std::string lobe_html(std::string_view lobe) {
    const std::string symbol = symbol_html(lobe);
    return fmt::format("{}{}", lobe, symbol.empty() ? "" : "<small>" + symbol + "</small>");
}

std::string costs_section(const std::optional<CpuPrices>& cpu) {
    const auto latencies = studies::paper::latencies_of_table_1(30);
    std::string out =
        "<h2 id=\"costs\">The paper's Table 1: operations, cycles and time</h2>\n"
        "<p>Operations are multiplications, divisions, additions, increments (and decrements) and comparisons, in this "
        "order. Those of the code are counted by running each formula with a number type that counts. A call is one of "
        "exp, acos or pow from the C++ library, with cycles of its own.</p>\n";
    if (latencies.size() == 1) {
        const Operations::Latencies& l = latencies.front();
        out += fmt::format(
            "<p>The paper gives sums of the latencies of Zen 4, not the latencies. Among all of 1 to 30 cycles only "
            "one set adds up in all five rows: {} for a multiplication, {} for a division, {} for an addition, {} for "
            "an increment, {} for a comparison. Those are latencies of integer instructions, and the formulas are not "
            "integer. With the latencies of scalar double instructions ({}, {}, {}, {} and {}; LLVM's scheduling model "
            "of Zen 4, <code>X86ScheduleZnver4.td</code>, classes WriteFMul64, WriteFDiv64, WriteFAdd64, WriteFCmp64; "
            "an increment is an addition) the sums are in the column after that. A sum of latencies holds for a chain "
            "without parallel steps; the measured latency knows what really waits. Where the code needs other "
            "operations "
            "than the paper prints, the table has the difference.</p>\n",
            l.multiplication, l.division, l.addition, l.increment, l.comparison, zen4_double.multiplication,
            zen4_double.division, zen4_double.addition, zen4_double.increment, zen4_double.comparison);
    } else {
        out += fmt::format("<p>{} sets of latencies of 1 to 30 cycles add up in all five rows of the paper.</p>\n",
                           latencies.size());
    }
    if (cpu) {
        out +=
            "<p>Times and instructions are those of double, one evaluation at a time: medians in nanoseconds. "
            "<em>Latency</em>: each evaluation waits for the one before. <em>Throughput</em>: they are independent. "
            "<em>Batch</em>: independent, over arrays, in vector instructions where nothing of the C library is "
            "called. <em>Instructions</em> are those of one evaluation with its loop, counted by Valgrind. The small "
            "numbers are ratios to f<sub>s</sub>; docs/cpu-cost.md has the conditions. " +
            measured_by(*cpu) + "</p>\n";
    } else {
        out += missing_cpu_prices();
    }
    std::vector<std::vector<Cell>> rows;
    for (const Form& form : forms()) {
        const Operations counted = form.count();
        const studies::paper::TableRow* printed = form.name == form.lobe ? table_row(form.lobe) : nullptr;
        std::string counts = operations_text(counted);
        if (counted.calls > 0)
            counts += fmt::format("<small>and {} call{}</small>", counted.calls, counted.calls > 1 ? "s" : "");
        if (printed != nullptr) counts += count_remark(printed->operations, counted);
        std::vector<Cell> row{
            {"lobe", lobe_html(form.lobe) + fmt::format("<small>{}</small>", escaped(form.formula)), Cell::words},
            {"operations, printed", printed != nullptr ? operations_text(printed->operations) : "–"},
            {"operations, counted", counts},
            {"cycles, printed", printed != nullptr ? with_ratio(fmt::format("{}", printed->cycles), printed->cycles,
                                                                table_row("schlick")->cycles)
                                                   : "–"},
            {"cycles, same sum",
             counted.calls == 0 && latencies.size() == 1 ? fmt::format("{}", counted.cycles(latencies.front())) : "–"},
            {"cycles, Zen 4 double", counted.calls == 0 ? fmt::format("{}", counted.cycles(zen4_double)) : "–"}};
        if (cpu) add_prices(row, *cpu, form.name);
        rows.push_back(std::move(row));
    }
    out += table_html(rows);
    if (cpu) out += claim_of_table_1(*cpu);
    return out +
           "<p>f<sub>8</sub> and f<sub>kub</sub> need a cut to 0, and the paper says that the cuts are counted; its "
           "rows for them have no comparison, and why f<sub>kub</sub> has a division when its coefficients come from a "
           "memory is not explained.</p>\n";
}

namespace {

std::string time_text(const CpuPrice* price) {
    return price == nullptr
               ? "–"
               : fmt::format("{:.3g}<small>{:.3g} to {:.3g}</small>", price->throughput, price->q1, price->q3);
}

std::string number_text(const std::optional<double>& value, std::string_view format) {
    return value ? fmt::format(fmt::runtime(format), *value) : "–";
}

std::string prices_table(const CpuPrices& cpu, std::string_view type) {
    std::vector<std::string_view> names;
    for (const CpuPrice& price : cpu.prices) {
        if (price.type == type && std::find(names.begin(), names.end(), price.name) == names.end())
            names.push_back(price.name);
    }
    if (names.empty()) return "<p>None were measured.</p>\n";
    std::vector<std::vector<Cell>> rows;
    for (const std::string_view name : names) {
        const CpuPrice* scalar = cpu.find(name, type, "scalar");
        const CpuPrice* batch = cpu.find(name, type, "batch");
        const std::string& formula = (scalar != nullptr ? scalar : batch)->formula;
        const auto instructions = [](const CpuPrice* price) {
            return price == nullptr ? "–" : number_text(price->instructions, "{:.1f}");
        };
        rows.push_back({{"lobe or rival", fmt::format("{}<small>{}</small>", name, escaped(formula)), Cell::words},
                        {"latency, ns", scalar == nullptr ? "–" : number_text(scalar->latency, "{:.2f}")},
                        {"throughput, ns", time_text(scalar)},
                        {"instructions", instructions(scalar)},
                        {"batch, ns", time_text(batch)},
                        {"batch, instructions", instructions(batch)}});
    }
    return table_html(rows);
}

std::string millions(double per_second) { return fmt::format("{:.1f}", per_second / 1e6); }

std::string millions(const CpuPrice* price) { return price == nullptr ? "–" : millions(1e9 / price->throughput); }

/// A run of hardware at full speed on all its inputs, with the golden model beside it; empty where there is none.
std::string cosimulation_table(const std::optional<CpuPrices>& cpu, const std::vector<ResultFile>& files) {
    const auto sweep = [&](const io::RunResult& wanted) -> const io::RunResult* {
        for (const ResultFile& file : files) {
            for (const io::RunResult& run : file.runs) {
                if (run.unit == "model" && run.lobe == wanted.lobe && run.profile == wanted.profile && run.seconds > 0)
                    return &run;
            }
        }
        return nullptr;
    };
    std::vector<std::vector<Cell>> rows;
    for (const ResultFile& file : files) {
        for (const io::RunResult& run : file.runs) {
            if (!run.hardware || run.seconds <= 0) continue;
            const double rate = static_cast<double>(run.inputs) / run.seconds;
            const CpuPrice* batch = cpu ? cpu->find(run.lobe, "fixed", "batch") : nullptr;
            const CpuPrice* scalar = cpu ? cpu->find(run.lobe, "fixed", "scalar") : nullptr;
            // The prices are those of one profile.
            if (batch != nullptr && batch->profile != run.profile) batch = nullptr;
            if (scalar != nullptr && scalar->profile != run.profile) scalar = nullptr;
            const io::RunResult* swept = sweep(run);
            rows.push_back(
                {{"lobe", run.lobe + " " + escaped(run.profile), Cell::name},
                 {"architecture", run.architecture.empty() ? "–" : escaped(run.architecture), Cell::name},
                 {"unit", escaped(run.unit) + "<small>" + escaped(run.test) + "</small>", Cell::name},
                 {"inputs", grouped(run.inputs)},
                 {"cosimulation, M/s", millions(rate)},
                 {"sweep, M/s", swept == nullptr ? "–" : millions(static_cast<double>(swept->inputs) / swept->seconds)},
                 {"golden batch, M/s", millions(batch)},
                 {"golden scalar, M/s", millions(scalar)},
                 {"batch / cosimulation",
                  batch == nullptr ? "–" : fmt::format("{:.1f}", 1e9 / batch->throughput / rate)}});
        }
    }
    return rows.empty() ? std::string() : table_html(rows);
}

}  // namespace

std::string speed_section(const std::optional<CpuPrices>& cpu, const std::vector<ResultFile>& files) {
    std::string out = "<h2 id=\"speed\">Speed in software</h2>\n";
    if (cpu) {
        out +=
            "<p>Nanoseconds a result, the median with its quartiles: every lobe as a plain formula in double and in "
            "float, and as the golden model in fixed point; with them what people use for c<sup>n</sup> today. "
            "<code>pow</code> is the same code as <code>blinn_phong</code>: what lies between the two is chance. " +
            measured_by(*cpu) + fmt::format(" Flags: <code>{}</code>.</p>\n", escaped(cpu->flags));
        out += "<h3>In double</h3>\n" + prices_table(*cpu, "double");
        out += "<h3>In float</h3>\n" + prices_table(*cpu, "float");
        out += "<h3>In fixed point: the golden model</h3>\n" + prices_table(*cpu, "fixed");
    } else {
        out += missing_cpu_prices();
    }
    out += "<h3>What cosimulation costs</h3>\n";
    const std::string table = cosimulation_table(cpu, files);
    if (table.empty()) return out + "<p>None of the result files holds a run of simulated hardware.</p>\n";
    return out +
           "<p>Millions of vectors a second. A cosimulation runs the Verilog, the golden model and the comparison, and "
           "measures errors where the results have them; a sweep is the golden model with the errors. Both are as the "
           "results tell, with the threads that they were run with. The golden model alone runs on one thread.</p>\n" +
           table;
}

}  // namespace glint::cli
