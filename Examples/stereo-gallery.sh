#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The pictures of Documentation/stereo-gallery.md: needs build/bin/widefov-render and a display,
# and writes them to the folder that is named, or to output/.
#
#   Examples/stereo-gallery.sh [FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder="${1:-output}"
mkdir -p "$folder"

# picture NAME OPTION...: one anaglyph
picture() {
  local name="$folder/gallery-$1.jpg"
  shift
  echo "Rendering $name"
  build/bin/widefov-render --scene atrium --samples 0 "$@" --output "$name"
}

warped=(--stereo warped --clip 1,30 --iod 0.4 --offset -0.6)
exact=(--stereo omnidirectional --ipd 0.25)
above=(--eye 0,5,0 --direction 0,-1,0 --up 0,0,-1)

picture hammer-warped "${warped[@]}" --projection hammer --size 1024x512
picture hammer-omnidirectional "${exact[@]}" --projection hammer --size 1024x512
picture fov-120 "${warped[@]}" --hfov 120 --vfov 60 --size 768x384
picture fov-180 "${warped[@]}" --hfov 180 --vfov 90 --size 768x384
picture fov-360 "${warped[@]}" --hfov 360 --vfov 180 --size 768x384
picture above-warped "${warped[@]}" "${above[@]}" --size 1024x512
picture above-omnidirectional "${exact[@]}" "${above[@]}" --size 1024x512
picture offaxis --stereo offaxis --projection perspective --hfov 80 --separation 0.03 \
  --convergence auto --letterbox 0.06 --size 768x432
