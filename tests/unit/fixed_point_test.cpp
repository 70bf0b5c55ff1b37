#include "glint/fixed_point.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "glint/error.hpp"

using namespace glint;

TEST_CASE("rnd is floor((x + 2^(k-1)) / 2^k)") {
    for (int k = 0; k <= 12; ++k) {
        for (std::int64_t x = -20000; x <= 20000; ++x) {
            // floor by its definition: the largest integer whose product with 2^k does not exceed the number.
            const std::int64_t y = rnd(x, k);
            const std::int64_t unit = std::int64_t{1} << k;
            const std::int64_t shifted = k == 0 ? x : x + unit / 2;
            if (!(y * unit <= shifted && shifted < (y + 1) * unit)) FAIL("x " << x << " k " << k);
        }
    }
    SUCCEED();
}

TEST_CASE("rnd rounds halves up, on both sides of 0") {
    CHECK(rnd(3, 1) == 2);
    CHECK(rnd(-3, 1) == -1);
    CHECK(rnd(-4, 3) == 0);
    CHECK(rnd(-5, 3) == -1);
    CHECK(rnd(4, 3) == 1);
    CHECK(rnd((std::int64_t{1} << 61) - 1, 62) == 0);
    CHECK(rnd(std::int64_t{1} << 61, 62) == 1);
}

TEST_CASE("constants round halves away from zero") {
    CHECK(quantize_constant(0.5, 0) == 1);
    CHECK(quantize_constant(-0.5, 0) == -1);
    CHECK(quantize_constant(1.25, 1) == 3);
    CHECK(quantize_constant(-1.25, 1) == -3);
    CHECK(quantize_constant(-1.631, 15) == -53445);
    CHECK_THROWS_AS(quantize_constant(64.0, 8), Error);
    CHECK_THROWS_AS(quantize_constant(std::nan(""), 8), Error);
    CHECK_THROWS_AS(quantize_constant(1.0, 49), Error);
    CHECK_THROWS_AS(quantize_constant(1.0, -1), Error);
}

TEST_CASE("cosines stay within what the port carries") {
    CHECK(quantize_cosine(1.0, 18) == 1 << 18);
    CHECK(quantize_cosine(-1.0, 18) == -(1 << 18));
    CHECK(quantize_cosine(std::nextafter(2.0, 0.0), 16) == (2 << 16) - 1);
    CHECK(quantize_cosine(std::nextafter(-2.0, 0.0), 30) == std::numeric_limits<std::int32_t>::min());
    CHECK_THROWS_AS(quantize_cosine(2.0, 16), Error);
    CHECK_THROWS_AS(quantize_cosine(std::numeric_limits<double>::infinity(), 16), Error);
}
