#!/bin/sh
# verilate.sh FOLDER PREFIX ARGUMENT...: runs Verilator with the arguments. FOLDER is then new, and holds the class PREFIX:
# PREFIX.h, and all its C++ in one file, PREFIX.all.inc.
set -eu
folder=$1 prefix=$2
shift 2
rm -rf "$folder"
verilator --cc --Mdir "$folder" --prefix "$prefix" --x-assign fast --x-initial unique --noassert -O3 "$@"
for file in "$folder"/*.cpp; do
    echo "#include \"${file##*/}\""
done > "$folder/$prefix.all.tmp"
mv "$folder/$prefix.all.tmp" "$folder/$prefix.all.inc"
