#include "cost/decay_formats.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "glint/decay_bounds.hpp"

namespace glint::cost {
namespace {

/// The fewest block RAMs that hold a table: of 4 kbit on iCE40, of 18 elsewhere.
int block_rams(int rows, int bits, bool ice40) {
    constexpr std::array<std::array<int, 2>, 4> small{{{256, 16}, {512, 8}, {1024, 4}, {2048, 2}}};
    constexpr std::array<std::array<int, 2>, 4> large{{{512, 36}, {1024, 18}, {2048, 9}, {4096, 4}}};
    int least = 1 << 20;
    for (const auto& [depth, width] : ice40 ? small : large) {
        least = std::min(least, ((rows + depth - 1) / depth) * ((bits + width - 1) / width));
    }
    return least;
}

/// Fitted to units without DSPs on the HX8K: those of cost/data/fpga.json are within 8 %. A product of a and b bits
/// takes a LUT and more for each of its a b bits, but for its first row and its last places.
constexpr double luts_around = 100.0, luts_of_long_cosine = 25.0, luts_of_n = 37.0;
constexpr double luts_of_bit = 3.27, luts_of_row = 3.46;
/// A product narrower than this stays out of DSPs in Yosys 0.23 (DSP_Y_MINWIDTH).
constexpr int least_dsp_ice40 = 11, least_dsp = 9;

DecayFormat priced(const std::vector<int>& x, const fpga::Device& device, bool dsp) {
    const int F = x[0], A = x[1], M = x[2], V = x[3], H = x[4], G = x[5], W = x[6], n = x[7], O = x[8];
    const bool ice40 = device.family->synthesis == "synth_ice40";
    const int E = static_cast<int>(std::bit_width(static_cast<unsigned>(F - 1)));
    const int slope = V - std::min(A, 4) + 2;  // widths as in docs/lobes/decay.md
    const int step = O + G - H - 1;
    DecayFormat out{x, 0.0, luts_around + (F > 16 ? luts_of_long_cosine : 0.0) + (n == 0 ? luts_of_n : 0.0), 0};
    for (const auto& [a, b] : {std::array{slope, M - A}, std::array{step, V - H}}) {
        if (dsp && device.has_dsps && a + b >= (ice40 ? least_dsp_ice40 : least_dsp)) {
            out.luts += a + b;  // the sum after it
        } else {
            out.luts += std::max(0.0, luts_of_bit * a * b - luts_of_row * (a + b));
        }
    }
    out.luts += 0.1 * (V + O + G);  // among equals the shorter words
    out.brams = block_rams(1 << (E + A), V + 2 + slope, ice40) +
                (n == 0 ? block_rams(512, V, ice40) : block_rams(1024, V + 4, ice40)) +
                block_rams(1 << (W + H), O + G + step, ice40);
    return out;
}

/// Of M and V: DecayBounds.
constexpr int most_of_proof = 18;

/// Every format that may do, and that the device holds.
std::vector<DecayFormat> all_formats(const fpga::Device& device, bool dsp, double max_error, int F_asked) {
    std::vector<DecayFormat> out;
    const auto bits = static_cast<int>(std::floor(-std::log2(max_error)));
    for (int F = F_asked != 0 ? F_asked : 16; F <= (F_asked != 0 ? F_asked : 18); ++F) {
        const int E = static_cast<int>(std::bit_width(static_cast<unsigned>(F - 1)));
        const int longest = std::min({F - 1, bits + 4, most_of_proof});
        for (int O = std::max(4, bits); O <= std::min(F, bits + 4); ++O)
            for (int A = 1; A <= 7; ++A)
                for (int M = std::max(A + 1, bits - 3); M <= longest; ++M)
                    for (int H = 1; H <= 8; ++H)
                        for (int V = std::max({A + 1, H + 1, bits - 2}); V <= std::min(bits + 4, most_of_proof); ++V)
                            for (int G = std::max(0, H + 3 - O); G <= 3; ++G)
                                for (int W = 3; W <= E; ++W)
                                    for (const int n : {0, 1}) {
                                        DecayFormat format = priced({F, A, M, V, H, G, W, n, O}, device, dsp);
                                        if (device.brams == 0 || format.brams <= device.brams)
                                            out.push_back(std::move(format));
                                    }
    }
    return out;
}

}  // namespace

DecaySearch find_decay_formats(const fpga::Device& device, bool dsp, double max_error, int F, int most) {
    std::vector<DecayFormat> all = all_formats(device, dsp, max_error, F);
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.luts < b.luts; });
    DecaySearch out;
    out.tried = static_cast<int>(all.size());
    DecayBounds bounds;
    std::vector<DecayFormat> close;
    constexpr double model_error = 1.08;
    for (DecayFormat& format : all) {
        int better = 0, much_better = 0;
        for (const std::vector<DecayFormat>* found : {&out.formats, &close}) {
            for (const DecayFormat& other : *found) {
                if (other.brams > format.brams) continue;
                ++better;
                much_better += other.luts * model_error < format.luts;
            }
        }
        if (much_better > 0 || better > 2) continue;
        ++out.proven;
        format.bound = bounds(format.numbers, max_error);
        if (format.bound >= max_error) continue;
        (better == 0 ? out.formats : close).push_back(std::move(format));
    }
    const auto wanted = static_cast<std::size_t>(most);
    if (out.formats.size() > wanted) out.formats.erase(out.formats.begin(), out.formats.end() - most);
    for (std::size_t i = 0; i < close.size() && out.formats.size() < wanted; ++i)
        out.formats.push_back(std::move(close[i]));
    return out;
}

}  // namespace glint::cost
