// The files of glint_effect_cook_torrance_modified_axis_p12, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_skid.v
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_stream.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/blocks/glint_parabola.v
$(GLINT_RTL)/blocks/glint_log2.v
$(GLINT_RTL)/blocks/glint_attenuation.v
$(GLINT_RTL)/blocks/glint_scaled_power.v
$(GLINT_RTL)/blocks/glint_dot.v
$(GLINT_RTL)/blocks/glint_microfacets.v
$(GLINT_RTL)/effects/glint_effect_cook_torrance_modified.v
$(GLINT_RTL)/generated/glint_table_log2_32_21.v
$(GLINT_RTL)/generated/glint_table_exp2_8_17.v
$(GLINT_RTL)/generated/glint_effect_cook_torrance_modified_p12.v
$(GLINT_RTL)/generated/glint_effect_cook_torrance_modified_axis_p12.v
