// SB_MAC16: what a simulation needs of the multiplier block of Lattice iCE40 UltraPlus. Synthesis has its own; do not give
// it this.
//
// It models the product of 16 x 16 bits, signed or not by A_SIGNED and B_SIGNED, and the registers of operands, middle and
// product, which move at the rising edge of CLK when CE is 1, and start unknown. Its adders, its products of 8 x 8 bits, the
// holds and the resets are not there; the parameters and inputs of these have to be as glint_multiplier_block has them.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module SB_MAC16 #(
    parameter A_REG                    = 0,
    parameter B_REG                    = 0,
    /* verilator lint_off UNUSED */
    parameter TOP_8x8_MULT_REG         = 0,
    parameter BOT_8x8_MULT_REG         = 0,
    parameter TOPOUTPUT_SELECT         = 3,
    parameter BOTOUTPUT_SELECT         = 3,
    /* verilator lint_on UNUSED */
    parameter PIPELINE_16x16_MULT_REG1 = 0,
    parameter PIPELINE_16x16_MULT_REG2 = 0,
    parameter A_SIGNED                 = 0,
    parameter B_SIGNED                 = 0
) (
    input  wire        CLK, CE,
    input  wire [15:0] A, B,
    /* verilator lint_off UNUSED */
    input  wire [15:0] C, D,
    input  wire        AHOLD, BHOLD, CHOLD, DHOLD, IRSTTOP, IRSTBOT, ORSTTOP, ORSTBOT, OLOADTOP, OLOADBOT,
    input  wire        ADDSUBTOP, ADDSUBBOT, OHOLDTOP, OHOLDBOT, CI, ACCUMCI, SIGNEXTIN,
    /* verilator lint_on UNUSED */
    output wire [31:0] O
);

    reg  [15:0] a_q, b_q;
    reg  [31:0] middle_q, product_q;

    wire        [15:0] a = A_REG != 0 ? a_q : A;
    wire        [15:0] b = B_REG != 0 ? b_q : B;
    wire signed [31:0] wide_a = {{16{A_SIGNED != 0 & a[15]}}, a};
    wire signed [31:0] wide_b = {{16{B_SIGNED != 0 & b[15]}}, b};
    wire        [31:0] now = wide_a * wide_b;
    wire        [31:0] middle = PIPELINE_16x16_MULT_REG1 != 0 ? middle_q : now;
    always @(posedge CLK) begin
        if (CE) begin
            a_q       <= A;
            b_q       <= B;
            middle_q  <= now;
            product_q <= middle;
        end
    end
    assign O = PIPELINE_16x16_MULT_REG2 != 0 ? product_q : middle;

endmodule

`default_nettype wire
