// Included at the end of a copy of glint_sqrt.

`ifdef PROVE_SQRT

// ---- the lemma of one stage ----------------------------------------------------------------------------------------
// From a remainder of at most twice the root, and two more bits, a stage makes a bit of the root, `fits`, and a remainder
// of at most twice the new root: 4 remainder + bits = fits (4 root + 1) + reduced, which is
// 4 (root^2 + remainder) + bits = (2 root + fits)^2 + reduced. It speaks of one clock and any state: it is unbounded.
wire [Y_W-1:0] step_ok, moves_ok;
generate
    for (i = 0; i < Y_W; i = i + 1) begin : lemma
        wire [Y_W+3:0] root, remainder, before;
        if (i == 0) begin : first
            assign root      = 0;
            assign before    = radicand_i[2*Y_W-1:2*Y_W-2];
            assign remainder = 0;
        end else begin : rest
            assign root      = stage[i-1].root_q;
            assign before    = {stage[i-1].remainder_q, 2'b00} + stage[i-1].waiting.bits_q[2*(Y_W-i)-1:2*(Y_W-i)-2];
            assign remainder = stage[i-1].remainder_q;
        end
        wire [Y_W+3:0] taken = stage[i].fits ? {root, 2'b01} : 0;
        wire [Y_W+3:0] most  = {root, stage[i].fits, 1'b0};
        assign step_ok[i] = remainder > {root, 1'b0} || (stage[i].reduced <= most && taken + stage[i].reduced == before);

        // What the registers of the stage must hold now: what they were given at the last enabled clock.
        reg [Y_W+3:0] reduced_q, appended_q;
        always @(posedge clk_i) begin
            if (enable_i) begin
                reduced_q  <= stage[i].reduced;
                appended_q <= {root, stage[i].fits};
            end
        end
        assign moves_ok[i] = stage[i].remainder_q == reduced_q && stage[i].root_q == appended_q;
    end
endgenerate

reg started;  // an enabled clock has passed
initial started = 0;
always @(posedge clk_i) started <= started | enable_i;

always @* begin
    one_stage: assert (&step_ok);
    if (started) stage_moves: assert (&moves_ok);
end

// ---- the whole root ------------------------------------------------------------------------------------------------
// The solver picks a clock at which it begins to watch a radicand. What the products of this say in full, for reduced
// widths: after stage i the top bits of the radicand are root^2 + remainder, the others wait.
`ifdef MULTIPLY
(* anyseq *) wire watch;
reg              watching;
reg  [2*Y_W-1:0] radicand;
reg        [7:0] place;  // the stage whose registers hold the watched radicand
initial watching = 0;

wire [Y_W-1:0] place_ok;
generate
    for (i = 0; i < Y_W; i = i + 1) begin : chain
        wire [2*Y_W+1:0] root = stage[i].root_q;
        wire [2*Y_W+1:0] remainder = stage[i].remainder_q;
        wire waits;
        if (i < Y_W - 1) begin : more
            wire [2*Y_W-1:0] left = radicand & ((1 << 2 * (Y_W - 1 - i)) - 1);
            assign waits = stage[i].waiting.bits_q == left;
        end else begin : none
            assign waits = 1;
        end
        assign place_ok[i] = place != i || (waits && root * root + remainder == radicand >> 2 * (Y_W - 1 - i)
            && remainder <= root << 1);
    end
endgenerate

always @(posedge clk_i) begin
    if (enable_i) begin
        if (watch && !watching) begin
            watching <= 1;
            radicand <= radicand_i;
            place    <= 0;
        end else begin
            place <= place + 1;
            if (place == Y_W - 1) watching <= 0;
        end
    end
end

// Without enable nothing moves.
reg           held_q;
reg [2*Y_W:0] outputs_q;
initial held_q = 0;
always @(posedge clk_i) begin
    held_q    <= ~enable_i;
    outputs_q <= {root_o, remainder_o};
end

wire [2*Y_W+1:0] full_root = root_o;
always @* begin
    if (watching && place == Y_W - 1)
        is_root: assert (full_root * full_root + remainder_o == radicand && remainder_o <= {root_o, 1'b0});
    if (held_q) holds: assert ({root_o, remainder_o} == outputs_q);
    if (watching) inv_place: assert (place < Y_W && &place_ok);

    cover_all_ones: cover (watching && place == Y_W - 1 && &radicand && held_q);
    cover_square:   cover (watching && place == Y_W - 1 && &root_o && remainder_o == 0);
    cover_before:   cover (watching && place == Y_W - 1 && root_o == 1 << (Y_W - 1) && remainder_o == {root_o, 1'b0});
    cover_zero:     cover (watching && place == Y_W - 1 && radicand == 0);
end
`endif

`endif
