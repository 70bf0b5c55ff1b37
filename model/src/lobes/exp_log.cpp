#include "exp_log.hpp"

#include <bit>

namespace glint::exp_log {
namespace {

// p moves by 0.35 to 0.69 units where t moves by one: h has to move by less, or p would not fall everywhere.
constexpr int exp2_guard_bits = 2;

/// x y for 0 <= x, y <= 1.
Wide product(Wide x, Wide y) {
    constexpr int half = wide_bits / 2;
    constexpr Wide low = (Wide{1} << half) - 1;
    const Wide middle = (x >> half) * (y & low) + (x & low) * (y >> half);
    return (x >> half) * (y >> half) + (middle >> half);
}

/// ln(x / y) = 2 artanh((x - y) / (x + y)) for 0 < y <= x <= 2 y < 2^14.
Wide ln_ratio(int x, int y) {
    const int numerator = x - y;
    const int denominator = x + y;
    Wide power = wide_one * numerator / denominator;
    Wide sum = 0;
    for (int k = 1; power != 0; k += 2) {
        sum += power / k;
        power = power * numerator / denominator * numerator / denominator;
    }
    return 2 * sum;
}

Wide ln2() {
    static const Wide value = ln_ratio(2, 1);
    return value;
}

}  // namespace

Wide over_ln2(Wide x) {
    Wide quotient = x / ln2();
    Wide rest = x % ln2();
    for (int bit = 0; bit < wide_bits; ++bit) {
        rest *= 2;
        quotient = 2 * quotient + (rest >= ln2() ? 1 : 0);
        if (rest >= ln2()) rest -= ln2();
    }
    return quotient;
}

Wide log2_1p(int x, int bits) { return over_ln2(ln_ratio((1 << bits) + x, 1 << bits)); }

Wide exp2_minus(int x, int bits) {
    const Wide exponent = (ln2() * x) >> bits;
    Wide term = wide_one;
    Wide sum = 0;
    for (int k = 1; term != 0; ++k) {
        sum += k % 2 == 1 ? term : -term;
        term = product(term, exponent) / k;
    }
    return sum;
}

Wide log2(Wide x) {
    // 2^k v, v in [1, 2); v is its first 13 bits, times 1 + rest.
    int k = 0;
    while (x < wide_one) x *= 2, --k;
    while (x >= 2 * wide_one) x /= 2, ++k;
    constexpr int head_bits = 12;
    const auto head = static_cast<int>(x >> (wide_bits - head_bits));
    const Wide rest = ((x - (Wide{head} << (wide_bits - head_bits))) << head_bits) / head;
    Wide ln = ln_ratio(head, 1 << head_bits);
    Wide power = rest;
    for (int i = 1; power != 0; ++i) {
        ln += (i % 2 == 1 ? power : -power) / i;
        power = product(power, rest);
    }
    return k * wide_one + over_ln2(ln);
}

Wide exp_minus(Wide x) {
    const auto halvings = static_cast<int>(x / ln2());
    const Wide rest = x % ln2();
    Wide term = wide_one;
    Wide sum = 0;
    for (int k = 1; term != 0; ++k) {
        sum += k % 2 == 1 ? term : -term;
        term = product(term, rest) / k;
    }
    return sum >> halvings;
}

Wide log_ratio(int x, int bits) {
    Wide power = wide_one;
    Wide sum = 0;
    for (int k = 1; power != 0; ++k) {
        sum += power / k;
        power = (power * x) >> bits;
    }
    return sum;
}

Wide minus_log_1m(int x, int bits) {
    int rest = (1 << bits) - x;
    int halvings = 0;
    for (; 2 * rest <= 1 << bits; rest *= 2) ++halvings;
    return halvings * ln2() + ln_ratio(1 << bits, rest);
}

std::int64_t nearest(Wide x, int bits) {
    const int cut = wide_bits - bits;
    const Wide half = Wide{1} << (cut - 1);
    const Wide margin = Wide{1} << (wide_bits - 85);
    const auto code = static_cast<std::int64_t>((x + half) >> cut);
    if (code != static_cast<std::int64_t>((x + half - margin) >> cut) ||
        code != static_cast<std::int64_t>((x + half + margin) >> cut)) {
        throw Error(fmt::format("a table entry at {} fraction bits lies within 2^-85 of a half", bits));
    }
    return code;
}

Table Pieces::table(std::string_view function, std::string_view name, int c0_width, int c1_width, int c2_width) const {
    Table out{std::string(name), {{"c0", c0_width}, {"c1", c1_width}, {"c2", c2_width}}, {}, {}};
    // What an entry depends on: the piece, and the fraction bits of the value.
    out.module = fmt::format("{}_{}_{}", function, pieces.size(), c0_width);
    const auto fits = [](std::int64_t x, int width) {
        return x >= -(std::int64_t{1} << (width - 1)) && x < std::int64_t{1} << (width - 1);
    };
    for (const Piece& c : pieces) {
        if (c.c0 < 0 || !fits(c.c0, c0_width + 1) || !fits(c.c1, c1_width) || !fits(c.c1 + c.c2, c1_width) ||
            !fits(c.c2, c2_width)) {
            throw Error(fmt::format("table {}: {}, {}, {} do not fit {}, {}, {} bits", name, c.c0, c.c1, c.c2, c0_width,
                                    c1_width, c2_width));
        }
        out.rows.push_back({c.c0, c.c1, c.c2});
    }
    return out;
}

// c1 is what is left for it when both ends of the piece are rounded values of the function: pieces join without a step.
Pieces make_pieces(const std::function<Wide(int x, int bits)>& real, int address, int R, int value_bits, int G) {
    Pieces out{R, G, {}};
    const int bits = address + 1;
    for (int x = 0; x < 1 << bits; x += 2) {
        const Wide begin = real(x, bits);
        const Wide end = real(x + 2, bits);
        Pieces::Piece piece;
        piece.c0 = nearest(begin, value_bits);
        piece.c2 = nearest(2 * begin - 4 * real(x + 1, bits) + 2 * end, value_bits + G);
        piece.c1 = ((nearest(end, value_bits) - piece.c0) << G) - piece.c2;
        out.pieces.push_back(piece);
    }
    return out;
}

// Ranges: docs/exp-log.md. L <= 38, F <= 30, T >= 4 keep h r below 2^60.
Log2::Steps Log2::steps(std::int64_t C) const {
    if (C == 0) return {F + 1, 0, 0, 0, std::int64_t{31} << L};
    Steps x;
    x.z = F + 1 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(C)));
    x.M = ((C << x.z) - (std::int64_t{1} << F)) >> (1 + cut);
    const Pieces::Steps l = pieces.steps(static_cast<std::size_t>(x.M >> pieces.R), x.M & ((1 << pieces.R) - 1));
    x.h = l.h;
    x.l = l.value;
    x.u = (x.z << L) - x.l;
    return x;
}

