// `glint eval`: one input of a lobe or of an effect with every intermediate value, or a stream of inputs.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/fixed_point.hpp"
#include "glint/lobe_unit.hpp"
#include "glint/reference.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

/// The values of an effect's input ports as given: --<port> x or --<port>-code c.
struct PortValues {
    std::map<std::string, std::string> reals, codes;
};

struct EvalOptions {
    std::string effect;
    PortValues ports;
    std::string lobe = "bps";
    std::string profile = "p12";
    int n = 0;
    std::string cosine;
    std::int64_t cos_code = 0;
    bool from_stdin = false;
    std::string json;
    bool port = false;  ///< correct what is out of range instead of refusing it
};

using Codes = std::vector<std::int64_t>;  // one for each input port

/// What is evaluated: the unit of a lobe or of an effect.
struct Unit {
    std::unique_ptr<GoldenModel> lobe;  ///< of a lobe; for an effect there is none
    std::unique_ptr<EffectModel> model;

    /// Throws Error where the codes are not legal, with `port` only where no port can carry them.
    void check(const Codes& in, bool port) const {
        const auto ports = model->inputs();
        for (std::size_t p = 0; p < ports.size(); ++p) {
            const bool legal = port ? in[p] >= ports[p].least() && in[p] <= ports[p].greatest()
                                    : in[p] >= ports[p].low && in[p] <= ports[p].high;
            if (legal) continue;
            if (lobe) {
                // Its own words. What an int cannot hold stays out of range.
                const int n = static_cast<int>(std::clamp<std::int64_t>(in[0], -1, max_n + 1));
                port ? static_cast<void>(lobe->eval_port(n, in[1])) : static_cast<void>(lobe->eval(n, in[1]));
            }
            if (port) model->eval_port(in);
            throw Error(fmt::format("{} code {} is not legal: {} to {} (--port corrects)", ports[p].name, in[p],
                                    ports[p].low, ports[p].high));
        }
    }
};

Unit make_unit(const EvalOptions& options) {
    if (!options.effect.empty()) {
        return {nullptr, find_effect(options.effect).golden(parse_profile(options.profile), options.lobe)};
    }
    const LobeChoice choice = parse_lobe(options.lobe);
    Unit out{choice.lobe->golden(choice.profile(options.profile)), nullptr};
    out.model = lobe_unit(*out.lobe);
    return out;
}

double parse_real(const std::string& text, std::string_view port) {
    double x = 0.0;
    const char* const last = text.data() + text.size();
    const char* const first = text.data() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
    const auto [end, error] = std::from_chars(first, last, x);
    if (error == std::errc::result_out_of_range) x = std::strtod(text.c_str(), nullptr);  // next to 0, or infinite
    if (error == std::errc::invalid_argument || end != last || !std::isfinite(x)) {
        throw Error(fmt::format("--{} '{}' is not legal: a finite number", port, text));
    }
    return x;
}

/// A code for each input port, from the command line.
Codes effect_input(const EffectModel& model, const PortValues& values) {
    std::set<std::string> unknown;
    for (const auto& [name, text] : values.reals) unknown.insert(name);
    for (const auto& [name, text] : values.codes) unknown.insert(name);
    Codes in;
    std::string names;
    for (const EffectPort& port : model.inputs()) {
        const std::string name(port.name);
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
        const auto real = values.reals.find(name);
        const auto code = values.codes.find(name);
        if (code != values.codes.end()) {
            in.push_back(
                io::parse_integer(code->second, fmt::format("--{}-code", name), port.least(), port.greatest()));
        } else if (real != values.reals.end()) {
            in.push_back(port.code(parse_real(real->second, port.name)));
        } else {
            throw Error(fmt::format("--{0} or --{0}-code is missing: {1} to {2} (codes {3} to {4})", name,
                                    port.real(port.low), port.real(port.high), port.low, port.high));
        }
        unknown.erase(name);
    }
    if (!unknown.empty()) {
        throw Error(
            fmt::format("--{} is not legal for {}: its inputs are {}", *unknown.begin(), model.effect(), names));
    }
    return in;
}

