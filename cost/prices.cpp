#include "cost/prices.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "cost/fpga/device.hpp"
#include "glint/architecture.hpp"
#include "glint/error.hpp"
#include "io/json_node.hpp"

namespace glint::cost {
namespace {

std::optional<double> optional_number(const io::JsonNode& node, const char* key) {
    return node.has(key) ? std::optional(node.number(key)) : std::nullopt;
}

void check_format(const io::JsonNode& top, std::string_view format) {
    if (top.text("format") != format) top.fail("format", format);
}

/// With what may follow it: "polynomial:symmetric:0:1". It goes into the scripts of the plots and into CSV files.
std::string name(const io::JsonNode& node, const char* key) {
    const std::string out = node.text(key);
    constexpr std::string_view legal = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.,:+-";
    if (out.empty() || out.find_first_not_of(legal) != std::string::npos) {
        node.fail(key, "a name of letters, digits and '_.,:+-'");
    }
    return out;
}

Price read_fpga_point(const io::JsonNode& node) {
    Price out;
    Configuration& c = out.configuration;
    c.lobe = name(node, "lobe");
    c.profile = name(node, "profile");
    c.architecture = name(node, "architecture");
    c.device = node.word("device");
    c.dsp = node.boolean("dsp");
    out.fits = !node.has("fits") || node.boolean("fits");
    if (node.has("error")) {
        const io::JsonNode error = node.node("error");
        out.error = error.number("max");
        out.error_from_8 = error.number("max_n8");
    }
    if (!out.fits) return out;
    c.luts = node.integer("luts", 0, largest_count);
    c.registers = node.integer("registers", 0, largest_count);
    c.carries = node.integer("carries", 0, largest_count);
    c.dsps = node.integer("dsps", 0, largest_count);
    c.brams = node.integer("brams", 0, largest_count);
    c.clock_mhz = optional_number(node, "clock_mhz");
    if (c.clock_mhz == 0.0) node.fail("clock_mhz", "above 0, or null");
    c.latency = node.integer("latency", 1, largest_count);
    c.interval = node.integer("interval", 1, largest_count);
    return out;
}

void read_fpga_file(const std::string& path, Prices& data) {
    const std::string name = fmt::format("price file '{}'", path);
    const nlohmann::json json = io::read_json(path, name);
    const io::JsonNode top(json, name);
    check_format(top, "glint-cost-fpga-1");
    const io::JsonNode tools = top.node("tools");
    std::string tools_here;
    for (const auto& [tool, version] : json["tools"].items()) {
        const std::string text = tools.text(tool.c_str());  // "0.23 (git sha1 7ce5011c24b)"
        tools_here += fmt::format("{}{} {}", tools_here.empty() ? "" : ", ", tool, text.substr(0, text.find(" (")));
    }
    data.tools += fmt::format("{}{}", data.tools.empty() ? "" : "; ", tools_here);
    for (const io::JsonNode& node : top.nodes("points")) data.fpga.push_back(read_fpga_point(node));
    if (data.fpga.empty()) throw Error(name + " holds no points");
}

/// Kernels of lobes, in the cells of an ECP5. hls/bambu/run_all.py writes the file.
void read_hls_file(const std::string& path, Prices& data) {
    const std::string name = fmt::format("file of HLS prices '{}'", path);
    const nlohmann::json json = io::read_json(path, name);
    const io::JsonNode top(json, name);
    check_format(top, "glint-cost-hls-1");
    for (const io::JsonNode& node : top.nodes("points")) {
        const std::string kernel = node.word("kernel");
        if (kernel.starts_with("effect_")) continue;
        Price price;
        Configuration& c = price.configuration;
        c.lobe = kernel;
        c.profile = node.word("profile");
        c.architecture = node.has("form") ? fmt::format("hls:{}", node.word("form")) : "hls";
        c.device = "ecp5-25k";
        c.dsp = true;
        c.carries = node.integer("ccu2c", 0, largest_count);
        c.luts = node.integer("lut4", 0, largest_count) + 2 * c.carries;
        c.registers = node.integer("ff", 0, largest_count);
        c.dsps = node.integer("mult18", 0, largest_count);
        c.brams = node.integer("dp16kd", 0, largest_count);
        c.clock_mhz = optional_number(node, "clock_mhz");
        if (c.clock_mhz == 0.0) node.fail("clock_mhz", "above 0, or null");
        c.latency = node.integer("cycles", 1, largest_count);
        c.interval = node.integer("interval", 1, largest_count);
        data.hls.push_back(price);
    }
}

}  // namespace

const AccuracyRecord* Prices::find(const std::string& lobe, const std::string& profile) const {
    const auto at = std::find_if(accuracy.begin(), accuracy.end(), [&](const AccuracyRecord& record) {
        return record.lobe == lobe && record.profile == profile;
    });
    return at == accuracy.end() ? nullptr : &*at;
}

Prices read_cost_data(const std::string& folder) {
    const auto path = [&](const char* file) { return (std::filesystem::path(folder) / file).string(); };
    for (const auto& [file, writes] :
         {std::pair("accuracy.json", "glint cost --accuracy"), std::pair("fpga.json", "glint cost --fpga")}) {
        if (!std::filesystem::is_regular_file(path(file))) {
            throw Error(fmt::format("file '{}' is not there: `{} --json {}` writes it; --data names another folder",
                                    path(file), writes, path(file)));
        }
    }
    Prices out;
    out.accuracy = read_accuracy_file(path("accuracy.json"));
    read_fpga_file(path("fpga.json"), out);
    if (std::filesystem::is_regular_file(path("fpga-yowasp.json"))) read_fpga_file(path("fpga-yowasp.json"), out);
    if (std::filesystem::is_regular_file(path("cpu.json"))) out.cpu = read_cpu_prices(path("cpu.json"));
    if (std::filesystem::is_regular_file(path("hls.json"))) read_hls_file(path("hls.json"), out);
    return out;
}

bool is_hls(const Configuration& configuration) { return configuration.architecture.starts_with("hls"); }

std::string emit_line(const Configuration& c) {
    std::string how = "--target verilog";
    if (is_hls(c)) {
        how = "--target hls";
    } else if (c.architecture != default_architecture(find_lobe(c.lobe.substr(0, c.lobe.find(':')))).name) {
        how = fmt::format("--architecture {} --target verilog", c.architecture);
    }
    return fmt::format("glint emit --lobe {} --profile {} {} -o out", c.lobe, c.profile, how);
}

std::vector<Configuration> join(const Prices& data, const Scope& scope, const std::string& device,
                                std::vector<std::string>* unknown) {
    std::vector<Configuration> out;
    const auto add = [&](const Price& point) {
        Configuration c = point.configuration;
        if (!point.fits || (!device.empty() && c.device != device)) return;
        const AccuracyRecord* record = data.find(c.lobe, c.profile);
        if (record != nullptr) {
            c.output_bits = record->O;
            c.rounding = record->rounding;
            c.error = record->error(scope.n, scope.cosine);
        } else if (point.error && scope.cosine == Cosine::rounded) {
            c.error = scope.n.first >= 8 ? *point.error_from_8 : *point.error;
        } else {
            const std::string name = c.lobe + " " + c.profile;
            if (unknown != nullptr && std::find(unknown->begin(), unknown->end(), name) == unknown->end()) {
                unknown->push_back(name);
            }
            return;
        }
        c.asked_mhz = scope.asked_mhz;
        out.push_back(std::move(c));
    };
    std::ranges::for_each(data.fpga, add);
    if (scope.hls) std::ranges::for_each(data.hls, add);
    return out;
}

std::vector<std::string> priced_devices(const Prices& data) {
    std::vector<std::string> out;
    for (const Price& point : data.fpga) {
        const std::string& device = point.configuration.device;
        if (std::find(out.begin(), out.end(), device) == out.end()) out.push_back(device);
    }
    const auto place = [](const std::string& name) {
        return std::ranges::find(fpga::devices(), name, &fpga::Device::name) - fpga::devices().begin();
    };
    std::ranges::stable_sort(out, {}, place);
    return out;
}

std::string priced_device(const Prices& data, const std::string& name) {
    const std::vector<std::string> known = priced_devices(data);
    for (const std::string& start : {name, name + '-'}) {
        for (const std::string& device : known) {
            if (device == name || (start != name && device.starts_with(start))) return device;
        }
    }
    throw Error(fmt::format("device '{}' has no prices: {}", name, fmt::join(known, ", ")));
}

Cosine parse_cosine(const std::string& text) {
    if (text == "rounded") return Cosine::rounded;
    if (text == "exact") return Cosine::exact;
    throw Error(fmt::format("--cosine '{}' is not legal: rounded or exact", text));
}

std::string to_text(const Scope& scope) {
    const Range& n = scope.n;
    return fmt::format("n {}{}{}, at the {} cosine", n.first, n.size() > 1 ? fmt::format(" to {}", n.last) : "",
                       n.step > 1 ? fmt::format(" step {}", n.step) : "",
                       scope.cosine == Cosine::rounded ? "rounded" : "exact");
}

std::string short_number(double x) {
    if (x == 0.0) return "0";
    // Rounded first, since that may take it to the next decade.
    const double magnitude = std::pow(10.0, std::floor(std::log10(std::abs(x))) - 2.0);
    const int decimals = std::max(0, -static_cast<int>(std::lround(std::log10(magnitude))));
    return fmt::format("{:.{}f}", std::round(x / magnitude) * magnitude, decimals);
}

std::string short_number(std::optional<double> x) { return x ? short_number(*x) : std::string("-"); }

}  // namespace glint::cost
