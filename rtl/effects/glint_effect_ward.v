// glint_effect_ward: the anisotropic highlight of Ward, one result a clock.
//
// Contract, ports, latency: docs/effects/ward.md; a value here carries the name that it has there. The tables are beside
// the unit: an entry comes one clock with table_enable_o after its address.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_ward #(
    parameter F     = 18,  // fraction bits of the dot products, at least O + 3
    parameter T     = 4,   // address bits of log2
    parameter E     = 3,   // address bits of exp2
    parameter O     = 12,  // fraction bits of the output, 4 .. 20
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,     // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire     [F+1:0] nl_i,       // N.L, signed, code / 2^F
    input  wire     [F+1:0] nv_i,       // N.V
    input  wire     [F+1:0] nh_i,       // N.H
    input  wire     [F+1:0] ht_i,       // H.T
    input  wire     [F+1:0] hb_i,       // H.B
    input  wire     [O+6:0] kx_i,       // sqrt(2 / ln 2) / alpha_x, code / 2^O
    input  wire     [O+6:0] ky_i,       // the same of alpha_y
    input  wire     [O+8:0] log_peak_i, // log2(1 / (4 pi alpha_x alpha_y)), signed, code / 2^(O+4)
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire     [O+7:0] y_o,        // code / 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o,  // an input was out of range and was corrected
    output wire             table_enable_o,
    output wire     [T-1:0] log2_nl_address_o,
    input  wire [3*F-3*T+5:0] log2_nl_entry_i,
    output wire     [T-1:0] log2_nv_address_o,
    input  wire [3*F-3*T+5:0] log2_nv_entry_i,
    output wire     [E-1:0] exp2_address_o,
    input  wire [3*O-3*E+17:0] exp2_entry_i
);

    localparam L   = F + 1;   // fraction bits of the logarithms
    localparam S   = O + 4;   // fraction bits of log_peak, r2, t and e
    localparam H   = O + 3;   // fraction bits of hx and hy
    localparam T_W = S + 7;   // bits of r2 and t, below 128: the quotient's
    localparam R2  = 6;       // clocks to r2: 1 correct, 2 hx and hy, 3 r2
    localparam W   = 11;      // clocks to `offset`: 1 correct, 8 logarithms, 1 difference, 1 offset
    localparam E_AT = R2 + T_W + 1;      // clocks to e
    localparam LATENCY = E_AT + 7 + 1;   // and exp2, and saturation: O + 26

    // ---- corrections --------------------------------------------------------------------------------------------------
    wire               advance;
    wire         [5:0] clamped;
    wire [5*F+9:0]     dots = {hb_i, ht_i, nh_i, nv_i, nl_i};
    wire [5*F+9:0]     cut;
    genvar k;
    generate
        for (k = 0; k < 5; k = k + 1) begin : dot
            glint_dot #(
                .F(F)
            ) corrected (
                .dot_i    (dots[(F+2)*k+:F+2]),
                .dot_o    (cut[(F+2)*k+:F+2]),
                .clamped_o(clamped[k])
            );
        end
    endgenerate
    wire [F+1:0] nl_cut = cut[F+1:0];
    wire [F+1:0] nv_cut = cut[2*F+3:F+2];
    wire [F+1:0] nh_cut = cut[3*F+5:2*F+4];
    wire [F+1:0] ht_cut = cut[4*F+7:3*F+6];
    wire [F+1:0] hb_cut = cut[5*F+9:4*F+8];

    // log_peak is -8 .. 8: S + 5 bits, of which the two at the top differ only at 8 and beyond it.
    wire peak_above = ~log_peak_i[S+4] & log_peak_i[S+3] & (|log_peak_i[S+2:0]);
    wire peak_below = log_peak_i[S+4] & ~log_peak_i[S+3];
    assign clamped[5] = peak_above | peak_below;

    glint_stream #(
        .LATENCY(LATENCY),
        .TAG_W  (TAG_W)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .clamped_i(|clamped),
        .tag_i    (tag_i),
        .valid_o  (valid_o),
        .ready_i  (ready_i),
        .tag_o    (tag_o),
        .clamped_o(clamped_o),
        .advance_o(advance)
    );
    assign table_enable_o = advance;

    // Dark where nl or nv is not above 0, or nh below 0; what is computed there has no meaning.
    wire dark = nl_cut[F+1] | ~|nl_cut[F:0] | nv_cut[F+1] | ~|nv_cut[F:0] | nh_cut[F+1];

    reg   [F:0] nl_q, nv_q, nh_q;  // 0 .. 2^F where they count
    reg   [F:0] ht_q, hb_q;        // magnitudes, 0 .. 2^F
    reg [O+6:0] kx_q, ky_q;
    reg [S+4:0] room_q;            // 8 - log_peak, 0 .. 16
    reg         dark_q;
    localparam [S+4:0] EIGHT = {2'b01, {(S + 3) {1'b0}}};
    wire [S+4:0] log_peak = {log_peak_i[S+4], log_peak_i[S+3] | peak_below, log_peak_i[S+2:0] & {(S + 3) {~clamped[5]}}};
    always @(posedge clk_i) begin
        if (advance) begin
            nl_q   <= nl_cut[F:0];
            nv_q   <= nv_cut[F:0];
            nh_q   <= nh_cut[F:0];
            ht_q   <= ht_cut[F+1] ? -ht_cut[F:0] : ht_cut[F:0];
            hb_q   <= hb_cut[F+1] ? -hb_cut[F:0] : hb_cut[F:0];
            kx_q   <= kx_i;
            ky_q   <= ky_i;
            room_q <= EIGHT - log_peak;
            dark_q <= dark;
        end
    end

    // ---- r2 -----------------------------------------------------------------------------------------------------------
    // |h| k <= 2^F (2^(O+7) - 1): F + O + 7 bits. Rounded to H bits by F + O - H = F - 3 it is at most 2^(O+10) - 8; above
    // 2^(H+4) - 1 = 2^(O+7) - 1 it is cut to that: whatever has hx or hy of 16 is 0 in the end.
    localparam HX_W = H + 4;
    wire [2*HX_W-1:0] squares_x, squares_y;
    generate
        for (k = 0; k < 2; k = k + 1) begin : axis
            wire   [F:0] h     = k == 0 ? ht_q : hb_q;
            wire [O+6:0] scale = k == 0 ? kx_q : ky_q;
            reg  [F+O+6:0] product_q;
            reg [HX_W-1:0] h_q;
            reg [2*HX_W-1:0] square_q;
            wire  [O+9:0] rounded = product_q[F+O+6:F-3] + {{(O + 9) {1'b0}}, product_q[F-4]};
            always @(posedge clk_i) begin
                if (advance) begin
                    product_q <= {{(O + 6) {1'b0}}, h} * {{F{1'b0}}, scale};
                    h_q       <= rounded[HX_W-1:0] | {HX_W{|rounded[O+9:HX_W]}};
                    square_q  <= {{HX_W{1'b0}}, h_q} * {{HX_W{1'b0}}, h_q};
                end
            end
            wire unused = &{1'b0, product_q[F-5:0]};
        end
    endgenerate
    assign squares_x = axis[0].square_q;
    assign squares_y = axis[1].square_q;

    // The sum of the squares is at most 2 (2^(O+7) - 1)^2 at 2 H bits; r2 = rnd(sum, 2 H - S), 2 H - S = O + 2, is at most
    // 2^(O+13) - 2^7 and cut to below 2^(S+7) = 2^(O+11).
    reg [2*HX_W:0] squares_q;
    reg  [T_W-1:0] r2_q;
    wire [T_W+1:0] r2_rounded = squares_q[2*HX_W:O+2] + {{(T_W + 1) {1'b0}}, squares_q[O+1]};
    wire           unused_squares = &{1'b0, squares_q[O:0]};
    always @(posedge clk_i) begin
        if (advance) begin
            squares_q <= {1'b0, squares_x} + {1'b0, squares_y};
            r2_q      <= r2_rounded[T_W-1:0] | {T_W{|r2_rounded[T_W+1:T_W]}};
        end
    end

    // ---- t = floor(r2 2^F / (2^F + nh)), below 2^T_W since r2 is and the divisor is at least 2^F ---------------------------
    wire     [F:0] nh;
    wire [T_W-1:0] t;
    glint_delay #(
        .WIDTH (F + 1),
        .STAGES(R2 - 1)
    ) delay_nh (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (nh_q),
        .data_o  (nh)
    );
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W(T_W + F),
        .Y_W(F + 2),
        .Q_W(T_W)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .start_i    (1'b0),
        .dividend_i ({r2_q, {F{1'b0}}}),
        .divisor_i  ({1'b0, nh} + {2'b01, {F{1'b0}}}),
        .beside_i   (1'b0),
        .done_o     (),
        .quotient_o (t),
        .remainder_o(),
        .beside_o   ()
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // ---- offset = rnd(ul - uv, L + 1 - S) + 8 - log_peak ------------------------------------------------------------------
    wire [L+4:0] ul, uv;
    wire [S+4:0] room;
    glint_log2 #(
        .F(F),
        .T(T),
        .L(L)
    ) log2_nl (
        .clk_i    (clk_i),
        .enable_i (advance),
        .cosine_i (nl_q),
        .address_o(log2_nl_address_o),
        .entry_i  (log2_nl_entry_i),
        .u_o      (ul)
    );
    glint_log2 #(
        .F(F),
        .T(T),
        .L(L)
    ) log2_nv (
        .clk_i    (clk_i),
        .enable_i (advance),
        .cosine_i (nv_q),
        .address_o(log2_nv_address_o),
        .entry_i  (log2_nv_entry_i),
        .u_o      (uv)
    );
    glint_delay #(
        .WIDTH (S + 5),
        .STAGES(W - 2)
    ) delay_room (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (room_q),
        .data_o  (room)
    );

    // |ul - uv| <= F 2^L, or 31 2^L in the dark: L + 6 bits, signed. Half of it at S bits is below 16 2^S, and with the 0 to
    // 16 of `room` the offset is above -16 and below 32: S + 6 bits, signed.
    localparam CUT = L + 1 - S;
    localparam [L+5:0] HALF_W = {{(L + 6 - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};
    reg [L+5:0] w_half_q;
    reg [S+5:0] offset_q;
    always @(posedge clk_i) begin
        if (advance) begin
            w_half_q <= {1'b0, ul} - {1'b0, uv} + HALF_W;
            offset_q <= {w_half_q[L+5], w_half_q[L+5:CUT]} + {1'b0, room};
        end
    end
    wire unused_w = &{1'b0, w_half_q[CUT-1:0]};

    wire [S+5:0] offset;
    glint_delay #(
        .WIDTH (S + 6),
        .STAGES(E_AT - 1 - W)
    ) delay_offset (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (offset_q),
        .data_o  (offset)
    );

    // ---- y = 2^-max(0, e) at O + 8 bits, saturating ------------------------------------------------------------------------
    // e = t + offset is above -16 and below 160: S + 9 bits, signed; S + 8 where it is not below 0.
    wire [S+8:0] sum = {2'b00, t} + {{3{offset[S+5]}}, offset};
    reg  [S+7:0] e_q;
    always @(posedge clk_i) if (advance) e_q <= sum[S+7:0] & {(S + 8) {~sum[S+8]}};

    wire dark_late;
    glint_delay #(
        .WIDTH (1),
        .STAGES(E_AT + 5)
    ) delay_dark (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (dark_q),
        .data_o  (dark_late)
    );

    wire [O+8:0] power;  // 2^(O+8) only where e is 0
    glint_exp2 #(
        .I_W(8),
        .E  (E),
        .S  (S),
        .O  (O + 8)
    ) exp2 (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .t_i       (e_q),
        .negative_i(dark_late),
        .address_o (exp2_address_o),
        .entry_i   (exp2_entry_i),
        .y_o       (power)
    );

    reg [O+7:0] y_q;
    always @(posedge clk_i) if (advance) y_q <= power[O+7:0] | {(O + 8) {power[O+8]}};
    assign y_o = y_q;

endmodule

`default_nettype wire
