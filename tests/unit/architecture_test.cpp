#include <algorithm>

#include <fmt/format.h>

#include "catch.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"

using namespace glint;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

TEST_CASE("an architecture is a divider, rows in a clock, clocks of a product, the name leaves out the defaults") {
    const Lobe& bps = find_lobe("bps");
    const auto parameters = [](int divider, int rows, int stages) {
        return std::vector<std::pair<std::string, int>>{
            {"DIVIDER", divider}, {"REGISTER_EVERY", rows}, {"MULTIPLIER_STAGES", stages}};
    };
    CHECK(default_architecture(bps) == Architecture{"restoring", parameters(0, 1, 1)});
    CHECK(parse_architecture(bps, "restoring:r1:m1") == default_architecture(bps));
    CHECK(parse_architecture(bps, "radix4:r32:m4") == Architecture{"radix4:r32:m4", parameters(1, 32, 4)});
    CHECK(parse_architecture(bps, "restoring:m3") == Architecture{"restoring:m3", parameters(0, 1, 3)});
    CHECK(parse_architecture(bps, "iterative:m2") == Architecture{"iterative:m2", parameters(2, 1, 2)});
    CHECK(parse_architecture(bps, "reciprocal") == Architecture{"reciprocal", parameters(3, 1, 1)});

    CHECK(parse_architecture(bps, "radix4:m2:ecp5") == Architecture{"radix4:m2:ecp5", parameters(1, 1, 2), "ecp5"});

    const Lobe& taylor = find_lobe("taylor");
    CHECK(default_architecture(taylor) == Architecture{"pipelined", {{"MULTIPLIER_STAGES", 1}}});
    CHECK(parse_architecture(find_lobe("decay"), "pipelined:deep:m2:ecp5") ==
          Architecture{"pipelined:deep:m2:ecp5", {{"MULTIPLIER_STAGES", 2}, {"DEEP", 1}}, "ecp5"});
    CHECK(parse_architecture(taylor, "pipelined:m2") == Architecture{"pipelined:m2", {{"MULTIPLIER_STAGES", 2}}});
}

TEST_CASE("an architecture that is not legal is refused, with what is") {
    const Lobe& bps = find_lobe("bps");
    for (const char* text : {"",
                             ":",
                             "pipelined",
                             "radix8",
                             "restoring:",
                             "restoring:r",
                             "restoring:r0",
                             "radix4:r33",
                             "restoring:m0",
                             "restoring:m5",
                             "restoring:m2:r2",
                             "restoring:r2:r2",
                             "restoring:r2x",
                             "iterative:r2",
                             "reciprocal:r1",
                             "restoring:ecp5:m2",
                             "restoring:xc7",
                             ":ecp5",
                             "ecp5",
                             "restoring:m-1",
                             "restoring:m99999999999",
                             "Radix4"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_architecture(bps, text), Error);
    }
    for (const char* text : {"", "restoring", "pipelined:r2", "pipelined:m5", "pipelined:", "pipelined:deep"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_architecture(find_lobe("taylor"), text), Error);
    }
    CHECK_THROWS_WITH(parse_architecture(bps, "radix8"),
                      StartsWith("architecture 'radix8' is not legal for bps: restoring[:rN][:mN][:FAMILY], "
                                 "radix4[:rN][:mN][:FAMILY], iterative[:mN][:FAMILY], reciprocal[:mN][:FAMILY], ") &&
                          EndsWith(", N of r 1 to 32, N of m 1 to 4, FAMILY ecp5, up5k or ice40"));
}

TEST_CASE("a unit for a family has its multiplier in the place of that of any device, and a model for simulators") {
    const Lobe& bps = find_lobe("bps");
    for (const Family& family : families()) {
        const std::string folder = fmt::format("blocks/{}/", family.name);
        const auto files =
            bps.emit(parse_profile("p8"), parse_architecture(bps, fmt::format("radix4:{}", family.name)));
        for (const GeneratedFile& file : files) {
            if (!file.unit) continue;
            const auto has = [&](const std::string& name) {
                return std::ranges::count(file.unit->files, name, &HardwareUnit::File::name);
            };
            CHECK(has("blocks/glint_multiplier.v") == 0);
            CHECK(has(folder + "glint_multiplier.v") == 1);
            CHECK(has(folder + "glint_multiplier_block.v") == (family.primitives.empty() ? 0 : 1));
            // The multiplier's block, and on ECP5 the carries of the divider; no memory, which decay alone has.
            REQUIRE(file.unit->simulation.size() == (family.name == "ecp5" ? 2 : family.primitives.size()));
            if (family.primitives.empty()) continue;
            CHECK(file.unit->simulation.front().name ==
                  fmt::format("simulation/{}.v", family.primitives.front().first));
        }
    }
}

TEST_CASE("the lobes with a divider are those whose wrappers have its parameters, all have the multiplier's") {
    for (const Lobe& lobe : lobes()) {
        CAPTURE(lobe.name);
        for (const GeneratedFile& file : lobe.emit(parse_profile("p8"), default_architecture(lobe))) {
            if (!file.unit) continue;
            CHECK((file.text.find("parameter DIVIDER = 0,") != std::string::npos) == lobe.divider);
            CHECK(file.text.find("parameter MULTIPLIER_STAGES = 1") != std::string::npos);
        }
    }
    const Lobe& schlick = find_lobe("schlick");
    for (const GeneratedFile& file : schlick.emit(parse_profile("p8"), parse_architecture(schlick, "radix4:r2:m3"))) {
        if (!file.unit) continue;
        CHECK(file.text.find("--profile p8 --architecture radix4:r2:m3`") != std::string::npos);
        CHECK(file.text.find(
                  "parameter DIVIDER = 1,\n    parameter REGISTER_EVERY = 2,\n    parameter MULTIPLIER_STAGES = 3\n") !=
              std::string::npos);
    }
}
