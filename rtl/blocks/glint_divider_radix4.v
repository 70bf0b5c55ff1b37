// glint_divider_radix4: quotient = floor(dividend / divisor), two quotient bits a row.
//
// The contract is that of glint_divider. Each row takes off 0, 1, 2 or 3 times the divisor, the most that fits: three
// subtractions side by side and their signs. Three times the divisor is made once, in a clock before the rows, and
// travels with it. A register follows every REGISTER_EVERY rows and the last one: 1 + ceil(ceil(Q_W / 2) /
// REGISTER_EVERY) clocks with enable_i = 1 lead from operands to result. Ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_divider_radix4 #(
    parameter X_W            = 34,  // dividend bits; Q_W < X_W <= Y_W + Q_W
    parameter Y_W            = 28,  // divisor bits
    parameter Q_W            = 16,  // quotient bits, at least 2
    parameter REGISTER_EVERY = 1,   // rows in a clock
    parameter BESIDE_W       = 1    // bits of what goes with the operands
) (
    input  wire                clk_i,
    input  wire                enable_i,
    input  wire      [X_W-1:0] dividend_i,
    input  wire      [Y_W-1:0] divisor_i,
    input  wire [BESIDE_W-1:0] beside_i,
    output wire      [Q_W-1:0] quotient_o,
    output wire      [Y_W-1:0] remainder_o,
    output wire [BESIDE_W-1:0] beside_o
);

    // An odd Q_W gets one bit more, which is 0. Head and tail of the dividend: as in glint_divider_restoring.
    localparam ROWS   = (Q_W + 1) / 2;
    localparam BITS_W = 2 * ROWS;
    localparam WIDE_W = Y_W + BITS_W;
    localparam R_W    = Y_W + 2;  // of what is below 4 divisor

    wire [WIDE_W-1:0] dividend = {{(WIDE_W - X_W) {1'b0}}, dividend_i};

    reg    [Y_W-1:0] head_0_q;
    reg    [Y_W-1:0] complement_0_q;
    reg    [R_W-1:0] triple_0_q;
    wire   [R_W-1:0] three = {2'b00, divisor_i} + {1'b0, divisor_i, 1'b0};
    reg [BITS_W-1:0] tail_0_q;
    reg [BESIDE_W-1:0] beside_0_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            {head_0_q, tail_0_q} <= dividend;
            complement_0_q   <= ~divisor_i;
            beside_0_q         <= beside_i;
            triple_0_q       <= ~three;
        end
    end

    genvar i;
    generate
        for (i = 0; i < ROWS; i = i + 1) begin : row
            wire    [Y_W-1:0] remainder, remainder_next;
            /* verilator lint_off UNUSED */  // after the last row
            wire    [Y_W-1:0] complement, complement_next;
            wire    [R_W-1:0] triple, triple_next;
            wire [BITS_W-1:0] bits, bits_next;
            /* verilator lint_on UNUSED */
            wire [BESIDE_W-1:0] beside, beside_next;

            if (i == 0) begin : first
                assign remainder = head_0_q;
                assign complement   = complement_0_q;
                assign triple    = triple_0_q;
                assign bits      = tail_0_q;
                assign beside    = beside_0_q;
            end else begin : rest
                assign remainder = row[i-1].remainder_next;
                assign complement   = row[i-1].complement_next;
                assign triple    = row[i-1].triple_next;
                assign bits      = row[i-1].bits_next;
                assign beside    = row[i-1].beside_next;
            end

            // remainder <= divisor - 1, so shifted = 4 remainder + two bits <= 4 divisor - 1: R_W bits, and one more for
            // the sign of a difference. The difference that is kept is below the divisor: Y_W bits.
            wire [R_W-1:0] shifted = {remainder, bits[BITS_W-1:BITS_W-2]};
            // As in glint_divider_restoring, complements travel, and a bit below adds the 1 of x - y = x + ~y + 1.
            /* verilator lint_off UNUSED */  // the bit below, and the upper bits but for the sign
            wire [R_W+1:0] less_1 = {1'b0, shifted, 1'b1} + {3'b111, complement, 1'b1};
            wire [R_W+1:0] less_2 = {1'b0, shifted, 1'b1} + {2'b11, complement, 2'b11};
            wire [R_W+1:0] less_3 = {1'b0, shifted, 1'b1} + {1'b1, triple, 1'b1};
            /* verilator lint_on UNUSED */
            wire           fits_1 = ~less_1[R_W+1];
            wire           fits_2 = ~less_2[R_W+1];
            wire           fits_3 = ~less_3[R_W+1];

            wire     [1:0] digit = {fits_2, fits_2 ? fits_3 : fits_1};
            wire [Y_W-1:0] reduced = fits_2 ? (fits_3 ? less_3[Y_W:1] : less_2[Y_W:1])
                                            : (fits_1 ? less_1[Y_W:1] : shifted[Y_W-1:0]);

            /* verilator lint_off UNUSED */  // the two bits that were taken
            wire [BITS_W+1:0] bits_digit = {bits, digit};
            /* verilator lint_on UNUSED */
            if ((i + 1) % REGISTER_EVERY == 0 || i == ROWS - 1) begin : registered
                reg    [Y_W-1:0] remainder_q;
                reg    [Y_W-1:0] complement_q;
                reg    [R_W-1:0] triple_q;
                reg [BITS_W-1:0] bits_q;
                reg [BESIDE_W-1:0] beside_q;
                always @(posedge clk_i) begin
                    if (enable_i) begin
                        remainder_q <= reduced;
                        complement_q   <= complement;
                        triple_q    <= triple;
                        bits_q      <= bits_digit[BITS_W-1:0];
                        beside_q    <= beside;
                    end
                end
                assign remainder_next = remainder_q;
                assign complement_next   = complement_q;
                assign triple_next    = triple_q;
                assign bits_next      = bits_q;
                assign beside_next    = beside_q;
            end else begin : passed
                assign remainder_next = reduced;
                assign complement_next   = complement;
                assign triple_next    = triple;
                assign bits_next      = bits_digit[BITS_W-1:0];
                assign beside_next    = beside;
            end
        end
    endgenerate

    assign quotient_o  = row[ROWS-1].bits_next[Q_W-1:0];
    assign remainder_o = row[ROWS-1].remainder_next;
    assign beside_o    = row[ROWS-1].beside_next;

endmodule

`default_nettype wire
