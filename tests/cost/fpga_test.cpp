#include <algorithm>
#include <filesystem>

#include "catch.hpp"
#include "cost/fpga/flow.hpp"
#include "cost/fpga/points.hpp"
#include "cost/fpga/table.hpp"
#include "cost/fpga/units.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "io/command.hpp"
#include "io/process.hpp"

using namespace glint;
using namespace glint;
using namespace glint::io;
using namespace glint::fpga;

namespace {

const std::filesystem::path rtl = std::filesystem::path(GLINT_SOURCE_DIR) / "rtl";

/// What a unit takes of a device, with the harness taken off.
Resources priced(Flow& flow, const Unit& unit, const Device& device, Products products = Products::dsps) {
    std::vector<Source> sources;
    sources.push_back({unit.module + ".v", read_file(rtl / "blocks" / (unit.module + ".v"))});
    sources.push_back({"glint_harness.v", harness(unit)});
    const Resources whole = Flow::Netlist(flow, sources, device, products).resources();
    const Resources alone =
        Flow::Netlist(flow, {{"glint_harness.v", harness_alone(unit)}}, device, products).resources();
    return {whole.luts - alone.luts, whole.registers - alone.registers, whole.carries - alone.carries,
            whole.dsps - alone.dsps, whole.brams - alone.brams};
}

Unit delay(int width, int stages) {
    return {"glint_delay",
            ".WIDTH(" + std::to_string(width) + "), .STAGES(" + std::to_string(stages) + ")",
            {{"enable_i"}, {"data_i", width}},
            {{"data_o", width}}};
}

std::vector<Exchange> exchanges(const GoldenModel& model, const std::vector<std::pair<int, std::int64_t>>& inputs) {
    std::vector<Exchange> out;
    for (const auto& [n, cosine] : inputs) {
        const PortResult result = model.eval_port(n, cosine);
        out.push_back({{n, cosine}, {result.y, result.clamped ? 1 : 0}});
    }
    return out;
}

Point point(const std::string& lobe, int luts) {
    Point out;
    out.lobe = lobe;
    out.profile = "p12";
    out.architecture = "restoring";
    out.device = "hx8k";
    out.resources.luts = luts;
    out.routed = out.fits = true;
    out.clocks_mhz = {70.0, 90.0, 80.0};
    out.latency = 20;
    out.interval = 2;
    return out;
}

}  // namespace

TEST_CASE("harness: a unit of 37 registers costs 37 registers, and nothing else, on every family") {
    const TemporaryFolder folder;
    Flow flow(folder.path());
    for (const Device& device : devices()) {
        CAPTURE(device.name);
        if (device.family->yosys != "yosys" && !flow.missing(device).empty()) {
            WARN(flow.missing(device));
            continue;
        }
        const Resources one = priced(flow, delay(37, 1), device);
        CHECK(one.registers == 37);
        CHECK(one.luts == 0);
        CHECK(one.carries == 0);
        CHECK(one.dsps == 0);
        CHECK(one.brams == 0);
    }
    // More outputs than inputs would make wires of the lone harness equal, and registers behind them one.
    const Resources two = priced(flow, delay(37, 2), find_device("hx8k"));
    CHECK(two.registers == 74);
    CHECK(two.luts == 0);
}

TEST_CASE("harness: the critical path of a unit with logic is the unit's, that of the harness alone is not") {
    const TemporaryFolder folder;
    Flow flow(folder.path());
    const Unit unit{"glint_square", ".S(12), .R(12)", {{"enable_i"}, {"x_i", 13}}, {{"y_o", 13}}};
    const Device& device = find_device("hx8k");
    const std::vector<Source> sources{{"glint_multiplier.v", read_file(rtl / "blocks/glint_multiplier.v")},
                                      {"glint_square.v", read_file(rtl / "blocks/glint_square.v")},
                                      {"glint_harness.v", harness(unit)}};
    const Routing whole = Flow::Netlist(flow, sources, device, Products::gates).route(1);
    CHECK(whole.fits);
    CHECK_FALSE(whole.harness_limits);
    const Routing alone =
        Flow::Netlist(flow, {{"glint_harness.v", harness_alone(unit)}}, device, Products::gates).route(1);
    CHECK(alone.fits);
    CHECK(alone.harness_limits);
    CHECK(alone.clock_mhz > whole.clock_mhz);
    CHECK(alone.cells < whole.cells);
}

