#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes a stand-in for a library: the same name and all that its users ask of it, but each
# function says that the library is missing and ends the program. For what a program is linked
# with and never calls.
#
#   bash Utilities/stand-in.sh LIBRARY FOLDER USER...
#
# USERS are the libraries or programs that are linked with LIBRARY; the stand-in goes into FOLDER.
# Weak symbols are left out: others may have them as well, and then theirs are the right ones.
set -euo pipefail

fail() {
  echo "stand-in.sh: $1" >&2
  exit 1
}

[ "$#" -ge 3 ] || fail "name the library, a folder and its users, not: $*"
library="$1" folder="$2"
name="$(readelf --dynamic "$library" | awk -F '[][]' '/\(SONAME\)/ { print $2 }')"
[ -n "$name" ] || fail "$library has no name of its own (SONAME)"
work="$(mktemp --directory)"
trap 'rm -rf "$work"' EXIT

# NAME@VERSION or NAME, and the kind where it is defined here
nm --dynamic --undefined-only "${@:3}" | awk 'NF == 2 { print $2 }' | LC_ALL=C sort -u > "$work/asked"
nm --dynamic --defined-only "$library" | awk '{ sub("@@", "@", $3); print $3, $2 }' |
  LC_ALL=C sort > "$work/defined"
LC_ALL=C join "$work/asked" "$work/defined" | awk '$2 ~ /^[TDBRG]$/' > "$work/wanted"

{
  cat << EOF
#include <unistd.h>
static void missing(void)
{
  static const char text[] = "widefov: this bundle is without $name; use an installation\n";
  (void)!write(2, text, sizeof(text) - 1);
  _exit(1);
}
EOF
  # (data are as large as a page, more than any that is asked for)
  awk '{ sub("@.*", "", $1)
    print ($2 == "T" ? "void " $1 "(void) { missing(); }" : "char " $1 "[4096];") }' "$work/wanted"
} > "$work/stand-in.c"
# A node of the script is a version; what has none needs none.
awk '{ n = split($1, part, "@"); if (n == 2) nodes[part[2]] = nodes[part[2]] " " part[1] ";" }
  END { for (v in nodes) print v " { global:" nodes[v] " };" }' "$work/wanted" > "$work/versions"
versions=()
[ ! -s "$work/versions" ] || versions=(-Wl,--version-script="$work/versions")
mkdir -p "$folder"
${CC:-cc} -shared -fPIC -fno-builtin -O1 -w -Wl,-soname,"$name" "${versions[@]}" \
  -o "$folder/$name" "$work/stand-in.c"
