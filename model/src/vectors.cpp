#include "glint/vectors.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {
namespace {

/// c with f_s(c, n) = s: c = n s / (1 + (n - 1) s).
double cosine_of_schlick(double s, int n) { return n * s / (1.0 + (n - 1) * s); }

TestVector evaluated(const GoldenModel& model, int n, std::int64_t code) {
    return {n, static_cast<std::int32_t>(code), model.eval_port(n, code)};
}

}  // namespace

std::uint64_t Random::next() {
    state_ += 0x9e37'79b9'7f4a'7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58'476d'1ce4'e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d0'49bb'1331'11ebULL;
    return z ^ (z >> 31);
}

std::int64_t Random::between(std::int64_t low, std::int64_t high) {
    const std::uint64_t span = static_cast<std::uint64_t>(high - low) + 1;  // at most 2^32 for any port
    return low + static_cast<std::int64_t>(next() % span);
}

LegalInput random_legal_input(const Profile& profile, Random& random) {
    const std::int64_t one = profile.one();
    const auto n = static_cast<int>(random.between(1, max_n));
    const bool highlight = random.between(0, 1) == 0;
    const std::int64_t reach = highlight ? std::min(one, 12 * one / n) : one;
    return {n, static_cast<std::int32_t>(one - random.between(0, reach))};
}

std::vector<TestVector> corner_vectors(const GoldenModel& model) {
    const std::int64_t one = model.profile().one();
    std::vector<TestVector> out;
    for (const int n : {0, 1, 2, 8, 50, 1000, 1023}) {
        std::set<std::int64_t> codes{-2 * one, -one, -1, 0, 1, 2, one / 2, one - 2, one - 1, one, one + 1, 2 * one - 1};
        for (const double s : {0.008, 0.126}) {
            const auto near = std::llround(cosine_of_schlick(s, std::max(n, 1)) * static_cast<double>(one));
            for (std::int64_t offset = -1; offset <= 1; ++offset) codes.insert(near + offset);
        }
        for (const std::int64_t code : codes) out.push_back(evaluated(model, n, code));
    }
    return out;
}

std::vector<TestVector> make_vectors(const GoldenModel& model, std::size_t count, std::uint64_t seed) {
    std::vector<TestVector> out = corner_vectors(model);
    if (count < out.size()) {
        throw Error(fmt::format("count {} is not legal: at least {}, the corners", count, out.size()));
    }
    const std::int64_t one = model.profile().one();
    Random random(seed);
    while (out.size() < count) {
        if (random.between(0, 7) == 0) {
            const auto n = static_cast<int>(random.between(0, max_n));
            out.push_back(evaluated(model, n, random.between(-2 * one, 2 * one - 1)));
        } else {
            const LegalInput input = random_legal_input(model.profile(), random);
            out.push_back(evaluated(model, input.n, input.cos_code));
        }
    }
    return out;
}

VectorFormat parse_vector_format(std::string_view text) {
    if (text == "tv") return VectorFormat::tv;
    if (text == "csv") return VectorFormat::csv;
    if (text == "hex") return VectorFormat::hex;
    throw Error(fmt::format("format '{}' is not legal: tv, csv or hex", text));
}

std::string format_vectors(const std::vector<TestVector>& vectors, VectorFormat format) {
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    if (format == VectorFormat::csv) fmt::format_to(to, "n,cos_code,y,clamped\n");
    for (const TestVector& v : vectors) {
        const int clamped = v.expected.clamped ? 1 : 0;
        switch (format) {
            case VectorFormat::tv:
                fmt::format_to(to, "{} {} {} {}\n", v.n, v.cos_code, v.expected.y, clamped);
                break;
            case VectorFormat::csv:
                fmt::format_to(to, "{},{},{},{}\n", v.n, v.cos_code, v.expected.y, clamped);
                break;
            case VectorFormat::hex:  // {cos[31:0], 6'b0, n[9:0], 15'b0, clamped, y[31:0]}
                fmt::format_to(to, "{:08x}{:04x}{:04x}{:08x}\n", static_cast<std::uint32_t>(v.cos_code), v.n, clamped,
                               v.expected.y);
                break;
        }
    }
    return fmt::to_string(out);
}

}  // namespace glint
