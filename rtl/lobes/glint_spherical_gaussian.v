// glint_spherical_gaussian: exp((n + 0.775)(c - 1)) in fixed point, one result a clock.
//
// The arithmetic is docs/lobes/spherical_gaussian.md; a value here carries the name that it has there.
// Ports and parameters: there too; handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_spherical_gaussian #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter K     = 13,  // fraction bits of a, b and g
    parameter E     = 3,   // address bits of exp2
    parameter S     = 16,  // fraction bits of t and p
    parameter O     = 12,  // fraction bits of the output
    parameter A     = 0,   // a = log2 e at K bits: 1.44
    parameter B     = 0,   // b = 0.775 log2 e at K bits: 1.12
    parameter MULTIPLIER_STAGES = 1,  // clocks of a product
    parameter LATENCY           = 2,  // clocks without those of the divider, and products: what the blocks on the way
    parameter PRODUCTS          = 0,  // add up to, from `glint emit`
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire       [9:0] n_i,      // specular exponent
    input  wire     [F+1:0] cos_i,    // cosine, signed, code / 2^F
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire       [O:0] y_o,      // result, code / 2^O, 0 .. 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o, // an input was out of range and was corrected
    output wire             table_enable_o,
    output wire     [E-1:0] exp2_address_o,
    input  wire [3*S-3*E+5:0] exp2_entry_i
);

    // Clocks: 1 correct, 2 g, 2 product with 1 - c, 7 exp2. Products: n a, g d, two in the parabola.
    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] distance;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_ports #(
        .F                (F),
        .LATENCY          (LATENCY),
        .PRODUCTS         (PRODUCTS),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .TAG_W            (TAG_W)
    ) ports (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .valid_i   (valid_i),
        .ready_o   (ready_o),
        .n_i       (n_i),
        .cos_i     (cos_i),
        .tag_i     (tag_i),
        .valid_o   (valid_o),
        .ready_i   (ready_i),
        .tag_o     (tag_o),
        .clamped_o (clamped_o),
        .advance_o (advance),
        .start_o   (),
        .n_o       (n),
        .cosine_o  (),
        .distance_o(distance),
        .negative_o(negative)
    );
    /* verilator lint_on PINCONNECTEMPTY */
    assign table_enable_o = advance;

    // g = n a + b < 1509 2^K: 11 integer bits.
    localparam [K:0] A_CODE = A;
    localparam [K:0] B_CODE = B;

    wire [K+10:0] product;
    reg  [K+10:0] g_q;
    glint_multiplier #(
        .A_W   (K + 1),
        .B_W   (10),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_a (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (A_CODE),
        .b_i      (n),
        .product_o(product)
    );
    always @(posedge clk_i) begin
        if (advance) begin
            g_q <= product + {10'd0, B_CODE};
        end
    end

    wire [F:0] d;
    glint_delay #(
        .WIDTH (F + 1),
        .STAGES(MULTIPLIER_STAGES + 1)
    ) delay_distance (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (distance),
        .data_o  (d)
    );

    // g d <= g 2^F, also with the half that rounds it below 1509 2^(K+F). t = rnd(g d, K + F - S).
    localparam CUT = K + F - S;

    reg    [S+10:0] t_q;
    /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts; the product's top bit is 0
    wire [K+F+11:0] scaled;
    wire [K+F+10:0] sum = scaled[K+F+10:0] + {{(K + F + 11 - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    glint_multiplier #(
        .A_W   (K + 11),
        .B_W   (F + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_g (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (g_q),
        .b_i      (d),
        .product_o(scaled)
    );

    always @(posedge clk_i) begin
        if (advance) begin
            t_q <= sum[K+F+10:CUT];
        end
    end

    glint_exp2 #(
        .I_W(11),
        .E  (E),
        .S  (S),
        .O  (O),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) exp2 (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .t_i       (t_q),
        .negative_i(negative),
        .address_o (exp2_address_o),
        .entry_i   (exp2_entry_i),
        .y_o       (y_o)
    );

endmodule

`default_nettype wire
