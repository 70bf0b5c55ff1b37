"""Bugs that the proofs have to find, planted one by one in a copy of a module.

Of each: what breaks, the property that finds it, text, what stands there instead.
"""

PORTS = [
    ("stall_ignored", "stable", "wire              advance = ready_i | ~valid_q[CLOCKS-1];",
     "wire              advance = 1'b1;"),
    ("valid_waits_for_ready", "valid_does_not_wait", "advance = ready_i | ~valid_q[CLOCKS-1];", "advance = ready_i;"),
    ("item_lost", "delivered", "valid_q[CLOCKS-2:0], valid_i & room}", "valid_q[CLOCKS-2:0], valid_i & room & ready_i}"),
    ("bubble_comes_out", "nothing_invented", "valid_q[CLOCKS-2:0], valid_i & room}", "valid_q[CLOCKS-2:0], 1'b1}"),
    ("survives_reset", "nothing_invented", "if (!rst_ni) valid_q <= {CLOCKS{1'b0}};\n        else if (advance)",
     "if (advance)"),
    ("ready_in_reset", "silent_in_reset", "assign ready_o   = rst_ni & advance & room;", "assign ready_o   = advance & room;"),
    ("every_second_clock", "full_rate", "assign ready_o   = rst_ni & advance & room;",
     "assign ready_o   = rst_ni & advance & ~valid_q[0];"),
    ("accepts_when_full", "capacity", "assign ready_o   = rst_ni & advance & room;", "assign ready_o   = rst_ni;"),
    ("tag_stays_behind", "in_turn", ") delay_tag (\n                .clk_i   (clk_i),\n                .enable_i(advance),",
     ") delay_tag (\n                .clk_i   (clk_i),\n                .enable_i(ready_i),"),
]
STREAM = [
    ("stall_ignored", "stable", "wire               advance = ready_i | ~valid_q[LATENCY-1];",
     "wire               advance = 1'b1;"),
    ("valid_waits_for_ready", "valid_does_not_wait", "advance = ready_i | ~valid_q[LATENCY-1];", "advance = ready_i;"),
    ("item_lost", "delivered", "valid_q[LATENCY-2:0], valid_i}", "valid_q[LATENCY-2:0], valid_i & ready_i}"),
    ("bubble_comes_out", "nothing_invented", "valid_q[LATENCY-2:0], valid_i}", "valid_q[LATENCY-2:0], 1'b1}"),
    ("survives_reset", "nothing_invented", "if (!rst_ni) valid_q <= {LATENCY{1'b0}};\n        else if (advance)",
     "if (advance)"),
    ("ready_in_reset", "silent_in_reset", "assign ready_o   = rst_ni & advance;", "assign ready_o   = advance;"),
    ("every_second_clock", "full_rate", "assign ready_o   = rst_ni & advance;",
     "assign ready_o   = rst_ni & advance & ~valid_q[0];"),
    ("accepts_when_full", "capacity", "assign ready_o   = rst_ni & advance;", "assign ready_o   = rst_ni;"),
    ("tag_stays_behind", "in_turn", ".enable_i(advance),", ".enable_i(ready_i),"),
    ("clamped_of_the_next", "in_turn", "        .data_o  ({clamped_o, tag_o})\n    );",
     "        .data_o  ({clamped_late, tag_o})\n    );\n    wire clamped_late;\n    assign clamped_o = clamped_i;"),
]
HIGHLIGHT = [
    ("facing_and_clamped_swapped", "in_turn", "{facing, clamped_o, tag_o} =", "{clamped_o, facing, tag_o} ="),
    ("grazing_is_lit", "in_turn", "{~nl_i[F+1] & (|nl_i[F:0]),", "{~nl_i[F+1],"),
    ("lit_from_behind", "dark_behind", "lobe_y_i & {(O + 1) {facing}}", "lobe_y_i"),
]
SHADE = {
    "glint_effect_shade": [
        ("one_too_many", "capacity", "rst_ni & ~held_q[LOG_DEPTH] &", "rst_ni &"),
        ("joins_early", "terms_kept", "join_valid = &here;", "join_valid = here[0];"),
        ("clamped_unasked", "clamped_right", "clamped & asked[k+1];", "clamped;"),
        ("light_of_another", "sums_right", "i_q <= i;", "i_q <= i_i;"),
    ],
}
OWN = {
    "glint_quadratic": [
        ("runs_on", "own_input", ") delay_cosine (\n        .clk_i   (clk_i),\n        .enable_i(advance),",
         ") delay_cosine (\n        .clk_i   (clk_i),\n        .enable_i(1'b1),"),
        ("of_the_one_before", "own_input", ".STAGES(2 * MULTIPLIER_STAGES + 1)", ".STAGES(2 * MULTIPLIER_STAGES + 2)"),
        ("of_the_next", "own_input", ".b_i      (distance_1),", ".b_i      (distance),"),
    ],
    "glint_ports": [
        ("clamped_with_another", "own_input", ".data_i  ({above | below | none, tag_i}),", ".data_i  ({above | below | none | n_q[0], tag_i}),"),
    ],
}
LOBE_SELECT = [
    ("one_too_many", "capacity", "rst_ni & ~held_q[LOG_DEPTH];", "rst_ni;"),
    ("line_stands", "right", "line_q << PLACE_W | joining", "line_q | joining"),
    ("joins_late", "right", "(CLOCKS[8*i+:8]-1)*PLACE_W+:PLACE_W] = joining", "(LATENCY-1)*PLACE_W+:PLACE_W] = joining"),
    ("another_lobe", "right", "& {PLACE_W{unit_valid_i[i]}}", ""),
    ("clamped_lost", "right", "{done_above | clamped, done_tag, y}", "{clamped, done_tag, y}"),
]
PIXEL = [
    ("shade_is_not_asked", "in_turn", ".ready_i  (taken_i),", ".ready_i  (1'b1),"),
    ("runs_on", "in_turn", ".CLOCKS(CLOCKS)\n    ) wait_others (\n        .clk_i   (clk_i),\n        .rst_ni  (rst_ni),\n        .enable_i(advance),",
     ".CLOCKS(CLOCKS)\n    ) wait_others (\n        .clk_i   (clk_i),\n        .rst_ni  (rst_ni),\n        .enable_i(1'b1),"),
    ("a_clock_late", "in_turn", ".CLOCKS(CLOCKS)\n    ) wait_others", ".CLOCKS(CLOCKS + 1)\n    ) wait_others"),
    ("one_is_cut", "cut_right", "|sum[O+7:O] ?", "|sum[O+7:O+1] ?"),
]
PIXEL_WAIT = [("not_placed", "in_turn", "read_q  <= {A{1'b0}};", "read_q  <= read_q;")]
ITERATIVE = [
    ("second_item", "capacity", "room = ITERATIVE ? ~|valid_q[CLOCKS-2:0] : 1'b1;", "room = 1'b1;"),
    ("tag_of_another", "in_turn", "if (advance & load) begin\n                    negative_q",
     "if (advance) begin\n                    negative_q"),
]
AXIS = [
    ("sidebands_swapped", "in_turn", "({s_axis_tuser, s_axis_tlast,", "({s_axis_tlast, s_axis_tuser,"),
    ("cos_off_by_a_bit", "operands_kept", "s_axis_tdata[COS+F+1:COS]", "s_axis_tdata[COS+F:COS-1]"),
    ("y_shifted", "result_kept", "{(30 - O) {1'b0}}, y}", "{(29 - O) {1'b0}}, y, 1'b0}"),
    ("result_while_ready", "stable", "{clamped, {(30", "{clamped & m_axis_tready, {(30"),
    ("item_taken_twice", "nothing_invented", ".ready_i(ready_i),", ".ready_i(ready_i & m_axis_tready),"),
    ("output_not_reset", "silent_in_reset", ") skid_out (\n        .clk_i  (aclk),\n        .rst_ni (aresetn),",
     ") skid_out (\n        .clk_i  (aclk),\n        .rst_ni (1'b1),"),
]
WRAPPER = [
    ("core_never_stalls", "in_turn", ".ready_i  (out_ready),", ".ready_i  (1'b1),"),
    ("core_not_reset", "nothing_invented", ".rst_ni   (aresetn),", ".rst_ni   (1'b1),"),
]
LANES = [  # of the lanes after the first one
    ("ready_alone", "same_valid", ".m_axis_tvalid(),\n                    .m_axis_tready(m_axis_tready)",
     ".m_axis_tvalid(),\n                    .m_axis_tready(1'b1)"),
    ("number_steers", "same_valid", ".s_axis_tlast(1'b0),\n                    .s_axis_tvalid(s_axis_tvalid)",
     ".s_axis_tlast(1'b0),\n                    .s_axis_tvalid(s_axis_tvalid & s_axis_tdata[0])"),
    ("words_of_the_first", "own_words", "s_axis_tdata[k*32+:32]),\n                    .s_axis_tuser(1'b0)",
     "s_axis_tdata[0+:32]),\n                    .s_axis_tuser(1'b0)"),
]
LANES_UNIT = [("number_waits", "same_ready", ".ready_i(in_ready),", ".ready_i(in_ready & nl_i[9]),")]
LANES_SKID = [("not_reset", "same_ready", "ready_q      <= 1'b0;", "ready_q      <= ready_q;")]
WORDS = [
    ("sidebands_swapped", "in_turn", "({s_axis_tuser, s_axis_tlast,", "({s_axis_tlast, s_axis_tuser,"),
    ("field_off_by_a_bit", "operands_kept", "s_axis_tdata[19:0]", "s_axis_tdata[20:1]"),
    ("result_shifted", "result_kept", "18'd0, shown_y_o}", "17'd0, shown_y_o, 1'b0}"),
    ("core_never_stalls", "in_turn", ".ready_i  (out_ready),", ".ready_i  (1'b1),"),
    ("core_not_reset", "nothing_invented", ".rst_ni   (aresetn),", ".rst_ni   (1'b1),"),
    ("item_taken_twice", "nothing_invented", ".ready_i(in_ready),", ".ready_i(in_ready & m_axis_tready),"),
]
SKID = [
    ("spare_forgotten", "delivered", "valid_q <= spare_full_q | accept;", "valid_q <= accept;"),
    ("shown_twice", "nothing_invented", "valid_q <= spare_full_q | accept;", "valid_q <= valid_q | accept;"),
    ("order_lost", "in_turn", "data_q <= spare_full_q ? spare_q : data_i;", "data_q <= data_i;"),
    ("stall_ignored", "stable", "leave  = ready_i | ~valid_q;", "leave  = 1'b1;"),
    ("ready_after_reset", "silent_in_reset", "ready_q      <= 1'b0;", "ready_q      <= 1'b1;"),
    ("every_second_clock", "full_rate", "ready_q      <= ~spare_full;", "ready_q      <= ~spare_full & ~accept;"),
    ("accepts_when_full", "capacity", "ready_q      <= ~spare_full;", "ready_q      <= 1'b1;"),
    ("valid_pauses", "valid_does_not_wait", "assign valid_o = valid_q;", "assign valid_o = valid_q & ready_q;"),
]
FIFO = [
    ("pushed_and_shown", "in_turn", "written_q <= write_q;", "written_q <= write_q + {{LOG_DEPTH{1'b0}}, push_i};"),
    ("pop_ignored", "nothing_invented", "read_q    <= read;", "read_q    <= read_q;"),
    ("push_forgotten", "valid_does_not_wait", "{{LOG_DEPTH{1'b0}}, push_i};", "{{LOG_DEPTH{1'b0}}, push_i & ~pop_i};"),
    ("full_is_empty", "valid_does_not_wait", "valid_o = written_q != read_q;",
     "valid_o = written_q[LOG_DEPTH-1:0] != read_q[LOG_DEPTH-1:0];"),
    ("read_late", "in_turn", "data_q <= memory[read[LOG_DEPTH-1:0]];", "data_q <= memory[read_q[LOG_DEPTH-1:0]];"),
    ("output_runs_on", "stable", "read_q + {{LOG_DEPTH{1'b0}}, pop_i};", "read_q + {{LOG_DEPTH{1'b0}}, valid_o};"),
    ("not_reset", "silent_in_reset", "written_q <= {(LOG_DEPTH + 1) {1'b0}};", "written_q <= write_q;"),
]
DELAY = [
    ("stage_skipped", "comes_out", "data_q <= stage[i-1].data_q;", "data_q <= stage[0].data_q;"),
    ("enable_ignored", "holds", "if (enable_i) data_q <= stage[i-1].data_q;", "data_q <= stage[i-1].data_q;"),
]
DIVIDER = [
    ("equal_does_not_fit", "one_stage", "fits = ~difference[Y_W+1];", "fits = ~difference[Y_W+1] & |difference[Y_W:1];"),
    ("stage_skips", "stage_moves", "remainder_q  <= reduced;", "remainder_q  <= remainder;"),
    ("quotient_inverted", "divides", "bits_q       <= {bits[Q_W-2:0], fits};",
     "bits_q       <= {bits[Q_W-2:0], ~fits};"),
    ("divisor_of_another", "divides|beside_kept", "complement_q <= complement;", "complement_q <= ~divisor_i;"),
    ("beside_of_another", "beside_kept", "beside_q     <= beside;", "beside_q     <= beside_i;"),
    ("enable_ignored", "holds", "if (enable_i) begin", "if (enable_i | fits) begin"),
]
SQRT = [
    ("equal_does_not_fit", "one_stage", "fits = shifted >= trial;", "fits = shifted > trial;"),
    ("root_inverted", "stage_moves", "root_q <= {stage[i-1].root_q, fits};", "root_q <= {stage[i-1].root_q, ~fits};"),
    ("bits_of_another", "is_root", "bits_q <= stage[i-1].waiting.bits_q[2*(Y_W-1-i)-1:0];",
     "bits_q <= radicand_i[2*(Y_W-1-i)-1:0];"),
    ("enable_ignored", "holds", "if (enable_i) remainder_q <= reduced;", "remainder_q <= reduced;"),
]
