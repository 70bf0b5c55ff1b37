// glint-wide: the golden model of `bps` at a profile with too many inputs for a sweep.
//
// The quotient takes only 2^S + 1 values, and all that follows depends on nothing else: so the steps after the division
// are run at every quotient, and the error that any real s can have is known from them. What is left is the division:
// it is tried at random inputs and where it is hardest. Every input is held against a second implementation of the
// contract, and the batch form against the scalar one.

#include <chrono>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "exact.hpp"
#include "glint/accuracy.hpp"
#include "glint/lobes.hpp"
#include "glint/parallel.hpp"
#include "glint/vectors.hpp"
#include "io/command.hpp"
#include "io/results.hpp"
#include "search.hpp"

namespace glint::wide {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string profile = "28,27,27,24";
    std::uint64_t count = 100'000'000;
    std::uint64_t seed = 1;
    std::string json;
    bool brute_force = false;
    unsigned threads = 0;
};

/// What became of a set of inputs.
struct Findings {
    std::uint64_t inputs = 0;
    Worst error;  ///< in ulps
    std::uint64_t mismatches = 0;
    std::string first_mismatch;

    void merge(const Findings& other) {
        inputs += other.inputs;
        error.merge(other.error);
        if (mismatches == 0) first_mismatch = other.first_mismatch;
        mismatches += other.mismatches;
    }
};

/// Runs inputs through the golden model, scalar and batch, and through the second implementation.
class Checker {
public:
    Checker(const GoldenModel& model, const Exact& exact) : model_(model), exact_(exact) {}

    void add(int n, std::int64_t C) {
        n_.push_back(static_cast<std::uint16_t>(n));
        C_.push_back(static_cast<std::int32_t>(C));
        if (n_.size() == block) flush();
    }
    Findings take() {
        flush();
        return std::exchange(findings_, {});
    }

private:
    static constexpr std::size_t block = 4096;

    void flush() {
        packed_.resize(n_.size());
        model_.eval_port_batch(n_, C_, packed_);
        for (std::size_t i = 0; i < n_.size(); ++i) {
            const std::int64_t ratio = exact_.ratio(n_[i], C_[i]);
            const std::int64_t y = exact_.y_of_sum(exact_.last_sum(exact_.quotient_of(ratio)));
            const std::int64_t scalar = model_.eval(n_[i], C_[i]);
            const std::int64_t batch = packed_[i];
            if (scalar != y || batch != y) {
                if (findings_.mismatches++ == 0) {
                    findings_.first_mismatch = fmt::format(
                        "n {}, cos code {}: contract {}, golden {}, its batch form {}", n_[i], C_[i], y, scalar, batch);
                }
            }
            const double error = exact_.in_ulps(exact_.error(scalar, ratio));
            if (error >= findings_.error.value) findings_.error.merge({error, n_[i], C_[i]});
        }
        findings_.inputs += n_.size();
        n_.clear();
        C_.clear();
    }

    const GoldenModel& model_;
    const Exact& exact_;
    std::vector<std::uint16_t> n_;
    std::vector<std::int32_t> C_;
    std::vector<std::uint32_t> packed_;
    Findings findings_;
};

/// Hard quotients to look for: so many of each kind.
constexpr std::size_t hard_quotients = 1024;
/// How close to a multiple of D a C 2^S is that counts as next to a quotient boundary.
constexpr std::int64_t reach = 16;

class Run {
public:
    explicit Run(const Options& options)
        : options_(options),
          profile_(parse_profile(options.profile)),
          model_(find_lobe("bps").golden(profile_)),
          numbers_(profile_.shipped() ? find_lobe("bps").numbers(profile_.F, profile_.O) : profile_.custom),
          exact_(std::span<const int, 4>(numbers_)) {
        if (exact_.F < exact_.S) {
            throw Error(fmt::format("profile {} is not legal here: F >= S, so that every quotient occurs at n = 1",
                                    profile_.argument()));
        }
        if (options.count == 0) throw Error("--count 0 is not legal: at least 1");
    }

