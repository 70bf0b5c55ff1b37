// sphere: a lit, turning sphere at 640 x 480, a pixel a clock, from no memory but the units' tables.
//
// The beam's place becomes a ray, the ray a normal, the normal a colour; every number: README.md. The marks of the picture
// travel with the pixels through the units.

`default_nettype none

module sphere #(
    parameter BITS = 8  // bits of a colour, 2 .. 8
) (
    input  wire            clk_i,        // pixel clock: 25 MHz gives 59.5 pictures a second
    input  wire            rst_ni,       // synchronous, active low
    input  wire            next_i,       // a button, 1 while pressed: the next material
    input  wire            hold_turn_i,  // the sphere stands still
    input  wire            hold_light_i, // the light stands still
    output wire            hsync_o,      // active low
    output wire            vsync_o,      // active low
    output wire            visible_o,
    output wire [BITS-1:0] r_o,          // 0 outside of the picture
    output wire [BITS-1:0] g_o,
    output wire [BITS-1:0] b_o
);

    // ---- the ray: does it hit, and how near to the viewer ------------------------------------------------------------
    // Two beams: one where rays start, one where their depth is known: 1 clock to rest, 15 to z.
    localparam DEPTH_CLOCKS = 16;
    wire signed [10:0] x_first, y_first, x, y;
    wire               line_end, hsync, vsync, visible, tick;
    /* verilator lint_off PINCONNECTEMPTY */
    sphere_beam first (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .x_o       (x_first),
        .y_o       (y_first),
        .hsync_o   (),
        .vsync_o   (),
        .visible_o (),
        .line_end_o(line_end),
        .tick_o    ()
    );
    sphere_beam #(
        .LATE(DEPTH_CLOCKS)
    ) beam (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .x_o       (x),
        .y_o       (y),
        .hsync_o   (hsync),
        .vsync_o   (vsync),
        .visible_o (visible),
        .line_end_o(),
        .tick_o    (tick)
    );

    // s = x^2 + y^2, a step at a time: at most 959^2 + 569^2, 21 bits. x, y, s stand side by side.
    localparam [20:0] CORNER = 639 * 639 + 479 * 479;
    reg  [20:0] s_q, line_q;  // line_q: at the start of this line
    wire [20:0] line_next = y_first == -11'sd569 ? CORNER : line_q - {{8{y_first[10]}}, y_first, 2'd0} + 21'd4;
    always @(posedge clk_i) begin
        if (!rst_ni) begin
            s_q    <= CORNER;
            line_q <= CORNER;
        end else if (line_end) begin
            s_q    <= line_next;
            line_q <= line_next;
        end else begin
            s_q <= s_q + {{8{x_first[10]}}, x_first, 2'd0} + 21'd4;
        end
    end

    // The radius is 2^11 / 5, so z = sqrt(2^22 - 25 s) / 2^11; 25 s has 26 bits.
    reg signed [26:0] rest_q;
    always @(posedge clk_i) rest_q <= 27'sd4194304 - 27'sd25 * {6'd0, s_q};
    wire [14:0] z;
    wire        hit;
    glint_sqrt #(
        .Y_W(15)
    ) depth (
        .clk_i      (clk_i),
        .enable_i   (1'b1),
        .radicand_i ({rest_q[21:0], 8'd0}),
        .root_o     (z),
        .remainder_o()
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(15)
    ) delay_hit (
        .clk_i   (clk_i),
        .enable_i(1'b1),
        .data_i  (~rest_q[26]),
        .data_o  (hit)
    );

    // ---- once a picture: buttons, the turn, the light -----------------------------------------------------------------
    // The buttons are looked at 60 times a second, which is slower than they bounce.
    reg [2:0] buttons_q, buttons_q2;
    reg       pressed_q;
    reg [1:0] material_q;
    always @(posedge clk_i) begin
        buttons_q  <= {next_i, hold_turn_i, hold_light_i};
        buttons_q2 <= buttons_q;
        if (!rst_ni) begin
            pressed_q  <= 1'b0;
            material_q <= 2'd0;
        end else if (tick) begin
            pressed_q <= buttons_q2[2];
            if (buttons_q2[2] & ~pressed_q) material_q <= material_q + 2'd1;
        end
    end
    wire signed [15:0] turn_cos, turn_sin, half_x, half_y;
    sphere_turn #(
        .SHIFT(6),
        .X0   (16'sd32600),
        .Y0   (16'sd0)
    ) turn (
        .clk_i (clk_i),
        .rst_ni(rst_ni),
        .step_i(tick & ~buttons_q2[1]),
        .x_o   (turn_cos),
        .y_o   (turn_sin)
    );
    // H is at a distance of sqrt(1 - (7/8)^2) from the axis; it starts at the upper left.
    sphere_turn #(
        .SHIFT(7),
        .X0   (-16'sd9973),
        .Y0   (16'sd12337)
    ) light (
        .clk_i (clk_i),
        .rst_ni(rst_ni),
        .step_i(tick & ~buttons_q2[0]),
        .x_o   (half_x),
        .y_o   (half_y)
    );

    // ---- the pattern, and the point in light --------------------------------------------------------------------------
    wire dark;
    sphere_checker pattern (
        .clk_i (clk_i),
        .x_i   (x),
        .y_i   (y),
        .z_i   (z),
        .cos_i (turn_cos[15:6]),
        .sin_i (turn_sin[15:6]),
        .dark_o(dark)
    );
    wire [15:0] r_lit, g_lit, b_lit;
    wire        hit_lit, hsync_lit, vsync_lit, visible_lit;
    sphere_pixel #(
        .TAG_W(4)
    ) pixel (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .x_i       (x),
        .y_i       (y),
        .z_i       (z),
        .half_x_i  (half_x),
        .half_y_i  (half_y),
        .material_i(material_q),
        .tag_i     ({hit, hsync, vsync, visible}),
        .dark_i    (dark),
        .r_o       (r_lit),
        .g_o       (g_lit),
        .b_o       (b_lit),
        .tag_o     ({hit_lit, hsync_lit, vsync_lit, visible_lit})
    );

    // ---- to the screen: a square root, near the inverse of a screen's curve; a dark blue behind the sphere --------------
    wire       [47:0] linear = hit_lit ? {b_lit, g_lit, r_lit} : {16'd1280, 16'd768, 16'd512};
    wire        [2:0] marks;
    wire [3*BITS-1:0] colour;
    genvar c;
    generate
        for (c = 0; c < 3; c = c + 1) begin : channel
            wire [15:0] radicand = linear[16*c+:16];
            wire        unused   = &{1'b0, radicand};
            glint_sqrt #(
                .Y_W(BITS)
            ) curve (
                .clk_i      (clk_i),
                .enable_i   (1'b1),
                .radicand_i (radicand[15-:2*BITS]),
                .root_o     (colour[BITS*c+:BITS]),
                .remainder_o()
            );
        end
    endgenerate
    /* verilator lint_on PINCONNECTEMPTY */
    glint_delay #(
        .WIDTH (3),
        .STAGES(BITS)
    ) delay_marks (
        .clk_i   (clk_i),
        .enable_i(1'b1),
        .data_i  ({~hsync_lit, ~vsync_lit, visible_lit}),
        .data_o  (marks)
    );
    assign {hsync_o, vsync_o, visible_o} = marks;
    assign {b_o, g_o, r_o}               = colour & {3 * BITS{visible_o}};
    wire unused = &{1'b0, rest_q[25:22], turn_cos[5:0], turn_sin[5:0]};

endmodule

`default_nettype wire
