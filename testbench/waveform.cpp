#include "waveform.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

namespace glint::testbench {
namespace {

struct Close {
    void operator()(void* library) const { dlclose(library); }
};
/// A loaded library; empty where it cannot be.
using Library = std::unique_ptr<void, Close>;

}  // namespace

std::string draw_waveform(const EffectModel& model, const UnitKind& kind, const Request& request,
                          const Failure& failure) {
    const std::filesystem::path build = GLINT_BUILD;
    if (!std::filesystem::exists(build / "CMakeCache.txt")) {
        return fmt::format("no waveform: its unit is built when it is wanted, and the build {} is not there\n",
                           build.string());
    }
    const std::string target = fmt::format("waveform-{}", kind.id);
    const std::string command = fmt::format("'{}' --build '{}' --target '{}' >&2", GLINT_CMAKE, build.string(), target);
    if (std::system(command.c_str()) != 0) return fmt::format("no waveform: this failed: {}\n", command);
    const std::filesystem::path file = build / "waveforms" / (target + ".so");
    const Library library(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL));
    if (!library) return fmt::format("no waveform: {}\n", dlerror());
    using Make = Unit*(const int*, std::size_t, std::uint64_t);
    const auto make = reinterpret_cast<Make*>(dlsym(library.get(), "glint_make_unit"));
    if (make == nullptr) return fmt::format("no waveform: {}\n", dlerror());

    const std::vector<int> widths = input_widths(model);
    const std::unique_ptr<Unit> unit(make(widths.data(), widths.size(), request.seed));
    const Schedule schedule{request.stall_probability, failure.stimulus.stall_seed};
    const auto inputs = failure.stimulus.pointers();
    const Burst burst{inputs, failure.stimulus.tags};
    constexpr std::uint64_t before = 64;
    constexpr std::uint64_t after = 16;
    Outcome outcome;
    unit->run(burst, schedule, outcome);  // once without drawing, to find the clock
    const std::uint64_t clock = failure.wrong >= outcome.results ? outcome.cycles
                                : request.stall_probability > 0.0
                                    ? outcome.clock[failure.wrong]
                                    : failure.wrong + static_cast<std::uint64_t>(outcome.latency);
    unit->reset();
    unit->trace(request.trace_file, clock < before ? 0 : clock - before, clock + after);
    unit->run(burst, schedule, outcome);
    const bool same = outcome.results == failure.outcome.results && outcome.values == failure.outcome.values;
    return fmt::format("waveform around clock {}: {}{}\n", clock, request.trace_file,
                       same ? "" : " (run again there, the unit gave other results)");
}

}  // namespace glint::testbench
