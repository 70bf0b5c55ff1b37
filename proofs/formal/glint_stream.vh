// Included at the end of a copy of glint_stream, whose valid bits are those of glint_ports.

localparam CLOCKS    = LATENCY;
localparam ITERATIVE = 0;
`include "glint_ports.vh"
