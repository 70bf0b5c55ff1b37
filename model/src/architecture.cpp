#include "glint/architecture.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/lobes.hpp"

namespace glint {
namespace {

struct Divider {
    std::string_view name;
    bool rows;  ///< of its rows, some may share a clock
};

/// In the order of the parameter DIVIDER.
constexpr std::array<Divider, 4> dividers{
    {{"restoring", true}, {"radix4", true}, {"iterative", false}, {"reciprocal", false}}};
constexpr int most_rows = 32;
constexpr int most_stages = 4;

std::string legal(const Lobe& lobe) {
    if (!lobe.divider) return fmt::format("pipelined[:mN], N = 1 to {}", most_stages);
    std::string out;
    for (const Divider& divider : dividers)
        out += fmt::format("{}{}[:mN], ", divider.name, divider.rows ? "[:rN]" : "");
    return out + fmt::format("N of r 1 to {}, N of m 1 to {}", most_rows, most_stages);
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

}  // namespace

Architecture parse_architecture(const Lobe& lobe, std::string_view text) {
    const Error refused(fmt::format("architecture '{}' is not legal for {}: {}", text, lobe.name, legal(lobe)));
    const std::string_view base = text.substr(0, text.find(':'));
    std::string_view rest = text.substr(base.size());
    const auto* divider =
        std::find_if(dividers.begin(), dividers.end(), [&](const Divider& d) { return d.name == base; });
    if (lobe.divider ? divider == dividers.end() : base != "pipelined") throw refused;
    const bool rows = lobe.divider && divider->rows;
    const std::optional<int> register_every = rows ? take_number(rest, 'r', most_rows) : 1;
    const std::optional<int> stages = register_every ? take_number(rest, 'm', most_stages) : std::nullopt;
    if (!stages || !rest.empty()) throw refused;

    Architecture out{std::string(base), {}};
    if (*register_every != 1) out.name += fmt::format(":r{}", *register_every);
    if (*stages != 1) out.name += fmt::format(":m{}", *stages);
    if (lobe.divider) {
        out.parameters = {{"DIVIDER", static_cast<int>(divider - dividers.begin())},
                          {"REGISTER_EVERY", *register_every}};
    }
    out.parameters.emplace_back("MULTIPLIER_STAGES", *stages);
    return out;
}

Architecture default_architecture(const Lobe& lobe) {
    return parse_architecture(lobe, lobe.divider ? dividers.front().name : "pipelined");
}

}  // namespace glint
