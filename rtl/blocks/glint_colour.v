// glint_colour: a channel of a material's colour as a port carries it, cut to 1 (docs/effects.md). No clock.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_colour #(
    parameter O = 12  // fraction bits, at least 1
) (
    input  wire [O:0] k_i,      // unsigned, code / 2^O
    output wire [O:0] k_o,      // 0 .. 2^O
    output wire       clamped_o // k_i was above 2^O
);

    assign k_o       = {k_i[O], k_i[O-1:0] & {O{~k_i[O]}}};
    assign clamped_o = k_i[O] & (|k_i[O-1:0]);

endmodule

`default_nettype wire
