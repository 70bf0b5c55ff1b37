// glint_effect_ambient: the product of a material's and a light's colour, one result a clock.
//
// Contract, ports, latency: docs/effects/ambient.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_ambient #(
    parameter O     = 12,  // fraction bits of the colours
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire       [O:0] k_r_i,    // colour of the material, code / 2^O
    input  wire       [O:0] k_g_i,
    input  wire       [O:0] k_b_i,
    input  wire     [O+3:0] i_r_i,    // colour of the light, code / 2^O
    input  wire     [O+3:0] i_g_i,
    input  wire     [O+3:0] i_b_i,
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire     [O+3:0] r_o,      // code / 2^O
    output wire     [O+3:0] g_o,
    output wire     [O+3:0] b_o,
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o // an input was out of range and was corrected
);

    wire       advance;
    wire [2:0] clamped;
    glint_stream #(
        .LATENCY(3),  // 1 correct, 1 product, 1 round
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

    wire [3*O+2:0]  k = {k_b_i, k_g_i, k_r_i};
    wire [3*O+11:0] i = {i_b_i, i_g_i, i_r_i};
    wire [3*O+11:0] y;
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

            // k <= 2^O, so the product is at most 2^O (2^(O+4) - 1): 2 O + 4 bits; and y at most i: O + 4 bits.
            reg     [O:0] k_q;
            reg   [O+3:0] i_q, y_q;
            reg [2*O+3:0] product_q;
            always @(posedge clk_i) begin
                if (advance) begin
                    k_q       <= k_cut;
                    i_q       <= i[(O+4)*c+:O+4];
                    product_q <= {{(O + 3) {1'b0}}, k_q} * {{O{1'b0}}, i_q};
                    y_q       <= product_q[2*O+3:O] + {{(O + 3) {1'b0}}, product_q[O-1]};
                end
            end
            wire unused = &{1'b0, product_q[O-2:0]};
            assign y[(O+4)*c+:O+4] = y_q;
        end
    endgenerate

endmodule

`default_nettype wire
