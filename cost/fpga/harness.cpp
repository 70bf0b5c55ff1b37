#include "cost/fpga/harness.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace glint::fpga {
namespace {

int width(const std::vector<Port>& ports) {
    return std::accumulate(ports.begin(), ports.end(), 0, [](int sum, const Port& port) { return sum + port.width; });
}

/// "unit" connected to slices of the two buses, or the wires in its place.
std::string instance(const Unit& unit) {
    std::string out = fmt::format("    {} {}unit (\n        .clk_i(clk_i)", unit.module,
                                  unit.parameters.empty() ? std::string() : fmt::format("#({}) ", unit.parameters));
    for (const auto& [bus, ports] : {std::pair("harness_in_q", &unit.inputs), std::pair("result", &unit.outputs)}) {
        int low = 0;
        for (const Port& port : *ports) {
            out += fmt::format(",\n        .{}({}[{}:{}])", port.name, bus, low + port.width - 1, low);
            low += port.width;
        }
    }
    return out + "\n    );\n";
}

/// Every register has an enable: one without could be merged with a register of the unit that does the same.
std::string around(const Unit& unit, const std::string& middle) {
    const int out_w = width(unit.outputs);
    const int in_w = std::max(width(unit.inputs), out_w);  // as long as the wires of harness_alone need
    return fmt::format(R"(`default_nettype none

module glint_harness (
    input  wire clk_i,
    input  wire shift_i,
    input  wire serial_i,
    output wire serial_o
);

    reg          harness_shift_q;
    reg  [{0}:0] harness_in_q;
    reg  [{1}:0] harness_capture_q;
    reg  [{1}:0] harness_out_q;
    wire [{1}:0] result;

    always @(posedge clk_i) begin
        harness_shift_q <= shift_i;
        if (harness_shift_q) harness_in_q <= {{harness_in_q, serial_i}};
        if (!harness_shift_q) harness_capture_q <= result;
        harness_out_q <= harness_shift_q ? {{harness_out_q, harness_in_q[{0}]}} : harness_capture_q;
    end

    assign serial_o = harness_out_q[{1}];

{2}
endmodule

`default_nettype wire
)",
                       in_w - 1, out_w - 1, middle);
}

std::vector<Port> without(std::vector<Port> ports, std::initializer_list<std::string_view> names) {
    std::erase_if(ports,
                  [&](const Port& port) { return std::find(names.begin(), names.end(), port.name) != names.end(); });
    return ports;
}

}  // namespace

Unit stream_unit(std::string module, const std::vector<Port>& inputs, const std::vector<Port>& results, int tag_w) {
    Unit out{std::move(module), fmt::format(".TAG_W({})", tag_w), {{"rst_ni"}, {"valid_i"}, {"ready_i"}}, {}};
    out.inputs.insert(out.inputs.end(), inputs.begin(), inputs.end());
    out.inputs.push_back({"tag_i", tag_w});
    out.outputs = {{"ready_o"}, {"valid_o"}};
    out.outputs.insert(out.outputs.end(), results.begin(), results.end());
    out.outputs.push_back({"tag_o", tag_w});
    out.outputs.push_back({"clamped_o"});
    return out;
}

Unit lobe_unit(std::string module, const Profile& profile, int tag_w) {
    return stream_unit(std::move(module), {{"n_i", 10}, {"cos_i", profile.F + 2}}, {{"y_o", profile.O + 1}}, tag_w);
}

std::vector<Port> data_ports(const Unit& unit) {
    return without(unit.inputs, {"rst_ni", "valid_i", "ready_i", "tag_i"});
}

std::vector<Port> result_ports(const Unit& unit) { return without(unit.outputs, {"ready_o", "valid_o", "tag_o"}); }

std::string harness(const Unit& unit) { return around(unit, instance(unit)); }

std::string harness_alone(const Unit& unit) {
    return around(unit, fmt::format("    assign result = harness_in_q[{}:0];\n", width(unit.outputs) - 1));
}

std::string clocks_bench(const Unit& unit, std::span<const Exchange> burst) {
    std::string memories, stimuli, connections, results, format, values;
    const std::vector<Port> data = data_ports(unit);
    for (std::size_t p = 0; p < data.size(); ++p) {
        const Port& port = data[p];
        memories += fmt::format("    reg [{}:0] {} [0:COUNT-1];\n", port.width - 1, port.name);
        connections += fmt::format("        .{0}({0}[last ? 0 : sent]),\n", port.name);
        for (std::size_t i = 0; i < burst.size(); ++i) {
            stimuli += fmt::format("        {}[{}] = {};\n", port.name, i, burst[i].in[p]);
        }
    }
    for (const Port& port : result_ports(unit)) {
        results += fmt::format("    wire [{}:0] {};\n", port.width - 1, port.name);
        connections += fmt::format("        .{0}({0}),\n", port.name);
        format += " %0d";
        values += ", " + port.name;
    }
    // Inputs change after the edge, outputs are read at it: as registers do.
    return fmt::format(R"(`default_nettype none
`timescale 1ns / 1ps

module glint_clocks;
    localparam COUNT = {0};
{1}
    reg clk = 0, rst_n = 0;
    always #1 clk = ~clk;

    integer sent = 0, received = 0, clocks = 0, start = 0, idle = 0;
    reg alone = 1;
    wire last = sent == (alone ? 1 : COUNT);

    wire ready, valid;
{2}    {3} #({4}) unit (
        .clk_i(clk),
        .rst_ni(rst_n),
        .valid_i(rst_n & ~last),
        .ready_o(ready),
{5}        .tag_i(1'b0),
        .valid_o(valid),
        .ready_i(1'b1),
        .tag_o()
    );

    initial begin
{6}        repeat (4) @(posedge clk);
        rst_n <= 1;
    end

    always @(posedge clk) if (rst_n) begin
        clocks <= clocks + 1;
        idle   <= valid ? 0 : idle + 1;
        if (!last && ready) begin
            sent  <= sent + 1;
            start <= clocks;
        end
        if (valid && alone) begin
            $display("latency %0d", clocks - start);
            alone <= 0;
            sent  <= 0;
        end else if (valid) begin
            $display("result %0d{7}", clocks{8});
            received <= received + 1;
            if (received == COUNT - 1) $finish(0);
        end
        if (idle == 10000) begin
            $display("no result");
            $finish(0);
        end
    end
endmodule

`default_nettype wire
)",
                       burst.size(), memories, results, unit.module, unit.parameters, connections, stimuli, format,
                       values);
}

}  // namespace glint::fpga