    int operator()() {
        const std::uint64_t all = max_n * (static_cast<std::uint64_t>(profile_.one()) + 1);
        fmt::print("bps at profile {}: F {}, S {}, K {}, O {}; {} legal inputs; seed {}\n", profile_.argument(),
                   exact_.F, exact_.S, exact_.K, exact_.O, all, options_.seed);
        const auto start = std::chrono::steady_clock::now();
        every_quotient();
        corners();
        random();
        quotient_boundaries();
        if (options_.brute_force) compare_with_brute_force();
        at_quotients("output boundaries", boundary_quotients_);
        at_quotients("worst quotients", worst_quotients_);
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return report();
    }

private:
    using Inputs = std::vector<Input>;

    /// Adds what `fill(task, checker)` adds for every task as one set.
    void set(const std::string& name, std::size_t tasks, auto fill) {
        Findings findings;
        std::mutex mutex;
        parallel_tasks(tasks, options_.threads, io::progress_bar(name), [&] {
            return [&, checker = Checker(*model_, exact_)](std::size_t task) mutable {
                fill(task, checker);
                const Findings part = checker.take();
                const std::lock_guard lock(mutex);
                findings.merge(part);
            };
        });
        if (findings.inputs == 0) failures_.push_back(fmt::format("{}: no input", name));
        if (findings.mismatches != 0) {
            failures_.push_back(
                fmt::format("{}: {} mismatches; {}", name, findings.mismatches, findings.first_mismatch));
        }
        sets_.emplace_back(name, findings);
    }

    /// n = 1, where D = 2^F and the quotient is the cosine code cut to S bits. Notes the quotients at which the error
    /// of some real s is largest, and those next to a boundary of the last rounding.
    void every_quotient() {
        const std::int64_t last = std::int64_t{1} << exact_.S;
        constexpr std::int64_t per_task = 1 << 16;
        std::mutex mutex;
        set("every quotient", static_cast<std::size_t>(last / per_task + 1), [&](std::size_t task, Checker& checker) {
            Least worst(hard_quotients), boundary(hard_quotients);
            const std::int64_t begin = static_cast<std::int64_t>(task) * per_task;
            for (std::int64_t q = begin; q < std::min(begin + per_task, last + 1); ++q) {
                checker.add(1, q << (exact_.F - exact_.S));
                const std::int64_t sum = exact_.last_sum(q);
                worst.add(-largest_error(q, exact_.y_of_sum(sum)), q);
                const std::int64_t unit = std::int64_t{1} << (exact_.S + exact_.K - exact_.O);
                const std::int64_t above = sum & (unit - 1);
                boundary.add(std::min(above, unit - above), q);
            }
            const std::lock_guard lock(mutex);
            worst_quotients_.merge(worst);
            boundary_quotients_.merge(boundary);
        });
        // Once more real_error: an input may be so close to an end of its stretch that only the two differ.
        every_s_ = exact_.in_ulps(-worst_quotients_.entries().front().first + real_error);
    }

    /// The largest error over every real s of a quotient, from q / 2^S up to but not including (q + 1) / 2^S. P falls
    /// up to its minimum, between its two zeros 0.008 and 0.126, and then rises, so max(0, P) is monotone on stretches
    /// of 2^-4 and less, and the error is largest at an end.
    std::int64_t largest_error(std::int64_t q, std::int64_t y) const {
        const int guard = real_bits - exact_.S;
        const std::int64_t at_first = exact_.error(y, q << guard);
        return q >> exact_.S == 1 ? at_first : std::max(at_first, exact_.error(y, (q + 1) << guard));
    }

    /// The ends of the cosine's range, and both sides of every power of two, counted from either end; at every n.
    void corners() {
        const std::int64_t one = profile_.one();
        set("corners", max_n, [&](std::size_t task, Checker& checker) {
            const int n = static_cast<int>(task) + 1;
            std::vector<std::int64_t> codes{0, one};
            for (std::int64_t power = 1; power < one; power *= 2) {
                for (const std::int64_t code : {power - 1, power, power + 1})
                    codes.insert(codes.end(), {code, one - code});
            }
            std::sort(codes.begin(), codes.end());
            codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
            for (const std::int64_t code : codes) checker.add(n, code);
        });
    }

