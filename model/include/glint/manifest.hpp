// What a unit of hardware is, for whoever builds, drives or prices it: an entry of rtl/units.json (docs/rtl.md, "The
// manifest"), and its list of files for a simulator.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glint {

struct HardwareUnit {
    struct File {
        std::string name;        ///< by hand: its path in rtl/; generated: its name
        bool generated = false;  ///< `glint emit` writes it
        friend bool operator==(const File&, const File&) = default;
    };
    struct Port {
        std::string name;
        bool output = false;
        int bits = 1;
        std::string parameter;   ///< what of parameters says how many bits: TAG_W, WORD_W / 8; empty: `bits`
        bool is_signed = false;  ///< two's complement
        std::string meaning;
    };
    struct Parameter {
        std::string name;
        std::string value;  ///< the default
        std::string legal;  ///< for people
        std::string meaning;
        int bits = 0;  ///< that it is declared with; 0: an integer
    };
    struct Architecture {
        std::string name;  ///< as on the command line; of an effect "default"
        std::vector<std::pair<std::string, int>> parameters;
        int latency = 0;   ///< clocks from the edge that accepts an input to the first that can take its result
        int interval = 0;  ///< clocks between two results without a stall
    };
    struct Memory {
        std::string name;
        std::string module;
        int address_bits = 0, entry_bits = 0;
    };

    std::string name;          ///< of its top module
    std::string_view kind;     ///< lobe, effect, and with _axis or _lanes behind it
    std::string lobe, effect;  ///< with the lobe's options; empty where there is none
    std::string profile;       ///< as on the command line
    int F = 0, O = 0;          ///< fraction bits of cosines and of results
    std::string core;          ///< the module by hand inside; empty for a unit made of others alone
    std::vector<std::pair<std::string, std::string>> numbers;  ///< the parameters of `core` that the unit sets
    std::vector<File> files;                                   ///< in an order in which they compile, its own last
    std::vector<File> simulation;  ///< models of a device's primitives, for simulators alone
    std::vector<Port> ports;       ///< in the order of the module
    std::vector<Parameter> parameters;
    std::vector<Architecture> architectures;  ///< the first has the defaults of the parameters
    std::vector<Memory> tables;
};

/// Where the files of a manifest or of a list are: what stands before the path of one by hand, and of a generated one.
struct FileRoots {
    std::string_view by_hand, generated;
};
inline constexpr FileRoots committed_paths{"", "generated/"};  ///< of rtl/units.json
inline constexpr FileRoots committed_list{"$(GLINT_RTL)/", "$(GLINT_RTL)/generated/"};
inline constexpr FileRoots emitted_paths{"$(GLINT_RTL)/", ""};  ///< of a units.json beside generated files
inline constexpr FileRoots emitted_list{"$(GLINT_RTL)/", "$(GLINT_EMITTED)/"};

/// Devices with files in the place of others, in a folder NAME beside them (rtl/blocks/NAME, rtl/lobes/NAME): modules
/// of the same ports, parameters, bits and clocks. Primitives that they are made of have models in rtl/simulation/.
struct Family {
    std::string_view name;
    std::vector<std::string_view> modules;
    std::vector<std::pair<std::string_view, std::string_view>> primitives = {};  ///< each with how modules of it begin
    std::vector<std::string_view> more = {};  ///< modules of the family alone, each a file of rtl/blocks/NAME
};
std::span<const Family> families();

/// The unit built of the blocks of a family; of those of any device when `family` is empty.
void use_family(HardwareUnit& unit, std::string_view family);

/// units.json of these units.
std::string manifest(std::span<const HardwareUnit> units, const FileRoots& roots);

/// A list of the files of a unit, one a line, for `verilator -f` and `iverilog -f`.
std::string file_list(const HardwareUnit& unit, const FileRoots& roots);

/// The files of a module that units share, and of all that it contains.
std::vector<HardwareUnit::File> module_files(std::string_view module);

}  // namespace glint
