#include "cli/eval_effect.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

double parse_real(const std::string& text, std::string_view port) {
    double x = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(x)) {
        throw Error(fmt::format("--{} '{}' is not legal: a finite number", port, text));
    }
    return x;
}

void refuse_illegal(const EffectPort& port, std::int64_t code) {
    if (code >= port.low && code <= port.high) return;
    throw Error(
        fmt::format("{} code {} is not legal: {} to {} (--port corrects)", port.name, code, port.low, port.high));
}

/// A code for each input port, from the command line.
std::vector<std::int64_t> input(const EffectModel& model, const PortValues& values, bool correct) {
    std::set<std::string> unknown;
    for (const auto& [name, text] : values.reals) unknown.insert(name);
    for (const auto& [name, text] : values.codes) unknown.insert(name);
    std::vector<std::int64_t> in;
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
        if (!correct) refuse_illegal(port, in.back());
        unknown.erase(name);
    }
    if (!unknown.empty()) {
        throw Error(
            fmt::format("--{} is not legal for {}: its inputs are {}", *unknown.begin(), model.effect(), names));
    }
    return in;
}

std::string described(std::span<const EffectPort> ports, const std::vector<std::int64_t>& codes) {
    std::string out;
    for (std::size_t p = 0; p < ports.size(); ++p) {
        out += fmt::format("{}{} {}", p == 0 ? "" : ", ", ports[p].name, codes[p]);
    }
    return out;
}

int show(const EffectModel& model, const std::vector<std::int64_t>& in, const EffectEval& options) {
    const EffectResult result = model.eval_port(in);
    const std::vector<Intermediate> trace = model.trace(in);
    std::vector<double> arguments;
    for (std::size_t p = 0; p < in.size(); ++p) arguments.push_back(model.inputs()[p].real(in[p]));
    const std::vector<double> real = model.reference(arguments);
    if (!options.json.empty()) {
        nlohmann::ordered_json out{{"tool", "glint eval"},
                                   {"command", options.command},
                                   {"effect", model.effect()},
                                   {"profile", model.profile().name},
                                   {"inputs", nlohmann::ordered_json::object()},
                                   {"outputs", nlohmann::ordered_json::object()},
                                   {"clamped", result.clamped},
                                   {"values", nlohmann::ordered_json::array()},
                                   {"real", nlohmann::ordered_json::object()}};
        for (std::size_t p = 0; p < in.size(); ++p) out["inputs"][std::string(model.inputs()[p].name)] = in[p];
        for (std::size_t p = 0; p < real.size(); ++p) {
            const std::string name(model.outputs()[p].name);
            out["outputs"][name] = result.values[p];
            out["real"][name] = real[p];
        }
        for (const Intermediate& value : trace) {
            out["values"].push_back(
                {{"name", value.name}, {"code", value.code}, {"fraction_bits", value.fraction_bits}});
        }
        io::write_file(options.json, out.dump(1) + "\n");
    }
    std::vector<std::vector<std::string>> rows{{"value", "code", "fraction bits", "real"}};
    for (const Intermediate& value : trace) {
        rows.push_back({std::string(value.name), fmt::format("{}", value.code), fmt::format("{}", value.fraction_bits),
                        fmt::format("{:.9f}", std::ldexp(static_cast<double>(value.code), -value.fraction_bits))});
    }
    fmt::print("{} {} {}{}\n{}", model.effect(), model.profile().name, described(model.inputs(), in),
               result.clamped ? ", clamped" : "", io::table(rows));
    for (std::size_t p = 0; p < real.size(); ++p) {
        const EffectPort& port = model.outputs()[p];
        fmt::print("{} of real numbers {:.9f}, rounding error {:.4f} ulp\n", port.name, real[p],
                   std::abs(static_cast<double>(result.values[p]) - std::ldexp(real[p], port.fraction_bits)));
    }
    return io::success;
}

/// Adds a line with the results of an input.
void evaluate(const EffectModel& model, std::span<const std::int64_t> in, bool correct, std::string& out) {
    if (!correct) {
        for (std::size_t i = 0; i < in.size(); ++i) refuse_illegal(model.inputs()[i], in[i]);
    }
    const EffectResult result = model.eval_port(in);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        fmt::format_to(std::back_inserter(out), "{}{}", i == 0 ? "" : " ", result.values[i]);
    }
    out += correct ? (result.clamped ? " 1\n" : " 0\n") : "\n";
}

/// Lines with a code per input port in, lines with a code per output port (with the port semantics, `clamped` too) out.
int stream(const EffectModel& model, bool correct) {
    const std::size_t ports = model.inputs().size();
    std::string line, out;
    std::vector<std::int64_t> in(ports);
    std::uint64_t lines = 0;
    std::string complaint;
    const auto write = [&] {
        if (std::fwrite(out.data(), 1, out.size(), stdout) != out.size() || std::fflush(stdout) != 0) {
            throw Error("standard output cannot be written");
        }
        out.clear();
    };
    while (complaint.empty() && std::getline(std::cin, line)) {
        ++lines;
        if (line.ends_with('\r')) line.pop_back();
        const char* p = line.data();
        const char* end = p + line.size();
        std::size_t got = 0;
        for (; got < ports; ++got) {
            while (p != end && *p == ' ') ++p;
            const auto [next, error] = std::from_chars(p, end, in[got]);
            if (error != std::errc{}) break;
            p = next;
        }
        try {
            if (got != ports || p != end) throw Error(fmt::format("line {} is not legal: {} integers", lines, ports));
            evaluate(model, in, correct, out);
        } catch (const Error& error) {
            complaint = got == ports && p == end ? fmt::format("line {}: {}", lines, error.what()) : error.what();
        }
        if (out.size() > (std::size_t{1} << 20)) write();
    }
    write();  // also the results of the lines before one that is not legal
    if (!complaint.empty()) throw Error(complaint);
    if (lines == 0) throw Error("standard input holds 0 lines, which is not legal: at least 1");
    return io::success;
}

}  // namespace

void add_port_options(CLI::App& command, PortValues& values) {
    std::set<std::string> names;
    for (const Effect& effect : effects()) {
        const auto model = effect.golden(shipped_profiles().front(), "bps");
        for (const EffectPort& port : model->inputs()) names.emplace(port.name);
    }
    names.erase("n");
    for (const std::string& name : names) {
        command
            .add_option_function<std::string>("--" + name, [&, name](const std::string& x) { values.reals[name] = x; })
            ->group("");
        command
            .add_option_function<std::string>("--" + name + "-code",
                                              [&, name](const std::string& x) { values.codes[name] = x; })
            ->group("");
    }
}

int eval_effect(const EffectEval& options, const PortValues& values) {
    const auto model = find_effect(options.effect).golden(parse_profile(options.profile), options.lobe);
    if (options.from_stdin) return stream(*model, options.port);
    return show(*model, input(*model, values, options.port), options);
}

}  // namespace glint::cli
