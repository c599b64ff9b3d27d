#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Packs the measuring and testing programs of a build with every library they need but the
# C library and the OpenGL driver, for machines without VTK: unpack, and run bin/NAME.
#
#   bash Utilities/bundle.sh [BUILD FOLDER [FILE.tar.xz]]
#
# By default of build/, into build/widefov-VERSION-x86_64.tar.xz. The programs find their
# libraries from where they lie; lib/gl holds the loader of OpenGL drivers and what NVIDIA's
# driver asks for, for machines that have a driver alone: there, add it to LD_LIBRARY_PATH.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fail() {
  echo "bundle.sh: $1" >&2
  exit 1
}

build="${1:-build}"
[ "$#" -le 2 ] || fail "name a build folder and a file at most, not: $*"
programs=(widefov-bench widefov-stress widefov-compare-tests widefov-gpu-tests)
for program in "${programs[@]}"; do
  [ -x "$build/bin/$program" ] || fail "no program $build/bin/$program; build first: cmake --build $build"
done
[ "$(uname -m)" = x86_64 ] || fail "bundles are made for x86-64 alone, not for $(uname -m)"
command -v patchelf > /dev/null || fail "patchelf is missing; as root: apt-get install patchelf"

version="$("$build/bin/widefov-bench" --version | awk '{ print $NF; exit }')"
name="widefov-$version-$(uname -m)"
file="$(realpath --canonicalize-missing "${2:-$build/$name.tar.xz}")"
work="$(mktemp --directory)"
trap 'rm -rf "$work" "$file.part"' EXIT
folder="$work/$name"
mkdir -p "$folder/bin" "$folder/lib/gl" "$folder/licences"

# The C library is the machine's own, and so is what belongs to the driver.
own='/(ld-linux-x86-64|libc|libm|libdl|libpthread|librt|libresolv|libutil|libanl)\.so'
loaders='/(libGL|libGLX|libEGL|libOpenGL|libGLdispatch|libXext)\.so'

# The package of a library; dpkg knows some as /lib/... and some as /usr/lib/...
package_of() {
  local path
  path="$(realpath "$1")"
  { dpkg-query --search "$path" "${path#/usr}" 2> /dev/null || true; } | awk -F: '{ print $1; exit }'
}

for program in "${programs[@]}"; do
  cp "$build/bin/$program" "$folder/bin/"
done
# (libXext is what NVIDIA's driver loads)
needed="$(ldd "$folder"/bin/*; /sbin/ldconfig -p | awk '/libXext.so.6 .*x86-64/ { print $1, $3, $4 }')"
if grep -q 'not found' <<< "$needed"; then
  fail "a library is missing: $(grep --max-count=1 'not found' <<< "$needed" | xargs)"
fi
awk '$3 ~ /^\// { print $3 }' <<< "$needed" | sort -u | grep -vE "$own" |
  while read -r library; do
    if grep -qE "$loaders" <<< "$library"; then
      cp --dereference "$library" "$folder/lib/gl/"
    else
      cp --dereference "$library" "$folder/lib/"
    fi
    package="$(package_of "$library")"
    notice="/usr/share/doc/${package:-none}/copyright"
    [ ! -f "$notice" ] || cp "$notice" "$folder/licences/$package"
  done
[ -f "$folder/lib/gl/libXext.so.6" ] || fail "libXext.so.6 is missing; as root: apt-get install libxext6"
cp LICENSE "$folder/licences/widefov"

# The data of the scenes, where they are: "winds", and beside the checkout "office".
mkdir -p "$folder/data"
for data in /usr/share/ferret-vis/data/{etopo20,coads_climatology}.cdf ../shared/data/office.binary.vtk; do
  [ ! -f "$data" ] || cp "$data" "$folder/data/"
done

# (of our own the names of functions stay, for whoever reads where one of them crashed)
find "$folder/bin" "$folder/lib" -type f -name '*WideFoV*' -exec strip --strip-debug {} +
find "$folder/lib" -type f ! -name '*WideFoV*' -exec strip --strip-unneeded {} +
# (RPATH, not RUNPATH: it holds for what libraries load as well)
patchelf --force-rpath --set-rpath '$ORIGIN/../lib' "$folder"/bin/*
patchelf --force-rpath --set-rpath '$ORIGIN' "$folder"/lib/*.so*

tar --create --directory="$work" "$name" | xz -6 --threads=0 > "$file.part"
mv "$file.part" "$file"
echo "$file: $(du -h "$file" | cut -f1)"
