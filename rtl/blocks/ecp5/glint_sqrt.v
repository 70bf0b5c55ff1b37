// glint_sqrt for Lattice ECP5: root = floor(sqrt(radicand)), one result a clock.
//
// It takes the place of rtl/blocks/glint_sqrt.v in a list of files: same ports, parameters, bits and clocks. Inside it does
// not restore, as the divider beside it does not: a stage is one row of carry cells. Table of ports: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_sqrt #(
    parameter Y_W = 19  // bits of the root = stages, at least 2
) (
    input  wire             clk_i,
    input  wire             enable_i,
    input  wire [2*Y_W-1:0] radicand_i,
    output wire   [Y_W-1:0] root_o,
    output wire     [Y_W:0] remainder_o
);

    // A stage takes two more bits and tries 4 root + 1, as in the root of any device. What does not fit stays negative: the
    // remainder is 2 root + 1 too small, and 4 times that less the next trial is 4 root + 3, which the next stage adds: after
    // stage i a remainder is -2^(i+2) + 1 .. 2^(i+2) - 1, kept as i + 2 bits and whether it is negative. -(4 root + 1) and
    // 4 root + 3 both have the low bits 11.
    genvar i;
    generate
        for (i = 0; i < Y_W; i = i + 1) begin : stage
            wire [i+2:0] shifted, trial;  // of trial, bits 1 and 0 are made in the adder
            wire         subtract;        // the remainder before is not negative
            wire         fits;
            wire [i+1:0] next;
            if (i == 0) begin : first
                assign subtract = 1'b1;
                assign shifted = {1'b0, radicand_i[2*Y_W-1:2*Y_W-2]};
                assign trial   = 3'd1;
            end else begin : rest
                assign subtract = stage[i-1].root_q[0];
                assign shifted = {stage[i-1].remainder_q, stage[i-1].waiting.bits_q[2*(Y_W-i)-1:2*(Y_W-i)-2]};
                assign trial   = {1'b0, stage[i-1].root_q, 2'b01};
            end
            glint_add_sub_odd #(
                .WIDTH(i + 3),
                .ONES (1)
            ) add_sub (
                .subtract_i    (subtract),
                .a_i           (shifted),
                .b_i           (trial),
                .result_o      (next),
                .not_negative_o(fits)
            );

            reg [i+1:0] remainder_q;
            reg   [i:0] root_q;
            always @(posedge clk_i) if (enable_i) remainder_q <= next;

            if (i == 0) begin : begins
                always @(posedge clk_i) if (enable_i) root_q <= fits;
            end else begin : appends
                always @(posedge clk_i) if (enable_i) root_q <= {stage[i-1].root_q, fits};
            end

            if (i < Y_W - 1) begin : waiting
                reg [2*(Y_W-1-i)-1:0] bits_q;
                if (i == 0) begin : enters
                    always @(posedge clk_i) if (enable_i) bits_q <= radicand_i[2*Y_W-3:0];
                end else begin : moves
                    always @(posedge clk_i) if (enable_i) bits_q <= stage[i-1].waiting.bits_q[2*(Y_W-1-i)-1:0];
                end
            end
        end
    endgenerate

    // A negative remainder is 2 root + 1 too small.
    wire [Y_W:0] back = root_o[0] ? {(Y_W + 1) {1'b0}} : {root_o, 1'b1};
    assign root_o      = stage[Y_W-1].root_q;
    assign remainder_o = stage[Y_W-1].remainder_q + back;

endmodule

`default_nettype wire
