#include "glint/word_lengths.hpp"

#include <algorithm>
#include <set>

#include "catch.hpp"
#include "glint/error.hpp"
#include "glint/sweep.hpp"

using namespace glint;
using Points = std::vector<std::vector<int>>;

namespace {

double rounding(const Lobe& lobe, const Profile& profile) {
    return sweep(*lobe.golden(profile), {1, max_n, 1}, {0, profile.one(), 1}).total.rounding.value;
}

}  // namespace

TEST_CASE("word lengths: the least points of a staircase") {
    CHECK(minimal_points({0, 0}, {9, 9}, [](const auto& p) { return p[0] + p[1] >= 3; }) ==
          Points{{0, 3}, {1, 2}, {2, 1}, {3, 0}});
    CHECK(minimal_points({0, 0}, {9, 9}, [](const auto& p) { return p[0] >= 4 && p[1] >= 6; }) == Points{{4, 6}});
    CHECK(minimal_points({2}, {9}, [](const auto& p) { return p[0] >= 5; }) == Points{{5}});
    CHECK(minimal_points({2}, {9}, [](const auto&) { return true; }) == Points{{2}});
    CHECK(minimal_points({2, 1}, {3, 3}, [](const auto&) { return false; }).empty());
    CHECK(minimal_points({}, {}, [](const auto&) { return true; }) == Points{{}});
    CHECK(minimal_points({}, {}, [](const auto&) { return false; }).empty());
}

TEST_CASE("word lengths: least points of three coordinates, against all points, each is asked once at most") {
    const auto good = [](const std::vector<int>& p) { return p[0] * p[1] + 2 * p[1] * p[2] + p[0] >= 17; };
    std::set<std::vector<int>> asked;
    int twice = 0;
    const Points found = minimal_points({0, 1, 0}, {5, 4, 5}, [&](const std::vector<int>& p) {
        if (!asked.insert(p).second) ++twice;
        return good(p);
    });
    Points all;
    for (int x = 0; x <= 5; ++x) {
        for (int y = 1; y <= 4; ++y) {
            for (int z = 0; z <= 5; ++z) {
                const bool least = good({x, y, z}) && !(x > 0 && good({x - 1, y, z})) &&
                                   !(y > 1 && good({x, y - 1, z})) && !(z > 0 && good({x, y, z - 1}));
                if (least) all.push_back({x, y, z});
            }
        }
    }
    REQUIRE(all.size() > 5);
    CHECK(found == all);
    CHECK(twice == 0);
    CHECK(asked.size() < 6 * 4 * 6 / 2);
}

TEST_CASE("word lengths: guard bits of lobes at F = 10, O = 5") {
    for (const std::string_view name : {"bps", "cayley", "blinn_phong", "schlick", "taylor"}) {
        const Lobe& lobe = find_lobe(name);
        const GuardSearch search = find_guard_bits(lobe, {.F = 10, .O = 5, .fewer = 2, .more = 1});
        INFO(name);
        REQUIRE_FALSE(search.least.empty());
        CHECK(search.tried > 0);
        for (const Profile& profile : search.least) {
            CHECK(profile.F == 10);
            CHECK(profile.O == 5);
            CHECK(rounding(lobe, profile) < 1.0);
            // A bit less in any word length is not legal, or breaks the promise, or is outside of what was searched.
            const std::vector<int> own = lobe.numbers(10, 5);
            for (std::size_t i = 1; i + 1 < own.size(); ++i) {
                std::vector<int> fewer = profile.custom;
                if (--fewer[i] < own[i] - 2) continue;
                std::string text;
                for (const int number : fewer) {
                    text += text.empty() ? "" : ",";
                    text += std::to_string(number);
                }
                double worst = 1.0;
                try {
                    worst = rounding(lobe, parse_profile(text));
                } catch (const Error&) {
                }
                INFO(text);
                CHECK(worst >= 1.0);
            }
        }
    }
    CHECK_THROWS_AS(find_guard_bits(find_lobe("bps"), {.F = 7, .O = 5}), Error);
    CHECK_THROWS_AS(find_guard_bits(find_lobe("bps"), {.F = 10, .O = 29}), Error);
}
