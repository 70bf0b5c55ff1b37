// The files of glint_gauss_p8, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_ports.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/blocks/glint_parabola.v
$(GLINT_RTL)/blocks/glint_exp2.v
$(GLINT_RTL)/lobes/glint_gauss.v
$(GLINT_RTL)/generated/glint_table_half_square_angle_16_22.v
$(GLINT_RTL)/generated/glint_table_exp2_4_13.v
$(GLINT_RTL)/generated/glint_gauss_p8.v
