#!/usr/bin/env python3
"""The scripts for Vitis HLS, Catapult and Bambu, executed with stand-ins for the tools: scripts_test.py GLINT.

A stand-in knows the documented options of its command and refuses others; tclsh refuses a command without stand-in. The
C simulation is real: the stand-in compiles the files that the script added, with their flags, and runs them. The keys
of the config file are held against the documented list. Stand-ins for Bambu fail, or succeed and simulate too little:
run_hls.sh has to notice. Exit status: 0 all as documented, 1 not.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

HLS = Path(__file__).resolve().parents[2] / "hls"
KERNELS = ("bps", "effect_ward")  # a lobe without tables, an effect with tables

# Options with an argument end in "=". Vitis HLS: UG1399, chapter "HLS Tcl Commands".
VITIS = {
    "open_project": "-reset -upgrade",
    "set_top": "",
    "add_files": "-appendflags -blackbox= -cflags= -csimflags= -tb",
    "open_solution": "-flow_target= -reset",
    "set_part": "",
    "create_clock": "-name= -period=",
    "csim_design": "-O -argv= -clean -ldflags= -mflags= -profile -setup",
    "csynth_design": "-dump_cfg -dump_post_cfg -synthesis_check",
    "cosim_design": "-O -argv= -coverage -ldflags= -mflags= -rtl= -setup -tool= -trace_level= -wave_debug",
    "export_design": "-description= -display_name= -flow= -format= -ipname= -library= -output= -rtl= -vendor= -version=",
}
# Keys of a config file: UG1399, tables of HLS general options, C synthesis sources, testbench sources, packaging.
KEYS = {"part", "hls.flow_target", "hls.clock", "hls.syn.top", "hls.syn.file", "hls.syn.cflags", "hls.syn.csimflags",
        "hls.tb.file", "hls.tb.cflags", "hls.csim.argv", "hls.cosim.argv", "hls.package.output.format"}
# Catapult: the commands and options of the project files of its 2023.1 release and of published scripts.
CATAPULT = {
    "project": "-name=",
    "solution": "-state= -type= -exclude= -top -- -rtlsyntool= -manufacturer= -family= -speed= -part=",
    "flow": "",
    "go": "",
    "directive": "-CLOCKS= -MEM_MAP_THRESHOLD= -PIPELINE_INIT_INTERVAL=",
}

COMMON = r"""
proc record {command options arguments} {
    for {set i 0} {$i < [llength $arguments]} {incr i} {
        set word [lindex $arguments $i]
        if {$word in {option options}} break  ;# a path and its value follow
        if {![string match -* $word] || [string is double $word]} continue
        if {"$word=" in $options} {
            incr i
            if {$i == [llength $arguments]} { error "$command: $word wants a value" }
        } elseif {$word ni $options} {
            error "$command: no option $word"
        }
    }
    puts "called $command $arguments"
}
proc run {arguments} { exec {*}$arguments >@stdout 2>@stderr }
"""
CSIM = r"""
rename add_files added
rename csim_design simulated
set units {}
proc add_files {args} {
    added {*}$args
    lappend ::units [lsearch -inline -glob $args *.cpp]
    set ::cflags [lindex $args [expr {[lsearch $args -cflags] + 1}]]
}
proc csim_design {args} {
    simulated {*}$args
    run [list $::env(CXX) {*}$::cflags {*}$::units -o csim]
    run [list ./csim {*}[lindex $args [expr {[lsearch $args -argv] + 1}]]]
}
"""
SCVERIFY = r"""
rename solution solved
rename flow flowed
set units {}
proc solution {args} {
    solved {*}$args
    if {[lrange $args 0 1] eq {file add}} { lappend ::units [lindex $args 2] }
    if {[lrange $args 0 2] eq {options set /Input/CompilerFlags}} { set ::cflags [lindex $args 3] }
}
proc flow {args} {
    flowed {*}$args
    if {[lrange $args 0 3] eq {package option set /SCVerify/INVOKE_ARGS}} { set ::arguments [lindex $args 4] }
    if {[lrange $args 0 1] eq {run /SCVerify/launch_make} && "SIMTOOL=osci" in $args} {
        # Outside the tool there is neither its header nor its compiler.
        set flags [lsearch -all -inline -not $::cflags -DGLINT_CATAPULT]
        run [list $::env(CXX) -std=c++14 {*}$flags {*}$::units -o csim]
        run [list ./csim {*}$::arguments]
    }
}
"""


def stand_ins(commands):
    return COMMON + "".join(f"proc {name} {{args}} {{ record {name} {{{options}}} $args }}\n"
                            for name, options in commands.items())


def check(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def execute(script, prelude, kernel, folder, hls=HLS):
    folder.mkdir()
    (folder / "script.tcl").write_text(f"{prelude}\nset argv0 {{{hls / script}}}\ninfo script {{{hls / script}}}\n"
                                       f"source {{{hls / script}}}\n")
    return subprocess.run(["tclsh", "script.tcl"], cwd=folder, capture_output=True, text=True,
                          env={"CXX": "g++", **os.environ, "GLINT_KERNEL": kernel, "GLINT_PROFILE": "p12"})


def main():
    glint = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        hls = folder / "hls"  # a view of the folder whose vectors are of this test
        hls.mkdir()
        for path in HLS.iterdir():
            if path.name not in ("vectors", "vitis", "catapult"):
                (hls / path.name).symlink_to(path)
        for tool in ("vitis", "catapult"):  # by copy: a script finds its neighbours from where it really is
            (hls / tool).mkdir()
            for path in (HLS / tool).iterdir():
                (hls / tool / path.name).write_bytes(path.read_bytes())

        tools = (("vitis/run_hls.tcl", stand_ins(VITIS) + CSIM,
                  "open_project set_top add_files add_files open_solution set_part create_clock csim_design "
                  "csynth_design cosim_design export_design"),
                 ("catapult/run_hls.tcl", stand_ins(CATAPULT) + SCVERIFY, "project solution go directive flow"))
        for script, prelude, expected in tools:
            for kernel in KERNELS:
                done = execute(script, prelude, kernel, folder / f"{Path(script).parent}-{kernel}-none", hls)
                check(done.returncode == 1 and "cannot read" in done.stderr and done.stderr.count("\n") == 1,
                      f"{script}, {kernel}, without vectors: {done.returncode}\n{done.stdout}{done.stderr}")
        for kernel in KERNELS:
            unit, name = ("effect", kernel[7:]) if kernel.startswith("effect_") else ("lobe", kernel)
            subprocess.run([glint, "vectors", f"--{unit}", name, "--profile", "p12", "--count", "1000", "-o",
                            hls / "vectors"], check=True, stdout=subprocess.DEVNULL)
        for script, prelude, expected in tools:
            for kernel in KERNELS:
                done = execute(script, prelude, kernel, folder / f"{Path(script).parent}-{kernel}", hls)
                print(done.stdout, end="")
                check(done.returncode == 0, f"{script}, {kernel}: {done.returncode}\n{done.stderr}")
                calls = [line.split()[1] for line in done.stdout.splitlines() if line.startswith("called ")]
                check(calls == expected.split() or script.startswith("catapult") and set(calls) == set(expected.split()),
                      f"{script}, {kernel}: called {calls}")
                check("1000 vectors, 0 mismatches" in done.stdout, f"{script}, {kernel}: no C simulation")
            broken = prelude + "rename go {}\n" if "proc go" in prelude else prelude + "rename cosim_design {}\n"
            done = execute(script, broken, "bps", folder / f"{Path(script).parent}-broken", hls)
            check(done.returncode == 1 and "invalid command name" in done.stderr, f"{script}: a command without stand-in")

        (hls / "bambu").unlink()
        (hls / "bambu").mkdir()
        for path in HLS.glob("bambu/*.??"):
            (hls / "bambu" / path.name).write_bytes(path.read_bytes())
            (hls / "bambu" / path.name).chmod(0o755)
        log = "HLS_output/simulation/testbench.log"
        bambus = (("exit 0", "simulated nothing"),
                  (f"mkdir -p {log[:-13]}; echo 'Sim: stopped' >{log}", "did not come to its end"),
                  ("echo broken; exit 1", "broken"))
        for number, (body, expected) in enumerate((("", "not found"), *bambus)):
            bambu = folder / f"bambu{number}"
            if body:
                bambu.write_text(f"#!/bin/sh\n{body}\n")
                bambu.chmod(0o755)
            done = subprocess.run([hls / "bambu/run_hls.sh", "p12", "bps"], cwd=folder, capture_output=True, text=True,
                                  env={**os.environ, "BAMBU": str(bambu)})
            check(done.returncode == (1 if body else 2) and expected in done.stderr,
                  f"run_hls.sh, {body or 'no Bambu'}: {done.returncode}\n{done.stdout}{done.stderr}")

        section = ""
        for line in (HLS / "vitis/hls_config.cfg").read_text().splitlines():
            line = line.strip()
            if line.startswith("["):
                section = line.strip("[]") + "."
            elif line and not line.startswith("#"):
                key, value = line.split("=", 1)
                check(section + key in KEYS, f"hls_config.cfg: no key {section}{key}")
                check(value, f"hls_config.cfg: {key} is empty")
                if key.endswith(".file"):
                    check((hls / "vitis" / value).exists(), f"hls_config.cfg: '{value}' is not there")


if __name__ == "__main__":
    main()
