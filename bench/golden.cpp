// The golden model of every lobe: scalar against batch, results per second.

#include <benchmark/benchmark.h>

#include "glint/lobes.hpp"
#include "glint/vectors.hpp"

namespace {

using namespace glint;

/// Random legal inputs: 4096 stay in the first-level cache, so that arithmetic is what is measured.
struct Inputs {
    std::vector<std::uint16_t> n;
    std::vector<std::int32_t> cos_code;
    std::vector<std::uint32_t> packed;

    explicit Inputs(const GoldenModel& model) : packed(4096) {
        Random random(1);
        for (std::size_t i = 0; i < packed.size(); ++i) {
            n.push_back(static_cast<std::uint16_t>(random.between(1, max_n)));
            cos_code.push_back(static_cast<std::int32_t>(random.between(0, model.profile().one())));
        }
    }
};

void scalar(benchmark::State& state, const GoldenModel& model) {
    Inputs in(model);
    for (auto _ : state) {
        for (std::size_t i = 0; i < in.n.size(); ++i) in.packed[i] = pack(model.eval_port(in.n[i], in.cos_code[i]));
        benchmark::DoNotOptimize(in.packed.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(in.n.size()));
}

void batch(benchmark::State& state, const GoldenModel& model) {
    Inputs in(model);
    for (auto _ : state) {
        model.eval_port_batch(in.n, in.cos_code, in.packed);
        benchmark::DoNotOptimize(in.packed.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(in.n.size()));
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::unique_ptr<GoldenModel>> models;
    for (const Lobe& lobe : lobes()) {
        for (const Profile& profile : shipped_profiles()) {
            models.push_back(lobe.golden(profile));
            const GoldenModel& model = *models.back();
            const std::string name = std::string(lobe.name) + "/" + profile.name;
            benchmark::RegisterBenchmark(("scalar/" + name).c_str(), [&model](auto& state) { scalar(state, model); });
            benchmark::RegisterBenchmark(("batch/" + name).c_str(), [&model](auto& state) { batch(state, model); });
        }
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
