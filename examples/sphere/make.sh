#!/usr/bin/env bash
# The lit sphere: its pictures by Verilator, its bitstreams by Yosys and nextpnr. README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() { echo "make.sh: $2" >&2; exit "$1"; }
usage() {
    cat <<'EOT'
Usage: examples/sphere/make.sh simulate ulx3s|icebreaker [PICTURES]    golden model == Verilog; build/sphere/BOARD/sphereN.png
       examples/sphere/make.sh ulx3s [25k|85k]                         build/sphere/ulx3s-25k.bit
       examples/sphere/make.sh icebreaker                              build/sphere/icebreaker.bin
GLINT_LIBRARY is the folder of libglint-c, build/clang/model as ./run leaves it. NEXTPNR and ECPPACK name the tools for the ECP5.
EOT
}

# sources [FAMILY]: Verilog of the units, and of the blocks that the sphere takes directly; products in blocks of the family.
sources() {
    local family=${1:+rtl/blocks/glint_multiplier_sliced.v rtl/blocks/$1/glint_multiplier_block.v rtl/blocks/$1/glint_multiplier.v}
    {
        sed -n 's|^$(GLINT_RTL)/|rtl/|p' rtl/generated/glint_{decay,effect_lambert,effect_tint}_p8.f
        echo rtl/effects/glint_effect_highlight.v rtl/blocks/glint_sqrt.v
    } | sort -u | sed "s|^rtl/blocks/glint_multiplier.v|${family:-&}|" | tr '\n' ' '
}
sphere=$(echo examples/sphere/sphere{,_beam,_checker,_material,_pixel,_product,_turn}.v)
dvi=$(echo examples/sphere/sphere_{dvi,tmds}.v)

simulate() {
    local board=$1 pictures=$2 top=sphere_dvi macro=-DSPHERE_DVI parameters=() library folder=build/sphere/$1
    [ "$board" = ulx3s ] || { top=sphere macro= parameters=(-GBITS=4) dvi=; }
    library=$(realpath -q "${GLINT_LIBRARY:-build/clang/model}") && [ -e "$library/libglint-c.so" ] ||
        fail 1 "there is no libglint-c.so in ${GLINT_LIBRARY:-build/clang/model}: ./run builds it, or set GLINT_LIBRARY"
    rm -rf "$folder" && mkdir -p "$folder"
    verilator --cc --exe --build -j 1 -Wall -O3 --x-assign unique --x-initial unique --Mdir "$folder/verilated" --prefix Vtop \
        --top-module "$top" "${parameters[@]}" $(sources) $sphere $dvi "$PWD"/examples/sphere/{bench,golden}.cpp -o bench \
        -CFLAGS "-std=c++20 -O2 -Wall -Wextra $macro -I$PWD/model/include" \
        -LDFLAGS "-L$library -lglint-c -lpng -Wl,-rpath,$library" > "$folder/log" 2>&1 ||
        { tail -20 "$folder/log" >&2; fail 1 "Verilator failed; the whole log is $folder/log"; }
    "$folder/verilated/bench" "$pictures" "$folder"
}

# report LOG: what of the device is used, and the clocks after routing; the whole log where nextpnr ends with an error.
report() {
    sed -En 's/^Info:\s+((TRELLIS_(COMB|FF)|MULT18X18D|DP16KD|ICESTORM_(LC|DSP|RAM)): .*)/\1/p' "$1" | sort -u
    tac "$1" | sed -n "s/^Info: \(Max frequency for clock\) *'\([^']*\)'/\1 \2/p" | sort -u -k5,5
}

# tool NAME: itself, or the one of the Python registry, on the PATH or where scripts/ecp5.sh puts it.
tool() {
    PATH=$PATH:$PWD/build/venv/bin command -v "$1" || PATH=$PATH:$PWD/build/venv/bin command -v "yowasp-$1" ||
        fail 1 "there is no $1: scripts/ecp5.sh installs it with nextpnr (Debian 13: packages nextpnr-ecp5, fpga-trellis)"
}

ulx3s() {
    local device=$1 nextpnr ecppack out=build/sphere/ulx3s-$1
    nextpnr=${NEXTPNR:-$(tool nextpnr-ecp5)}
    ecppack=${ECPPACK:-$(tool ecppack)}
    mkdir -p build/sphere && rm -f "$out.bit"
    yosys -q -l "$out.yosys" -p "read_verilog $(sources ecp5) $sphere $dvi examples/sphere/ulx3s.v; synth_ecp5 -nodsp -top ulx3s -json $out.json"
    "$nextpnr" "--$device" --package CABGA381 --speed 6 --json "$out.json" --lpf examples/sphere/ulx3s.lpf --textcfg "$out.config" \
        > "$out.log" 2>&1 || { report "$out.log"; fail 1 "nextpnr failed; its log is $out.log"; }
    "$ecppack" --compress "$out.config" "$out.bit"
    report "$out.log"
    echo "$out.bit"
}

icebreaker() {
    local out=build/sphere/icebreaker
    mkdir -p build/sphere && rm -f "$out.bin"
    yosys -q -l "$out.yosys" -p "read_verilog $(sources up5k) $sphere examples/sphere/icebreaker.v; synth_ice40 -top icebreaker -json $out.json"
    nextpnr-ice40 --up5k --package sg48 --freq 25.125 --json "$out.json" --pcf examples/sphere/icebreaker.pcf --asc "$out.asc" \
        > "$out.log" 2>&1 || { report "$out.log"; fail 1 "nextpnr failed; its log is $out.log"; }
    icepack "$out.asc" "$out.bin"
    report "$out.log"
    echo "$out.bin"
}

case "${1:-} ${2:-} ${3:-}" in
    "-h  " | "--help  ") usage ;;
    "simulate ulx3s "* | "simulate icebreaker "*) [ $# -le 3 ] || fail 2 "too many arguments; --help says what is legal"; simulate "$2" "${3:-8}" ;;
    "ulx3s  " | "ulx3s 25k " | "ulx3s 85k ") ulx3s "${2:-25k}" ;;
    "icebreaker  ") icebreaker ;;
    *) fail 2 "arguments '$*' are not legal; --help says what is" ;;
esac
