#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages of the named groups that are missing, and says which.
# Runs apt only when something is missing; asks nothing.
#
#   Utilities/install-packages.sh GROUP...     groups: see packages.txt
set -euo pipefail

list="$(dirname "${BASH_SOURCE[0]}")/packages.txt"

fail() {
  echo "install-packages.sh: $1" >&2
  exit 1
}

[ "$#" -gt 0 ] || fail "name at least one group of packages.txt"

wanted=()
for group in "$@"; do
  packages="$(awk -v group="$group" '$1 == group { print $2 }' "$list")"
  [ -n "$packages" ] || fail "no group \"$group\" in packages.txt"
  # word splitting is meant: one package a word
  # shellcheck disable=SC2206
  wanted+=($packages)
done

command -v dpkg-query > /dev/null && command -v apt-get > /dev/null ||
  fail "this needs Debian's package tools; install what corresponds to: ${wanted[*]}"

missing=()
for package in "${wanted[@]}"; do
  state="$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2> /dev/null || true)"
  [ "$state" = installed ] || missing+=("$package")
done
[ "${#missing[@]}" -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null ||
    fail "not root and no sudo; as root: apt-get install --no-install-recommends ${missing[*]}"
  as_root=(sudo)
fi

echo "Installing Debian packages: ${missing[*]}"
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
# A list that cannot be brought up to date is no reason to stop: what is known may serve.
"${apt[@]}" update || echo "install-packages.sh: apt-get update failed, going on" >&2
"${apt[@]}" install -y --no-install-recommends "${missing[@]}" < /dev/null ||
  fail "apt-get could not install: ${missing[*]}"
