#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Packs the programs of a build with every library they need but the C library and the OpenGL
# driver, for machines without VTK: unpack, and run ./widefov-render, ./widefov-bench, ...
#
#   bash Utilities/bundle.sh [BUILD FOLDER [FILE.tar.xz]]
#   bash Utilities/bundle.sh --unpacked FOLDER [BUILD FOLDER]     the same as a folder, not packed
#   bash Utilities/bundle.sh --films ...                          with the programs ffmpeg and ffprobe
#
# By default of build/, into build/widefov-VERSION-x86_64.tar.xz, or widefov-films-VERSION-... It runs
# where the C library is not older than here: made on Debian 12, with glibc 2.36 and later. Packages
# that this needs are installed where they are missing; packing takes three minutes of one processor.
# Bundled is:
#
#   widefov-*        one launcher under the names of the programs (Utilities/launch.sh)
#   bin/ lib/        the programs, and libraries that nothing else on a machine shares with them
#   lib/machine/     libraries that the driver uses as well, each in a folder of its own; used
#                    where the machine has none
#   data/ licences/  of the scenes "winds" and "office", of web pages; of all that is packed
#   ffmpeg/          with --films: ffmpeg, ffprobe, their libraries and licences (bundle-ffmpeg.sh)
#   check.sh         Testing/Gpu/check.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

programs=(widefov-render widefov-viewer widefov-bench widefov-stress widefov-compare-tests
  widefov-gpu-tests)
# The machine's own, where it has them: what its driver uses as well.
machine='/lib(GL|GLX|EGL|OpenGL|GLdispatch|stdc\+\+|gcc_s|X11|X11-xcb|xcb[a-z0-9-]*|Xau|Xdmcp|bsd|md|z|zstd|expat|ffi)\.so'
# OpenImageIO is linked with these for formats that no program reads or writes: films, OpenVDB,
# HEIF, cameras. They and theirs are two thirds of all. Stand-ins are packed instead.
unused='/lib(opencv_[a-z]*|avcodec|avformat|avutil|swscale|heif|openvdb)\.so'
# What is loaded by name alone: by NVIDIA's driver, and by the windows of the viewer.
by_name=(libXext.so.6 libXrandr.so.2 libXinerama.so.1 libXcursor.so.1 libXi.so.6 libXxf86vm.so.1)
# Compiled into the programs, and the data.
compiled_in=(libcli11-dev nlohmann-json3-dev libglm-dev libgtest-dev libboost-dev librapidcheck-dev
  libimgui-dev ferret-datasets)

fail() {
  echo "bundle.sh: $1" >&2
  exit 1
}

# shellcheck source=Utilities/bundle-parts.sh
. Utilities/bundle-parts.sh

check() {
  local program
  [ "$(uname -m)" = x86_64 ] || fail "bundles are made for x86-64 alone, not for $(uname -m)"
  for program in "${programs[@]}"; do
    [ -x "$build/bin/$program" ] || fail "no program $build/bin/$program; build first: cmake --build $build"
  done
  bash Utilities/install-packages.sh bundle
}

# Stand-ins for what OpenImageIO never calls here, in $stand_ins.
make_stand_ins() {
  local image library
  image="$(ldd "$build/bin/widefov-render" | awk '/libOpenImageIO\.so/ { print $3 }')"
  [ -n "$image" ] || return 0
  needed_by "$image" > "$work/needed"
  ldd "$image" | awk '$3 ~ /^\// { print $1, $3 }' | grep -E "$unused" |
    while read -r library path; do
      ! grep -qFx "$library" "$work/needed" || bash Utilities/stand-in.sh "$path" "$stand_ins" "$image"
    done
}

# Each library that the programs load, as a path; stand-ins in the place of what they stand for.
list_libraries() {
  local name path
  LD_LIBRARY_PATH="$stand_ins" ldd -r "${programs[@]/#/$build/bin/}" > "$work/ldd" 2>&1 || true
  ! grep -E 'not found|undefined symbol' "$work/ldd" >&2 || fail "the libraries do not fit, see above"
  awk '$3 ~ /^\// { print $3 }' "$work/ldd"
  for name in "${by_name[@]}"; do
    # (awk reads to the end: who writes to a pipe that is closed fails)
    path="$(/sbin/ldconfig -p | awk -v name="$name" '$1 == name && /x86-64/ && !n++ { print $NF }')"
    [ -n "$path" ] || fail "$name is missing; install the packages of the group bundle in Utilities/packages.txt"
    ldd "$path" | awk -v self="$path" 'BEGIN { print self } $3 ~ /^\// { print $3 }'
  done
}

