#!/usr/bin/env python3
"""The Tcl of docs/tools.md for Vivado, Quartus and Radiant, executed by tclsh with stand-ins for the tools.

A stand-in knows the documented options of its command and refuses others; tclsh refuses a command without stand-in. The
files that a script adds must be those of the manifest. Exit status: 0 all as documented, 1 not.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/hls"), str(ROOT / "tests/rtl")]
from scripts_test import check, stand_ins  # noqa: E402
from units import RTL, units  # noqa: E402

UNIT = "glint_bps_p12"
# Options with an argument end in "=". TOOLS says which command adds files.
VIVADO = {  # UG835
    "read_verilog": "-library= -sv -quiet -verbose",
    "synth_design": "-name= -part= -constrset= -top= -include_dirs= -generic= -verilog_define= -flatten_hierarchy= -directive= "
                    "-rtl -mode= -fsm_extraction= -retiming -no_lc -shreg_min_size= -max_bram= -max_dsp= -quiet -verbose",
    "report_utilization": "-file= -append -hierarchical -hierarchical_depth= -cells= -name= -quiet -verbose",
}
QUARTUS = {  # Quartus Prime Scripting Reference Manual; Tcl Package project
    "project_new": "-family= -overwrite -part= -revision=",
    "set_global_assignment": "-comment= -disable -entity= -name= -remove -section_id= -tag=",
    "set_instance_assignment": "-comment= -disable -entity= -from= -name= -remove -section_id= -tag= -to=",
    "project_close": "-dont_export_assignments",
}
RADIANT = {  # the help of Radiant, "Tcl Command Reference Guide": project commands
    "prj_create": "-name= -dev= -performance= -impl= -impl_dir= -synthesis=",
    "prj_add_source": "-exclude -simulate_only -synthesis_only -impl= -format= -opt= -work=",
    "prj_set_impl_opt": "-impl= -append -rem",
    "prj_run": "-impl= -task= -forceOne -forceAll",
}
TOOLS = (("vivado", VIVADO, r"read_verilog (.*)"), ("quartus", QUARTUS, r"set_global_assignment -name VERILOG_FILE (.*)"),
         ("radiant", RADIANT, r"prj_add_source (.*)"))


def execute(folder, script):
    (folder / "script.tcl").write_text(script)
    return subprocess.run(["tclsh", "script.tcl"], cwd=folder, capture_output=True, text=True, check=False)


def main():
    scripts = re.findall(r"<!-- run by tests/install/tools_test.py -->\n```tcl\n(.*?)```", (ROOT / "docs/tools.md").read_text(), re.DOTALL)
    check(len(scripts) == len(TOOLS), f"{len(scripts)} scripts in docs/tools.md")
    wanted = [f"share/glint/rtl/{file.resolve().relative_to(RTL)}" for file in units()[UNIT]["files"]]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "share/glint").mkdir(parents=True)
        (folder / "share/glint/rtl").symlink_to(RTL)
        for (tool, commands, adds), script in zip(TOOLS, scripts):
            done = execute(folder, stand_ins(commands) + script)
            check(done.returncode == 0, f"{tool}: {done.stderr}")
            calls = re.findall(r"^called (.*)$", done.stdout, re.MULTILINE)
            check({call.split()[0] for call in calls} == set(commands), f"{tool}: called {calls}")
            added = [file for call in calls for files in re.findall(f"^{adds}$", call) for file in re.sub("[{}]", " ", files).split()]
            check(added == wanted, f"{tool} adds {added}, not {wanted}")
            print(f"{tool}: {len(calls)} commands, {len(added)} files")
            # The checks can fail: a command without stand-in, an option that is not documented.
            last = script.splitlines()[-1].split()[0]
            done = execute(folder, stand_ins(commands) + f"rename {last} {{}}\n" + script)
            check(done.returncode == 1 and "invalid command name" in done.stderr, f"{tool}: a command without stand-in")
            done = execute(folder, stand_ins(commands) + f"{last} -none 1\n")
            check(done.returncode == 1 and "no option -none" in done.stderr, f"{tool}: an option that is not documented")


if __name__ == "__main__":
    main()
