#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "catch.hpp"
#include "cost/missing.hpp"
#include "cost/prices.hpp"
#include "cost/table.hpp"
#include "glint/lobes.hpp"
#include "io/process.hpp"
#include "refusal.hpp"

// Files of prices small enough to compute every figure by hand.
using namespace glint;
using namespace glint::cost;

namespace {

/// Whether a text holds another.
bool holds(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// The numbers from 1 + more to 1023 + more: an error a value of n.
std::string errors(int more) {
    std::string out;
    for (int n = 1; n <= max_n; ++n) out += fmt::format("{}{}", n == 1 ? "" : ",", n + more);
    return '[' + out + ']';
}

/// 1023 (2^16 + 1) inputs, and 1023 (2^8 + 1) of the shortest cosine that is legal.
std::string accuracy() {
    return R"({"format": "glint-cost-accuracy-1", "points": [
{"lobe": "schlick", "profile": "p8", "F": 16, "O": 8, "inputs": 67044351, "rounding_ulp": 0.75,
 "error_rounded_cosine": )" +
           errors(0) + R"(, "error_exact_cosine": )" + errors(1000) + R"(},
{"lobe": "cubic", "profile": "8,4,4,4", "F": 8, "O": 4, "inputs": 262911, "rounding_ulp": 0.5,
 "error_rounded_cosine": )" +
           errors(0) + R"(, "error_exact_cosine": )" + errors(0) + "}]}";
}

constexpr const char* fpga_prices = R"json({"format": "glint-cost-fpga-1",
"tools": {"yosys": "0.23 (git sha1 7ce5011c24b)", "nextpnr-ice40": "0.4"}, "points": [
{"lobe": "schlick", "profile": "p8", "architecture": "restoring", "device": "hx8k", "dsp": false, "luts": 312,
 "registers": 101, "carries": 45, "dsps": 0, "brams": 2, "clock_mhz": 62.5, "latency": 25, "interval": 5},
{"lobe": "schlick", "profile": "p8", "architecture": "radix4", "device": "hx8k", "dsp": true, "luts": 400,
 "registers": 90, "carries": 0, "dsps": 1, "brams": 2, "clock_mhz": 62.5, "latency": 25, "interval": 5},
{"lobe": "cubic", "profile": "8,4,4,4", "architecture": "default", "device": "up5k", "dsp": false, "luts": 0,
 "registers": 0, "carries": 0, "dsps": 0, "brams": 0, "latency": 1, "interval": 1},
{"lobe": "gauss", "profile": "p12", "architecture": "default", "device": "up5k", "dsp": true, "fits": false}]})json";

constexpr const char* cpu_prices = R"({"format": "glint-cost-cpu-1", "command": "run", "machine":
{"cpu": "a processor", "compiler": "a compiler", "flags": "-O3", "date": "today"}, "points": [
{"lobe": "schlick", "type": "double", "form": "scalar", "formula": "f", "throughput_ns": 2, "throughput_q1_ns": 1.5,
 "throughput_q3_ns": 2.5, "latency_ns": 5, "instructions": 7},
{"lobe": "schlick", "type": "double", "form": "batch", "formula": "f", "throughput_ns": 1, "throughput_q1_ns": 1,
 "throughput_q3_ns": 1},
{"lobe": "schlick", "type": "fixed", "profile": "p8", "form": "scalar", "formula": "f", "throughput_ns": 4,
 "throughput_q1_ns": 3, "throughput_q3_ns": 8}]})";

constexpr const char* hls_prices = R"({"format": "glint-cost-hls-1", "points": [
{"kernel": "schlick", "profile": "p8", "form": "radix4", "ccu2c": 10, "lut4": 100, "ff": 7, "mult18": 3, "dp16kd": 2,
 "clock_mhz": 100, "cycles": 12, "interval": 4}, {"kernel": "effect_phong"}]})";

/// The text with one part of it replaced.
std::string with(std::string text, const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    REQUIRE(at != text.npos);
    return text.replace(at, old.size(), now);
}

/// A folder with all of them, gone at the end.
struct Folder {
    io::TemporaryFolder temporary;
    const std::filesystem::path path = temporary.path();

    Folder() {
        write("accuracy.json", accuracy());
        write("fpga.json", fpga_prices);
        write("cpu.json", cpu_prices);
        write("hls.json", hls_prices);
    }
    std::string operator/(const std::string& file) const { return (path / file).string(); }
    void write(const std::string& file, const std::string& text) const { std::ofstream(path / file) << text; }
};

