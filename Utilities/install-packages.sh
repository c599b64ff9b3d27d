#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages of the named groups that are missing, and says which.
# Runs apt only when something is missing; asks nothing.
#
#   Utilities/install-packages.sh GROUP...              groups: see packages.txt
#   Utilities/install-packages.sh --satisfy DEPENDS     what a package's field Depends says
#   Utilities/install-packages.sh --suites              the suites of Debian it knows
#
# The suite is that of this machine, or WIDEFOV_SUITE: the one whose VTK is nearest.
set -euo pipefail

list="$(dirname "${BASH_SOURCE[0]}")/packages.txt"
suites=(bookworm trixie forky)

fail() {
  echo "install-packages.sh: $1" >&2
  exit 1
}

# What this machine runs, as one word.
this_suite() {
  # shellcheck source=/dev/null
  (. /etc/os-release 2> /dev/null && echo "${VERSION_CODENAME:-${ID:-unknown}}") || echo unknown
}

# The suite whose names hold here. Ubuntu 24.04 has VTK 9.1 and ParaView 5.11, as Debian 12.
find_suite() {
  local here="${WIDEFOV_SUITE:-$(this_suite)}"
  [ "$here" != noble ] || here=bookworm
  [[ " ${suites[*]} " == *" $here "* ]] ||
    fail "this knows the packages of Debian's ${suites[*]} and of Ubuntu's noble, not of $here; set WIDEFOV_SUITE to the one whose VTK is nearest, or install by hand what packages.txt lists"
  echo "$here"
}

# names_of GROUP SUITE: its packages, one a line
names_of() {
  awk -v group="$1" -v suite="$2" '{
    split($1, key, ":")
    if (key[1] == group && (key[2] == "" || index("," key[2] ",", "," suite ","))) print $2
  }' "$list"
}

find_missing() {
  local package state
  for package in "$@"; do
    state="$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2> /dev/null || true)"
    [ "$state" = installed ] || echo "$package"
  done
}

# install COMMAND WHAT...: apt-get's install or satisfy
install() {
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null ||
      fail "not root and no sudo; as root: apt-get $1 --no-install-recommends ${*:2}"
    as_root=(sudo)
  fi
  echo "Installing Debian packages: ${*:2}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
    apt-get -q -o DPkg::Lock::Timeout=300)
  # A list that cannot be brought up to date is no reason to stop: what is known may serve.
  "${apt[@]}" update || echo "install-packages.sh: apt-get update failed, going on" >&2
  "${apt[@]}" "$1" -y --no-install-recommends "${@:2}" < /dev/null ||
    fail "apt-get could not $1: ${*:2}"
}

[ "$#" -gt 0 ] || fail "name at least one group of packages.txt"
if [ "$1" = --suites ]; then
  printf '%s\n' "${suites[@]}"
  exit 0
fi

wanted=()
if [ "$1" = --satisfy ]; then
  [ "$#" -eq 2 ] || fail "--satisfy takes one field"
  wanted=("$2")
else
  suite="$(find_suite)"
  for group in "$@"; do
    mapfile -t names < <(names_of "$group" "$suite")
    [ "${#names[@]}" -gt 0 ] || fail "no group \"$group\" in packages.txt"
    wanted+=("${names[@]}")
  done
fi

command -v dpkg-query > /dev/null && command -v apt-get > /dev/null ||
  fail "this needs Debian's package tools; install what corresponds to: ${wanted[*]}"

if [ "$1" = --satisfy ]; then
  # an error as well: the lists may have to be fetched first
  plan="$(apt-get -q -q satisfy --simulate --no-install-recommends "$2" 2>&1 || echo E:)"
  ! grep -q '^\(Inst\|E:\)' <<< "$plan" || install satisfy "$2"
  exit 0
fi
mapfile -t missing < <(find_missing "${wanted[@]}")
[ "${#missing[@]}" -eq 0 ] || install install "${missing[@]}"