TEST_CASE("a unit larger than its device does not fit, and it says what is too little") {
    const TemporaryFolder folder;
    Flow flow(folder.path());
    const Unit unit = delay(300, 18);
    const std::vector<Source> sources{{"glint_delay.v", read_file(rtl / "blocks/glint_delay.v")},
                                      {"glint_harness.v", harness(unit)}};
    const Routing found = Flow::Netlist(flow, sources, find_device("up5k"), Products::gates).route(1);
    CHECK_FALSE(found.fits);
    CHECK(found.why.find("of 5280 ICESTORM_LC") != std::string::npos);
}

TEST_CASE("DSPs without registers have no clock of their own, and a line says what no clock holds") {
    const TemporaryFolder folder;
    Flow flow(folder.path());
    const Unit unit{"two_products", "", {{"x_i", 48}}, {{"y_o", 32}}};
    const Source source{"two_products.v",
                        R"(module two_products (input wire clk_i, input wire [47:0] x_i, output wire [31:0] y_o);
    wire [15:0] a = x_i[15:0] ^ x_i[31:16];
    wire [15:0] b = x_i[31:16] ^ x_i[47:32];
    wire [31:0] first  = a * b;
    wire [31:0] second = first[15:0] * b;
    assign y_o = second ^ {x_i[15:0], x_i[47:32]};
endmodule
)"};
    Flow::Netlist netlist(flow, {source, {"glint_harness.v", harness(unit)}}, find_device("up5k"), Products::dsps);
    CHECK(netlist.resources().dsps == 2);
    const Routing found = netlist.route(1);
    CHECK(found.routed);
    CHECK(found.clock_mhz > 0.0);
    const std::string notes = dsp_clock_notes({"hx8k", "up5k", "ecp5-25k", "lifcl-40", "xc7", "another"});
    CHECK(notes == "up5k: nextpnr-ice40 counts no time inside a DSP: the clocks of units with DSPs are upper bounds\n");
}

TEST_CASE("latency and interval come from a simulation whose results are right") {
    const TemporaryFolder folder;
    Flow flow(folder.path());
    const Lobe& lobe = find_lobe("schlick");
    const Profile profile = parse_profile("p8");
    const auto model = lobe.golden(profile);
    const std::vector<Source> sources = read_sources(rtl, design_of(lobe.emit(profile, default_architecture(lobe))));
    const Unit unit = lobe_unit("glint_schlick_p8", profile, 1);
    std::vector<Exchange> burst = exchanges(*model, {{50, 64225}, {0, 5}, {7, -3}, {1023, profile.one()}});
    const Clocks clocks = flow.count_clocks(sources, unit, burst);
    CHECK(clocks.latency > 3);
    CHECK(clocks.interval == 1);
    burst[2].out.back() = 0;
    CHECK_THROWS_WITH(flow.count_clocks(sources, unit, burst), "glint_schlick_p8 has a wrong result: n_i 7, cos_i -3");
}

TEST_CASE("the files of a unit are those of its description") {
    const Lobe& lobe = find_lobe("bps");
    const Design design = design_of(lobe.emit(parse_profile("p12"), default_architecture(lobe)));
    std::vector<std::string> names;
    for (const Source& source : read_sources(rtl, design)) names.push_back(source.name);
    CHECK(std::find(names.begin(), names.end(), "glint_bps.v") != names.end());
    CHECK(std::find(names.begin(), names.end(), "glint_divider.v") != names.end());
    CHECK(std::find(names.begin(), names.end(), "glint_axis.v") == names.end());
    CHECK(names.back() == "glint_bps_p12.v");
    const TemporaryFolder empty;
    CHECK_THROWS_AS(read_sources(empty.path(), design), Error);
}

