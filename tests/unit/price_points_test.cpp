#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "cost/fpga/points.hpp"
#include "glint/error.hpp"
#include "io/process.hpp"

// The file of prices, field by field.
using namespace glint;
using namespace glint::fpga;

namespace {

/// Three seeds, the one in the middle first, and a critical path with each.
Point routed() {
    Point out;
    out.lobe = "bps";
    out.profile = "p12";
    out.architecture = "restoring";
    out.device = "hx8k";
    out.resources = {100, 20, 3, 0, 1};
    out.cells = 130;
    out.routed = out.fits = true;
    out.clocks_mhz = {80.0, 90.126, 70.0};
    out.paths = {{"a_q", "b_q", 3.004, 4.996}, {"c_q", "d_q", 1.0, 1.0}, {"e_q", "f_q", 2.0, 2.0}};
    out.latency = 20;
    out.interval = 2;
    out.hash = "0123";
    return out;
}

nlohmann::json written(const Point& point, PriceFile file) {
    return nlohmann::json::parse(merged({}, file, {}, {point}))["points"][0];
}

}  // namespace

TEST_CASE("points: each field of a file") {
    CHECK(written(routed(), PriceFile::lobes) == nlohmann::json::parse(R"(
        {"lobe": "bps", "profile": "p12", "architecture": "restoring", "device": "hx8k", "dsp": false, "luts": 100,
         "registers": 20, "carries": 3, "dsps": 0, "brams": 1, "fits": true, "cells": 130, "clock_mhz": 80.0,
         "clock_mhz_seeds": [80.0, 90.13, 70.0],
         "path": {"from": "a_q", "to": "b_q", "logic_ns": 3.0, "routing_ns": 5.0},
         "latency": 20, "interval": 2, "hash": "0123"})"));
    // Too large for its device, in a file of shells.
    Point large = routed();
    large.fits = false;
    large.why = "too few LUTs";
    large.clocks_mhz.clear();
    large.paths.clear();
    large.effect = "shade";
    large.mask = 3;
    large.unit = "lanes";
    large.lanes = 4;
    large.harness_limits = true;
    CHECK(written(large, PriceFile::shells) == nlohmann::json::parse(R"(
        {"effect": "shade", "mask": 3, "lobe": "bps", "profile": "p12", "architecture": "restoring", "unit": "lanes",
         "lanes": 4, "device": "hx8k", "dsp": false, "luts": 100, "registers": 20, "carries": 3, "dsps": 0, "brams": 1,
         "fits": false, "why": "too few LUTs", "harness_limits": true, "clock_mhz": null, "clock_mhz_seeds": [],
         "latency": 20, "interval": 2, "hash": "0123"})"));
    // On a device without a router.
    Point synthesized = routed();
    synthesized.routed = synthesized.fits = false;
    synthesized.clocks_mhz.clear();
    synthesized.paths.clear();
    const nlohmann::json json = written(synthesized, PriceFile::lobes);
    for (const char* key : {"fits", "why", "cells", "lanes", "unit", "mask", "path", "unrouted_seeds"}) {
        CAPTURE(key);
        CHECK_FALSE(json.contains(key));
    }
    CHECK(json["luts"] == 100);
}

TEST_CASE("points: of a file their names alone, and what they are called") {
    const io::TemporaryFolder folder;
    const auto file = folder.path() / "points.json";
    const auto named = [&](const Point& point, PriceFile format) {
        std::ofstream(file) << merged({}, format, {}, {point});
        return named_points(file).at(0);
    };
    Point lobe = routed();
    lobe = named(lobe, PriceFile::lobes);
    CHECK((lobe.hash == "0123" && lobe.lanes == 1 && lobe.unit.empty() && lobe.resources.luts == 0));
    CHECK(name_of(lobe) == "bps p12 restoring hx8k");
    Point shade = routed();
    shade.effect = "shade";
    shade.mask = 10;
    shade.architecture.clear();
    shade.device = "ecp5-25k";
    CHECK(name_of(named(shade, PriceFile::effects)) == "shade 10 bps p12 ecp5-25k no DSPs");
    shade.dsp = true;
    CHECK(name_of(named(shade, PriceFile::effects)) == "shade 10 bps p12 ecp5-25k");
    Point lanes = routed();
    lanes.unit = "lanes";
    lanes.lanes = 4;
    CHECK(name_of(named(lanes, PriceFile::shells)) == "- - bps p12 restoring 4 lanes hx8k");
    lanes.unit = "axis";
    lanes.lanes = 1;
    CHECK(name_of(named(lanes, PriceFile::shells)) == "- - bps p12 restoring axis hx8k");
    std::ofstream(file) << R"({"format": "glint-cost-cpu-1", "points": []})";
    CHECK_THROWS_AS(named_points(file), Error);
}

TEST_CASE("points: what the lines under the table say") {
    Point large = routed();
    large.fits = false;
    large.clocks_mhz.clear();
    large.why = "too few LUTs";
    const auto says = [](const Point& point, const std::string& line) {
        return points_table({point}, PriceFile::lobes).find(line + "\n") != std::string::npos;
    };
    CHECK(says(large, "bps p12 restoring hx8k does not fit: too few LUTs"));
    CHECK(says(routed(), "bps p12 restoring hx8k: a_q to b_q: 3.0 ns of logic, 5.0 of wires"));
    CHECK_FALSE(says(routed(), "bps p12 restoring hx8k*: the critical path is in the harness"));
    Point limited = routed();
    limited.harness_limits = true;
    CHECK(says(limited, "bps p12 restoring hx8k*: the critical path is in the harness"));
}
