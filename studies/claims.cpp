#include "studies/claims.hpp"

#include <fmt/format.h>

#include "io/command.hpp"

namespace glint::studies {
namespace {

using Json = nlohmann::ordered_json;

std::string shown(const Json& x, const Claim& claim, bool printed) {
    if (x.is_null()) return "-";
    if (x.is_string()) return x.get<std::string>();
    const double value = x.get<double>() * (claim.unit == "%" ? 100.0 : 1.0);
    const std::string number = printed ? fmt::format("{:.6g}", value) : fmt::format("{:.{}f}", value, claim.digits);
    return claim.unit.empty() ? number : fmt::format("{} {}", number, claim.unit);
}

}  // namespace

std::string_view name_of(Cost cost) {
    constexpr std::string_view names[] = {"latency", "throughput", "instructions", "batch"};
    return names[static_cast<std::size_t>(cost)];
}

Json to_json(const std::vector<Claim>& claims) {
    Json out = Json::array();
    for (const Claim& c : claims) {
        const bool both = c.printed.is_number() && c.measured.is_number();
        out.push_back({{"id", c.id},
                       {"says", c.says},
                       {"source", c.source},
                       {"printed", c.printed},
                       {"measured", c.measured},
                       {"unit", c.unit},
                       {"digits", c.digits},
                       {"difference", both ? Json(c.measured.get<double>() / c.printed.get<double>() - 1.0) : Json()},
                       {"verdict", c.verdict},
                       {"reason", c.reason},
                       {"numbers", c.numbers}});
    }
    return out;
}

std::string claims_table(const std::vector<Claim>& claims) {
    std::vector<std::vector<std::string>> rows{{"claim", "printed", "measured", "verdict"}};
    for (const Claim& c : claims) {
        rows.push_back({c.says, shown(c.printed, c, true), shown(c.measured, c, false), std::string(c.verdict)});
    }
    return io::table(rows);
}

}  // namespace glint::studies
