// glint_frame: the dot products that effects take, of unit vectors of integers; one set a clock.
//
// The arithmetic is docs/effects/pixel.md, section `Dot products`. All come CLOCKS clocks after the vectors:
// 2 MULTIPLIER_STAGES + 2 F + 13 with H; without, 2 MULTIPLIER_STAGES + 5 with R, else MULTIPLIER_STAGES + 3. What is not
// built is 0. No valid bits: its owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_frame #(
    parameter W                 = 16,  // bits of a component, 8 .. 17
    parameter F                 = 18,  // fraction bits of a dot product, W .. 29, below 2 W - 2
    parameter WITH_R            = 1,   // build R.V
    parameter WITH_H            = 1,   // build N.H
    parameter WITH_V            = 1,   // build V.H; with WITH_H alone
    parameter WITH_T            = 1,   // build H.T and H.B; with WITH_H alone
    parameter MULTIPLIER_STAGES = 1    // clocks of a product, 1 .. 4
) (
    input  wire           clk_i,
    input  wire           rst_ni,      // synchronous, active low; for the addresses of memories
    input  wire           enable_i,
    input  wire [3*W-1:0] light_i,     // {z, y, x}, signed
    input  wire [3*W-1:0] view_i,
    input  wire [3*W-1:0] normal_i,
    input  wire [3*W-1:0] tangent_i,
    input  wire [3*W-1:0] bitangent_i,
    output wire   [F+1:0] nl_o,        // signed, -2^F .. 2^F
    output wire   [F+1:0] nv_o,
    output wire   [F+1:0] lv_o,
    output wire   [F+1:0] rv_o,
    output wire   [F+1:0] nh_o,
    output wire   [F+1:0] vh_o,
    output wire   [F+1:0] ht_o,
    output wire   [F+1:0] hb_o
);

    localparam M      = MULTIPLIER_STAGES;
    localparam PLAIN  = M + 3;
    localparam MIRROR = 2 * M + 5;
    localparam CLOCKS = WITH_H != 0 ? 2 * M + 2 * F + 13 : WITH_R != 0 ? MIRROR : PLAIN;
    localparam SHIFT  = 2 * W - 2 - F;  // at least 1

    // A number of F + 3 bits, cut to -2^F .. 2^F.
    function [F+1:0] cut(input [F+2:0] x);
        cut = x[F+2] ? (&x[F+1:F] ? x[F+1:0] : {2'b11, {F{1'b0}}}) : (|x[F+1:F] ? {2'b01, {F{1'b0}}} : x[F+1:0]);
    endfunction

    // ---- N.L, N.V, L.V: |dot| <= 3 2^(2W-2), so F + 3 bits after the shift --------------------------------------------
    wire [3*F+5:0] plain;
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : pair
            wire [2*W:0] dot;
            glint_dot_product #(
                .WIDTH            (W),
                .MULTIPLIER_STAGES(M)
            ) product (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .a_i     (i == 2 ? light_i : normal_i),
                .b_i     (i == 0 ? light_i : view_i),
                .dot_o   (dot)
            );
            wire [F+3:0] half = dot[2*W:SHIFT-1] + {{(F + 3) {1'b0}}, 1'b1};
            wire         unused = &{1'b0, half[0]};
            if (SHIFT > 1) begin : below
                wire unused_below = &{1'b0, dot[SHIFT-2:0]};
            end
            reg [F+1:0] code_q;
            always @(posedge clk_i) if (enable_i) code_q <= cut(half[F+3:1]);
            assign plain[(F+2)*i+:F+2] = code_q;
        end
    endgenerate
    glint_wait #(
        .WIDTH (3 * F + 6),
        .CLOCKS(CLOCKS - PLAIN)
    ) wait_plain (
        .clk_i   (clk_i),
        .rst_ni  (rst_ni),
        .enable_i(enable_i),
        .data_i  (plain),
        .data_o  ({lv_o, nv_o, nl_o})
    );

    // ---- R.V = 2 (N.L)(N.V) - L.V: magnitudes, at most 2^F, are multiplied --------------------------------------------
    generate
        if (WITH_R != 0) begin : with_r
            wire [F+1:0] nl = plain[F+1:0], nv = plain[2*F+3:F+2], lv = plain[3*F+5:2*F+4];
            wire [F+1:0] nl_negated = -nl, nv_negated = -nv;
            wire         unused = &{1'b0, nl_negated[F+1], nv_negated[F+1]};
            wire [2*F+1:0] product;
            glint_multiplier #(
                .A_W   (F + 1),
                .B_W   (F + 1),
                .STAGES(M)
            ) multiplier (
                .clk_i    (clk_i),
                .enable_i (enable_i),
                .a_i      (nl[F+1] ? nl_negated[F:0] : nl[F:0]),
                .b_i      (nv[F+1] ? nv_negated[F:0] : nv[F:0]),
                .product_o(product)
            );
            wire         negative;
            wire [F+1:0] lv_beside;
            glint_delay #(
                .WIDTH (F + 3),
                .STAGES(M)
            ) delay (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  ({nl[F+1] ^ nv[F+1], lv}),
                .data_o  ({negative, lv_beside})
            );
            // floor((x + 2^(F-2)) / 2^(F-1)): of a negative x, ~(magnitude - 1) is x. Halves of the bits from F - 2 on.
            wire [2*F+2:0] signed_product = negative ? -{1'b0, product} : {1'b0, product};
            wire   [F+4:0] half = signed_product[2*F+2:F-2] + {{(F + 4) {1'b0}}, 1'b1};
            wire           unused_below = &{1'b0, half[F+4], half[0], signed_product[F-3:0]};
            reg    [F+2:0] twice_q;  // at most 2^(F+1) in magnitude
            reg    [F+1:0] lv_q, rv_q;
            wire   [F+2:0] mirrored = twice_q - {lv_q[F+1], lv_q};
            always @(posedge clk_i) begin
                if (enable_i) begin
                    twice_q <= half[F+3:1];
                    lv_q    <= lv_beside;
                    rv_q    <= cut(mirrored);
                end
            end
            glint_wait #(
                .WIDTH (F + 2),
                .CLOCKS(CLOCKS - MIRROR)
            ) wait_rv (
                .clk_i   (clk_i),
                .rst_ni  (rst_ni),
                .enable_i(enable_i),
                .data_i  (rv_q),
                .data_o  (rv_o)
            );
        end else begin : without_r
            assign rv_o = {(F + 2) {1'b0}};
        end
    endgenerate

    // ---- H = L + V, of any length --------------------------------------------------------------------------------------
    function [3*W+2:0] wide(input [3*W-1:0] x);
        wide = {x[3*W-1], x[3*W-1:2*W], x[2*W-1], x[2*W-1:W], x[W-1], x[W-1:0]};
    endfunction
    generate
        if (WITH_H != 0) begin : with_h
            wire [3*W+2:0] l = wide(light_i), v = wide(view_i);
            reg  [3*W+2:0] h_q;
            reg  [9*W+8:0] others_q;  // B, T, N
            always @(posedge clk_i) begin
                if (enable_i) begin
                    h_q      <= {l[3*W+2:2*W+2] + v[3*W+2:2*W+2], l[2*W+1:W+1] + v[2*W+1:W+1], l[W:0] + v[W:0]};
                    others_q <= {wide(bitangent_i), wide(tangent_i), wide(normal_i)};
                end
            end
            wire [3*F+5:0] cosines;
            for (i = 0; i < 3; i = i + 1) begin : vector
                if (i == 0 || WITH_T != 0) begin : built
                    wire none;
                    glint_cosine #(
                        .W                (W + 1),
                        .F                (F),
                        .MULTIPLIER_STAGES(M)
                    ) cosine (
                        .clk_i   (clk_i),
                        .enable_i(enable_i),
                        .a_i     (others_q[(3*W+3)*i+:3*W+3]),
                        .b_i     (h_q),
                        .cosine_o(cosines[(F+2)*i+:F+2]),
                        .none_o  (none)
                    );
                    wire unused = &{1'b0, none};
                end else begin : absent
                    assign cosines[(F+2)*i+:F+2] = {(F + 2) {1'b0}};
                    wire unused = &{1'b0, others_q[(3*W+3)*i+:3*W+3]};
                end
            end
            assign {hb_o, ht_o, nh_o} = cosines;

            // V.H = |H| / 2: of h.h, at most 3 2^(2W), the root at one bit more.
            if (WITH_V != 0) begin : with_v
                wire [2*W+2:0] hh;
                glint_dot_product #(
                    .WIDTH            (W + 1),
                    .MULTIPLIER_STAGES(M)
                ) square (
                    .clk_i   (clk_i),
                    .enable_i(enable_i),
                    .a_i     (h_q),
                    .b_i     (h_q),
                    .dot_o   (hh)
                );
                wire   [F+1:0] root;
                /* verilator lint_off PINCONNECTEMPTY */
                glint_sqrt #(
                    .Y_W(F + 2)
                ) sqrt (
                    .clk_i      (clk_i),
                    .enable_i   (enable_i),
                    .radicand_i ({hh[2*W+1:0], {(2 * F + 2 - 2 * W) {1'b0}}}),
                    .root_o     (root),
                    .remainder_o()
                );
                /* verilator lint_on PINCONNECTEMPTY */
                wire [F+2:0] rounded = {1'b0, root} + {{(F + 2) {1'b0}}, 1'b1};
                wire         unused = &{1'b0, hh[2*W+2], rounded[0]};
                reg  [F+1:0] vh_q;
                always @(posedge clk_i) if (enable_i) vh_q <= cut({1'b0, rounded[F+2:1]});
                glint_wait #(
                    .WIDTH (F + 2),
                    .CLOCKS(CLOCKS - M - F - 6)
                ) wait_vh (
                    .clk_i   (clk_i),
                    .rst_ni  (rst_ni),
                    .enable_i(enable_i),
                    .data_i  (vh_q),
                    .data_o  (vh_o)
                );
            end else begin : without_v
                assign vh_o = {(F + 2) {1'b0}};
            end
        end else begin : without_h
            assign {hb_o, ht_o, vh_o, nh_o} = {(4 * F + 8) {1'b0}};
            wire unused = &{1'b0, tangent_i, bitangent_i, wide({(3 * W) {1'b0}})};
        end
    endgenerate

endmodule

`default_nettype wire
