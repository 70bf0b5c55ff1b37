// glint_decay: c^n from tables of logarithms and of exp(-2^x), in fixed point, one result a clock.
//
// The arithmetic is docs/lobes/decay.md; a value here carries the name that it has there.
// Ports and parameters: there too; handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_decay #(
    parameter F = 18,  // fraction bits of the cosine
    parameter A = 4,   // address bits of logarithm within an octave
    parameter M = 12,  // bits of m, what follows the leading one of the distance
    parameter V = 12,  // fraction bits of w, lambda and x
    parameter H = 4,   // address bits of fall within an octave
    parameter G = 1,   // guard bits of fall
    parameter W = 4,   // address bits of the octave of fall
    parameter N = 1,   // 1: exponent has an entry for each n; 0: 512 entries, after the leading one of n
    parameter O = 12,  // fraction bits of the output
    parameter MULTIPLIER_STAGES = 1,  // clocks of a product
    parameter LATENCY           = 2,  // clocks without those of the divider, and products: what the blocks on the way
    parameter PRODUCTS          = 0,  // add up to, from `glint emit`
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire       [9:0] n_i,      // specular exponent
    input  wire     [F+1:0] cos_i,    // cosine, signed, code / 2^F
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire       [O:0] y_o,      // result, code / 2^O, 0 .. 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o, // an input was out of range and was corrected
    output wire             table_enable_o,
    output wire [$clog2(F)+A-1:0] logarithm_address_o,
    input  wire [2*V+3-(A<4?A:4):0] logarithm_entry_i,  // {base, slope}
    output wire       [N+8:0] exponent_address_o,
    input  wire   [V+4*N-1:0] exponent_entry_i,   // {k + 6, lambda}; without N, lambda
    output wire     [W+H-1:0] fall_address_o,
    input  wire [2*O+2*G-H-2:0] fall_entry_i      // {base, slope}
);

    // Clocks: 1 correct, 2 normalise, 1 tables, 2 x, 1 fall, 2 y. Products: one for x, one for y.
    localparam CLOCKS = LATENCY + PRODUCTS * (MULTIPLIER_STAGES - 1);

    // Corrections: a cosine of 0 or less gives 0, one of 1 or more 1. n = 0 gives what n = 1 gives.
    wire advance;
    wire below = cos_i[F+1];
    wire one   = ~below & cos_i[F];
    wire whole = ~|cos_i[F-1:0];
    wire first = ~|n_i[9:1];
    glint_stream #(
        .LATENCY(CLOCKS),
        .TAG_W  (TAG_W)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .clamped_i(below | (one & ~whole) | (first & ~n_i[0])),
        .tag_i    (tag_i),
        .valid_o  (valid_o),
        .ready_i  (ready_i),
        .tag_o    (tag_o),
        .clamped_o(clamped_o),
        .advance_o(advance)
    );
    assign table_enable_o = advance;

    // What does not come from the tables; it stands beside the last step.
    wire         none_late, one_late, first_late;
    wire [O-1:0] linear_late;
    glint_delay #(
        .WIDTH (O + 2),
        .STAGES(CLOCKS - 1)
    ) delay_linear (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  ({one, first, cos_i[F-1:F-O]}),
        .data_o  ({one_late, first_late, linear_late})
    );

    // d - 1 = 2^F - 1 - C, for C below 2^F.
    reg [F-1:0] distance_q;
    reg   [9:0] n_q;
    always @(posedge clk_i) begin
        if (advance) begin
            distance_q <= ~cos_i[F-1:0];
            n_q        <= n_i;
        end
    end

    localparam E_W = $clog2(F);
    wire [E_W-1:0] octave_d;
    wire   [M-1:0] m;
    glint_normalise #(
        .WIDTH  (F),
        .SHIFT_W(E_W),
        .OUT_W  (M),
        .FILL   (1)
    ) normalise_distance (
        .clk_i   (clk_i),
        .enable_i(advance),
        .x_i     (distance_q),
        .kept_o  (octave_d),
        .rest_o  (m)
    );

    // k + 6 beside octave_d, lambda one clock later.
    wire   [3:0] octave_n;
    wire [V-1:0] lambda;
    generate
        if (N != 0) begin : all
            reg   [9:0] n_2_q;
            reg [V-1:0] lambda_q;
            always @(posedge clk_i) begin
                if (advance) begin
                    n_2_q    <= n_q;
                    lambda_q <= exponent_entry_i[V-1:0];
                end
            end
            assign exponent_address_o = n_2_q;
            assign octave_n           = exponent_entry_i[V+3:V];
            assign lambda             = lambda_q;
        end else begin : normalised
            glint_normalise #(
                .WIDTH  (10),
                .SHIFT_W(4),
                .OUT_W  (9),
                .FILL   (0)
            ) normalise_n (
                .clk_i   (clk_i),
                .enable_i(advance),
                .x_i     (n_q),
                .kept_o  (octave_n),
                .rest_o  (exponent_address_o)
            );
            assign lambda = exponent_entry_i;
        end
    endgenerate

    // w is base and a part of slope; the octaves of d and n come with base.
    localparam R       = M - A;
    localparam BASE_W  = V + 2;
    localparam SLOPE_W = V + 2 - (A < 4 ? A : 4);
    assign logarithm_address_o = {octave_d, m[M-1:R]};
    reg [R-1:0] r_q;
    reg [E_W:0] octaves_q;
    always @(posedge clk_i) begin
        if (advance) begin
            r_q       <= m[R-1:0];
            octaves_q <= {1'b0, octave_d} + {{(E_W - 3) {1'b0}}, octave_n};
        end
    end

    localparam X_W    = V + E_W + 2;
    localparam Q      = V - H;
    localparam FALL_W = O + G;
    localparam STEP_W = O + G - H - 1;
    wire [FALL_W-1:0] base_late;
    wire              none;
    /* verilator lint_off UNUSED */  // what is below the last place
    wire [SLOPE_W+R-1:0] logarithm_product;
    wire [STEP_W+Q-1:0]  fall_product;
    wire [FALL_W-1:0]    fall = base_late + {{(FALL_W - STEP_W) {1'b0}}, fall_product[STEP_W+Q-1:Q]};
    /* verilator lint_on UNUSED */
    wire       [X_W-1:0] sum, sum_late;
    glint_multiplier #(
        .A_W   (SLOPE_W),
        .B_W   (R),
        .STAGES(MULTIPLIER_STAGES)
    ) logarithm_multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (logarithm_entry_i[SLOPE_W-1:0]),
        .b_i      (r_q),
        .product_o(logarithm_product)
    );
    assign sum = {{E_W{1'b0}}, logarithm_entry_i[BASE_W+SLOPE_W-1:SLOPE_W]} + {1'b0, octaves_q, lambda};
    glint_delay #(
        .WIDTH (X_W),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_sum (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (sum),
        .data_o  (sum_late)
    );
    reg [X_W-1:0] x_q;
    always @(posedge clk_i) begin
        if (advance) x_q <= sum_late + {{(X_W - SLOPE_W) {1'b0}}, logarithm_product[SLOPE_W+R-1:R]};
    end

    // The table of fall holds 2^W octaves of x, which end at x = 16 (mod 2^W). Before them y stays next to 1, after them 0.
    localparam       [31:0] END   = (1 << E_W) + 10;
    localparam       [31:0] BEGIN = END - (1 << W);
    // As a vector of the answers: a comparison would become an adder.
    localparam [(4<<E_W)-1:0] EARLY = ({{((4 << E_W) - 1) {1'b0}}, 1'b1} << BEGIN) - 1'b1;
    localparam [(4<<E_W)-1:0] LATE  = {(4 << E_W) {1'b1}} << END;
    wire [E_W+1:0] octave = x_q[X_W-1:V];
    wire           early  = EARLY[octave];
    wire           late   = LATE[octave];
    assign fall_address_o = x_q[V+W-1:Q];
    reg  [Q-1:0] q_q;
    reg          early_q, late_q;
    always @(posedge clk_i) begin
        if (advance) begin
            q_q      <= early ? {Q{1'b0}} : x_q[Q-1:0];
            early_q <= early;
            late_q  <= late;
        end
    end

    glint_multiplier #(
        .A_W   (STEP_W),
        .B_W   (Q),
        .STAGES(MULTIPLIER_STAGES)
    ) fall_multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (fall_entry_i[STEP_W-1:0]),
        .b_i      (q_q),
        .product_o(fall_product)
    );
    glint_delay #(
        .WIDTH (FALL_W),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_base (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (early_q ? {FALL_W{1'b0}} : fall_entry_i[FALL_W+STEP_W-1:STEP_W]),
        .data_o  (base_late)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(CLOCKS - MULTIPLIER_STAGES - 1)
    ) delay_none (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (below | one | whole),
        .data_o  (none)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_after (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (none | late_q),
        .data_o  (none_late)
    );

    reg [O:0] y_q;
    always @(posedge clk_i) begin
        if (advance) begin
            y_q[O]     <= one_late;
            y_q[O-1:0] <= none_late ? {O{1'b0}} : first_late ? linear_late : ~fall[FALL_W-1:G];
        end
    end
    assign y_o = y_q;

endmodule

`default_nettype wire
