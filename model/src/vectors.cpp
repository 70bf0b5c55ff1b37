#include "glint/vectors.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::vector<std::int64_t> corner_codes(const EffectPort& port) {
    const std::int64_t one = std::int64_t{1} << port.fraction_bits;
    std::vector<std::int64_t> codes{
        port.least(), port.low - 1, port.low,      -one,           -1, 0, 1, one / 64 + 1, one / 2, one - 1,
        one,          port.high,    port.high + 1, port.greatest()};
    if (port.fraction_bits == 0) codes.push_back((port.low + port.high) / 20);
    std::sort(codes.begin(), codes.end());
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    std::erase_if(codes, [&](std::int64_t code) { return code < port.least() || code > port.greatest(); });
    return codes;
}

std::int64_t random_legal_code(const EffectPort& port, Random& random) {
    const auto kind = random.between(0, 3);
    if (kind < 2) return random.between(port.low, port.high);
    const std::int64_t distance = random.between(0, (std::int64_t{1} << random.between(0, port.bits)) - 1);
    if (kind == 3) return std::clamp(port.high - distance, port.low, port.high);
    const bool negative = port.low < 0 && random.between(0, 1) == 1;
    return std::clamp(negative ? -distance : distance, port.low, port.high);
}

std::vector<EffectVector> corner_vectors(const Effect& effect, const EffectModel& model, std::uint64_t seed) {
    Random random(seed);
    std::vector<EffectVector> out;
    for (const EffectCase& hard : effect.hard_cases(model)) out.push_back({hard.in, model.eval_port(hard.in)});
    const auto ports = model.inputs();
    std::vector<std::int64_t> in(ports.size());
    for (std::size_t chosen = 0; chosen < ports.size(); ++chosen) {
        for (const std::int64_t code : corner_codes(ports[chosen])) {
            for (std::size_t p = 0; p < ports.size(); ++p) {
                in[p] = p == chosen ? code : random_legal_code(ports[p], random);
            }
            out.push_back({in, model.eval_port(in)});
        }
    }
    return out;
}

std::vector<EffectVector> make_vectors(const Effect& effect, const EffectModel& model, std::size_t count,
                                       std::uint64_t seed) {
    std::vector<EffectVector> out = corner_vectors(effect, model, seed);
    if (count < out.size()) {
        throw Error(
            fmt::format("count {} is not legal: at least {}, the hard cases and corner codes", count, out.size()));
    }
    Random random(~seed);
    std::vector<std::int64_t> in;
    while (out.size() < count) {
        in.clear();
        for (const EffectPort& port : model.inputs()) {
            const bool any = random.between(0, 7) == 0;
            in.push_back(any ? random.between(port.least(), port.greatest()) : random_legal_code(port, random));
        }
        out.push_back({in, model.eval_port(in)});
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

std::string format_vectors(const EffectModel& model, const std::vector<EffectVector>& vectors, VectorFormat format) {
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    if (format == VectorFormat::csv) {
        for (const EffectPort& port : model.inputs()) fmt::format_to(to, "{},", port.name);
        for (const EffectPort& port : model.outputs()) fmt::format_to(to, "{},", port.name);
        fmt::format_to(to, "clamped\n");
    }
    for (const EffectVector& v : vectors) {
        std::vector<std::int64_t> row = v.in;
        row.insert(row.end(), v.expected.values.begin(), v.expected.values.end());
        row.push_back(v.expected.clamped ? 1 : 0);
        switch (format) {
            case VectorFormat::tv:
                fmt::format_to(to, "{}\n", fmt::join(row, " "));
                break;
            case VectorFormat::csv:
                fmt::format_to(to, "{}\n", fmt::join(row, ","));
                break;
            case VectorFormat::hex:  // 32 bits a field, the first one on top
                for (const std::int64_t field : row) fmt::format_to(to, "{:08x}", static_cast<std::uint32_t>(field));
                fmt::format_to(to, "\n");
                break;
        }
    }
    return fmt::to_string(out);
}

}  // namespace glint
