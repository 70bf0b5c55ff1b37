// Holds a compiled HLS kernel against the golden model, bit for bit.
//
//   hls-kernel-<compiler> LOBE PROFILE legal      every legal input
//   hls-kernel-<compiler> LOBE PROFILE illegal    n = 0 with every cosine code; every illegal cosine code with five n
//   hls-kernel-<compiler> LOBE PROFILE sample     the corners, then 10^7 random inputs of the ports, seed 1
//
// Exit status: 0 all equal, 1 a difference or a wrong number of inputs, 2 bad arguments.
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "glint/lobes.hpp"
#include "glint/parallel.hpp"
#include "glint/vectors.hpp"

#include "hls_headers.inc"  // declares the top functions

namespace {

struct Kernel {
    std::string_view lobe;
    std::string_view profile;
    std::uint32_t (*top)(std::uint16_t n, std::int32_t cos_code);
};

// hls_kernels.inc: one GLINT_KERNEL(top, lobe, profile) for every kernel that the object files hold.
const Kernel kernels[] = {
#define GLINT_KERNEL(top, lobe, profile) {lobe, profile, top},
#include "hls_kernels.inc"
#undef GLINT_KERNEL
};

class Comparison {
public:
    Comparison(const Kernel& kernel, const glint::GoldenModel& model) : kernel_(kernel), model_(model) {}

    /// Compares one batch; any thread.
    void run(std::span<const std::uint16_t> n, std::span<const std::int32_t> cos_code) {
        std::vector<std::uint32_t> golden(n.size());
        model_.eval_port_batch(n, cos_code, golden);
        std::uint64_t differing = 0;
        for (std::size_t i = 0; i < n.size(); ++i) {
            const std::uint32_t word = kernel_.top(n[i], cos_code[i]);
            if (word == golden[i]) continue;
            ++differing;
            show(n[i], cos_code[i], word, golden[i]);
        }
        inputs_ += n.size();
        mismatches_ += differing;
    }

    std::uint64_t inputs() const { return inputs_; }
    std::uint64_t mismatches() const { return mismatches_; }

private:
    void show(int n, std::int32_t cos_code, std::uint32_t word, std::uint32_t golden) {
        const std::lock_guard lock(mutex_);
        if (++shown_ > 10) return;
        fmt::print("n = {}, cos_code = {}: kernel {:#010x}, golden {:#010x}\n", n, cos_code, word, golden);
    }

