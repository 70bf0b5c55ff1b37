#include "glint/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "glint/reference.hpp"

namespace glint {
namespace {

/// c^n so small is 0 to every output; stopping there keeps the products clear of subnormal numbers, which are slow.
constexpr double negligible = 1e-200;

/// Index of the largest element and the sum of squares.
struct Extremes {
    double largest = -1.0;
    double squares = 0.0;
};

Extremes extremes(const double* values, std::size_t count) {
    // Lanes written out: without licence to reorder sums, compilers do not make them by themselves.
    constexpr std::size_t lanes = 8;
    double largest[lanes];
    double squares[lanes] = {};
    std::fill_n(largest, lanes, -1.0);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double value = values[i + lane];
            largest[lane] = value > largest[lane] ? value : largest[lane];
            squares[lane] += value * value;
        }
    }
    for (; i < count; ++i) {
        largest[0] = std::max(largest[0], values[i]);
        squares[0] += values[i] * values[i];
    }
    Extremes out;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        out.largest = std::max(out.largest, largest[lane]);
        out.squares += squares[lane];
    }
    return out;
}

void update(Worst& worst, double largest, const std::vector<double>& values, int n,
            const std::vector<std::int32_t>& codes) {
    if (largest < worst.value) return;
    const auto at = std::find(values.begin(), values.end(), largest) - values.begin();
    worst.merge({largest, n, codes[static_cast<std::size_t>(at)]});
}

}  // namespace

void Worst::merge(const Worst& other) {
    if (std::tuple(-other.value, other.n, other.cos_code) < std::tuple(-value, n, cos_code)) *this = other;
}

ExactSum& ExactSum::operator+=(double term) {
    if (!(term > 0.0)) return *this;
    int exponent = 0;
    auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::min(term, 0x1p80), &exponent), 53));
    int place = exponent - 53 + 128;
    if (place < 0) {
        mantissa = place > -64 ? mantissa >> -place : 0;
        place = 0;
    }
    const auto word = static_cast<std::size_t>(place / 64);
    const int bit = place % 64;
    ExactSum wide;
    wide.words[word] = mantissa << bit;
    if (bit > 0) wide.words[word + 1] = mantissa >> (64 - bit);
    return *this += wide;
}

ExactSum& ExactSum::operator+=(const ExactSum& other) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::uint64_t sum = words[i] + other.words[i];
        const std::uint64_t with_carry = sum + carry;
        carry = (sum < words[i] || with_carry < sum) ? 1 : 0;
        words[i] = with_carry;
    }
    return *this;
}

double ExactSum::value() const {
    double out = 0.0;
    for (std::size_t i = words.size(); i-- > 0;) {
        out += std::ldexp(static_cast<double>(words[i]), 64 * static_cast<int>(i) - 128);
    }
    return out;
}

ExactSum::Halves ExactSum::halves() const {
    Halves out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<std::uint32_t>(words[i / 2] >> (i % 2 * 32));
    return out;
}

ExactSum ExactSum::of(const Halves& halves) {
    ExactSum out;
    for (std::size_t i = 0; i < halves.size(); ++i) out.words[i / 2] |= std::uint64_t{halves[i]} << (i % 2 * 32);
    return out;
}

double Accuracy::rounding_rms() const { return std::sqrt(rounding_squares.value() / static_cast<double>(inputs)); }
double Accuracy::approximation_rms() const {
    return std::sqrt(approximation_squares.value() / static_cast<double>(inputs));
}

void Accuracy::merge(const Accuracy& other) {
    inputs += other.inputs;
    rounding.merge(other.rounding);
    rounding_squares += other.rounding_squares;
    approximation.merge(other.approximation);
    approximation_squares += other.approximation_squares;
    approximation_exact.merge(other.approximation_exact);
    epicentre.merge(other.epicentre);
}

void AccuracyMeter::Powers::move(int from, int to) {
    value.resize(c.size());
    if (from == 0 || to < from || to - from > 16) {
        for (std::size_t i = 0; i < c.size(); ++i) {
            const double power = std::pow(c[i], to);
            value[i] = power < negligible ? 0.0 : power;
        }
        return;
    }
    double* power = value.data();
    const double* base = c.data();
    const std::size_t count = c.size();
    for (int n = from; n < to; ++n) {
#pragma omp simd
        for (std::size_t i = 0; i < count; ++i) {
            const double next = power[i] * base[i];
            power[i] = next < negligible ? 0.0 : next;
        }
    }
}

AccuracyMeter::AccuracyMeter(const GoldenModel& model, std::span<const std::int32_t> cos_codes)
    : model_(model), codes_(cos_codes.begin(), cos_codes.end()) {
    for (const std::int32_t code : codes_) {
        at_.c.push_back(std::ldexp(code, -model.profile().F));
        below_.c.push_back(std::max(0.0, std::ldexp(code - 0.5, -model.profile().F)));
        above_.c.push_back(std::min(1.0, std::ldexp(code + 0.5, -model.profile().F)));
    }
    exact_.resize(codes_.size());
    rounding_error_.resize(codes_.size());
    error_.resize(codes_.size());
    exact_error_.resize(codes_.size());
}

void AccuracyMeter::move_to(int n) {
    if (n == n_) return;
    at_.move(n_, n);
    below_.move(n_, n);
    above_.move(n_, n);
    n_ = n;
}

void AccuracyMeter::add(int n, std::span<const std::uint32_t> packed, Accuracy& into) {
    const std::size_t count = codes_.size();
    if (count == 0) return;
    move_to(n);
    model_.reference(n, at_.c, exact_);

    const double ulp = std::ldexp(1.0, -model_.profile().O);
    const double inverse_ulp = std::ldexp(1.0, model_.profile().O);
    const double* exact = exact_.data();
    const double* at = at_.value.data();
    const double* below = below_.value.data();
    const double* above = above_.value.data();
    double* rounding_error = rounding_error_.data();
    double* error = error_.data();
    double* exact_error = exact_error_.data();
    const std::uint32_t* word = packed.data();
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        const double y = static_cast<std::int32_t>(word[i] & 0x7fff'ffffU) * ulp;
        rounding_error[i] = std::abs(y - exact[i]) * inverse_ulp;
        error[i] = std::abs(y - at[i]);
        const double low = std::abs(y - below[i]);
        const double high = std::abs(y - above[i]);
        exact_error[i] = low > high ? low : high;
    }

    into.inputs += count;
    const Extremes rounding = extremes(rounding_error, count);
    into.rounding_squares += rounding.squares;
    update(into.rounding, rounding.largest, rounding_error_, n, codes_);
    const Extremes approximation = extremes(error, count);
    into.approximation_squares += approximation.squares;
    update(into.approximation, approximation.largest, error_, n, codes_);
    update(into.approximation_exact, extremes(exact_error, count).largest, exact_error_, n, codes_);

    if (n < 2) return;  // at n = 1 the zone reaches c = 0
    const double edge = reference::epicentre_cosine(n);
    for (std::size_t i = count; i-- > 0 && at_.c[i] >= edge;) into.epicentre.merge({error[i] / at[i], n, codes_[i]});
}

}  // namespace glint
