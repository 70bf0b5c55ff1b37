// Runs the tests of the cosimulation against a unit that holds many planted faults, one of them switched on at a time,
// and says which test found each. tests/mutants/mutants.py builds the unit.

#include <dlfcn.h>

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "effect_tests.hpp"
#include "glint/error.hpp"
#include "glint/lobe_unit.hpp"
#include "io/command.hpp"
#include "lobe_tests.hpp"

namespace {

using namespace glint;
using namespace glint::testbench;

using Make = Unit*(const int*, std::size_t, std::uint64_t);
using Choose = void(int);

Make* make_loaded = nullptr;  // of the unit's library; MakeUnit takes no context

std::unique_ptr<Unit> make(std::span<const int> bits, std::uint64_t seed) {
    return std::unique_ptr<Unit>(make_loaded(bits.data(), bits.size(), seed));
}

template <class Function>
Function* loaded(void* library, const char* name) {
    auto* out = reinterpret_cast<Function*>(dlsym(library, name));
    if (out == nullptr) throw Error(fmt::format("--library: {}", dlerror()));
    return out;
}

/// A test of tests/cosim with fewer inputs, or a whole one. The record calls it by its name.
struct Step {
    std::string_view name;
    Test test;
    std::uint64_t count;
    double stalls;
    std::uint64_t parts = 1;  ///< only the first of so many
    std::uint64_t seed = 1;   ///< with 0 registers start at 0
};

// The cheapest first. A long list is for what the short one does not find.
constexpr std::array lobe_short{
    Step{"reset 4", Test::reset, 4, 0.0},         Step{"stalls 4096", Test::stream, 4096, 0.3},
    Step{"stream 4096", Test::stream, 4096, 0.0}, Step{"heavy_stalls 4096", Test::stream, 4096, 0.9},
    Step{"reset 100", Test::reset, 100, 0.0},     Step{"reset from 0", Test::reset, 4, 0.0, 1, 0},
};
constexpr std::array lobe_middle{
    Step{"illegal_stalls 1/15", Test::illegal, 0, 0.3, 15},
    Step{"stalls 100000", Test::stream, 100'000, 0.3},
};
constexpr std::array lobe_long{
    Step{"reset seed 2", Test::reset, 4, 0.0, 1, 2},      Step{"reset seed 3", Test::reset, 4, 0.0, 1, 3},
    Step{"reset seed 4", Test::reset, 4, 0.0, 1, 4},      Step{"reset seed 5", Test::reset, 4, 0.0, 1, 5},
    Step{"illegal_stalls", Test::illegal, 0, 0.3},        Step{"stalls 300000", Test::stream, 300'000, 0.3},
    Step{"stream 2000000", Test::stream, 2'000'000, 0.0},
};
constexpr std::array lobe_all{Step{"exhaustive", Test::stream, 0, 0.0}};
constexpr std::array effect_short{
    Step{"reset 8", Test::reset, 8, 0.0},
    Step{"reset 100", Test::reset, 100, 0.0},
    Step{"reset stalls 100", Test::reset, 100, 0.3},
    Step{"reset from 0", Test::reset, 8, 0.0, 1, 0},
};
constexpr std::array effect_middle{
    Step{"illegal_stalls 1/15", Test::illegal, 0, 0.3, 15},
    Step{"stalls 1/5", Test::stream, 20'000, 0.3, 5},
};
constexpr std::array effect_long{
    Step{"reset seed 2", Test::reset, 4, 0.0, 1, 2},       Step{"reset seed 3", Test::reset, 4, 0.0, 1, 3},
    Step{"reset seed 4", Test::reset, 4, 0.0, 1, 4},       Step{"reset seed 5", Test::reset, 4, 0.0, 1, 5},
    Step{"reset heavy_stalls 100", Test::reset, 100, 0.9}, Step{"illegal_stalls", Test::illegal, 0, 0.3},
    Step{"stalls 20000", Test::stream, 20'000, 0.3},       Step{"stream 2000000", Test::stream, 2'000'000, 0.0},
};

std::span<const Step> steps(bool lobe, const std::string& which) {
    if (which == "short") return lobe ? std::span<const Step>(lobe_short) : std::span<const Step>(effect_short);
    if (which == "middle") return lobe ? std::span<const Step>(lobe_middle) : std::span<const Step>(effect_middle);
    if (which == "long") return lobe ? std::span<const Step>(lobe_long) : std::span<const Step>(effect_long);
    if (which == "all" && lobe) return lobe_all;
    throw Error(fmt::format("--steps '{}' is not legal: short, middle, long, or for a lobe all", which));
}

struct Options {
    std::string library, effect, profile = "p8", unit = "core", architecture;
    std::string lobe = "bps";
    std::string mutants;
    std::string steps = "short";
};

/// Empty where the unit passes.
std::string complaint(const Options& options, const UnitKind& kind, const Step& step) {
    Request request;
    request.test = step.test;
    request.count = step.count;
    request.stall_probability = step.stalls;
    request.threads = 1;
    request.seed = step.seed;
    request.to_first_mismatch = true;
    if (options.effect.empty()) {
        const auto model = find_lobe(options.lobe).golden(parse_profile(options.profile));
        const Grid grid{{1, max_n, 1}, {0, model->profile().one(), 1}};
        request.shard.count = step.parts;
        return test_lobe(*model, kind, request, grid, {}).complaint;
    }
    const Effect& effect = find_effect(options.effect);
    const auto model = effect.golden(parse_profile(options.profile), options.lobe);
    const auto inputs = model->inputs();
    std::uint64_t illegal = 0;
    for (const EffectPort& port : inputs)
        illegal += static_cast<std::uint64_t>(port.low - port.least() + port.greatest() - port.high);
    if (step.test == Test::illegal && illegal == 0) return {};
    // Some effects have few illegal inputs, or few corners; bursts are not cut.
    const std::uint64_t least = step.test == Test::illegal ? illegal : step.count;
    request.shard.count = std::min(step.parts, least / burst_length + 1);
    return test_effect(effect, *model, kind, request, {}).complaint;
}

int judge(const Options& options) {
    const std::span<const Step> tests = steps(options.effect.empty(), options.steps);
    const std::string name = parse_profile(options.profile).name;
    const UnitKind kind{.effect = options.effect,
                        .lobe = options.lobe,
                        .profile = name,
                        .unit = options.unit,
                        .architecture = options.architecture,
                        .id = {},
                        .verilog = {},
                        .make = make};
    void* library = dlopen(options.library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw Error(fmt::format("--library: {}", dlerror()));
    make_loaded = loaded<Make>(library, "glint_make_unit");
    Choose* choose = loaded<Choose>(library, "glint_choose_mutant");
    for (const std::string& text : io::split_list(options.mutants)) {
        const auto mutant = static_cast<int>(io::parse_integer(text, "--mutants", 0, 0xffff));
        choose(mutant);
        nlohmann::ordered_json line{{"mutant", mutant}, {"killed_by", ""}};
        for (const Step& step : tests) {
            const std::string found = complaint(options, kind, step);
            if (found.empty()) continue;
            line["killed_by"] = step.name;
            line["complaint"] = found.substr(0, 300);
            break;
        }
        fmt::print("{}\n", line.dump());
        std::fflush(stdout);
    }
    return io::success;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"Which test of the cosimulation finds which planted fault of a unit.", "glint-mutants"};
    app.add_option("--library", options.library, "The unit, from mutants.py")->required();
    app.add_option("--effect", options.effect, "The effect, or none: a lobe");
    app.add_option("--lobe", options.lobe, "The lobe")->capture_default_str();
    app.add_option("--profile", options.profile, "The profile")->capture_default_str();
    app.add_option("--unit", options.unit, "core or axis")->capture_default_str();
    app.add_option("--architecture", options.architecture, "The architecture of a lobe");
    app.add_option("--mutants", options.mutants, "Numbers, by commas; 0: no fault")->required();
    app.add_option("--steps", options.steps,
                   "short, middle, long: some seconds a fault; all: every legal input of a lobe")
        ->capture_default_str();
    app.footer("Example: glint-mutants --library bps.so --lobe bps --architecture restoring --mutants 0,1,2");
    return io::run(app, argc, argv, [&] { return judge(options); });
}
