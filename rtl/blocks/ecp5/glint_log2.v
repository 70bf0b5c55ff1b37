// glint_log2 for Lattice ECP5: u = -log2(C / 2^F) at L fraction bits. 2 MULTIPLIER_STAGES + 6 clocks.
//
// It takes the place of rtl/blocks/glint_log2.v in a list of files: same ports, parameters, bits and clocks. A product of three
// clocks or four has one more than its block needs: the first of the parabola gives it to the shift. Arithmetic:
// docs/exp-log.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_log2 #(
    parameter F   = 18,  // fraction bits of C, 8 .. 30
    parameter T   = 5,   // address bits, 4 .. F - CUT - 2
    parameter L   = 25,  // fraction bits of u, above F - CUT and above 2 T
    parameter CUT = 0,   // low bits of the normalised C that are dropped
    parameter MULTIPLIER_STAGES = 1
) (
    input  wire             clk_i,
    input  wire             enable_i,
    input  wire       [F:0] cosine_i,  // C: 0 .. 2^F
    output wire     [T-1:0] address_o,
    input  wire [3*L-3*T+2:0] entry_i, // {c0, c1, c2}
    output wire     [L+4:0] u_o        // 0 .. F 2^L, and 31 2^L for C = 0
);

    localparam R    = F - CUT - 1 - T;
    localparam C1_W = L - T + 2;      // 0 < h <= c1 <= 1.45 2^(L-T), signed
    localparam C2_W = L - 2 * T + 1;  // 0 > c2 > -2^(L-2T), signed

    localparam SAVED = MULTIPLIER_STAGES > 2 ? 1 : 0;

    // z, the zero bits before the leading one of C's F + 1 bits, is 16 half + 4 groups + low; it is 31 for C = 0. In the first
    // clock the shift by 16 and the count of groups, then the shift by groups of four, then what is left.
    function [1:0] zero_groups(input [11:0] x);
        zero_groups = |x[11:8] ? 2'd0 : |x[7:4] ? 2'd1 : |x[3:0] ? 2'd2 : 2'd3;
    endfunction
    localparam B = F > 31 ? F - 31 : 0;  // bits below the 32 that are counted: what gives so long a C has its leading one above
    wire [31+B:0] wide = {cosine_i, {(31 + B - F) {1'b0}}};
    wire          half = ~|wide[31+B:16+B];

    reg    [31+B:0] cosine_q;
    reg             half_q;
    reg       [1:0] groups_q;
    reg       [1:0] low_q;
    reg [F-CUT-2:0] mantissa_q;  // M: what follows the leading one, F - CUT - 1 bits
    reg     [R-1:0] r_q;
    wire   [31+B:0] nearly;
    wire      [1:0] low = nearly[31+B] ? 2'd0 : nearly[30+B] ? 2'd1 : nearly[29+B] ? 2'd2 : 2'd3;
    /* verilator lint_off UNUSED */  // the leading one, and 0 below
    wire   [31+B:0] normal = nearly << low;
    /* verilator lint_on UNUSED */
    glint_delay #(
        .WIDTH (32 + B),
        .STAGES(SAVED)
    ) delay_nearly (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (cosine_q << {groups_q, 2'b00}),
        .data_o  (nearly)
    );
    always @(posedge clk_i) begin
        if (enable_i) begin
            cosine_q   <= half ? {wide[15+B:0], 16'd0} : wide;
            half_q     <= half;
            groups_q   <= half ? zero_groups(wide[15+B:4+B]) : zero_groups(wide[31+B:20+B]);
            low_q      <= low;
            mantissa_q <= normal[30+B:32+B-F+CUT];
            r_q        <= mantissa_q[R-1:0];
        end
    end
    assign address_o = mantissa_q[F-CUT-2:R];

    // l = log2(1 + M / 2^(F-1)) < 1: L bits.
    wire [L-1:0] l;
    glint_parabola #(
        .R   (R),
        .G   (0),
        .V_W (L),
        .C1_W(C1_W),
        .C2_W(C2_W),
        .SAVED(SAVED),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) parabola (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .r_i     ({1'b0, r_q}),
        .c0_i    (entry_i[C1_W+C2_W+L-1:C1_W+C2_W]),
        .c1_i    (entry_i[C1_W+C2_W-1:C2_W]),
        .c2_i    (entry_i[C2_W-1:0]),
        .value_o (l)
    );

    wire [4:0] z;
    glint_delay #(
        .WIDTH (3),
        .STAGES(2 * MULTIPLIER_STAGES + 4)
    ) delay_high (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  ({half_q, groups_q}),
        .data_o  (z[4:2])
    );
    glint_delay #(
        .WIDTH (2),
        .STAGES(2 * MULTIPLIER_STAGES + 3 - SAVED)
    ) delay_low (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (low_q),
        .data_o  (z[1:0])
    );

    // u = z - l, never negative: l > 0 only where z > 0. For C = 0 what follows the leading one is 0, and l with it.
    reg [L+4:0] u_q;
    always @(posedge clk_i) begin
        if (enable_i) u_q <= {z, {L{1'b0}}} - {5'd0, l};
    end
    assign u_o = u_q;

endmodule

`default_nettype wire
