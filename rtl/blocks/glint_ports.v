// glint_ports: what every lobe's unit has around its numbers: the stream's valid bits, the tag, the corrections.
//
// The corrections are the section "Ports" of docs/contract.md. A lobe gets n and C one clock after a transfer, moves its
// registers when advance_o = 1 and only then, and makes y 0 where negative_o = 1, which stands beside the last step.
// How many clocks a lobe takes stands here once: its own, those of its divider, and those of its products. With the
// iterative divider one input at a time is in the unit; n and C stay until the next. Ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_ports #(
    parameter F                 = 18,  // fraction bits of the cosine
    parameter LATENCY           = 2,   // clocks from an input to its result without a divider, a product taking one; at least 3
    parameter PRODUCTS          = 0,   // products of glint_multiplier on the way, outside a divider
    parameter QUOTIENT_W        = 0,   // Q_W of the divider; 0: there is none
    parameter DIVIDER           = 0,
    parameter REGISTER_EVERY    = 1,
    parameter MULTIPLIER_STAGES = 1,
    parameter TAG_W             = 16   // width of the tag, at least 1
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
    output wire             start_o,    // a new input is at n_o, cosine_o, distance_o
    output wire       [9:0] n_o,        // 1 .. 1023
    output wire       [F:0] cosine_o,   // C: 0 .. 2^F
    output wire       [F:0] distance_o, // 2^F - C: 0 .. 2^F
    output wire             negative_o  // cos < 0
);

`ifndef SYNTHESIS
    initial begin
        if (LATENCY < 3) begin  // the default: nobody has added up the blocks of the lobe
            $display("glint_ports: parameter LATENCY not set; use a wrapper from `glint emit`");
            $finish;
        end
    end
`endif

    // The clocks of each glint_divider_*; 2 R - 1 quotient bits are as many rows of radix 4 as 2 R.
    localparam ITERATIVE = QUOTIENT_W > 0 && DIVIDER == 2;
    localparam ROWS      = DIVIDER == 1 ? (QUOTIENT_W + 1) / 2 : QUOTIENT_W;
    localparam CHUNKS    = (ROWS + REGISTER_EVERY - 1) / REGISTER_EVERY;
    localparam RECIPROCAL = 1 + MULTIPLIER_STAGES + (QUOTIENT_W + 15) / 16 * (2 * MULTIPLIER_STAGES + 1);
    localparam DIVISION  = QUOTIENT_W == 0 ? 0 : DIVIDER == 1 ? 1 + CHUNKS : DIVIDER == 2 ? QUOTIENT_W + 1 : DIVIDER == 3 ? RECIPROCAL : CHUNKS;
    localparam CLOCKS    = LATENCY + DIVISION + PRODUCTS * (MULTIPLIER_STAGES - 1);

    // The whole pipeline moves, or none of it: it stands still only while a result waits at the output.
    reg  [CLOCKS-1:0] valid_q;
    wire              advance = ready_i | ~valid_q[CLOCKS-1];
    wire              room = ITERATIVE ? ~|valid_q[CLOCKS-2:0] : 1'b1;
    wire              load = ITERATIVE ? valid_i & room : 1'b1;

    assign advance_o = advance;
    assign start_o   = valid_q[0];
    assign ready_o   = rst_ni & advance & room;
    assign valid_o   = rst_ni & valid_q[CLOCKS-1];

    always @(posedge clk_i) begin
        if (!rst_ni) valid_q <= {CLOCKS{1'b0}};
        else if (advance) valid_q <= {valid_q[CLOCKS-2:0], valid_i & room};
    end

    localparam [F:0] ONE = {1'b1, {F{1'b0}}};  // 1.0 as a cosine code

    // 2^F - code for a code 0 .. 2^(F+1) - 1: F + 2 bits with the sign, which says that the code is above 2^F.
    wire [F+1:0] difference = {1'b0, ONE} - {1'b0, cos_i[F:0]};
    wire         below = cos_i[F+1];  // code < 0; C is then 0, a legal operand, and unused
    wire         above = ~below & difference[F+1];
    wire         none  = ~|n_i;

    reg [9:0] n_q;
    reg [F:0] cosine_q;
    reg [F:0] distance_q;
    always @(posedge clk_i) begin
        if (advance & load) begin
            n_q        <= none ? 10'd1 : n_i;
            cosine_q   <= below ? {(F + 1) {1'b0}} : above ? ONE : cos_i[F:0];
            distance_q <= below ? ONE : above ? {(F + 1) {1'b0}} : difference[F:0];
        end
    end

    assign n_o        = n_q;
    assign cosine_o   = cosine_q;
    assign distance_o = distance_q;

    generate
        if (ITERATIVE) begin : one
            reg             negative_q;
            reg [TAG_W:0] tag_q;
            always @(posedge clk_i) begin
                if (advance & load) begin
                    negative_q <= below;
                    tag_q      <= {above | below | none, tag_i};
                end
            end
            assign negative_o         = negative_q;
            assign {clamped_o, tag_o} = tag_q;
        end else begin : all
            glint_delay #(
                .WIDTH (1),
                .STAGES(CLOCKS - 1)
            ) delay_negative (
                .clk_i   (clk_i),
                .enable_i(advance),
                .data_i  (below),
                .data_o  (negative_o)
            );

            glint_delay #(
                .WIDTH (TAG_W + 1),
                .STAGES(CLOCKS)
            ) delay_tag (
                .clk_i   (clk_i),
                .enable_i(advance),
                .data_i  ({above | below | none, tag_i}),
                .data_o  ({clamped_o, tag_o})
            );
        end
    endgenerate

endmodule

`default_nettype wire
