#!/usr/bin/env python3
"""Every HLS kernel, compiled with every kind of integers and form of the divider that is to be had here, on a million vectors a profile.

    types_test.py GLINT [--count N] [VARIANT ...]       e.g. types_test.py build/release/glint ap:g++ ubsan:clang++

The vendors' types come from the Python package hls4ml, whose release is pinned below; where the registry is not reached,
one line says so and the other variants are run. Exit status: 0 no mismatch, 1 a mismatch or a warning, 2 a variant that
is not known.
"""

import argparse
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

HLS = Path(__file__).resolve().parents[2] / "hls"
HLS4ML = "hls4ml==1.3.0"
PROFILES = ("p8", "p12", "p16")
WARNINGS = ("-Wall", "-Wextra", "-Wconversion", "-Werror")
VENDORS = {"ap": "GLINT_INT_AP", "ac": "GLINT_INT_AC"}
FORMS = ("adding", "radix4", "reciprocal")  # of the divider
VARIANTS = ("m32:g++", "ubsan:g++", "ubsan:clang++", "bitint:clang++", "bitint-ubsan:clang++", "ap:g++", "ap:clang++",
            "ac:g++", "ac:clang++", *(f"{form}:g++" for form in FORMS))


def vendor_headers(folder):
    """The folders of the vendors' headers, or nothing where the registry is not reached."""
    done = subprocess.run([sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "-d", folder, HLS4ML],
                          capture_output=True, text=True)
    wheels = list(folder.glob("*.whl"))
    if done.returncode != 0 or not wheels:
        print(f"the vendors' types are left out: {HLS4ML} is not to be had from the Python registry")
        return None
    with zipfile.ZipFile(wheels[0]) as wheel:
        wheel.extractall(folder)
    return {kind: next(path.parent for path in folder.rglob(f"{kind}_int.h")) for kind in VENDORS}


def flags(variant, headers):
    """The compiler and its options, or nothing where the vendors' headers are not to be had."""
    kind, compiler = variant.split(":")
    options = []
    if "ubsan" in kind:
        options += ["-fsanitize=undefined", "-fno-sanitize-recover=all"]
    if "bitint" in kind:
        options += ["-DGLINT_INT_BITINT"]
    if kind in FORMS:
        options += [f"-DGLINT_DIVIDE_{kind.upper()}"]
    if kind == "m32":
        options += ["-m32"]
    if kind in VENDORS:
        if headers is None:
            return None
        options += [f"-D{VENDORS[kind]}", "-isystem", str(headers[kind])]
        if (kind, compiler) == ("ap", "g++"):  # its constructors read the bits that they set next
            options += ["-Wno-uninitialized", "-Wno-maybe-uninitialized"]
    return [compiler, *options]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("glint")
    parser.add_argument("--count", type=int, default=1_000_000, help="vectors of a kernel at a profile")
    parser.add_argument("variants", nargs="*", metavar="VARIANT", help=f"of {', '.join(VARIANTS)}; none: all")
    options = parser.parse_intermixed_args()
    for variant in options.variants:
        if variant not in VARIANTS:
            parser.error(f"variant '{variant}' is not known: {', '.join(VARIANTS)}")
    variants = options.variants or VARIANTS
    kernels = sorted(path.stem[len("glint_"):-len("_p12")] for path in HLS.glob("generated/*_p12.cpp"))
    runs = failures = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        wanted = any(variant.split(":")[0] in VENDORS for variant in variants)
        headers = vendor_headers(folder) if wanted else None
        for kernel in kernels:
            unit, name = ("effect", kernel[len("effect_"):]) if kernel.startswith("effect_") else ("lobe", kernel)
            subprocess.run([options.glint, "vectors", f"--{unit}", name, "--profile", ",".join(PROFILES), "--count",
                            str(options.count), "-o", folder], check=True, stdout=subprocess.DEVNULL)
            tops = [f"glint_{kernel}_{profile}" for profile in PROFILES]
            for variant in variants:
                command = flags(variant, headers)
                if command is None:
                    continue
                command += ["-std=c++14", "-O1", *WARNINGS, f"-DGLINT_TOPS(X)={' '.join(f'X({top})' for top in tops)}"]
                for top in tops:
                    command += ["-include", str(HLS / f"generated/{top}_constants.hpp")]
                command += [str(HLS / f"generated/{top}.cpp") for top in tops]
                bench = folder / "bench"
                done = subprocess.run([*command, str(HLS / "testbench.cpp"), "-o", bench], capture_output=True, text=True)
                for top in tops if done.returncode == 0 else []:
                    done = subprocess.run([bench, top, folder / f"{top}.tv"], capture_output=True, text=True)
                    print(f"{variant}: {done.stdout}", end="", flush=True)
                    failures += done.returncode != 0
                    runs += 1
                if done.returncode != 0:
                    print(f"FAILED: {variant}, {kernel}:\n{done.stderr}")
                    failures += 1
            for top in tops:
                (folder / f"{top}.tv").unlink()
    print(f"{runs} runs of {options.count} vectors, {failures} failed")
    return 1 if failures or runs == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
