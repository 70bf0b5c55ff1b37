# Catapult HLS; nobody has run this yet. In any folder:
#
#   glint vectors --lobe bps --profile p12 --count 10000 --seed 1 --format tv -o <repository>/hls/vectors
#   catapult -shell -file <repository>/hls/catapult/run_hls.tcl
#
# C simulation, synthesis and cosimulation of the RTL (SCVerify), each with the same test bench and vectors; the first
# failure ends it with exit status 1. The Verilog is rtl.v in the folder of the solution. The environment chooses:
#   GLINT_KERNEL bps (default), cayley, effect_ward, ...     GLINT_PROFILE p8, p12 (default), p16
#   GLINT_PERIOD clock period in ns, 5
#   GLINT_ROM_FROM tables of more entries become memories, 64; smaller ones logic
#   GLINT_SIMULATOR msim (default), vcs, ncsim: the name by which SCVerify knows the RTL simulator

proc choice {name default} { return [expr {[info exists ::env($name)] ? $::env($name) : $default}] }

set hls [file dirname [file dirname [file normalize [info script]]]]
set top glint_[choice GLINT_KERNEL bps]_[choice GLINT_PROFILE p12]
set period [choice GLINT_PERIOD 5.0]
set simulator [choice GLINT_SIMULATOR msim]
set vectors [file join $hls vectors $top.tv]
if {![file readable $vectors]} {
    puts stderr "run_hls.tcl: cannot read '$vectors': write it with `glint vectors --format tv`"
    exit 1
}

if {[catch {
    project new -name $top
    solution new -state initial
    solution options defaults
    solution options set /Input/CppStandard c++14
    solution options set /Input/CompilerFlags "-DGLINT_CATAPULT -DGLINT_TOP=$top"
    solution options set /Output/OutputVerilog true
    solution options set /Output/OutputVHDL false
    flow package require /SCVerify
    flow package option set /SCVerify/INVOKE_ARGS "$top $vectors"

    solution file add [file join $hls generated $top.cpp] -type C++
    solution file add [file join $hls testbench.cpp] -type C++ -exclude true
    go analyze
    solution design set $top -top
    go compile
    flow run /SCVerify/launch_make ./scverify/Verify_orig_cxx_osci.mk {} SIMTOOL=osci sim

    solution library add mgc_Xilinx-ARTIX-7-1_beh -- \
        -rtlsyntool Vivado -manufacturer Xilinx -family ARTIX-7 -speed -1 -part xc7a35tcpg236-1
    solution library add Xilinx_ROMS
    go libraries
    directive set -MEM_MAP_THRESHOLD [choice GLINT_ROM_FROM 64]
    directive set -CLOCKS [list clk [list -CLOCK_PERIOD $period -CLOCK_EDGE rising \
        -RESET_KIND sync -RESET_SYNC_NAME rst_n -RESET_SYNC_ACTIVE low]]
    go assembly
    directive set /$top/core/main -PIPELINE_INIT_INTERVAL 1
    go architect
    go extract
    flow run /SCVerify/launch_make ./scverify/Verify_rtl_v_$simulator.mk {} SIMTOOL=$simulator sim
    project save
} message]} {
    puts stderr "run_hls.tcl: $message"
    exit 1
}
exit 0
