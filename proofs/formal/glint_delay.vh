// Included at the end of a copy of glint_delay.

// All registers side by side, stage 0 at the bottom, for the invariants of the units that contain a glint_delay.
wire [WIDTH*STAGES-1:0] contents;
generate
    for (i = 0; i < STAGES; i = i + 1) begin : probe
        assign contents[i*WIDTH+:WIDTH] = stage[i].data_q;
    end
endgenerate

`ifdef PROVE_DELAY

// The solver picks a clock at which it begins to watch what goes in. There is no reset: the proof starts anywhere.
(* anyseq *) wire watch;
reg               watching;
reg   [WIDTH-1:0] value;
reg         [7:0] place;  // the stage that holds the watched value
reg               held_q;
reg   [WIDTH-1:0] data_o_q;
initial {watching, held_q} = 0;

always @(posedge clk_i) begin
    held_q   <= ~enable_i;
    data_o_q <= data_o;
    if (enable_i) begin
        if (watch && !watching) begin
            watching <= 1;
            value    <= data_i;
            place    <= 0;
        end else begin
            place <= place + 1;
            if (place == STAGES - 1) watching <= 0;
        end
    end
end

always @* begin
    // What goes in comes out STAGES enabled clocks later.
    if (watching && place == STAGES - 1) comes_out: assert (data_o == value);
    // Without enable nothing moves.
    if (held_q) holds: assert (data_o == data_o_q);
    if (watching) inv_place: assert (place < STAGES && contents[place*WIDTH+:WIDTH] == value);

    cover_comes_out: cover (watching && place == STAGES - 1 && value != contents[WIDTH-1:0]);
    cover_holds:     cover (watching && place == STAGES - 1 && held_q);
end

`endif
