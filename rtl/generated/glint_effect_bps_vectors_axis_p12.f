// The files of glint_effect_bps_vectors_axis_p12, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_skid.v
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_stream.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/blocks/glint_signed_multiplier.v
$(GLINT_RTL)/blocks/glint_dot_product.v
$(GLINT_RTL)/blocks/glint_vectors.v
$(GLINT_RTL)/blocks/glint_sqrt.v
$(GLINT_RTL)/blocks/glint_divider_restoring.v
$(GLINT_RTL)/blocks/glint_divider_radix4.v
$(GLINT_RTL)/blocks/glint_divider_iterative.v
$(GLINT_RTL)/blocks/glint_divider_reciprocal.v
$(GLINT_RTL)/blocks/glint_divider.v
$(GLINT_RTL)/blocks/glint_horner.v
$(GLINT_RTL)/effects/glint_effect_bps_vectors.v
$(GLINT_RTL)/generated/glint_effect_bps_vectors_p12.v
$(GLINT_RTL)/generated/glint_effect_bps_vectors_axis_p12.v
