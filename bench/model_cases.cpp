#include <benchmark/benchmark.h>

#include <memory>

#include "cases.hpp"
#include "models.hpp"
#include "opaque.hpp"

namespace glint::bench {
namespace {

/// A little wider than the cubics for D, which are cut to 0 at 33 (of the angle) and 36 degrees (of N.H).
constexpr double throughput_width = 39.0;
/// Where no cubic is cut to 0: with the cut a branch, which processors foresee, the next evaluation would not wait.
constexpr double latency_width = 25.0;

template <class T>
struct Data {
    ModelInputs<T> in;
    std::vector<T> y = std::vector<T>(input_count);

    explicit Data(double widest) : in(highlight_scenes(input_count, widest), studies::paper2::Material{}) {}
};
template <class T>
using Shared = std::shared_ptr<Data<T>>;

template <class T>
Case model_case(const ModelFunction<T>& function, const Shared<T>& each_data, const Shared<T>& chain_data) {
    Case out{std::string(function.name),
             std::is_same_v<T, float> ? "float" : "double",
             "",
             "scalar",
             std::string(function.formula),
             {},
             {}};
    out.throughput = [each = function.each, data = each_data] {
        each(data->in, data->y.data());
        benchmark::ClobberMemory();
    };
    out.latency = [chain = function.chain, data = chain_data] {
        benchmark::DoNotOptimize(chain(data->in, opaque(T{0})));
    };
    return out;
}

template <class T>
void add_models(std::vector<Case>& out) {
    const auto each = std::make_shared<Data<T>>(throughput_width);
    const auto chain = std::make_shared<Data<T>>(latency_width);
    for (const auto& function : model_functions<T>()) out.push_back(model_case<T>(function, each, chain));
}

template <class T>
Case dependency() {
    const auto data = std::make_shared<Data<T>>(latency_width);
    return model_case<T>(model_dependency<T>(), data, data);
}

}  // namespace

const Program program{"glint-bench-models", "model", "glint-cost-cpu-models-1"};

std::vector<Case> dependencies() { return {dependency<double>(), dependency<float>()}; }

std::vector<Case> cases() {
    std::vector<Case> out;
    add_models<double>(out);
    add_models<float>(out);
    return out;
}

}  // namespace glint::bench
