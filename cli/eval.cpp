#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/eval_effect.hpp"
#include "glint/error.hpp"
#include "glint/fixed_point.hpp"
#include "glint/reference.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

struct Options {
    std::string effect;
    PortValues ports;
    std::string lobe = "bps";
    std::string profile = "p12";
    int n = 0;
    double cosine = 0.0;
    std::int64_t cos_code = 0;
    bool from_stdin = false;
    std::string json;
    bool port = false;
};

int show(const GoldenModel& model, int n, std::int64_t cos_code, const Options& options, const std::string& command) {
    if (!options.port) model.eval(n, cos_code);  // refuses what is not legal
    const PortResult result = model.eval_port(n, cos_code);
    const double c = std::ldexp(static_cast<double>(cos_code), -model.profile().F);
    std::vector<std::vector<std::string>> rows{{"value", "code", "fraction bits", "real"}};
    for (const Intermediate& value : model.trace(n, cos_code)) {
        rows.push_back({std::string(value.name), fmt::format("{}", value.code), fmt::format("{}", value.fraction_bits),
                        fmt::format("{:.9f}", std::ldexp(static_cast<double>(value.code), -value.fraction_bits))});
    }
    const double y = std::ldexp(static_cast<double>(result.y), -model.profile().O);
    const int counted = n == 0 ? 1 : n;
    // The model's own real function, which knows the numbers of a custom profile and the options of a lobe.
    const double within = std::clamp(c, 0.0, 1.0);
    double real = 0.0;
    if (c >= 0.0) model.reference(counted, {&within, 1}, {&real, 1});
    const double blinn_phong = reference::blinn_phong(c, counted);
    if (!options.json.empty()) {
        nlohmann::ordered_json out{{"tool", "glint eval"},
                                   {"command", command},
                                   {"lobe", model.lobe()},
                                   {"profile", model.profile().name},
                                   {"n", n},
                                   {"cos_code", cos_code},
                                   {"y", result.y},
                                   {"clamped", result.clamped},
                                   {"values", nlohmann::ordered_json::array()},
                                   {"real", real},
                                   {"blinn_phong", blinn_phong}};
        for (const Intermediate& value : model.trace(n, cos_code)) {
            out["values"].push_back(
                {{"name", value.name}, {"code", value.code}, {"fraction_bits", value.fraction_bits}});
        }
        io::write_file(options.json, out.dump(1) + "\n");
    }
    fmt::print("{} {} n {} cos code {} (c = {:.9f}){}\n{}", model.lobe(), model.profile().name, n, cos_code, c,
               result.clamped ? ", clamped" : "", io::table(rows));
    fmt::print("{} of real numbers {:.9f}, rounding error {:.4f} ulp; c^n {:.9f}, approximation error {:.6f}\n",
               model.lobe(), real, std::abs(y - real) * std::ldexp(1.0, model.profile().O), blinn_phong,
               std::abs(y - blinn_phong));
    return io::success;
}

/// Lines "n cos_code" in, lines "y" (with the port semantics "y clamped") out, a block at a time.
class Stream {
public:
    Stream(const GoldenModel& model, bool port) : model_(model), port_(port) {}

