// The C test bench of the HLS kernels: runs a top function on the vectors of a file and compares its results.
//
//   glint-hls-tb [TOP [FILE]]      e.g. glint-hls-tb glint_bps_p8 vectors/glint_bps_p8.tv
//
// FILE, by default TOP.tv, holds a line a vector: the inputs, the outputs and `clamped` in decimal (`glint vectors
// --format tv`). Exit status: 0 all results equal, 1 a mismatch or no vectors, 2 bad arguments, a file that cannot be
// read or a malformed line. HLS tools compile this file with -DGLINT_TOP=<top>, which leaves that one function to call
// and makes it the default; its prototype is in generated/<top>_constants.hpp, or in the include path.
#include <cerrno>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "flat.hpp"

#define GLINT_TEXT_OF(x) #x
#define GLINT_TEXT(x) GLINT_TEXT_OF(x)
#ifndef GLINT_TOPS  // CMake defines it for all kernels and includes their prototypes
#ifndef GLINT_TOP
#define GLINT_TOP glint_bps_p12
#endif
// clang-format off
#define GLINT_PROTOTYPE_OF(top) top##_constants.hpp
#define GLINT_PROTOTYPE(top) GLINT_PROTOTYPE_OF(top)
#define GLINT_TOPS(X) X(GLINT_TOP)
#if __has_include(GLINT_TEXT(generated/GLINT_PROTOTYPE(GLINT_TOP)))
#include GLINT_TEXT(generated/GLINT_PROTOTYPE(GLINT_TOP))
#else
#include GLINT_TEXT(GLINT_PROTOTYPE(GLINT_TOP))
#endif
// clang-format on
#endif

#ifdef GLINT_CATAPULT  // SCVerify puts the RTL in place of the function that CCS_DESIGN names
#include <mc_scverify.h>
#else
#define CCS_MAIN(argc, argv) int main(argc, argv)
#define CCS_DESIGN(top) top
#define CCS_RETURN(status) return (status)
#endif

namespace {

#define GLINT_NAME(top) GLINT_TEXT(top),
const char* const tops[] = {GLINT_TOPS(GLINT_NAME)};

constexpr std::size_t most_ports = 64;

/// Reads the number at `text` and steps over it. False when there is none, or it does not fit 32 bits.
bool read_number(const char*& text, std::int32_t& value) {
    char* end = nullptr;
    errno = 0;
    const long long number = std::strtoll(text, &end, 10);
    if (end == text || errno != 0 || number < INT32_MIN || number > INT32_MAX) return false;
    text = end;
    value = static_cast<std::int32_t>(number);
    return *text == ' ' || *text == '\0' || *text == '\r';
}

/// `count` numbers, `clamped` the last of them, and nothing else.
bool parse(const std::string& line, std::int32_t* numbers, std::size_t count) {
    const char* text = line.c_str();
    for (std::size_t i = 0; i < count; ++i) {
        if (!read_number(text, numbers[i])) return false;
    }
    text += std::strspn(text, " \r");
    return *text == '\0' && (numbers[count - 1] == 0 || numbers[count - 1] == 1);
}

}  // namespace

// One function from the arguments to the result: SCVerify wants the calls of the design here.
CCS_MAIN(int argc, char** argv) {
    const std::string top = argc > 1 ? argv[1] : tops[0];
    const std::string path = argc > 2 ? std::string(argv[2]) : top + ".tv";
    bool known = false;
    std::string all;
    for (const char* name : tops) {
        known = known || top == name;
        all += std::string(all.empty() ? "" : ", ") + name;
    }
    if (argc > 3 || !known) {
        std::fprintf(stderr, "glint-hls-tb: top function '%s' %s; usage: glint-hls-tb [TOP [FILE]], TOP one of: %s\n",
                     top.c_str(), known ? "and file are all that is taken" : "is not here", all.c_str());
        CCS_RETURN(2);
    }

    std::ifstream file(path);
    if (!file) {
        std::fprintf(stderr, "glint-hls-tb: cannot read '%s': %s\n", path.c_str(), std::strerror(errno));
        CCS_RETURN(2);
    }

    constexpr long long shown = 10;  // mismatches printed
    long long vectors = 0;
    long long mismatches = 0;
    std::string line;
    while (std::getline(file, line)) {
        ++vectors;
        bool well_formed = false;
        std::int32_t numbers[most_ports] = {};
        std::int32_t results[most_ports] = {};
        std::size_t inputs = 0;
        std::size_t outputs = 0;
#define GLINT_CALL(name)                                                                               \
    if (top == GLINT_TEXT(name)) {                                                                     \
        using Ports = glint_flat::Ports<decltype(name)>;                                               \
        inputs = Ports::inputs;                                                                        \
        outputs = Ports::outputs;                                                                      \
        well_formed = parse(line, numbers, inputs + outputs) && Ports::carry(numbers);                 \
        if (well_formed) {                                                                             \
            Ports::call([](auto&&... ports) { return CCS_DESIGN(name)(ports...); }, numbers, results); \
        }                                                                                              \
    }
        GLINT_TOPS(GLINT_CALL)
        if (!well_formed) {
            std::fprintf(stderr,
                         "glint-hls-tb: %s:%lld: '%s' is not a vector; legal: %d inputs, %d outputs (clamped last), in "
                         "decimal, as the ports can carry them\n",
                         path.c_str(), vectors, line.c_str(), static_cast<int>(inputs), static_cast<int>(outputs));
            CCS_RETURN(2);
        }
        if (std::memcmp(results, numbers + inputs, outputs * sizeof *results) != 0 && ++mismatches <= shown) {
            std::printf("line %lld: '%s': got", vectors, line.c_str());
            for (std::size_t i = 0; i < outputs; ++i) std::printf(" %" PRId32, results[i]);
            std::printf("\n");
        }
    }
    if (file.bad()) {
        std::fprintf(stderr, "glint-hls-tb: cannot read '%s' to its end\n", path.c_str());
        CCS_RETURN(2);
    }
    std::printf("%s, %s: %lld vectors, %lld mismatches\n", top.c_str(), path.c_str(), vectors, mismatches);
    if (vectors == 0) std::fprintf(stderr, "glint-hls-tb: '%s' has no vectors\n", path.c_str());
    CCS_RETURN(vectors == 0 || mismatches != 0 ? 1 : 0);
}
