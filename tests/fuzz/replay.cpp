// Without libFuzzer: runs targets on their committed inputs.
//
//     glint-fuzz CORPUS TARGET... [-TARGET...]
//
// CORPUS has a folder a target. A target without an input is a failure, and so is a folder that is not named; with a
// '-' before it, it is one of a target that this build has not.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "targets.hpp"

int main(int argc, char** argv) {
    namespace fs = std::filesystem;
    using namespace glint::fuzz;
    if (argc < 3 || std::freopen("/dev/null", "w", stdout) == nullptr) return 1;
    std::size_t files = 0;
    for (int i = 2; i < argc; ++i) {
        if (argv[i][0] == '-') continue;
        const auto target = std::ranges::find(targets(), argv[i], &Target::name);
        const fs::path folder = fs::path(argv[1]) / argv[i];
        if (target == targets().end() || !fs::is_directory(folder)) {
            std::fprintf(stderr, "%s: there is no such target, or no folder %s\n", argv[i], folder.c_str());
            return 1;
        }
        const std::size_t before = files;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (!entry.is_regular_file()) continue;
            std::ifstream in(entry.path(), std::ios::binary);
            const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
            std::fprintf(stderr, "%s\n", entry.path().c_str());  // the last one is the one that failed
            target->run(text);
            ++files;
        }
        if (files == before) {
            std::fprintf(stderr, "%s: no inputs in %s\n", argv[i], folder.c_str());
            return 1;
        }
    }
    for (const auto& entry : fs::directory_iterator(argv[1])) {
        const std::string name = entry.path().filename().string();
        if (std::none_of(argv + 2, argv + argc, [&](const char* word) { return word == name || word == "-" + name; })) {
            std::fprintf(stderr, "%s: no target was named of this folder\n", entry.path().c_str());
            return 1;
        }
    }
    std::fprintf(stderr, "%zu inputs\n", files);
    return files == 0 ? 1 : 0;
}
