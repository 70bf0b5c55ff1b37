// glint_multiplier_block for Lattice iCE40 UltraPlus: a product of 16 x 16 bits in one SB_MAC16. STAGES clocks: 1, a
// register of the product in the block; 2, also of the operands; 3, also in the middle; 4, one of logic cells after it; 0,
// none. Synthesize without `-dsp`: Yosys 0.23 then takes the registers out of a block that stands in the source.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_multiplier_block #(
    parameter SIGNED = 0,  // 1: a is signed; b is unsigned
    parameter STAGES = 1   // 0 .. 4
) (
    input  wire        clk_i,
    input  wire        enable_i,
    input  wire [15:0] a_i,
    input  wire [15:0] b_i,
    output wire [31:0] product_o
);

    wire [31:0] now;
    /* verilator lint_off PINMISSING */  // the outputs of its adders' cascade
    SB_MAC16 #(
        .A_REG                   (STAGES > 1),
        .B_REG                   (STAGES > 1),
        .TOP_8x8_MULT_REG        (STAGES > 2),
        .BOT_8x8_MULT_REG        (STAGES > 2),
        .PIPELINE_16x16_MULT_REG1(STAGES > 2),
        .PIPELINE_16x16_MULT_REG2(STAGES > 0),
        .TOPOUTPUT_SELECT        (2'd3),  // the product of 16 x 16 bits
        .BOTOUTPUT_SELECT        (2'd3),
        .A_SIGNED                (SIGNED != 0),
        .B_SIGNED                (1'b0)
    ) multiplier (
        .CLK(clk_i), .CE(enable_i),
        .A(a_i), .B(b_i), .C(16'd0), .D(16'd0), .O(now),
        .AHOLD(1'b0), .BHOLD(1'b0), .CHOLD(1'b0), .DHOLD(1'b0),
        .IRSTTOP(1'b0), .IRSTBOT(1'b0), .ORSTTOP(1'b0), .ORSTBOT(1'b0),
        .OLOADTOP(1'b0), .OLOADBOT(1'b0), .ADDSUBTOP(1'b0), .ADDSUBBOT(1'b0), .OHOLDTOP(1'b0), .OHOLDBOT(1'b0),
        .CI(1'b0), .ACCUMCI(1'b0), .SIGNEXTIN(1'b0)
    );
    /* verilator lint_on PINMISSING */
    glint_delay #(
        .WIDTH (32),
        .STAGES(STAGES > 3 ? STAGES - 3 : 0)
    ) delay (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (now),
        .data_o  (product_o)
    );

endmodule

`default_nettype wire
