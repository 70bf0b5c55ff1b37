// The files of glint_effect_blinn_phong_vectors_p12, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_stream.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/blocks/glint_signed_multiplier.v
$(GLINT_RTL)/blocks/glint_dot_product.v
$(GLINT_RTL)/blocks/glint_vectors.v
$(GLINT_RTL)/blocks/glint_parabola.v
$(GLINT_RTL)/blocks/glint_log2.v
$(GLINT_RTL)/blocks/glint_exp2.v
$(GLINT_RTL)/effects/glint_effect_blinn_phong_vectors.v
$(GLINT_RTL)/generated/glint_table_log2_128_27.v
$(GLINT_RTL)/generated/glint_table_exp2_8_17.v
$(GLINT_RTL)/generated/glint_effect_blinn_phong_vectors_p12.v
