// What the files of the lobes share: a golden model made of a format, the numbers of a custom profile, the generated
// files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../blocks.hpp"
#include "../domain.hpp"
#include "glint/error.hpp"
#include "glint/fixed_point.hpp"
#include "glint/lanes.hpp"
#include "glint/lobes.hpp"
#include "glint/reference.hpp"

namespace glint {

/// The golden model of a lobe whose contract is a plain sequence of integers. `Format` holds the word lengths, and:
///   static constexpr std::string_view lobe;
///   Steps steps(int n, std::int64_t C) const;     the integers for corrected arguments; Steps has a member y
///   std::vector<Intermediate> named(std::int64_t C, const Steps&) const;     them with their names; ends with y
///   double real(double c, double n) const;        the real function, 0 <= c <= 1, n >= 1
/// A lobe that is worth it adds loops for vector lanes (glint/lanes.hpp); PlainModel uses those that are there:
///   bool has_lanes() const;                       whether the word lengths fit the loop `lanes`
///   static std::uint32_t lanes(const Format&, n, cos_code, packed, count);
///                                                 eval_port and pack, element by element, on pointers as in
///                                                 GoldenModel::eval_port_batch; all bits that occur in the results
///   static void real_lanes(double n, std::span<const double> c, std::span<double> out);     `real`
template <class Format>
class PlainModel final : public GoldenModel {
public:
    PlainModel(const Profile& profile, const Format& format) : GoldenModel(Format::lobe, profile), f_(format) {}

    void reference(double n, std::span<const double> c, std::span<double> out) const override {
        if constexpr (requires { Format::real_lanes(n, c, out); }) {
            Format::real_lanes(n, c, out);
        } else {
            const std::size_t count = std::min(c.size(), out.size());
            for (std::size_t i = 0; i < count; ++i) out[i] = f_.real(c[i], n);
        }
    }

private:
    std::uint32_t value(int n, std::int32_t cosine) const override {
        return static_cast<std::uint32_t>(f_.steps(n, cosine).y);
    }
    std::vector<Intermediate> intermediates(int n, std::int32_t cosine) const override {
        return f_.named(cosine, f_.steps(n, cosine));
    }
    bool batch(std::span<const std::uint16_t> n, std::span<const std::int32_t> cos_code,
               std::span<std::uint32_t> packed) const override {
        std::uint32_t bits = 0;  // that occur in the results
        if constexpr (requires { f_.has_lanes(); }) {
            if (f_.has_lanes()) {
                with_lanes([&] { bits = Format::lanes(f_, n.data(), cos_code.data(), packed.data(), n.size()); });
                return bits >> 31 != 0;
            }
        }
        // A copy: the compiler knows then that no store changes it, and takes what it leads to out of the loop.
        const Format format = f_;
        const std::int32_t one = profile().one();
        for (std::size_t i = 0; i < n.size(); ++i) {
            const Corrected in = correct(n[i], cos_code[i], one);
            packed[i] =
                pack({in.negative ? 0U : static_cast<std::uint32_t>(format.steps(in.n, in.cosine).y), in.clamped});
            bits |= packed[i];
        }
        return bits >> 31 != 0;
    }