std::string described(std::span<const EffectPort> ports, const Codes& codes) {
    std::string out;
    for (std::size_t p = 0; p < ports.size(); ++p) {
        out += fmt::format("{}{} {}", p == 0 ? "" : ", ", ports[p].name, codes[p]);
    }
    return out;
}

/// n and the cosine's code of a lobe, from the command line.
Codes lobe_input(const GoldenModel& model, const EvalOptions& options, bool has_code) {
    if (has_code) return {options.n, options.cos_code};
    const double cosine = parse_real(options.cosine, "cos");
    const std::int64_t code = quantize_cosine(cosine, model.profile().F);
    if (!options.port && (code < 0 || code > model.profile().one())) {
        throw Error(fmt::format("cosine {} is not legal: 0 to 1", cosine));
    }
    return {options.n, code};
}

/// What the results are beside: the unit's name and inputs in JSON, and the line above the table.
std::string inputs(const Unit& unit, const Codes& in, nlohmann::ordered_json& json) {
    const EffectModel& model = *unit.model;
    json[unit.lobe ? "lobe" : "effect"] = model.effect();
    json["profile"] = model.profile().name;
    if (unit.lobe) {
        json["n"] = in[0];
        json["cos_code"] = in[1];
        return fmt::format("{} {} n {} cos code {} (c = {:.9f})", model.effect(), model.profile().name, in[0], in[1],
                           model.inputs()[1].real(in[1]));
    }
    json["inputs"] = nlohmann::ordered_json::object();
    for (std::size_t p = 0; p < in.size(); ++p) json["inputs"][std::string(model.inputs()[p].name)] = in[p];
    return fmt::format("{} {} {}", model.effect(), model.profile().name, described(model.inputs(), in));
}

int show(const Unit& unit, const Codes& in, const EvalOptions& options, const std::string& command) {
    const EffectModel& model = *unit.model;
    unit.check(in, options.port);
    const EffectResult result = model.eval_port(in);
    std::vector<double> arguments;
    for (std::size_t p = 0; p < in.size(); ++p) arguments.push_back(model.inputs()[p].real(in[p]));
    // The model's own real function, which knows the numbers of a custom profile and the options of a lobe.
    const std::vector<double> real = model.reference(arguments);
    nlohmann::ordered_json json{{"tool", "glint eval"}, {"command", command}};
    const std::string heading = inputs(unit, in, json);
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    std::vector<std::vector<std::string>> rows{{"value", "code", "fraction bits", "real"}};
    for (const Intermediate& value : model.trace(in)) {
        values.push_back({{"name", value.name}, {"code", value.code}, {"fraction_bits", value.fraction_bits}});
        rows.push_back({std::string(value.name), fmt::format("{}", value.code), fmt::format("{}", value.fraction_bits),
                        fmt::format("{:.9f}", std::ldexp(static_cast<double>(value.code), -value.fraction_bits))});
    }
    std::string text = fmt::format("{}{}\n{}", heading, result.clamped ? ", clamped" : "", io::table(rows));
    nlohmann::ordered_json outputs, reals;
    for (std::size_t p = 0; p < real.size(); ++p) {
        const EffectPort& port = model.outputs()[p];
        outputs[std::string(port.name)] = result.values[p];
        reals[std::string(port.name)] = real[p];
        text += fmt::format("{} of real numbers {:.9f}, rounding error {:.4f} ulp",
                            unit.lobe ? model.effect() : port.name, real[p],
                            std::abs(static_cast<double>(result.values[p]) - std::ldexp(real[p], port.fraction_bits)));
        if (!unit.lobe) text += '\n';
    }
    if (unit.lobe) {
        const double c_to_n = reference::blinn_phong(arguments[1], in[0] == 0 ? 1 : static_cast<double>(in[0]));
        text += fmt::format("; c^n {:.9f}, approximation error {:.6f}\n", c_to_n,
                            std::abs(model.outputs()[0].real(result.values[0]) - c_to_n));
        json.update({{"y", result.values[0]}, {"clamped", result.clamped}, {"values", values}, {"real", real[0]}});
        json["blinn_phong"] = c_to_n;
    } else {
        json.update({{"outputs", outputs}, {"clamped", result.clamped}, {"values", values}, {"real", reals}});
    }
    if (!options.json.empty()) io::write_json(options.json, json);
    fmt::print("{}", text);
    return io::success;
}

