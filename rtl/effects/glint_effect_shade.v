// glint_effect_shade: a light's part of a pixel: ambient + tint(diffuse terms) + tint(specular terms), saturating.
//
// The units of the terms stand beside it in the generated wrapper, each only where MASK has its bit. They and all that
// follows never stand still: as many inputs are accepted as the last memory can hold. Contract: docs/effects/shade.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_shade #(
    parameter         O         = 12,  // fraction bits of terms and colours
    parameter         N         = 1,   // terms
    parameter [N:0]   MASK      = {(N + 1) {1'b1}},  // what is built: bit 0 ambient, the others a term each
    parameter [N:0]   DIFFUSE   = {(N + 1) {1'b0}},  // the bits of diffuse terms
    parameter         LOG_DEPTH = 6,   // inputs in flight: 2^LOG_DEPTH; one a clock where that is no less than the latency
    parameter         TAG_W     = 16   // width of the tag, at least 1
) (
    input  wire                 clk_i,
    input  wire                 rst_ni,         // synchronous, active low
    input  wire                 valid_i,
    output wire                 ready_o,
    input  wire           [N:0] effects_i,      // what is asked for, a bit each as in MASK
    input  wire       [3*O+2:0] ka_i,           // colours: {b, g, r}
    input  wire      [3*O+11:0] ia_i,
    input  wire       [3*O+2:0] kd_i,
    input  wire       [3*O+2:0] ks_i,
    input  wire      [3*O+11:0] i_i,
    input  wire     [TAG_W-1:0] tag_i,
    output wire                 valid_o,
    input  wire                 ready_i,
    output wire         [O+7:0] r_o,
    output wire         [O+7:0] g_o,
    output wire         [O+7:0] b_o,
    output wire     [TAG_W-1:0] tag_o,
    output wire                 clamped_o,
    output wire                 start_o,        // valid_i of every unit
    input  wire         [N-1:0] unit_ready_i,
    input  wire         [N-1:0] unit_valid_i,
    input  wire         [N-1:0] unit_clamped_i,
    input  wire [N*(O+8)-1:0]   unit_y_i
);

    localparam [N:0] BUILT_DIFFUSE  = MASK & DIFFUSE;
    localparam [N:0] BUILT_SPECULAR = MASK & ~DIFFUSE & ~{{N{1'b0}}, 1'b1};
    localparam       BUILT          = ones(MASK);
    localparam       TOTAL_W        = 3 * (O + 8) + TAG_W + 1;

    function integer ones(input [N:0] bits);
        integer bit_number;
        begin
            ones = 0;
            for (bit_number = 0; bit_number <= N; bit_number = bit_number + 1) begin
                if (bits[bit_number]) ones = ones + 1;
            end
        end
    endfunction

    // ---- input: what was accepted and not yet delivered ------------------------------------------------------------
    reg  [LOG_DEPTH:0] held_q;
    wire               deliver = valid_o & ready_i;
    assign ready_o = rst_ni & ~held_q[LOG_DEPTH] & (&(unit_ready_i | ~MASK[N:1]));
    assign start_o = valid_i & ready_o;
    always @(posedge clk_i) begin
        if (!rst_ni) held_q <= {(LOG_DEPTH + 1) {1'b0}};
        else held_q <= held_q + {{LOG_DEPTH{1'b0}}, start_o} - {{LOG_DEPTH{1'b0}}, deliver};
    end

    // ---- what waits for the slowest unit: what was asked for, the tag, the colours, the terms -----------------------
    wire [N:0]       here;  // bit 0: what came with the input
    wire             join_valid = &here;
    wire [N:0]       asked;
    wire [TAG_W-1:0] join_tag;
    // One bit for each that is built, and the tag below.
    wire [TAG_W+BUILT-1:0] waiting_in, waiting_out;
    assign waiting_in[TAG_W-1:0] = tag_i;
    assign join_tag              = waiting_out[TAG_W-1:0];
    glint_fifo #(
        .WIDTH    (TAG_W + BUILT),
        .LOG_DEPTH(LOG_DEPTH)
    ) fifo_tag (
        .clk_i  (clk_i),
        .rst_ni (rst_ni),
        .push_i (start_o),
        .data_i (waiting_in),
        .valid_o(here[0]),
        .pop_i  (join_valid),
        .data_o (waiting_out)
    );
    genvar k;
    generate
        for (k = 0; k <= N; k = k + 1) begin : choice
            if (MASK[k]) begin : built
                localparam [N:0] BELOW = MASK & ~({(N + 1) {1'b1}} << k);
                localparam       PLACE = TAG_W + ones(BELOW);
                assign waiting_in[PLACE] = effects_i[k];
                assign asked[k]          = waiting_out[PLACE];
            end else begin : absent
                assign asked[k] = 1'b0;
                wire unused = &{1'b0, effects_i[k]};
            end
        end
    endgenerate

    wire [N*(O+8)-1:0] terms;  // 0 where it was not asked for
    wire       [N-1:0] terms_clamped;
    generate
        for (k = 0; k < N; k = k + 1) begin : unit
            if (MASK[k+1]) begin : built
                wire [O+7:0] y;
                wire         clamped;
                glint_fifo #(
                    .WIDTH    (O + 9),
                    .LOG_DEPTH(LOG_DEPTH)
                ) fifo (
                    .clk_i  (clk_i),
                    .rst_ni (rst_ni),
                    .push_i (unit_valid_i[k]),
                    .data_i ({unit_clamped_i[k], unit_y_i[(O+8)*k+:O+8]}),
                    .valid_o(here[k+1]),
                    .pop_i  (join_valid),
                    .data_o ({clamped, y})
                );
                assign terms[(O+8)*k+:O+8] = y & {(O + 8) {asked[k+1]}};
                assign terms_clamped[k]    = clamped & asked[k+1];
            end else begin : absent
                assign here[k+1]           = 1'b1;
                assign terms[(O+8)*k+:O+8] = {(O + 8) {1'b0}};
                assign terms_clamped[k]    = 1'b0;
                wire unused = &{1'b0, asked[k+1], terms[(O+8)*k+:O+8], unit_valid_i[k], unit_clamped_i[k],
                    unit_y_i[(O+8)*k+:O+8]};
            end
        end
    endgenerate

    // ---- the sums of the terms, saturating ---------------------------------------------------------------------------
    reg             sum_valid_q, sum_clamped_q;
    reg [TAG_W-1:0] sum_tag_q;
    always @(posedge clk_i) begin
        sum_valid_q   <= rst_ni & join_valid;
        sum_clamped_q <= |terms_clamped;
        sum_tag_q     <= join_tag;
    end

    wire             tail_valid, tail_clamped, tail_ready, tail_advance;
    wire [TAG_W-1:0] tail_tag;
    glint_stream #(
        .LATENCY(4),  // that of glint_effect_tint
        .TAG_W  (TAG_W)
    ) tail (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (sum_valid_q),
        .ready_o  (tail_ready),
        .clamped_i(sum_clamped_q),
        .tag_i    (sum_tag_q),
        .valid_o  (tail_valid),
        .ready_i  (1'b1),
        .tag_o    (tail_tag),
        .clamped_o(tail_clamped),
        .advance_o(tail_advance)
    );
    wire unused_tail = &{1'b0, tail_ready, tail_advance};

    // ---- each part: its colours wait, too -------------------------------------------------------------------------
    wire [3*O+11:0] light;  // the light's colour, beside the sums
    wire [3*O+23:0] diffuse, specular;
    wire [3*O+11:0] ambient;
    wire            diffuse_clamped, specular_clamped, ambient_clamped;
    generate
        if (|MASK[N:1]) begin : lit
            wire            here_i;  // as here[0]
            wire [3*O+11:0] i;
            glint_fifo #(
                .WIDTH    (3 * O + 12),
                .LOG_DEPTH(LOG_DEPTH)
            ) fifo (
                .clk_i  (clk_i),
                .rst_ni (rst_ni),
                .push_i (start_o),
                .data_i (i_i),
                .valid_o(here_i),
                .pop_i  (join_valid),
                .data_o (i)
            );
            wire            unused = &{1'b0, here_i};
            reg  [3*O+11:0] i_q;
            always @(posedge clk_i) i_q <= i;
            assign light = i_q;
        end else begin : unlit
            assign light = {(3 * O + 12) {1'b0}};
            wire unused = &{1'b0, i_i, light};
        end

        if (|BUILT_DIFFUSE) begin : with_diffuse
            glint_shade_part #(
                .O        (O),
                .N        (N),
                .TERMS    (BUILT_DIFFUSE[N:1]),
                .LOG_DEPTH(LOG_DEPTH)
            ) part (
                .clk_i    (clk_i),
                .rst_ni   (rst_ni),
                .start_i  (start_o),
                .k_i      (kd_i),
                .join_i   (join_valid),
                .asked_i  (asked[N:1]),
                .terms_i  (terms),
                .light_i  (light),
                .colour_o (diffuse),
                .clamped_o(diffuse_clamped)
            );
        end else begin : without_diffuse
            assign diffuse         = {(3 * O + 24) {1'b0}};
            assign diffuse_clamped = 1'b0;
            wire unused = &{1'b0, kd_i};
        end

        if (|BUILT_SPECULAR) begin : with_specular
            glint_shade_part #(
                .O        (O),
                .N        (N),
                .TERMS    (BUILT_SPECULAR[N:1]),
                .LOG_DEPTH(LOG_DEPTH)
            ) part (
                .clk_i    (clk_i),
                .rst_ni   (rst_ni),
                .start_i  (start_o),
                .k_i      (ks_i),
                .join_i   (join_valid),
                .asked_i  (asked[N:1]),
                .terms_i  (terms),
                .light_i  (light),
                .colour_o (specular),
                .clamped_o(specular_clamped)
            );
        end else begin : without_specular
            assign specular         = {(3 * O + 24) {1'b0}};
            assign specular_clamped = 1'b0;
            wire unused = &{1'b0, ks_i};
        end

        if (MASK[0]) begin : with_ambient
            wire            here_a;
            wire  [3*O+2:0] ka;
            wire [3*O+11:0] ia;
            glint_fifo #(
                .WIDTH    (6 * O + 15),
                .LOG_DEPTH(LOG_DEPTH)
            ) fifo (
                .clk_i  (clk_i),
                .rst_ni (rst_ni),
                .push_i (start_o),
                .data_i ({ka_i, ia_i}),
                .valid_o(here_a),
                .pop_i  (join_valid),
                .data_o ({ka, ia})
            );
            wire            unit_ready, unit_valid, unit_clamped, unit_asked;
            wire [3*O+11:0] y;
            glint_effect_ambient #(
                .O    (O),
                .TAG_W(1)
            ) unit (
                .clk_i    (clk_i),
                .rst_ni   (rst_ni),
                .valid_i  (1'b1),
                .ready_o  (unit_ready),
                .k_r_i    (ka[O:0]),
                .k_g_i    (ka[2*O+1:O+1]),
                .k_b_i    (ka[3*O+2:2*O+2]),
                .i_r_i    (ia[O+3:0]),
                .i_g_i    (ia[2*O+7:O+4]),
                .i_b_i    (ia[3*O+11:2*O+8]),
                .tag_i    (asked[0]),
                .valid_o  (unit_valid),
                .ready_i  (1'b1),
                .r_o      (y[O+3:0]),
                .g_o      (y[2*O+7:O+4]),
                .b_o      (y[3*O+11:2*O+8]),
                .tag_o    (unit_asked),
                .clamped_o(unit_clamped)
            );
            // It starts a clock before the tints, which have sums to wait for, and is a clock shorter.
            glint_delay #(
                .WIDTH (3 * O + 13),
                .STAGES(2)
            ) delay (
                .clk_i   (clk_i),
                .enable_i(1'b1),
                .data_i  ({y & {(3 * O + 12) {unit_asked}}, unit_clamped & unit_asked}),
                .data_o  ({ambient, ambient_clamped})
            );
            wire unused = &{1'b0, here_a, unit_ready, unit_valid};
        end else begin : without_ambient
            assign ambient         = {(3 * O + 12) {1'b0}};
            assign ambient_clamped = 1'b0;
            wire unused = &{1'b0, ka_i, ia_i, asked[0]};
        end
    endgenerate

    // ---- the total, saturating: O + 4 bits and twice O + 8 make O + 10 ------------------------------------------------
    reg                total_valid_q, total_clamped_q;
    reg    [TAG_W-1:0] total_tag_q;
    wire   [3*O+23:0]  total;
    generate
        for (k = 0; k < 3; k = k + 1) begin : channel
            wire [O+9:0] exact = {6'd0, ambient[(O+4)*k+:O+4]} + {2'd0, diffuse[(O+8)*k+:O+8]}
                + {2'd0, specular[(O+8)*k+:O+8]};
            reg  [O+7:0] total_q;
            always @(posedge clk_i) total_q <= exact[O+7:0] | {(O + 8) {|exact[O+9:O+8]}};
            assign total[(O+8)*k+:O+8] = total_q;
        end
    endgenerate
    always @(posedge clk_i) begin
        total_valid_q   <= rst_ni & tail_valid;
        total_clamped_q <= tail_clamped | ambient_clamped | diffuse_clamped | specular_clamped;
        total_tag_q     <= tail_tag;
    end

    wire out_valid;
    glint_fifo #(
        .WIDTH    (TOTAL_W),
        .LOG_DEPTH(LOG_DEPTH)
    ) fifo_total (
        .clk_i  (clk_i),
        .rst_ni (rst_ni),
        .push_i (total_valid_q),
        .data_i ({total_clamped_q, total_tag_q, total}),
        .valid_o(out_valid),
        .pop_i  (deliver),
        .data_o ({clamped_o, tag_o, b_o, g_o, r_o})
    );
    assign valid_o = rst_ni & out_valid;

endmodule

`default_nettype wire
