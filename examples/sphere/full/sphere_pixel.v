// sphere_pixel, the full one: a lit point of the sphere by glint_effect_pixel with `bps`, at p12, from the vectors N, L, V.
//
// Ambient light, lambert, blinn_phong. H circles round the view axis with H.z = 7/8; L = 2 (H.V) H - V. Numbers: README.md.

`default_nettype none

module sphere_pixel #(
    parameter TAG_W = 4
) (
    input  wire               clk_i,
    input  wire               rst_ni,      // synchronous, active low
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

    wire signed [10:0] x, y;
    wire        [14:0] z;
    wire   [TAG_W-1:0] tag;
    glint_delay #(
        .WIDTH (37 + TAG_W),
        .STAGES(5)
    ) delay_point (
        .clk_i   (clk_i),
        .enable_i(1'b1),
        .data_i  ({x_i, y_i, z_i, tag_i}),
        .data_o  ({x, y, z, tag})
    );

    // On the sphere N fits; elsewhere nothing reads it. L is 7/4 H across, and 17/32 along the axis.
    wire [15:0] normal_x = 16'd80 * {{5{x[10]}}, x};
    wire [15:0] normal_y = 16'd80 * {{5{y[10]}}, y};
    wire signed [18:0] seven_x = 19'sd7 * {{3{half_x_i[15]}}, half_x_i};
    wire signed [18:0] seven_y = 19'sd7 * {{3{half_y_i[15]}}, half_y_i};
    reg         [15:0] light_x_q, light_y_q;
    always @(posedge clk_i) begin
        light_x_q <= seven_x[17:2];
        light_y_q <= seven_y[17:2];
    end

    wire  [9:0] n;
    wire [26:0] kd, ks;
    sphere_material material (
        .material_i(material_i),
        .dark_i    (dark_i),
        .n_o       (n),
        .kd_o      (kd),
        .ks_o      (ks)
    );

    // Nothing ever waits: one pixel a clock, of which fewer than 2^7 are inside. White light; 1/16 comes from everywhere.
    wire [12:0] r, g, b;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_effect_pixel_bps_p12 #(
        .TAG_W    (TAG_W),
        .MASK     (8'd11),
        .LOG_DEPTH(7)
    ) pixel (
        .clk_i        (clk_i),
        .rst_ni       (rst_ni),
        .valid_i      (1'b1),
        .ready_o      (),
        .effects_i    (8'd11),
        .light_x_i    (light_x_q),
        .light_y_i    (light_y_q),
        .light_z_i    (16'd17408),
        .view_x_i     (16'd0),
        .view_y_i     (16'd0),
        .view_z_i     (16'd32767),
        .normal_x_i   (normal_x),
        .normal_y_i   (normal_y),
        .normal_z_i   ({1'b0, z}),
        .tangent_x_i  (16'd0),
        .tangent_y_i  (16'd0),
        .tangent_z_i  (16'd0),
        .bitangent_x_i(16'd0),
        .bitangent_y_i(16'd0),
        .bitangent_z_i(16'd0),
        .n_i          (n),
        .oren_nayar_a_i                 (15'd0),
        .oren_nayar_b_i                 (15'd0),
        .ward_kx_i                      (19'd0),
        .ward_ky_i                      (19'd0),
        .ward_log_peak_i                (21'd0),
        .cook_torrance_falloff_i        (22'd0),
        .cook_torrance_level_i          (22'd0),
        .cook_torrance_excess_i         (16'd0),
        .cook_torrance_modified_level_i (22'd0),
        .cook_torrance_modified_stretch_i(18'd0),
        .cook_torrance_modified_c0_i    (21'd0),
        .cook_torrance_modified_c1_i    (21'd0),
        .cook_torrance_modified_c2_i    (21'd0),
        .cook_torrance_modified_c3_i    (21'd0),
        .ka_r_i       ({kd[8:0], 4'd0}),
        .ka_g_i       ({kd[17:9], 4'd0}),
        .ka_b_i       ({kd[26:18], 4'd0}),
        .ia_r_i       (16'd256),
        .ia_g_i       (16'd256),
        .ia_b_i       (16'd256),
        .kd_r_i       ({kd[8:0], 4'd0}),
        .kd_g_i       ({kd[17:9], 4'd0}),
        .kd_b_i       ({kd[26:18], 4'd0}),
        .ks_r_i       ({ks[8:0], 4'd0}),
        .ks_g_i       ({ks[17:9], 4'd0}),
        .ks_b_i       ({ks[26:18], 4'd0}),
        .i_r_i        (16'd4096),
        .i_g_i        (16'd4096),
        .i_b_i        (16'd4096),
        .tag_i        (tag),
        .valid_o      (),
        .ready_i      (1'b1),
        .r_o          (r),
        .g_o          (g),
        .b_o          (b),
        .tag_o        (tag_o),
        .clamped_o    ()
    );
    /* verilator lint_on PINCONNECTEMPTY */

    assign r_o = {r[11:0] | {12{r[12]}}, 4'd0};
    assign g_o = {g[11:0] | {12{g[12]}}, 4'd0};
    assign b_o = {b[11:0] | {12{b[12]}}, 4'd0};
    wire unused = &{1'b0, seven_x[18], seven_x[1:0], seven_y[18], seven_y[1:0]};

endmodule

`default_nettype wire
