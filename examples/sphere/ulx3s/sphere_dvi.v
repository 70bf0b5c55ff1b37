// sphere_dvi: the sphere as four pairs of DVI, two bits of each a clock of clk_shift_i, which is five times clk_i.
//
// Both clocks come from one source. clk_i's words are taken one to two shift clocks after they change, whatever the phase.

`default_nettype none

module sphere_dvi (
    input  wire       clk_i,        // pixel clock
    input  wire       clk_shift_i,
    input  wire       rst_ni,       // synchronous to clk_i, active low
    input  wire       next_i,       // buttons: as in sphere
    input  wire       hold_turn_i,
    input  wire       hold_light_i,
    output wire [3:0] first_o,      // clock, red, green, blue: in the first half of a shift clock
    output wire [3:0] second_o,     // in the second half
    output wire       hsync_o,      // what is sent, three clk_i before
    output wire       vsync_o,
    output wire       visible_o,
    output wire [7:0] r_o,
    output wire [7:0] g_o,
    output wire [7:0] b_o
);

    sphere core (
        .clk_i       (clk_i),
        .rst_ni      (rst_ni),
        .next_i      (next_i),
        .hold_turn_i (hold_turn_i),
        .hold_light_i(hold_light_i),
        .hsync_o     (hsync_o),
        .vsync_o     (vsync_o),
        .visible_o   (visible_o),
        .r_o         (r_o),
        .g_o         (g_o),
        .b_o         (b_o)
    );

    // The clock's channel sends five ones and five zeros.
    wire [39:0] words;
    assign words[39:30] = 10'b0000011111;
    genvar c;
    generate
        for (c = 0; c < 3; c = c + 1) begin : channel
            sphere_tmds tmds (
                .clk_i    (clk_i),
                .rst_ni   (rst_ni),
                .visible_i(visible_o),
                .data_i   (c == 0 ? b_o : c == 1 ? g_o : r_o),
                .control_i(c == 0 ? {vsync_o, hsync_o} : 2'b00),
                .word_o   (words[10*c+:10])
            );
        end
    endgenerate

    reg phase_q, seen_q, seen_q2;
    always @(posedge clk_i) phase_q <= rst_ni & ~phase_q;
    wire load = seen_q ^ seen_q2;
    always @(posedge clk_shift_i) begin
        seen_q  <= phase_q;
        seen_q2 <= seen_q;
    end
    generate
        for (c = 0; c < 4; c = c + 1) begin : pair
            reg [9:0] shift_q;
            always @(posedge clk_shift_i) shift_q <= load ? words[10*c+:10] : {2'b00, shift_q[9:2]};
            assign first_o[c]  = shift_q[0];
            assign second_o[c] = shift_q[1];
        end
    endgenerate

endmodule

`default_nettype wire
