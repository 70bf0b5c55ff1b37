// The units of bps without their wrappers. Add the wrapper of your profile (generated/glint_bps_p12.v, for AXI4-Stream
// also generated/glint_bps_axis_p12.v; or those from `glint emit`); paths are relative to this file's folder.
glint_axis.v
glint_bps.v
glint_delay.v
glint_divider.v
glint_divider_iterative.v
glint_divider_radix4.v
glint_divider_reciprocal.v
glint_divider_restoring.v
glint_horner.v
glint_multiplier.v
glint_ports.v
glint_ratio.v
glint_skid.v
