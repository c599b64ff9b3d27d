#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A headset: three turns of the head, and the whole sphere for players that turn it.
#
#   bash Examples/Displays/headset.sh [OPTION...]
#
# Options of widefov-render may name other data; the scene "atrium" without any.
# See Documentation/displays/headset.md.
source "$(dirname "${BASH_SOURCE[0]}")/render.bash"

render --screens Examples/Displays/headset.pvx --pose Examples/Displays/turns.txt \
  --stereo offaxis --layout side-by-side --output output/headset.png
render --stereo omnidirectional --layout top-bottom --size 2048x1024 --output output/sphere.png
ls output/headset-*.png output/sphere.png