    const Kernel& kernel_;
    const glint::GoldenModel& model_;
    std::atomic<std::uint64_t> inputs_{0};
    std::atomic<std::uint64_t> mismatches_{0};
    std::mutex mutex_;
    int shown_ = 0;
};

constexpr std::int64_t batch = 1 << 14;

/// The cosine codes first..last, both included, at one n.
struct Row {
    int n;
    std::int64_t first;
    std::int64_t last;
};

void compare_rows(const std::vector<Row>& rows, Comparison& comparison) {
    glint::parallel_tasks(rows.size(), 0, {}, [&] {
        return [&comparison, &rows, n = std::vector<std::uint16_t>(),
                codes = std::vector<std::int32_t>()](std::size_t task) mutable {
            const Row& row = rows[task];
            for (std::int64_t low = row.first; low <= row.last; low += batch) {
                const std::int64_t count = std::min(batch, row.last - low + 1);
                n.assign(static_cast<std::size_t>(count), static_cast<std::uint16_t>(row.n));
                codes.resize(static_cast<std::size_t>(count));
                for (std::int64_t i = 0; i < count; ++i) {
                    codes[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(low + i);
                }
                comparison.run(n, codes);
            }
        };
    });
}

/// Returns the number of inputs that there are.
std::uint64_t compare_legal(const glint::Profile& profile, Comparison& comparison) {
    std::vector<Row> rows;
    for (int n = 1; n <= glint::max_n; ++n) rows.push_back({n, 0, profile.one()});
    compare_rows(rows, comparison);
    return 1023 * ((std::uint64_t{1} << profile.F) + 1);
}

std::uint64_t compare_illegal(const glint::Profile& profile, Comparison& comparison) {
    const std::int64_t one = profile.one();
    std::vector<Row> rows{{0, -2 * one, 2 * one - 1}};
    for (const int n : {1, 2, 50, 1000, 1023}) {
        rows.push_back({n, -2 * one, -1});
        rows.push_back({n, one + 1, 2 * one - 1});
    }
    compare_rows(rows, comparison);
    return (std::uint64_t{1} << (profile.F + 2)) + 5 * (3 * (std::uint64_t{1} << profile.F) - 1);
}

std::uint64_t compare_sample(const glint::GoldenModel& model, Comparison& comparison) {
    constexpr std::size_t tasks = 1000;
    constexpr std::size_t per_task = 10000;
    constexpr std::uint64_t seed = 1;
    const std::vector<glint::TestVector> corners = glint::corner_vectors(model);
    std::vector<std::uint16_t> n;
    std::vector<std::int32_t> codes;
    for (const glint::TestVector& corner : corners) {
        n.push_back(static_cast<std::uint16_t>(corner.n));
        codes.push_back(corner.cos_code);
    }
    comparison.run(n, codes);
    const std::int64_t one = model.profile().one();
    glint::parallel_tasks(tasks, 0, {}, [&] {
        return [&comparison, one](std::size_t task) {
            glint::Random random(seed + task);
            std::vector<std::uint16_t> random_n(per_task);
            std::vector<std::int32_t> random_codes(per_task);
            for (std::size_t i = 0; i < per_task; ++i) {
                // One in eight is anything that the ports can carry. Of the legal ones, every other lies in the
                // highlight, where the result is not 0: within 16 / n of 1.
                const int n_here = static_cast<int>(random.between(0, glint::max_n));
                const bool any = random.between(0, 7) == 0;
                const bool highlight = random.between(0, 1) == 0;
                const std::int64_t width = n_here <= 16 ? one : one / n_here * 16;
                random_n[i] = static_cast<std::uint16_t>(n_here);
                random_codes[i] = static_cast<std::int32_t>(any         ? random.between(-2 * one, 2 * one - 1)
                                                            : highlight ? random.between(one - width, one)
                                                                        : random.between(0, one));
            }
            comparison.run(random_n, random_codes);
        };
    });
    return corners.size() + tasks * per_task;
}

int check(const Kernel& kernel, std::string_view mode) {
    const glint::Profile profile = glint::parse_profile(kernel.profile);
    const std::unique_ptr<glint::GoldenModel> model = glint::find_lobe(kernel.lobe).golden(profile);
    Comparison comparison(kernel, *model);
    const std::uint64_t expected = mode == "legal"     ? compare_legal(profile, comparison)
                                   : mode == "illegal" ? compare_illegal(profile, comparison)
                                                       : compare_sample(*model, comparison);
    fmt::print("{}, {} inputs of {} {}: {} inputs, {} mismatches\n", GLINT_KERNEL_COMPILER, mode, kernel.lobe,
               kernel.profile, comparison.inputs(), comparison.mismatches());
    if (comparison.inputs() != expected || expected == 0) {
        fmt::print(stderr, "{} inputs were compared; there are {}\n", comparison.inputs(), expected);
        return 1;
    }
    return comparison.mismatches() == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view lobe = argc > 1 ? argv[1] : "";
    const std::string_view profile = argc > 2 ? argv[2] : "";
    const std::string_view mode = argc > 3 ? argv[3] : "";
    if (argc == 4 && (mode == "legal" || mode == "illegal" || mode == "sample")) {
        for (const Kernel& kernel : kernels) {
            if (kernel.lobe == lobe && kernel.profile == profile) return check(kernel, mode);
        }
    }
    fmt::print(stderr, "lobe '{}', profile '{}', mode '{}' are not legal; kernels:", lobe, profile, mode);
    for (const Kernel& kernel : kernels) fmt::print(stderr, " {} {},", kernel.lobe, kernel.profile);
    fmt::print(stderr, " modes: legal illegal sample\n");
    return 2;
}
