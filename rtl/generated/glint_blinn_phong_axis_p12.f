// The files of glint_blinn_phong_axis_p12, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_skid.v
$(GLINT_RTL)/blocks/glint_axis.v
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_ports.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/blocks/glint_parabola.v
$(GLINT_RTL)/blocks/glint_log2.v
$(GLINT_RTL)/blocks/glint_exp2.v
$(GLINT_RTL)/lobes/glint_blinn_phong.v
$(GLINT_RTL)/generated/glint_table_log2_32_25.v
$(GLINT_RTL)/generated/glint_table_exp2_8_17.v
$(GLINT_RTL)/generated/glint_blinn_phong_p12.v
$(GLINT_RTL)/generated/glint_blinn_phong_axis_p12.v
