#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the viewer of web pages, which widefov-render --web and widefov.show put beside a panorama, for a
# build: Photo Sphere Viewer from the npm registry, in one script. A build that has it is left alone.
#
#   bash Utilities/fetch-viewer.sh [BUILD]      afterwards BUILD/share/widefov/web (build/)
#
# The versions and the hashes of all packages are those of Programs/Web/page/package-lock.json. Needs npm,
# which is installed if it is missing, and the network. Exit code: 1 when something failed, 2 for a wrong command line.
set -euo pipefail
umask 022

fail() {
  echo "fetch-viewer.sh: $1" >&2
  exit "${2:-1}"
}

[ "$#" -le 1 ] || fail "name at most a build, not: $*" 2
build="$(realpath --canonicalize-missing "${1:-build}")"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
sources="$PWD/Programs/Web/page"
target="$build/share/widefov/web"
made="$(cat "$sources"/* | sha256sum)"
[ "$(cat "$target/made-of" 2> /dev/null)" != "$made" ] || exit 0
command -v npm > /dev/null || bash Utilities/install-packages.sh web

work="$(mktemp --directory)"
trap 'rm -rf "$work"' EXIT
cp "$sources"/* "$work/"
cd "$work"
npm ci --ignore-scripts --no-audit --no-fund --silent > log 2>&1 ||
  fail "npm could not install what package-lock.json lists: $(tail -n 1 log)"
mkdir web
node_modules/.bin/esbuild viewer.js --bundle --minify --format=iife --legal-comments=none --log-level=error \
  --target=es2022 --outfile=web/viewer.js || fail "esbuild failed, see above"
cp index.html web/
# a headset for the tests; no package has it
echo 'import { XRDevice, metaQuest3 } from "iwer"; window.emulator = { XRDevice, metaQuest3 };' > emulator.js
node_modules/.bin/esbuild emulator.js --bundle --minify --format=iife --log-level=error --outfile=web/emulator.js ||
  fail "esbuild failed, see above"
for package in node_modules/@photo-sphere-viewer/core node_modules/three; do
  echo "${package#node_modules/} $(sed -n 's/^ *"version": "\(.*\)",*$/\1/p' "$package/package.json")"
  echo
  cat "$package/LICENSE"
  echo
done > web/licences.txt
echo "$made" > web/made-of
mkdir -p "$(dirname "$target")"
rm -rf "$target"
# another run may have been quicker
mv --no-target-directory web "$target" 2> /dev/null ||
  [ "$(cat "$target/made-of" 2> /dev/null)" = "$made" ] || fail "$target cannot be written"
echo "fetch-viewer.sh: $target"
