#include "glint/profile.hpp"

#include <algorithm>
#include <string>

#include "catch.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "glint/range.hpp"

using namespace glint;

TEST_CASE("shipped and custom profiles") {
    const Profile p12 = parse_profile("p12");
    CHECK(p12.F == 18);
    CHECK(p12.O == 12);
    CHECK(p12.shipped());
    CHECK(p12.argument() == "p12");
    const Profile custom = parse_profile("18,14,15,12");
    CHECK(custom.name == "18_14_15_12");
    CHECK(custom.argument() == "18,14,15,12");
    CHECK(custom.F == 18);
    CHECK(custom.O == 12);
    const auto trace = find_lobe("bps").golden(custom)->trace(1, 0);
    CHECK(trace[2].fraction_bits == 14);  // quotient
    CHECK(trace[3].fraction_bits == 15);  // h1
}

TEST_CASE("illegal profiles are refused with the legal ones named") {
    for (const char* text : {"", "p9", "P8", "18", "18,", ",18", "18,x,14,12", "7,4,4,4", "31,30,30,28", "18,12,12,3",
                             "30,30,30,29", "-8,8,8,8", "8,8,8,8888888888888"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_profile(text), Error);
    }
    for (const char* text :
         {"18,12", "18,14,12", "18,14,14,14,12", "18,11,14,12", "18,14,11,12", "18,31,14,12", "18,14,31,12"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(find_lobe("bps").golden(parse_profile(text)), Error);
    }
}

TEST_CASE("an unknown lobe is refused with the list of the known ones") {
    CHECK(find_lobe("bps").name == "bps");
    try {
        find_lobe("phong");
        FAIL("not refused");
    } catch (const Error& error) {
        CHECK(std::string(error.what()).find("bps") != std::string::npos);
    }
}

TEST_CASE("ranges") {
    CHECK(parse_range("all", "--n", 1, 1023).size() == 1023);
    CHECK(parse_range("7", "--n", 1, 1023).size() == 1);
    const Range stepped = parse_range("1:10:4", "--n", 1, 1023);
    CHECK(stepped.size() == 3);
    CHECK(stepped[2] == 9);
    for (const char* text : {"", "0", "1024", "5:4", "1:10:0", "1:10:-1", "1:2:3:4", "a", "1:", ":1", "1.5"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_range(text, "--n", 1, 1023), Error);
    }
}

TEST_CASE("profile: the numbers of a shipped profile give a custom one with the same integers") {
    for (const Lobe& lobe : lobes()) {
        REQUIRE(lobe.numbers != nullptr);
        for (const Profile& shipped : shipped_profiles()) {
            const std::vector<int> numbers = lobe.numbers(shipped.F, shipped.O);
            REQUIRE(numbers.size() ==
                    static_cast<std::size_t>(std::count(lobe.custom.begin(), lobe.custom.end(), ',')) + 1);
            std::string text;
            for (const int number : numbers) {
                text += text.empty() ? "" : ",";
                text += std::to_string(number);
            }
            const auto custom = lobe.golden(parse_profile(text));
            const auto golden = lobe.golden(shipped);
            int differing = 0;
            for (int n = 1; n <= max_n; n += 7) {
                for (int i = 1; i < 40; ++i) {
                    // Near 1, where the results are, and down to 0.
                    const int code = shipped.one() - (shipped.one() >> (i / 2)) * (1 + i % 2) / 2;
                    if (custom->eval(n, code) != golden->eval(n, code)) ++differing;
                }
            }
            INFO(lobe.name << " " << text);
            CHECK(differing == 0);
        }
    }
}
