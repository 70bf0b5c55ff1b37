// The units glint_bps and glint_bps_axis without their wrappers. Add the wrapper of your profile
// (generated/glint_bps_p12.v, or one from `glint emit`); paths are relative to this file's folder.
glint_bps.v
glint_bps_axis.v
glint_delay.v
glint_divider.v
glint_skid.v
