#include "command.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "effect_tests.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"
#include "io/shards.hpp"
#include "junit.hpp"
#include "lobe_tests.hpp"

namespace glint::testbench {
namespace {

struct Options {
    std::string effect;
    std::string lobe = "bps";
    std::string profile = "p8,p12,p16";
    std::string mask;
    std::string unit = "core";
    std::string architecture;
    std::string n = "all";
    std::string cos = "all";
    bool exhaustive = false;
    bool illegal = false;
    std::uint64_t count = 0;
    std::uint64_t resets = 0;
    double stall_probability = 0.0;
    std::uint64_t seed = 1;
    unsigned threads = 0;
    std::string trace;
    std::string json;
    std::string junit;
    io::ShardOptions shard;
};

/// The units that are asked for, of one golden model. `architectures`: names, "all" that this build has, or empty: the
/// default one. Throws Error.
std::vector<const UnitKind*> find_units(const GoldenModel& model, const std::vector<std::string>& units,
                                        const std::vector<std::string>& architectures) {
    const Lobe& lobe = find_lobe(model.lobe());
    const bool all = architectures == std::vector<std::string>{"all"};
    std::vector<std::string> names;
    for (const std::string& text : architectures) {
        if (!all) names.push_back(parse_architecture(lobe, text).name);
    }
    if (architectures.empty()) names.push_back(default_architecture(lobe).name);
    std::string known;
    std::vector<const UnitKind*> out;
    for (const UnitKind& kind : unit_kinds()) {
        if (!kind.effect.empty() || kind.lobe != model.lobe()) continue;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", kind.name());
    }
    const auto add = [&](const std::string& unit, const std::string& architecture) {
        const std::size_t before = out.size();
        for (const UnitKind& kind : unit_kinds()) {
            if (kind.effect.empty() && kind.lobe == model.lobe() && kind.profile == model.profile().name &&
                kind.unit == unit && (all || kind.architecture == architecture)) {
                out.push_back(&kind);
            }
        }
        if (out.size() == before) {
            throw Error(fmt::format(
                "unit '{} {} {} {}' is not in this build, which has: {} (the CMake lists GLINT_PROFILES and "
                "GLINT_ARCHITECTURES say)",
                model.lobe(), model.profile().name, unit, architecture,
                known.empty() ? fmt::format("nothing of {}", model.lobe()) : known));
        }
    };
    for (const std::string& unit : units) {
        if (all) add(unit, "all");
        for (const std::string& name : names) add(unit, name);
    }
    return out;
}

Request make_request(const Options& options) {
    Request request;
    request.count = options.count;
    if (options.exhaustive) request.test = Test::exhaustive;
    if (options.illegal) request.test = Test::illegal;
    if (options.resets > 0) {
        request.test = Test::reset;
        request.count = options.resets;
    }
    request.stall_probability = options.stall_probability;
    request.seed = options.seed;
    request.threads = options.threads;
    request.shard = options.shard.shard();
    request.trace_file = options.trace;
    return request;
}

/// What runs of either kind end with: files, a table, a line, the exit status.
class Report {
public:
    explicit Report(const Options& options) : options_(options) {
        io::check_writable(options.json);
        io::check_writable(options.junit);
        io::check_writable(options.trace);
    }

    void add(const std::string& name, std::string_view test, double seconds, const std::string& complaint) {
        cases_.push_back({fmt::format("{} {}", name, test), seconds, complaint});
        if (!complaint.empty()) fmt::print(stderr, "{}: FAILED: {}", name, complaint);
    }

