// glint_sqrt: root = floor(sqrt(radicand)), one result a clock.
//
// Contract, with integers, for every radicand:
//   radicand = root^2 + remainder   and   0 <= remainder <= 2 root.
// Restoring, one bit of the root a stage: Y_W clocks with enable_i = 1 from the radicand to the result. The pipeline
// has no valid bits and no reset: its owner counts clocks. Table of ports and parameters: docs/rtl.md.

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

    // Each stage takes the next two bits of the radicand, from the top, and appends a bit to the root: with `root` and
    // `remainder` of the bits so far, 4 (root^2 + remainder) + two bits is (2 root + 1)^2 + something when
    // 4 remainder + two bits >= 4 root + 1. After stage i the root has i + 1 bits and the remainder, at most 2 root, has
    // i + 2; the rest of the radicand has two bits fewer than before.
    genvar i;
    generate
        for (i = 0; i < Y_W; i = i + 1) begin : stage
            // remainder <= 2 root < 2^(i+1), so shifted < 2^(i+3); trial = 4 root + 1 < 2^(i+2).
            wire [i+2:0] shifted;
            wire [i+2:0] trial;
            if (i == 0) begin : first
                assign shifted = {1'b0, radicand_i[2*Y_W-1:2*Y_W-2]};
                assign trial   = 3'd1;
            end else begin : rest
                assign shifted = {stage[i-1].remainder_q, stage[i-1].waiting.bits_q[2*(Y_W-i)-1:2*(Y_W-i)-2]};
                assign trial   = {1'b0, stage[i-1].root_q, 2'b01};
            end
            wire fits = shifted >= trial;

            // What is kept is at most 2 root of this stage: one bit less than `shifted`, whether the trial came off or
            // did not fit (then shifted <= 4 root).
            wire [i+1:0] reduced = fits ? shifted[i+1:0] - trial[i+1:0] : shifted[i+1:0];

            reg [i+1:0] remainder_q;
            reg   [i:0] root_q;
            always @(posedge clk_i) if (enable_i) remainder_q <= reduced;

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

    assign root_o      = stage[Y_W-1].root_q;
    assign remainder_o = stage[Y_W-1].remainder_q;

endmodule

`default_nettype wire
