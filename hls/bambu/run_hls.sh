#!/bin/sh
# Bambu v2024.03; its steps after the C simulation nobody has run yet on the kernels as they are now. In any folder:
#
#   glint vectors --lobe bps --profile p12 --count 10000 --seed 1 --format tv -o <repository>/hls/vectors
#   <repository>/hls/bambu/run_hls.sh [PROFILE [LOBE]]   p8, p12 (default), p16; bps (default), cayley, ...
#
# C simulation (the host's compiler), then synthesis and cosimulation of the RTL by Verilator, with the same test bench
# and vectors; the first failure ends it. Leaves <top>/<top>.v. The environment chooses:
#   CXX g++     BAMBU bambu     BAMBU_DEVICE xc7z020-1clg484-VVD     BAMBU_PERIOD clock period in ns, 10
set -eu

hls=$(cd "$(dirname "$0")/.." && pwd)
profile=${1:-p12}
lobe=${2:-bps}
top=glint_${lobe}_$profile
vectors=$hls/vectors/$top.tv
case $profile in
    p8 | p12 | p16) ;;
    *)
        echo "run_hls.sh: profile '$profile' is not legal: p8, p12 or p16" >&2
        exit 2
        ;;
esac
if [ ! -r "$hls/generated/$top.cpp" ]; then
    echo "run_hls.sh: lobe '$lobe' is not known: there is no generated/$top.cpp" >&2
    exit 2
fi
if [ ! -r "$vectors" ]; then
    echo "run_hls.sh: cannot read '$vectors': write it with \`glint vectors --format tv\`" >&2
    exit 2
fi
mkdir -p "$top"
cd "$top"

echo "C simulation"
"${CXX:-g++}" -std=c++14 -O1 -DGLINT_TOP="$top" "$hls/generated/$top.cpp" "$hls/testbench.cpp" -o testbench
./testbench "$top" "$vectors"

bambu=${BAMBU:-bambu}
if ! command -v "$bambu" >/dev/null; then
    echo "run_hls.sh: '$bambu' not found: set BAMBU to the program" >&2
    exit 2
fi

echo "Synthesis and cosimulation"
"$bambu" "$hls/generated/$top.cpp" --top-fname="$top" --std=c++14 -O2 \
    --pipelining="$top"=1 --generate-interface=INFER --reset-type=sync --reset-level=low \
    --device-name="${BAMBU_DEVICE:-xc7z020-1clg484-VVD}" --clock-period="${BAMBU_PERIOD:-10}" \
    --generate-tb="$hls/testbench.cpp" --tb-extra-gcc-options="-std=c++14 -DGLINT_TOP=$top" \
    --tb-arg="$top" --tb-arg="$vectors" --simulate --simulator=VERILATOR
test -s "$top.v"
