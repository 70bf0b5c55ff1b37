// glint_dot_product: a . b of two vectors of three signed components. MULTIPLIER_STAGES + 2 clocks.
//
// No valid bits and no reset: its owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_dot_product #(
    parameter WIDTH             = 16,  // bits of a component, 2 .. 18
    parameter MULTIPLIER_STAGES = 1    // clocks of a product, 1 .. 4
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire [3*WIDTH-1:0] a_i,   // three components, side by side
    input  wire [3*WIDTH-1:0] b_i,
    output wire [2*WIDTH:0]   dot_o  // signed, -3 2^(2 WIDTH - 2) .. 3 2^(2 WIDTH - 2)
);

    localparam P_W = 2 * WIDTH;

    wire [3*P_W-1:0] products;
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : component
            glint_signed_multiplier #(
                .WIDTH (WIDTH),
                .STAGES(MULTIPLIER_STAGES)
            ) multiplier (
                .clk_i    (clk_i),
                .enable_i (enable_i),
                .a_i      (a_i[WIDTH*i+:WIDTH]),
                .b_i      (b_i[WIDTH*i+:WIDTH]),
                .product_o(products[P_W*i+:P_W])
            );
        end
    endgenerate

    // A product is at most 2^(2 WIDTH - 2) in magnitude: two of them fit P_W bits but for 2 2^(2 WIDTH - 2), three one more.
    reg  [P_W:0] two_q, dot_q;
    reg [P_W-1:0] third_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            two_q   <= {products[P_W-1], products[P_W-1:0]} + {products[2*P_W-1], products[2*P_W-1:P_W]};
            third_q <= products[3*P_W-1:2*P_W];
            dot_q   <= two_q + {third_q[P_W-1], third_q};
        end
    end
    assign dot_o = dot_q;

endmodule

`default_nettype wire
