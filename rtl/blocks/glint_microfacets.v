// glint_microfacets: what both forms of Cook-Torrance do with the ports that they share: dot products and level corrected,
// in a register.
//
// Dark is a result that is 0 whatever else: nl, nv or nh is not above 0, where their magnitudes have no meaning any more.
// Ports and parameters: docs/rtl.md; contract: docs/effects/cook_torrance.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_microfacets #(
    parameter F = 18,  // fraction bits of the dot products
    parameter S = 16   // fraction bits of level
) (
    input  wire         clk_i,
    input  wire         enable_i,
    input  wire [F+1:0] nl_i,      // N.L, signed, code / 2^F
    input  wire [F+1:0] nv_i,      // N.V
    input  wire [F+1:0] nh_i,      // N.H
    input  wire [F+1:0] vh_i,      // V.H
    input  wire [S+5:0] level_i,   // signed, code / 2^S, -32 .. 32
    input  wire         dark_i,    // the result is 0 for another reason
    output wire         clamped_o, // of the input that is offered: something is corrected
    output wire   [F:0] nl_o,      // one enabled clock later: 0 .. 2^F
    output wire   [F:0] nv_o,
    output wire   [F:0] nh_o,
    output wire   [F:0] vh_o,
    output wire [S+5:0] level_o,   // -32 .. 16
    output wire         dark_o
);

    wire   [4:0] clamped;
    wire [F+1:0] nl_cut, nv_cut, nh_cut, vh_cut;
    glint_dot #(
        .F(F)
    ) nl_dot (
        .dot_i    (nl_i),
        .dot_o    (nl_cut),
        .clamped_o(clamped[0])
    );
    glint_dot #(
        .F(F)
    ) nv_dot (
        .dot_i    (nv_i),
        .dot_o    (nv_cut),
        .clamped_o(clamped[1])
    );
    glint_dot #(
        .F(F)
    ) nh_dot (
        .dot_i    (nh_i),
        .dot_o    (nh_cut),
        .clamped_o(clamped[2])
    );
    glint_dot #(
        .F(F)
    ) vh_dot (
        .dot_i    (vh_i),
        .dot_o    (vh_cut),
        .clamped_o(clamped[3])
    );
    assign clamped[4] = ~level_i[S+5] & level_i[S+4] & (|level_i[S+3:0]);  // above 16
    assign clamped_o  = |clamped;

    reg   [F:0] nl_q, nv_q, nh_q, vh_q;
    reg [S+5:0] level_q;
    reg         dark_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            nl_q    <= nl_cut[F:0];
            nv_q    <= nv_cut[F:0];
            nh_q    <= nh_cut[F:0];
            vh_q    <= vh_cut[F:0] & {(F + 1) {~vh_cut[F+1]}};
            level_q <= {level_i[S+5:S+4], level_i[S+3:0] & {(S + 4) {~clamped[4]}}};
            dark_q  <= nl_cut[F+1] | ~|nl_cut[F:0] | nv_cut[F+1] | ~|nv_cut[F:0] | nh_cut[F+1] | ~|nh_cut[F:0] | dark_i;
        end
    end
    assign nl_o    = nl_q;
    assign nv_o    = nv_q;
    assign nh_o    = nh_q;
    assign vh_o    = vh_q;
    assign level_o = level_q;
    assign dark_o  = dark_q;

endmodule

`default_nettype wire
