// One highlight through the Verilog: `bps` at p12, n = 50, from cos = 1 down to 0.9.
module highlight;
    reg         clk = 0, rst_n = 0, valid = 0;
    reg  [19:0] cosine = 20'd262144;  // 1.0: a code is cos * 2^18
    wire [12:0] y;                    // the highlight * 2^12
    wire [19:0] of;                   // the tag: here the cosine, which travels with its result
    wire        ready, done, clamped;

    glint_bps_p12 #(.TAG_W(20)) unit (
        .clk_i(clk), .rst_ni(rst_n), .valid_i(valid), .ready_o(ready), .n_i(10'd50), .cos_i(cosine), .tag_i(cosine),
        .valid_o(done), .ready_i(1'b1), .y_o(y), .tag_o(of), .clamped_o(clamped));

    always #5 clk = ~clk;
    initial #40 begin rst_n = 1; valid = 1; end
    always @(posedge clk) begin
        if (valid & ready) cosine <= cosine - 20'd5243;  // 0.02
        if (done) $display("cos %6.4f  highlight %6.4f  (code %0d)", of / 262144.0, y / 4096.0, y);
        if (done & of < 20'd235930) $finish(0);
    end
endmodule