    Format f_;
};

/// The golden model of a lobe whose word lengths are what `format_of` says of a profile.
template <auto format_of>
std::unique_ptr<GoldenModel> make_plain(const Profile& profile) {
    const auto format = format_of(profile);
    return std::make_unique<PlainModel<std::remove_const_t<decltype(format)>>>(profile, format);
}

/// A number of a custom profile within its legal range. Throws Error.
int in_range(std::string_view lobe, std::string_view what, int value, int low, int high);

/// Throws Error unless a custom profile has as many numbers as `names` ("F,S,O") and F is in 8..30, O in 4..28.
void check_custom(const Profile& profile, std::string_view lobe, std::string_view names);

/// A parameter of a unit or a constant of a kernel: its name and its value, as source text.
struct Constant {
    std::string name;
    std::string value;
    std::string meaning;  ///< a comment in the HLS header; may be empty
};

/// A read-only memory beside a unit. The unit has the ports <name>_address_o and <name>_entry_i; the entry is there one
/// enabled clock (table_enable_o) after the address, two with DEEP = 1: the fields side by side, the first the most
/// significant. The kernel gets a function <name>_<field>(index) for each field.
struct Table {
    struct Field {
        std::string name;
        int width = 0;  ///< bits; a negative value is stored as two's complement, the unit and the kernel read it back
    };
    std::string name;
    std::vector<Field> fields;
    std::vector<std::vector<std::int64_t>> rows;  ///< 2^k of them, each with a value per field
    std::string module;                           ///< glint_table_<module> in Verilog: tables of one name are equal
    bool chosen =
        false;  ///< its module and the wrapper have the parameters LOGIC (1 keeps it out of block memory), DEEP
    bool clears =
        false;  ///< one that is chosen: the unit has <name>_clear_o, one clock after the address; the entry is 0
};

/// What tables add to the module of a generated wrapper: its wires, the connections of the unit inside (each with a
/// comma before it), the memories' instances.
struct TableText {
    std::string wires, ports, instances;
};
TableText table_text(const std::vector<Table>& tables, const Architecture& architecture = {});

/// Whether one of them is.
bool is_chosen(const std::vector<Table>& tables);

/// `files`, and the modules of tables, a file each; one that several tables share is there once.
std::vector<GeneratedFile> with_tables(std::vector<GeneratedFile> files, const std::vector<Table>& tables,
                                       const Architecture& architecture = {});

/// An HLS kernel: a function template on a struct of constants, in <folder>/glint_<kernel>.hpp beside the generated
/// folder.
struct Kernel {
    std::string folder, kernel;
    std::string command;    ///< the arguments of `glint emit` that write its files
    std::string document;   ///< that says what it computes
    std::string result;     ///< of its top function: the type,
    std::string arguments;  ///< the arguments,
    std::string passed;     ///< and what of them the kernel gets
};

/// Its header glint_<kernel>_<profile>_constants.hpp: the constants, and the declaration of the top function.
GeneratedFile constants_header(const Kernel& kernel, const Profile& profile, const std::vector<Constant>& constants,
                               const std::vector<Table>& tables);

/// Its top function glint_<kernel>_<profile>, one result a clock, in a file of that name.
GeneratedFile top_function(const Kernel& kernel, const Profile& profile);

/// A signed Verilog literal of `width` bits. Legal: |value| < 2^(width - 1).
std::string verilog_literal(std::int64_t value, int width);

/// What tables and numbers add to the description of a unit. The unit's own file stays the last.
void describe(HardwareUnit& unit, const std::vector<Constant>& parameters, const std::vector<Table>& tables,
              const Architecture& architecture = {});

/// The Verilog wrappers of the unit and of its AXI4-Stream form, with the parameters set, those of the architecture as
/// parameters of the wrapper, and the tables beside the unit; and the HLS header of constants.
std::vector<GeneratedFile> generated_sources(std::string_view lobe, const Profile& profile,
                                             const Architecture& architecture, const Hardware& hardware,
                                             const std::vector<Constant>& parameters,
                                             const std::vector<Constant>& hls_constants,
                                             const std::vector<Table>& tables = {});

/// The Gappa script of a lobe at a profile, headed as the runner of the proofs wants it. `format` says the word
/// lengths, e.g. "F, S, O: 18, 15, 12".
GeneratedFile gappa_script(std::string_view lobe, const Profile& profile, std::string_view format,
                           std::string_view body);

/// The least cosine code at which the intermediate value `name` of a model is at least `least`. Legal: a value that is
/// at c = 1, and at every cosine above one at which it is.
std::int32_t first_code(const GoldenModel& model, int n, std::string_view name, std::int64_t least = 1);

/// What covers a case that the ports correct.
inline const std::vector<std::string_view> covered_illegal{"illegal", "kernel", "oracle"};

/// The cases that belong to every lobe, legal and illegal: n at its ends, c = 0, 1 ulp, 1 - 1 ulp .. 1 - 16 ulp, 1, and
/// all that the ports correct. A lobe's own come after them.
std::vector<HardCase> common_hard_cases(const GoldenModel& model);

}  // namespace glint