TEST_CASE("a cell without a price is refused") {
    const fpga::Family& ice40 = *find_device("hx8k").family;
    const Resources some = count_resources(ice40, {{"SB_LUT4", 3}, {"SB_DFFESR", 2}, {"SB_DFF", 5}, {"SB_CARRY", 1}});
    CHECK(some.luts == 3);
    CHECK(some.registers == 7);
    CHECK(some.carries == 1);
    CHECK(count_resources(*find_device("ecp5-25k").family, {{"LUT4", 3}, {"CCU2C", 2}, {"$scopeinfo", 9}}).luts == 7);
    CHECK(count_resources(*find_device("lifcl-40").family, {{"MULT18X18", 1}, {"MULT36X36", 1}}).dsps == 5);
    CHECK(count_resources(*find_device("gw2a-18").family, {{"LUT4", 3}, {"ALU", 2}}).luts == 5);
    CHECK_THROWS_AS(count_resources(*find_device("gw2a-18").family, {{"LUT3", 1}}), Error);
    CHECK_THROWS_AS(count_resources(ice40, {{"SB_SPRAM256KA", 1}}), Error);
    CHECK_THROWS_AS(find_device("hx9k"), Error);
}

TEST_CASE("points: the median, and what follows from it") {
    Point some = point("bps", 100);
    CHECK(some.clock_mhz() == Approx(80.0));
    CHECK(some.latency_ns() == Approx(250.0));
    CHECK(some.results_per_second() == Approx(40e6));
    some.clocks_mhz.push_back(60.0);
    CHECK(some.clock_mhz() == Approx(75.0));
}

TEST_CASE("the file of prices: points of the same unit and device are replaced, others stay") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "fpga.json";
    const ToolVersions tools{{"yosys", "1"}};
    write_file(file, merged(file, PriceFile::lobes, tools, {point("bps", 100), point("schlick", 50)}));
    const std::string text = merged(file, PriceFile::lobes, {{"yosys", "1"}, {"iverilog", "2"}}, {point("bps", 90)});
    const auto json = nlohmann::json::parse(text);
    REQUIRE(json["points"].size() == 2);
    CHECK(json["points"][0]["luts"] == 90);
    CHECK(json["points"][0]["clock_mhz"] == 80.0);
    CHECK(json["points"][1]["luts"] == 50);
    CHECK(json["tools"] == nlohmann::json{{"yosys", "1"}, {"iverilog", "2"}});
    CHECK_THROWS_AS(merged(file, PriceFile::lobes, {{"yosys", "3"}}, {}), Error);
    for (const char* bad : {"", "[]", "{\"format\": 1}", R"({"format": "glint-cost-fpga-1"})",
                            R"({"format": "glint-cost-fpga-1", "tools": {}, "points": [1]})"}) {
        CAPTURE(bad);
        write_file(file, bad);
        CHECK_THROWS_AS(merged(file, PriceFile::lobes, tools, {}), Error);
    }
}

TEST_CASE("the file of effects' prices: one of shade a mask, one of a highlight a lobe") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "effects.json";
    const auto effect = [](const std::string& name, std::optional<int> mask, const std::string& lobe, int luts) {
        Point out = point(lobe, luts);
        out.effect = name;
        out.mask = mask;
        out.architecture.clear();
        return out;
    };
    const auto write = [&](const std::vector<Point>& points) {
        write_file(file, merged(file, PriceFile::effects, {{"yosys", "1"}}, points));
        return nlohmann::json::parse(read_file(file))["points"];
    };
    write({effect("shade", 10, "bps", 100), effect("shade", 2, "bps", 50), effect("lambert", {}, "", 10),
           effect("blinn_phong", {}, "cayley", 70)});
    Point family = effect("lambert", {}, "", 9);
    family.architecture = "default:ecp5";
    const auto points = write({effect("shade", 2, "bps", 40), effect("blinn_phong", {}, "bps", 60), family});
    REQUIRE(points.size() == 6);
    CHECK(points[0]["lobe"] == "bps");
    CHECK(points[1]["luts"] == 70);
    CHECK_FALSE(points[2].contains("mask"));
    CHECK_FALSE(points[2].contains("lobe"));
    CHECK_FALSE(points[2].contains("architecture"));
    CHECK(points[3]["architecture"] == "default:ecp5");
    CHECK(points[3]["luts"] == 9);
    CHECK(points[4]["mask"] == 2);
    CHECK(points[4]["luts"] == 40);
    CHECK(points[5]["mask"] == 10);
    CHECK_THROWS_AS(merged(file, PriceFile::lobes, {}, {}), Error);
}

