// glint_stream: the frame of a unit with any ports: the stream's valid bits, the tag and `clamped` beside the numbers.
//
// The unit's numbers move when advance_o = 1 and only then, and are ready LATENCY such clocks after their inputs. Table of
// ports and parameters, handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_stream #(
    parameter LATENCY = 2,  // clocks from an input to its result, at least 2
    parameter TAG_W   = 16  // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,    // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire             clamped_i, // of the input that is offered
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o,
    output wire             advance_o  // every register of the unit moves
);

    // The whole pipeline moves, or none of it: it stands still only while a result waits at the output.
    reg  [LATENCY-1:0] valid_q;
    wire               advance = ready_i | ~valid_q[LATENCY-1];

    assign advance_o = advance;
    assign ready_o   = rst_ni & advance;
    assign valid_o   = rst_ni & valid_q[LATENCY-1];

    always @(posedge clk_i) begin
        if (!rst_ni) valid_q <= {LATENCY{1'b0}};
        else if (advance) valid_q <= {valid_q[LATENCY-2:0], valid_i};
    end

    glint_delay #(
        .WIDTH (TAG_W + 1),
        .STAGES(LATENCY)
    ) delay_tag (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  ({clamped_i, tag_i}),
        .data_o  ({clamped_o, tag_o})
    );

endmodule

`default_nettype wire
