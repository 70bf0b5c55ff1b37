// The proof of a bound of the error of `decay`: docs/lobes/decay.md, "Proof".

#include "glint/decay_bounds.hpp"

#include <cmath>
#include <limits>

#include "decay_format.hpp"

namespace glint {
namespace {

// Bins of x, from the least x of all, -2^5, to 4, where the last octave of fall ends; one more for all x from there on.
constexpr int bin_bits = 6;
constexpr int least_x = -32;
constexpr int end_x = 4;
constexpr int bins = ((end_x - least_x) << bin_bits) + 1;
constexpr double bin_width = 1.0 / (1 << bin_bits);

/// More than what a double and the mathematical library, trusted to 2^-45, add to a difference of numbers below 64.
constexpr double slack = 0x1p-36;

double begin_of(int bin) { return least_x + bin * bin_width; }

std::size_t bin_of(double x) {
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>(std::floor((x - least_x) * (1 << bin_bits))), 0, bins - 1));
}

template <class Range>
void join(Range& range, const Range& other) {
    range = {std::min(range.low, other.low), std::max(range.high, other.high)};
}

double power(double x) { return std::exp(-std::exp2(x)); }

/// The greatest slope of exp(-2^x), downwards, between low and high; it is at its greatest at x = 0.
double slope(double low, double high) {
    const double x = std::clamp(0.0, low, high);
    return std::exp2(x) * power(x) * 0.6931471805599454;
}

/// exp(-2^(x - dx)) - exp(-2^x) for x in a bin and dx in a range: its least and its greatest.
template <class Range>
Range moved(int bin, const Range& dx) {
    const double low = begin_of(bin);
    const double high = bin == bins - 1 ? std::numeric_limits<double>::infinity() : low + bin_width;
    const double up = std::max(dx.high, 0.0);
    const double down = std::max(-dx.low, 0.0);
    Range out{-down * slope(low, high + down), up * slope(low - up, high)};
    // From x = 0 on the slope falls: the difference is greatest at the begin of the bin.
    if (down > bin_width / 4 && low >= 0.0) out.low = power(low + down) - power(low);
    if (bin == bins - 1) out = {-power(low), power(low - up)};
    return out;
}

}  // namespace

// x - X, where X is the sum of the two real logarithms, for x in each bin. A distance that has its x in a bin with a
// small n has a greater x with another n: so the bins after it have its range, too.
const DecayBounds::Ranges& DecayBounds::of_x(const std::vector<int>& numbers) {
    DecayFormat f = decay_words(numbers);
    Ranges& out = x_[{f.F, f.A, f.M, f.V}];
    if (!out.empty()) return out;
    f.logarithm = logarithm_pieces(f);
    f.exponent = exponent_entries(f);
    const double unit = std::ldexp(1.0, -f.V);
    const double none = std::numeric_limits<double>::infinity();
    out.assign(bins, {none, -none});
    Ranges others = out;  // n above 2

    double lambda_low = 0.0;  // lambda is never above the real logarithm
    for (int i = 0; i < 512; ++i) {
        lambda_low = std::min(lambda_low, static_cast<double>(f.exponent[static_cast<std::size_t>(i)]) * unit -
                                              std::log2(1.0 + i / 512.0));
    }
    const double least_lambda = static_cast<double>(f.exponent[256]) * unit;  // of n = 3
    const int R = f.M - f.A;
    const std::int64_t one = std::int64_t{1} << f.F;
    for (int e = 0; e <= std::min(f.F, (1 << f.E) - 1); ++e) {
        const auto real = [&](std::int64_t distance) {  // of d 2^e 2^F
            return std::log2(-std::log1p(-std::ldexp(static_cast<double>(distance), -f.F - e)));
        };
        const int octave = (1 << f.E) - 1 - e;
        const std::int64_t step = std::int64_t{1} << e;
        for (std::int64_t m = 0; m < std::int64_t{1} << f.M; ++m) {
            // The distances d 2^e 2^F that have this m: multiples of 2^e above `begin` up to `end`; a half itself where
            // e is cut; not 2^F at e = 0, where c is 0.
            const std::int64_t begin = one / 2 + (m << (f.F - 1 - f.M));
            const std::int64_t end = one / 2 + ((m + 1) << (f.F - 1 - f.M));
            const bool cut = m == 0 && f.F == 1 << f.E && e == f.F - 1;
            const std::int64_t first = cut ? begin : (begin / step + 1) * step;
            std::int64_t last = end / step * step;
            if (e == 0 && last == one) --last;
            if (first > last) continue;
            const DecayFormat::Piece& p = f.logarithm[static_cast<std::size_t>((octave << f.A) + (m >> R))];
            const std::int64_t code = p.base + ((p.slope * (m & ((1 << R) - 1))) >> R);
            const double w = static_cast<double>(code) * unit - e - 1;
            const Range dx{w - real(last) - slack, w - real(first) + slack};
            join(out[bin_of(w + 1.0)], dx);  // n = 2, where lambda is 0
            join(others[bin_of(w + 1.0 + least_lambda)], {dx.low + lambda_low, dx.high});
        }
    }
    Range all{none, -none};
    for (std::size_t bin = 0; bin < bins; ++bin) {
        join(all, others[bin]);
        join(out[bin], all);
    }
    return out;
}

