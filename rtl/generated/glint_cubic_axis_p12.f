// The files of glint_cubic_axis_p12, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_skid.v
$(GLINT_RTL)/blocks/glint_axis.v
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_ports.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/lobes/glint_cubic.v
$(GLINT_RTL)/generated/glint_table_cubic_18_18.v
$(GLINT_RTL)/generated/glint_cubic_p12.v
$(GLINT_RTL)/generated/glint_cubic_axis_p12.v