    int finish(const nlohmann::ordered_json& json, const std::string& table) const {
        if (!options_.json.empty()) io::write_json(options_.json, json);
        if (!options_.junit.empty()) io::write_file(options_.junit, to_junit("glint-cosim", cases_));
        const auto failed = static_cast<std::size_t>(
            std::count_if(cases_.begin(), cases_.end(), [](const JUnitCase& c) { return !c.failure.empty(); }));
        fmt::print("{}{} of {} runs passed, seed {}\n", table, cases_.size() - failed, cases_.size(), options_.seed);
        return failed == 0 ? io::success : io::check_failed;
    }

private:
    const Options& options_;
    std::vector<JUnitCase> cases_;
};

/// "ambient,tint", or "all": every effect that this build has a unit of.
std::vector<const Effect*> split_effects(const std::string& text) {
    std::vector<const Effect*> out;
    if (text == "all") {
        for (const Effect& effect : effects()) {
            const auto kinds = unit_kinds();
            const bool here =
                std::any_of(kinds.begin(), kinds.end(), [&](const auto& k) { return k.effect == effect.name; });
            if (here) out.push_back(&effect);
        }
        return out;
    }
    for (const std::string& word : io::split_list(text)) out.push_back(&find_effect(word));
    return out;
}

/// "1,2,5"; empty: -1, all that there is.
std::vector<int> split_masks(const std::string& text) {
    if (text.empty()) return {-1};
    std::vector<int> out;
    for (const std::string& word : io::split_list(text)) {
        out.push_back(static_cast<int>(io::parse_integer(word, "--mask", 0, 0xffff)));
    }
    return out;
}

// Both find everything before anything runs: a mistake in the last name must not cost the time of the first.

int cosim_effects(const Options& options, const std::string& command) {
    struct Work {
        const Effect* effect;
        std::shared_ptr<const EffectModel> model;
        const UnitKind* kind;
    };
    std::vector<Work> work;
    for (const Effect* effect : split_effects(options.effect)) {
        for (const std::string& profile : io::split_profiles(options.profile)) {
            for (const int mask : split_masks(options.mask)) {
                const std::shared_ptr<const EffectModel> model = effect->golden(parse_profile(profile), options.lobe);
                for (const std::string& unit : io::split_list(options.unit)) {
                    const std::string& name = model->profile().name;
                    const UnitKind& kind = find_effect_unit(effect->name, options.lobe, name, mask, unit);
                    work.push_back({effect, model, &kind});
                }
            }
        }
    }
    if (work.empty()) throw Error("--effect all: this build has no unit of any effect");
    Report report(options);
    std::vector<EffectRun> runs;
    for (const auto& [effect, model, kind] : work) {
        const std::string name = kind->name();
        runs.push_back(test_effect(*effect, *model, *kind, make_request(options), io::progress_bar(name)));
        report.add(name, runs.back().test, runs.back().seconds, runs.back().complaint);
    }
    return report.finish(to_json(runs, command), effect_table(runs));
}

int cosim_lobes(const Options& options, const std::string& command) {
    const auto golden = io::models(options.lobe, options.profile);
    const auto architectures =
        options.architecture.empty() ? std::vector<std::string>{} : io::split_list(options.architecture);
    std::vector<std::pair<const GoldenModel*, const UnitKind*>> work;
    for (const auto& model : golden) {
        for (const UnitKind* kind : find_units(*model, io::split_list(options.unit), architectures)) {
            work.emplace_back(model.get(), kind);
        }
    }
    Report report(options);
    Request request = make_request(options);
    if (request.test == Test::exhaustive) request.test = Test::stream;  // of the whole grid
    const auto grid_of = [&](const GoldenModel& model) {
        return Grid{parse_range(options.n, "--n", 1, max_n),
                    parse_range(options.cos, "--cos", 0, model.profile().one())};
    };
    std::vector<std::string> keys;
    for (const auto& [model, kind] : work) keys.push_back(key_of(*kind, request, grid_of(*model)));
    if (options.shard.there(options.json, "glint-cosim", keys)) return io::success;
    std::vector<io::RunResult> runs;
    for (const auto& [model, kind] : work) {
        const std::string name = kind->name();
        runs.push_back(test_lobe(*model, *kind, request, grid_of(*model), io::progress_bar(name)));
        report.add(name, runs.back().test, runs.back().seconds, runs.back().complaint);
    }
    return report.finish(io::to_json(runs, "glint-cosim", command, request.shard), io::results_table(runs, true));
}

}  // namespace

int run_cosim(int argc, char** argv) {
    Options options;
    CLI::App app{"The Verilog, run by Verilator, against the golden model, bit for bit.", "glint-cosim"};
    CLI::Option* effect =
        app.add_option("--effect", options.effect, "Effects instead of lobes, or all (phong, blinn_phong: of --lobe)");
    app.add_option("--mask", options.mask, "Units of shade with these MASKs")->needs(effect);
    app.add_option("--lobe", options.lobe, "Lobes, separated by commas, or all")->capture_default_str();
    app.add_option("--profile", options.profile, "Profiles, separated by commas")->capture_default_str();
    app.add_option("--unit", options.unit, "core, axis or both, separated by a comma")->capture_default_str();
    app.add_option("--architecture", options.architecture,
                   "Architectures, by commas, or all; without it the default one");
    CLI::Option* exhaustive = app.add_flag("--exhaustive", options.exhaustive, "Every legal input");
    CLI::Option* n = app.add_option("--n", options.n, "Exponents: n, first:last, first:last:step or all");
    CLI::Option* cos = app.add_option("--cos", options.cos, "Cosine codes: a range as for --n, or all (0 to 2^F)");
    CLI::Option* count = io::add_integer(app, "--count", options.count, 1, std::int64_t{1} << 40,
                                         "So many random legal inputs, the corners first");
    CLI::Option* illegal = app.add_flag("--illegal", options.illegal,
                                        "n = 0 with every code, and illegal codes with n 1, 2, 50, 1000, 1023");
    CLI::Option* resets =
        io::add_integer(app, "--resets", options.resets, 1, std::int64_t{1} << 40, "So many resets in mid-stream");
    io::add_real(app, "--stall-probability", options.stall_probability, 0.0, 0.99,
                 "Chance of a bubble at the input, and of a stall at the output")
        ->default_str(fmt::format("{}", options.stall_probability));
    io::add_integer(app, "--seed", options.seed, 0, io::largest_seed,
                    "Seed of all that is random; with 0 registers start at 0");
    io::add_integer(app, "--threads", options.threads, 0, io::most_threads, "Threads; 0: one a core");
    app.add_option("--trace", options.trace, "Waveform (FST) around the first mismatch");
    CLI::Option* json = app.add_option("--json", options.json, "Write the results, per n and in total");
    app.add_option("--junit", options.junit, "Write the results as JUnit XML");
    CLI::Option* shard = options.shard.add(app, json);
    // Without this, the lists of what excludes what do not fit a screen.
    for (CLI::Option* option : {count, resets}) option->option_text("INT");
    for (CLI::Option* option : {n, cos, effect}) option->option_text("TEXT");
    for (CLI::Option* option : {exhaustive, illegal}) option->option_text(" ");
    exhaustive->excludes(n)->excludes(cos)->excludes(count)->excludes(illegal)->excludes(resets);
    count->excludes(n)->excludes(cos)->excludes(illegal)->excludes(resets);
    illegal->excludes(n)->excludes(cos)->excludes(resets);
    resets->excludes(n)->excludes(cos);
    effect->excludes(n)->excludes(cos)->excludes(shard);
    app.footer("Example: glint-cosim --lobe bps --profile p8,p12,p16 --exhaustive --json cosim.json");
    const std::string command = io::command_line(argc, argv);
    return io::run(app, argc, argv, [&] {
        if (exhaustive->count() + n->count() + cos->count() + count->count() + illegal->count() + resets->count() ==
            0) {
            throw Error("nothing to run: --exhaustive, --n and --cos, --count, --illegal or --resets");
        }
        return options.effect.empty() ? cosim_lobes(options, command) : cosim_effects(options, command);
    });
}

}  // namespace glint::testbench
