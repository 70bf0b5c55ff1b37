// The files of glint_taylor_axis_p12, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_skid.v
$(GLINT_RTL)/blocks/glint_axis.v
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_ports.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/blocks/glint_square.v
$(GLINT_RTL)/blocks/glint_power.v
$(GLINT_RTL)/lobes/glint_taylor.v
$(GLINT_RTL)/generated/glint_taylor_p12.v
$(GLINT_RTL)/generated/glint_taylor_axis_p12.v
