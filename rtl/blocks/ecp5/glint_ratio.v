// glint_ratio for Lattice ECP5: Schlick's fraction s = C / D, or with SYMMETRIC its sibling t, as a quotient of S fraction bits.
//
// It takes the place of rtl/blocks/glint_ratio.v in a list of files: same ports, parameters, bits and clocks. The distance has
// F + 1 bits, and its top one is 1 only where C = 0. A product of one clock is one of F bits, which at p12 fits a multiplier
// block; where C = 0 the other operand of the sum is n 2^F. With more clocks a slice of one bit costs none of the last one,
// so there the product has all bits. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_ratio #(
    parameter F                 = 18,  // fraction bits of the cosine
    parameter S                 = 15,  // fraction bits of the quotient, at least 1
    parameter SYMMETRIC         = 0,   // 0: s, 1: t
    parameter DIVIDER           = 0,   // of glint_divider
    parameter REGISTER_EVERY    = 1,
    parameter MULTIPLIER_STAGES = 1    // clocks of a product
) (
    input  wire       clk_i,
    input  wire       enable_i,
    input  wire       start_i,    // iterative: begin with these operands, which stay until done_o
    input  wire [9:0] n_i,        // 1 .. 1023
    input  wire [F:0] cosine_i,   // C: 0 .. 2^F
    input  wire [F:0] distance_i, // 2^F - C
    output wire       done_o,     // iterative: for one clock, the quotient is there, and stays until the next start
    output wire [S:0] quotient_o  // 0 .. 2^S, or 1 .. 2^S
);

    // s: D = C + n (2^F - C). n (2^F - C) <= 1023 2^F, and D <= n 2^F as well, since D falls when C grows: F + 10 bits.
    // t: 2^F + C <= 2^(F+1): F + 2 bits. D falls when C grows, from (2 n + 1) 2^F <= 2047 2^F: F + 11 bits, and so has
    // 2 n (2^F - C) <= 2046 2^F.
    localparam A_W = SYMMETRIC == 1 ? F + 2 : F + 1;
    localparam D_W = SYMMETRIC == 1 ? F + 11 : F + 10;

    localparam NARROW = MULTIPLIER_STAGES == 1 ? 1 : 0;
    localparam B_W    = F + 1 - NARROW;

    /* verilator lint_off UNUSED */  // the top bit of a product that is not narrow is 0
    wire [B_W+9:0] scaled;
    /* verilator lint_on UNUSED */
    glint_multiplier #(
        .A_W   (10),
        .B_W   (B_W),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (n_i),
        .b_i      (distance_i[B_W-1:0]),
        .product_o(scaled)
    );

    // What is added to the product above the lower bits of C.
    wire [9:0] high;
    glint_delay #(
        .WIDTH (10),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_high (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (NARROW == 1 && distance_i[F] ? n_i : {9'd0, cosine_i[F]}),
        .data_o  (high)
    );

    // What goes with it. With the iterative divider the cosine stays where it is.
    wire [F:0] cosine;
    wire       start;
    generate
        if (DIVIDER == 2) begin : held
            assign cosine = cosine_i;
            glint_delay #(
                .WIDTH (1),
                .STAGES(MULTIPLIER_STAGES + 1)
            ) delay_start (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  (start_i),
                .data_o  (start)
            );
        end else begin : moved
            assign start = start_i;  // and not used
            glint_delay #(
                .WIDTH (F + 1),
                .STAGES(MULTIPLIER_STAGES)
            ) delay_cosine (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  (cosine_i),
                .data_o  (cosine)
            );
        end
    endgenerate

    reg [D_W-1:0] complement_q;  // of the divisor: what the rows of a divider add
    reg [A_W-1:0] numerator_q;
    wire [A_W-1:0] numerator;
    wire [D_W-1:0] weighted;     // the product, or twice it
    wire [D_W-1:0] addend;
    generate
        if (SYMMETRIC == 1) begin : symmetric
            assign numerator = {2'b01, {F{1'b0}}} + {1'b0, cosine};
            assign weighted  = {scaled[F+9:0], 1'b0};
            assign addend    = {high, ~cosine[F], cosine[F-1:0]};  // 2^F and C, or 2^F and 2 n 2^F
        end else begin : schlick
            assign numerator = cosine;
            assign weighted  = scaled[F+9:0];
            assign addend    = {high, cosine[F-1:0]};
        end
    endgenerate
    always @(posedge clk_i) begin
        if (enable_i) begin
            complement_q <= ~(weighted + addend);
            numerator_q  <= numerator;
        end
    end

    // The numerator is at most D, so the quotient is at most 2^S: S + 1 bits, as the divider asks.
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W           (A_W + S),
        .Y_W           (D_W),
        .Q_W           (S + 1),
        .DIVIDER       (DIVIDER),
        .REGISTER_EVERY(REGISTER_EVERY),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .ZEROS(9)  // D is at least 2^F, or 2^(F+1)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (enable_i),
        .start_i    (start),
        .dividend_i ({numerator_q, {S{1'b0}}}),
        .divisor_i  (~complement_q),
        .beside_i   (1'b0),
        .done_o     (done_o),
        .quotient_o (quotient_o),
        .remainder_o(),
        .beside_o   ()
    );
    /* verilator lint_on PINCONNECTEMPTY */

endmodule

`default_nettype wire