/// Lines with a code per input port in, lines with a code per output port (with the port semantics, `clamped` too) out,
/// a block at a time.
class Stream {
public:
    Stream(const Unit& unit, bool port)
        : unit_(unit), port_(port), in_(unit.model->inputs().size()), out_(unit.model->outputs().size()) {}

    int run() {
        std::vector<char> block(1 << 20);
        std::string rest;  // an unfinished line of the last block
        while (const std::size_t got = std::fread(block.data(), 1, block.size(), stdin)) {
            const std::size_t whole = std::string_view(block.data(), got).rfind('\n') + 1;  // npos + 1 is 0
            rest.append(block.data(), whole);
            if (whole != 0) {
                lines(rest);
                rest.clear();
            }
            rest.append(block.data() + whole, got - whole);
        }
        if (!rest.empty()) lines(rest + '\n');
        if (line_ == 0) throw Error("standard input holds 0 lines, which is not legal: at least 1");
        return io::success;
    }

private:
    void lines(const std::string& text) {
        for (auto& column : in_) column.clear();
        const char* end = text.data() + text.size();
        std::string complaint;
        Codes row(in_.size());
        for (const char* p = text.data(); p != end && complaint.empty(); ++p) {
            ++line_;
            try {
                p = parse(p, end, row);
                unit_.check(row, port_);
                for (std::size_t i = 0; i < row.size(); ++i) in_[i].push_back(static_cast<std::int32_t>(row[i]));
            } catch (const Error& error) {
                complaint = fmt::format("line {}{}{}", line_,
                                        std::string_view(error.what()).starts_with("is") ? " " : ": ", error.what());
            }
        }
        write();  // also the results of the lines before one that is not legal
        if (!complaint.empty()) throw Error(complaint);
    }

    /// Reads a line that begins at p, and returns its end. Throws Error.
    const char* parse(const char* p, const char* end, Codes& row) const {
        const auto refuse = [&] {
            return Error(unit_.lobe ? "is not legal: two integers, n and the cosine's code"
                                    : fmt::format("is not legal: {} integers", row.size()));
        };
        for (std::int64_t& code : row) {
            while (&code != &row.front() && *p == ' ') ++p;
            const auto [next, error] = std::from_chars(p, end, code);
            if (error != std::errc{}) throw refuse();
            p = next;
        }
        if (*p == '\r') ++p;
        if (p == end || *p != '\n') throw refuse();
        return p;
    }

    void write() {
        std::vector<const std::int32_t*> inputs;
        std::vector<std::int32_t*> outputs;
        for (const auto& column : in_) inputs.push_back(column.data());
        clamped_.resize(in_[0].size());
        for (auto& column : out_) {
            column.resize(clamped_.size());
            outputs.push_back(column.data());
        }
        unit_.model->eval_port_batch(inputs, outputs, clamped_);
        text_.clear();
        for (std::size_t i = 0; i < clamped_.size(); ++i) {
            for (std::size_t p = 0; p < out_.size(); ++p) {
                if (p != 0) text_.push_back(' ');
                fmt::format_to(std::back_inserter(text_), "{}", out_[p][i]);
            }
            const std::string_view tail = !port_ ? "\n" : clamped_[i] != 0 ? " 1\n" : " 0\n";
            text_.append(tail.data(), tail.data() + tail.size());
        }
        if (std::fwrite(text_.data(), 1, text_.size(), stdout) != text_.size() || std::fflush(stdout) != 0) {
            throw Error("standard output cannot be written");
        }
    }