TEST_CASE("units of effects: those they are made of beside them, MASK set, and results as by the mask") {
    Options options;
    options.effect = "shade";
    options.mask = "3,8";
    const std::vector<PricedUnit> units = priced_units(options);
    REQUIRE(units.size() == 2);
    CHECK(units[0].unit.module == "glint_effect_shade_bps_p12");
    CHECK(units[0].unit.parameters == ".TAG_W(1), .MASK(3)");
    REQUIRE(units[1].point.mask);
    CHECK(*units[1].point.mask == 8);
    const auto model = find_effect("shade").golden(parse_profile("p12"), "bps");
    std::size_t different = 0;
    REQUIRE(units[0].burst.size() > 64);
    for (std::size_t i = 0; i < units[0].burst.size(); ++i) {
        std::vector<std::int64_t> in = units[0].burst[i].in;
        in[0] &= 3;
        const EffectResult result = model->eval_port(in);
        CHECK(std::equal(result.values.begin(), result.values.end(), units[0].burst[i].out.begin()));
        CHECK(units[0].burst[i].out.back() == (result.clamped ? 1 : 0));
        different += units[0].burst[i].out != units[1].burst[i].out;
    }
    CHECK(different > 64);
    std::vector<std::string> names;
    for (const Source& source : read_sources(rtl, units[0].design)) names.push_back(source.name);
    for (const char* file : {"glint_effect_lambert_p12.v", "glint_bps_p12.v", "glint_bps.v", "glint_fifo.v"}) {
        CAPTURE(file);
        CHECK(std::count(names.begin(), names.end(), file) == 1);
    }
    CHECK(names.back() == "glint_effect_shade_bps_p12.v");
    options.mask = "256";
    CHECK_THROWS_WITH(priced_units(options), "--mask '256' is not legal: 0 to 255");
}

TEST_CASE("the table is the best of its size, and its model and its memory agree") {
    const TemporaryFolder folder;
    Flow flow(folder.path());
    const Profile profile = parse_profile("p8");
    const TableFormat format = TableFormat::best(profile);
    CHECK(format.n_bits + format.cos_bits == 13);  // 8192 x 8 bits: 16 of 30 block RAMs
    const auto model = table_model(profile, format);
    CHECK(model->eval_port(1, profile.one()).y <= 255);
    const Design unit = table_unit(profile, format);
    const std::vector<Exchange> burst = exchanges(*model, {{1, 0},
                                                           {1, profile.one()},
                                                           {1023, profile.one()},
                                                           {1023, 60000},
                                                           {5, 33333},
                                                           {0, 44444},
                                                           {700, -1},
                                                           {2, profile.one() + 1}});
    const Clocks clocks = flow.count_clocks(read_sources(rtl, unit), lobe_unit("glint_table_p8", profile, 1), burst);
    CHECK(clocks.latency == 3);
    CHECK(clocks.interval == 1);
}

TEST_CASE("A program that does not end is stopped after its processor time, one that ends is not") {
    const TemporaryFolder folder;
    const std::filesystem::path shell = find_on_path("sh").value();
    const std::filesystem::path log = folder.path() / "log";
    CHECK(run_program(shell, {"-c", "while :; do :; done"}, folder.path(), log, 1) == out_of_time);
    CHECK(run_program(shell, {"-c", "exit 3"}, folder.path(), log, 1) == 3);
}

TEST_CASE("A seed that is not routed is named in the file and counts in no median") {
    Point point;
    point.lobe = "bps";
    point.profile = "p8";
    point.architecture = "restoring";
    point.device = "hx8k";
    point.routed = point.fits = true;
    point.clocks_mhz = {80.0, 90.0};
    point.unrouted_seeds = {3};
    point.latency = point.interval = 1;
    CHECK(point.clock_mhz() == 85.0);
    const std::string file = merged({}, PriceFile::lobes, {}, {point});
    CHECK(file.find("\"unrouted_seeds\":[3]") != std::string::npos);
    CHECK(points_table({point}, PriceFile::lobes).find("seed 3 is not routed") != std::string::npos);
}
