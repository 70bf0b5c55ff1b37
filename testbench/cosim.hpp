// Cosimulation: a unit's results against the golden model, bit for bit. Which inputs a test sends is its plan's
// business: lobe_tests.hpp, effect_tests.hpp.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "glint/effect.hpp"
#include "glint/parallel.hpp"
#include "io/results.hpp"
#include "unit.hpp"

namespace glint::testbench {

enum class Test {
    stream,      ///< legal inputs
    exhaustive,  ///< all of them; of an effect everything that its ports can carry
    illegal,     ///< what the unit has to correct
    reset        ///< resets in mid-stream, at random clocks and of random lengths
};

/// "stream", "exhaustive", ...
std::string_view name(Test test);

/// What all tests of all units take.
struct Request {
    Test test = Test::stream;
    std::uint64_t count = 0;  ///< random inputs (stream), or resets (reset)
    double stall_probability = 0.0;
    std::uint64_t seed = 1;
    unsigned threads = 0;
    Shard shard;                     ///< of the tasks
    bool to_first_mismatch = false;  ///< the run ends with the first burst that is wrong
    std::string trace_file;          ///< waveform of the first mismatch's neighbourhood; empty: none
};

inline constexpr std::uint64_t burst_length = 4096;

/// A seed of its own for each part of a run, so that any part can be run again by itself.
std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t part);

/// A permutation of 0 .. count - 1 that brings far ones together: a stall or a delay that is wrong shows only where
/// neighbours differ.
std::uint64_t scattered(std::uint64_t i, std::uint64_t count);

/// The inputs of one burst, a column per port, and where its random stalls start.
struct Stimulus {
    std::vector<std::vector<std::int32_t>> columns;
    std::vector<std::uint32_t> tags;
    std::uint64_t stall_seed = 0;

    void resize(std::size_t ports, std::size_t count);
    void set(std::size_t i, std::size_t port, std::int64_t code) { columns[port][i] = static_cast<std::int32_t>(code); }
    std::vector<std::int64_t> row(std::size_t i) const;
    std::vector<const std::int32_t*> pointers() const;
};

/// "n 50 cos 3": names and codes of ports.
std::string described(std::span<const EffectPort> ports, const std::vector<std::int64_t>& codes);

/// A burst that went wrong, with all that is needed to run it again.
struct Failure {
    Stimulus stimulus;
    Outcome outcome;
    std::size_t wrong = 0;  ///< index in the burst of the first wrong result
    std::string complaint;
};

/// What the threads of a run add to.
struct Log {
    std::mutex mutex;
    std::uint64_t inputs = 0, mismatches = 0, cycles = 0;
    io::Timing timing;
    std::map<std::uint64_t, Failure> failures;  ///< by place; only the first few are kept
};

/// Streams bursts through one unit and compares. One a thread.
class Checker {
public:
    Checker(const EffectModel& model, const UnitKind& kind, const Request& request, Log& log);

    /// Runs a burst; `place` orders the bursts of the run. Returns the unit's own results.
    const Outcome& check(const Stimulus& stimulus, std::uint64_t place);

    /// Full speed, a reset in mid-stream, and then the burst again from a clean start.
    void check_reset(const Stimulus& stimulus, std::uint64_t place);

    /// check_reset for a test of resets, else check.
    void run(const Stimulus& stimulus, std::uint64_t place);

    /// Of the last burst: the golden results, a column a port, and the inputs that the unit answers to.
    const std::vector<std::vector<std::int32_t>>& expected() const { return expected_; }
    const Stimulus& asked() const { return *asked_; }

private:
    bool right(const Stimulus& stimulus, std::size_t i) const;
    bool all_right(const Stimulus& stimulus) const;
    void count();
    void fail(std::uint64_t place, Failure failure);
    std::string description(const Stimulus& stimulus, const std::vector<std::size_t>& wrong) const;

    const EffectModel& model_;
    const Request& request_;
    Log& log_;
    int mask_;
    std::unique_ptr<Unit> unit_;
    Stimulus masked_;
    const Stimulus* asked_ = nullptr;
    std::vector<std::vector<std::int32_t>> expected_;
    std::vector<std::uint8_t> clamped_;
    Outcome outcome_;
};

/// A test cut into tasks.
struct Plan {
    std::uint64_t tasks = 0;
    /// Called once a thread: what runs task after task with the thread's checker.
    std::function<std::function<void(std::uint64_t)>(Checker&)> worker;
};

/// Runs the request's shard of a plan on all threads. Returns the seconds that it took.
double run_plan(const Plan& plan, const EffectModel& model, const UnitKind& kind, const Request& request, Log& log,
                const Progress& progress);

/// What went wrong, for people, with what the test has to say itself; empty when all is well. Draws a waveform where
/// one is asked for.
std::string complaint(const EffectModel& model, const UnitKind& kind, const Request& request, const Log& log,
                      const std::string& own);

}  // namespace glint::testbench
