// glint_effect_blinn_phong_vectors: c^n from two vectors of any length, by two logarithms, one result a clock.
//
// Contract, ports, latency: docs/effects/blinn_phong_vectors.md; a value here carries the name that it has there. The tables
// are beside the unit: an entry comes one clock with table_enable_o after its address.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_blinn_phong_vectors #(
    parameter W                 = 16,  // bits of a component, 8 .. 18
    parameter T                 = 7,   // address bits of log2
    parameter L                 = 27,  // fraction bits of up, us and w
    parameter E                 = 3,   // address bits of exp2
    parameter S                 = 16,  // fraction bits of t
    parameter O                 = 12,  // fraction bits of the output
    parameter MULTIPLIER_STAGES = 1,   // clocks of a product, 1 .. 4
    parameter TAG_W             = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire     [W-1:0] a_x_i,    // the first vector, signed
    input  wire     [W-1:0] a_y_i,
    input  wire     [W-1:0] a_z_i,
    input  wire     [W-1:0] b_x_i,    // the second
    input  wire     [W-1:0] b_y_i,
    input  wire     [W-1:0] b_z_i,
    input  wire       [9:0] n_i,      // specular exponent
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire       [O:0] y_o,      // result, code / 2^O, 0 .. 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o, // n was 0, or a vector is
    output wire             table_enable_o,
    output wire     [T-1:0] log2_p_address_o,
    input  wire [3*L-3*T+2:0] log2_p_entry_i,
    output wire     [T-1:0] log2_s_address_o,
    input  wire [3*L-3*T+2:0] log2_s_entry_i,
    output wire     [E-1:0] exp2_address_o,
    input  wire [3*S-3*E+5:0] exp2_entry_i
);

    localparam FRONT = 2 * MULTIPLIER_STAGES + 8;              // clocks to p 4^j and s 16^j,
    localparam LOG   = 2 * MULTIPLIER_STAGES + 6;              // of a logarithm,
    localparam POWER = 2 * MULTIPLIER_STAGES + 5;              // of exp2
    localparam AFTER = LOG + 1 + MULTIPLIER_STAGES + 1 + POWER;  // of all that follows the first

    wire advance, none_before;
    glint_stream #(
        .LATENCY(FRONT + AFTER),
        .TAG_W  (TAG_W)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .clamped_i(~|n_i),
        .tag_i    (tag_i),
        .valid_o  (valid_o),
        .ready_i  (ready_i),
        .tag_o    (tag_o),
        .clamped_o(none_before),
        .advance_o(advance)
    );
    assign table_enable_o = advance;

    wire   [2*W:0] p;
    wire [4*W-1:0] s;
    wire           zero;  // a vector is 0
    glint_vectors #(
        .W                (W),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) vectors (
        .clk_i   (clk_i),
        .enable_i(advance),
        .a_i     ({a_x_i, a_y_i, a_z_i}),
        .b_i     ({b_x_i, b_y_i, b_z_i}),
        .p_o     (p),
        .s_o     (s),
        .none_o  (zero)
    );

    // ---- cp = floor(p 4^j 2^(L-2W)), cs = floor(s 16^j 2^(L+2-4W)): below 1 of their fraction bits --------------------
    localparam FP = L;
    localparam FS = L + 2;
    wire [FP:0] cp;
    wire [FS:0] cs;
    generate
        if (FP > 2 * W) begin : pad_p
            assign cp = {1'b0, p[2*W-1:0], {(FP - 2 * W) {1'b0}}};
        end else begin : cut_p
            assign cp = {1'b0, p[2*W-1:2*W-FP]};
            wire unused = &{1'b0, p};  // what has no place
        end
        if (FS > 4 * W) begin : pad_s
            assign cs = {1'b0, s, {(FS - 4 * W) {1'b0}}};
        end else begin : cut_s
            assign cs = {1'b0, s[4*W-1:4*W-FS]};
            wire unused = &{1'b0, s};
        end
    endgenerate

    wire [L+4:0] up, us;
    glint_log2 #(
        .F  (FP),
        .T  (T),
        .L  (L),
        .CUT(1),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) log2_p (
        .clk_i    (clk_i),
        .enable_i (advance),
        .cosine_i (cp),
        .address_o(log2_p_address_o),
        .entry_i  (log2_p_entry_i),
        .u_o      (up)
    );
    glint_log2 #(
        .F  (FS),
        .T  (T),
        .L  (L),
        .CUT(3),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) log2_s (
        .clk_i    (clk_i),
        .enable_i (advance),
        .cosine_i (cs),
        .address_o(log2_s_address_o),
        .entry_i  (log2_s_entry_i),
        .u_o      (us)
    );

    // ---- w = max(0, 2 up - us), below 2^6; t = rnd(n w, L + 1 - S) ------------------------------------------------------
    localparam CUT = L + 1 - S;
    wire [L+6:0] difference = {1'b0, up, 1'b0} - {2'b00, us};
    wire   [9:0] n;
    reg  [L+5:0] w_q;
    wire [L+15:0] product;
    reg  [S+14:0] t_q;
    glint_delay #(
        .WIDTH (10),
        .STAGES(FRONT + LOG + 1)
    ) delay_n (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (n_i == 10'd0 ? 10'd1 : n_i),
        .data_o  (n)
    );
    glint_multiplier #(
        .A_W   (L + 6),
        .B_W   (10),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (w_q),
        .b_i      (n),
        .product_o(product)
    );
    /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts
    wire [L+15:0] sum = product + {{(L + 16 - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    always @(posedge clk_i) begin
        if (advance) begin
            w_q <= difference[L+5:0] & {(L + 6) {~difference[L+6]}};
            t_q <= sum[L+15:CUT];
        end
    end

    // ---- y = 2^-t, 0 where p is negative or a vector is 0 ---------------------------------------------------------------
    wire dark, none;
    glint_delay #(
        .WIDTH (2),
        .STAGES(AFTER - 1)
    ) delay_dark (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  ({p[2*W] | zero, zero}),
        .data_o  ({dark, none})
    );
    reg none_q;
    always @(posedge clk_i) if (advance) none_q <= none;
    assign clamped_o = none_before | none_q;

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
        .negative_i(dark),
        .address_o (exp2_address_o),
        .entry_i   (exp2_entry_i),
        .y_o       (y_o)
    );

endmodule

`default_nettype wire