copy_libraries() {
  local library name package
  list_libraries > "$work/libraries"
  sort -u "$work/libraries" | grep -vE "$own" | while read -r library; do
    name="$(basename "$library")"
    if grep -qE "$machine" <<< "$library"; then
      mkdir -p "$folder/lib/machine/$name"
      cp --dereference "$library" "$folder/lib/machine/$name/"
    else
      cp --dereference "$library" "$folder/lib/"
    fi
    case "$library" in
      "$stand_ins"/* | "$(realpath "$build")"/*) ;;
      *)
        package="$(package_of "$library")"
        add_licence "${package:-$name}"
        ;;
    esac
  done
}

# The viewer of web pages.
copy_viewer() {
  ! command -v npm > /dev/null || bash Utilities/fetch-viewer.sh "$build"
  if [ -d "$build/share/widefov/web" ]; then
    cp --recursive "$build/share/widefov/web" "$folder/data/"
    rm -f "$folder"/data/web/{made-of,emulator.js}
    cp "$build/share/widefov/web/licences.txt" "$folder/licences/web"
  else
    echo "bundle.sh: without the viewer of web pages (widefov-render --web); Utilities/fetch-viewer.sh makes it" >&2
  fi
}

copy_others() {
  local program package data
  for program in "${programs[@]}"; do
    cp "$build/bin/$program" "$folder/bin/"
    ln -s launch.sh "$folder/$program"
  done
  install --mode=755 Utilities/launch.sh Testing/Gpu/check.sh "$folder/"
  cp LICENSE "$folder/licences/widefov"
  for package in "${compiled_in[@]}"; do
    add_licence "$package"
  done
  # the data of the scenes, where they are: "winds", and beside the checkout "office"
  for data in /usr/share/ferret-vis/data/{etopo20,coads_climatology}.cdf ../shared/data/office.binary.vtk; do
    if [ -f "$data" ]; then
      cp "$data" "$folder/data/"
    else
      echo "bundle.sh: without $data, which is not there" >&2
    fi
  done
  copy_viewer
}

# Films need ffmpeg: where it is from, or where it is to be had.
films_line() {
  if [ -d "$folder/ffmpeg" ]; then
    echo "Films are made by ffmpeg/ffmpeg, Debian's $("$folder/ffmpeg/ffmpeg" -version | awk 'NR == 1 { print $3 }'); its sources: https://tracker.debian.org/pkg/ffmpeg."
  else
    echo "Films need the program ffmpeg (Debian: apt install ffmpeg), which is not here; numbered frames, -o frames/%05d.png, do not."
  fi
}

write_readme() {
  cat > "$folder/README" << EOF
WideFoV for VTK $version: ./widefov-render --help, ./widefov-viewer --help, ./widefov-bench --help.
Runs on x86-64 Linux with glibc $(getconf GNU_LIBC_VERSION | awk '{ print $2 }') or newer, an OpenGL driver and an X display (a virtual one serves).
$(films_line)
bash check.sh . RESULTS checks and times the machine's OpenGL driver.
OpenImageIO is here without libraries for films, OpenVDB, HEIF and cameras: stand-ins are in their place.
EOF
}

# (of our own the names of functions stay, for whoever reads where one of them crashed)
trim() {
  find "$folder/bin" "$folder/lib" -type f -name '*[Ww]ide[Ff]o[Vv]*' -exec strip --strip-debug {} +
  find "$folder/lib" -type f ! -name '*WideFoV*' -exec strip --strip-unneeded {} +
  set_library_folder '$ORIGIN/../lib' "$folder"/bin/*
  set_library_folder '$ORIGIN' "$folder"/lib/*.so*
}

# BCJ and a dictionary as large as all libraries together: a sixth less than xz alone
pack() {
  file="$1"
  trap 'rm -rf "$work" "$file.part"' EXIT
  tar --create --sort=name --owner=0 --group=0 --directory="$work" "$name" |
    xz --x86 --lzma2=preset=9e,dict=192MiB > "$file.part"
  mv "$file.part" "$file"
  echo "$file: $(du -h "$file" | cut -f1)"
}

unpacked="" films=""
while [[ "${1:-}" == --* ]]; do
  case "$1" in
    --films)
      films=-films
      shift
      ;;
    --unpacked)
      [ -n "${2:-}" ] && [ ! -e "$2" ] || fail "--unpacked: name a folder that is not there yet"
      unpacked="$(realpath --canonicalize-missing "$2")"
      shift 2
      ;;
    *) fail "no option $1; there are --films and --unpacked FOLDER" ;;
  esac
done
build="${1:-build}"
[ "$#" -le 2 ] || fail "name a build folder and a file at most, not: $*"
check
version="$("$build/bin/widefov-bench" --version | awk 'NR == 1 { print $NF }')"
name="widefov$films-$version-$(uname -m)"
work="$(mktemp --directory)"
trap 'rm -rf "$work"' EXIT
folder="$work/$name"
stand_ins="$work/stand-ins"
mkdir -p "$folder"/{bin,lib/machine,licences,data} "$stand_ins"
make_stand_ins
copy_libraries
copy_others
trim
[ -z "$films" ] || bash Utilities/bundle-ffmpeg.sh "$folder/ffmpeg"
write_readme
if [ -n "$unpacked" ]; then
  mkdir -p "$(dirname "$unpacked")"
  mv "$folder" "$unpacked"
else
  pack "$(realpath --canonicalize-missing "${2:-$build/$name.tar.xz}")"
fi
