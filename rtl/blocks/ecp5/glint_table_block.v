// glint_table_block for Lattice ECP5: a read-only memory of 1024 rows of 18 bits, read at two addresses, in one DP16KD.
//
// An entry comes two enabled clocks after its address, since the block has registers at its outputs: without them the way out
// of it is 5 ns. With clear one clock after the address the entry is 0. Of generated tables: docs/lobes/decay.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_table_block #(
    parameter [18431:0] ENTRIES = 18432'd0  // the first row lowest
) (
    input  wire        clk_i,
    input  wire        enable_i,
    input  wire  [9:0] address_a_i,
    input  wire        clear_a_i,
    output wire [17:0] entry_a_o,
    input  wire  [9:0] address_b_i,
    input  wire        clear_b_i,
    output wire [17:0] entry_b_o
);

    // 16 rows, each in 20 bits.
    function [319:0] rows(input integer first);
        integer k;
        begin
            rows = 320'd0;
            for (k = 0; k < 16; k = k + 1) rows[20*k+:18] = ENTRIES[18*(16*first+k)+:18];
        end
    endfunction

    /* verilator lint_off PINMISSING */  // what is written
    DP16KD #(
        .INITVAL_00(rows(0)), .INITVAL_01(rows(1)), .INITVAL_02(rows(2)), .INITVAL_03(rows(3)),
        .INITVAL_04(rows(4)), .INITVAL_05(rows(5)), .INITVAL_06(rows(6)), .INITVAL_07(rows(7)),
        .INITVAL_08(rows(8)), .INITVAL_09(rows(9)), .INITVAL_0A(rows(10)), .INITVAL_0B(rows(11)),
        .INITVAL_0C(rows(12)), .INITVAL_0D(rows(13)), .INITVAL_0E(rows(14)), .INITVAL_0F(rows(15)),
        .INITVAL_10(rows(16)), .INITVAL_11(rows(17)), .INITVAL_12(rows(18)), .INITVAL_13(rows(19)),
        .INITVAL_14(rows(20)), .INITVAL_15(rows(21)), .INITVAL_16(rows(22)), .INITVAL_17(rows(23)),
        .INITVAL_18(rows(24)), .INITVAL_19(rows(25)), .INITVAL_1A(rows(26)), .INITVAL_1B(rows(27)),
        .INITVAL_1C(rows(28)), .INITVAL_1D(rows(29)), .INITVAL_1E(rows(30)), .INITVAL_1F(rows(31)),
        .INITVAL_20(rows(32)), .INITVAL_21(rows(33)), .INITVAL_22(rows(34)), .INITVAL_23(rows(35)),
        .INITVAL_24(rows(36)), .INITVAL_25(rows(37)), .INITVAL_26(rows(38)), .INITVAL_27(rows(39)),
        .INITVAL_28(rows(40)), .INITVAL_29(rows(41)), .INITVAL_2A(rows(42)), .INITVAL_2B(rows(43)),
        .INITVAL_2C(rows(44)), .INITVAL_2D(rows(45)), .INITVAL_2E(rows(46)), .INITVAL_2F(rows(47)),
        .INITVAL_30(rows(48)), .INITVAL_31(rows(49)), .INITVAL_32(rows(50)), .INITVAL_33(rows(51)),
        .INITVAL_34(rows(52)), .INITVAL_35(rows(53)), .INITVAL_36(rows(54)), .INITVAL_37(rows(55)),
        .INITVAL_38(rows(56)), .INITVAL_39(rows(57)), .INITVAL_3A(rows(58)), .INITVAL_3B(rows(59)),
        .INITVAL_3C(rows(60)), .INITVAL_3D(rows(61)), .INITVAL_3E(rows(62)), .INITVAL_3F(rows(63)),
        .DATA_WIDTH_A(18), .DATA_WIDTH_B(18), .REGMODE_A("OUTREG"), .REGMODE_B("OUTREG"), .RESETMODE("SYNC")
    ) pair (
        .CLKA(clk_i), .CEA(enable_i), .OCEA(enable_i), .RSTA(enable_i & clear_a_i), .WEA(1'b0),
        .CSA0(1'b0), .CSA1(1'b0), .CSA2(1'b0),
        .ADA0(1'b0), .ADA1(1'b0), .ADA2(1'b0), .ADA3(1'b0),
        .ADA4(address_a_i[0]), .ADA5(address_a_i[1]), .ADA6(address_a_i[2]), .ADA7(address_a_i[3]),
        .ADA8(address_a_i[4]), .ADA9(address_a_i[5]), .ADA10(address_a_i[6]), .ADA11(address_a_i[7]),
        .ADA12(address_a_i[8]), .ADA13(address_a_i[9]),
        .DOA0(entry_a_o[0]), .DOA1(entry_a_o[1]), .DOA2(entry_a_o[2]), .DOA3(entry_a_o[3]),
        .DOA4(entry_a_o[4]), .DOA5(entry_a_o[5]), .DOA6(entry_a_o[6]), .DOA7(entry_a_o[7]),
        .DOA8(entry_a_o[8]), .DOA9(entry_a_o[9]), .DOA10(entry_a_o[10]), .DOA11(entry_a_o[11]),
        .DOA12(entry_a_o[12]), .DOA13(entry_a_o[13]), .DOA14(entry_a_o[14]), .DOA15(entry_a_o[15]),
        .DOA16(entry_a_o[16]), .DOA17(entry_a_o[17]),
        .CLKB(clk_i), .CEB(enable_i), .OCEB(enable_i), .RSTB(enable_i & clear_b_i), .WEB(1'b0),
        .CSB0(1'b0), .CSB1(1'b0), .CSB2(1'b0),
        .ADB0(1'b0), .ADB1(1'b0), .ADB2(1'b0), .ADB3(1'b0),
        .ADB4(address_b_i[0]), .ADB5(address_b_i[1]), .ADB6(address_b_i[2]), .ADB7(address_b_i[3]),
        .ADB8(address_b_i[4]), .ADB9(address_b_i[5]), .ADB10(address_b_i[6]), .ADB11(address_b_i[7]),
        .ADB12(address_b_i[8]), .ADB13(address_b_i[9]),
        .DOB0(entry_b_o[0]), .DOB1(entry_b_o[1]), .DOB2(entry_b_o[2]), .DOB3(entry_b_o[3]),
        .DOB4(entry_b_o[4]), .DOB5(entry_b_o[5]), .DOB6(entry_b_o[6]), .DOB7(entry_b_o[7]),
        .DOB8(entry_b_o[8]), .DOB9(entry_b_o[9]), .DOB10(entry_b_o[10]), .DOB11(entry_b_o[11]),
        .DOB12(entry_b_o[12]), .DOB13(entry_b_o[13]), .DOB14(entry_b_o[14]), .DOB15(entry_b_o[15]),
        .DOB16(entry_b_o[16]), .DOB17(entry_b_o[17])
    );
    /* verilator lint_on PINMISSING */

endmodule

`default_nettype wire
