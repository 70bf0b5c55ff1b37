// glint_shade_part: the diffuse or the specular part of glint_effect_shade: the sum of its terms, tinted.
//
// The result comes five clocks after join_i: one for the sum, four of glint_effect_tint. Never stands still.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_shade_part #(
    parameter         O         = 12,  // fraction bits of terms and colours
    parameter         N         = 1,   // terms
    parameter [N-1:0] TERMS     = {N{1'b1}},  // those that belong to the part
    parameter         LOG_DEPTH = 6
) (
    input  wire                 clk_i,
    input  wire                 rst_ni,
    input  wire                 start_i,   // an input was accepted
    input  wire       [3*O+2:0] k_i,       // and this is the material's colour for it: {b, g, r}
    input  wire                 join_i,    // the terms of the oldest input are here
    input  wire         [N-1:0] asked_i,   // which of them were asked for
    input  wire [N*(O+8)-1:0]   terms_i,   // 0 where not
    input  wire      [3*O+11:0] light_i,   // the light's colour, one clock later
    output wire      [3*O+23:0] colour_o,
    output wire                 clamped_o
);

    wire           here;
    wire [3*O+2:0] k;
    glint_fifo #(
        .WIDTH    (3 * O + 3),
        .LOG_DEPTH(LOG_DEPTH)
    ) fifo (
        .clk_i  (clk_i),
        .rst_ni (rst_ni),
        .push_i (start_i),
        .data_i (k_i),
        .valid_o(here),
        .pop_i  (join_i),
        .data_o (k)
    );

    // Each partial sum saturates, which is the same as the sum of all saturating: no term is negative.
    genvar t;
    generate
        for (t = 0; t < N; t = t + 1) begin : add
            wire [O+7:0] below;  // the sum of the terms before this one
            wire [O+7:0] sum;
            if (t == 0) begin : first
                assign below = {(O + 8) {1'b0}};
            end else begin : rest
                assign below = add[t-1].sum;
            end
            if (TERMS[t]) begin : own
                wire [O+8:0] exact = {1'b0, below} + {1'b0, terms_i[(O+8)*t+:O+8]};
                assign sum = exact[O+7:0] | {(O + 8) {exact[O+8]}};
            end else begin : other
                assign sum = below;
                wire unused_term = &{1'b0, terms_i[(O+8)*t+:O+8], asked_i[t]};
            end
        end
    endgenerate

    reg   [O+7:0] sum_q;
    reg [3*O+2:0] k_q;
    reg           asked_q;
    always @(posedge clk_i) begin
        sum_q   <= add[N-1].sum;
        k_q     <= k;
        asked_q <= |(asked_i & TERMS);
    end

    wire unit_ready, unit_valid, unit_clamped, unit_asked;
    glint_effect_tint #(
        .O    (O),
        .TAG_W(1)
    ) unit (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (1'b1),
        .ready_o  (unit_ready),
        .s_i      (sum_q),
        .k_r_i    (k_q[O:0]),
        .k_g_i    (k_q[2*O+1:O+1]),
        .k_b_i    (k_q[3*O+2:2*O+2]),
        .i_r_i    (light_i[O+3:0]),
        .i_g_i    (light_i[2*O+7:O+4]),
        .i_b_i    (light_i[3*O+11:2*O+8]),
        .tag_i    (asked_q),
        .valid_o  (unit_valid),
        .ready_i  (1'b1),
        .r_o      (colour_o[O+7:0]),
        .g_o      (colour_o[2*O+15:O+8]),
        .b_o      (colour_o[3*O+23:2*O+16]),
        .tag_o    (unit_asked),
        .clamped_o(unit_clamped)
    );
    assign clamped_o = unit_clamped & unit_asked;
    wire unused = &{1'b0, here, unit_ready, unit_valid};

endmodule

`default_nettype wire
