#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Are the pictures of two builds the same, to the byte? For changes that are to change none.
#
#   bash compare-pictures.sh OLD NEW FOLDER
#
# OLD and NEW are build folders. Draws scenes, projections, stereo models and techniques at 512x256
# with the widefov-render of both, and beside them what has shaders of its own: lines, points,
# bodies, fades, screens, skies. Writes FOLDER/old, FOLDER/new and FOLDER/different.txt; pictures
# that lie in FOLDER/old already are taken as they are. Exits with 1 where any picture differs.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
old=$1 new=$2 folder=$3
mkdir -p "$folder/old" "$folder/new"
folder=$(cd "$folder" && pwd)
displays=$here/../Examples/Displays

# A line a picture: its name, then its options.
list_pictures() {
  local scene view model technique
  for scene in cornell room globe; do
    for technique in auto exact; do
      for view in equirectangular hammer "azimuthal-equidistant --fov 180"; do
        for model in mono warped omnidirectional; do
          echo "$scene-${view%% *}-$model-$technique --scene $scene --technique $technique" \
            "--projection $view --stereo $model"
        done
      done
      for model in mono offaxis; do
        echo "$scene-perspective-$model-$technique --scene $scene --technique $technique" \
          "--projection perspective --hfov 90 --vfov 60 --stereo $model"
      done
    done
  done
  for model in mono warped omnidirectional; do
    echo "sky-$model --scene globe --sky ../sky.png --projection hammer --stereo $model"
    echo "gradient-$model --scene globe --zenith 0.1,0.2,0.5 --samples 0 --stereo $model"
  done
  local warped="--scene room --stereo warped"
  local around="--scene room --stereo omnidirectional --ipd 0.4"
  cat <<LIST
warped-lines $warped --representation wireframe --line-width 3
warped-points $warped --representation points --point-size 5
warped-samples $warped --samples 0 --iod 1 --offset 0.2
warped-log $warped --depth log
around-fade $around --pole-fade 40,70
around-fade-tilt $around --pole-fade 40,70 --tilt 30
around-fade-points $around --pole-fade 40,70 --representation points --point-size 5
around-lines $around --representation wireframe --line-width 3
around-points $around --representation points --point-size 5
around-balls $around --representation points --point-size 9 --points-as-spheres
around-tubes $around --representation wireframe --line-width 9 --lines-as-tubes
around-edges $around --representation surface-with-edges --samples 0
around-tiles $around --tile 100x100
atrium-mono --scene atrium
atrium-around --scene atrium --stereo omnidirectional
vectors-around --scene vector-cloud --stereo omnidirectional
vectors-mono --scene vector-cloud
flow-around --scene flow --stereo omnidirectional --technique auto
tubes-exact --scene room --technique exact --samples 0
tilted --scene cornell --projection hammer --tilt 40 --technique preclip
walls --scene room --screens $displays/wall.pvx --stereo offaxis
volume --scene room --screens $displays/headset.pvx --pose $displays/steps.txt --stereo warped
LIST
}

# $1: the folder of a build, $2: a folder for its pictures, $3: a name, then the options.
draw() {
  local build=$1 into=$2 name=$3
  shift 3
  compgen -G "$into/$name*.png" >/dev/null && return
  local eyes=()
  [[ " $* " == *" --stereo "* && " $* " != *" mono "* ]] && eyes=(--layout separate)
  (cd "$into" && LD_LIBRARY_PATH=$build/lib "$build/bin/widefov-render" --size 512x256 "$@" \
    ${eyes[@]+"${eyes[@]}"} -o "$name.png" >"$name.log" 2>&1) ||
    echo "$name: exit code $?, $(tail -1 "$into/$name.log")"
}

old=$(cd "$old" && pwd)
new=$(cd "$new" && pwd)
rm -f "$folder"/new/*
draw "$old" "$folder" sky --scene atrium # what skies show
list_pictures | while read -r name options; do
  # shellcheck disable=SC2086 # options are words
  for side in old new; do
    draw "${!side}" "$folder/$side" "$name" $options </dev/null
  done
done
diff -rq --exclude='*.log' "$folder/old" "$folder/new" >"$folder/different.txt" || true
echo "pictures: $(find "$folder/new" -name '*.png' | wc -l), different: $(wc -l <"$folder/different.txt")"
cat "$folder/different.txt"
[ ! -s "$folder/different.txt" ]
