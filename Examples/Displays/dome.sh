#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A dome: its master for one projector, and for each eye of viewers who may look around.
#
#   bash Examples/Displays/dome.sh [OPTION...]
#
# Options of widefov-render may name other data; the scene "atrium" without any.
# See Documentation/displays/dome.md.
source "$(dirname "${BASH_SOURCE[0]}")/render.bash"

dome=(--projection azimuthal-equidistant --fov 180 --tilt 75 --size 1024x1024)
render "${dome[@]}" --output output/dome.png
render "${dome[@]}" --stereo omnidirectional --pole-fade 60,85 --layout separate \
  --output output/dome.png
ls output/dome*.png
