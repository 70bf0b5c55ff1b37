#!/bin/sh
# Bambu v2024.03 with the front end clang-13. In any folder:
#
#   glint vectors --lobe bps --profile p12 --count 10000 --seed 1 --format tv -o <repository>/hls/vectors
#   <repository>/hls/bambu/run_hls.sh [PROFILE [KERNEL]]   p8, p12 (default), p16; bps (default), cayley, effect_ward, ...
#
# C simulation (the host's compiler), then synthesis and cosimulation of the RTL by Verilator, with the same test bench
# and vectors; then one input a clock through the RTL in Icarus, and its area by Yosys (measure.py). The first failure
# ends it, and so does a simulation that ran fewer vectors than the file has. Leaves <top>/<top>.v; the last line is for
# machines. The environment chooses:
#   CXX g++     BAMBU bambu     BAMBU_DEVICE xc7z020-1clg484-VVD     BAMBU_PERIOD clock period in ns, 10
#   GLINT_VECTORS the folder of the vectors, <repository>/hls/vectors
#   GLINT_DIVIDE  the form of the divider: ADDING, RADIX4, RECIPROCAL (hls/README.md); not set: restoring
#   NEXTPNR       nextpnr-ecp5, for the clock after route; none where there is no such program
set -eu

hls=$(cd "$(dirname "$0")/.." && pwd)
profile=${1:-p12}
kernel=${2:-bps}
top=glint_${kernel}_$profile
vectors=${GLINT_VECTORS:-$hls/vectors}/$top.tv
case $profile in
    p8 | p12 | p16) ;;
    *)
        echo "run_hls.sh: profile '$profile' is not legal: p8, p12 or p16" >&2
        exit 2
        ;;
esac
if [ ! -r "$hls/generated/$top.cpp" ]; then
    echo "run_hls.sh: kernel '$kernel' is not known: there is no generated/$top.cpp" >&2
    exit 2
fi
if [ ! -r "$vectors" ]; then
    echo "run_hls.sh: cannot read '$vectors': write it with \`glint vectors --format tv\`" >&2
    exit 2
fi
vectors=$(realpath "$vectors")
case ${GLINT_DIVIDE:-RESTORING} in
    RESTORING | ADDING | RADIX4 | RECIPROCAL) ;;
    *)
        echo "run_hls.sh: GLINT_DIVIDE '$GLINT_DIVIDE' is not legal: ADDING, RADIX4 or RECIPROCAL" >&2
        exit 2
        ;;
esac
divide=-DGLINT_DIVIDE_${GLINT_DIVIDE:-RESTORING}
mkdir -p "$top"
cd "$top"

echo "C simulation"
"${CXX:-g++}" -std=c++14 -O1 "$divide" -DGLINT_TOP="$top" "$hls/generated/$top.cpp" "$hls/testbench.cpp" -o testbench
./testbench "$top" "$vectors"

bambu=${BAMBU:-bambu}
if ! command -v "$bambu" >/dev/null; then
    echo "run_hls.sh: '$bambu' not found: set BAMBU to the program" >&2
    exit 2
fi

echo "Synthesis and cosimulation (bambu.log)"
rm -rf HLS_output results.txt "$top.v"
"$bambu" "$hls/generated/$top.cpp" --top-fname="$top" --compiler=I386_CLANG13 --std=c++14 -O2 "$divide" \
    --pipelining="$top"=1 --generate-interface=INFER --reset-type=sync --reset-level=low \
    --device-name="${BAMBU_DEVICE:-xc7z020-1clg484-VVD}" --clock-period="${BAMBU_PERIOD:-10}" \
    --generate-tb="$hls/testbench.cpp" --tb-extra-gcc-options="-std=c++14 $divide -DGLINT_TOP=$top" \
    --tb-arg="$top" --tb-arg="$vectors" --simulate --simulator=VERILATOR >bambu.log 2>&1 || {
    echo "run_hls.sh: Bambu failed; the end of bambu.log:" >&2
    tail -5 bambu.log >&2
    exit 1
}
# An exit status of 0 says little: Bambu has it after a simulation that stopped, too.
python3 -B "$hls/bambu/measure.py" "$top" "$vectors"
