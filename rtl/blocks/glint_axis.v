// glint_axis: AXI4-Stream around the stream of a unit; every output to the AXI4-Stream side is a register.
//
// s_axis_tdata: [9:0] n, [63:32] cos, sign-extended; of 32 bits: [9:0] n, [F+11:10] cos. The rest is ignored.
// m_axis_tdata: [O:0] y, [31] clamped, the rest 0. tuser and tlast pass along, as the tag of the unit.
// The generated wrappers connect it to their unit. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_axis #(
    parameter F      = 18,  // fraction bits of the cosine
    parameter O      = 12,  // fraction bits of the output
    parameter USER_W = 16,  // width of tuser, at least 1
    parameter WORD_W = 64   // width of s_axis_tdata: 64, or 32 where F is at most 20
) (
    input  wire              aclk,
    input  wire              aresetn,        // synchronous, active low
    /* verilator lint_off UNUSED */          // bits between the fields are ignored
    input  wire [WORD_W-1:0] s_axis_tdata,
    /* verilator lint_on UNUSED */
    input  wire [USER_W-1:0] s_axis_tuser,
    input  wire              s_axis_tlast,
    input  wire              s_axis_tvalid,
    output wire              s_axis_tready,
    output wire       [31:0] m_axis_tdata,
    output wire [USER_W-1:0] m_axis_tuser,
    output wire              m_axis_tlast,
    output wire              m_axis_tvalid,
    input  wire              m_axis_tready,
    // to the inputs of the unit
    output wire              valid_o,
    input  wire              ready_i,
    output wire        [9:0] n_o,
    output wire      [F+1:0] cos_o,
    output wire   [USER_W:0] tag_o,
    // from its outputs
    input  wire              valid_i,
    output wire              ready_o,
    input  wire        [O:0] y_i,
    input  wire   [USER_W:0] tag_i,
    input  wire              clamped_i
);

    localparam TAG_W = USER_W + 1;
    localparam COS   = WORD_W == 32 ? 10 : 32;  // where cos starts

    glint_skid #(
        .WIDTH(TAG_W + F + 2 + 10)
    ) skid_in (
        .clk_i  (aclk),
        .rst_ni (aresetn),
        .valid_i(s_axis_tvalid),
        .ready_o(s_axis_tready),
        .data_i ({s_axis_tuser, s_axis_tlast, s_axis_tdata[COS+F+1:COS], s_axis_tdata[9:0]}),
        .valid_o(valid_o),
        .ready_i(ready_i),
        .data_o ({tag_o, cos_o, n_o})
    );

    wire [O:0] y;
    wire       clamped;

    glint_skid #(
        .WIDTH(TAG_W + 1 + O + 1)
    ) skid_out (
        .clk_i  (aclk),
        .rst_ni (aresetn),
        .valid_i(valid_i),
        .ready_o(ready_o),
        .data_i ({tag_i, clamped_i, y_i}),
        .valid_o(m_axis_tvalid),
        .ready_i(m_axis_tready),
        .data_o ({m_axis_tuser, m_axis_tlast, clamped, y})
    );

    assign m_axis_tdata = {clamped, {(30 - O) {1'b0}}, y};

endmodule

`default_nettype wire