TableOptions options(const Folder& folder) {
    TableOptions out;
    out.data = folder.path.string();
    out.csv = folder / "out.csv";
    out.json = folder / "out.json";
    return out;
}

}  // namespace

TEST_CASE("price files: every number arrives where it belongs") {
    const Folder folder;
    const Prices data = read_cost_data(folder.path.string());
    CHECK(data.tools == "nextpnr-ice40 0.4, yosys 0.23");
    REQUIRE(data.accuracy.size() == 2);
    const AccuracyRecord& record = data.accuracy[0];
    CHECK((record.lobe == "schlick" && record.profile == "p8" && record.F == 16 && record.O == 8));
    CHECK(record.inputs == 67044351);
    CHECK(record.rounding == 0.75);
    CHECK(data.accuracy[1].F == 8);  // the least legal lengths
    CHECK(data.accuracy[1].O == 4);
    // Errors in units of 2^-(O + 8).
    CHECK(record.error({1, max_n, 1}, Cosine::rounded) == 1023.0 / 65536);
    CHECK(record.error({8, 17, 4}, Cosine::rounded) == 16.0 / 65536);
    CHECK(record.error({8, 8, 1}, Cosine::exact) == 1008.0 / 65536);

    REQUIRE(data.fpga.size() == 4);
    const Configuration& c = data.fpga[0].configuration;
    CHECK((c.lobe == "schlick" && c.profile == "p8" && c.architecture == "restoring" && c.device == "hx8k" && !c.dsp));
    CHECK((c.luts == 312 && c.registers == 101 && c.carries == 45 && c.dsps == 0 && c.brams == 2));
    CHECK((c.clock_mhz == 62.5 && c.latency == 25 && c.interval == 5));
    CHECK_FALSE(data.fpga[2].configuration.clock_mhz.has_value());
    CHECK(data.fpga[2].fits);
    CHECK_FALSE(data.fpga[3].fits);

    REQUIRE(data.cpu.has_value());
    CHECK((data.cpu->cpu == "a processor" && data.cpu->compiler == "a compiler" && data.cpu->command == "run"));
    const CpuPrice* scalar = data.cpu->find("schlick", "double", "scalar");
    REQUIRE(scalar != nullptr);
    CHECK((scalar->throughput == 2.0 && scalar->q1 == 1.5 && scalar->q3 == 2.5));
    CHECK((scalar->latency == 5.0 && scalar->instructions == 7.0));
    CHECK(data.cpu->prices[2].type == "fixed");

    REQUIRE(data.hls.size() == 1);  // a kernel of a lobe
    const Configuration& h = data.hls[0].configuration;
    CHECK((h.lobe == "schlick" && h.profile == "p8" && h.architecture == "hls:radix4" && h.device == "ecp5-25k"));
    CHECK(h.luts == 120);  // a CCU2C is two LUTs
    CHECK((h.carries == 10 && h.registers == 7 && h.dsps == 3 && h.brams == 2));
    CHECK((h.clock_mhz == 100.0 && h.latency == 12 && h.interval == 4));
}

TEST_CASE("price files: what is not legal is refused") {
    const Folder folder;
    const auto refused = [&](const char* file, const std::string& text, const std::string& says) {
        const std::string before = io::read_file(folder.path / file);
        folder.write(file, text);
        CHECK(holds(refusal([&] { read_cost_data(folder.path.string()); }), says));
        folder.write(file, before);
    };
    refused("accuracy.json", R"({"format": "glint-cost-accuracy-1", "points": []})", "holds no points");
    refused("fpga.json", R"({"format": "glint-cost-fpga-1", "tools": {}, "points": []})", "holds no points");
    refused("fpga.json", with(fpga_prices, "62.5", "0"), "above 0, or null");
    refused("hls.json", with(hls_prices, "hls-1", "hls-2"), "glint-cost-hls-1");
    refused("cpu.json", with(cpu_prices, "\"latency_ns\": 5", "\"latency_ns\": 0"), "a number above 0");
    refused("cpu.json", with(cpu_prices, "\"throughput_q1_ns\": 1.5", "\"throughput_q1_ns\": 2.1"), "no more than");
    refused("cpu.json", with(cpu_prices, "\"throughput_q3_ns\": 2.5", "\"throughput_q3_ns\": 1.9"), "no less than");
    refused("cpu.json", with(cpu_prices, "\"double\"", "\"half\""), "double, float or fixed");
    // In hls.json, no number may be less than nothing, or no clock at all.
    refused("hls.json", with(hls_prices, "\"interval\": 4", "\"interval\": 0"), "interval 0 is not legal");
}

