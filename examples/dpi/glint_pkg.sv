// The golden models in a SystemVerilog bench: the functions of glint.h, by DPI-C. Link libglint-c.
package glint_pkg;
    import "DPI-C" function string glint_error();
    import "DPI-C" function chandle glint_open_lobe(input string lobe, input string profile);
    import "DPI-C" function void glint_close(input chandle model);
    import "DPI-C" function int glint_eval_port(input chandle model, input int n, input longint cos_code,
                                                output int unsigned y, output int clamped);
endpackage
