#!/bin/sh
# verilate.sh FOLDER PREFIX ARGUMENT...: runs Verilator with the arguments. FOLDER is then new, and holds the class PREFIX:
# PREFIX.h, and all its C++ in one file, PREFIX.all.inc, with a hash of the Verilog that it was made of.
set -eu
folder=$1 prefix=$2
shift 2
rm -rf "$folder"
verilator --cc --Mdir "$folder" --prefix "$prefix" --x-assign fast --x-initial unique --noassert -O3 "$@"
{
    for file in "$folder"/*.cpp; do
        echo "#include \"${file##*/}\""
    done
    hash=$(tr ' ' '\n' < "$folder/${prefix}__ver.d" | grep '\.v$' | xargs cat | sha256sum | cut -c1-16)
    echo "#define GLINT_VERILOG \"$hash\""
} > "$folder/$prefix.all.tmp"
mv "$folder/$prefix.all.tmp" "$folder/$prefix.all.inc"
