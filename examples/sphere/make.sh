#!/usr/bin/env bash
# The lit sphere: its pictures by Verilator, its bitstreams by Yosys and nextpnr. README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."

fail() { echo "make.sh: $2" >&2; exit "$1"; }
usage() {
    cat <<'EOT'
Usage: examples/sphere/make.sh simulate BOARD [PICTURES]    golden model == Verilog; build/sphere/BOARD/sphereN.png
       examples/sphere/make.sh BOARD                        a bitstream: build/sphere/BOARD.bit or .bin
BOARD is ulx3s-85k, ulx3s-25k or icebreaker, PICTURES 1 to 1000, 8 by default.
GLINT_LIBRARY is the folder of libglint-c, build/clang/model as ./run leaves it. NEXTPNR and ECPPACK name the tools for the ECP5.
EOT
}

# sources BOARD [FAMILY]: Verilog for a board but its top module, products in blocks of the family.
sources() {
    local units blocks=rtl/blocks shading=small
    local multiplier=${2:+$blocks/glint_multiplier_sliced.v $blocks/$2/glint_multiplier_block.v $blocks/$2/glint_multiplier.v}
    [ "$1" != ulx3s-85k ] || shading=full
    [ $shading = full ] && units=effect_pixel_bps_p12 || units='decay_p8 effect_lambert_p8 effect_tint_p8'
    {
        for unit in $units; do sed -n 's|^$(GLINT_RTL)/|rtl/|p' "rtl/generated/glint_$unit.f"; done
        printf '%s\n' rtl/effects/glint_effect_highlight.v $blocks/glint_sqrt.v $blocks/glint_multiplier.v
        ls examples/sphere/sphere*.v examples/sphere/$shading/*.v "examples/sphere/${1%-*k}"/sphere*.v 2> /dev/null
    } | sort -u | sed "s|^$blocks/glint_multiplier.v|${multiplier:-&}|" | tr '\n' ' '
}

simulate() {
    local board=$1 pictures=$2 folder=build/sphere/$1 top=sphere_dvi parameters=() macros=-DSPHERE_DVI library
    case $board in
        ulx3s-85k) macros="$macros -DSPHERE_FULL" ;;
        icebreaker) top=sphere parameters=(-GBITS=4) macros= ;;
    esac
    library=$(realpath -q "${GLINT_LIBRARY:-build/clang/model}") && [ -e "$library/libglint-c.so" ] ||
        fail 1 "there is no libglint-c.so in ${GLINT_LIBRARY:-build/clang/model}: ./run builds it, or set GLINT_LIBRARY"
    rm -rf "$folder" && mkdir -p "$folder"
    verilator --cc --exe --build -j 1 -Wall -O3 --x-assign unique --x-initial unique --Mdir "$folder/verilated" --prefix Vtop \
        --top-module "$top" "${parameters[@]}" $(sources "$board") "$PWD"/examples/sphere/{bench,golden}.cpp -o bench \
        -CFLAGS "-std=c++20 -O2 -Wall -Wextra $macros -I$PWD/model/include" \
        -LDFLAGS "-L$library -lglint-c -lpng -Wl,-rpath,$library" > "$folder/log" 2>&1 ||
        { tail -20 "$folder/log" >&2; fail 1 "Verilator failed; the whole log is $folder/log"; }
    "$folder/verilated/bench" "$pictures" "$folder"
}

# report LOG: what of the device is used, and the clocks after routing; the whole log where nextpnr ends with an error.
report() {
    sed -En 's/^Info:\s+((TRELLIS_(COMB|FF)|MULT18X18D|DP16KD|ICESTORM_(LC|DSP|RAM)): .*)/\1/p' "$1" | sort -u
    tac "$1" | sed -n "s/^Info: \(Max frequency for clock\) *'\([^']*\)'/\1 \2/p" | sort -u -k5,5
}

# tool NAME: itself, or the one of the Python registry, on the PATH or where scripts/router.sh puts it.
tool() {
    PATH=$PATH:$PWD/build/venv/bin command -v "$1" || PATH=$PATH:$PWD/build/venv/bin command -v "yowasp-$1" ||
        fail 1 "there is no $1: scripts/router.sh installs it with nextpnr (Debian 13: packages nextpnr-ecp5, fpga-trellis)"
}

ulx3s() {
    local device=$1 family= option= nextpnr ecppack out=build/sphere/ulx3s-$1
    nextpnr=${NEXTPNR:-$(tool nextpnr-ecp5)}
    ecppack=${ECPPACK:-$(tool ecppack)}
    # Of the 28 multiplier blocks of the 25F only those products get one that ask for it; the 85F has enough for all.
    [ "$device" = 85k ] || { family=ecp5 option=-nodsp; }
    mkdir -p build/sphere && rm -f "$out.bit"
    yosys -q -l "$out.yosys" -p "read_verilog $(sources "ulx3s-$1" $family) examples/sphere/ulx3s/ulx3s.v; synth_ecp5 $option -top ulx3s -json $out.json"
    "$nextpnr" "--$device" --package CABGA381 --speed 6 --json "$out.json" --lpf examples/sphere/ulx3s/ulx3s.lpf --textcfg "$out.config" \
        > "$out.log" 2>&1 || { report "$out.log"; fail 1 "nextpnr failed; its log is $out.log"; }
    "$ecppack" --compress "$out.config" "$out.bit"
    report "$out.log"
    echo "$out.bit"
}

icebreaker() {
    local out=build/sphere/icebreaker
    mkdir -p build/sphere && rm -f "$out.bin"
    yosys -q -l "$out.yosys" -p "read_verilog $(sources icebreaker up5k) examples/sphere/icebreaker/icebreaker.v; synth_ice40 -top icebreaker -json $out.json"
    nextpnr-ice40 --up5k --package sg48 --freq 25.125 --json "$out.json" --pcf examples/sphere/icebreaker/icebreaker.pcf --asc "$out.asc" \
        > "$out.log" 2>&1 || { report "$out.log"; fail 1 "nextpnr failed; its log is $out.log"; }
    icepack "$out.asc" "$out.bin"
    report "$out.log"
    echo "$out.bin"
}

case "${1:-} ${2:-}" in
    "-h " | "--help ") usage ;;
    "simulate ulx3s-85k" | "simulate ulx3s-25k" | "simulate icebreaker")
        [ $# -le 3 ] || fail 2 "argument '$4' is not legal; --help says what is"
        simulate "$2" "${3:-8}"
        ;;
    "ulx3s-25k " | "ulx3s-85k ") ulx3s "${1#ulx3s-}" ;;
    "icebreaker ") icebreaker ;;
    *) fail 2 "arguments '$*' are not legal; --help says what is" ;;
esac
