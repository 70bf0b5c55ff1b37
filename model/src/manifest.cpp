#include "glint/manifest.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>

#include "blocks.hpp"
#include "glint/effect.hpp"
#include "glint/lobes.hpp"

namespace glint {
namespace {

/// A JSON string. The texts here hold no control characters.
std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

template <class Items, class Text>
std::string list(const Items& items, Text text, std::string_view open, std::string_view close,
                 std::string_view between) {
    std::string out(open);
    std::string_view separator = "";
    for (const auto& item : items) {
        out += separator;
        out += text(item);
        separator = between;
    }
    return out += close;
}

template <class Items, class Text>
std::string lines(const Items& items, Text text) {
    return items.empty() ? "[]" : list(items, text, "[\n   ", "]", ",\n   ");
}

std::string path(const HardwareUnit::File& file, const FileRoots& roots) {
    return fmt::format("{}{}", file.generated ? roots.generated : roots.by_hand, file.name);
}

std::string object(const std::vector<std::pair<std::string, int>>& values) {
    return list(
        values, [](const auto& v) { return fmt::format("{}: {}", quoted(v.first), v.second); }, "{", "}", ", ");
}

std::string object(const std::vector<std::pair<std::string, std::string>>& values) {
    return list(
        values, [](const auto& v) { return fmt::format("{}: {}", quoted(v.first), quoted(v.second)); }, "{", "}", ", ");
}

std::string described(const HardwareUnit& unit, const FileRoots& roots) {
    const auto file = [&](const HardwareUnit::File& f) { return quoted(path(f, roots)); };
    const auto port = [](const HardwareUnit::Port& p) {
        return fmt::format(R"({{"name": "{}", "direction": "{}", "width": {}, "signed": {}, "meaning": {}}})", p.name,
                           p.output ? "output" : "input",
                           p.parameter.empty() ? std::to_string(p.bits) : quoted(p.parameter), p.is_signed,
                           quoted(p.meaning));
    };
    const auto parameter = [](const HardwareUnit::Parameter& p) {
        return fmt::format(R"({{"name": "{}", "default": {}, "legal": {}, "meaning": {}}})", p.name, quoted(p.value),
                           quoted(p.legal), quoted(p.meaning));
    };
    const auto architecture = [](const HardwareUnit::Architecture& a) {
        return fmt::format(R"({{"name": "{}", "parameters": {}, "latency": {}, "interval": {}}})", a.name,
                           object(a.parameters), a.latency, a.interval);
    };
    const auto table = [](const HardwareUnit::Memory& t) {
        return fmt::format(R"({{"name": "{}", "module": "{}", "address_bits": {}, "entry_bits": {}}})", t.name,
                           t.module, t.address_bits, t.entry_bits);
    };
    return fmt::format(R"({{"name": "{}", "kind": "{}", "lobe": {}, "effect": "{}", "profile": "{}", "F": {}, "O": {},
  "core": {{"module": "{}", "parameters": {}}},
  "files": {},{}
  "ports": {},
  "parameters": {},
  "architectures": {},
  "tables": {}}})",
                       unit.name, unit.kind, quoted(unit.lobe), unit.effect, unit.profile, unit.F, unit.O, unit.core,
                       object(unit.numbers), lines(unit.files, file),
                       unit.simulation.empty() ? "" : "\n  \"simulation\": " + lines(unit.simulation, file) + ',',
                       lines(unit.ports, port), lines(unit.parameters, parameter),
                       lines(unit.architectures, architecture), lines(unit.tables, table));
}

/// The modules by hand, each with its files: those that units share, and the cores of units.
using Modules = std::map<std::string, std::vector<HardwareUnit::File>, std::less<>>;
Modules modules(std::span<const HardwareUnit> units) {
    Modules found;
    for (const std::string_view name : shared_modules()) found.try_emplace(std::string(name), files_of(name));
    for (const HardwareUnit& unit : units) {
        if (unit.kind.ends_with("_axis") || unit.kind.ends_with("_lanes") || found.contains(unit.core)) continue;
        std::vector<HardwareUnit::File>& files = found[unit.core];
        std::copy_if(unit.files.begin(), unit.files.end(), std::back_inserter(files),
                     [](const HardwareUnit::File& file) { return !file.generated; });
    }
    return found;
}

