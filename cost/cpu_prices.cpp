#include "cost/cpu_prices.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "io/json_node.hpp"

namespace glint::cost {
namespace {

double positive(const io::JsonNode& node, const char* key) {
    const double out = node.number(key);
    if (out == 0.0) node.fail(key, "a number above 0");
    return out;
}

CpuPrice read_price(const io::JsonNode& node, const char* subject) {
    CpuPrice out;
    out.name = node.word(subject);
    out.type = node.word("type");
    if (out.type != "double" && out.type != "float" && out.type != "fixed") node.fail("type", "double, float or fixed");
    if (out.type == "fixed") out.profile = node.text("profile");
    out.form = node.word("form");
    if (out.form != "scalar" && out.form != "batch") node.fail("form", "scalar or batch");
    out.formula = node.text("formula");
    out.throughput = positive(node, "throughput_ns");
    out.q1 = positive(node, "throughput_q1_ns");
    out.q3 = positive(node, "throughput_q3_ns");
    if (out.q1 > out.throughput) node.fail("throughput_q1_ns", "no more than throughput_ns");
    if (out.q3 < out.throughput) node.fail("throughput_q3_ns", "no less than throughput_ns");
    if (node.has("latency_ns")) out.latency = positive(node, "latency_ns");
    if (node.has("instructions")) out.instructions = positive(node, "instructions");
    return out;
}

/// `subject` is the key of what a point is of.
CpuPrices read(const std::string& path, const std::string& name, const char* format, const char* subject) {
    const nlohmann::json json = io::read_json(path, name);
    const io::JsonNode top(json, name);
    if (top.text("format") != format) top.fail("format", fmt::format("{}, as bench/run.py writes it", format));
    CpuPrices out;
    out.command = top.text("command");
    const io::JsonNode machine = top.node("machine");
    out.cpu = machine.text("cpu");
    out.compiler = machine.text("compiler");
    out.flags = machine.text("flags");
    out.date = machine.text("date");
    for (const io::JsonNode& point : top.nodes("points")) out.prices.push_back(read_price(point, subject));
    return out;
}

}  // namespace

const CpuPrice* CpuPrices::find(std::string_view name, std::string_view type, std::string_view form) const {
    const auto it = std::find_if(prices.begin(), prices.end(), [&](const CpuPrice& price) {
        return price.name == name && price.type == type && price.form == form;
    });
    return it == prices.end() ? nullptr : &*it;
}

CpuPrices read_cpu_prices(const std::string& path) {
    const std::string name = fmt::format("file of CPU prices '{}'", path);
    const CpuPrices out = read(path, name, "glint-cost-cpu-1", "lobe");
    // What all ratios are to.
    if (out.find("schlick", "double", "scalar") == nullptr || out.find("schlick", "double", "batch") == nullptr) {
        throw Error(name +
                    " does not hold the lobe schlick in double, scalar and batch, to which the others are compared");
    }
    return out;
}

CpuPrices read_model_prices(const std::string& path, std::span<const std::string_view> names) {
    const std::string name = fmt::format("file of CPU prices of models '{}'", path);
    const CpuPrices out = read(path, name, "glint-cost-cpu-models-1", "model");
    for (const std::string_view model : names) {
        for (const char* type : {"double", "float"}) {
            if (out.find(model, type, "scalar") == nullptr) {
                throw Error(fmt::format("{} does not hold the model {} in {}, scalar", name, model, type));
            }
        }
    }
    return out;
}

}  // namespace glint::cost
