// The cosine of two vectors of integers: docs/effects/cosine.md.
#pragma once

#include <cmath>
#include <cstdint>

namespace glint {

/// s fills 4 W bits, up to 72: the one exception to the rule of 64 bits (docs/contract.md).
using Wide = unsigned __int128;

struct CosineFormat {
    int W = 0;
    int F = 0;

    struct Steps {
        std::int64_t p = 0, aa = 0, bb = 0, j = 0, r = 0, c = 0;
    };

    // p and the squares are at most 3 2^(2W-2) in magnitude; the radicand has 2 F + 4 bits, |p| 4^j 2^(2F+3-2W) is
    // below 2^(2F+3), since p^2 <= s: with F <= 29 all but s is below 2^62.
    Steps steps(const std::int64_t* a, const std::int64_t* b) const {
        Steps x;
        for (int i = 0; i < 3; ++i) {
            x.p += a[i] * b[i];
            x.aa += a[i] * a[i];
            x.bb += b[i] * b[i];
        }
        Wide s = static_cast<Wide>(x.aa) * static_cast<Wide>(x.bb);
        if (s == 0) return x;
        while (s >> (4 * W - 4) == 0) {
            s <<= 4;
            ++x.j;
        }
        const int K = F + 2, places = 4 * W - 2 * K;
        const auto radicand = static_cast<std::uint64_t>(places >= 0 ? s >> places : s << -places);
        auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(radicand)));
        while (root * root > radicand) --root;
        while ((root + 1) * (root + 1) <= radicand) ++root;
        x.r = static_cast<std::int64_t>(root);
        const std::int64_t dividend = x.p * (std::int64_t{1} << (2 * x.j + 2 * F + 3 - 2 * W)) + x.r;
        const std::int64_t divisor = 2 * x.r + 1;
        x.c = dividend >= 0 ? dividend / divisor : -((divisor - 1 - dividend) / divisor);
        return x;
    }
};

}  // namespace glint
