# shellcheck shell=bash
# What ./run and ./test share: packages, builds. To be sourced, from the project's root.

# usage ARGUMENTS... <TEXT: prints the text for --help; refuses any other argument.
usage() {
    local text
    text=$(cat)
    [ $# -eq 0 ] && return
    case $1 in
        -h | --help) echo "$text"; exit 0 ;;
        *) echo "$(basename "$0"): argument '$1' is not legal; --help says what is" >&2; exit 2 ;;
    esac
}

# need PACKAGE TEST...: notes a package when the test command fails.
missing=()
need() {
    local package=$1
    shift
    "$@" > /dev/null 2>&1 || missing+=("$package")
}

command_there() { command -v "$1"; }
# file_there PATTERN...: one of the patterns names a file.
file_there() { compgen -G "$1" || { [ $# -gt 1 ] && shift && file_there "$@"; }; }

# install_missing run|test: what the main job, or also the tests, need; through the system's package manager.
install_missing() {
    need cmake command_there cmake
    need ninja-build command_there ninja
    need g++ command_there g++
    need clang command_there clang++
    need verilator command_there verilator
    need gnuplot-nox command_there gnuplot
    need libfmt-dev file_there '/usr/include/fmt/core.h'
    need libcli11-dev file_there '/usr/include/CLI/CLI.hpp'
    need nlohmann-json3-dev file_there '/usr/include/nlohmann/json.hpp'
    need libglpk-dev file_there '/usr/include/glpk.h'
    need zlib1g-dev file_there '/usr/include/zlib.h'
    need libembree-dev file_there '/usr/include/embree4/rtcore.h' '/usr/include/embree3/rtcore.h'
    need libpng-dev file_there '/usr/include/png.h'
    need libstb-dev file_there '/usr/include/stb/stb_easy_font.h'
    need gappa command_there gappa
    need python3 command_there python3
    need python3-jinja2 file_there '/usr/lib/python3/dist-packages/jinja2/__init__.py'
    need python3-plotly file_there '/usr/lib/python3/dist-packages/plotly/__init__.py'
    need esbuild command_there esbuild
    if [ "$1" = test ]; then
        need catch2 file_there '/usr/include/catch2/catch*.hpp'
        need libclang-rt-dev file_there '/usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.asan-*.a'
        need make command_there make
        need parallel command_there parallel
        need valgrind command_there valgrind
        need libbenchmark-dev file_there '/usr/include/benchmark/benchmark.h'
        need iverilog command_there iverilog
        need ghdl command_there ghdl
        need yosys command_there yosys
        need yosys-dev file_there '/usr/share/yosys/include/backends/cxxrtl'  # the headers of CXXRTL
        need nextpnr-ice40 command_there nextpnr-ice40
        need fpga-icestorm command_there icepack
        need z3 command_there z3
        need sollya command_there sollya
        need libsystemc-dev file_there '/usr/include/systemc'
        need tcl command_there tclsh
        need clang-format command_there clang-format
        # Ubuntu has a snap for it: the test of the page in a browser is left out there.
        ! grep -qx 'ID=debian' /etc/os-release || need chromium command_there chromium
        need assimp-testmodels file_there '/usr/share/assimp/models/OBJ/spider.obj'
        # 32-bit headers for the check of the HLS kernel's object file; there is no such package but on x86-64.
        [ "$(uname -m)" != x86_64 ] || need g++-multilib file_there '/usr/lib/gcc/x86_64-linux-gnu/*/32/libgcc.a'
    fi
    [ ${#missing[@]} -eq 0 ] && return

    echo "== installing: ${missing[*]}"
    local root=()
    [ "$(id -u)" -eq 0 ] || root=(sudo)
    if ! command -v apt-get > /dev/null || { [ ${#root[@]} -gt 0 ] && ! command -v sudo > /dev/null; }; then
        echo "$(basename "$0"): cannot install (needs apt-get, and root or sudo); missing are the packages: ${missing[*]}" >&2
        exit 1
    fi
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
    if ! "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null; then
        echo "$(basename "$0"): the package manager could not install: ${missing[*]}" >&2
        exit 1
    fi
}

# build PRESET [TARGETS...]: configures and builds; the log is shown only when it fails.
build() {
    local preset=$1 log
    shift
    mkdir -p build
    log=build/$preset.log
    if command -v ccache > /dev/null; then  # also of another clone, but for what has its headers read once
        export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 \
            CCACHE_SLOPPINESS=pch_defines,time_macros
    fi
    echo "== building: $preset (log: $log)"
    if ! { cmake --preset "$preset" && cmake --build --preset "$preset" ${1:+--target "$@"}; } > "$log" 2>&1; then
        grep -E 'error|Error|FAILED' "$log" | head -20 >&2 || true
        echo "$(basename "$0"): the build failed; the whole log is $log" >&2
        exit 1
    fi
    grep -E '^-- .*: OFF' "$log" || true  # parts that are left out, and why
}
