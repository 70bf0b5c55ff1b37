// glint_nearest: the integer nearest to x / (2 root + 1), for a signed x. Q_W + 1 clocks.
//
// Contract, with integers: quotient = floor((x + root) / (2 root + 1)), for every x of which that is -2^(Q_W-1) .. 2^(Q_W-1).
// The divisor is odd: no x lies half between two quotients. No valid bits and no reset: its owner counts clocks. Table of
// ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_nearest #(
    parameter ROOT_W = 22,  // bits of the root
    parameter Q_W    = 21   // bits of the quotient's magnitude: -2^(Q_W-1) .. 2^(Q_W-1)
) (
    input  wire                clk_i,
    input  wire                enable_i,
    input  wire [ROOT_W+Q_W:0] x_i,        // signed
    input  wire   [ROOT_W-1:0] root_i,
    output wire        [Q_W:0] quotient_o  // signed
);

    localparam Y_W = ROOT_W + 1;
    localparam X_W = Y_W + Q_W;

    // x + root, and 2^(Q_W-1) divisors more where x is negative: never negative, below (2^(Q_W-1) + 1) divisors.
    wire           negative = x_i[X_W-1];
    wire [X_W-1:0] rounded  = x_i + {{(X_W - ROOT_W) {1'b0}}, root_i};
    wire [X_W-1:0] lifted   = {1'b0, {root_i, 1'b1} & {Y_W{negative}}, {(Q_W - 1) {1'b0}}};
    reg  [X_W-1:0] dividend_q;
    reg  [Y_W-1:0] divisor_q;
    reg            negative_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            dividend_q <= rounded + lifted;
            divisor_q  <= {root_i, 1'b1};
            negative_q <= negative;
        end
    end

    wire [Q_W-1:0] quotient;
    wire           lower;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W(X_W),
        .Y_W(Y_W),
        .Q_W(Q_W)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (enable_i),
        .start_i    (1'b0),
        .dividend_i (dividend_q),
        .divisor_i  (divisor_q),
        .beside_i   (negative_q),
        .done_o     (),
        .quotient_o (quotient),
        .remainder_o(),
        .beside_o   (lower)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // Where it was lifted, 2^(Q_W-1) less.
    assign quotient_o = {lower & ~quotient[Q_W-1], quotient[Q_W-1] ^ lower, quotient[Q_W-2:0]};

endmodule

`default_nettype wire
