#include "glint/architecture.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "glint/manifest.hpp"

namespace glint {
namespace {

/// x / y, rounded up.
constexpr int up(int x, int y) { return (x + y - 1) / y; }

constexpr int most_rows = 32;
constexpr int most_stages = 4;

/// "ecp5, up5k or ice40"
std::string family_names() {
    std::string out;
    for (const Family& family : families()) {
        out += fmt::format("{}{}", out.empty() ? "" : &family == &families().back() ? " or " : ", ", family.name);
    }
    return out;
}

std::string legal(const Lobe& lobe) {
    std::string out;
    const std::string names = family_names();
    if (!lobe.divider)
        return fmt::format("pipelined{}{}[:mN][:FAMILY], N = 1 to {}, FAMILY {}", lobe.deep ? "[:deep]" : "",
                           lobe.block ? "[:block]" : "", most_stages, names);
    for (const Divider& divider : dividers())
        out += fmt::format("{}{}[:mN][:FAMILY], ", divider.name, divider.rows ? "[:rN]" : "");
    return out + fmt::format("N of r 1 to {}, N of m 1 to {}, FAMILY {}", most_rows, most_stages, names);
}

/// The ":FAMILY" that ends `rest`, taken off; empty where there is none.
std::string take_family(std::string_view& rest) {
    for (const Family& family : families()) {
        if (!rest.ends_with(fmt::format(":{}", family.name))) continue;
        rest.remove_suffix(family.name.size() + 1);
        return std::string(family.name);
    }
    return {};
}

/// Whether a word, such as ":deep", is at the front of `rest`; it is taken off.
bool take_word(std::string_view& rest, std::string_view word) {
    if (!rest.starts_with(word)) return false;
    rest.remove_prefix(word.size());
    return true;
}

/// The N of ":rN" or ":mN", taken off the front of `rest`; 1 where there is none; nothing where it is not legal.
std::optional<int> take_number(std::string_view& rest, char letter, int most) {
    if (rest.size() < 2 || rest[0] != ':' || rest[1] != letter) return 1;
    int number = 0;
    const auto [end, error] = std::from_chars(rest.data() + 2, rest.data() + rest.size(), number);
    if (error != std::errc{} || number < 1 || number > most) return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return number;
}

const Divider& divider_of(const Architecture& architecture) {
    return dividers()[static_cast<std::size_t>(architecture.parameter("DIVIDER", 0))];
}

}  // namespace

std::span<const Divider> dividers() {
    static const std::array<Divider, 4> all{
        {{"restoring", "glint_divider_restoring", true, true, [](int Q, int R, int) { return up(Q, R); }},
         {"radix4", "glint_divider_radix4", true, true, [](int Q, int R, int) { return 1 + up(up(Q, 2), R); }},
         {"iterative", "glint_divider_iterative", false, false, [](int Q, int, int) { return Q + 1; }},
         {"reciprocal",
          "glint_divider_reciprocal",
          false,
          true,
          [](int Q, int, int M) { return 1 + M + up(Q, 16) * (2 * M + 1); },
          {"glint_delay", "glint_multiplier"}}}};
    return all;
}

std::string numbered_dividers() {
    std::string out;
    for (const Divider& divider : dividers())
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", &divider - dividers().data(), divider.name);
    return out;
}

Architecture parse_architecture(const Lobe& lobe, std::string_view text) {
    const Error refused(fmt::format("architecture '{}' is not legal for {}: {}", text, lobe.name, legal(lobe)));
    const std::string_view base = text.substr(0, text.find(':'));
    std::string_view rest = text.substr(base.size());
    const auto divider = std::ranges::find(dividers(), base, &Divider::name);
    if (lobe.divider ? divider == dividers().end() : base != "pipelined") throw refused;
    const std::string family = take_family(rest);
    const bool rows = lobe.divider && divider->rows;
    const bool deep = lobe.deep && take_word(rest, ":deep");
    const bool block = lobe.block && take_word(rest, ":block");
    const std::optional<int> register_every = rows ? take_number(rest, 'r', most_rows) : 1;
    const std::optional<int> stages = register_every ? take_number(rest, 'm', most_stages) : std::nullopt;
    if (!stages || !rest.empty()) throw refused;

    Architecture out{std::string(base), {}, family, block};
    if (*register_every != 1) out.name += fmt::format(":r{}", *register_every);
    if (deep) out.name += ":deep";
    if (block) out.name += ":block";
    if (*stages != 1) out.name += fmt::format(":m{}", *stages);
    if (!family.empty()) out.name += ':' + family;
    if (lobe.divider) {
        out.parameters = {{"DIVIDER", static_cast<int>(divider - dividers().begin())},
                          {"REGISTER_EVERY", *register_every}};
    }
    out.parameters.emplace_back("MULTIPLIER_STAGES", *stages);
    if (lobe.deep) out.parameters.emplace_back("DEEP", deep ? 1 : 0);
    return out;
}

Architecture parse_architecture(const HardwareUnit& unit, std::string_view text) {
    const std::string_view base = text.substr(0, text.find(':'));
    std::string_view rest = text.substr(base.size());
    const bool chosen = std::ranges::find(unit.parameters, "MULTIPLIER_STAGES", &HardwareUnit::Parameter::name) !=
                        unit.parameters.end();
    const std::string family = take_family(rest);
    const bool block = !unit.tables.empty() && take_word(rest, ":block");
    const std::optional<int> stages = chosen ? take_number(rest, 'm', most_stages) : 1;
    if (base != "default" || !stages || !rest.empty()) {
        throw Error(fmt::format("architecture '{}' is not legal for {}: default{}{}[:FAMILY], FAMILY {}", text,
                                unit.name, unit.tables.empty() ? "" : "[:block]",
                                chosen ? fmt::format("[:mN], N = 1 to {}", most_stages) : "", family_names()));
    }
    Architecture out{"", {}, family, block};
    if (block) out.name = "block";
    if (*stages != 1) {
        out.name += fmt::format("{}m{}", block ? ":" : "", *stages);
        out.parameters.emplace_back("MULTIPLIER_STAGES", *stages);
    }
    if (!family.empty()) out.name += (out.name.empty() ? "" : ":") + family;
    if (!out.name.empty()) out.name = "default:" + out.name;
    return out;
}

int Architecture::parameter(std::string_view name_of_it, int otherwise) const {
    const auto found =
        std::find_if(parameters.begin(), parameters.end(), [&](const auto& p) { return p.first == name_of_it; });
    return found == parameters.end() ? otherwise : found->second;
}

std::vector<Architecture> listed_architectures(const Lobe& lobe) {
    std::vector<Architecture> out;
    for (const std::string_view stages : {"", ":m2"}) {
        if (!lobe.divider) out.push_back(parse_architecture(lobe, fmt::format("pipelined{}", stages)));
        for (const Divider& divider : dividers()) {
            if (lobe.divider) out.push_back(parse_architecture(lobe, fmt::format("{}{}", divider.name, stages)));
        }
    }
    if (lobe.divider) out.push_back(parse_architecture(lobe, "restoring:r3:m3"));
    if (lobe.deep) out.push_back(parse_architecture(lobe, "pipelined:deep"));
    return out;
}

int division_clocks(const Architecture& architecture, int quotient_bits) {
    if (quotient_bits == 0) return 0;
    return divider_of(architecture)
        .clocks(quotient_bits, architecture.parameter("REGISTER_EVERY", 1),
                architecture.parameter("MULTIPLIER_STAGES", 1));
}

bool takes_one_a_clock(const Architecture& architecture) { return divider_of(architecture).pipeline; }

Architecture default_architecture(const Lobe& lobe) {
    return parse_architecture(lobe, lobe.divider ? dividers().front().name : "pipelined");
}

}  // namespace glint
