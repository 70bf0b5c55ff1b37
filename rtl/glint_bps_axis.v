// glint_bps_axis: glint_bps as an AXI4-Stream unit; every output is a register. tlast and tuser pass along.
//
// s_axis_tdata: [9:0] n, [63:32] cos, sign-extended; the rest is ignored.
// m_axis_tdata: [O:0] y, [31] clamped, the rest 0.
// Do not instantiate by hand: use a wrapper from `glint emit`. Table of ports and parameters: docs/rtl.md.

`default_nettype none

module glint_bps_axis #(
    parameter F      = 18,  // as in glint_bps
    parameter S      = 15,
    parameter K      = 15,
    parameter O      = 12,
    parameter USER_W = 16,  // width of tuser, at least 1
    parameter signed [K+2:0] A  = 0,
    parameter signed [K+2:0] B  = 0,
    parameter signed [K+2:0] C1 = 0,
    parameter signed [K+2:0] D0 = 0
) (
    input  wire              aclk,
    input  wire              aresetn,        // synchronous, active low
    /* verilator lint_off UNUSED */          // bits between the fields are ignored
    input  wire       [63:0] s_axis_tdata,
    /* verilator lint_on UNUSED */
    input  wire [USER_W-1:0] s_axis_tuser,
    input  wire              s_axis_tlast,
    input  wire              s_axis_tvalid,
    output wire              s_axis_tready,
    output wire       [31:0] m_axis_tdata,
    output wire [USER_W-1:0] m_axis_tuser,
    output wire              m_axis_tlast,
    output wire              m_axis_tvalid,
    input  wire              m_axis_tready
);

    localparam TAG_W = USER_W + 1;
    localparam IN_W  = TAG_W + F + 2 + 10;
    localparam OUT_W = TAG_W + 1 + O + 1;

    wire             in_valid, in_ready;
    wire [TAG_W-1:0] in_tag;
    wire     [F+1:0] in_cos;
    wire       [9:0] in_n;

    glint_skid #(
        .WIDTH(IN_W)
    ) skid_in (
        .clk_i  (aclk),
        .rst_ni (aresetn),
        .valid_i(s_axis_tvalid),
        .ready_o(s_axis_tready),
        .data_i ({s_axis_tuser, s_axis_tlast, s_axis_tdata[32+F+1:32], s_axis_tdata[9:0]}),
        .valid_o(in_valid),
        .ready_i(in_ready),
        .data_o ({in_tag, in_cos, in_n})
    );

    wire             out_valid, out_ready, out_clamped;
    wire [TAG_W-1:0] out_tag;
    wire       [O:0] out_y;

    glint_bps #(
        .F    (F),
        .S    (S),
        .K    (K),
        .O    (O),
        .TAG_W(TAG_W),
        .A    (A),
        .B    (B),
        .C1   (C1),
        .D0   (D0)
    ) core (
        .clk_i    (aclk),
        .rst_ni   (aresetn),
        .valid_i  (in_valid),
        .ready_o  (in_ready),
        .n_i      (in_n),
        .cos_i    (in_cos),
        .tag_i    (in_tag),
        .valid_o  (out_valid),
        .ready_i  (out_ready),
        .y_o      (out_y),
        .tag_o    (out_tag),
        .clamped_o(out_clamped)
    );

    wire       [O:0] y;
    wire             clamped;

    glint_skid #(
        .WIDTH(OUT_W)
    ) skid_out (
        .clk_i  (aclk),
        .rst_ni (aresetn),
        .valid_i(out_valid),
        .ready_o(out_ready),
        .data_i ({out_tag, out_clamped, out_y}),
        .valid_o(m_axis_tvalid),
        .ready_i(m_axis_tready),
        .data_o ({m_axis_tuser, m_axis_tlast, clamped, y})
    );

    assign m_axis_tdata = {clamped, {(30 - O) {1'b0}}, y};

endmodule

`default_nettype wire
