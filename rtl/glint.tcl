# glint_files UNIT: the Verilog files of a unit, in an order in which they compile, as generated/UNIT.f lists them.
set glint_rtl [file dirname [info script]]
proc glint_files {unit} {
    global glint_rtl
    set file [open $glint_rtl/generated/$unit.f]
    set list [read $file]
    close $file
    return [string map [list {$(GLINT_RTL)} $glint_rtl] [regexp -all -inline -line {^\$.*$} $list]]
}
