// Holds a compiled HLS kernel, of a lobe or of an effect, against the golden model, bit for bit.
//
//   hls-kernel-<compiler> LOBE PROFILE legal        every legal input
//   hls-kernel-<compiler> LOBE PROFILE illegal      n = 0 with every cosine code; every illegal cosine code with five n
//   hls-kernel-<compiler> LOBE PROFILE sample       the corners, then 10^7 random inputs of the ports, seed 1
//   hls-kernel-<compiler> effect_NAME PROFILE ports all inputs where the ports carry at most 2^20; else the hard cases,
//                                                   then 2 000 000 random inputs of the ports, seed 1
//
// Exit status: 0 all equal, 1 a difference or a wrong number of inputs, 2 bad arguments.
#include <atomic>
#include <mutex>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lobe_unit.hpp"
#include "glint/lobes.hpp"
#include "glint/parallel.hpp"
#include "glint/vectors.hpp"

namespace {

using Columns = std::vector<std::vector<std::int32_t>>;

struct Kernel {
    std::string_view unit;
    std::string_view profile;
    void (*run)(const std::int32_t* in, std::int32_t* out);  ///< hls/flat.hpp
};

// hls_kernels.inc: one GLINT_KERNEL(top, unit, profile) for every kernel that the object files hold.
#define GLINT_KERNEL(top, unit, profile) extern "C" void top##_flat(const std::int32_t*, std::int32_t*);
#include "hls_kernels.inc"
#undef GLINT_KERNEL
const Kernel kernels[] = {
#define GLINT_KERNEL(top, unit, profile) {unit, profile, top##_flat},
#include "hls_kernels.inc"
#undef GLINT_KERNEL
};

constexpr std::string_view effect_prefix = "effect_";

class Comparison {
public:
    Comparison(const Kernel& kernel, const glint::EffectModel& model) : kernel_(kernel), model_(model) {}

    /// Compares one batch, a column per input port; any thread.
    void run(const Columns& in) {
        const std::size_t count = in[0].size();
        Columns want(model_.outputs().size(), std::vector<std::int32_t>(count));
        std::vector<std::uint8_t> clamped(count);
        std::vector<const std::int32_t*> inputs;
        std::vector<std::int32_t*> outputs;
        for (const auto& column : in) inputs.push_back(column.data());
        for (auto& column : want) outputs.push_back(column.data());
        model_.eval_port_batch(inputs, outputs, clamped);
        std::vector<std::int32_t> row(in.size());
        std::vector<std::int32_t> out(want.size() + 1);  // the last one: clamped
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t p = 0; p < row.size(); ++p) row[p] = in[p][i];
            kernel_.run(row.data(), out.data());
            bool same = out.back() == clamped[i];
            for (std::size_t p = 0; p < want.size(); ++p) same = same && out[p] == want[p][i];
            if (!same) show(row, out, want, i, clamped[i] != 0);
        }
        inputs_ += count;
    }

    std::uint64_t inputs() const { return inputs_; }
    std::uint64_t mismatches() const { return mismatches_; }

private:
    void show(const std::vector<std::int32_t>& in, const std::vector<std::int32_t>& out, const Columns& want,
              std::size_t i, bool clamped) {
        const std::lock_guard lock(mutex_);
        if (++mismatches_ > 10) return;
        for (std::size_t p = 0; p < in.size(); ++p) fmt::print("{} {} ", model_.inputs()[p].name, in[p]);
        fmt::print(": kernel, clamped last, {}; golden", fmt::join(out, " "));
        for (const auto& column : want) fmt::print(" {}", column[i]);
        fmt::print(" {:d}\n", clamped);
    }

    const Kernel& kernel_;
    const glint::EffectModel& model_;
    std::atomic<std::uint64_t> inputs_{0};
    std::uint64_t mismatches_ = 0;
    std::mutex mutex_;
};

constexpr std::int64_t batch = 1 << 14;

/// `count` inputs in batches on all threads, of which make(k, random, row) makes the k-th; a batch has its own seed.
template <class Make>
void compare(std::int64_t count, std::size_t ports, const Make& make, Comparison& comparison) {
    glint::parallel_tasks(static_cast<std::size_t>((count + batch - 1) / batch), 0, {}, [&] {
        return [&, columns = Columns(ports), row = std::vector<std::int64_t>(ports)](std::size_t task) mutable {
            const std::int64_t first = static_cast<std::int64_t>(task) * batch;
            const auto here = static_cast<std::size_t>(std::min(batch, count - first));
            glint::Random random(1 + task);
            for (auto& column : columns) column.resize(here);
            for (std::size_t i = 0; i < here; ++i) {
                make(first + static_cast<std::int64_t>(i), random, row);
                for (std::size_t p = 0; p < ports; ++p) columns[p][i] = static_cast<std::int32_t>(row[p]);
            }
            comparison.run(columns);
        };
    });
}

void compare(const std::vector<std::vector<std::int64_t>>& rows, Comparison& comparison) {
    if (rows.empty()) return;
    compare(
        static_cast<std::int64_t>(rows.size()), rows[0].size(),
        [&](std::int64_t k, glint::Random&, auto& row) { row = rows[static_cast<std::size_t>(k)]; }, comparison);
}

/// The cosine codes first..last, both included, at one n.
void compare_codes(int n, std::int64_t first, std::int64_t last, Comparison& comparison) {
    compare(
        last - first + 1, 2, [=](std::int64_t k, glint::Random&, auto& row) { row[0] = n, row[1] = first + k; },
        comparison);
}

// Each returns the number of inputs that there are.

