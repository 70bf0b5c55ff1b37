// The files of glint_taylor_p8, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/glint_delay.v
$(GLINT_RTL)/glint_ports.v
$(GLINT_RTL)/glint_multiplier.v
$(GLINT_RTL)/glint_square.v
$(GLINT_RTL)/glint_power.v
$(GLINT_RTL)/glint_taylor.v
$(GLINT_RTL)/generated/glint_taylor_p8.v
