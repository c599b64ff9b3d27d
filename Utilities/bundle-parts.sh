# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# What the scripts that pack programs with their libraries share; they bring fail and $folder.

# Always the machine's own: the C library.
own='/(ld-linux-x86-64|libc|libm|libdl|libpthread|librt|libresolv|libutil|libanl)\.so'

# The package of a library; dpkg knows some as /lib/... and some as /usr/lib/...
package_of() {
  local path
  path="$(realpath "$1")"
  { dpkg-query --search "$path" "${path#/usr}" 2> /dev/null || true; } | awk -F: 'NR == 1 { print $1 }'
}

# add_licence PACKAGE
add_licence() {
  local notice="/usr/share/doc/$1/copyright"
  [ -f "$notice" ] || fail "the package $1 has no licence at $notice; install it anew, with it"
  cp --dereference "$notice" "$folder/licences/$1"
}

# libraries_of PROGRAM-OR-LIBRARY: each that it loads, as a path, but the C library
libraries_of() {
  ldd "$1" | awk '$3 ~ /^\// { print $3 }' | grep -vE "$own"
}

# needed_by FILE: the names of those that it asks for itself
needed_by() {
  readelf --dynamic "$1" | awk -F '[][]' '/\(NEEDED\)/ { print $2 }'
}

# (RPATH, not RUNPATH: it holds for what libraries load as well, and goes before LD_LIBRARY_PATH)
set_library_folder() {
  patchelf --force-rpath --set-rpath "$1" "${@:2}"
}
