// glint_fifo, glint_effect_tint and glint_ratio of a family beside those for any device, here any_glint_...: the same at every
// clock, where it counts. Verilog-2005, for any simulator.
//
//   parameters  O of tint; F, S, SYMMETRIC, DIVIDER (not 2), STAGES of ratio; LOG_DEPTH of fifo
//               CLOCKS: so many, of random inputs, corners among them
//
// The last line is `3000 results, 0 mismatches`.

`default_nettype none

module family_blocks_tb;

    parameter O         = 12;
    parameter F         = 18;
    parameter S         = 15;
    parameter SYMMETRIC = 0;
    parameter DIVIDER   = 0;
    parameter STAGES    = 1;
    parameter LOG_DEPTH = 2;
    parameter CLOCKS    = 1000;

    localparam IN_W  = O + 8 + 3 * (O + 1) + 3 * (O + 4);
    localparam OUT_W = 3 * (O + 8) + 4;  // colours, tag of two bits, clamped, and valid
    localparam FILL  = 100;              // clocks before the first comparison of ratio: more than it takes

    reg clk, rst_n, enable, valid, ready, push, pop;
    reg [IN_W-1:0] in;
    reg [1:0]      tag;
    reg [9:0]      n;
    reg [F:0]      cosine, distance;
    reg [7:0]      item;

    wire             ready_own, ready_any, head_own, head_any;
    wire [OUT_W-1:0] out_own, out_any;
    wire       [S:0] quotient_own, quotient_any;
    wire       [7:0] item_own, item_any;

    glint_effect_tint #(.O(O), .TAG_W(2)) tint_own (
        .clk_i(clk), .rst_ni(rst_n), .valid_i(valid), .ready_o(ready_own), .s_i(in[O+7:0]), .k_r_i(in[O+8+:O+1]),
        .k_g_i(in[2*O+9+:O+1]), .k_b_i(in[3*O+10+:O+1]), .i_r_i(in[4*O+11+:O+4]), .i_g_i(in[5*O+15+:O+4]),
        .i_b_i(in[6*O+19+:O+4]), .tag_i(tag), .valid_o(out_own[0]), .ready_i(ready), .r_o(out_own[4+:O+8]),
        .g_o(out_own[O+12+:O+8]), .b_o(out_own[2*O+20+:O+8]), .tag_o(out_own[3:2]), .clamped_o(out_own[1]));
    any_glint_effect_tint #(.O(O), .TAG_W(2)) tint_any (
        .clk_i(clk), .rst_ni(rst_n), .valid_i(valid), .ready_o(ready_any), .s_i(in[O+7:0]), .k_r_i(in[O+8+:O+1]),
        .k_g_i(in[2*O+9+:O+1]), .k_b_i(in[3*O+10+:O+1]), .i_r_i(in[4*O+11+:O+4]), .i_g_i(in[5*O+15+:O+4]),
        .i_b_i(in[6*O+19+:O+4]), .tag_i(tag), .valid_o(out_any[0]), .ready_i(ready), .r_o(out_any[4+:O+8]),
        .g_o(out_any[O+12+:O+8]), .b_o(out_any[2*O+20+:O+8]), .tag_o(out_any[3:2]), .clamped_o(out_any[1]));

    glint_ratio #(
        .F(F), .S(S), .SYMMETRIC(SYMMETRIC), .DIVIDER(DIVIDER), .MULTIPLIER_STAGES(STAGES)
    ) ratio_own (
        .clk_i(clk), .enable_i(enable), .start_i(1'b0), .n_i(n), .cosine_i(cosine), .distance_i(distance), .done_o(),
        .quotient_o(quotient_own));
    any_glint_ratio #(
        .F(F), .S(S), .SYMMETRIC(SYMMETRIC), .DIVIDER(DIVIDER), .MULTIPLIER_STAGES(STAGES)
    ) ratio_any (
        .clk_i(clk), .enable_i(enable), .start_i(1'b0), .n_i(n), .cosine_i(cosine), .distance_i(distance), .done_o(),
        .quotient_o(quotient_any));

    glint_fifo #(.WIDTH(8), .LOG_DEPTH(LOG_DEPTH)) fifo_own (
        .clk_i(clk), .rst_ni(rst_n), .push_i(push), .data_i(item), .valid_o(head_own), .pop_i(pop), .data_o(item_own));
    any_glint_fifo #(.WIDTH(8), .LOG_DEPTH(LOG_DEPTH)) fifo_any (
        .clk_i(clk), .rst_ni(rst_n), .push_i(push), .data_i(item), .valid_o(head_any), .pop_i(pop), .data_o(item_any));

    integer seed, clock, held, results, mismatches, filled, k;

    function [63:0] draw(input integer ignored);
        case ({$random(seed)} % 8)
            0: draw = 0;
            1: draw = ~64'd0;
            default: draw = {$random(seed), $random(seed)};
        endcase
    endfunction

    task compare(input right, input [63:0] what);
        begin
            results = results + 1;
            if (right !== 1'b1) begin
                mismatches = mismatches + 1;
                $display("FAILED: %0s at clock %0d", what, clock);
            end
        end
    endtask

    initial begin
        clk = 1'b0;
        rst_n = 1'b0;
        {enable, valid, ready, push, pop} = 5'd0;
        seed = 1;
        held = 0;
        filled = 0;
        results = 0;
        mismatches = 0;
        for (clock = 0; clock < CLOCKS && mismatches < 10; clock = clock + 1) begin
            {tag, item, n} = draw(0);
            if (n == 0) n = 1;
            for (k = 0; k < IN_W; k = k + 8) in = {in, draw(0) >> 3} ^ {in, 8'd0};
            if ({$random(seed)} % 8 == 0) in = {IN_W{tag[0]}};
            cosine   = draw(0) >> 1;
            if (cosine > {1'b1, {F{1'b0}}}) cosine = {1'b1, {F{1'b0}}};
            if ({$random(seed)} % 16 == 0) cosine = tag;
            distance = {1'b1, {F{1'b0}}} - cosine;
            rst_n    = clock > 2 && {$random(seed)} % 64 != 0;
            {enable, valid, ready} = {$random(seed)};
            push = {$random(seed)} % 256 < clock % 256 && held < 1 << LOG_DEPTH;
            #1;  // what the outputs say now
            pop = head_any === 1'b1 && {$random(seed)} % 2 == 0;
            #1;
            if (clock > 2) begin
                compare(head_own === head_any && (!head_any || item_own === item_any), "fifo");
                compare(ready_own === ready_any && out_own[0] === out_any[0] && (!out_any[0] || out_own === out_any), "tint");
            end
            if (filled > FILL) compare(quotient_own === quotient_any, "ratio");
            if (enable) filled = filled + 1;
            held = rst_n ? held + push - pop : 0;
            #1 clk = 1'b1;
            #1 clk = 1'b0;
        end
        $display("%0d results, %0d mismatches", results, mismatches);
        $finish(0);
    end

endmodule

`default_nettype wire
