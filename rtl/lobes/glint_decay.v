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
    parameter W = 4,   // address bits of the octave of fall, at most $clog2(F)
    parameter N = 1,   // 1: exponent has an entry for each n; 0: 512 entries, after the leading one of n
    parameter O = 12,  // fraction bits of the output
    parameter MULTIPLIER_STAGES = 1,  // clocks of a product
    parameter DEEP              = 0,  // 1: a register after each step of normalisation, and behind each table
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
    output wire               fall_clear_o,       // one clock after the address; with DEEP the entry is then to be 0
    input  wire [2*O+2*G-H-2:0] fall_entry_i      // {base, slope}
);

    // Clocks: 1 correct, 2 normalise, 1 tables, 2 x, 1 fall, 2 y; DEEP adds E_W - 2 to normalise, 1 to a table and
    // to y. Products: one for x, one for y.
    localparam E_W    = $clog2(F);
    localparam CLOCKS = LATENCY + PRODUCTS * (MULTIPLIER_STAGES - 1) + DEEP * (E_W + 1);

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

    // d - 1 = 2^F - 1 - C, for C below 2^F. The register holds C: so the inverters are in the LUTs after it.
    reg [F-1:0] cosine_q;
    always @(posedge clk_i) if (advance) cosine_q <= cos_i[F-1:0];

    wire [E_W-1:0] octave_d;
    wire   [M-1:0] m;
    glint_normalise #(
        .WIDTH  (F),
        .SHIFT_W(E_W),
        .OUT_W  (M),
        .FILL   (1),
        .DEEP   (DEEP)
    ) normalise_distance (
        .clk_i   (clk_i),
        .enable_i(advance),
        .x_i     (~cosine_q),
        .kept_o  (octave_d),
        .rest_o  (m)
    );

    // k + 6 is beside octave, which is octave_d, with DEEP one clock later; lambda comes one clock after it.
    wire [E_W-1:0] octave_late;
    glint_delay #(
        .WIDTH (E_W),
        .STAGES(DEEP)
    ) delay_octave (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (octave_d),
        .data_o  (octave_late)
    );
    wire [9:0] n_late;
    glint_delay #(
        .WIDTH (10),
        .STAGES(N != 0 ? (DEEP != 0 ? E_W : 2) : (DEEP != 0 ? E_W - 3 : 1))
    ) delay_n (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  ({n_i[9:1], n_i[0] | (N == 0 & first)}),  // 0 as 1: x is not below 6
        .data_o  (n_late)
    );
    wire   [3:0] octave_n;
    wire [V-1:0] lambda;
    generate
        if (N != 0) begin : all
            reg [V-1:0] lambda_q;
            always @(posedge clk_i) if (advance) lambda_q <= exponent_entry_i[V-1:0];
            assign exponent_address_o = n_late;
            assign octave_n           = exponent_entry_i[V+3:V];
            assign lambda             = lambda_q;
        end else begin : normalised
            wire [3:0] octave_k;
            glint_normalise #(
                .WIDTH  (10),
                .SHIFT_W(4),
                .OUT_W  (9),
                .FILL   (0),
                .DEEP   (DEEP)
            ) normalise_n (
                .clk_i   (clk_i),
                .enable_i(advance),
                .x_i     (n_late),
                .kept_o  (octave_k),
                .rest_o  (exponent_address_o)
            );
            glint_delay #(
                .WIDTH (4),
                .STAGES(DEEP)
            ) delay_k (
                .clk_i   (clk_i),
                .enable_i(advance),
                .data_i  (octave_k),
                .data_o  (octave_n)
            );
            assign lambda = exponent_entry_i;
        end
    endgenerate

    // w is base and a part of slope; the octaves of d and n come with base.
    localparam R       = M - A;
    localparam BASE_W  = V + 2;
    localparam SLOPE_W = V + 2 - (A < 4 ? A : 4);
    assign logarithm_address_o = {octave_d, m[M-1:R]};
    wire [R-1:0] r;
    glint_delay #(
        .WIDTH (R),
        .STAGES(1 + DEEP)
    ) delay_r (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (m[R-1:0]),
        .data_o  (r)
    );
    reg [E_W:0] octaves_q;
    always @(posedge clk_i) begin
        if (advance) octaves_q <= {1'b0, octave_late} + {{(E_W - 3) {1'b0}}, octave_n};
    end

    // x is 6 .. 2^E_W + 20: that many octaves are told apart modulo 2^(E_W + 1), since E_W is at least 4.
    localparam X_W    = V + E_W + 1;
    localparam Q      = V - H;
    localparam FALL_W = O + G;
    localparam STEP_W = O + G - H - 1;
    wire [FALL_W-1:0] base_late;
    wire      [O-1:0] fall_late;
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
        .b_i      (r),
        .product_o(logarithm_product)
    );
    assign sum = {{(E_W - 1) {1'b0}}, logarithm_entry_i[BASE_W+SLOPE_W-1:SLOPE_W]} + {octaves_q, lambda};
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

    // The table of fall holds 2^W octaves of x, which end at x = END. Before them y stays next to 1, after them 0.
    localparam [31:0] END   = (1 << E_W) + 10;
    localparam [31:0] BEGIN = END - (1 << W);
    // As vectors of the answers: a comparison would become an adder.
    localparam [(2<<E_W)-1:0] ALL   = {(2 << E_W) {1'b1}};
    localparam [(2<<E_W)-1:0] EARLY = ~(ALL << BEGIN) & (ALL << 6);
    localparam [(2<<E_W)-1:0] LATE  = (ALL << END) | ~(ALL << 6);
    wire [E_W:0] octave = x_q[X_W-1:V];
    wire         early  = EARLY[octave];
    reg          early_q, late_q;
    always @(posedge clk_i) begin
        if (advance) begin
            early_q <= early;
            late_q  <= LATE[octave];
        end
    end
    assign fall_address_o = x_q[V+W-1:Q];
    assign fall_clear_o   = early_q;
    // With DEEP the table clears its entry, in the register behind the memory; else q is cleared before, the base after it.
    wire clear_q    = DEEP == 0 & early;
    wire clear_base = DEEP == 0 & early_q;
    wire [Q-1:0] q;
    wire         late;
    glint_delay #(
        .WIDTH (Q),
        .STAGES(1 + DEEP)
    ) delay_q (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (clear_q ? {Q{1'b0}} : x_q[Q-1:0]),
        .data_o  (q)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(DEEP)
    ) delay_late (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (late_q),
        .data_o  (late)
    );

    glint_multiplier #(
        .A_W   (STEP_W),
        .B_W   (Q),
        .STAGES(MULTIPLIER_STAGES)
    ) fall_multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (fall_entry_i[STEP_W-1:0]),
        .b_i      (q),
        .product_o(fall_product)
    );
    glint_delay #(
        .WIDTH (FALL_W),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_base (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (clear_base ? {FALL_W{1'b0}} : fall_entry_i[FALL_W+STEP_W-1:STEP_W]),
        .data_o  (base_late)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(CLOCKS - MULTIPLIER_STAGES - DEEP - 1)
    ) delay_none (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (below | one | whole),
        .data_o  (none)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(MULTIPLIER_STAGES + DEEP)
    ) delay_after (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (none | late),
        .data_o  (none_late)
    );

    glint_delay #(
        .WIDTH (O),
        .STAGES(DEEP)
    ) delay_fall (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (fall[FALL_W-1:G]),
        .data_o  (fall_late)
    );

    reg [O:0] y_q;
    always @(posedge clk_i) begin
        if (advance) begin
            y_q[O]     <= one_late;
            y_q[O-1:0] <= none_late ? {O{1'b0}} : first_late ? linear_late : ~fall_late;
        end
    end
    assign y_o = y_q;

endmodule

`default_nettype wire
