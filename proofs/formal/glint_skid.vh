// Included at the end of a copy of glint_skid.

`ifdef PROVE_SKID

wire             watching;
wire [WIDTH-1:0] item;
wire       [7:0] in_flight, ahead, patience, drought, ready_run;

glint_scoreboard #(
    .WIDTH     (WIDTH),
    .CAPACITY  (2),
    .PATIENCE  (2),
    .DROUGHT   (1),
    .RATE      (1),
    .REGISTERED(1)
) scoreboard (
    .clk       (clk_i),
    .rst_n     (rst_ni),
    .in_valid  (valid_i),
    .in_ready  (ready_o),
    .in_data   (data_i),
    .out_valid (valid_o),
    .out_ready (ready_i),
    .out_data  (data_o),
    .out_result(1'b0),
    .watch_now (),
    .watching  (watching),
    .item      (item),
    .in_flight (in_flight),
    .ahead     (ahead),
    .patience  (patience),
    .drought   (drought),
    .ready_run (ready_run)
);

always @* begin
    if (!$initstate) begin
        inv_count: assert (in_flight == valid_q + spare_full_q);
        inv_spare: assert (!(spare_full_q && (ready_q || !valid_q)));
        if (in_flight != 0) inv_drought: assert (drought == 0);
        // Not ready with room to spare: only in the clock after reset.
        if (!ready_q && !spare_full_q) inv_ready: assert (in_flight == 0 && ready_run == 0);
        if (watching) begin
            inv_place: assert (ahead < in_flight && (ahead == 0 ? data_q : spare_q) == item);
            inv_patience: assert (patience + ahead < 2);
        end
    end
end

`endif
