// glint_quadratic: the specular highlight max(0, 0.786 n c^2 + (1 - 0.786 n) c) in fixed point, one result a clock.
//
// The arithmetic is docs/lobes/quadratic.md; a value here carries the name that it has there. Do not instantiate this
// module by hand: the constant SLOPE comes from the model (`glint emit`), which writes one wrapper per profile
// (rtl/generated/). Table of ports, handshake: docs/rtl.md.

`default_nettype none

module glint_quadratic #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter S     = 13,  // fraction bits of w; O <= S
    parameter K     = 14,  // fraction bits of the constant; S <= F + K
    parameter O     = 12,  // fraction bits of the output
    parameter TAG_W = 16,  // width of the tag, at least 1
    // 0.786 at K fraction bits. The widths below rest on its being below 1, so no other is legal.
    parameter [K-1:0] SLOPE = 0
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire       [9:0] n_i,      // specular exponent
    input  wire     [F+1:0] cos_i,    // cosine, signed, code / 2^F
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire       [O:0] y_o,      // result, code / 2^O, 0 .. 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o // an input was out of range and was corrected
);

`ifndef SYNTHESIS
    initial begin
        if (SLOPE == 0) begin  // the default: without its constant the unit would answer c to everything
            $display("glint_quadratic: parameter SLOPE not set; use a wrapper from `glint emit`");
            $finish;
        end
    end
`endif

    localparam LATENCY = 6;  // 1 correct, 1 slope n, 1 times d, 1 w, 1 times C, 1 rounding

    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] cosine, distance;
    glint_ports #(
        .F      (F),
        .LATENCY(LATENCY),
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
        .distance_o(distance),
        .negative_o(negative)
    );

    // ---- scaled = slope n, and its product with d = 2^F - C -------------------------------------------------------
    // slope < 2^K and n < 2^10: K + 10 bits; times d <= 2^F: below 2^(F+K+10).
    localparam N_W = K + 10;
    localparam P_W = F + K + 10;

    reg [N_W-1:0] scaled_q;
    reg [P_W-1:0] product_q;
    reg     [F:0] cosine_1_q, cosine_2_q, cosine_3_q;  // beside scaled, product, w
    reg     [F:0] distance_1_q;

    // ---- w = rnd(line, F + K - S), line = max(0, 2^(F+K) - scaled d) ----------------------------------------------
    // Between -2^(F+K+10) and 2^(F+K), with the half that rounds it below 2^(F+K+1): one bit more for the sign. Rounded
    // before it is cut: rnd is monotone and keeps 0.
    localparam LINE_W = F + K + 11;
    localparam CUT    = F + K - S;  // bits dropped, at least 0

    localparam [LINE_W-1:0] UNIT   = {{(LINE_W - 1) {1'b0}}, 1'b1};
    localparam [LINE_W-1:0] OFFSET = (UNIT << (F + K)) + ((UNIT << CUT) >> 1);

    /* verilator lint_off UNUSED */  // the low bits are those that rounding cuts; the high ones repeat the sign
    wire [LINE_W-1:0] line = OFFSET - {1'b0, product_q};
    /* verilator lint_on UNUSED */
    reg         [S:0] w_q;  // 0 .. 2^S, since line is at most 2^(F+K)

    // ---- y = rnd(C w, F + S - O) ----------------------------------------------------------------------------------
    // C w <= 2^(F+S); with the half that rounds it still fits F + S + 1 bits.
    localparam Y_W   = F + S + 1;
    localparam CUT_Y = F + S - O;  // at least F, since O <= S

    reg  [Y_W-1:0] product_y_q;
    /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts
    wire [Y_W-1:0] sum = product_y_q + {{(Y_W - CUT_Y) {1'b0}}, 1'b1, {(CUT_Y - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    reg      [O:0] y_q;

    always @(posedge clk_i) begin
        if (advance) begin
            scaled_q     <= {10'b0, SLOPE} * {{K{1'b0}}, n};
            cosine_1_q   <= cosine;
            distance_1_q <= distance;

            product_q  <= {{F{1'b0}}, scaled_q} * {{(P_W - F - 1) {1'b0}}, distance_1_q};
            cosine_2_q <= cosine_1_q;

            w_q        <= line[LINE_W-1] ? {(S + 1) {1'b0}} : line[CUT+S:CUT];
            cosine_3_q <= cosine_2_q;

            product_y_q <= {{S{1'b0}}, cosine_3_q} * {{F{1'b0}}, w_q};

            y_q <= negative ? {(O + 1) {1'b0}} : sum[F+S:CUT_Y];
        end
    end
    assign y_o = y_q;

endmodule

`default_nettype wire
