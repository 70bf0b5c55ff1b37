// The files of glint_gauss_axis_p16, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/glint_skid.v
$(GLINT_RTL)/glint_axis.v
$(GLINT_RTL)/glint_delay.v
$(GLINT_RTL)/glint_ports.v
$(GLINT_RTL)/glint_multiplier.v
$(GLINT_RTL)/glint_parabola.v
$(GLINT_RTL)/glint_exp2.v
$(GLINT_RTL)/glint_gauss.v
$(GLINT_RTL)/generated/glint_gauss_p16.v
$(GLINT_RTL)/generated/glint_gauss_axis_p16.v