    int run() {
        std::vector<char> block(1 << 20);
        std::string rest;  // an unfinished line of the last block
        while (const std::size_t got = std::fread(block.data(), 1, block.size(), stdin)) {
            const char* begin = block.data();
            const char* end = begin + got;
            const char* last = end;
            while (last != begin && last[-1] != '\n') --last;
            if (last == begin) {
                rest.append(begin, end);
                continue;
            }
            rest.append(begin, last);
            lines(rest);
            rest.assign(last, end);
        }
        if (!rest.empty()) lines(rest + '\n');
        if (line_ == 0) throw Error("standard input holds 0 lines, which is not legal: at least 1");
        return io::success;
    }

private:
    void lines(const std::string& text) {
        n_.clear();
        cos_code_.clear();
        std::string complaint;
        const char* end = text.data() + text.size();
        for (const char* p = text.data(); p != end && complaint.empty();) {
            int n = 0;
            std::int64_t code = 0;
            ++line_;
            const auto a = std::from_chars(p, end, n);
            const char* q = a.ptr;
            while (q != end && *q == ' ') ++q;
            const auto b = std::from_chars(q, end, code);
            const char* last = b.ptr;
            if (last != end && *last == '\r') ++last;
            if (a.ec != std::errc{} || b.ec != std::errc{} || q == a.ptr || *last != '\n') {
                complaint = fmt::format("line {} is not legal: two integers, n and the cosine's code", line_);
                break;
            }
            try {
                check(n, code);
            } catch (const Error& error) {
                complaint = fmt::format("line {}: {}", line_, error.what());
                break;
            }
            n_.push_back(static_cast<std::uint16_t>(n));
            cos_code_.push_back(static_cast<std::int32_t>(code));
            p = last + 1;
        }
        write();
        if (!complaint.empty()) throw Error(complaint);
    }

    /// The results of the lines that were legal: also of those before one that was not.
    void write() {
        packed_.resize(n_.size());
        model_.eval_port_batch(n_, cos_code_, packed_);
        out_.clear();
        for (const std::uint32_t word : packed_) {
            const PortResult result = unpack(word);
            if (port_) {
                fmt::format_to(std::back_inserter(out_), "{} {}\n", result.y, result.clamped ? 1 : 0);
            } else {
                fmt::format_to(std::back_inserter(out_), "{}\n", result.y);
            }
        }
        if (std::fwrite(out_.data(), 1, out_.size(), stdout) != out_.size() || std::fflush(stdout) != 0) {
            throw Error("standard output cannot be written");
        }
    }

    void check(int n, std::int64_t code) const {
        const std::int64_t one = model_.profile().one();
        const bool legal = port_ ? n >= 0 && n <= max_n && code >= -2 * one && code < 2 * one
                                 : n >= 1 && n <= max_n && code >= 0 && code <= one;
        if (legal) return;
        port_ ? static_cast<void>(model_.eval_port(n, code)) : static_cast<void>(model_.eval(n, code));
    }

    const GoldenModel& model_;
    bool port_;
    std::size_t line_ = 0;
    std::vector<std::uint16_t> n_;
    std::vector<std::int32_t> cos_code_;
    std::vector<std::uint32_t> packed_;
    fmt::memory_buffer out_;
};

}  // namespace

void add_eval(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<Options>();
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
    add_port_options(*command, options->ports);
    cosine->excludes(code);
    effect->excludes(cosine)->excludes(code);
    from_stdin->excludes(n)->excludes(cosine)->excludes(code);
    command->footer("Example: glint eval --lobe bps --profile p12 --n 50 --cos 0.98");
    command->callback([=, &chosen] {
        chosen.run = [=, &chosen] {
            if (!options->effect.empty()) {
                if (n->count() != 0) options->ports.codes["n"] = std::to_string(options->n);
                return eval_effect({options->effect, options->lobe, options->profile, options->json, chosen.command,
                                    options->port, options->from_stdin},
                                   options->ports);
            }
            if (!options->ports.reals.empty() || !options->ports.codes.empty()) {
                throw Error("values of ports are not legal without --effect");
            }
            const LobeChoice choice = parse_lobe(options->lobe);
            const auto model = choice.lobe->golden(choice.profile(options->profile));
            if (options->from_stdin) return Stream(*model, options->port).run();
            if (n->count() == 0) throw Error("--n is missing: 1 to 1023 (or --stdin)");
            if (cosine->count() + code->count() == 0) throw Error("--cos or --cos-code is missing (or --stdin)");
            std::int64_t cos_code = options->cos_code;
            if (code->count() == 0) {
                cos_code = quantize_cosine(options->cosine, model->profile().F);
                if (!options->port && (cos_code < 0 || cos_code > model->profile().one())) {
                    throw Error(fmt::format("cosine {} is not legal: 0 to 1", options->cosine));
                }
            }
            return show(*model, options->n, cos_code, *options, chosen.command);
        };
    });
}

}  // namespace glint::cli
