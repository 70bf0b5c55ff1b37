#include "studies/forms.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "glint/lobes.hpp"

using namespace glint;
using namespace glint::studies;

namespace {

Operations count(std::string_view lobe) {
    for (const Form& form : forms()) {
        if (form.lobe == lobe) return form.count();
    }
    FAIL("no form " << lobe);
    return {};
}

const Lobe* registered(std::string_view name) {
    for (const Lobe& lobe : lobes()) {
        if (lobe.name == name) return &lobe;
    }
    return nullptr;
}

}  // namespace

TEST_CASE("operations: what the paper's Table 1 counts, counted from the code") {
    CHECK(count("schlick") == Operations{1, 1, 2, 0, 0});
    CHECK(count("bps") == Operations{4, 1, 4, 1, 1});
    CHECK(count("quadratic") == Operations{4, 0, 2, 0, 1});
    // The paper has no comparison for f_8, but says that the cut to 0 is counted.
    CHECK(count("cosine_power") == Operations{4, 1, 0, 2, 1});
    // The paper has a division, and again no comparison.
    CHECK(count("cubic") == Operations{5, 0, 2, 0, 1});
    // Beyond the paper, and a library's function.
    CHECK(count("cayley") == Operations{6, 1, 2, 2, 1});
    CHECK(count("polynomial") == Operations{5, 1, 3, 2, 1});
    CHECK(count("gauss") == Operations{3, 0, 0, 0, 0, 2});
    CHECK(count("spherical_gaussian") == Operations{1, 0, 1, 1, 0, 1});
}

TEST_CASE("operations: cycles are the sum of latencies") {
    CHECK(Operations{1, 1, 1, 1, 1, 1}.cycles({1, 10, 100, 1000, 10000}) == 11111);
    CHECK(Operations{4, 1, 4, 1, 1}.cycles(zen4_double) == 12 + 13 + 12 + 3 + 1);
}

TEST_CASE("forms: what is counted is the lobe") {
    std::size_t compared = 0;
    std::size_t of_the_paper = 0;
    for (const Form& form : forms()) {
        const Lobe* lobe = registered(form.lobe);
        if (lobe == nullptr) continue;
        for (const int n : {1, 2, 7, 8, 9, 50, 999}) {
            if (n < form.least_n) continue;
            for (int i = 0; i <= 200; ++i) {
                const double c = 1.0 - i * i / 40000.0;
                if (std::abs(form.value(c, n) - lobe->reference(c, n)) > 1e-9)
                    FAIL(form.lobe << " n " << n << " c " << c << ": " << form.value(c, n) << " is not "
                                   << lobe->reference(c, n));
                ++compared;
            }
        }
        for (const std::string_view name : {"schlick", "cosine_power", "quadratic", "cubic", "bps"}) {
            of_the_paper += form.lobe == name ? 1 : 0;
        }
    }
    CHECK(of_the_paper == 6);
    CHECK(compared >= 6 * 7 * 201);
}
