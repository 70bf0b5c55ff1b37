// The files of glint_effect_phong_bps_p16, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/glint_delay.v
$(GLINT_RTL)/glint_ports.v
$(GLINT_RTL)/glint_multiplier.v
$(GLINT_RTL)/glint_divider_restoring.v
$(GLINT_RTL)/glint_divider_radix4.v
$(GLINT_RTL)/glint_divider_iterative.v
$(GLINT_RTL)/glint_divider_reciprocal.v
$(GLINT_RTL)/glint_divider.v
$(GLINT_RTL)/glint_ratio.v
$(GLINT_RTL)/glint_horner.v
$(GLINT_RTL)/glint_bps.v
$(GLINT_RTL)/generated/glint_bps_p16.v
$(GLINT_RTL)/glint_dot.v
$(GLINT_RTL)/glint_effect_highlight.v
$(GLINT_RTL)/generated/glint_effect_phong_bps_p16.v
