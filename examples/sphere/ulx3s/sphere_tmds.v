// sphere_tmds: eight bits of a colour, or two bits of synchronisation, as a word of ten bits of DVI 1.0. 3 clocks.

`default_nettype none

module sphere_tmds (
    input  wire       clk_i,
    input  wire       rst_ni,     // synchronous, active low
    input  wire       visible_i,  // a pixel; else control
    input  wire [7:0] data_i,
    input  wire [1:0] control_i,
    output wire [9:0] word_o      // bit 0 goes out first
);

    function [3:0] ones(input [7:0] bits);
        ones = {3'd0, bits[0]} + {3'd0, bits[1]} + {3'd0, bits[2]} + {3'd0, bits[3]} + {3'd0, bits[4]} + {3'd0, bits[5]}
            + {3'd0, bits[6]} + {3'd0, bits[7]};
    endfunction

    // Few transitions: each bit is the exclusive or, or nor, of the one before and its own.
    reg  [7:0] data_q;
    reg        invert_q, visible_q, visible_q2;
    reg  [1:0] control_q, control_q2;
    wire [3:0] ones_in = ones(data_i);
    wire [7:0] chain;
    genvar k;
    generate
        for (k = 0; k < 8; k = k + 1) begin : link
            assign chain[k] = ^data_q[k:0] ^ (invert_q & k % 2 == 1);
        end
    endgenerate

    // As many ones as zeros: `excess` is half of what ones are more than zeros, so far; `more` is that of the eight bits.
    reg         [7:0] chain_q;
    reg               plain_q;
    reg signed  [3:0] more_q, excess_q;
    reg         [9:0] word_q;
    wire              even = more_q == 4'sd0 | excess_q == 4'sd0;
    wire              flip = even ? ~plain_q : more_q[3] == excess_q[3];
    wire signed [3:0] change = flip ? -more_q : more_q;
    // Bits 9 and 8 are 01 or 10 where `even` holds or they say different things; 11 adds one to the excess, 00 takes one.
    wire signed [3:0] tail = even ? 4'sd0 : (plain_q & flip) ? 4'sd1 : (~plain_q & ~flip) ? -4'sd1 : 4'sd0;
    always @(posedge clk_i) begin
        data_q     <= data_i;
        invert_q   <= ones_in > 4'd4 | (ones_in == 4'd4 & ~data_i[0]);
        visible_q  <= visible_i;
        control_q  <= control_i;
        chain_q    <= chain;
        plain_q    <= ~invert_q;
        more_q     <= $signed(ones(chain)) - 4'sd4;
        visible_q2 <= visible_q;
        control_q2 <= control_q;
        if (!rst_ni | !visible_q2) excess_q <= 4'sd0;
        else excess_q <= excess_q + change + tail;
        case ({visible_q2, control_q2})
            3'b000: word_q <= 10'b1101010100;
            3'b001: word_q <= 10'b0010101011;
            3'b010: word_q <= 10'b0101010100;
            3'b011: word_q <= 10'b1010101011;
            default: word_q <= {flip, plain_q, chain_q ^ {8{flip}}};
        endcase
    end
    assign word_o = word_q;

endmodule

`default_nettype wire
