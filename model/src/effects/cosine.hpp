// The cosine of two vectors of integers: docs/effects/cosine.md.
#pragma once

#include <cmath>
#include <cstdint>

namespace glint {

/// s fills 4 W bits, up to 72: the one exception to the rule of 64 bits (docs/contract.md).
using Wide = unsigned __int128;

/// What two vectors of W bits make of each other, and how far it is moved up.
struct VectorProduct {
    std::int64_t p = 0, aa = 0, bb = 0, j = 0;
    std::int64_t p_up = 0;  ///< p 4^j
    Wide s_up = 0;          ///< s 16^j; 0 where a vector is 0

    // p and the squares are at most 3 2^(2W-2) in magnitude; |p| 4^j is below 2^(2W), since p^2 <= s.
    VectorProduct(int W, const std::int64_t* a, const std::int64_t* b) {
        for (int i = 0; i < 3; ++i) {
            p += a[i] * b[i];
            aa += a[i] * a[i];
            bb += b[i] * b[i];
        }
        s_up = static_cast<Wide>(aa) * static_cast<Wide>(bb);
        if (s_up == 0) return;
        while (s_up >> (4 * W - 4) == 0) {
            s_up <<= 4;
            ++j;
        }
        p_up = p * (std::int64_t{1} << (2 * j));
    }

    /// floor(sqrt(s 16^j 2^(2K-4W))): K bits, at least 2^(K-2). Legal: K at most 31.
    std::int64_t root(int W, int K) const {
        const int places = 4 * W - 2 * K;
        const auto radicand = static_cast<std::uint64_t>(places >= 0 ? s_up >> places : s_up << -places);
        auto r = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(radicand)));
        while (r * r > radicand) --r;
        while ((r + 1) * (r + 1) <= radicand) ++r;
        return static_cast<std::int64_t>(r);
    }
};

struct CosineFormat {
    int W = 0;
    int F = 0;

    struct Steps {
        std::int64_t p = 0, aa = 0, bb = 0, j = 0, r = 0, c = 0;
    };

    // |p| 4^j 2^(2F+3-2W) is below 2^(2F+3): with F <= 29 all but s is below 2^62.
    Steps steps(const std::int64_t* a, const std::int64_t* b) const {
        const VectorProduct v(W, a, b);
        Steps x{v.p, v.aa, v.bb, v.j, 0, 0};
        if (v.s_up == 0) return x;
        x.r = v.root(W, F + 2);
        const std::int64_t dividend = v.p_up * (std::int64_t{1} << (2 * F + 3 - 2 * W)) + x.r;
        const std::int64_t divisor = 2 * x.r + 1;
        x.c = dividend >= 0 ? dividend / divisor : -((divisor - 1 - dividend) / divisor);
        return x;
    }
};

}  // namespace glint
