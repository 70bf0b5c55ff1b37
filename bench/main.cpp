// glint-bench: what a lobe costs on this processor, beside what people use for c^n today; glint-bench-models: what a
// lighting model costs (docs/cpu-cost.md). Both take
//
//   [options of Google Benchmark]    times; one iteration of a benchmark is input_count results
//   --describe                       compiler, flags and all cases, as JSON
//   --passes N [NAME ...]            runs the cases for callgrind, all or those named: bench/run.py

#include <benchmark/benchmark.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>

#include <nlohmann/json.hpp>

#include "cases.hpp"

namespace {

using namespace glint::bench;

void add_benchmark(const std::string& name, const std::function<void()>& work) {
    benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) {
        for (auto _ : state) work();
        state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(input_count));
    });
}

int describe() {
    nlohmann::ordered_json out{{"format", program.format},
                               {"compiler", GLINT_BENCH_COMPILER},
                               {"flags", GLINT_BENCH_FLAGS},
                               {"inputs", input_count},
                               {"cases", nlohmann::ordered_json::array()}};
    for (const Case& c : cases()) {
        nlohmann::ordered_json entry{{"name", c.name()}, {program.subject, c.subject}, {"type", c.type}};
        if (!c.profile.empty()) entry["profile"] = c.profile;
        entry["form"] = c.form;
        entry["formula"] = c.formula;
        out["cases"].push_back(std::move(entry));
    }
    std::puts(out.dump(1).c_str());
    return 0;
}

/// Between two calls callgrind counts; it knows the place by this name.
[[gnu::noinline]] void glint_bench_mark() { benchmark::ClobberMemory(); }

int pass(const Case& c, int passes) {
    c.throughput();  // once, for what happens the first time only
    glint_bench_mark();
    for (int i = 0; i < passes; ++i) c.throughput();
    glint_bench_mark();
    for (int i = 0; i < 2 * passes; ++i) c.throughput();
    glint_bench_mark();
    return 0;
}

int run_passes(int argc, char** argv) {
    int passes = 0;
    const char* text = argc > 2 ? argv[2] : "";
    const auto [end, error] = std::from_chars(text, text + std::strlen(text), passes);
    if (error != std::errc{} || *end != '\0' || passes < 1 || passes > 1000) {
        std::fprintf(stderr, "%s: --passes '%s' is not legal: a whole number, 1 to 1000\n", program.name, text);
        return 2;
    }
    const std::vector<Case> all = cases();
    std::vector<const Case*> chosen;
    for (int i = 3; i < argc; ++i) {
        const auto it = std::find_if(all.begin(), all.end(), [&](const Case& c) { return c.name() == argv[i]; });
        if (it == all.end()) {
            std::fprintf(stderr, "%s: '%s' is not legal: a name that --describe lists\n", program.name, argv[i]);
            return 2;
        }
        chosen.push_back(&*it);
    }
    if (argc == 3) {
        for (const Case& c : all) chosen.push_back(&c);
    }
    for (const Case* c : chosen) {
        std::puts(c->name().c_str());
        pass(*c, passes);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
#ifdef __x86_64__
    const std::vector<Case> all = cases();
    const bool batches = std::any_of(all.begin(), all.end(), [](const Case& c) { return c.form == "batch"; });
    if (batches && (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))) {
        std::fprintf(stderr, "%s: this processor lacks AVX2 and FMA, for which the batches are compiled\n",
                     program.name);
        return 2;
    }
#endif
    const std::string_view mode = argc > 1 ? argv[1] : "";
    if (mode == "--describe" && argc == 2) return describe();
    if (mode == "--passes") return run_passes(argc, argv);
    for (const Case& c : dependencies()) add_benchmark("latency/" + c.name(), c.latency);
    for (const Case& c : cases()) {
        add_benchmark("throughput/" + c.name(), c.throughput);
        if (c.latency) add_benchmark("latency/" + c.name(), c.latency);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
