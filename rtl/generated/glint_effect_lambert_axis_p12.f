// The files of glint_effect_lambert_axis_p12, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_skid.v
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_stream.v
$(GLINT_RTL)/blocks/glint_dot.v
$(GLINT_RTL)/effects/glint_effect_lambert.v
$(GLINT_RTL)/generated/glint_effect_lambert_p12.v
$(GLINT_RTL)/generated/glint_effect_lambert_axis_p12.v
