#!/bin/sh
# emit.sh GLINT FOLDER ARGUMENT...: `glint emit` of Verilog into FOLDER, which touches only what changes.
set -eu
glint=$1 folder=$2
shift 2
"$glint" emit "$@" --target verilog -o "$folder.new" > /dev/null
mkdir -p "$folder"
for file in "$folder.new"/*; do
    cmp -s "$file" "$folder/${file##*/}" || mv "$file" "$folder"
done
rm -rf "$folder.new"
