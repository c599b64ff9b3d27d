#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Packs the programs ffmpeg and ffprobe of this machine with those of their libraries that films of
# widefov-render use, so that they run from wherever the folder lies:
#
#   bash Utilities/bundle-ffmpeg.sh FOLDER      ffmpeg ffprobe lib/ licences/
#
# FFmpeg is linked with two hundred libraries, for formats and devices that no film here has. In their
# places are stand-ins (stand-in.sh), which say so and end the program. Which ones are used is found by
# trying: films of all codecs and containers are made, and a stand-in that complains gives way.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# FFmpeg's own libraries; and those of the compiler, which no stand-in has all of.
ffmpegs='/lib(avcodec|avdevice|avfilter|avformat|avutil|postproc|swresample|swscale)\.so'
compilers='/lib(stdc\+\+|gcc_s)\.so'

fail() {
  echo "bundle-ffmpeg.sh: $1" >&2
  exit 1
}

# shellcheck source=Utilities/bundle-parts.sh
. Utilities/bundle-parts.sh

# copy LIBRARY, in the place of a stand-in where there is one
copy() {
  local package name="$folder/lib/${1##*/}"
  cp --remove-destination --dereference "$1" "$name"
  strip --strip-unneeded "$name"
  set_library_folder '$ORIGIN' "$name"
  package="$(package_of "$1")"
  add_licence "${package:-${1##*/}}"
}

# A stand-in of each library that FFmpeg's own ask for, as it is to all of them.
make_stand_ins() {
  local library
  for library in "$folder/lib"/*; do
    needed_by "$library"
  done | sort -u > "$work/needed"
  while read -r library; do
    if [ ! -e "$folder/lib/${library##*/}" ] && grep -qFx "${library##*/}" "$work/needed"; then
      bash Utilities/stand-in.sh "$library" "$folder/lib" "${own_libraries[@]}"
    fi
  done < "$work/libraries"
}

# A library and what it loads itself.
bring_in() {
  local library path
  path="$(awk -F / -v name="$1" '$NF == name' "$work/libraries")"
  [ -n "$path" ] || fail "$1 is asked for, and the ffmpeg of this machine does not load it"
  copy "$path"
  libraries_of "$path" > "$work/more" || true # none but the C library
  while read -r library; do
    copy "$library"
  done < "$work/more"
}

# encode CODEC PIXELS SOUND FILE
encode() {
  local tags="setparams=range=tv:color_primaries=bt709:color_trc=bt709:colorspace=bt709"
  local color="scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,$tags,format=$2"
  "$folder/ffmpeg" -nostdin -loglevel error -y -f rawvideo -pixel_format rgb24 -video_size 64x64 -framerate 25 \
    -i "$work/frames" -i "$work/sound.wav" -vf "$color" -c:v "$1" -c:a "$3" "$work/$4"
}

# What films ask for: encoders, each codec and sound, joining, reading the metadata. (In a condition set -e
# does nothing.)
try_films() {
  local film quiet=(-nostdin -loglevel error -y)
  "$folder/ffmpeg" "${quiet[@]}" -f lavfi -i sine=duration=0.2 "$work/sound.wav" &&
    "$folder/ffmpeg" -hide_banner -encoders > "$work/encoders" &&
    encode libx264 yuv420p aac film.mp4 &&
    encode prores_ks yuv422p10le aac film.mov &&
    encode libvpx-vp9 yuv420p libopus film.webm &&
    encode libx265 yuv420p aac film.mkv &&
    "$folder/ffmpeg" "${quiet[@]}" -f concat -safe 0 -i "$work/list" -c copy "$work/joined.mp4" || return 1
  for film in joined.mp4 film.mov film.webm film.mkv sound.wav; do
    "$folder/ffprobe" -loglevel error -show_streams "$work/$film" > "$work/streams" || return 1
  done
}

keep_what_is_used() {
  local missing
  head --bytes=$((5 * 3 * 64 * 64)) /dev/urandom > "$work/frames"
  echo "file film.mp4" > "$work/list"
  until try_films > "$work/said" 2>&1; do
    missing="$(sed -n 's/^widefov: this bundle is without \(.*\); use an installation$/\1/p' "$work/said" | head -n 1)"
    [ -n "$missing" ] || fail "no films can be made with it: $(grep . "$work/said" | tail -n 1)"
    bring_in "$missing"
  done
}

[ "$#" -eq 1 ] && [ ! -e "$1" ] || fail "name a folder that is not there yet"
{ command -v ffmpeg && command -v ffprobe; } > /dev/null || fail "no ffmpeg and ffprobe here; apt install ffmpeg"
{ command -v patchelf && command -v readelf; } > /dev/null || bash Utilities/install-packages.sh bundle
folder="$(realpath --canonicalize-missing "$1")"
work="$(mktemp --directory)"
trap 'code=$?; rm -rf "$work"; [ "$code" -eq 0 ] || rm -rf "$folder"' EXIT
mkdir -p "$folder"/{lib,licences}
cp --dereference "$(command -v ffmpeg)" "$(command -v ffprobe)" "$folder/"
set_library_folder '$ORIGIN/lib' "$folder/ffmpeg" "$folder/ffprobe"
libraries_of "$(command -v ffmpeg)" > "$work/libraries"
mapfile -t own_libraries < <(grep -E "$ffmpegs" "$work/libraries")
for library in "${own_libraries[@]}" $(grep -E "$compilers" "$work/libraries"); do
  copy "$library"
done
make_stand_ins
keep_what_is_used
"$folder/ffmpeg" -version | head -n 1
