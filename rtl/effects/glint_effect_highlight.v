// glint_effect_highlight: what makes of a lobe's unit the effects phong and blinn_phong: no light from behind the surface.
//
// Stands around the lobe's stream: the lobe's tag carries whether the surface faces the light, and `clamped`. No clock.
// Contract, ports, latency: docs/effects/phong.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_highlight #(
    parameter F     = 18,  // fraction bits of the dot products
    parameter O     = 12,  // fraction bits of the output
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire       [9:0] n_i,        // specular exponent
    input  wire     [F+1:0] cos_i,      // the lobe's cosine, signed, code / 2^F
    input  wire     [F+1:0] nl_i,       // N.L, signed, code / 2^F
    input  wire [TAG_W-1:0] tag_i,
    output wire [TAG_W+1:0] lobe_tag_o,
    input  wire       [O:0] lobe_y_i,
    input  wire [TAG_W+1:0] lobe_tag_i,
    output wire       [O:0] y_o,        // code / 2^O, 0 .. 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o   // an input was out of range and was corrected
);

    // The lobe corrects what it gets by itself; only whether anything was corrected is not for it to say: a cosine from -1
    // to 0 is legal here.
    wire         nl_clamped, cos_clamped;
    wire [F+1:0] nl_cut, cos_cut;
    glint_dot #(
        .F(F)
    ) nl (
        .dot_i    (nl_i),
        .dot_o    (nl_cut),
        .clamped_o(nl_clamped)
    );
    glint_dot #(
        .F(F)
    ) cosine (
        .dot_i    (cos_i),
        .dot_o    (cos_cut),
        .clamped_o(cos_clamped)
    );
    wire unused = &{1'b0, nl_cut, cos_cut};

    wire facing;
    assign lobe_tag_o                 = {~nl_i[F+1] & (|nl_i[F:0]), nl_clamped | cos_clamped | ~|n_i, tag_i};
    assign {facing, clamped_o, tag_o} = lobe_tag_i;
    assign y_o                        = lobe_y_i & {(O + 1) {facing}};

endmodule

`default_nettype wire