std::string modules_of(const Modules& found, const FileRoots& roots) {
    return list(
        found,
        [&](const auto& module) {
            return fmt::format(
                "{}: {}", quoted(module.first),
                list(
                    module.second, [&](const auto& file) { return quoted(path(file, roots)); }, "[", "]", ", "));
        },
        "{\n  ", "}", ",\n  ");
}

/// By family: for each module that it has of its own the files of it and of all that it contains, and the models for a
/// simulator. A core is there where the manifest has a unit of it.
std::string families_of(const Modules& found, const FileRoots& roots) {
    const auto file = [&](const HardwareUnit::File& f) { return quoted(path(f, roots)); };
    return list(
        families(),
        [&](const Family& family) {
            std::string members;
            HardwareUnit unit;
            std::vector<HardwareUnit::File> models;
            for (const auto& primitive : family.primitives)
                models.push_back({fmt::format("simulation/{}.v", primitive.first)});
            for (const std::string_view name : family.modules) {
                const auto module = found.find(name);
                if (module == found.end()) continue;
                unit.files = module->second;
                use_family(unit, family.name);
                members += fmt::format("{}: {}, ", quoted(name), list(unit.files, file, "[", "]", ", "));
            }
            for (const std::string_view name : family.more) {
                const HardwareUnit::File own{fmt::format("blocks/{}/{}.v", family.name, name)};
                members += fmt::format("{}: [{}], ", quoted(name), file(own));
            }
            return fmt::format(R"({}: {{{}"simulation": {}}})", quoted(family.name), members,
                               list(models, file, "[", "]", ", "));
        },
        "{\n  ", "}", ",\n  ");
}

}  // namespace

std::string manifest(std::span<const HardwareUnit> units, const FileRoots& roots) {
    const Modules found = modules(units);
    const bool variable = roots.by_hand.find('$') != std::string_view::npos;
    return fmt::format(
        "{{\"format\": 1,\n \"variables\": {},\n \"dividers\": {},\n \"modules\": {},\n \"families\": {},\n \"units\": "
        "[\n {}\n]}}\n",
        variable ? R"({"GLINT_RTL": "the folder rtl/ of Glint"})" : "{}",
        list(
            dividers(), [](const Divider& divider) { return quoted(divider.name); }, "[", "]", ", "),
        modules_of(found, roots), families_of(found, roots),
        list(
            units, [&](const HardwareUnit& unit) { return described(unit, roots); }, "", "", ",\n "));
}

std::string file_list(const HardwareUnit& unit, const FileRoots& roots) {
    std::string out = fmt::format(
        "// The files of {}, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of "
        "Glint{}.\n",
        unit.name, roots.generated == emitted_list.generated ? ", GLINT_EMITTED that of this file" : "");
    for (const auto* files : {&unit.simulation, &unit.files}) {
        for (const HardwareUnit::File& file : *files) out += path(file, roots) + '\n';
    }
    return out;
}

std::vector<HardwareUnit::File> module_files(std::string_view module) { return files_of(module); }

std::vector<GeneratedFile> committed_verilog() {
    std::vector<GeneratedFile> out;
    std::set<std::string> names;
    const auto add = [&](std::vector<GeneratedFile> files) {
        for (GeneratedFile& file : files) {
            if (file.target != GeneratedFile::Target::verilog) continue;
            if (file.unit && file.unit->kind.ends_with("_axis") && file.unit->profile != "p12") continue;
            if (names.insert(file.name).second) out.push_back(std::move(file));
        }
    };
    for (const Lobe& lobe : lobes()) {
        for (const Profile& profile : shipped_profiles())
            add(with_axi_stream(lobe.emit(profile, default_architecture(lobe))));
    }
    for (const Effect& effect : effects()) {
        for (const Profile& profile : shipped_profiles()) {
            add(with_axi_stream(effect.emit(profile, lobes().front().name)));
        }
    }
    return out;
}

std::vector<HardwareUnit> units_of(const std::vector<GeneratedFile>& files) {
    std::vector<HardwareUnit> out;
    for (const GeneratedFile& file : files) {
        if (file.unit) out.push_back(*file.unit);
    }
    return out;
}

}  // namespace glint
