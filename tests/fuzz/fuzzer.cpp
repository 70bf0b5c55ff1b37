// With libFuzzer: `glint-fuzz TARGET [options of libFuzzer] FOLDER...`.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "targets.hpp"

namespace {

const glint::fuzz::Target* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    using namespace glint::fuzz;
    const auto target = std::ranges::find(targets(), *argc > 1 ? (*argv)[1] : "", &Target::name);
    if (target == targets().end()) {
        std::fprintf(stderr, "usage: glint-fuzz TARGET [options of libFuzzer] FOLDER..., where TARGET is one of:");
        for (const Target& each : targets()) std::fprintf(stderr, " %s", each.name.data());
        std::fprintf(stderr, "\n");
        std::exit(2);
    }
    chosen = &*target;
    std::rotate(*argv + 1, *argv + 2, *argv + *argc);
    --*argc;
    return std::freopen("/dev/null", "w", stdout) == nullptr ? 1 : 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    chosen->run(std::string(reinterpret_cast<const char*>(data), size));
    return 0;
}