    /// n uniform; every second C uniform, the others such that s is uniform: with C uniform and n large, s is tiny
    /// nearly everywhere.
    void random() {
        constexpr std::uint64_t per_task = 1 << 20;
        const std::int64_t one = profile_.one();
        set("random", static_cast<std::size_t>((options_.count + per_task - 1) / per_task),
            [&](std::size_t task, Checker& checker) {
                Random random(Random(options_.seed).next() + task);
                const std::uint64_t begin = task * per_task;
                for (std::uint64_t i = begin; i < std::min(begin + per_task, options_.count); ++i) {
                    const auto n = static_cast<int>(random.between(1, max_n));
                    std::int64_t C = random.between(0, one);
                    if (i % 2 == 1) {  // C / 2^F = n s / (1 + (n - 1) s), with s the number drawn
                        C = static_cast<std::int64_t>(Integer{n} * C * one / (one + (n - 1) * Integer{C}));
                    }
                    checker.add(n, C);
                }
            });
    }

    /// Every input, n >= 2, whose C 2^S is a multiple of D, or at most `reach` above or below one: the divider's
    /// hardest. (n = 1 is in the first set.)
    void quotient_boundaries() {
        std::mutex mutex;
        set("quotient boundaries", max_n - 1, [&](std::size_t task, Checker& checker) {
            const int n = static_cast<int>(task) + 2;
            Inputs found;
            for (std::int64_t r = -reach; r <= reach; ++r) {
                for (const Input& x : at_remainder(exact_, n, r)) {
                    const Integer shifted = Integer{x.C} << exact_.S;
                    const Integer D = exact_.divisor(n, x.C);
                    if ((shifted - r) % D != 0) throw Error("the search for hard divisions is wrong");
                    found.push_back(x);
                    checker.add(n, x.C);
                    // A wrong quotient seldom shows in y: look at it as well.
                    const std::int64_t golden = golden_quotient(x);
                    if (golden != static_cast<std::int64_t>(shifted / D)) {
                        const std::lock_guard lock(mutex);
                        failures_.push_back(fmt::format("n {}, cos code {}: quotient {}, golden {}", n, x.C,
                                                        static_cast<std::int64_t>(shifted / D), golden));
                    }
                }
            }
            const std::lock_guard lock(mutex);
            boundary_inputs_.insert(boundary_inputs_.end(), found.begin(), found.end());
        });
        std::sort(boundary_inputs_.begin(), boundary_inputs_.end());
    }

    std::int64_t golden_quotient(const Input& x) const {
        for (const Intermediate& value : model_->trace(x.n, x.C)) {
            if (value.name == "quotient") return value.code;
        }
        throw Error("the golden model's trace has no quotient");
    }

    /// The same inputs by trying all of them.
    void compare_with_brute_force() {
        Inputs expected;
        std::mutex mutex;
        parallel_tasks(max_n - 1, options_.threads, io::progress_bar("brute force"), [&] {
            return [&](std::size_t task) {
                const std::int64_t n = static_cast<std::int64_t>(task) + 2;
                Inputs found;
                for (std::int64_t C = 0; C <= profile_.one(); ++C) {
                    const std::int64_t D = n * profile_.one() - (n - 1) * C;
                    const std::int64_t remainder = (C << exact_.S) % D;
                    if (remainder <= reach || remainder >= D - reach) found.push_back({static_cast<int>(n), C});
                }
                const std::lock_guard lock(mutex);
                expected.insert(expected.end(), found.begin(), found.end());
            };
        });
        std::sort(expected.begin(), expected.end());
        fmt::print("quotient boundaries: {} by the search, {} by trying all inputs\n", boundary_inputs_.size(),
                   expected.size());
        if (expected != boundary_inputs_) failures_.emplace_back("quotient boundaries: the search does not find all");
    }

    /// At each of the quotients, for every n >= 2, the inputs on both sides of both ends.
    void at_quotients(const std::string& name, Least& quotients) {
        const auto& entries = quotients.entries();
        set(name, entries.size(), [&](std::size_t task, Checker& checker) {
            for (int n = 2; n <= max_n; ++n) {
                for (const Input& x : of_quotient(exact_, n, entries[task].second)) checker.add(x.n, x.C);
            }
        });
    }