    const Unit& unit_;
    bool port_;
    std::size_t line_ = 0;
    std::vector<std::vector<std::int32_t>> in_, out_;  // columns
    std::vector<std::uint8_t> clamped_;
    fmt::memory_buffer text_;
};

/// Options for the ports of effects, but n, which `glint eval` has anyway: those that the command line names, for all
/// of them would take longer than a result. They are not listed in the help, for they would not fit a screen.
void add_port_options(CLI::App& command, PortValues& values, const std::string& command_line) {
    std::set<std::string> names;
    for (const Effect& effect : effects()) {
        const auto model = effect.golden(shipped_profiles().front(), "bps");
        for (const EffectPort& port : model->inputs()) names.emplace(port.name);
    }
    names.erase("n");
    for (const std::string& name : names) {
        if (command_line.find("--" + name) == std::string::npos) continue;
        command
            .add_option_function<std::string>("--" + name, [&, name](const std::string& x) { values.reals[name] = x; })
            ->group("");
        command
            .add_option_function<std::string>("--" + name + "-code",
                                              [&, name](const std::string& x) { values.codes[name] = x; })
            ->group("");
    }
}

}  // namespace

void add_eval(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<EvalOptions>();
    CLI::App* command = app.add_subcommand("eval", "One input with every intermediate value, or a stream of inputs");
    CLI::Option* effect =
        command->add_option("--effect", options->effect, "An effect: --<port> x or --<port>-code c for each input");
    command->add_option("--lobe", options->lobe, "Lobe, with its options: polynomial:symmetric:0:-1:2")
        ->capture_default_str();
    command->add_option("--profile", options->profile, "p8, p12, p16 or the lobe's F,..,O")->capture_default_str();
    CLI::Option* n =
        io::add_integer(*command, "--n", options->n, 0, max_n, "Specular exponent, 1 to 1023 (--port: 0 too)");
    CLI::Option* cosine = command->add_option("--cos", options->cosine, "Cosine, rounded to its code");
    CLI::Option* code = io::add_integer(*command, "--cos-code", options->cos_code, -(std::int64_t{1} << 31),
                                        (std::int64_t{1} << 31) - 1, "Cosine's code, 0 to 2^F");
    command->add_flag("--port", options->port, "Port semantics: correct what is out of range and say so");
    CLI::Option* from_stdin = command->add_flag("--stdin", options->from_stdin,
                                                "Read lines \"n cos_code\", write lines \"y\" (--port: \"y clamped\")");
    CLI::Option* json = command->add_option("--json", options->json, "Write the same as JSON");
    from_stdin->excludes(json);
    n->default_str("");  // neither has a default
    code->default_str("");
    command->preparse_callback(
        [=, &chosen](std::size_t) { add_port_options(*command, options->ports, chosen.command); });
    cosine->excludes(code);
    effect->excludes(cosine)->excludes(code);
    from_stdin->excludes(n)->excludes(cosine)->excludes(code);
    command->footer("Example: glint eval --lobe bps --profile p12 --n 50 --cos 0.98");
    command->callback([=, &chosen] {
        chosen.run = [=, &chosen] {
            const bool effect_asked = !options->effect.empty();
            if (effect_asked && n->count() != 0) options->ports.codes["n"] = std::to_string(options->n);
            if (!effect_asked && !(options->ports.reals.empty() && options->ports.codes.empty())) {
                throw Error("values of ports are not legal without --effect");
            }
            const Unit unit = make_unit(*options);
            if (options->from_stdin) return Stream(unit, options->port).run();
            if (effect_asked) {
                return show(unit, effect_input(*unit.model, options->ports), *options, chosen.command);
            }
            if (n->count() == 0) throw Error("--n is missing: 1 to 1023 (or --stdin)");
            if (cosine->count() + code->count() == 0) throw Error("--cos or --cos-code is missing (or --stdin)");
            return show(unit, lobe_input(*unit.lobe, *options, code->count() != 0), *options, chosen.command);
        };
    });
}

}  // namespace glint::cli
