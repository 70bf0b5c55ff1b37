// Included at the end of a copy of a lobe's unit, behind unit.vh: `y` and `clamped` belong to their own input.
//
// Beside the unit runs another of the same text. Both see the same valid, ready, reset and tag; what their registers hold at first,
// and all operands, differ, but those of the watched input. When its result is there, both answer the same, so nothing but that input
// went into it. own.py puts the instance `other` and the invariants of the registers, `same_registers`, before this.

wire same_valid = \other.ports.valid_q == \ports.valid_q ;

always @* begin
    if (watch_now) assume (other_n == n_i && other_cos == cos_i);

    keeps_step: assert (other_valid == valid_o && other_ready == ready_o);
    // The k-th result, where the watched input was the k-th: `ahead` of them came before it.
    if (rst_ni && valid_o && watching && ahead == 0) own_input: assert (y_o == other_y && clamped_o == other_clamped);

    if (!$initstate) begin
        inv_valid: assert (same_valid);
        inv_own: assert (&(~mark_q | same_registers));
    end
end
