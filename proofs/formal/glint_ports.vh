// Included at the end of a copy of glint_ports.

// Bookkeeping that the invariants rest on: for every slot of the pipeline, the number of items in the slots after it.
// The numbers of neighbours differ by one item or none, which is a relation that the solver can carry from clock to
// clock, where a count over all slots is not.
reg  [6*CLOCKS-1:0] after_q;
wire           [5:0] inside = after_q[5:0] + valid_q[0];  // items in all slots
wire   [CLOCKS-1:0] after_ok, after_bound;
genvar slot;
generate
    for (slot = 0; slot < CLOCKS; slot = slot + 1) begin : slots
        wire [5:0] after = after_q[6*slot+:6];
        wire [5:0] before;  // what this slot's number is made of at the next step: that of the item that comes in
        if (slot == 0) assign before = inside;
        else assign before = after_q[6*(slot-1)+:6];
        always @(posedge clk_i) begin
            if (!rst_ni) after_q[6*slot+:6] <= 0;
            else if (advance) after_q[6*slot+:6] <= before - valid_q[CLOCKS-1];
        end
        assign after_ok[slot]    = before == after + valid_q[slot] && (slot != CLOCKS - 1 || after == 0);
        assign after_bound[slot] = after < CLOCKS - slot && (slot == CLOCKS - 1 || after >= valid_q[CLOCKS-1]);
    end
endgenerate

always @* begin
    if (!$initstate) begin
        inv_after: assert (&after_ok);
        inv_after_bound: assert (&after_bound);
        if (ITERATIVE) inv_one: assert ((valid_q & (valid_q - 1)) == 0);
    end
end
