// The files of glint_decay_p8, for `verilator -f` and `iverilog -f`. GLINT_RTL in the environment is the folder rtl/ of Glint.
$(GLINT_RTL)/blocks/glint_delay.v
$(GLINT_RTL)/blocks/glint_stream.v
$(GLINT_RTL)/blocks/glint_normalise.v
$(GLINT_RTL)/blocks/glint_multiplier.v
$(GLINT_RTL)/lobes/glint_decay.v
$(GLINT_RTL)/generated/glint_table_log_of_log_16_4_8.v
$(GLINT_RTL)/generated/glint_table_log2_n_1024_8.v
$(GLINT_RTL)/generated/glint_table_fall_4_4_10.v
$(GLINT_RTL)/generated/glint_decay_p8.v
