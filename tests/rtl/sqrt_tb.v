// glint_sqrt by its contract: radicand = root^2 + remainder, remainder <= 2 root, Y_W enabled edges after the radicand.
//
//   parameters  Y_W as in glint_sqrt (up to 32)
//               ROOTS: so many, of random radicands and corners; 0: all that there are

`default_nettype none

module sqrt_tb;

    parameter Y_W   = 19;
    parameter ROOTS = 0;

    localparam LATENCY = Y_W;
    localparam THINGS  = "roots";
    localparam COUNT   = ROOTS;
    localparam IN_W    = 2 * Y_W;
    localparam FIRST   = {IN_W{1'b0}};
`include "pipeline.vh"

    wire [Y_W-1:0] root;
    wire   [Y_W:0] remainder;

    glint_sqrt #(
        .Y_W(Y_W)
    ) sqrt (
        .clk_i      (clk),
        .enable_i   (enable),
        .radicand_i (given),
        .root_o     (root),
        .remainder_o(remainder)
    );

    assign right = {2'b0, root} * {2'b0, root} + remainder === {2'b0, past} && remainder <= {root, 1'b0};

    integer        bits;
    reg [IN_W-1:0] drawn;

    // A square, one less or one more, all ones, or a random number: of up to IN_W bits, as often of few as of many.
    task draw_next;
        begin
            bits  = 1 + {$random(seed)} % IN_W;
            drawn = {IN_W{1'b1}} & ({$random(seed), $random(seed)} >> (64 - bits));
            case ({$random(seed)} % 8)
                0: next = drawn[Y_W-1:0] * drawn[Y_W-1:0];
                1: next = drawn[Y_W-1:0] * drawn[Y_W-1:0] - 1;
                2: next = drawn[Y_W-1:0] * drawn[Y_W-1:0] + 1;
                3: next = {IN_W{1'b1}} >> (IN_W - bits);
                default: next = drawn;
            endcase
        end
    endtask

    task following;
        begin
            more = ~&next;
            next = next + 1;
        end
    endtask

    task complain;
        $display("FAILED: %0d: root %0d, remainder %0d", past, root, remainder);
    endtask

endmodule

`default_nettype wire