    int report() {
        Findings total;
        std::vector<std::vector<std::string>> rows{{"set", "inputs", "mismatches", "error/ulp", "n", "cos code"}};
        for (const auto& [name, findings] : sets_) {
            total.merge(findings);
            rows.push_back({name, fmt::format("{}", findings.inputs), fmt::format("{}", findings.mismatches),
                            fmt::format("{:.6f}", findings.error.value), fmt::format("{}", findings.error.n),
                            fmt::format("{}", findings.error.cos_code)});
        }
        fmt::print("{}", io::table(rows));
        fmt::print("largest error: {:.6f} ulp measured, {:.6f} for any real s; {:.1f} s\n", total.error.value, every_s_,
                   seconds_);
        if (total.error.value > every_s_) failures_.emplace_back("an input errs more than any real s may");
        if (every_s_ >= 1.0) failures_.emplace_back("the error of some real s is not below 1 ulp");
        if (!options_.json.empty()) write_json(total);
        for (const std::string& failure : failures_) fmt::print("FAILED: {}\n", failure);
        return failures_.empty() ? io::success : io::check_failed;
    }

    /// In the form of `glint sweep --json`, so that proofs/gappa/run.py --measured holds it against the proven bound.
    void write_json(const Findings& total) const {
        Json sets = Json::array();
        for (const auto& [name, findings] : sets_) {
            sets.push_back({{"name", name},
                            {"inputs", findings.inputs},
                            {"mismatches", findings.mismatches},
                            {"max_ulp", findings.error.value},
                            {"n", findings.error.n},
                            {"cos_code", findings.error.cos_code}});
        }
        const Json rounding{{"max_ulp", total.error.value},
                            {"n", total.error.n},
                            {"cos_code", total.error.cos_code},
                            {"max_ulp_any_real_s", every_s_}};
        const Json run{{"lobe", "bps"},
                       {"profile", profile_.name},
                       {"F", exact_.F},
                       {"O", exact_.O},
                       {"unit", "model"},
                       {"test", "wide"},
                       {"exhaustive", false},
                       {"inputs", total.inputs},
                       {"seconds", seconds_},
                       {"seed", options_.seed},
                       {"mismatches", total.mismatches},
                       {"sets", sets},
                       {"accuracy", {{"total", {{"inputs", total.inputs}, {"rounding", rounding}}}}}};
        const Json out{{"tool", "glint-wide"}, {"version", GLINT_VERSION}, {"runs", Json::array({run})}};
        io::write_file(options_.json, out.dump(1) + "\n");
    }

    Options options_;
    Profile profile_;
    std::unique_ptr<GoldenModel> model_;
    std::vector<int> numbers_;  ///< F, S, K, O
    Exact exact_;
    std::vector<std::pair<std::string, Findings>> sets_;
    std::vector<std::string> failures_;
    Least worst_quotients_{hard_quotients}, boundary_quotients_{hard_quotients};
    Inputs boundary_inputs_;
    double every_s_ = 0.0;
    double seconds_ = 0.0;
};

}  // namespace
}  // namespace glint::wide

int main(int argc, char** argv) {
    CLI::App app{
        "The golden model of bps at a profile with too many inputs for a sweep: every quotient, random inputs,\n"
        "and every input next to a rounding boundary, against a second implementation of the contract",
        "glint-wide"};
    glint::wide::Options options;
    app.add_option("--profile", options.profile, "Profile: p8, p12, p16 or F,S,K,O, with F >= S")
        ->capture_default_str();
    app.add_option("--count", options.count, "Random inputs")->capture_default_str();
    app.add_option("--seed", options.seed, "Seed of the random inputs")->capture_default_str();
    app.add_option("--json", options.json, "Write the results as JSON");
    app.add_flag("--brute-force", options.brute_force,
                 "Hold the search for quotient boundaries against all inputs (p8: a second)");
    app.add_option("--threads", options.threads, "Threads; 0: one a core")->capture_default_str();
    app.footer("Example: glint-wide --profile 28,27,27,24 --count 100000000 --seed 1");
    return glint::io::run(app, argc, argv, [&] { return glint::wide::Run(options)(); });
}
