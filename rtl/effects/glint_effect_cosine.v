// glint_effect_cosine: the cosine of the angle between two vectors, one result a clock.
//
// Contract, ports, latency: docs/effects/cosine.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_cosine #(
    parameter W                 = 16,  // bits of a component, 8 .. 18
    parameter F                 = 18,  // fraction bits of the cosine, W - 1 .. 29
    parameter MULTIPLIER_STAGES = 1,   // clocks of a product, 1 .. 4
    parameter TAG_W             = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire     [W-1:0] a_x_i,    // the first vector, signed
    input  wire     [W-1:0] a_y_i,
    input  wire     [W-1:0] a_z_i,
    input  wire     [W-1:0] b_x_i,    // the second
    input  wire     [W-1:0] b_y_i,
    input  wire     [W-1:0] b_z_i,
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire     [F+1:0] c_o,      // signed, code / 2^F
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o // a vector is 0
);

    wire advance;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_stream #(
        .LATENCY(2 * MULTIPLIER_STAGES + 2 * F + 13),
        .TAG_W  (TAG_W)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .clamped_i(1'b0),
        .tag_i    (tag_i),
        .valid_o  (valid_o),
        .ready_i  (ready_i),
        .tag_o    (tag_o),
        .clamped_o(),
        .advance_o(advance)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // A vector of 0 is seen on the way, which costs less than at the ports.
    wire [F+1:0] cosine;
    wire         none;
    reg  [F+1:0] c_q;
    reg          clamped_q;
    glint_cosine #(
        .W                (W),
        .F                (F),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) block (
        .clk_i   (clk_i),
        .enable_i(advance),
        .a_i     ({a_x_i, a_y_i, a_z_i}),
        .b_i     ({b_x_i, b_y_i, b_z_i}),
        .cosine_o(cosine),
        .none_o  (none)
    );
    always @(posedge clk_i) begin
        if (advance) begin
            c_q       <= cosine;
            clamped_q <= none;
        end
    end
    assign c_o       = c_q;
    assign clamped_o = clamped_q;

endmodule

`default_nettype wire
