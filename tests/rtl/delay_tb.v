// glint_delay: data_o is data_i of STAGES enabled edges ago, and stays while enable_i is 0, when data_i is x.
// Verilog-2005, for any simulator. The last line is `10000 items, 0 mismatches`; ten mismatches end the run.

`default_nettype none

module delay_tb;

    parameter WIDTH  = 1;
    parameter STAGES = 1;
    parameter ITEMS  = 10000;

    reg              clk;
    reg              enable;
    reg  [WIDTH-1:0] data;
    wire [WIDTH-1:0] delayed;

    glint_delay #(
        .WIDTH (WIDTH),
        .STAGES(STAGES)
    ) delay (
        .clk_i   (clk),
        .enable_i(enable),
        .data_i  (data),
        .data_o  (delayed)
    );

    initial clk = 1'b0;
    always #1 clk = ~clk;

    reg [WIDTH-1:0] history[0:STAGES-1];  // what went in at the last STAGES enabled edges
    integer         entered;
    integer         items;
    integer         mismatches;
    integer         clock, stalled;
    integer         seed;

    initial begin
        enable     = 1'b0;
        clock      = 0;
        stalled    = 0;
        entered    = 0;
        items      = 0;
        mismatches = 0;
        seed       = 1;
        while (items < ITEMS && mismatches < 10) begin
            @(posedge clk);
            clock = clock + 1;
            if (entered >= STAGES && delayed !== history[entered%STAGES]) begin
                mismatches = mismatches + 1;
                $display("FAILED: clock %0d: %h instead of %h", clock, delayed, history[entered%STAGES]);
            end
            if (enable) begin
                if (entered >= STAGES) items = items + 1;
                history[entered%STAGES] = data;
                entered                 = entered + 1;
            end else begin
                stalled = stalled + 1;
            end
            if (clock % 32 < 16 || $random(seed) % 2 == 0) begin
                enable <= 1'b1;
                data   <= {$random(seed), $random(seed)};
            end else begin
                enable <= 1'b0;
                data   <= {WIDTH{1'bx}};
            end
        end
        if (mismatches == 0 && stalled == 0) begin
            mismatches = 1;
            $display("FAILED: enable_i was never 0");
        end
        $display("%0d items, %0d mismatches", items, mismatches);
        $finish(0);
    end

endmodule

`default_nettype wire
