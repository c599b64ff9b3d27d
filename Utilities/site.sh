#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the documentation site into a folder, from the pages of the checkout:
#
#   bash Utilities/site.sh OUTDIR [BUILD]       afterwards OUTDIR/index.html
#
# The commands of the pages in Documentation/tasks are run with the programs of BUILD (build/), and what
# they draw stands below them. Doxygen adds the reference of the classes. A page, a picture or a place that
# a link does not find is an error, and so is a command that fails. Nothing is asked of the network.
#
# Environment: WIDEFOV_LARGEST, pixels along the longer side of the pictures (640).
# Exit code: 1 when something failed, 2 for a wrong command line.
set -euo pipefail

fail() {
  echo "site.sh: $1" >&2
  exit "${2:-1}"
}

[ "$#" -eq 1 ] || [ "$#" -eq 2 ] || fail "name a folder for the site and at most a build, not: $*" 2
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out="$(realpath --canonicalize-missing "$1")"
build="$(realpath --canonicalize-missing "${2:-build}")"
[ -x "$build/bin/widefov-render" ] || fail "no program $build/bin/widefov-render; build first: cmake --build ${2:-build}"
[ ! -e "$out" ] || [ -f "$out/index.html" ] || [ -z "$(ls -A "$out")" ] || fail "$1 is there and is no site"
bash Utilities/install-packages.sh site

# The checkout as it is, by links, so that links from page to page and to sources hold; what commands draw
# lies beside them.
work="$(mktemp --directory)"
trap 'rm -rf "$work"' EXIT
mkdir "$work/pages" "$work/api"
cp --recursive --symbolic-link "$PWD"/{Documentation,*.md,LICENSE} "$work/pages/"
ln -s "$PWD"/{Examples,Module,Plugin,Programs,Testing,Utilities,CMakeLists.txt} "$work/pages/"
cp --symbolic-link "$PWD/Documentation/site/index.md" "$work/pages/"
bash Utilities/with-display.sh --for "$build" /usr/bin/python3 -B Documentation/site/run_pages.py \
  "$build/bin" "${WIDEFOV_LARGEST:-640}" "$PWD" "$work/pages/Documentation"/{start.md,tasks/*.md}

doxygen - > "$work/log" 2>&1 << EOF || fail "Doxygen says: $(head -n 3 "$work/log")"
@INCLUDE = Documentation/Doxyfile
OUTPUT_DIRECTORY = $work/api
EOF
sphinx-build -q -W --keep-going -b html -d "$work/trees" -c Documentation/site "$work/pages" "$work/site" ||
  fail "Sphinx failed, see above"
mv "$work/api/html" "$work/site/api"
/usr/bin/python3 -B Documentation/site/check_links.py "$work/site"
rm -rf "$out"
mkdir -p "$(dirname "$out")"
mv "$work/site" "$out"
echo "site.sh: $out/index.html"