std::uint64_t compare_legal(std::int64_t one, Comparison& comparison) {
    for (int n = 1; n <= glint::max_n; ++n) compare_codes(n, 0, one, comparison);
    return 1023 * (static_cast<std::uint64_t>(one) + 1);
}

std::uint64_t compare_illegal(std::int64_t one, Comparison& comparison) {
    compare_codes(0, -2 * one, 2 * one - 1, comparison);
    for (const int n : {1, 2, 50, 1000, 1023}) {
        compare_codes(n, -2 * one, -1, comparison);
        compare_codes(n, one + 1, 2 * one - 1, comparison);
    }
    return static_cast<std::uint64_t>(4 * one + 5 * (3 * one - 1));
}

std::uint64_t compare_sample(const glint::GoldenModel& model, Comparison& comparison) {
    constexpr std::int64_t count = 10'000'000;
    std::vector<std::vector<std::int64_t>> corners;
    for (const glint::TestVector& corner : glint::corner_vectors(model)) corners.push_back({corner.n, corner.cos_code});
    compare(corners, comparison);
    const std::int64_t one = model.profile().one();
    const auto make = [one](std::int64_t, glint::Random& random, std::vector<std::int64_t>& row) {
        // One in eight is anything that the ports can carry. Of the legal ones, every other lies in the highlight,
        // where the result is not 0: within 16 / n of 1.
        const std::int64_t n = random.between(0, glint::max_n);
        const bool any = random.between(0, 7) == 0;
        const bool highlight = random.between(0, 1) == 0;
        const std::int64_t width = n <= 16 ? one : one / n * 16;
        row = {n, any         ? random.between(-2 * one, 2 * one - 1)
                  : highlight ? random.between(one - width, one)
                              : random.between(0, one)};
    };
    compare(count, 2, make, comparison);
    return corners.size() + count;
}

std::uint64_t compare_ports(const glint::Effect& effect, const glint::EffectModel& model, Comparison& comparison) {
    const auto ports = model.inputs();
    int bits = 0;
    for (const glint::EffectPort& port : ports) bits += port.bits;
    if (bits <= 20) {
        const auto make = [ports](std::int64_t k, glint::Random&, std::vector<std::int64_t>& row) {
            for (std::size_t p = 0; p < ports.size(); ++p) {
                row[p] = ports[p].least() + (k & ((std::int64_t{1} << ports[p].bits) - 1));
                k >>= ports[p].bits;
            }
        };
        compare(std::int64_t{1} << bits, ports.size(), make, comparison);
        return std::uint64_t{1} << bits;
    }
    constexpr std::int64_t count = 2'000'000;
    std::vector<std::vector<std::int64_t>> cases;
    for (const glint::EffectCase& c : effect.hard_cases(model)) cases.push_back(c.in);
    compare(cases, comparison);
    const auto make = [ports](std::int64_t k, glint::Random& random, std::vector<std::int64_t>& row) {
        for (std::size_t p = 0; p < ports.size(); ++p) {
            row[p] = k % 4 != 0 ? random.between(ports[p].low, ports[p].high)
                                : random.between(ports[p].least(), ports[p].greatest());
            if (k % 2 == 0) row[p] >>= random.between(0, ports[p].bits);  // small ones, too, of every size
        }
    };
    compare(count, ports.size(), make, comparison);
    return cases.size() + count;
}

int check(const Kernel& kernel, std::string_view mode) {
    const glint::Profile profile = glint::parse_profile(kernel.profile);
    std::unique_ptr<glint::GoldenModel> lobe;
    std::unique_ptr<glint::EffectModel> model;
    const glint::Effect* effect = nullptr;
    if (mode == "ports") {
        effect = &glint::find_effect(kernel.unit.substr(effect_prefix.size()));
        model = effect->golden(profile, "bps");
    } else {
        lobe = glint::find_lobe(kernel.unit).golden(profile);
        model = glint::lobe_unit(*lobe);
    }
    Comparison comparison(kernel, *model);
    const std::uint64_t expected = mode == "legal"     ? compare_legal(profile.one(), comparison)
                                   : mode == "illegal" ? compare_illegal(profile.one(), comparison)
                                   : mode == "sample"  ? compare_sample(*lobe, comparison)
                                                       : compare_ports(*effect, *model, comparison);
    fmt::print("{}, {} inputs of {} {}: {} inputs, {} mismatches\n", GLINT_KERNEL_COMPILER, mode, kernel.unit,
               kernel.profile, comparison.inputs(), comparison.mismatches());
    if (comparison.inputs() != expected || expected == 0) {
        fmt::print(stderr, "{} inputs were compared; there are {}\n", comparison.inputs(), expected);
        return 1;
    }
    return comparison.mismatches() == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view unit = argc > 1 ? argv[1] : "";
    const std::string_view profile = argc > 2 ? argv[2] : "";
    const std::string_view mode = argc > 3 ? argv[3] : "";
    const bool of_effect = unit.starts_with("effect_");
    if (argc == 4 && (of_effect ? mode == "ports" : mode == "legal" || mode == "illegal" || mode == "sample")) {
        for (const Kernel& kernel : kernels) {
            if (kernel.unit == unit && kernel.profile == profile) return check(kernel, mode);
        }
    }
    fmt::print(stderr, "unit '{}', profile '{}', mode '{}' are not legal; kernels:", unit, profile, mode);
    for (const Kernel& kernel : kernels) fmt::print(stderr, " {} {},", kernel.unit, kernel.profile);
    fmt::print(stderr, " modes: legal illegal sample; of effects: ports\n");
    return 2;
}