Table Log2::table(std::string_view name) const { return pieces.table("log2", name, L, L - T + 2, L - 2 * T + 1); }

Exp2::Steps Exp2::steps(std::int64_t t) const {
    const std::int64_t fraction = t & ((std::int64_t{1} << S) - 1);
    const auto integer = static_cast<int>(std::min<std::int64_t>(t >> S, O + 2));  // 0 from there on
    const Pieces::Steps p =
        pieces.steps(static_cast<std::size_t>(fraction >> pieces.R), fraction & ((std::int64_t{1} << pieces.R) - 1));
    const int cut = S - O + integer;
    return {p.h, p.value, cut < 0 ? p.value << -cut : rnd(p.value, cut)};
}

Table Exp2::table() const { return pieces.table("exp2", "exp2", S + 1, S - E + 1 + pieces.G, S - 2 * E + pieces.G); }

std::vector<int> shipped_numbers(int F, int O) { return {F, O / 4 + 2, O + 13, O / 4, O + 4, O}; }

WordLengths word_lengths(std::string_view lobe, const Profile& profile) {
    if (!profile.shipped()) check_custom(profile, lobe, "F,T,L,E,S,O");
    const std::vector<int> numbers = profile.shipped() ? shipped_numbers(profile.F, profile.O) : profile.custom;
    in_range(lobe, "S", numbers[4], profile.O + 1, numbers[2] - 1);  // t is rounded from L bits to S
    return {numbers[1], numbers[2], numbers[3], numbers[4]};
}

Log2 make_log2(std::string_view lobe, int F, int T, int L, int cut) {
    in_range(lobe, "T", T, 4, std::min(10, F - cut - 2));
    in_range(lobe, "L", L, std::max(F - cut + 1, 2 * T + 1), 38);
    const int R = F - cut - 1 - T;
    return {F, T, L, cut, make_pieces(log2_1p, T, R, L, 0)};
}

Exp2 make_exp2(std::string_view lobe, int E, int S, int O) {
    in_range(lobe, "E", E, 2, 8);
    in_range(lobe, "S", S, 2 * E + 2, 32);
    return {E, S, O, make_pieces(exp2_minus, E, S - E, S, exp2_guard_bits)};
}

void add_end_cases(const GoldenModel& model, std::vector<HardCase>& cases) {
    for (const int n : {1, 50, 1023}) {
        const int rises = first_code(model, n, "y");
        if (rises > 0) {
            cases.push_back({fmt::format("n = {}, last 0", n), n, rises - 1, "the last shift to leave nothing"});
            cases.push_back(
                {fmt::format("n = {}, first result", n), n, rises, "a half that rounds up from below the last place"});
        }
        cases.push_back({fmt::format("n = {}, first 1", n), n,
                         first_code(model, n, "y", std::int64_t{1} << model.profile().O),
                         "rounds up to 1 below the peak: the carry reaches bit O"});
    }
}

}  // namespace glint::exp_log
