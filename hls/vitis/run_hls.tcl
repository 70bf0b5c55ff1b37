# Vitis HLS before 2023.2, or by `vitis-run --mode hls --tcl run_hls.tcl`; nobody has run this yet. In any folder:
#
#   glint vectors --lobe bps --profile p12 --count 10000 --seed 1 --format tv -o <repository>/hls/vectors
#   vitis_hls -f <repository>/hls/vitis/run_hls.tcl
#
# C simulation, synthesis, cosimulation of the RTL and export, each with the same test bench and vectors; the first
# failure ends it with exit status 1. The environment chooses:
#   GLINT_KERNEL bps (default), cayley, effect_ward, ...     GLINT_PROFILE p8, p12 (default), p16
#   GLINT_PART xc7a35tcpg236-1     GLINT_PERIOD clock period in ns, 5

proc choice {name default} { return [expr {[info exists ::env($name)] ? $::env($name) : $default}] }

set hls [file dirname [file dirname [file normalize [info script]]]]
set top glint_[choice GLINT_KERNEL bps]_[choice GLINT_PROFILE p12]
set vectors [file join $hls vectors $top.tv]
if {![file readable $vectors]} {
    puts stderr "run_hls.tcl: cannot read '$vectors': write it with `glint vectors --format tv`"
    exit 1
}

if {[catch {
    open_project -reset $top
    set_top $top
    add_files [file join $hls generated $top.cpp] -cflags "-std=c++14"
    add_files -tb [file join $hls testbench.cpp] -cflags "-std=c++14 -DGLINT_TOP=$top"
    open_solution -reset solution -flow_target vivado
    set_part [choice GLINT_PART xc7a35tcpg236-1]
    create_clock -period [choice GLINT_PERIOD 5]

    csim_design -argv "$top $vectors"
    csynth_design
    cosim_design -argv "$top $vectors" -rtl verilog
    export_design -format ip_catalog -rtl verilog
} message]} {
    puts stderr "run_hls.tcl: $message"
    exit 1
}
exit 0
