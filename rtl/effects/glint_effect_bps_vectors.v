// glint_effect_bps_vectors: the lobe `bps` from two vectors of any length, one result a clock.
//
// Contract, ports, latency: docs/effects/bps_vectors.md; a value here carries the name that it has there. The constants
// A, B, C1, D0 come from the model (`glint emit`).

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_bps_vectors #(
    parameter W                 = 16,  // bits of a component, 8 .. 18
    parameter R                 = 26,  // bits of the root, 16 .. 30
    parameter S                 = 15,  // fraction bits of the quotient
    parameter K                 = 15,  // fraction bits of the constants
    parameter O                 = 12,  // fraction bits of the output; O <= S and O <= K
    parameter MULTIPLIER_STAGES = 1,   // clocks of a product, 1 .. 4
    parameter TAG_W             = 16,  // width of the tag, at least 1
    // The constants of f_bps at K fraction bits. The widths of glint_horner rest on their values.
    parameter signed [K+2:0] A  = 0,
    parameter signed [K+2:0] B  = 0,
    parameter signed [K+2:0] C1 = 0,
    parameter signed [K+2:0] D0 = 0
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
    output wire             clamped_o // n was 0, or a vector is
);

`ifndef SYNTHESIS
    initial begin
        if (B == 0) begin  // the defaults: without its constants the unit would answer 0 to everything
            $display("glint_effect_bps_vectors: parameters A, B, C1, D0 not set; use a wrapper from `glint emit`");
            $finish;
        end
    end
`endif

    localparam CUT    = 7;                               // bits that x and n (r - x) lose before the division
    localparam U      = R - CUT;                         // of C
    localparam FRONT  = 2 * MULTIPLIER_STAGES + 8 + R;   // clocks to r
    localparam RATIO  = MULTIPLIER_STAGES + 1 + S + 1;
    localparam HORNER = 3 * (MULTIPLIER_STAGES + 1);

    wire advance, none_before;
    glint_stream #(
        .LATENCY(FRONT + 1 + RATIO + HORNER),
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

    // ---- p 4^j and s 16^j, then x and r -----------------------------------------------------------------------------
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

    wire [2*R-1:0] radicand;
    wire   [R-1:0] x_first, x, r;
    generate
        if (R > 2 * W) begin : pad
            assign radicand = {s, {(2 * R - 4 * W) {1'b0}}};
            assign x_first  = {p[2*W-1:0], {(R - 2 * W) {1'b0}}};
        end else begin : cut
            assign radicand = s[4*W-1:4*W-2*R];
            assign x_first  = p[2*W-1:2*W-R];
            wire unused = &{1'b0, s, p};  // what has no place
        end
    endgenerate
    /* verilator lint_off PINCONNECTEMPTY */
    glint_sqrt #(
        .Y_W(R)
    ) root (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .radicand_i (radicand),
        .root_o     (r),
        .remainder_o()
    );
    glint_delay #(
        .WIDTH (R),
        .STAGES(R)
    ) delay_x (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (x_first),
        .data_o  (x)
    );

    // ---- the fraction: C / D, D = C + floor(n (r - x) / 2^CUT) ------------------------------------------------------
    // 0 <= x <= r where p is not negative; where it is y is 0 in any case.
    wire   [9:0] n;
    reg  [R-1:0] distance_q;
    reg  [U-1:0] cosine_q;
    always @(posedge clk_i) begin
        if (advance) begin
            distance_q <= r - x;
            cosine_q   <= x[R-1:CUT];
        end
    end
    glint_delay #(
        .WIDTH (10),
        .STAGES(FRONT + 1)
    ) delay_n (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (n_i == 10'd0 ? 10'd1 : n_i),
        .data_o  (n)
    );
    // n (r - x) is below 1023 2^R: R + 10 bits. D is C at least and, with r >= 2^(R-2), never 0; and at most n r / 2^CUT.
    /* verilator lint_off UNUSED */  // what is cut
    wire [R+9:0] weighted;
    /* verilator lint_on UNUSED */
    wire [U-1:0] cosine;
    reg  [U-1:0] numerator_q;
    reg  [U+9:0] complement_q;  // of the divisor: what the rows of a divider add
    glint_multiplier #(
        .A_W   (10),
        .B_W   (R),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (n),
        .b_i      (distance_q),
        .product_o(weighted)
    );
    glint_delay #(
        .WIDTH (U),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_cosine (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (cosine_q),
        .data_o  (cosine)
    );
    always @(posedge clk_i) begin
        if (advance) begin
            numerator_q  <= cosine;
            complement_q <= ~(weighted[R+9:CUT] + {10'd0, cosine});
        end
    end
    wire [S:0] quotient;
    glint_divider #(
        .X_W(U + S),
        .Y_W(U + 10),
        .Q_W(S + 1)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .start_i    (1'b0),
        .dividend_i ({numerator_q, {S{1'b0}}}),
        .divisor_i  (~complement_q),
        .beside_i   (1'b0),
        .done_o     (),
        .quotient_o (quotient),
        .remainder_o(),
        .beside_o   ()
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // ---- the cubic, 0 where p is negative or a vector is 0 -----------------------------------------------------------
    wire dark, none;
    glint_delay #(
        .WIDTH (2),
        .STAGES(R + 1 + RATIO + HORNER - 1)
    ) delay_dark (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  ({p[2*W] | zero, zero}),
        .data_o  ({dark, none})
    );
    reg none_q;
    always @(posedge clk_i) if (advance) none_q <= none;
    assign clamped_o = none_before | none_q;
    glint_horner #(
        .S                (S),
        .K                (K),
        .O                (O),
        .I                (2),
        .DEGREE           (3),
        .CLAMP            (0),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .COEFFICIENTS     ({A, B, C1, D0})
    ) horner (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .start_i   (1'b0),
        .quotient_i(quotient),
        .negative_i(dark),
        .y_o       (y_o)
    );

endmodule

`default_nettype wire
