// What the files of the lobes share: a golden model made of a format, the numbers of a custom profile, the generated
// files.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../blocks.hpp"
#include "../domain.hpp"
#include "glint/error.hpp"
#include "glint/fixed_point.hpp"
#include "glint/lobes.hpp"
#include "glint/reference.hpp"

namespace glint {

/// The golden model of a lobe whose contract is a plain sequence of integers. `Format` holds the word lengths, and:
///   static constexpr std::string_view lobe;
///   Steps steps(int n, std::int64_t C) const;     the integers for corrected arguments; Steps has a member y
///   std::vector<Intermediate> named(std::int64_t C, const Steps&) const;     them with their names; ends with y
///   double real(double c, double n) const;        the real function, 0 <= c <= 1, n >= 1
template <class Format>
class PlainModel final : public GoldenModel {
public:
    PlainModel(const Profile& profile, const Format& format) : GoldenModel(Format::lobe, profile), f_(format) {}

    void reference(double n, std::span<const double> c, std::span<double> out) const override {
        const std::size_t count = std::min(c.size(), out.size());
        for (std::size_t i = 0; i < count; ++i) out[i] = f_.real(c[i], n);
    }

private:
    std::uint32_t value(int n, std::int32_t cosine) const override {
        return static_cast<std::uint32_t>(f_.steps(n, cosine).y);
    }
    std::vector<Intermediate> intermediates(int n, std::int32_t cosine) const override {
        return f_.named(cosine, f_.steps(n, cosine));
    }
    void batch(std::span<const std::uint16_t> n, std::span<const std::int32_t> cos_code,
               std::span<std::uint32_t> packed) const override {
        const std::int32_t one = profile().one();
        for (std::size_t i = 0; i < n.size(); ++i) {
            const Corrected in = correct(n[i], cos_code[i], one);
            packed[i] = pack({in.negative ? 0U : static_cast<std::uint32_t>(f_.steps(in.n, in.cosine).y), in.clamped});
        }
    }

    Format f_;
};

/// The powers 1, 2, 4, 8, 16 of a fraction r = 0 .. 2^S by repeated squaring, each rounded to S bits.
using Powers = std::array<std::int64_t, 5>;
inline Powers powers_by_squaring(std::int64_t r, int S) {
    Powers p{r};
    for (std::size_t i = 1; i < p.size(); ++i) p[i] = rnd(p[i - 1] * p[i - 1], S);
    return p;
}

/// A power of r at O bits, as one product of two of `p` (or of r and 1.0): `power` is 1 .. 6, 8, 16 or 32.
inline std::int64_t power_of(const Powers& p, int power, int S, int O) {
    const std::int64_t left = power <= 2 ? p[0] : power <= 4 ? p[1] : power <= 8 ? p[2] : power == 16 ? p[3] : p[4];
    const std::int64_t right = power == 1                               ? std::int64_t{1} << S
                               : power == 2 || power == 3 || power == 5 ? p[0]
                               : power == 4 || power == 6               ? p[1]
                                                                        : left;
    return rnd(left * right, 2 * S - O);
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
/// enabled clock (table_enable_o) after the address: the fields side by side, the first the most significant. The
/// kernel gets a function <name>_<field>(index) for each field.
struct Table {
    struct Field {
        std::string name;
        int width = 0;  ///< bits; a negative value is stored as two's complement, the unit and the kernel read it back
    };
    std::string name;
    std::vector<Field> fields;
    std::vector<std::vector<std::int64_t>> rows;  ///< 2^k of them, each with a value per field
    std::string module;                           ///< glint_table_<module> in Verilog: tables of one name are equal
};

/// What tables add to the module of a generated wrapper: its wires, the connections of the unit inside (each with a
/// comma before it), the memories' instances.
struct TableText {
    std::string wires, ports, instances;
};
TableText table_text(const std::vector<Table>& tables);

/// `files`, and the modules of tables, a file each; one that several tables share is there once.
std::vector<GeneratedFile> with_tables(std::vector<GeneratedFile> files, const std::vector<Table>& tables);

/// An HLS header of constants <module>_<profile>_constants.hpp: the arguments of `glint emit` that write it, and the
/// document that says what they mean.
struct HeaderNames {
    std::string module, command, document;
};
GeneratedFile constants_header(const HeaderNames& names, const Profile& profile, const std::vector<Constant>& constants,
                               const std::vector<Table>& tables);

/// A signed Verilog literal of `width` bits. Legal: |value| < 2^(width - 1).
std::string verilog_literal(std::int64_t value, int width);

/// What tables and numbers add to the description of a unit. The unit's own file stays the last.
void describe(HardwareUnit& unit, const std::vector<Constant>& parameters, const std::vector<Table>& tables);

/// The Verilog wrappers of the unit and of its AXI4-Stream form, with the parameters set, those of the architecture as
/// parameters of the wrapper, and the tables beside the unit; and the HLS header of constants.
std::vector<GeneratedFile> generated_sources(std::string_view lobe, const Profile& profile,
                                             const Architecture& architecture, const Hardware& hardware,
                                             const std::vector<Constant>& parameters,
                                             const std::vector<Constant>& hls_constants,
                                             const std::vector<Table>& tables = {});

/// The Gappa script of a lobe at a profile, headed as proofs/gappa/run.py wants it. `format` says the word lengths,
/// e.g. "F, S, O: 18, 15, 12".
GeneratedFile gappa_script(std::string_view lobe, const Profile& profile, std::string_view format,
                           std::string_view body);

/// The cases that belong to every lobe, legal and illegal: n at its ends, c = 0, 1 ulp, 1 - 1 ulp .. 1 - 16 ulp, 1, and
/// all that the ports correct. A lobe's own come after them.
std::vector<HardCase> common_hard_cases(const GoldenModel& model);

}  // namespace glint
