// icebreaker: the sphere on an iCEBreaker, at the DVI module of 12 bits. Pins: icebreaker.pcf.

`default_nettype none

module icebreaker (
    input  wire       clk_12mhz,
    input  wire       btn_next_n,
    input  wire       btn_hold_turn,
    input  wire       btn_hold_light,
    output wire       dvi_clk,
    output wire       dvi_hsync,
    output wire       dvi_vsync,
    output wire       dvi_de,
    output wire [3:0] dvi_r,
    output wire [3:0] dvi_g,
    output wire [3:0] dvi_b
);

    // 12 MHz * 67 / 32 = 25.125 MHz: 59.8 pictures a second.
    wire clk, locked;
    SB_PLL40_PAD #(
        .FEEDBACK_PATH("SIMPLE"),
        .DIVR         (4'd0),
        .DIVF         (7'd66),
        .DIVQ         (3'd5),
        .FILTER_RANGE (3'd1)
    ) pll (
        .PACKAGEPIN   (clk_12mhz),
        .PLLOUTGLOBAL (clk),
        .LOCK         (locked),
        .RESETB       (1'b1),
        .BYPASS       (1'b0)
    );
    reg rst_n_q, rst_n_q2;
    always @(posedge clk) {rst_n_q2, rst_n_q} <= {rst_n_q, locked};

    wire       hsync, vsync, visible;
    wire [3:0] r, g, b;
    sphere #(
        .BITS(4)
    ) core (
        .clk_i       (clk),
        .rst_ni      (rst_n_q2),
        .next_i      (~btn_next_n),
        .hold_turn_i (btn_hold_turn),
        .hold_light_i(btn_hold_light),
        .hsync_o     (hsync),
        .vsync_o     (vsync),
        .visible_o   (visible),
        .r_o         (r),
        .g_o         (g),
        .b_o         (b)
    );

    // Registers in the pins; the clock goes out inverted, so its rising edge is in the middle of a pixel.
    SB_IO #(
        .PIN_TYPE(6'b0101_01)
    ) pin[14:0] (
        .PACKAGE_PIN ({dvi_hsync, dvi_vsync, dvi_de, dvi_r, dvi_g, dvi_b}),
        .CLOCK_ENABLE(1'b1),
        .OUTPUT_CLK  (clk),
        .D_OUT_0     ({hsync, vsync, visible, r, g, b})
    );
    SB_IO #(
        .PIN_TYPE(6'b0100_01)
    ) pin_clk (
        .PACKAGE_PIN (dvi_clk),
        .CLOCK_ENABLE(1'b1),
        .OUTPUT_CLK  (clk),
        .D_OUT_0     (1'b0),
        .D_OUT_1     (1'b1)
    );

endmodule

`default_nettype wire
