// Word lengths: the shipped profiles and custom ones.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// The largest specular exponent: the port has 10 bits.
inline constexpr int max_n = 1023;

/// A profile names the fraction bits of the cosine (F) and of the output (O) for all lobes. Guard bits belong to each
/// lobe: a lobe knows its own for the shipped profiles; a custom profile lists them in the lobe's own order.
struct Profile {
    std::string name;  ///< "p12", or the numbers of a custom profile joined by '_': part of file and module names
    int F = 0;         ///< fraction bits of the cosine
    int O = 0;         ///< fraction bits of the output
    std::vector<int> custom;  ///< empty for a shipped profile; else all numbers as given, e.g. F,S,K,O for `bps`
    std::string options{};    ///< of the lobe, as given after its name; `name` then ends with a mark made of them

    bool shipped() const { return custom.empty(); }
    /// As on the command line: "p12", or the numbers joined by ','.
    std::string argument() const;
    /// The cosine code of 1.0: 2^F.
    int one() const { return 1 << F; }
};

/// p8 (F=16, O=8), p12 (18, 12), p16 (20, 16).
std::span<const Profile> shipped_profiles();

/// "p8", "p12", "p16", or comma separated integers, the first of them F and the last O, with 8 <= F <= 30 and
/// 4 <= O <= 28. What the numbers between mean is the lobe's to say and to check. Throws Error.
Profile parse_profile(std::string_view text);

/// The profile for a lobe with options; itself when they are empty.
Profile with_options(Profile profile, std::string_view options);

}  // namespace glint
