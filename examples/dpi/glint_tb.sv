// A bench for glint_bps_p12 whose reference is the golden model: random inputs, bubbles and stalls; results in order.
// docs/c-api.md has the command that builds it with Verilator.
module glint_tb;
    import glint_pkg::*;

    localparam int COUNT = 100000;

    logic clk = 0, rst_n = 0, valid = 0, ready = 0, taken = 0;
    logic [9:0] n = 0;
    logic [19:0] cosine = 0;
    logic [15:0] tag = 0;
    wire ready_o, valid_o, clamped_o;
    wire [12:0] y_o;
    wire [15:0] tag_o;

    glint_bps_p12 unit (
        .clk_i(clk), .rst_ni(rst_n), .valid_i(valid), .ready_o(ready_o), .n_i(n), .cos_i(cosine), .tag_i(tag),
        .valid_o(valid_o), .ready_i(ready), .y_o(y_o), .tag_o(tag_o), .clamped_o(clamped_o)
    );

    typedef struct packed {
        logic        clamped;
        logic [12:0] y;
        logic [15:0] tag;
    } result_t;
    result_t expected[$];

    chandle model;
    int sent = 0, received = 0, mismatches = 0;

    function automatic void send();
        int unsigned y;
        int clamped;
        result_t result;
        if (glint_eval_port(model, int'(n), longint'($signed(cosine)), y, clamped) != 0) $fatal(1, "%s", glint_error());
        result.clamped = clamped != 0;
        result.y = y[12:0];
        result.tag = tag;
        expected.push_back(result);
        sent++;
    endfunction

    function automatic void receive();
        result_t wanted;
        if (expected.size() == 0) $fatal(1, "a result that nobody asked for");
        wanted = expected.pop_front();
        if ({clamped_o, y_o, tag_o} != wanted) mismatches++;
        received++;
    endfunction

    always #5 clk = ~clk;

    initial begin
        model = glint_open_lobe("bps", "p12");
        if (model == null) $fatal(1, "%s", glint_error());
        repeat (3) @(negedge clk);
        rst_n = 1;
        while (received < COUNT) begin
            // What the ports show before the edge is what the edge takes.
            @(negedge clk);
            if (!valid || taken) begin
                valid = sent < COUNT && $urandom_range(9) != 0;
                n = 10'($urandom);
                cosine = 20'($urandom);
                tag = 16'(sent);
            end
            ready = $urandom_range(3) != 0;
            #1;
            taken = valid && ready_o;
            if (taken) send();
            if (valid_o && ready) receive();
        end
        $display("%0d inputs, %0d mismatches", received, mismatches);
        glint_close(model);
        if (mismatches != 0) $fatal(1, "mismatches");
        $finish(0);
    end
endmodule
