// The files of glint_quadratic_p8, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_ports.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/lobes/glint_quadratic.v
$(GLINT_RTL)/generated/glint_quadratic_p8.v