TEST_CASE("price files: prices join their errors, and what has none is named") {
    const Folder folder;
    Prices data = read_cost_data(folder.path.string());
    const auto names = [&](const Scope& scope, const std::string& device) {
        std::string out;
        for (const Configuration& c : join(data, scope, device)) out += name_of(c) + "; ";
        return out;
    };
    CHECK(names({}, "hx8k") == "schlick p8 restoring; schlick p8 radix4; ");
    CHECK(names({}, "") == "schlick p8 restoring; schlick p8 radix4; cubic 8,4,4,4 default; ");
    CHECK(names({{1, max_n, 1}, Cosine::rounded, {}, true}, "ecp5-25k") == "schlick p8 hls:radix4; ");
    const Configuration first = join(data, {{8, 8, 1}, Cosine::exact, {}, false}, "hx8k").front();
    CHECK((first.output_bits == 8 && first.rounding == 0.75 && first.error == 1008.0 / 65536));
    data.accuracy.erase(data.accuracy.begin());
    std::vector<std::string> unknown;
    CHECK(join(data, {}, "", &unknown).size() == 1);
    CHECK(unknown == std::vector<std::string>{"schlick p8"});
}

TEST_CASE("price files: what was not measured is named, line by line") {
    const Folder folder;
    const std::vector<std::string> lines = not_measured(folder.path.string());
    const auto has = [&](const std::string& line) { return std::count(lines.begin(), lines.end(), line) == 1; };
    // Each lobe at three profiles and in six forms on a processor, but for what the files hold: one and three.
    CHECK(lines.size() == lobes().size() * (shipped_profiles().size() + 6) - 4);
    CHECK_FALSE(has("not measured: the errors of schlick at p8"));
    CHECK(has("not measured: the errors of schlick at p12"));
    CHECK(has("not measured: the errors of bps at p8"));
    CHECK_FALSE(has("not measured: schlick on a processor, double, batch"));
    CHECK(has("not measured: schlick on a processor, float, batch"));
}

TEST_CASE("price table: the CSV file is exact, the best by the metric first") {
    const Folder folder;
    TableOptions table = options(folder);
    table.sort = "registers";
    CHECK(run_cost_table(table, "command") == 0);
    // 1023 / 2^16; 25 clocks of 16 ns, a result in 5 of them. The second is beaten in LUTs and DSPs.
    const std::string heading =
        "lobe,profile,architecture,device,dsp,output_bits,error,rounding_ulp,luts,registers,dsps,brams,clock_mhz,"
        "latency_clocks,latency_ns,ns_per_result,results_per_second,dominated\n";
    const std::string one =
        "schlick,p8,radix4,hx8k,1,8,0.0156097412,0.75,400,90,1,2,62.5,25,400,80,12500000,1\n"
        "schlick,p8,restoring,hx8k,0,8,0.0156097412,0.75,312,101,0,2,62.5,25,400,80,12500000,0\n";
    CHECK(io::read_file(table.csv) == heading + one);
    // Of all devices, and with processors: 1023 / 2^12, and a comma in a name.
    table.device = "all";
    table.sort = "error";
    table.lobe = "all";
    CHECK(run_cost_table(table, "command") == 0);
    CHECK(io::read_file(table.csv) ==
          heading +
              "schlick,p8,restoring,hx8k,0,8,0.0156097412,0.75,312,101,0,2,62.5,25,400,80,12500000,0\n"
              "schlick,p8,radix4,hx8k,1,8,0.0156097412,0.75,400,90,1,2,62.5,25,400,80,12500000,1\n"
              "cubic,\"8,4,4,4\",default,up5k,0,4,0.249755859,0.5,0,0,0,0,,1,,,,0\n"
              "schlick,double,scalar,cpu,,,,,,,,,,,5,2,500000000,\n"
              "schlick,double,batch,cpu,,,,,,,,,,,,1,1e+09,\n"
              "schlick,p8,scalar,cpu,,,0.0156097412,,,,,,,,,4,250000000,\n");
}

