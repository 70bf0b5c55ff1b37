#include "glint/hard_cases.hpp"

#include <cmath>
#include <set>

#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/lobes.hpp"

using namespace glint;

TEST_CASE("hard cases: within the lobe's bound of the real function, clamped exactly when illegal, in range") {
    for (const Lobe& lobe : lobes()) {
        for (const Profile& profile : shipped_profiles()) {
            const auto model = lobe.golden(profile);
            std::set<std::string> names;
            for (const HardCase& c : lobe.hard_cases(*model)) {
                CAPTURE(lobe.name, profile.name, c.name);
                const PortResult result = model->eval_port(c.n, c.cos_code);
                // The reference has the same corrections: n below 1 counts as 1, c above 1 as 1, c below 0 gives 0.
                const double real = lobe.reference(std::ldexp(c.cos_code, -profile.F), c.n);
                CHECK(std::abs(std::ldexp(result.y, -profile.O) - real) < std::ldexp(lobe.bound_ulp, -profile.O));
                CHECK(result.clamped == (c.n == 0 || c.cos_code < 0 || c.cos_code > profile.one()));
                CHECK(result.y <= 1U << profile.O);
                CHECK(names.insert(c.name).second);
                CHECK_FALSE(c.risk.empty());
                CHECK_FALSE(c.covered.empty());
            }
            CHECK(names.size() >= 10);
        }
    }
}

TEST_CASE("bps: the cases around the cut to 0 stand where they say") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("bps").golden(profile);
        for (const HardCase& c : find_lobe("bps").hard_cases(*model)) {
            CAPTURE(profile.name, c.name);
            if (c.name == "last result before the cut") {
                CHECK(model->eval(c.n, c.cos_code) > 0);
                CHECK(model->eval(c.n, c.cos_code + 1) == 0);
            } else if (c.name == "first result after the cut") {
                CHECK(model->eval(c.n, c.cos_code) > 0);
                CHECK(model->eval(c.n, c.cos_code - 1) == 0);
            } else if (c.name == "deepest below 0") {
                CHECK(model->eval(c.n, c.cos_code) == 0);
            } else if (c.name == "largest h2") {
                for (const Intermediate& value : model->trace(c.n, c.cos_code)) {
                    if (value.name == "h2") CHECK(value.code > std::int64_t{1} << value.fraction_bits);
                }
            }
        }
    }
}

TEST_CASE("every lobe stands in the registry once") {
    std::set<std::string_view> names;
    for (const Lobe& lobe : lobes()) {
        CAPTURE(lobe.name);
        CHECK(names.insert(lobe.name).second);
        CHECK(&find_lobe(lobe.name) == &lobe);
    }
    CHECK(names.size() >= 11);
}

TEST_CASE("hard cases: every effect has a table, a row for each of its cases") {
    for (const Effect& effect : effects()) {
        CAPTURE(effect.name);
        const HardCaseTable table = effect_case_table(effect);
        const auto model = effect.golden(parse_profile("p12"), "bps");
        const auto cases = effect.hard_cases(*model);
        REQUIRE(table.rows.size() == cases.size());
        bool clamped = false;
        for (std::size_t i = 0; i < cases.size(); ++i) {
            REQUIRE(table.rows[i].size() == table.columns.size());
            CHECK(table.rows[i][0] == cases[i].name);
            const std::string& last = table.rows[i].back();
            const EffectResult result = model->eval_port(cases[i].in);
            CHECK(last.find(" -> " + std::to_string(result.values[0])) != std::string::npos);
            CHECK((last.find(" clamped") != std::string::npos) == result.clamped);
            clamped |= result.clamped;
        }
        CHECK(clamped);
    }
}
