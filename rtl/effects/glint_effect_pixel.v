// glint_effect_pixel: what stands around glint_effect_shade in a pixel from vectors: the dot products before it, the cut to
// 0 .. 1 behind it.
//
// The unit shade of the profile stands beside it in the generated wrapper, takes start_o as its valid_i and answers with
// ready_o as taken_i. Contract: docs/effects/pixel.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_pixel #(
    parameter W      = 16,  // bits of a component
    parameter F      = 18,  // fraction bits of a dot product
    parameter O      = 12,  // fraction bits of colours
    parameter WIDE   = 1,   // bits of what waits for the dot products
    parameter WITH_R = 1,   // build R.V
    parameter WITH_H = 1,   // build N.H
    parameter WITH_V = 1,   // build V.H
    parameter WITH_T = 1,   // build H.T and H.B
    parameter TAG_W  = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,      // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire   [3*W-1:0] light_i,     // {z, y, x}, signed
    input  wire   [3*W-1:0] view_i,
    input  wire   [3*W-1:0] normal_i,
    input  wire   [3*W-1:0] tangent_i,
    input  wire   [3*W-1:0] bitangent_i,
    input  wire  [WIDE-1:0] waiting_i,   // the other inputs of shade
    input  wire [TAG_W-1:0] tag_i,
    output wire             start_o,     // to shade: valid_i
    input  wire             taken_i,     // its ready_o
    output wire     [F+1:0] nl_o,
    output wire     [F+1:0] nv_o,
    output wire     [F+1:0] lv_o,
    output wire     [F+1:0] rv_o,
    output wire     [F+1:0] nh_o,
    output wire     [F+1:0] vh_o,
    output wire     [F+1:0] ht_o,
    output wire     [F+1:0] hb_o,
    output wire  [WIDE-1:0] waited_o,
    output wire [TAG_W-1:0] tag_o,
    input  wire  [3*O+23:0] sum_i,       // from shade: {b, g, r}
    output wire   [3*O+2:0] pixel_o      // cut to 0 .. 2^O
);

    localparam CLOCKS = WITH_H != 0 ? 2 * F + 15 : WITH_R != 0 ? 7 : 4;  // of glint_frame

    wire advance, unused_tag, unused_clamped;
    glint_stream #(
        .LATENCY(CLOCKS),
        .TAG_W  (1)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .clamped_i(1'b0),
        .tag_i    (1'b0),
        .valid_o  (start_o),
        .ready_i  (taken_i),
        .tag_o    (unused_tag),
        .clamped_o(unused_clamped),
        .advance_o(advance)
    );
    wire unused = &{1'b0, unused_tag, unused_clamped};

    glint_frame #(
        .W     (W),
        .F     (F),
        .WITH_R(WITH_R),
        .WITH_H(WITH_H),
        .WITH_V(WITH_V),
        .WITH_T(WITH_T)
    ) frame (
        .clk_i      (clk_i),
        .rst_ni     (rst_ni),
        .enable_i   (advance),
        .light_i    (light_i),
        .view_i     (view_i),
        .normal_i   (normal_i),
        .tangent_i  (tangent_i),
        .bitangent_i(bitangent_i),
        .nl_o       (nl_o),
        .nv_o       (nv_o),
        .lv_o       (lv_o),
        .rv_o       (rv_o),
        .nh_o       (nh_o),
        .vh_o       (vh_o),
        .ht_o       (ht_o),
        .hb_o       (hb_o)
    );
    glint_wait #(
        .WIDTH (WIDE + TAG_W),
        .CLOCKS(CLOCKS)
    ) wait_others (
        .clk_i   (clk_i),
        .rst_ni  (rst_ni),
        .enable_i(advance),
        .data_i  ({tag_i, waiting_i}),
        .data_o  ({tag_o, waited_o})
    );

    genvar c;
    generate
        for (c = 0; c < 3; c = c + 1) begin : channel
            wire [O+7:0] sum = sum_i[(O+8)*c+:O+8];
            assign pixel_o[(O+1)*c+:O+1] = |sum[O+7:O] ? {1'b1, {O{1'b0}}} : sum[O:0];
        end
    endgenerate

endmodule

`default_nettype wire
