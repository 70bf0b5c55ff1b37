// glint_nearest for Lattice ECP5: the integer nearest to x / (2 root + 1), for a signed x. Q_W + 1 clocks.
//
// It takes the place of rtl/blocks/glint_nearest.v in a list of files: same ports, parameters, bits and clocks. It does not
// restore: a row takes the divisor off a remainder that is not negative and adds it to one that is, so it takes a signed x as
// it comes. Table of ports and parameters: docs/rtl.md.

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

    // The first remainder is floor((x + root) / 2^Q_W), -divisor .. divisor - 1: Y_W bits and the sign. Each row doubles it,
    // takes in a bit and adds or subtracts the divisor: in that range again. A quotient bit says that what came is not
    // negative; the sign of x + root is the one above them.
    reg [X_W-1:0] dividend_q;
    reg [Y_W-1:0] odd_q;
    reg           positive_q;
    wire  [X_W:0] rounded = {x_i[X_W-1], x_i} + {{(X_W + 1 - ROOT_W) {1'b0}}, root_i};
    always @(posedge clk_i) begin
        if (enable_i) begin
            dividend_q <= rounded[X_W-1:0];
            odd_q      <= {root_i, 1'b1};
            positive_q <= ~rounded[X_W];
        end
    end

    genvar i;
    generate
        for (i = 0; i < Q_W; i = i + 1) begin : row
            wire [Y_W-1:0] remainder, divisor, next;
            wire   [Q_W:0] bits;  // quotient bits from below, dividend bits from above; at last the sign of x + root
            wire           subtract, fits;
            if (i == 0) begin : first
                assign remainder = dividend_q[X_W-1:Q_W];
                assign divisor   = odd_q;
                assign bits      = {dividend_q[Q_W-1:0], ~positive_q};
                assign subtract  = positive_q;
            end else begin : rest
                assign remainder = row[i-1].remainder_q;
                assign divisor   = row[i-1].divisor_q;
                assign bits      = row[i-1].bits_q;
                assign subtract  = row[i-1].bits_q[0];
            end
            glint_add_sub_odd #(
                .WIDTH(Y_W + 1)
            ) add_sub (
                .subtract_i    (subtract),
                .a_i           ({remainder, bits[Q_W]}),
                .b_i           ({1'b0, divisor}),
                .result_o      (next),
                .not_negative_o(fits)
            );
            // Nobody reads those of the last row.
            // verilator lint_off UNUSEDSIGNAL
            reg [Y_W-1:0] remainder_q;
            reg [Y_W-1:0] divisor_q;
            // verilator lint_on UNUSEDSIGNAL
            reg   [Q_W:0] bits_q;
            always @(posedge clk_i) begin
                if (enable_i) begin
                    remainder_q <= next;
                    divisor_q   <= divisor;
                    bits_q      <= {bits[Q_W-1:0], fits};
                end
            end
        end
    endgenerate
    assign quotient_o = row[Q_W-1].bits_q;

endmodule

`default_nettype wire
