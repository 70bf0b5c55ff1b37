// The ends of what is legal: the last legal value is taken, the next is refused by its name. And the bounds that the
// documents state for the effects. Planted faults (tests/mutants/cpp_faults.py) showed that no test said so.

#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"

using namespace glint;

TEST_CASE("word lengths of lobes: the last legal one, and what the first illegal one is told") {
    struct Case {
        const char *lobe, *legal, *illegal, *message;
    };
    for (const Case& c : {
             Case{"decay", "9,1,2,2,1,0,3,0,4", "8,1,2,2,1,0,3,0,4", "F = 8 is not legal for decay: 9 to 30"},
             Case{"decay", "9,1,2,2,1,0,3,0,9", "9,1,2,2,1,0,3,0,10", "O = 10 is not legal for decay: 4 to 9"},
             Case{"gauss", "18,6,19,6,16,12", "18,6,18,6,16,12", "L = 18 is not legal for gauss: 19 to 38"},
             Case{"gauss", "16,10,21,6,16,12", "16,10,20,6,16,12", "L = 20 is not legal for gauss: 21 to 38"},
             Case{"cosine_power", "8,2,9,9", "8,2,10,10", "O = 10 is not legal for cosine_power: 4 to 9"},
             Case{"quadratic", "30,22,22,22", "30,23,23,23", "O = 23 is not legal for quadratic: 4 to 22"},
         }) {
        CAPTURE(c.lobe, c.legal, c.illegal);
        CHECK_NOTHROW(find_lobe(c.lobe).golden(parse_profile(c.legal)));
        CHECK_THROWS_WITH(find_lobe(c.lobe).golden(parse_profile(c.illegal)), c.message);
    }
}

TEST_CASE("a custom profile of a lobe has the numbers of that lobe") {
    CHECK_THROWS_AS(find_lobe("decay").golden(parse_profile("18,12")), Error);
    CHECK_THROWS_AS(find_effect("bps_vectors").golden(parse_profile("18,12"), "bps"), Error);
    CHECK_THROWS_AS(find_effect("lobe_select").golden(parse_profile("18,12"), "bps"), Error);
}

TEST_CASE("the bounds of effects are those of docs/effects, in ulp") {
    struct Bound {
        const char* effect;
        double ulp;
    };
    for (const Bound& bound : {Bound{"ambient", 0.5}, Bound{"lambert", 0.5}, Bound{"tint", 0.5}, Bound{"cosine", 1.0},
                               Bound{"oren_nayar", 0.75}, Bound{"ward", 1.3}, Bound{"cook_torrance", 1.4},
                               Bound{"cook_torrance_modified", 2.5}, Bound{"phong", 1.0}, Bound{"blinn_phong", 1.0},
                               Bound{"shade", 1.0}, Bound{"pixel", 1.0}, Bound{"lobe_select", 1.0},
                               Bound{"bps_vectors", 1.0}, Bound{"blinn_phong_vectors", 1.0}}) {
        CAPTURE(bound.effect);
        CHECK(find_effect(bound.effect).bound_ulp == bound.ulp);
    }
    CHECK(effects().size() == 15);
}
