// The constants of `bps` on their way to rtl/, hls/ and proofs/.

#include "glint/bps.hpp"
#include "lobe.hpp"

namespace glint {

std::vector<GeneratedFile> emit_bps(const Profile& profile, const Architecture& architecture) {
    const BpsFormat f = bps_format(profile);
    // The constants of f_bps are below 4 in magnitude, with 1.0 as 2^K: K + 3 bits with the sign.
    const auto literal = [&](std::int64_t value) { return verilog_literal(value, f.K + 3); };
    const auto text = [](std::int64_t value) { return std::to_string(value); };
    auto files =
        generated_sources("bps", profile, architecture, {{block::ports(), block::ratio(f.S), block::horner(3)}},
                          {{"F", text(f.F), ""},
                           {"S", text(f.S), ""},
                           {"K", text(f.K), ""},
                           {"O", text(f.O), ""},
                           {"A", literal(f.a), ""},
                           {"B", literal(f.b), ""},
                           {"C1", literal(f.c1), ""},
                           {"D0", literal(f.d0), ""}},
                          {{"int F", text(f.F), "fraction bits of the cosine"},
                           {"int S", text(f.S), "fraction bits of the quotient"},
                           {"int K", text(f.K), "fraction bits of the constants below"},
                           {"int O", text(f.O), "fraction bits of the output"},
                           {"std::int64_t a", text(f.a), ""},
                           {"std::int64_t b", text(f.b), ""},
                           {"std::int64_t c1", text(f.c1), ""},
                           {"std::int64_t d0", text(f.d0), ""}});
    files.push_back(
        {GeneratedFile::Target::proof, fmt::format("glint_bps_{}.g", profile.name), bps_gappa_script(profile)});
    return files;
}

}  // namespace glint
