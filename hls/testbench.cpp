// The C test bench of the HLS kernels: runs a top function on the vectors of a file and compares its results.
//
//   glint-hls-tb [TOP [FILE]]      e.g. glint-hls-tb glint_bps_p8 vectors/glint_bps_p8.tv
//
// FILE, by default TOP.tv, holds lines "n cos_code y clamped" in decimal (`glint vectors --format tv`). Exit status: 0
// all results equal, 1 a mismatch or no vectors, 2 bad arguments, a file that cannot be read or a malformed line. HLS
// tools compile this file with -DGLINT_TOP=<top>, which leaves that one function to call and makes it the default.
#include <cerrno>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#ifdef GLINT_TOP
#define GLINT_TOPS(X) X(GLINT_TOP)
#elif !defined(GLINT_TOPS)  // CMake defines it for all lobes
#define GLINT_TOPS(X) X(glint_bps_p12) X(glint_bps_p8) X(glint_bps_p16)
#endif

#ifdef GLINT_CATAPULT  // SCVerify puts the RTL in place of the function that CCS_DESIGN names
#include <mc_scverify.h>
#else
#define CCS_MAIN(argc, argv) int main(argc, argv)
#define CCS_DESIGN(top) top
#define CCS_RETURN(status) return (status)
#endif

#define GLINT_DECLARE(top) extern "C" std::uint32_t top(std::uint16_t n, std::int32_t cos_code);
GLINT_TOPS(GLINT_DECLARE)

namespace {

#define GLINT_TEXT_OF(x) #x
#define GLINT_TEXT(x) GLINT_TEXT_OF(x)
#define GLINT_NAME(top) GLINT_TEXT(top),
const char* const tops[] = {GLINT_TOPS(GLINT_NAME)};

struct Vector {
    std::uint16_t n;
    std::int32_t cos_code;
    std::uint32_t y;
    bool clamped;
};

/// Reads the number at `text` and steps over it. False when there is none, or it is outside low..high.
bool read_number(const char*& text, long long low, long long high, long long& value) {
    char* end = nullptr;
    errno = 0;
    value = std::strtoll(text, &end, 10);
    if (end == text || errno != 0 || value < low || value > high) return false;
    text = end;
    return *text == ' ' || *text == '\0' || *text == '\r';
}

/// Four numbers within what the ports of any profile can carry, and nothing else.
bool parse(const std::string& line, Vector& vector) {
    const char* text = line.c_str();
    long long n = 0;
    long long cos_code = 0;
    long long y = 0;
    long long clamped = 0;
    if (!read_number(text, 0, 1023, n) || !read_number(text, INT32_MIN, INT32_MAX, cos_code) ||
        !read_number(text, 0, INT32_MAX, y) || !read_number(text, 0, 1, clamped)) {
        return false;
    }
    text += std::strspn(text, " \r");
    vector.n = static_cast<std::uint16_t>(n);
    vector.cos_code = static_cast<std::int32_t>(cos_code);
    vector.y = static_cast<std::uint32_t>(y);
    vector.clamped = clamped != 0;
    return *text == '\0';
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
        Vector vector = {};
        if (!parse(line, vector)) {
            std::fprintf(stderr,
                         "glint-hls-tb: %s:%lld: '%s' is not a vector; legal: n cos_code y clamped, in decimal\n",
                         path.c_str(), vectors, line.c_str());
            CCS_RETURN(2);
        }
        std::uint32_t word = 0;
#define GLINT_CALL(name) \
    if (top == GLINT_TEXT(name)) word = CCS_DESIGN(name)(vector.n, vector.cos_code);
        GLINT_TOPS(GLINT_CALL)
        const std::uint32_t expected = vector.y | (vector.clamped ? 0x80000000U : 0U);
        if (word != expected && ++mismatches <= shown) {
            std::printf("line %lld: n = %d, cos_code = %" PRId32 ": y = %" PRIu32 ", clamped = %" PRIu32
                        "; expected y = %" PRIu32 ", clamped = %d\n",
                        vectors, static_cast<int>(vector.n), vector.cos_code, word & 0x7fffffffU, word >> 31, vector.y,
                        vector.clamped ? 1 : 0);
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
