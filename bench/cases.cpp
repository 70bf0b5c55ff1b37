#include "cases.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "functions.hpp"
#include "glint/fixed_point.hpp"
#include "glint/lobes.hpp"
#include "glint/vectors.hpp"
#include "opaque.hpp"
#include "studies/paper.hpp"
#include "studies/study.hpp"

namespace glint::bench {
namespace {

/// Random pairs of n, 9 (from where every formula is its lobe) to 1000, and of an angle, 0 to some widths of the
/// epicentre zone.
struct Pairs {
    std::vector<double> c;
    std::vector<int> n;

    explicit Pairs(double zones) {
        Random random(1);
        for (std::size_t i = 0; i < input_count; ++i) {
            n.push_back(static_cast<int>(random.between(9, studies::paper::last_n)));
            const double part = static_cast<double>(random.between(0, 1 << 30)) / (1 << 30);
            c.push_back(std::cos(part * zones * studies::epicentre_angle(n.back())));
        }
    }
};

/// As a renderer has them where there is a highlight to see: c^n is 1 down to 0.01.
constexpr double throughput_zones = 3.0;
/// Where no lobe is cut to 0: with the cut a branch, which processors foresee, the next evaluation would not wait.
constexpr double latency_zones = 1.0;

template <class T>
struct RealInputs {
    Inputs<T> in;
    std::vector<T> y = std::vector<T>(input_count);

    explicit RealInputs(const Pairs& pairs) : in(pairs.c, pairs.n) {}
};
template <class T>
using SharedInputs = std::shared_ptr<RealInputs<T>>;
template <class T>
SharedInputs<T> real_inputs(double zones) {
    return std::make_shared<RealInputs<T>>(Pairs(zones));
}

template <class T>
Case real_case(const Function<T>& function, const std::string& form, const SharedInputs<T>& each_data,
               const SharedInputs<T>& chain_data) {
    Case out{std::string(function.name),
             std::is_same_v<T, float> ? "float" : "double",
             "",
             form,
             std::string(function.formula),
             {},
             {}};
    out.throughput = [each = function.each, data = each_data] {
        each(data->in, data->y.data());
        benchmark::ClobberMemory();
    };
    if (function.chain != nullptr) {
        out.latency = [chain = function.chain, data = chain_data] {
            benchmark::DoNotOptimize(chain(data->in, opaque(T{0})));
        };
    }
    return out;
}

template <class T>
void add_real(std::vector<Case>& out) {
    const auto each = real_inputs<T>(throughput_zones);
    const auto chain = real_inputs<T>(latency_zones);
    for (const auto& function : scalar_functions<T>()) out.push_back(real_case<T>(function, "scalar", each, chain));
    for (const auto& function : batch_functions<T>()) out.push_back(real_case<T>(function, "batch", each, chain));
#ifdef GLINT_BENCH_LIBMVEC
    for (const auto& function : libmvec_functions<T>()) out.push_back(real_case<T>(function, "batch", each, chain));
#endif
}

struct FixedInputs {
    std::vector<std::uint16_t> n;
    std::vector<std::int32_t> cos_code;
    std::vector<std::uint32_t> packed = std::vector<std::uint32_t>(input_count);

    FixedInputs(const Profile& profile, const Pairs& pairs) : n(pairs.n.begin(), pairs.n.end()) {
        for (const double c : pairs.c) cos_code.push_back(quantize_cosine(c, profile.F));
    }

    /// Each cosine waits for the result before: `zero` is 0, which the compiler does not know.
    void chain(std::uint32_t zero, const auto& evaluate) const {
        std::uint32_t y = 0;
        for (std::size_t i = 0; i < n.size(); ++i) {
            y = evaluate(n[i], cos_code[i] + static_cast<std::int32_t>(y & zero));
        }
        benchmark::DoNotOptimize(y);
    }
};

constexpr std::string_view fixed_profile = "p12";

void add_fixed(std::vector<Case>& out) {
    const Profile profile = parse_profile(fixed_profile);
    const auto each = std::make_shared<FixedInputs>(profile, Pairs(throughput_zones));
    const auto chain = std::make_shared<FixedInputs>(profile, Pairs(latency_zones));
    for (const Lobe& lobe : lobes()) {
        const std::shared_ptr<const GoldenModel> model = lobe.golden(profile);
        Case scalar{std::string(lobe.name), "fixed", profile.name, "scalar", "golden model, eval_port", {}, {}};
        Case batch{std::string(lobe.name), "fixed", profile.name, "batch", "golden model, eval_port_batch", {}, {}};
        scalar.throughput = [model, data = each] {
            for (std::size_t i = 0; i < data->n.size(); ++i) {
                data->packed[i] = pack(model->eval_port(data->n[i], data->cos_code[i]));
            }
            benchmark::ClobberMemory();
        };
        scalar.latency = [model, data = chain] {
            data->chain(opaque(0U), [&](int n, std::int32_t code) { return pack(model->eval_port(n, code)); });
        };
        batch.throughput = [model, data = each] {
            model->eval_port_batch(data->n, data->cos_code, data->packed);
            benchmark::ClobberMemory();
        };
        out.push_back(std::move(scalar));
        out.push_back(std::move(batch));
    }
}

template <class T>
Case real_dependency() {
    const auto in = real_inputs<T>(latency_zones);
    return real_case<T>(dependency<T>(), "scalar", in, in);
}

}  // namespace

const Program program{"glint-bench", "lobe", "glint-cost-cpu-1"};

std::vector<Case> dependencies() {
    const auto data = std::make_shared<FixedInputs>(parse_profile(fixed_profile), Pairs(latency_zones));
    Case fixed{"dependency", "fixed", std::string(fixed_profile), "scalar", "code + (y & zero)", {}, {}};
    fixed.latency = [data] {
        data->chain(opaque(0U), [](int, std::int32_t code) { return static_cast<std::uint32_t>(code); });
    };
    return {real_dependency<double>(), real_dependency<float>(), fixed};
}

std::vector<Case> cases() {
    std::vector<Case> out;
    add_real<double>(out);
    add_real<float>(out);
    add_fixed(out);
    return out;
}

}  // namespace glint::bench
