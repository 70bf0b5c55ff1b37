// sphere_checker: which field of a turning ball a point is in: 16 sectors of longitude, 8 bands of latitude. 5 clocks.
//
// The axis leans by the angle of a triangle of 5, 12 and 13 in the plane of the picture. Numbers: README.md.

`default_nettype none

module sphere_checker (
    input  wire               clk_i,
    input  wire signed [10:0] x_i,     // half pixels from the middle, right and up
    input  wire signed [10:0] y_i,
    input  wire        [14:0] z_i,     // code / 2^15, towards the viewer
    input  wire signed  [9:0] cos_i,   // the turn, code / 2^9; still during a frame
    input  wire signed  [9:0] sin_i,
    output wire               dark_o
);

    // A radius of 13 * 2^11: 5 times 409.6 half pixels, by 13 for the leaning axis.
    reg signed [16:0] tx_q, ty_q;
    reg        [14:0] tz_q;
    wire signed [16:0] x = {{6{x_i[10]}}, x_i};
    wire signed [16:0] y = {{6{y_i[10]}}, y_i};
    always @(posedge clk_i) begin
        tx_q <= 17'sd60 * x + 17'sd25 * y;
        ty_q <= 17'sd60 * y - 17'sd25 * x;
        tz_q <= 15'd13 * {4'd0, z_i[14:4]};
    end

    // On the sphere tx has 16 bits with its sign; 10 of them are half a pixel.
    wire  [9:0] tx = tx_q[15:6];
    wire  [9:0] tz = {1'b0, tz_q[14:6]};
    wire signed [19:0] tx_cos, tx_sin, tz_cos, tz_sin;
    sphere_product product_tx_cos (
        .clk_i    (clk_i),
        .a_i      (cos_i),
        .b_i      (tx),
        .product_o(tx_cos)
    );
    sphere_product product_tx_sin (
        .clk_i    (clk_i),
        .a_i      (sin_i),
        .b_i      (tx),
        .product_o(tx_sin)
    );
    sphere_product product_tz_cos (
        .clk_i    (clk_i),
        .a_i      (cos_i),
        .b_i      (tz),
        .product_o(tz_cos)
    );
    sphere_product product_tz_sin (
        .clk_i    (clk_i),
        .a_i      (sin_i),
        .b_i      (tz),
        .product_o(tz_sin)
    );
    reg signed [20:0] u_q, w_q;
    always @(posedge clk_i) begin
        u_q <= {tx_cos[19], tx_cos} + {tz_sin[19], tz_sin};
        w_q <= {tz_cos[19], tz_cos} - {tx_sin[19], tx_sin};
    end

    // Sectors: the axes, the diagonals, and 5/12, near the tangent of 22.5 degrees. Magnitudes of 11 bits tell a pixel.
    wire [11:0] u = u_q[20:9], w = w_q[20:9];
    wire [14:0] a = {4'd0, u[11] ? ~u[10:0] : u[10:0]};
    wire [14:0] b = {4'd0, w[11] ? ~w[10:0] : w[10:0]};
    reg   [3:0] sides_q;  // of the lines that part sectors
    always @(posedge clk_i) sides_q <= {u[11] ^ w[11], a < b, 15'd12 * a < 15'd5 * b, 15'd5 * a < 15'd12 * b};

    // Bands: the middle, and the sines of 22.5, 45, 67.5 degrees.
    wire        band;
    wire [16:0] height = ty_q[16] ? -ty_q : ty_q;
    glint_delay #(
        .WIDTH (1),
        .STAGES(4)
    ) delay_band (
        .clk_i   (clk_i),
        .enable_i(1'b1),
        .data_i  (ty_q[16] ^ (height > 17'd10189) ^ (height > 17'd18826) ^ (height > 17'd24598)),
        .data_o  (band)
    );
    assign dark_o = band ^ (^sides_q);
    wire unused = &{1'b0, tx_q[16], tx_q[5:0], tz_q[5:0], u_q[8:0], w_q[8:0], z_i[3:0]};

endmodule

`default_nettype wire
