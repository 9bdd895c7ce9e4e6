#!/usr/bin/env bash
# Makes slides-notes/scenes.jpg, the contact sheet: every scene as it asks to be rendered, in a few minutes.
#   slides-notes/scenes.sh [FOLDER_OF_luch]      default: build/release
# Needs oiiotool (openimageio-tools) and the font DejaVu Sans.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/.."
luch=${1:-build/release}/luch
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tiles=()
for scene in scenes/*/*.scene; do
    name=$(basename "$scene" .scene)
    "$luch" render "$scene" -o "$work/$name.png"
    oiiotool "$work/$name.png" --ch R,G,B --fit:pad=1 320x240 --crop 320x262+0+0 --fullpixels \
        --text:x=8:y=256:size=15:font=DejaVuSans:color=1,1,1 "$name" -o "$work/$name-tile.png"
    tiles+=("$work/$name-tile.png")
done
oiiotool "${tiles[@]}" --mosaic:pad=4 5x$(((${#tiles[@]} + 4) / 5)) \
    --eraseattrib '.*' --nosoftwareattrib --compression jpeg:88 -o slides-notes/scenes.jpg
