#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A cylindrical screen of 240 degrees, and a desk with three monitors.
#
#   bash Examples/Displays/cylinder.sh [OPTION...]
#
# Options of widefov-render may name other data; the scene "atrium" without any.
# See Documentation/displays/cylinder.md.
source "$(dirname "${BASH_SOURCE[0]}")/render.bash"

cylinder=(--projection central-cylindrical --hfov 240 --vfov 50 --size 1796x400)
render "${cylinder[@]}" --output output/cylinder.png
render "${cylinder[@]}" --stereo omnidirectional --layout separate --output output/cylinder.png
render --screens Examples/Displays/wall.pvx --output output/wall.png
ls output/cylinder*.png output/wall-*.png
