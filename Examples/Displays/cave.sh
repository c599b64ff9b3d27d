#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A CAVE of four walls: three places of a head, both eyes, a file each in output/.
#
#   bash Examples/Displays/cave.sh [OPTION...]
#
# Options of widefov-render may name other data; the scene "atrium" without any.
# See Documentation/displays/cave.md.
source "$(dirname "${BASH_SOURCE[0]}")/render.bash"

render --screens Examples/Displays/cave.pvx --pose Examples/Displays/steps.txt \
  --stereo offaxis --layout separate --size 512x512 --output output/cave.png
ls output/cave-*.png
