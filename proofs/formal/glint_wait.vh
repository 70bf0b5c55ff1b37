// Included at the end of a copy of glint_wait whose CLOCKS are so many that it is a memory.

// What entered so many enabled clocks ago, less one; age is for the owner to drive.
wire       [7:0] age;
wire [WIDTH-1:0] at_age = age == CLOCKS - 1 ? memory.data_q : memory.words[memory.write_q - 1'b1 - age];

always @* if (!$initstate) inv_places: assert (memory.write_q - memory.read_q == memory.AHEAD);
