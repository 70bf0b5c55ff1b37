// glint_effect_lambert: the diffuse term max(0, N.L), one result a clock.
//
// Contract, ports, latency: docs/effects/lambert.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_lambert #(
    parameter F     = 18,  // fraction bits of the dot product, at least O
    parameter O     = 12,  // fraction bits of the output
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire     [F+1:0] nl_i,     // N.L, signed, code / 2^F
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire       [O:0] y_o,      // code / 2^O, 0 .. 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o // an input was out of range and was corrected
);

    wire         advance, clamped;
    wire [F+1:0] nl_cut;
    glint_dot #(
        .F(F)
    ) nl (
        .dot_i    (nl_i),
        .dot_o    (nl_cut),
        .clamped_o(clamped)
    );

    glint_stream #(
        .LATENCY(2),  // 1 correct, 1 round
        .TAG_W  (TAG_W)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .clamped_i(clamped),
        .tag_i    (tag_i),
        .valid_o  (valid_o),
        .ready_i  (ready_i),
        .tag_o    (tag_o),
        .clamped_o(clamped_o),
        .advance_o(advance)
    );

    // y = rnd(max(0, nl), F - O), at most 2^O since the operand is at most 2^F.
    reg [F:0] positive_q;
    reg [O:0] y_q;
    generate
        if (F == O) begin : exact
            always @(posedge clk_i) if (advance) y_q <= positive_q;
        end else begin : rounded
            always @(posedge clk_i) if (advance) y_q <= positive_q[F:F-O] + {{O{1'b0}}, positive_q[F-O-1]};
            if (F > O + 1) begin : below_half
                wire unused = &{1'b0, positive_q[F-O-2:0]};
            end
        end
    endgenerate
    always @(posedge clk_i) if (advance) positive_q <= nl_cut[F:0] & {(F + 1) {~nl_cut[F+1]}};

    assign y_o = y_q;

endmodule

`default_nettype wire
