// glint_effect_tint for Lattice ECP5: a term times the colours of material and light, one result a clock, saturating.
//
// It takes the place of rtl/effects/glint_effect_tint.v in a list of files: same ports, parameters, bits and clocks, in
// multiplier blocks with registers inside. Contract: docs/effects/tint.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_tint #(
    parameter O     = 12,  // fraction bits of the term and of the colours
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire     [O+7:0] s_i,      // term, code / 2^O
    input  wire       [O:0] k_r_i,    // colour of the material, code / 2^O
    input  wire       [O:0] k_g_i,
    input  wire       [O:0] k_b_i,
    input  wire     [O+3:0] i_r_i,    // colour of the light, code / 2^O
    input  wire     [O+3:0] i_g_i,
    input  wire     [O+3:0] i_b_i,
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire     [O+7:0] r_o,      // code / 2^O
    output wire     [O+7:0] g_o,
    output wire     [O+7:0] b_o,
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o // an input was out of range and was corrected
);

    wire       advance;
    wire [2:0] clamped;
    glint_stream #(
        .LATENCY(4),  // 1 correct and colour, 2 product, 1 round and saturate
        .TAG_W  (TAG_W)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .clamped_i(|clamped),
        .tag_i    (tag_i),
        .valid_o  (valid_o),
        .ready_i  (ready_i),
        .tag_o    (tag_o),
        .clamped_o(clamped_o),
        .advance_o(advance)
    );

    reg [O+7:0] s_q;  // beside the colours
    always @(posedge clk_i) begin
        if (advance) s_q <= s_i;
    end

    wire [3*O+2:0]  k = {k_b_i, k_g_i, k_r_i};
    wire [3*O+11:0] i = {i_b_i, i_g_i, i_r_i};
    wire [3*O+23:0] y;
    assign {b_o, g_o, r_o} = y;

    genvar c;
    generate
        for (c = 0; c < 3; c = c + 1) begin : channel
            wire [O:0] k_cut;
            glint_colour #(
                .O(O)
            ) colour (
                .k_i      (k[(O+1)*c+:O+1]),
                .k_o      (k_cut),
                .clamped_o(clamped[c])
            );

            // k <= 2^O, so k i is at most 2^O (2^(O+4) - 1): 2 O + 4 bits; times s below 2^(O+8) it has 3 O + 12 bits. The
            // rounded quotient by 2^(2 O) is at most 2^(O+12) - 2^(O+4) - 2^8 + 1 (s and i at their tops): O + 12 bits.
            wire  [2*O+4:0] colour_product;
            glint_multiplier #(
                .A_W   (O + 1),
                .B_W   (O + 4),
                .STAGES(1)
            ) multiplier_colour (
                .clk_i    (clk_i),
                .enable_i (advance),
                .a_i      (k_cut),
                .b_i      (i[(O+4)*c+:O+4]),
                .product_o(colour_product)
            );
            wire [3*O+11:0] product;
            glint_multiplier #(
                .A_W   (2 * O + 4),
                .B_W   (O + 8),
                .STAGES(2)
            ) multiplier_product (
                .clk_i    (clk_i),
                .enable_i (advance),
                .a_i      (colour_product[2*O+3:0]),
                .b_i      (s_q),
                .product_o(product)
            );
            wire   [O+11:0] rounded = product[3*O+11:2*O] + {{(O + 11) {1'b0}}, product[2*O-1]};
            reg     [O+7:0] y_q;
            always @(posedge clk_i) begin
                if (advance) y_q <= rounded[O+7:0] | {(O + 8) {|rounded[O+11:O+8]}};
            end
            wire unused = &{1'b0, colour_product[2*O+4], product[2*O-2:0]};
            assign y[(O+8)*c+:O+8] = y_q;
        end
    endgenerate

endmodule

`default_nettype wire
