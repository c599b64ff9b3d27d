#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes Debian packages of a build, into a folder:
#
#   bash Utilities/package.sh BUILD OUTDIR
#
# of build/ the library, the programs, the Python module and what programs are built with; of
# build-paraview/ the plugin. They are for the suite of Debian that the build was made on. The same
# build gives the same bytes: every time in them is that of the commit, or SOURCE_DATE_EPOCH.
#
# Environment: SOURCE_DATE_EPOCH (needed where git knows no commit), DEBFULLNAME and DEBEMAIL (who
# maintains the packages). Exit code: 1 when something failed, 2 for a wrong command line.
set -euo pipefail

fail() {
  echo "package.sh: $1" >&2
  exit "${2:-1}"
}

[ "$#" -eq 2 ] || fail "name a build folder and a folder for the packages, not: $*" 2
build="$(realpath --canonicalize-missing "$1")"
out="$(realpath --canonicalize-missing "$2")"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ -f "$build/CPackConfig.cmake" ] || fail "$1 is no build of this project; build first: cmake --build $1"
bash Utilities/install-packages.sh package

export SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2> /dev/null || true)}"
[[ "$SOURCE_DATE_EPOCH" =~ ^[0-9]+$ ]] ||
  fail "the time of the packages is not known; set SOURCE_DATE_EPOCH to that of the commit, in seconds"

# What is no release is older than it, and younger than what was made of earlier commits. The end is
# the suite: ~deb12, or ~forky while that has no number.
version="$(sed -n 's/^set(CPACK_PACKAGE_VERSION "\(.*\)")$/\1/p' "$build/CPackConfig.cmake")"
git describe --exact-match --match "v$version" > /dev/null 2>&1 ||
  version+="~git$(date --utc --date="@$SOURCE_DATE_EPOCH" +%Y%m%d.%H%M%S)"
# shellcheck source=/dev/null
version+="-1~$(. /etc/os-release && echo "${VERSION_ID:+deb}${VERSION_ID:-$VERSION_CODENAME}")"

# without npm the packages are made all the same
if [ -x "$build/bin/widefov-render" ]; then
  if command -v npm > /dev/null; then
    bash Utilities/fetch-viewer.sh "$build" >&2
  elif [ ! -f "$build/share/widefov/web/viewer.js" ]; then
    echo "package.sh: without the viewer of web pages (widefov-render --web); Utilities/fetch-viewer.sh makes it" >&2
  fi
fi

more=()
[ -z "${DEBEMAIL:-}" ] || more=(-D "CPACK_PACKAGE_CONTACT=${DEBFULLNAME:-$DEBEMAIL} <$DEBEMAIL>")
work="$(mktemp --directory)"
trap 'rm -rf "$work"' EXIT
umask 022
(cd "$work" && cpack --config "$build/CPackConfig.cmake" -G DEB -B "$work" \
  -D "CPACK_DEBIAN_PACKAGE_VERSION=$version" "${more[@]}") > "$work/log" 2>&1 ||
  fail "CPack failed: $(grep -A 3 -m 1 'Error' "$work/log" || tail -n 3 "$work/log")"
mkdir -p "$out"
mv "$work"/*.deb "$out/"
(cd "$out" && ls -- *_"$version"_*.deb)
