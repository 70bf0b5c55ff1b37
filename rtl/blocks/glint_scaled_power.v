// glint_scaled_power: y = factor 2^-z at O fraction bits, rounded, saturating below 256. Latency 8 clocks.
//
// The arithmetic is the section "Scaled power" of docs/effects/cook_torrance.md; a value here carries the name that it has
// there. The table exp2 is beside the unit. No valid bits and no reset: its owner counts clocks.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_scaled_power #(
    parameter I_W   = 10,  // integer bits of z with the sign; 2^(I_W-1) above O + 3 and above 8 + BELOW
    parameter E     = 3,   // address bits, at least 2
    parameter S     = 16,  // fraction bits of z
    parameter K     = 16,  // fraction bits of the factor
    parameter BELOW = 16,  // the factor is 0 or at least 2^-BELOW: 0 .. K, at most 53 - O
    parameter O     = 12   // fraction bits of y
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire [I_W+S-1:0]   z_i,        // signed
    input  wire               dark_i,     // beside z: y is to be 0
    input  wire       [K+1:0] factor_i,   // 0 .. 2^(K+1); five clocks after z
    output wire       [E-1:0] address_o,
    input  wire [3*S-3*E+5:0] entry_i,    // {c0, c1, c2}
    output wire       [O+7:0] y_o
);

    localparam R    = S - E;
    localparam C1_W = S - E + 3;      // as in glint_exp2
    localparam C2_W = S - 2 * E + 2;

    assign address_o = z_i[S-1:R];
    reg [R-1:0] r_q;
    always @(posedge clk_i) begin
        if (enable_i) r_q <= z_i[R-1:0];
    end

    // p = 2^-(fraction of z): 1/2 .. 1, S + 1 bits.
    wire [S:0] p;
    glint_parabola #(
        .R   (R),
        .G   (2),
        .V_W (S + 1),
        .C1_W(C1_W),
        .C2_W(C2_W)
    ) parabola (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .r_i     ({1'b0, r_q}),
        .c0_i    (entry_i[C1_W+C2_W+S:C1_W+C2_W]),
        .c1_i    (entry_i[C1_W+C2_W-1:C2_W]),
        .c2_i    (entry_i[C2_W-1:0]),
        .value_o (p)
    );

    // Below z = -8 - BELOW any factor but 0 saturates; from O + 3 on any rounds to 0. Between them the shift is
    // j = i + 8 + BELOW, 0 .. O + 10 + BELOW, at most 6 bits.
    localparam [31:0] LEAST_CODE = 8 + BELOW;
    localparam [31:0] MOST_CODE  = O + 10 + BELOW;
    wire [I_W:0] j = {z_i[I_W+S-1], z_i[I_W+S-1:S]} + LEAST_CODE[I_W:0];
    reg       nothing_q, full_q;
    reg [5:0] shift_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            nothing_q <= dark_i | (~j[I_W] & j > MOST_CODE[I_W:0]);
            full_q    <= j[I_W];
            shift_q   <= j[5:0];
        end
    end
    wire       nothing, full;
    wire [5:0] shift;
    glint_delay #(
        .WIDTH (8),
        .STAGES(5)
    ) delay (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  ({nothing_q, full_q, shift_q}),
        .data_o  ({nothing, full, shift})
    );

    // p factor <= 2^(S+K+1). y = rnd(p factor, S + K - O - 8 - BELOW + j); `operand` is that product with one bit more than
    // the half that rounds at j = 0 wants, so bits below are cut, or zeros put in.
    localparam DROP      = S + K > O + 9 + BELOW ? S + K - O - 9 - BELOW : 0;
    localparam PAD       = S + K > O + 9 + BELOW ? 0 : O + 9 + BELOW - S - K;
    localparam PRODUCT_W = S + K + 2;
    localparam OPERAND_W = PRODUCT_W - DROP + PAD;

    /* verilator lint_off UNUSED */  // where DROP is above 0
    reg [PRODUCT_W-1:0] product_q;
    /* verilator lint_on UNUSED */
    reg [OPERAND_W-1:0] cut_q;
    reg                 nothing_late_q, full_late_q;
    reg         [O+7:0] y_q;
    wire [OPERAND_W-1:0] operand;
    generate
        if (PAD > 0) begin : pads
            assign operand = {product_q, {PAD{1'b0}}};
        end else begin : drops
            assign operand = product_q[PRODUCT_W-1:DROP];
        end
    endgenerate

    // Rounded, y has a bit more than the cut; it saturates where that or a bit above the port is 1.
    wire [OPERAND_W-1:0] rounded = {1'b0, cut_q[OPERAND_W-1:1]} + {{(OPERAND_W - 1) {1'b0}}, cut_q[0]};
    always @(posedge clk_i) begin
        if (enable_i) begin
            product_q      <= {{(K + 1) {1'b0}}, p} * {{S{1'b0}}, factor_i};
            cut_q          <= operand >> shift;
            nothing_late_q <= nothing | ~|product_q;
            full_late_q    <= full;
            y_q            <= (rounded[O+7:0] | {(O + 8) {full_late_q | (|rounded[OPERAND_W-1:O+8])}}) &
                              {(O + 8) {~nothing_late_q}};
        end
    end
    assign y_o = y_q;

endmodule

`default_nettype wire
