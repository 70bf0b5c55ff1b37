// glint_divider_reciprocal: quotient = floor(dividend / divisor) by a table of reciprocals and exact remainders.
//
// The contract is that of glint_divider. Both operands are shifted until the divisor begins with a 1. A table and a
// product give a reciprocal of the divisor that is never too large; a second product an estimate of up to 16 quotient
// bits that is at most 2 too small; a third the remainder, which says what is missing. More quotient bits take another
// round. 1 + M + ROUNDS (2 M + 1) clocks with enable_i = 1 lead from operands to result, for M = MULTIPLIER_STAGES and
// ROUNDS = ceil(Q_W / 16). Derivation of the widths, ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_divider_reciprocal #(
    parameter X_W               = 34,   // dividend bits; Q_W < X_W <= Y_W + Q_W
    parameter Y_W               = 28,   // divisor bits
    parameter Q_W               = 16,   // quotient bits, at least 2
    parameter ZEROS             = 27,   // most leading zeros of a divisor, 0 .. Y_W - 1
    parameter MULTIPLIER_STAGES = 1,
    parameter BESIDE_W          = 1     // bits of what goes with the operands
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

    localparam ROUNDS = (Q_W + 15) / 16;
    localparam K      = (Q_W + ROUNDS - 1) / ROUNDS;  // quotient bits of a round
    localparam T      = K > 2 ? (K - 1) / 2 : 1;      // address bits of the table
    localparam W      = T + 5;                        // bits of the divisor after those
    localparam V      = T + 5;                        // fraction bits of the slope
    localparam G      = K + 2;                        // fraction bits of the reciprocal
    localparam U      = G + 4;                        // fraction bits of the line before it is cut
    localparam DROP   = T + V + W - U;                // bits of the product slope * part that are below those

    // The divisor with zeros behind it where it is shorter than what the table looks at.
    localparam N_W   = Y_W > T + W + 1 ? Y_W : T + W + 1;
    localparam PAD   = N_W - Y_W;
    localparam ALL_W = N_W + ROUNDS * K;  // of the dividend, shifted as the divisor is

    // ---- normal: divisor 2^(N_W-1) .. 2^N_W - 1 ------------------------------------------------------------------
    localparam [31:0] LAST = Y_W - 1;

    function [5:0] leading_zeros(input [Y_W-1:0] x);
        integer k;
        begin
            leading_zeros = 6'd0;
            for (k = Y_W - 1 - ZEROS; k < Y_W; k = k + 1) if (x[k]) leading_zeros = LAST[5:0] - k[5:0];
        end
    endfunction
    wire         [5:0] shift = leading_zeros(divisor_i);
    wire   [ALL_W-1:0] dividend_wide = {{(ALL_W - X_W - PAD) {1'b0}}, dividend_i, {PAD{1'b0}}};
    wire     [N_W-1:0] divisor_wide = {divisor_i, {PAD{1'b0}}};
    reg    [ALL_W-1:0] dividend_0_q;
    reg      [N_W-1:0] divisor_0_q;
    reg          [5:0] shift_0_q;
    reg [BESIDE_W-1:0] beside_0_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            dividend_0_q <= dividend_wide << shift;
            divisor_0_q  <= divisor_wide << shift;
            shift_0_q    <= shift;
            beside_0_q   <= beside_i;
        end
    end

    // ---- reciprocal: floor((offset - floor(slope part / 2^DROP)) / 2^4) at G fraction bits, for the divisor as 1 .. 2 ----
    // The tangent of 1 / x at the middle m of the interval that the address names: below 1 / x, by 2^-(2T+2) at most. Its
    // value is taken at the upper end of what the bits seen of the divisor allow.
    //   middle = m 2^(T+1); slope = ceil(2^V / m^2); offset = floor(2^U (1 / m + 2^-(T+1) / m^2)) - ceil(slope / 2^DROP)
    // - 1, where the last 1 makes up for the floor of the product.
    localparam SLOPE_W  = V + 1;
    localparam OFFSET_W = U + 1;
    localparam ENTRY_W  = OFFSET_W + SLOPE_W;

    function [ENTRY_W-1:0] entry(input integer address);
        /* verilator lint_off UNUSED */  // the upper bits, which are 0
        reg [63:0] middle, square, slope, start;
        /* verilator lint_on UNUSED */
        begin
            middle = (64'd1 << (T + 1)) + (address * 2 + 1);
            square = middle * middle;
            slope  = ((64'd1 << (V + 2 * T + 2)) + square - 64'd1) / square;
            start  = ((middle + 64'd1) << (U + T + 1)) / square - ((slope + (64'd1 << DROP) - 64'd1) >> DROP) - 64'd1;
            entry  = {start[OFFSET_W-1:0], slope[SLOPE_W-1:0]};
        end
    endfunction

    (* ram_style = "logic", rom_style = "logic" *)  // a block memory would take a clock more
    reg [ENTRY_W-1:0] entries[0:(1<<T)-1];
    integer           a;
    initial for (a = 0; a < 1 << T; a = a + 1) entries[a] = entry(a);

    wire [ENTRY_W-1:0] now = entries[divisor_0_q[N_W-2:N_W-1-T]];

    wire [OFFSET_W-1:0] offset;
    /* verilator lint_off UNUSED */  // the low bits of the product are those that are cut
    wire [SLOPE_W+W-1:0] product;
    wire  [OFFSET_W-1:0] line = offset - {{(OFFSET_W + DROP - SLOPE_W - W) {1'b0}}, product[SLOPE_W+W-1:DROP]};
    /* verilator lint_on UNUSED */
    wire         [G-1:0] reciprocal = line[U-1:U-G];  // below 1
    glint_multiplier #(
        .A_W   (SLOPE_W),
        .B_W   (W),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (now[SLOPE_W-1:0]),
        .b_i      (divisor_0_q[N_W-2-T:N_W-1-T-W]),
        .product_o(product)
    );
    glint_delay #(
        .WIDTH (OFFSET_W),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_offset (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (now[ENTRY_W-1:SLOPE_W]),
        .data_o  (offset)
    );

    // ---- rounds: from a remainder below the divisor and K more bits of the dividend, K bits of the quotient -----------
    genvar i;
    generate
        for (i = 0; i < ROUNDS; i = i + 1) begin : round
            wire        [G-1:0] factor;     // the reciprocal
            wire      [N_W-1:0] divisor;
            /* verilator lint_off UNUSED */  // after the last round
            wire    [ALL_W-1:0] rest;       // remainder, bits of the dividend, bits of the quotient
            /* verilator lint_on UNUSED */
            wire          [5:0] places;
            wire [BESIDE_W-1:0] beside;
            if (i == 0) begin : first
                assign factor = reciprocal;
                glint_delay #(
                    .WIDTH (N_W + ALL_W + 6 + BESIDE_W),
                    .STAGES(MULTIPLIER_STAGES)
                ) delay (
                    .clk_i   (clk_i),
                    .enable_i(enable_i),
                    .data_i  ({divisor_0_q, dividend_0_q, shift_0_q, beside_0_q}),
                    .data_o  ({divisor, rest, places, beside})
                );
            end else begin : next
                assign factor  = round[i-1].factor_q;
                assign divisor = round[i-1].divisor_q;
                assign rest    = round[i-1].rest_q;
                assign places  = round[i-1].places_q;
                assign beside  = round[i-1].beside_q;
            end

            // estimate = floor(x r) for x the value of the upper bits with one fraction bit, K + 2 bits, and r the
            // reciprocal: x r is never above the quotient, and less than 2 below it, as tests/rtl/reciprocal_bound.py finds
            // for every entry of the table and every K.
            /* verilator lint_off UNUSED */  // what is below the estimate, and above it 0
            wire [K+G+1:0] scaled;
            /* verilator lint_on UNUSED */
            wire   [K-1:0] estimate = scaled[G+K:G+1];
            glint_multiplier #(
                .A_W   (G),
                .B_W   (K + 2),
                .STAGES(MULTIPLIER_STAGES)
            ) multiplier_estimate (
                .clk_i    (clk_i),
                .enable_i (enable_i),
                .a_i      (factor),
                .b_i      (rest[ALL_W-1:ALL_W-K-2]),
                .product_o(scaled)
            );

            wire        [G-1:0] factor_1;
            wire      [N_W-1:0] divisor_1;
            wire    [ALL_W-1:0] rest_1;
            wire          [5:0] places_1;
            wire [BESIDE_W-1:0] beside_1;
            glint_delay #(
                .WIDTH (G + N_W + ALL_W + 6 + BESIDE_W),
                .STAGES(MULTIPLIER_STAGES)
            ) delay_1 (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  ({factor, divisor, rest, places, beside}),
                .data_o  ({factor_1, divisor_1, rest_1, places_1, beside_1})
            );

            /* verilator lint_off UNUSED */  // the remainder shows in the low bits
            wire [N_W+K-1:0] taken;
            /* verilator lint_on UNUSED */
            glint_multiplier #(
                .A_W   (N_W),
                .B_W   (K),
                .STAGES(MULTIPLIER_STAGES)
            ) multiplier_taken (
                .clk_i    (clk_i),
                .enable_i (enable_i),
                .a_i      (divisor_1),
                .b_i      (estimate),
                .product_o(taken)
            );

            // The estimate is 0, 1 or 2 too small, so what is left is below 3 times the divisor, and less once or twice
            // the divisor it is not below -2 times it: N_W + 2 bits, modulo which all is computed. Beside the product:
            // what it will be taken from, and the estimate, both for each of the three cases.
            localparam L_W = N_W + 2;

            wire [L_W-1:0] whole = rest_1[ALL_W-N_W-K+:L_W];
            reg  [L_W-1:0] whole_0_q, whole_1_q, whole_2_q;
            reg    [K-1:0] digit_0_q, digit_1_q, digit_2_q;
            always @(posedge clk_i) begin
                if (enable_i) begin
                    whole_0_q <= whole;
                    whole_1_q <= whole - {2'b00, divisor_1};
                    whole_2_q <= whole - {1'b0, divisor_1, 1'b0};
                    digit_0_q <= estimate;
                    digit_1_q <= estimate + {{(K - 1) {1'b0}}, 1'b1};
                    digit_2_q <= estimate + {{(K - 2) {1'b0}}, 2'b10};
                end
            end

            wire   [L_W-1:0] whole_0, whole_1, whole_2;
            wire     [K-1:0] digit_0, digit_1, digit_2;
            glint_delay #(
                .WIDTH (3 * L_W + 3 * K),
                .STAGES(MULTIPLIER_STAGES - 1)
            ) delay_cases (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  ({whole_0_q, whole_1_q, whole_2_q, digit_0_q, digit_1_q, digit_2_q}),
                .data_o  ({whole_0, whole_1, whole_2, digit_0, digit_1, digit_2})
            );

            wire        [G-1:0] factor_2;
            wire      [N_W-1:0] divisor_2;
            /* verilator lint_off UNUSED */  // the remainder before this round
            wire    [ALL_W-1:0] rest_2;
            /* verilator lint_on UNUSED */
            wire          [5:0] places_2;
            wire [BESIDE_W-1:0] beside_2;
            glint_delay #(
                .WIDTH (G + N_W + ALL_W + 6 + BESIDE_W),
                .STAGES(MULTIPLIER_STAGES)
            ) delay_2 (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  ({factor_1, divisor_1, rest_1, places_1, beside_1}),
                .data_o  ({factor_2, divisor_2, rest_2, places_2, beside_2})
            );

            /* verilator lint_off UNUSED */  // the upper bits of what is kept
            wire [L_W-1:0] left_0 = whole_0 - taken[L_W-1:0];
            wire [L_W-1:0] left_1 = whole_1 - taken[L_W-1:0];
            wire [L_W-1:0] left_2 = whole_2 - taken[L_W-1:0];
            /* verilator lint_on UNUSED */
            wire           fits_1 = ~left_1[L_W-1];
            wire           fits_2 = ~left_2[L_W-1];
            wire [N_W-1:0] remainder = fits_2 ? left_2[N_W-1:0] : fits_1 ? left_1[N_W-1:0] : left_0[N_W-1:0];
            wire   [K-1:0] digit = fits_2 ? digit_2 : fits_1 ? digit_1 : digit_0;

            /* verilator lint_off UNUSED */  // after the last round
            reg        [G-1:0] factor_q;
            reg      [N_W-1:0] divisor_q;
            reg          [5:0] places_q;
            reg    [ALL_W-1:0] rest_q;
            /* verilator lint_on UNUSED */
            reg [BESIDE_W-1:0] beside_q;
            /* verilator lint_off UNUSED */  // the bits that were taken
            // What has left the dividend at its upper end comes back as quotient at the lower one.
            wire [ALL_W-N_W+K-1:0] low = {rest_2[ALL_W-N_W-1:0], digit};
            /* verilator lint_on UNUSED */
            always @(posedge clk_i) begin
                if (enable_i) begin
                    factor_q  <= factor_2;
                    divisor_q <= divisor_2;
                    places_q  <= places_2;
                    beside_q  <= beside_2;
                    rest_q    <= {remainder, low[ALL_W-N_W-1:0]};
                end
            end
        end
    endgenerate

    // Back from where the divisor begins with a 1; what is dropped is 0.
    /* verilator lint_off UNUSED */
    wire [N_W-1:0] remainder_normal = round[ROUNDS-1].rest_q[ALL_W-1:ALL_W-N_W] >> round[ROUNDS-1].places_q;
    /* verilator lint_on UNUSED */
    assign quotient_o  = round[ROUNDS-1].rest_q[Q_W-1:0];
    assign remainder_o = remainder_normal[N_W-1:PAD];
    assign beside_o    = round[ROUNDS-1].beside_q;

endmodule

`default_nettype wire
