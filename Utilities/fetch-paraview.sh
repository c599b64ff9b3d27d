#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Unpacks Debian's ParaView into a folder, beside the system's VTK, and installs what it links
# with: its packages themselves cannot be installed with libvtk9-dev everywhere. A folder that is
# complete is kept.
#
#   Utilities/fetch-paraview.sh FOLDER         afterwards FOLDER/usr/bin/pvpython
set -euo pipefail

packages=(paraview paraview-dev python3-paraview)
install="$(dirname "${BASH_SOURCE[0]}")/install-packages.sh"

fail() {
  echo "fetch-paraview.sh: $1" >&2
  exit 1
}

[ "$#" -eq 1 ] || fail "name one folder"
folder="$(realpath --canonicalize-missing "$1")"
if [ -s "$folder/complete" ]; then
  exec bash "$install" --satisfy "$(cat "$folder/complete")"
fi
command -v apt-get > /dev/null && command -v dpkg > /dev/null ||
  fail "this needs Debian's package tools; set ParaView_DIR to a ParaView of your own instead"

# beside the folder, then renamed: an interrupted download leaves no half ParaView
part="$(dirname "$folder")/$(basename "$folder").part"
rm -rf "$part" "$folder"
mkdir -p "$part/packages" "$part/root"
trap 'rm -rf "$part"' EXIT

download() {
  # apt hands the download to a user of its own where it may, and warns where it may not
  (cd "$part/packages" && apt-get -q -q download "${packages[@]}" 2> "$part/errors")
}

# What the packages depend on beside each other, as one field: whichever libraries this suite has.
needed() {
  local others
  others="$(IFS='|' && echo "${packages[*]}")"
  for package in "$part"/packages/*.deb; do
    dpkg-deb --field "$package" Depends
  done | tr ',' '\n' | sed 's/^ *//' | grep -v -E "^($others)( |\$)" | sort -u | paste -s -d ,
}

# ParaView's CMake files look for Python modules by the names they had before packaging put the
# version of Python into them, as it does since Debian 13.
name_as_built() {
  local module
  find "$1" -name '*.cpython-*.so' | while read -r module; do
    ln -s -f "$(basename "$module")" "${module%%.cpython-*}.so"
  done
}

echo "Downloading Debian packages: ${packages[*]}"
if ! download; then
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get -q update || echo "fetch-paraview.sh: apt-get update failed" >&2
  download || fail "apt-get could not download ${packages[*]}: $(cat "$part/errors")"
fi
bash "$install" --satisfy "$(needed)"
for package in "$part"/packages/*.deb; do
  dpkg -x "$package" "$part/root" || fail "could not unpack $(basename "$package")"
done
name_as_built "$part/root"
needed > "$part/root/complete"
mv "$part/root" "$folder"
