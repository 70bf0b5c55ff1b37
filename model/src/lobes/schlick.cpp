// The lobe `schlick`: docs/lobes/schlick.md.

#include "lobe.hpp"

namespace glint {
namespace {

struct SchlickFormat {
    static constexpr std::string_view lobe = "schlick";
    int F = 0;  ///< fraction bits of the cosine
    int O = 0;  ///< fraction bits of the output

    struct Steps {
        std::int64_t D = 0, quotient = 0, y = 0;
    };

    // C <= D and D >= 2^F, so quotient is 0 .. 2^(O+1); C 2^(O+1) <= 2^59.
    Steps steps(int n, std::int64_t C) const {
        Steps x;
        const std::int64_t one = std::int64_t{1} << F;
        x.D = n * one - (n - 1) * C;
        x.quotient = (C << (O + 1)) / x.D;
        x.y = rnd(x.quotient, 1);
        return x;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        return {{"C", C, F}, {"D", x.D, F}, {"quotient", x.quotient, O + 1}, {"y", x.y, O}};
    }

    double real(double c, double n) const { return reference::schlick(c, n); }
};

std::vector<int> schlick_numbers(int F, int O) { return {F, O}; }

SchlickFormat schlick_format(const Profile& profile) {
    if (!profile.shipped()) check_custom(profile, "schlick", "F,O");
    return {profile.F, profile.O};
}

std::vector<GeneratedFile> emit_schlick(const Profile& profile, const Architecture& architecture) {
    const SchlickFormat f = schlick_format(profile);
    auto files =
        generated_sources("schlick", profile, architecture, {{block::ports(), block::ratio(f.O + 1), block::step()}},
                          {{"F", std::to_string(f.F), ""}, {"O", std::to_string(f.O), ""}},
                          {{"int F", std::to_string(f.F), "fraction bits of the cosine"},
                           {"int O", std::to_string(f.O), "fraction bits of the output"}});
    files.push_back(gappa_script("schlick", profile, fmt::format("F, O: {}, {}", f.F, f.O),
                                 fmt::format(R"(
# A name here has the meaning of docs/lobes/schlick.md, but stands for the value, not the code. Gappa checks each equation as
# algebra, for D other than 0, and warns of that; where it divides by D, D <> 0 is asked for, and proven.
#@-Wno-null-denominator

@rnd_O = fixed<-{O}, nu>;

D = n - (n - 1) * C;
s = C / D;
# The contract's floor at one bit more and its rnd by that bit are together one rounding to the nearest, halves up:
# floor((floor(2 x) + 1) / 2) = floor(x + 1/2).
y = rnd_O(s);
error = (y - s) * 1b{O};

{{ C in [0, 1] /\ n in [1, 1023] ->
  D in [1, 1023] /\ s in [0, 1] /\ y in [0, 1] /\
  D in ? /\ s in ? /\ y in ? /\ error in ? }}

D -> 1 + (n - 1) * (1 - C);
s -> 1 - n * (1 - C) / D {{ D <> 0 }};
)",
                                             fmt::arg("O", f.O))));
    return files;
}

}  // namespace

Lobe schlick_lobe() {
    return {"schlick",
            "c / (n - n c + c)",
            "F,O",
            reference::schlick,
            make_plain<schlick_format>,
            emit_schlick,
            common_hard_cases,
            schlick_numbers,
            {},
            true};
}

}  // namespace glint
