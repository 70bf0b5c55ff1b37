// glint_ports: what every lobe's unit has around its numbers: the stream's valid bits, the tag, the corrections.
//
// The corrections are the section "Ports" of docs/contract.md. A lobe gets n and C one clock after a transfer, computes
// y in LATENCY clocks in all, moves its registers when advance_o = 1 and only then, and makes y 0 where negative_o = 1,
// which stands beside the last step: LATENCY - 1 clocks after the transfer. Table of ports and parameters: docs/rtl.md.

`default_nettype none

module glint_ports #(
    parameter F       = 18,  // fraction bits of the cosine
    parameter LATENCY = 2,   // clocks from an input to its result, at least 2
    parameter TAG_W   = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,     // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire       [9:0] n_i,
    input  wire     [F+1:0] cos_i,      // cosine, signed, code / 2^F
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o,
    output wire             advance_o,  // every register of the lobe moves
    output wire       [9:0] n_o,        // 1 .. 1023
    output wire       [F:0] cosine_o,   // C: 0 .. 2^F
    output wire       [F:0] distance_o, // 2^F - C: 0 .. 2^F
    output wire             negative_o  // cos < 0
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

    localparam [F:0] ONE = {1'b1, {F{1'b0}}};  // 1.0 as a cosine code

    wire above = ~cos_i[F+1] & cos_i[F] & (|cos_i[F-1:0]);  // code > 2^F
    wire below = cos_i[F+1];                                // code < 0; C is then 0, a legal operand, and unused
    wire none  = ~|n_i;

    wire [F:0] corrected = below ? {(F + 1) {1'b0}} : above ? ONE : cos_i[F:0];

    reg [9:0] n_q;
    reg [F:0] cosine_q;
    reg [F:0] distance_q;
    always @(posedge clk_i) begin
        if (advance) begin
            n_q        <= none ? 10'd1 : n_i;
            cosine_q   <= corrected;
            distance_q <= ONE - corrected;
        end
    end

    assign n_o        = n_q;
    assign cosine_o   = cosine_q;
    assign distance_o = distance_q;

    glint_delay #(
        .WIDTH (1),
        .STAGES(LATENCY - 1)
    ) delay_negative (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (below),
        .data_o  (negative_o)
    );

    glint_delay #(
        .WIDTH (TAG_W + 1),
        .STAGES(LATENCY)
    ) delay_tag (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  ({above | below | none, tag_i}),
        .data_o  ({clamped_o, tag_o})
    );

endmodule

`default_nettype wire
