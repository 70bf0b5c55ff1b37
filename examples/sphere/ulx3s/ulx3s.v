// ulx3s: the sphere on an ULX3S, at its GPDI connector. Pins: ulx3s.lpf.

`default_nettype none

module ulx3s (
    input  wire       clk_25mhz,
    input  wire       btn_next,
    input  wire       btn_hold_turn,
    input  wire       btn_hold_light,
    output wire [3:0] gpdi_dp,
    output wire       wifi_gpio0
);

    assign wifi_gpio0 = 1'b1;

    // 25 MHz * 5 = 125 MHz, by way of 625 MHz; that by 5 again for the pixels. Both start in one phase.
    wire clk, clk_shift, locked;
    (* FREQUENCY_PIN_CLKI = "25", FREQUENCY_PIN_CLKOP = "125", FREQUENCY_PIN_CLKOS = "25" *)
    (* ICP_CURRENT = "12", LPF_RESISTOR = "8" *)
    EHXPLLL #(
        .CLKI_DIV     (1),
        .CLKFB_DIV    (5),
        .FEEDBK_PATH  ("CLKOP"),
        .CLKOP_ENABLE ("ENABLED"),
        .CLKOP_DIV    (5),
        .CLKOP_CPHASE (2),
        .CLKOS_ENABLE ("ENABLED"),
        .CLKOS_DIV    (25),
        .CLKOS_CPHASE (2)
    ) pll (
        .CLKI        (clk_25mhz),
        .CLKFB       (clk_shift),
        .CLKOP       (clk_shift),
        .CLKOS       (clk),
        .LOCK        (locked),
        .RST         (1'b0),
        .STDBY       (1'b0),
        .PHASESEL0   (1'b0),
        .PHASESEL1   (1'b0),
        .PHASEDIR    (1'b1),
        .PHASESTEP   (1'b1),
        .PHASELOADREG(1'b1),
        .PLLWAKESYNC (1'b0),
        .ENCLKOP     (1'b0)
    );
    reg rst_n_q, rst_n_q2;
    always @(posedge clk) {rst_n_q2, rst_n_q} <= {rst_n_q, locked};

    wire [3:0] first, second;
    sphere_dvi dvi (
        .clk_i       (clk),
        .clk_shift_i (clk_shift),
        .rst_ni      (rst_n_q2),
        .next_i      (btn_next),
        .hold_turn_i (btn_hold_turn),
        .hold_light_i(btn_hold_light),
        .first_o     (first),
        .second_o    (second)
    );
    ODDRX1F out[3:0] (
        .SCLK(clk_shift),
        .RST (1'b0),
        .D0  (first),
        .D1  (second),
        .Q   (gpdi_dp)
    );

endmodule

`default_nettype wire
