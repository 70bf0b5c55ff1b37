// glint_add_sub_odd for Lattice ECP5: a + b, or a - b with subtract_i, for an odd b, and the sign, in one row of CCU2C.
//
// With b odd the carry out of bit 0 is a[0] and the sum there ~a[0] in both cases, so a row needs no bit below it. The top bit
// of the sum is the sign where the operands are such that the sum fits WIDTH bits. No register.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_add_sub_odd #(
    parameter WIDTH = 24,  // bits of a, of b and of the sum, at least 3
    parameter ONES  = 0    // 1: bit 1 of b, or of ~b, is 1 in both cases
) (
    input  wire             subtract_i,
    input  wire [WIDTH-1:0] a_i,
    /* verilator lint_off UNUSED */  // bit 0, and bit 1 with ONES
    input  wire [WIDTH-1:0] b_i,
    /* verilator lint_on UNUSED */
    output wire [WIDTH-2:0] result_o,
    output wire             not_negative_o
);

    localparam CELLS = (WIDTH + 1) / 2;

    wire [2*CELLS-1:0] a, b, subtract;
    /* verilator lint_off UNUSED */  // above the top
    wire [2*CELLS-1:0] sum;
    wire     [CELLS:0] carry;
    /* verilator lint_on UNUSED */
    assign a        = {{(2 * CELLS - WIDTH) {1'b0}}, a_i};
    assign b        = {{(2 * CELLS - WIDTH) {1'b0}}, b_i[WIDTH-1:2], ONES != 0 ? 1'b1 : b_i[1], 1'b0};
    assign subtract = {{(2 * CELLS - 2) {subtract_i}}, ONES != 0 ? 1'b0 : subtract_i, 1'b0};
    assign carry[0] = 1'b0;

    // Of a LUT: at the bottom ~a with D, else a, which makes the carry; in the middle a ^ b ^ C; at the top its complement.
    genvar i;
    generate
        for (i = 0; i < CELLS; i = i + 1) begin : pair
            CCU2C #(
                .INIT0    (i == 0 ? 16'h55AA : 2 * i == WIDTH - 1 ? 16'h69AA : 16'h96AA),
                .INIT1    (2 * i + 1 == WIDTH - 1 ? 16'h69AA : 16'h96AA),
                .INJECT1_0("NO"),
                .INJECT1_1("NO")
            ) adder (
                .CIN(carry[i]), .COUT(carry[i+1]),
                .A0(a[2*i]), .B0(b[2*i]), .C0(subtract[2*i]), .D0(1'b1), .S0(sum[2*i]),
                .A1(a[2*i+1]), .B1(b[2*i+1]), .C1(subtract[2*i+1]), .D1(1'b1), .S1(sum[2*i+1])
            );
        end
    endgenerate
    assign result_o       = sum[WIDTH-2:0];
    assign not_negative_o = sum[WIDTH-1];

endmodule

`default_nettype wire
