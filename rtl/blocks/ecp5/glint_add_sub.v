// glint_add_sub for Lattice ECP5: a + b, or a - b with subtract_i, modulo 2^WIDTH, and the carry, in one row of CCU2C.
//
// With subtract_i the carry says a >= b. A LUT of CCU2C takes three operands beside its carry, so the choice costs nothing;
// synthesis would put gates before the adder. No register.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_add_sub #(
    parameter WIDTH = 29
) (
    input  wire             subtract_i,
    input  wire [WIDTH-1:0] a_i,
    input  wire [WIDTH-1:0] b_i,
    output wire [WIDTH-1:0] result_o,
    output wire             carry_o
);

    // Below the operands a bit 1 + (0 ^ subtract_i), whose carry is the 1 of -b = ~b + 1. Above them a LUT of a alone, which
    // is 0, shows the carry.
    localparam CELLS = (WIDTH + 3) / 2;
    localparam ALL   = 2 * CELLS;

    wire  [ALL-1:0] a = {{(ALL - WIDTH - 1) {1'b0}}, a_i, 1'b1};
    wire  [ALL-1:0] b = {{(ALL - WIDTH - 1) {1'b0}}, b_i, 1'b0};
    /* verilator lint_off UNUSED */  // of the bit below and of one above
    wire  [ALL-1:0] sum;
    wire  [CELLS:0] carry;
    /* verilator lint_on UNUSED */
    assign carry[0] = 1'b0;
    genvar i;
    generate
        for (i = 0; i < CELLS; i = i + 1) begin : pair
            CCU2C #(
                .INIT0    (16'h96AA),  // with D a ^ b ^ C, else a
                .INIT1    (16'h96AA),
                .INJECT1_0("NO"),
                .INJECT1_1("NO")
            ) adder (
                .CIN(carry[i]), .COUT(carry[i+1]),
                .A0(a[2*i]), .B0(b[2*i]), .C0(subtract_i), .D0(2 * i <= WIDTH), .S0(sum[2*i]),
                .A1(a[2*i+1]), .B1(b[2*i+1]), .C1(subtract_i), .D1(2 * i + 1 <= WIDTH), .S1(sum[2*i+1])
            );
        end
    endgenerate
    assign {carry_o, result_o} = sum[WIDTH+1:1];

endmodule

`default_nettype wire
