#!/usr/bin/env python3
"""The Slurm lines of docs/cluster.md, run by Slurm on this machine as its only node.

    slurm_test.py --build FOLDER        where glint and glint-cosim are

Exit status: 0 if they ran and every part is there, 77 where there is no Slurm or no right to start it, else 1.
"""

import argparse
import json
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = ("slurmctld", "slurmd", "sbatch", "sinfo", "munged")

CONFIGURATION = """
ClusterName=glint
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores}
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=os.path.abspath, required=True)
    build = parser.parse_args().build
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    missing = [program for program in PROGRAMS if shutil.which(program) is None]
    if missing or os.geteuid() != 0:
        print(f"skipped: no {', '.join(missing)} (packages slurm-wlm, munge)" if missing else "skipped: Slurm wants root")
        return 77
    text = (ROOT / "docs/cluster.md").read_text()
    commands = re.search(r"<!-- run by tests/cli/slurm_test.py -->\n```sh\n(.*?)```", text, re.DOTALL).group(1)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o755)
        for part in ("state", "spool", "work"):
            (folder / part).mkdir()
        (folder / "munge.key").write_bytes(os.urandom(128))
        (folder / "munge.key").chmod(0o400)
        host = socket.gethostname().split(".")[0]
        configuration = folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(folder=folder, host=host, ports=free_ports(2), cores=os.cpu_count()))
        environment = dict(os.environ, SLURM_CONF=str(configuration), PATH=f"{build}:{os.environ['PATH']}")
        daemons = []
        try:
            log = open(folder / "log", "w", encoding="utf-8")
            for command in (["munged", "--foreground", "--force", f"--socket={folder}/munge.socket", f"--key-file={folder}/munge.key",
                             f"--pid-file={folder}/munge.pid", f"--seed-file={folder}/munge.seed", f"--log-file={folder}/munge.log"],
                            ["slurmctld", "-D", "-f", configuration], ["slurmd", "-D", "-f", configuration, "-N", host]):
                daemons.append(subprocess.Popen(command, env=environment, stdout=log, stderr=log, cwd=folder))
                time.sleep(1)
            for _ in range(30):
                state = subprocess.run(["sinfo", "-h", "-o", "%t"], env=environment, capture_output=True, text=True, check=False)
                if state.stdout.strip() == "idle":
                    break
                time.sleep(1)
            else:
                print(f"FAILED: Slurm has no idle node: '{state.stdout.strip()}' {state.stderr}\n{(folder / 'log').read_text()[-3000:]}")
                return 1
            done = subprocess.run(["bash", "-euc", commands], env=environment, cwd=folder / "work", check=False, timeout=300)
            if done.returncode != 0:
                print(f"FAILED: exit status {done.returncode}\n{(folder / 'log').read_text()[-3000:]}")
                return 1
            run = json.loads((folder / "work/cosim.json").read_text())["runs"][0]
        finally:
            for daemon in reversed(daemons):
                daemon.terminate()
                daemon.wait()
    if not run["exhaustive"] or run["mismatches"] != 0:
        print(f"FAILED: {run['inputs']} inputs, {run['mismatches']} mismatches")
        return 1
    print(f"slurm: {run['inputs']} inputs in an array of 8, 0 mismatches")
    return 0


if __name__ == "__main__":
    sys.exit(main())