TEST_CASE("price table: JSON, options that leave configurations out, and what leaves none") {
    const Folder folder;
    TableOptions table = options(folder);
    table.csv.clear();
    table.device = "all";
    CHECK(run_cost_table(table, "a command") == 0);
    CHECK_FALSE(std::filesystem::exists(folder / "out.csv"));
    const auto json = nlohmann::json::parse(io::read_file(table.json));
    CHECK(json["command"] == "a command");
    CHECK(json["n"] == nlohmann::json{{"first", 1}, {"last", 1023}, {"step", 1}});
    CHECK(json["cosine"] == "rounded");
    CHECK(json["pareto"] == nlohmann::json{"error", "luts", "dsps", "brams", "latency", "ns"});
    REQUIRE(json["configurations"].size() == 3);
    CHECK(json["configurations"][0]["luts"] == 312);
    CHECK(json["configurations"][0]["clock_mhz"] == 62.5);
    CHECK(json["configurations"][0]["dominated"] == false);
    CHECK(json["configurations"][1]["dominated"] == true);
    CHECK(json["configurations"][2]["lobe"] == "cubic");
    CHECK(json["configurations"][2]["clock_mhz"].is_null());
    REQUIRE(json["cpu"].size() == 3);
    CHECK(json["cpu"][0] == nlohmann::json{{"lobe", "schlick"},
                                           {"type", "double"},
                                           {"profile", ""},
                                           {"form", "scalar"},
                                           {"error", nullptr},
                                           {"ns_per_result", 2},
                                           {"latency_ns", 5},
                                           {"instructions", 7}});
    CHECK(json["cpu"][2]["error"] == 1023.0 / 65536);

    const auto left = [&](const std::string& lobe, const std::string& profile) {
        table.lobe = lobe;
        table.profile = profile;
        run_cost_table(table, "");
        return nlohmann::json::parse(io::read_file(table.json))["configurations"].size();
    };
    CHECK(left("cubic", "") == 1);
    CHECK(left("all", "p8") == 2);
    CHECK(left("", "p8,8,4,4,4") == 3);
    CHECK(holds(refusal([&] { left("cubic", "p8"); }), "no price on all is of --lobe 'cubic' --profile 'p8'"));
    table.lobe.clear();
    table.profile.clear();
    table.plots = folder / "plots";
    CHECK(holds(refusal([&] { run_cost_table(table, ""); }), "a plot shows one device"));
}

TEST_CASE("price table: for people") {
    const Folder folder;
    const Prices data = read_cost_data(folder.path.string());
    std::vector<Configuration> all = join(data, {}, "hx8k");
    const auto words = [](const std::string& text) {
        std::string out;
        for (const char c : text) {
            const char blank = c == '\n' ? '|' : ' ';
            if (c != ' ' && c != '\n')
                out += c;
            else if (!out.empty() && out.back() != blank)
                out += blank;
        }
        return out;
    };
    const std::string plain = words(configurations_table(all));
    CHECK(holds(plain,
                "lobe profile architecture device DSP error rounding/ulp LUTs registers DSPs BRAMs MHz "
                "clocks latency/ns ns/result results/s"));
    CHECK(holds(plain, "schlick p8 restoring hx8k no 0.0156 0.7500 312 101 0 2 62.5 25 400 80.0 12.5 M"));
    CHECK(holds(plain, "schlick p8 radix4 hx8k yes 0.0156 0.7500 400 90 1 2 62.5 25 400 80.0 12.5 M"));
    const std::string marked = words(configurations_table(all, {"one", "two"}));
    CHECK((holds(marked, "12.5 M one|") && holds(marked, "12.5 M two|")));
    CHECK(parse_axes("luts,ns") == std::vector{Metric::luts, Metric::ns});
}

TEST_CASE("prices: numbers and scopes as people read them") {
    CHECK(short_number(0.0) == "0");
    CHECK(short_number(0.012345) == "0.0123");
    CHECK(short_number(99.94) == "99.9");
    CHECK(short_number(7.0) == "7.00");
    CHECK(short_number(123456.0) == "123000");
    CHECK(short_number(-0.5) == "-0.500");
    CHECK(short_number(std::optional<double>()) == "-");
    CHECK(to_text({{8, 1000, 1}, Cosine::rounded, {}, false}) == "n 8 to 1000, at the rounded cosine");
    CHECK(to_text({{8, 1000, 4}, Cosine::exact, {}, false}) == "n 8 to 1000 step 4, at the exact cosine");
    CHECK(to_text({{8, 8, 1}, Cosine::rounded, {}, false}) == "n 8, at the rounded cosine");
}
