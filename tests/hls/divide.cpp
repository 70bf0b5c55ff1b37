// The divider of the HLS kernels, in the form that a macro chooses, against division: every pair of operands of small
// widths, corners and random ones at widths in use. Exit status: 0 all equal, 1 not.
#include "blocks/glint_divide.hpp"

#include <cstdint>
#include <cstdio>
#include <random>

namespace {

long long tried = 0, wrong = 0;

template <int S, int D_W>
void compare(std::uint64_t below, std::uint64_t D) {
    using Wide = unsigned __int128;
    const auto quotient = static_cast<std::uint64_t>((static_cast<Wide>(D - below) << S) / D);
    const auto found = static_cast<std::uint64_t>(
        glint_hls::divide_below<S, D_W>(glint_hls::to_uint<D_W>(below), glint_hls::to_uint<D_W>(D)));
    ++tried;
    if (found != quotient && ++wrong <= 10) {
        std::printf("S %d, D_W %d: below %llu, D %llu: %llu, and not %llu\n", S, D_W,
                    static_cast<unsigned long long>(below), static_cast<unsigned long long>(D),
                    static_cast<unsigned long long>(found), static_cast<unsigned long long>(quotient));
    }
}

template <int S, int D_W>
void all() {
    for (std::uint64_t D = 1; D < std::uint64_t{1} << D_W; ++D) {
        for (std::uint64_t below = 0; below <= D; ++below) compare<S, D_W>(below, D);
    }
}

template <int S, int D_W>
void some() {
    std::mt19937_64 random(S * 100 + D_W);
    const std::uint64_t last = (std::uint64_t{1} << D_W) - 1;
    for (int length = 1; length <= D_W; ++length) {  // every place of the leading one, with its neighbours
        for (const std::uint64_t D :
             {std::uint64_t{1} << (length - 1), (std::uint64_t{1} << (length - 1)) + 1, last >> (D_W - length)}) {
            if (D > last) continue;
            for (const std::uint64_t below : {std::uint64_t{0}, std::uint64_t{1}, D / 2, D - 1, D})
                compare<S, D_W>(below, D);
            for (int i = 0; i < 3000; ++i) {
                const std::uint64_t any = (random() & (last >> (D_W - length))) | std::uint64_t{1} << (length - 1);
                compare<S, D_W>(random() % (any + 1), any);
            }
        }
    }
}

}  // namespace

int main() {
    all<2, 6>();
    all<3, 8>();
    all<8, 9>();
    all<9, 9>();
    all<10, 4>();
    some<13, 26>();  // schlick and bps p8
    some<16, 26>();
    some<17, 29>();
    some<18, 31>();
    some<20, 31>();
    some<23, 54>();  // effects
    some<30, 41>();  // the widest that is legal
    std::printf("%lld quotients, %lld wrong\n", tried, wrong);
    return wrong == 0 ? 0 : 1;
}
