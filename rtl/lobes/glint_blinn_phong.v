// glint_blinn_phong: c^n as exp2(n log2 c) in fixed point, one result a clock.
//
// The arithmetic is docs/lobes/blinn_phong.md; a value here carries the name that it has there.
// Ports and parameters: there too; handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_blinn_phong #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter T     = 5,   // address bits of log2
    parameter L     = 25,  // fraction bits of u
    parameter E     = 3,   // address bits of exp2
    parameter S     = 16,  // fraction bits of t and p
    parameter O     = 12,  // fraction bits of the output
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
    output wire     [T-1:0] log2_address_o,
    input  wire [3*L-3*T+2:0] log2_entry_i,
    output wire     [E-1:0] exp2_address_o,
    input  wire [3*S-3*E+5:0] exp2_entry_i
);

    // Clocks: 1 correct, 8 log2, 2 product with n, 7 exp2. Products: two in each parabola, n u.
    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] cosine;
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
        .cosine_o  (cosine),
        .distance_o(),
        .negative_o(negative)
    );
    /* verilator lint_on PINCONNECTEMPTY */
    assign table_enable_o = advance;

    wire [L+4:0] u;
    glint_log2 #(
        .F(F),
        .T(T),
        .L(L),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) log2 (
        .clk_i    (clk_i),
        .enable_i (advance),
        .cosine_i (cosine),
        .address_o(log2_address_o),
        .entry_i  (log2_entry_i),
        .u_o      (u)
    );

    wire [9:0] n_late;
    glint_delay #(
        .WIDTH (10),
        .STAGES(2 * MULTIPLIER_STAGES + 6)
    ) delay_n (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (n),
        .data_o  (n_late)
    );

    // n u <= 1023 * 31 * 2^L = 31713 2^L, also with the half that rounds it: 15 integer bits. t = rnd(n u, L - S).
    localparam CUT = L - S;

    wire [L+14:0] product;
    reg  [S+14:0] t_q;
    glint_multiplier #(
        .A_W   (L + 5),
        .B_W   (10),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (u),
        .b_i      (n_late),
        .product_o(product)
    );
    /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts
    wire [L+14:0] sum = product + {{(L + 15 - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    always @(posedge clk_i) begin
        if (advance) begin
            t_q <= sum[L+14:CUT];
        end
    end

    glint_exp2 #(
        .I_W(15),
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
