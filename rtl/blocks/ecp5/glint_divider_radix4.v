// glint_divider_radix4 for Lattice ECP5: quotient = floor(dividend / divisor), two quotient bits a row.
//
// It takes the place of rtl/blocks/glint_divider_radix4.v in a list of files: same ports, parameters, bits and clocks. As the
// divider of one bit a row beside it, it does not restore. A row is two rows of that one: the sum of the first and both that the
// second can have stand side by side, and one choice follows. Table of ports and parameters: docs/rtl.md.

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

    // An odd Q_W gets one bit more, which is 0. Three times the divisor is made in a clock before the rows.
    localparam ROWS   = (Q_W + 1) / 2;
    localparam BITS_W = 2 * ROWS;
    localparam WIDE_W = Y_W + BITS_W;
    localparam R_W    = Y_W + 2;

    wire [WIDE_W-1:0] dividend = {{(WIDE_W - X_W) {1'b0}}, dividend_i};

    reg    [Y_W-1:0] head_0_q;
    reg    [Y_W-1:0] divisor_0_q;
    reg    [R_W-1:0] triple_0_q;
    reg [BITS_W-1:0] tail_0_q;
    reg [BESIDE_W-1:0] beside_0_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            {head_0_q, tail_0_q} <= dividend;
            divisor_0_q          <= divisor_i;
            beside_0_q           <= beside_i;
            triple_0_q           <= {2'b00, divisor_i} + {1'b0, divisor_i, 1'b0};
        end
    end

    genvar i;
    generate
        for (i = 0; i < ROWS; i = i + 1) begin : row
            wire    [Y_W-1:0] remainder, remainder_next;
            wire    [Y_W-1:0] divisor, divisor_next;
            /* verilator lint_off UNUSED */  // after the last row
            wire    [R_W-1:0] triple, triple_next;
            wire [BITS_W-1:0] bits, bits_next;
            /* verilator lint_on UNUSED */
            wire [BESIDE_W-1:0] beside, beside_next;
            wire              subtract;  // the remainder is not negative

            if (i == 0) begin : first
                assign remainder = head_0_q;
                assign divisor   = divisor_0_q;
                assign triple    = triple_0_q;
                assign bits      = tail_0_q;
                assign beside    = beside_0_q;
                assign subtract  = 1'b1;
            end else begin : rest
                assign remainder = row[i-1].remainder_next;
                assign divisor   = row[i-1].divisor_next;
                assign triple    = row[i-1].triple_next;
                assign bits      = row[i-1].bits_next;
                assign beside    = row[i-1].beside_next;
                assign subtract  = row[i-1].bits_next[0];
            end

            // A remainder is -divisor .. divisor - 1: Y_W bits and a sign, kept as the last quotient bit. Of one that is not
            // negative, x = 4 remainder + two bits is less 3 divisor where x >= 2 divisor, else less 1 divisor, in that range
            // again; a negative one gets 1 divisor where x >= -2 divisor, else 3. The carries say what is not negative, as in
            // glint_divider_restoring.
            /* verilator lint_off UNUSED */  // of the first sum only the sign counts; upper bits are the sign again
            wire [Y_W:0] twice;
            wire [R_W-1:0] near, far;
            /* verilator lint_on UNUSED */
            wire           fits_twice, fits_near, fits_far;
            glint_add_sub #(
                .WIDTH(Y_W + 1)
            ) add_sub_twice (
                .subtract_i(subtract),
                .a_i       ({remainder, bits[BITS_W-1]}),
                .b_i       ({1'b0, divisor}),
                .result_o  (twice),
                .carry_o   (fits_twice)
            );
            glint_add_sub #(
                .WIDTH(R_W)
            ) add_sub_near (
                .subtract_i(subtract),
                .a_i       ({remainder, bits[BITS_W-1:BITS_W-2]}),
                .b_i       ({2'b00, divisor}),
                .result_o  (near),
                .carry_o   (fits_near)
            );
            glint_add_sub #(
                .WIDTH(R_W)
            ) add_sub_far (
                .subtract_i(subtract),
                .a_i       ({remainder, bits[BITS_W-1:BITS_W-2]}),
                .b_i       (triple),
                .result_o  (far),
                .carry_o   (fits_far)
            );
            wire           is_far = fits_twice == subtract;
            wire [Y_W-1:0] next = is_far ? far[Y_W-1:0] : near[Y_W-1:0];
            wire           fits = is_far ? fits_far : fits_near;

            /* verilator lint_off UNUSED */  // the two bits that were taken
            wire [BITS_W+1:0] bits_digit = {bits, fits_twice, fits};
            /* verilator lint_on UNUSED */
            if ((i + 1) % REGISTER_EVERY == 0 || i == ROWS - 1) begin : registered
                reg    [Y_W-1:0] remainder_q;
                reg    [Y_W-1:0] divisor_q;
                reg    [R_W-1:0] triple_q;
                reg [BITS_W-1:0] bits_q;
                reg [BESIDE_W-1:0] beside_q;
                always @(posedge clk_i) begin
                    if (enable_i) begin
                        remainder_q <= next;
                        divisor_q   <= divisor;
                        triple_q    <= triple;
                        bits_q      <= bits_digit[BITS_W-1:0];
                        beside_q    <= beside;
                    end
                end
                assign remainder_next = remainder_q;
                assign divisor_next   = divisor_q;
                assign triple_next    = triple_q;
                assign bits_next      = bits_q;
                assign beside_next    = beside_q;
            end else begin : passed
                assign remainder_next = next;
                assign divisor_next   = divisor;
                assign triple_next    = triple;
                assign bits_next      = bits_digit[BITS_W-1:0];
                assign beside_next    = beside;
            end
        end
    endgenerate

    // What is negative at the end is one divisor too small.
    wire [Y_W-1:0] back = row[ROWS-1].bits_next[0] ? {Y_W{1'b0}} : row[ROWS-1].divisor_next;
    assign quotient_o  = row[ROWS-1].bits_next[Q_W-1:0];
    assign remainder_o = row[ROWS-1].remainder_next + back;
    assign beside_o    = row[ROWS-1].beside_next;

endmodule

`default_nettype wire
