// The name of a file of cost/data on a line, and then that file.
#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "check.hpp"
#include "cost/effect_prices.hpp"
#include "cost/grid.hpp"
#include "cost/table.hpp"
#include "io/files.hpp"
#include "io/process.hpp"
#include "studies/paper2.hpp"
#include "targets.hpp"

namespace glint::fuzz {
namespace {

void save(const std::filesystem::path& path, const std::string& text) {
    require(static_cast<bool>(std::ofstream(path, std::ios::binary) << text), "the file is written");
}

/// Errors of bps at p8, all 0, and a price of it: what the files beside the one in question hold.
void save_others(const std::filesystem::path& folder) {
    const std::vector<int> errors(max_n, 0);
    save(folder / "accuracy.json",
         fmt::format(R"({{"format": "glint-cost-accuracy-1", "unit": "", "points": [{{"lobe": "bps", "profile": "p8",
"F": 16, "O": 8, "inputs": {0}, "rounding_ulp": 0.5, "error_rounded_cosine": [{1}], "error_exact_cosine": [{1}]}}]}})",
                     max_n * 65537, fmt::join(errors, ",")));
    save(folder / "fpga.json", R"({"format": "glint-cost-fpga-1", "tools": {"yosys": "0.23"}, "points": [{"lobe": "bps",
"profile": "p8", "architecture": "restoring", "device": "hx8k", "dsp": false, "luts": 1, "registers": 1, "carries": 0,
"dsps": 0, "brams": 0, "fits": true, "clock_mhz": 50.0, "latency": 21, "interval": 1}]})");
}

void show(const cost::Prices& data) {
    for (const cost::Cosine cosine : {cost::Cosine::rounded, cost::Cosine::exact}) {
        const cost::Scope scope{{8, 1000, 1}, cosine, 50.0, true};
        std::vector<cost::Configuration> all = cost::join(data, scope, "");
        cost::sort_by(all, cost::Metric::error);
        const std::vector<cost::CpuPrice> cpu = data.cpu ? data.cpu->prices : std::vector<cost::CpuPrice>();
        const auto json = cost::table_json(all, cost::common_axes, data, cpu, scope);
        require(nlohmann::json::accept(io::json_text(json)), "the table is JSON");
        require(cost::configurations_table(all).ends_with('\n'), "the table is a text");
    }
    require(cost::priced_devices(data).size() <= data.fpga.size(), "a device has a price");
}

}  // namespace

static const Registration prices("prices", [](const std::string& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string name = text.substr(0, end), json = text.substr(std::min(end + 1, text.size()));
    const std::vector<std::string> of_lobes{"accuracy.json", "fpga.json", "fpga-yowasp.json", "cpu.json", "hls.json"};
    const bool lobes = std::ranges::count(of_lobes, name) > 0;
    if (!lobes && name != "cpu-models.json" && name != "effects.json" && name != "grid.json" && name != "shell.json")
        return;
    static const io::TemporaryFolder folder;
    const std::string path = (folder.path() / name).string();
    save_others(folder.path());
    save(path, json);
    if (lobes) may_refuse([&] { show(cost::read_cost_data(folder.path().string())); });
    if (name == "cpu-models.json") may_refuse([&] { cost::read_model_prices(path, studies::paper2::model_names()); });
    if (name == "grid.json") may_refuse([&] { cost::read_grids(path); });
    if (name == "effects.json") {
        may_refuse([&] {
            const cost::EffectPrices read = cost::read_effect_prices(path);
            require(fpga::points_table(read.points, fpga::PriceFile::effects).ends_with('\n'), "the table is a text");
        });
    }
    may_refuse([&] {
        for (const fpga::Point& point : fpga::named_points(path)) fpga::name_of(point);
    });
    for (const auto kind : {fpga::PriceFile::lobes, fpga::PriceFile::effects, fpga::PriceFile::shells}) {
        may_refuse([&] {
            const std::string merged = fpga::merged(path, kind, {{"yosys", "0.23"}}, {});
            require(nlohmann::json::accept(merged), "what is merged is JSON");
        });
    }
    std::filesystem::remove(path);
});

}  // namespace glint::fuzz
