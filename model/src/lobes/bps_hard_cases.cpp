#include <cmath>

#include "glint/bps.hpp"
#include "glint/hard_cases.hpp"

namespace glint {

std::vector<HardCase> bps_hard_cases(const GoldenModel& model) {
    const int one = model.profile().one();
    const std::string everywhere = "cosim.exhaustive, labels hls and proof";
    // The code whose Schlick fraction is nearest to s: c = n s / (1 + (n - 1) s).
    const auto at = [&](double s, int n) {
        return static_cast<std::int32_t>(std::lround(n * s / (1.0 + (n - 1) * s) * one));
    };
    // Walks from a code in steps until the result is (or is not) 0.
    const auto walk = [&](int n, std::int32_t code, int step, bool zero) {
        while (code > 0 && code < one && (model.eval(n, code) == 0) != zero) code += step;
        return code;
    };
    const std::int32_t middle = at(0.066, 50);  // the polynomial's minimum, -0.0094
    return {
        {"constant divisor", 1, one / 2, "D = 2^F whatever c: a divider that expects D > 2^F fails", everywhere},
        {"largest divisor", 1023, 0, "D = 1023 2^F needs all of its F + 10 bits", everywhere},
        {"c = 0", 50, 0, "quotient 0: the result is d0, the lobe's floor, and must not be taken for 0", everywhere},
        {"c = 1 ulp, n = 1", 1, 1, "least nonzero dividend", everywhere},
        {"c = 1 ulp, n = 1023", 1023, 1, "quotient 0 though c > 0", everywhere},
        {"c = 1 - 1 ulp, n = 1", 1, one - 1, "quotient next to 2^S", everywhere},
        {"c = 1 - 1 ulp, n = 1023", 1023, one - 1,
         "steepest place: one code of c moves the quotient by up to n 2^(S-F)", everywhere},
        {"c = 1", 1000, one, "quotient 2^S needs the bit S; the peak is 0.9927, not 1", everywhere},
        {"last result before the cut", 50, walk(50, middle, -1, false),
         "s near 0.0078: the polynomial turns negative; an unsigned result would wrap to almost 1",
         everywhere + "; unit: sign changes"},
        {"deepest below 0", 50, middle, "s near 0.066: the sum is negative; max(0, .) has to see its sign",
         everywhere + "; unit: sign changes"},
        {"first result after the cut", 50, walk(50, middle, 1, false), "s near 0.126: the polynomial turns positive",
         everywhere + "; unit: sign changes"},
        {"largest h2", 50, at(0.918, 50), "h2 reaches 1.001: one integer bit and a sign, not a fraction",
         everywhere + "; unit: widths"},
        {"n = 0", 0, one / 2, "(n - 1) would wrap to 1023; counts as 1", "cosim.illegal_p8, labels hls and oracle"},
        {"c just above 1", 50, one + 1, "1 - c would be negative and D too small; counts as 1",
         "cosim.illegal_p8, labels hls and oracle"},
        {"greatest code", 1023, 2 * one - 1, "as above, at the end of the port",
         "cosim.illegal_p8, labels hls and oracle"},
        {"c just below 0", 50, -1, "would be a huge unsigned number; the result is 0",
         "cosim.illegal_p8, labels hls and oracle"},
        {"least code", 1, -2 * one, "its negative does not fit the port", "cosim.illegal_p8, labels hls and oracle"},
        {"n = 0 and c < 0", 0, -one, "two corrections at once: the result is 0, clamped once",
         "cosim.illegal_p8, labels hls and oracle"},
    };
}

}  // namespace glint
