// glint_log2: u = -log2(C / 2^F) at L fraction bits. 2 MULTIPLIER_STAGES + 6 clocks.
//
// The arithmetic is the section "log2" of docs/exp-log.md; a value here carries the name that it has there. The table
// is beside the unit: its entry comes one enabled clock after the address. No valid bits and no reset: its owner
// counts clocks.

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

    // z, the zero bits before the leading one of C's F + 1 bits: 0 .. F <= 30.
    function [4:0] zeros(input [F:0] x);
        integer k;
        begin
            zeros = 5'd0;
            for (k = 0; k <= F; k = k + 1) if (x[k]) zeros = F[4:0] - k[4:0];
        end
    endfunction

    reg       [F:0] cosine_q;
    reg       [4:0] z_q;
    reg             none_q;
    reg [F-CUT-2:0] mantissa_q;  // M: what follows the leading one, F - CUT - 1 bits
    reg     [R-1:0] r_q;

    // The leading one has left; the last bit is 0 where CUT is 0, since only C = 2^F is not shifted.
    /* verilator lint_off UNUSED */
    wire  [F:0] normal = cosine_q << z_q;
    /* verilator lint_on UNUSED */
    always @(posedge clk_i) begin
        if (enable_i) begin
            cosine_q   <= cosine_i;
            z_q        <= zeros(cosine_i);
            none_q     <= ~|cosine_i;
            mantissa_q <= normal[F-1:CUT+1];
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
    wire       none;
    glint_delay #(
        .WIDTH (6),
        .STAGES(2 * MULTIPLIER_STAGES + 4)
    ) delay (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  ({none_q, z_q}),
        .data_o  ({none, z})
    );

    // u = z - l, never negative: l > 0 only where z > 0.
    reg [L+4:0] u_q;
    always @(posedge clk_i) begin
        if (enable_i) u_q <= none ? {5'd31, {L{1'b0}}} : {z, {L{1'b0}}} - {5'd0, l};
    end
    assign u_o = u_q;

endmodule

`default_nettype wire
