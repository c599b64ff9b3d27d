#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The Debian packages in a suite of Debian: makes them there, installs them in a bare root of the
# suite, draws a picture and a film, imports the Python module, builds a program and loads the plugin
# into ParaView.
#
#   bash Testing/packages.sh SUITE            bookworm, trixie or forky
#   bash Testing/packages.sh --make FOLDER    the first half, here: builds, and packages into FOLDER
#   bash Testing/packages.sh --use FOLDER     the second, here: installs what FOLDER has, and uses it
#
# The roots are those of Testing/elsewhere.sh; the packages stay in build-roots/SUITE/srv/output/packages.
#
# Exit code: 0 when all of it worked.
set -euo pipefail
exec < /dev/null
cd "$(dirname "${BASH_SOURCE[0]}")/.."

step="reading the command line"
trap 'code=$?; [ "$code" -eq 0 ] || echo "Testing/packages.sh: FAILED while $step (exit code $code)" >&2' EXIT

make() {
  step="building"
  cmake --preset default -DWIDEFOV_BUILD_TESTING=OFF -DWIDEFOV_BUILD_PROGRAMS=ON \
    -DWIDEFOV_WRAP_PYTHON=ON -DCMAKE_UNITY_BUILD=ON
  cmake --build build
  step="building the plugin"
  cmake --preset paraview -DWIDEFOV_BUILD_TESTING=OFF
  cmake --build build-paraview
  step="fetching the viewer of web pages"
  bash Utilities/fetch-viewer.sh build
  step="making packages"
  rm -rf "$1"
  bash Utilities/package.sh build "$1"
  bash Utilities/package.sh build-paraview "$1"
}

# install PACKAGE...: as users do, but without what is recommended
install() {
  step="installing ${*##*/}"
  echo "$step"
  DEBIAN_FRONTEND=noninteractive apt-get -q -q -y -o Dpkg::Use-Pty=0 install \
    --no-install-recommends "$@" > "$work/log" 2>&1 || {
    tail -n 20 "$work/log"
    return 1
  }
}

# holds FILE BYTES: it has so many at least, which a picture of nothing has not
holds() {
  local bytes
  bytes="$(stat --format=%s "$1")"
  echo "$(basename "$1"): $bytes bytes"
  [ "$bytes" -ge "$2" ]
}

use_programs() {
  install "$packages"/libwidefov0.1_*.deb "$packages"/widefov_*.deb xvfb xauth libgl1-mesa-dri ffmpeg
  step="drawing a picture"
  bash Utilities/with-display.sh widefov-render --scene atrium --size 256x128 -o "$work/atrium.png"
  holds "$work/atrium.png" 10000
  step="drawing a film"
  bash Utilities/with-display.sh widefov-render --scene room --film turn --seconds 0.2 --size 256x128 --quiet \
    -o "$work/film.mp4"
  ffprobe -v error -show_streams "$work/film.mp4" | grep '^projection=equirectangular$'
  step="making a web page"
  bash Utilities/with-display.sh widefov-render --scene room --size 256x128 --web "$work/page"
  holds "$work/page/viewer.js" 100000
  step="asking the other programs"
  widefov-viewer --version
  widefov-run --help > "$work/help"
  holds "$work/help" 500
}

use_python() {
  install "$packages"/python3-widefov_*.deb
  step="using the Python module"
  bash Utilities/with-display.sh python3 -B Testing/Install/test_install.py python "$work/python" ""
}

use_headers() {
  install "$packages"/libwidefov-dev_*.deb g++ cmake ninja-build
  step="building a program"
  bash Utilities/with-display.sh python3 -B Testing/Install/test_install.py cxx "$work/cxx" /usr cmake -G Ninja
}

# Where its packages and those of VTK exclude each other, apt takes away the latter.
use_plugin() {
  install "$packages"/paraview-widefov_*.deb python3-paraview
  step="loading the plugin"
  bash Utilities/with-display.sh pvpython Examples/ParaView/panorama.py \
    "$(dpkg --listfiles paraview-widefov | grep '/WideFoV\.so$')" "$work/paraview"
  holds "$work/paraview/panorama.png" 100000
  holds "$work/paraview/dome.png" 100000
}

use() {
  packages="$(realpath "$1")"
  work="$(mktemp --directory)"
  trap 'code=$?; rm -rf "$work"
    [ "$code" -eq 0 ] || echo "Testing/packages.sh: FAILED while $step (exit code $code)" >&2' EXIT
  step="reading the lists of packages"
  apt-get -q -q update
  use_programs
  use_python
  use_headers
  use_plugin
}

in_suite() {
  local epoch
  step="reading the time of the commit"
  epoch="${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}"
  step="making packages in $1"
  bash Testing/elsewhere.sh --prepare "$1"
  bash Testing/elsewhere.sh --in "$1" env SOURCE_DATE_EPOCH="$epoch" \
    bash Testing/packages.sh --make output/packages
  step="using packages in $1"
  bash Testing/elsewhere.sh --bare "$1" \
    bash Testing/packages.sh --use "build-roots/$1/srv/output/packages"
  echo "Testing/packages.sh: $1: made, installed and used"
}

case "${1:-}" in
  --make | --use) [ "$#" -eq 2 ] && "${1#--}" "$2" ;;
  *) [ "$#" -eq 1 ] && in_suite "$1" ;;
esac
