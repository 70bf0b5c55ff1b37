// glint_exp2 for Lattice ECP5: y = 2^-t at O fraction bits. 2 MULTIPLIER_STAGES + 5 clocks.
//
// It takes the place of rtl/blocks/glint_exp2.v in a list of files: same ports, parameters, bits and clocks. A product of three
// clocks or four has more than its block needs: the first of the parabola gives one to the shift. Arithmetic: docs/exp-log.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_exp2 #(
    parameter I_W = 15,  // integer bits of t, at least 6
    parameter E   = 3,   // address bits, at least 2
    parameter S   = 16,  // fraction bits of t and p, above 2 E + 1
    parameter O   = 12,  // fraction bits of y, 4 .. 28
    parameter MULTIPLIER_STAGES = 1
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire [I_W+S-1:0]   t_i,
    input  wire               negative_i,  // y is to be 0; beside the last step
    output wire [E-1:0]       address_o,
    input  wire [3*S-3*E+5:0] entry_i,     // {c0, c1, c2}
    output wire [O:0]         y_o          // 0 .. 2^O
);

    localparam R    = S - E;
    localparam C1_W = S - E + 3;      // 0 > h >= c1 > -2^(S-E) at S bits, at S + 2 bits; signed
    localparam C2_W = S - 2 * E + 2;  // 0 < c2 < 2^(S-2E-1) at S bits, at S + 2 bits; signed

    localparam SAVED = MULTIPLIER_STAGES > 2 ? 1 : 0;

    assign address_o = t_i[S-1:R];

    // From an integer part of O + 2 on nothing is left, however p rounds.
    localparam    [31:0] LAST_CODE = O + 1;
    localparam [I_W-1:0] LAST = LAST_CODE[I_W-1:0];
    wire [I_W-1:0] integer_part = t_i[I_W+S-1:S];
    wire           beyond       = integer_part > LAST;

    reg [R-1:0] r_q;
    always @(posedge clk_i) begin
        if (enable_i) r_q <= t_i[R-1:0];
    end

    // p = 2^-(fraction of t): 2^S at 0, else less; S + 1 bits.
    /* verilator lint_off UNUSED */  // the bits of p that y's half does not reach
    wire [S:0] p;
    /* verilator lint_on UNUSED */
    glint_parabola #(
        .R   (R),
        .G   (2),
        .V_W (S + 1),
        .C1_W(C1_W),
        .C2_W(C2_W),
        .SAVED(SAVED),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) parabola (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .r_i     ({1'b0, r_q}),
        .c0_i    (entry_i[C1_W+C2_W+S:C1_W+C2_W]),
        .c1_i    (entry_i[C1_W+C2_W-1:C2_W]),
        .c2_i    (entry_i[C2_W-1:0]),
        .value_o (p)
    );

    wire [4:0] shift;
    wire       nothing;
    glint_delay #(
        .WIDTH (6),
        .STAGES(2 * MULTIPLIER_STAGES + 3 - SAVED)
    ) delay (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  ({beyond, integer_part[4:0]}),
        .data_o  ({nothing, shift})
    );

    // p at O + 1 fraction bits; where that is more than S, zeros follow.
    wire [O+1:0] head;
    generate
        if (S > O) begin : cut
            assign head = p[S:S-O-1];
        end else begin : pad
            assign head = {p, {(O + 1 - S) {1'b0}}};
        end
    endgenerate

    // By multiples of four places, then by what is left.
    wire [O+1:0] nearly;
    wire   [1:0] places;
    glint_delay #(
        .WIDTH (O + 4),
        .STAGES(SAVED)
    ) delay_nearly (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  ({nothing ? {(O + 2) {1'b0}} : head >> {shift[4:2], 2'b00}, shift[1:0]}),
        .data_o  ({nearly, places})
    );

    // y = rnd(p, S - O + shift): cut to one bit more, then rounded by that bit.
    reg [O+1:0] cut_q;
    reg   [O:0] y_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            cut_q <= nearly >> places;
            y_q   <= negative_i ? {(O + 1) {1'b0}} : cut_q[O+1:1] + {{O{1'b0}}, cut_q[0]};
        end
    end
    assign y_o = y_q;

endmodule

`default_nettype wire
