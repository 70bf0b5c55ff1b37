#include "cost/fpga/table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "glint/sweep.hpp"
#include "io/command.hpp"

namespace glint::fpga {
namespace {

constexpr int n_width = 10;

/// The block RAM that both HX8K and UP5K have: 30 blocks of 4 kbit.
int largest_address(int O) { return static_cast<int>(std::bit_width(30U * 4096U / static_cast<unsigned>(O))) - 1; }

/// The inputs that share an entry, as real numbers.
struct Cell {
    double n_low, n_high, c_low, c_high;
    double largest() const { return std::pow(c_high, n_low); }
    double least() const { return std::pow(c_low, n_high); }
};

Cell cell(const TableFormat& format, const Profile& profile, int n_index, int cos_index) {
    const int n_step = 1 << (n_width - format.n_bits);
    const int cos_step = 1 << (profile.F - format.cos_bits);
    const bool top = cos_index == (1 << format.cos_bits) - 1;  // holds 1.0, too
    const int first = n_index * n_step, code = cos_index * cos_step;
    return {static_cast<double>(std::max(first, 1)), static_cast<double>(first + n_step - 1),
            static_cast<double>(code) / profile.one(),
            top ? 1.0 : static_cast<double>(code + cos_step - 1) / profile.one()};
}

std::vector<std::uint32_t> entries(const TableFormat& format, const Profile& profile) {
    std::vector<std::uint32_t> out;
    const double scale = std::ldexp(1.0, profile.O);
    for (int n = 0; n < 1 << format.n_bits; ++n) {
        for (int c = 0; c < 1 << format.cos_bits; ++c) {
            const Cell here = cell(format, profile, n, c);
            const double middle = (here.largest() + here.least()) / 2.0;
            out.push_back(static_cast<std::uint32_t>(std::min(std::floor(middle * scale + 0.5), scale - 1.0)));
        }
    }
    return out;
}

class TableModel final : public GoldenModel {
public:
    TableModel(const Profile& profile, const TableFormat& format)
        : GoldenModel("table", profile), format_(format), entries_(entries(format, profile)) {}

    void reference(double n, std::span<const double> c, std::span<double> out) const override {
        for (std::size_t i = 0; i < c.size(); ++i) out[i] = std::pow(c[i], n);
    }

private:
    std::uint32_t value(int n, std::int32_t cosine) const override {
        const int cos_index = std::min(cosine, profile().one() - 1) >> (profile().F - format_.cos_bits);
        const int address = (n >> (n_width - format_.n_bits)) << format_.cos_bits | cos_index;
        return entries_[static_cast<std::size_t>(address)];
    }
    std::vector<Intermediate> intermediates(int n, std::int32_t cosine) const override {
        return {{"y", value(n, cosine), profile().O}};
    }
    bool batch(std::span<const std::uint16_t> n, std::span<const std::int32_t> cos_code,
               std::span<std::uint32_t> packed) const override {
        bool clamped = false;
        for (std::size_t i = 0; i < n.size(); ++i) {
            const Corrected in = correct(n[i], cos_code[i], profile().one());
            packed[i] = pack({in.negative ? 0U : value(in.n, in.cosine), in.clamped});
            clamped = clamped || in.clamped;
        }
        return clamped;
    }

    TableFormat format_;
    std::vector<std::uint32_t> entries_;
};

}  // namespace

TableFormat TableFormat::best(const Profile& profile) {
    const int bits = largest_address(profile.O);
    TableFormat out;
    double least = 2.0;
    for (int n_bits = 1; n_bits <= n_width; ++n_bits) {
        const TableFormat format{n_bits, bits - n_bits};
        if (format.cos_bits >= profile.F) continue;
        double worst = 0.0;
        for (int n = 0; n < 1 << format.n_bits; ++n) {
            for (int c = 0; c < 1 << format.cos_bits; ++c) {
                const Cell here = cell(format, profile, n, c);
                worst = std::max(worst, (here.largest() - here.least()) / 2.0);
            }
        }
        if (worst < least) {
            least = worst;
            out = format;
        }
    }
    return out;
}

std::unique_ptr<GoldenModel> table_model(const Profile& profile, const TableFormat& format) {
    return std::make_unique<TableModel>(profile, format);
}

Design table_unit(const Profile& profile, const TableFormat& format) {
    std::string memory;
    const std::vector<std::uint32_t> all = entries(format, profile);
    for (const std::uint32_t entry : all) memory += fmt::format("{:x}\n", entry);
    const std::string module = "glint_table_" + profile.name;
    const std::string text =
        fmt::format(R"(// {0}: a table of c^n at the top {6} bits of n and the top {7} bits of the cosine.

`default_nettype none

module {0} #(
    parameter TAG_W = 16
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    input  wire             valid_i,
    output wire             ready_o,
    input  wire       [9:0] n_i,
    input  wire     [{1}:0] cos_i,
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire     [{2}:0] y_o,
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o
);

    wire         advance, negative;
    wire   [9:0] n;
    wire [{3}:0] cosine;
    glint_ports #(
        .F      ({3}),
        .LATENCY(3),
        .TAG_W  (TAG_W)
    ) ports (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .valid_i   (valid_i),
        .ready_o   (ready_o),
        .n_i       (n_i),
        .cos_i     (cos_i),
        .tag_i     (tag_i),
        .valid_o   (valid_o),
        .ready_i   (ready_i),
        .tag_o     (tag_o),
        .clamped_o (clamped_o),
        .advance_o (advance),
        .n_o       (n),
        .cosine_o  (cosine),
        .distance_o(),
        .negative_o(negative)
    );

    reg [{4}:0] memory [0:{5}];
    initial $readmemh("{0}.hex", memory);

    wire [{7}-1:0] cos_index = cosine[{3}] ? {{{7}{{1'b1}}}} : cosine[{3}-1:{3}-{7}];

    reg [{4}:0] entry_q;
    reg [{4}:0] y_q;
    always @(posedge clk_i) begin
        if (advance) begin
            entry_q <= memory[{{n[9:10-{6}], cos_index}}];
            y_q     <= negative ? {{{8}{{1'b0}}}} : entry_q;
        end
    end

    assign y_o = {{1'b0, y_q}};

endmodule

`default_nettype wire
)",
                    module, profile.F + 1, profile.O, profile.F, profile.O - 1, all.size() - 1, format.n_bits,
                    format.cos_bits, profile.O);
    Design out{{}, {{module + ".hex", memory}, {module + ".v", text}}};
    for (const HardwareUnit::File& file : module_files("glint_ports")) out.by_hand.push_back(file.name);
    return out;
}

nlohmann::ordered_json table_error(const GoldenModel& model) {
    const SweepResult result = sweep(model, {1, max_n, 1}, {0, model.profile().one(), 1});
    Worst from_8;
    for (const AccuracyRow& row : result.rows) {
        if (row.n >= 8) from_8.merge(row.accuracy.approximation);
    }
    return {{"max", result.total.approximation.value}, {"max_n8", from_8.value}, {"inputs", result.total.inputs}};
}

}  // namespace glint::fpga
