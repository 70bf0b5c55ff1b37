// Included at the end of a copy of glint_divider_restoring.

`ifdef PROVE_DIVIDER

// ---- the lemma of one stage ----------------------------------------------------------------------------------------
// From a remainder below the divisor and one more dividend bit, a stage makes a quotient bit and a remainder below the
// divisor: 2 remainder + bit - divisor * fits = reduced. It speaks of one clock and any state, so it is unbounded.
`ifdef TWO_STAGES
localparam STAGES = 2;  // the first, and one of the others, which are all the same text
`else
localparam STAGES = Q_W;
`endif
wire [STAGES-1:0] step_ok, moves_ok;
generate
    for (i = 0; i < STAGES; i = i + 1) begin : lemma
        wire [Y_W-1:0] row_divisor = ~row[i].complement;  // at this width
        wire [Y_W-1:0] row_divisor_next = ~row[i].complement_next;
        wire [Y_W+1:0] twice = {row[i].remainder, 1'b0} + row[i].bits[Q_W-1];
        wire [Y_W+1:0] taken = row[i].fits ? row_divisor : 0;
        assign step_ok[i] = row[i].remainder >= row_divisor
            || (row[i].reduced < row_divisor && twice - taken == row[i].reduced);

        // What the registers of the stage must hold now: what they were given at the last enabled clock.
        reg [Y_W-1:0] reduced_q, divisor_q;
        reg [Q_W-1:0] bits_q;
        always @(posedge clk_i) begin
            if (enable_i) begin
                reduced_q <= row[i].reduced;
                divisor_q <= row_divisor;
                bits_q    <= {row[i].bits, row[i].fits};
            end
        end
        assign moves_ok[i] = row[i].remainder_next == reduced_q && row_divisor_next == divisor_q
            && row[i].bits_next == bits_q;
    end
endgenerate

reg started;  // an enabled clock has passed
initial started = 0;
always @(posedge clk_i) started <= started | enable_i;

always @* begin
    one_stage: assert (&step_ok);
    if (started) stage_moves: assert (&moves_ok);
end

// ---- the whole divider ---------------------------------------------------------------------------------------------
// The solver picks a clock at which it begins to watch operands within the contract. That quotient * divisor + remainder
// is the dividend is shown in two ways. With MULTIPLY it is said with the operator `*`: for reduced widths. Without, at
// full width, by Horner's rule: the books start at the dividend and become, in the clock that finds a quotient bit,
// twice themselves less bit * divisor * 2^Q_W, which makes 2^Q_W (dividend - quotient * divisor) in the end. The stages
// do the same subtraction on fewer bits, so the solver can follow.
localparam BOOK_W = Y_W + 2 * Q_W + 2;  // |dividend - quotient * divisor| < 2^(Y_W + Q_W + 1): no wrap hides an error

(* anyseq *) wire watch;
reg              watching;
reg    [X_W-1:0] dividend;
reg    [Y_W-1:0] divisor;
reg        [7:0] place;   // the row whose registers hold the watched operands
reg    [Q_W-1:0] found;   // the quotient bits so far
reg [BOOK_W-1:0] books;
reg [BESIDE_W-1:0] beside;  // what came in beside the operands
initial {watching} = 0;

wire [Q_W-1:0] fits, place_ok;
generate
    for (i = 0; i < Q_W; i = i + 1) begin : chain
        localparam [Q_W-1:0] SEEN = (1 << (i + 1)) - 1;  // where the quotient bits are; dividend bits wait above
        wire     [Q_W-1:0] seen = row[i].bits_next & SEEN;
        wire     [Y_W-1:0] row_divisor_next = ~row[i].complement_next;
        wire     [Q_W-1:0] waiting = row[i].bits_next & ~SEEN;
        assign fits[i] = row[i].fits;
        assign place_ok[i] = place != i || (row_divisor_next == divisor && row[i].remainder_next < divisor
`ifdef MULTIPLY
            && seen * divisor + {{Q_W{1'b0}}, row[i].remainder_next} == dividend >> (Q_W - 1 - i)
            && waiting == ({{Q_W{1'b0}}, dividend} << (i + 1) & {Q_W{1'b1}})
`else
            && seen == found && books == {row[i].remainder_next, waiting}
`endif
            && row[i].beside_next == beside);
    end
endgenerate

wire in_contract = divisor_i != 0 && {1'b0, dividend_i} < {divisor_i, {Q_W{1'b0}}};
wire next_fits = fits >> (place + 1);

always @(posedge clk_i) begin
    if (enable_i) begin
        if (watch && !watching) begin
            watching <= in_contract;
            dividend <= dividend_i;
            divisor  <= divisor_i;
            beside   <= beside_i;
            place    <= 0;
            found    <= fits[0];
            books    <= {dividend_i, 1'b0} - (fits[0] ? {divisor_i, {Q_W{1'b0}}} : 0);
        end else begin
            place    <= place + 1;
            found    <= {found, next_fits};
            books    <= {books, 1'b0} - (next_fits ? {divisor, {Q_W{1'b0}}} : 0);
            if (place == Q_W - 1) watching <= 0;
        end
    end
end

// Without enable nothing moves.
reg                   held_q;
reg [Q_W+Y_W+BESIDE_W-1:0] outputs_q;
initial held_q = 0;
always @(posedge clk_i) begin
    held_q    <= ~enable_i;
    outputs_q <= {quotient_o, remainder_o, beside_o};
end

always @* begin
    // Q_W enabled clocks after the operands: the contract.
    if (watching && place == Q_W - 1) begin
`ifdef MULTIPLY
        divides: assert (quotient_o * divisor + {{Q_W{1'b0}}, remainder_o} == dividend && remainder_o < divisor);
`else
        divides: assert (quotient_o == found && books == {remainder_o, {Q_W{1'b0}}} && remainder_o < divisor);
`endif
        beside_kept: assert (beside_o == beside);
    end
    if (held_q) holds: assert ({quotient_o, remainder_o, beside_o} == outputs_q);
    if (watching) inv_place: assert (place < Q_W && &place_ok);

    cover_all_ones: cover (watching && place == Q_W - 1 && &quotient_o && remainder_o != 0 && held_q);
    cover_top:      cover (watching && place == Q_W - 1 && quotient_o == 1 << (Q_W - 1) && remainder_o == 0);
    cover_largest:  cover (watching && place == Q_W - 1 && &divisor && remainder_o == divisor - 1);
    cover_zero:     cover (watching && place == Q_W - 1 && quotient_o == 0 && remainder_o == 0);
end

`endif
