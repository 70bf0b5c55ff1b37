// sphere_pixel, the small one: a lit point of the sphere by lambert and blinn_phong with `decay`, all at p8.
//
// The viewer is far away and the light circles round the view axis, so H does, too: H.z = 7/8. L = 2 (H.V) H - V, so
// N.L = 7/4 N.H - N.V, and one dot product makes both. Numbers: README.md.

`default_nettype none

module sphere_pixel #(
    parameter TAG_W = 4
) (
    input  wire               clk_i,
    input  wire               rst_ni,
    input  wire signed [10:0] x_i,         // half pixels from the middle, right and up; N is 80 (x, y) and z / 2^15
    input  wire signed [10:0] y_i,
    input  wire        [14:0] z_i,
    input  wire signed [15:0] half_x_i,    // H, code / 2^15; still during a picture
    input  wire signed [15:0] half_y_i,
    input  wire         [1:0] material_i,
    input  wire   [TAG_W-1:0] tag_i,
    input  wire               dark_i,      // 5 clocks later: which field of the pattern
    output wire        [15:0] r_o,         // linear, code / 2^16; 1.0 is cut
    output wire        [15:0] g_o,
    output wire        [15:0] b_o,
    output wire   [TAG_W-1:0] tag_o
);

    localparam FIELD_W = TAG_W + 3;  // beside a pixel: what it is of
    wire   [TAG_W-1:0] tag0;
    wire [FIELD_W-1:0] field0 = {material_i, dark_i, tag0};
    glint_delay #(
        .WIDTH (TAG_W),
        .STAGES(5)
    ) delay_tag (
        .clk_i   (clk_i),
        .enable_i(1'b1),
        .data_i  (tag_i),
        .data_o  (tag0)
    );

    // H at 13 fraction bits, x and y in units of 80 / 2^15: a product has 25 bits; the sum of two, and w, fit 27 on the sphere.
    wire signed [24:0] fx, fy;
    sphere_product #(
        .A_W(14),
        .B_W(11)
    ) product_x (
        .clk_i    (clk_i),
        .a_i      (half_x_i[15:2]),
        .b_i      (x_i),
        .product_o(fx)
    );
    sphere_product #(
        .A_W(14),
        .B_W(11)
    ) product_y (
        .clk_i    (clk_i),
        .a_i      (half_y_i[15:2]),
        .b_i      (y_i),
        .product_o(fy)
    );
    // z beside the sum of both products, and beside w.
    wire        [14:0] z_f;
    reg         [14:0] z_w_q;
    reg signed  [25:0] f_q;
    reg signed  [26:0] w_q;
    glint_delay #(
        .WIDTH (15),
        .STAGES(3)
    ) delay_z (
        .clk_i   (clk_i),
        .enable_i(1'b1),
        .data_i  (z_i),
        .data_o  (z_f)
    );
    always @(posedge clk_i) begin
        f_q   <= {fx[24], fx} + {fy[24], fy};
        w_q   <= 27'sd5 * {f_q[25], f_q} + 27'sd448 * {12'd0, z_f};
        z_w_q <= z_f;
    end

    // w is N.H at 24 fraction bits: nh = rnd(w, 8), nl = rnd(7 w - 2^11 z, 10).
    reg signed [26:0] nh_q;
    reg signed [29:0] nl_q;
    always @(posedge clk_i) begin
        nh_q <= w_q + 27'sd128;
        nl_q <= 30'sd7 * {{3{w_q[26]}}, w_q} - {4'd0, z_w_q, 11'd0} + 30'sd512;
    end

    // Nothing ever waits: every unit takes a pixel a clock.
    wire       [17:0] nl1, nh1;
    wire        [8:0] lambert1;
    wire [FIELD_W-1:0] field1;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_effect_lambert_p8 #(
        .TAG_W(36 + FIELD_W)
    ) lambert (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (1'b1),
        .ready_o  (),
        .nl_i     (nl_q[27:10]),
        .tag_i    ({nl_q[27:10], nh_q[25:8], field0}),
        .valid_o  (),
        .ready_i  (1'b1),
        .y_o      (lambert1),
        .tag_o    ({nl1, nh1, field1}),
        .clamped_o()
    );

    wire [9:0] n;
    sphere_material material_n (
        .material_i(field1[FIELD_W-1:FIELD_W-2]),
        .dark_i    (1'b0),
        .n_o       (n),
        .kd_o      (),
        .ks_o      ()
    );
    wire [FIELD_W+10:0] lobe_tag_in, lobe_tag_out;
    wire          [8:0] lobe_y, lambert2, highlight2;
    wire  [FIELD_W-1:0] field2;
    glint_effect_highlight #(
        .F    (16),
        .O    (8),
        .TAG_W(FIELD_W + 9)
    ) highlight (
        .n_i       (n),
        .cos_i     (nh1),
        .nl_i      (nl1),
        .tag_i     ({lambert1, field1}),
        .lobe_tag_o(lobe_tag_in),
        .lobe_y_i  (lobe_y),
        .lobe_tag_i(lobe_tag_out),
        .y_o       (highlight2),
        .tag_o     ({lambert2, field2}),
        .clamped_o ()
    );
    glint_decay_p8 #(
        .TAG_W(FIELD_W + 11)
    ) lobe (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (1'b1),
        .ready_o  (),
        .n_i      (n),
        .cos_i    (nh1),
        .tag_i    (lobe_tag_in),
        .valid_o  (),
        .ready_i  (1'b1),
        .y_o      (lobe_y),
        .tag_o    (lobe_tag_out),
        .clamped_o()
    );

    // White light; 1/16 of it comes from everywhere.
    wire        [26:0] kd, ks;
    wire         [8:0] highlight3;
    wire [FIELD_W-1:0] field3;
    wire        [15:0] r3, g3, b3, r4, g4, b4;
    wire        [26:0] diffuse4;
    sphere_material material_kd (
        .material_i(field2[FIELD_W-1:FIELD_W-2]),
        .dark_i    (field2[FIELD_W-3]),
        .n_o       (),
        .kd_o      (kd),
        .ks_o      ()
    );
    glint_effect_tint_p8 #(
        .TAG_W(9 + FIELD_W)
    ) diffuse (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (1'b1),
        .ready_o  (),
        .s_i      ({7'd0, lambert2} + 16'd16),
        .k_r_i    (kd[8:0]),
        .k_g_i    (kd[17:9]),
        .k_b_i    (kd[26:18]),
        .i_r_i    (12'd256),
        .i_g_i    (12'd256),
        .i_b_i    (12'd256),
        .tag_i    ({highlight2, field2}),
        .valid_o  (),
        .ready_i  (1'b1),
        .r_o      (r3),
        .g_o      (g3),
        .b_o      (b3),
        .tag_o    ({highlight3, field3}),
        .clamped_o()
    );
    sphere_material material_ks (
        .material_i(field3[FIELD_W-1:FIELD_W-2]),
        .dark_i    (1'b0),
        .n_o       (),
        .kd_o      (),
        .ks_o      (ks)
    );
    // Diffuse light is at most 1 + 1/16: 9 bits.
    glint_effect_tint_p8 #(
        .TAG_W(27 + TAG_W)
    ) specular (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (1'b1),
        .ready_o  (),
        .s_i      ({7'd0, highlight3}),
        .k_r_i    (ks[8:0]),
        .k_g_i    (ks[17:9]),
        .k_b_i    (ks[26:18]),
        .i_r_i    (12'd256),
        .i_g_i    (12'd256),
        .i_b_i    (12'd256),
        .tag_i    ({b3[8:0], g3[8:0], r3[8:0], field3[TAG_W-1:0]}),
        .valid_o  (),
        .ready_i  (1'b1),
        .r_o      (r4),
        .g_o      (g4),
        .b_o      (b4),
        .tag_o    ({diffuse4, tag_o}),
        .clamped_o()
    );
    /* verilator lint_on PINCONNECTEMPTY */

    function [7:0] cut(input [8:0] a, input [8:0] b);
        reg [9:0] sum;
        begin
            sum = {1'b0, a} + {1'b0, b};
            cut = sum[7:0] | {8{|sum[9:8]}};
        end
    endfunction
    assign r_o = {cut(diffuse4[8:0], r4[8:0]), 8'd0};
    assign g_o = {cut(diffuse4[17:9], g4[8:0]), 8'd0};
    assign b_o = {cut(diffuse4[26:18], b4[8:0]), 8'd0};
    wire unused = &{1'b0, nl_q[29:28], nl_q[9:0], nh_q[26], nh_q[7:0], field3[TAG_W], r3[15:9], g3[15:9], b3[15:9],
        r4[15:9], g4[15:9], b4[15:9], half_x_i[1:0], half_y_i[1:0]};

endmodule

`default_nettype wire