// y / 2^O - exp(-2^x) for every x in each bin.
const DecayBounds::Ranges& DecayBounds::of_y(const std::vector<int>& numbers) {
    DecayFormat f = decay_words(numbers);
    Ranges& out = y_[{f.E, f.V, f.H, f.G, f.W, f.O}];
    if (!out.empty()) return out;
    f.fall = fall_pieces(f);
    const std::int64_t ends = std::int64_t{end_x - least_x} << f.V;
    std::vector<double>& real = fall_[f.V];
    if (real.empty()) {
        for (std::int64_t i = 0; i < ends; ++i)
            real.push_back(power(least_x + std::ldexp(static_cast<double>(i), -f.V)));
    }
    const double none = std::numeric_limits<double>::infinity();
    out.assign(bins, {none, -none});
    const std::int64_t origin = std::int64_t{(1 << f.E) + 6 + least_x} << f.V;  // of the code of x
    const double unit = std::ldexp(1.0, -f.O);
    for (std::int64_t i = std::max<std::int64_t>(0, -origin); i < ends; ++i) {
        Range& range = out[static_cast<std::size_t>(f.V > bin_bits ? i >> (f.V - bin_bits) : i << (bin_bits - f.V))];
        const double error =
            static_cast<double>(f.result(f.fall_at(origin + i))) * unit - real[static_cast<std::size_t>(i)];
        join(range, {error, error});
    }
    out.back() = {-power(end_x), static_cast<double>(f.result(f.fall_at(origin + ends))) * unit};
    return out;
}

double DecayBounds::operator()(const std::vector<int>& numbers, double enough) {
    const DecayFormat f = decay_words(numbers);
    constexpr int most = 18;
    in_range(f.lobe, "M of a proof", f.M, 1, most);
    in_range(f.lobe, "V of a proof", f.V, 1, most);
    double out = std::ldexp(1.0, -f.O) - std::ldexp(1.0, -f.F) + slack;  // n = 1: C cut to O bits
    if (out >= enough) return out;
    const Ranges& y = of_y(numbers);
    const Ranges& x = of_x(numbers);
    for (int k = 0; k < bins && out < enough; ++k) {
        const int bin = (k + bins - (6 << bin_bits)) % bins;  // from x = -2 on, where most is lost
        const Range& dx = x[static_cast<std::size_t>(bin)];
        const Range& dy = y[static_cast<std::size_t>(bin)];
        if (dx.low > dx.high || dy.low > dy.high) continue;  // no x is there
        const Range by_x = moved(bin, dx);
        out = std::max({out, dy.high - by_x.low + slack, by_x.high - dy.low + slack});
    }
    return out;
}

double decay_bound(const Profile& profile) { return DecayBounds()(decay_numbers(profile)); }

}  // namespace glint
