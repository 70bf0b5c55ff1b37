// sphere_material: the materials that the button steps through, from materials.hex. No clock.

`default_nettype none

module sphere_material (
    input  wire  [1:0] material_i,
    input  wire        dark_i,      // the darker fields
    output wire  [9:0] n_o,         // specular exponent
    output wire [26:0] kd_o,        // diffuse colour {b, g, r}, 9 bits each, code / 2^8
    output wire [26:0] ks_o         // specular colour
);

    // A word: three digits of the exponent; three of red, green, blue of the light fields, the dark ones, the highlight.
    reg [47:0] materials[0:3];
    initial $readmemh("examples/sphere/materials.hex", materials);
    wire [47:0] word = materials[material_i];

    // A digit in sixteenths, 15 for 1.0 and 8 to 14 for one more than they say: code 0, 16, .. 112, 144, .. 256.
    function [8:0] code(input [3:0] digit);
        code = {{1'b0, digit} + {4'd0, digit[3]}, 4'd0};
    endfunction
    wire [11:0] kd = dark_i ? word[23:12] : word[35:24];
    assign n_o  = word[45:36];
    assign kd_o = {code(kd[3:0]), code(kd[7:4]), code(kd[11:8])};
    assign ks_o = {code(word[3:0]), code(word[7:4]), code(word[11:8])};
    wire unused = &{1'b0, word[47:46]};

endmodule

`default_nettype wire
