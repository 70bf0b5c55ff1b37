// glint_dot: a dot product of unit vectors as a port carries it, cut to -1 .. 1 (docs/effects.md). No clock.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_dot #(
    parameter F = 18  // fraction bits, at least 1
) (
    input  wire [F+1:0] dot_i,    // signed, code / 2^F
    output wire [F+1:0] dot_o,    // signed, -2^F .. 2^F
    output wire         clamped_o // dot_i was outside
);

    wire negative = dot_i[F+1];
    wire above    = ~negative & dot_i[F] & (|dot_i[F-1:0]);  // code > 2^F
    wire below    = negative & ~dot_i[F];                    // code < -2^F

    // Of 2^F and -2^F alike the low F bits are 0.
    assign dot_o     = {negative, dot_i[F] | below, dot_i[F-1:0] & {F{~clamped_o}}};
    assign clamped_o = above | below;

endmodule

`default_nettype wire
