#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The pictures of Examples/run.sh, which calls this: needs build/bin/widefov-render and
# a display, writes output/*.jpg and lists them.
#
#   Examples/render-pictures.sh [FILE]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

office=../shared/data/office.binary.vtk
pictures=()

# render NAME OPTION...: one picture, output/NAME.jpg
render() {
  local picture="output/$1.jpg"
  shift
  echo "Rendering $picture"
  build/bin/widefov-render "$@" --output "$picture"
  pictures+=("$PWD/$picture")
}

# render_all NAME OPTION...: what the options show, in the three projections. The dome
# leans 15 degrees forward: its middle is 75 degrees above the direction of view.
render_all() {
  local name="$1"
  shift
  render "$name-equirectangular" "$@" --projection equirectangular --size "$map_size"
  render "$name-hammer" "$@" --projection hammer --size "$map_size"
  render "$name-dome" "$@" --projection azimuthal-equidistant --fov 180 --tilt 75 --size 1024x1024
}

mkdir -p output
map_size=2048x1024
render_all winds --scene winds
if [ -f "$office" ]; then
  map_size=1024x512
  # inside the room, between desk and window; up is +z in these data
  render_all office "$office" --streamlines vectors --vectors vectors --no-surface --eye 2,2.2,1.4 \
    --direction 1,0,0 --up 0,0,1 --range 0,0.25 --colormap rainbow --scalar-bar
fi
protein=../shared/data/2LYZ.pdb
if [ -f "$protein" ]; then
  # the eye among the atoms of a lysozyme molecule
  render protein-dome "$protein" --projection azimuthal-equidistant --fov 180 --tilt 30 \
    --size 1024x1024
  render protein-equirectangular "$protein" --projection equirectangular --size 1024x512
fi
if [ "$#" -gt 0 ]; then
  name="$(basename "$1")"
  map_size=2048x1024
  render_all "${name%.*}" "$1"
fi

echo
echo "Pictures:"
printf '  %s\n' "${pictures[@]}"
