#include <random>

#include "../../hls/blocks/glint_sqrt.hpp"
#include "catch.hpp"
#include "glint/fixed_point.hpp"

namespace {

bool is_floor_sqrt(std::int64_t root, std::int64_t x) {
    return root >= 0 && root * root <= x && x - root * root <= 2 * root;
}

template <int Y_W>
void check_kernel() {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        const std::uint64_t root = random() >> (64 - Y_W);
        const int bits = 1 + i % (2 * Y_W);
        for (const std::uint64_t x :
             {random() >> (64 - bits), root * root, root * root + 2 * root, root == 0 ? 0 : root * root - 1}) {
            const auto found =
                static_cast<std::int64_t>(glint_hls::floor_sqrt<Y_W>(static_cast<glint_hls::uint<2 * Y_W>>(x)));
            if (!is_floor_sqrt(found, static_cast<std::int64_t>(x))) FAIL("floor_sqrt(" << x << ") is not " << found);
        }
    }
    SUCCEED();
}

}  // namespace

TEST_CASE("floor_sqrt: around every square up to 2^20, and up to the end of its range") {
    const auto check = [](std::int64_t root) {
        const std::int64_t square = root * root;
        if (root > 0 && glint::floor_sqrt(square - 1) != root - 1) FAIL("below the square of " << root);
        if (glint::floor_sqrt(square) != root) FAIL("at the square of " << root);
        if (glint::floor_sqrt(square + 2 * root) != root) FAIL("before the next square of " << root);
    };
    for (std::int64_t root = 0; root < std::int64_t{1} << 20; ++root) check(root);
    for (std::int64_t root = (std::int64_t{1} << 31) - 1; root > (std::int64_t{1} << 31) - 100000; --root) check(root);
    SUCCEED();
}

TEST_CASE("floor_sqrt of the kernels: every radicand of 12 bits, squares, their neighbours and any number of more") {
    for (std::int64_t x = 0; x < 1 << 12; ++x) {
        if (glint_hls::floor_sqrt<6>(static_cast<std::uint16_t>(x)) != glint::floor_sqrt(x))
            FAIL("floor_sqrt(" << x << ")");
    }
    check_kernel<19>();
    check_kernel<31>();
}
