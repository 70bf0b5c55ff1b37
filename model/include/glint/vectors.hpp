// Test vectors: inputs that the ports can carry, with the results of a golden model.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "glint/effect.hpp"
#include "glint/golden.hpp"

namespace glint {

/// A small, portable source of random numbers (the distributions of <random> differ between libraries).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// 64 random bits (SplitMix64: Steele, Lea, Flood 2014).
    std::uint64_t next();
    /// Uniform in low..high, both included; low <= high. The bias is below 2^-32 of the range.
    std::int64_t between(std::int64_t low, std::int64_t high);

private:
    std::uint64_t state_;
};

struct LegalInput {
    int n = 0;
    std::int32_t cos_code = 0;
};

/// A random legal input: n uniform in 1..1023; the cosine in one half of all cases uniform in [0, 1], in the other half
/// uniform where the highlight is, within 12 / n of 1, which a uniform choice hardly ever meets when n is large.
LegalInput random_legal_input(const Profile& profile, Random& random);

struct TestVector {
    int n = 0;
    std::int32_t cos_code = 0;
    PortResult expected;
};

/// The corners that every vector set starts with: n at 0, 1, 2, 8, 50, 1000 and 1023, each with the ends of the port,
/// of the legal range and one beyond, 1/2, the neighbours of 0 and 1, and the codes on both sides of the sign changes
/// of f_bps near s = 0.008 and 0.126.
std::vector<TestVector> corner_vectors(const GoldenModel& model);

/// The corners, then random inputs up to `count` in all: seven in eight legal, one in eight anything that the ports can
/// carry. The same seed gives the same vectors everywhere. Legal: count >= number of corners. Throws Error.
std::vector<TestVector> make_vectors(const GoldenModel& model, std::size_t count, std::uint64_t seed);

/// The codes at which an input port could go wrong, as far as it can carry them: 0, 1 ulp, small, 1/2, 1 - 1 ulp, 1,
/// the ends of what is legal and of what the port carries, and one beyond.
std::vector<std::int64_t> corner_codes(const EffectPort& port);

/// A random legal code: one half uniform, one quarter near 0, one quarter near the top, at every distance alike.
std::int64_t random_legal_code(const EffectPort& port, Random& random);

struct EffectVector {
    std::vector<std::int64_t> in;  ///< a code per input port
    EffectResult expected;
};

/// The hard cases of an effect, then every corner code of every input port with random legal codes at the others.
/// `model` is of `effect`.
std::vector<EffectVector> corner_vectors(const Effect& effect, const EffectModel& model, std::uint64_t seed);

/// The corners, then random inputs up to `count` in all: seven codes in eight legal, one in eight anything that the
/// port can carry. The same seed gives the same vectors everywhere. Legal: count >= number of corners. Throws Error.
std::vector<EffectVector> make_vectors(const Effect& effect, const EffectModel& model, std::size_t count,
                                       std::uint64_t seed);

enum class VectorFormat { tv, csv, hex };

/// "tv", "csv" or "hex". Throws Error.
VectorFormat parse_vector_format(std::string_view text);

/// The text of a vector file (docs/contract.md, section "File formats").
std::string format_vectors(const std::vector<TestVector>& vectors, VectorFormat format);
std::string format_vectors(const EffectModel& model, const std::vector<EffectVector>& vectors, VectorFormat format);

}  // namespace glint
