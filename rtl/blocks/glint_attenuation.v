// glint_attenuation: gain = log2(G / N.V) of Cook-Torrance, and the logarithm of N.H, at L fraction bits. Latency 10
// clocks.
//
// The arithmetic is the section "Attenuation" of docs/effects/cook_torrance.md; a value here carries the name that it has
// there. The four tables log2 are beside the unit. No valid bits and no reset: its owner counts clocks.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_attenuation #(
    parameter F = 18,  // fraction bits of the dot products
    parameter T = 5,   // address bits of log2
    parameter L = 21   // fraction bits of the logarithms
) (
    input  wire             clk_i,
    input  wire             enable_i,
    input  wire       [F:0] nl_i,      // 0 .. 2^F each; where nl, nv or nh is 0 the results are without meaning
    input  wire       [F:0] nv_i,
    input  wire       [F:0] nh_i,
    input  wire       [F:0] vh_i,
    output wire   [4*T-1:0] address_o, // of nl, nv, nh, vh, the first the lowest
    input  wire [4*(3*L-3*T+3)-1:0] entry_i,
    output wire     [L+4:0] uh_o,      // -log2(N.H): 0 .. 31 2^L
    output wire     [L+6:0] gain_o     // signed, above -64 2^L, at most 31 2^L
);

    // A dot product has F fraction bits; the logarithm takes L - 1 of them, from the leading one on.
    localparam CUT     = F + 1 > L ? F + 1 - L : 0;
    localparam ENTRY_W = 3 * L - 3 * T + 3;

    wire [4*F+3:0] dots = {vh_i, nh_i, nv_i, nl_i};
    wire [4*L+19:0] u;
    genvar i;
    generate
        for (i = 0; i < 4; i = i + 1) begin : dot
            glint_log2 #(
                .F  (F),
                .T  (T),
                .L  (L),
                .CUT(CUT)
            ) log2 (
                .clk_i    (clk_i),
                .enable_i (enable_i),
                .cosine_i (dots[(F+1)*i+:F+1]),
                .address_o(address_o[T*i+:T]),
                .entry_i  (entry_i[ENTRY_W*i+:ENTRY_W]),
                .u_o      (u[(L+5)*i+:L+5])
            );
        end
    endgenerate
    wire [L+4:0] ul = u[L+4:0];
    wire [L+4:0] uv = u[2*L+9:L+5];
    wire [L+4:0] uh = u[3*L+14:2*L+10];
    wire [L+4:0] uc = u[4*L+19:3*L+15];

    // loss = max(0, uh + max(ul, uv) - uc - 1): each u is at most 31 2^L, so every sum is below 64 2^L. Of vh = 0 uc is
    // 31 2^L, which stands for infinity; then 63 2^L is taken off and nothing is lost.
    wire no_vh = &uc[L+4:L];
    reg  [L+5:0] lit_q, whole_q;
    reg  [L+4:0] uv_q, uh_1_q, uh_0_q;
    reg  [L+6:0] gain_q;
    wire [L+6:0] difference = {1'b0, lit_q} - {1'b0, whole_q};
    wire [L+5:0] loss = difference[L+5:0] & {(L + 6) {~difference[L+6]}};
    always @(posedge clk_i) begin
        if (enable_i) begin
            lit_q   <= {1'b0, uh} + {1'b0, ul > uv ? ul : uv};
            whole_q <= {1'b0, uc} + {no_vh, 4'd0, ~no_vh, {L{1'b0}}};
            uv_q    <= uv;
            uh_1_q  <= uh;

            gain_q  <= {2'b00, uv_q} - {1'b0, loss};
            uh_0_q  <= uh_1_q;
        end
    end
    assign uh_o   = uh_0_q;
    assign gain_o = gain_q;

endmodule

`default_nettype wire
