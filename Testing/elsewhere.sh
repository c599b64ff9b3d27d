#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The README's two commands in another suite of Debian: makes a root of it with debootstrap,
# installs, builds and draws there, and runs the tests.
#
#   bash Testing/elsewhere.sh SUITE [CTEST OPTION...]    for example trixie -L everywhere
#   bash Testing/elsewhere.sh --prepare SUITE            the root and its packages, no more
#   bash Testing/elsewhere.sh --in SUITE COMMAND...      one command in the checkout, there
#   bash Testing/elsewhere.sh --bare SUITE COMMAND...    the same in a root without any more
#                                                        packages, which goes with the command
#
# SUITE is bookworm (Debian 12), trixie (13) or forky (testing). The root stays in
# build-roots/SUITE for the next call, with its own builds and pictures in srv/ there; what was
# downloaded stays in build-roots/cache. The checkout is seen from it and not written to. Nothing
# stays mounted. One call at a time works in a suite; another ends at once. This needs root, or sudo.
#
# Environment:
#   WIDEFOV_ELSEWHERE=tests     leaves out Examples/run.sh
#   WIDEFOV_FLAVOURS            as for Testing/run.sh
#   WIDEFOV_MIRROR=URL          a mirror of Debian, instead of debootstrap's own
#
# Exit code: 0 when all was built and every test passed.
set -euo pipefail

checkout="$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")"
roots="$checkout/build-roots"
passed_on=(WIDEFOV_ELSEWHERE WIDEFOV_FLAVOURS WIDEFOV_MIRROR http_proxy https_proxy no_proxy)
made_by_builds=(build build-paraview output)

fail() {
  echo "Testing/elsewhere.sh: $1" >&2
  exit 1
}

# name_of STEP SUITE: the folder of the root
name_of() {
  [ "$1" = bare ] && echo "$2.bare" || echo "$2"
}

# settings: what of the environment is passed on, as arguments of env
settings() {
  local name
  for name in "${passed_on[@]}"; do
    [ -z "${!name:-}" ] || printf '%s\n' "$name=${!name}"
  done
}

# ---- in a namespace of mounts, which go with it

# in_root COMMAND [ARGUMENT...]: in the checkout, with nothing of this machine's environment
in_root() {
  local kept
  mapfile -t kept < <(settings)
  chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 TERM="${TERM:-dumb}" \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${kept[@]}" \
    bash -c 'cd /srv/checkout && exec "$@"' in_root "$@"
}

mount_all() {
  local folder
  for folder in dev proc sys; do
    mount --rbind "/$folder" "$root/$folder"
  done
  # X servers on one machine find each other's locks there, and do not share a number
  mount --bind /tmp "$root/tmp"
  mkdir -p "$roots/cache/$suite" "$root/srv/checkout"
  mount --bind "$roots/cache/$suite" "$root/var/cache/apt/archives"
  mount --bind "$checkout" "$root/srv/checkout"
  mount -o remount,bind,ro "$root/srv/checkout"
  [ "$name" = "$suite" ] || return 0 # nothing is built in a bare one
  for folder in "${made_by_builds[@]}"; do
    mkdir -p "$root/srv/$folder" "$checkout/$folder"
    mount --bind "$root/srv/$folder" "$root/srv/checkout/$folder"
  done
}

say_versions() {
  local config=("$root"/srv/build-paraview/paraview/usr/lib/*/cmake/paraview-*)
  [ ! -d "${config[0]}" ] || echo -n "$(basename "${config[0]}") "
  in_root dpkg-query --show --showformat='${Package}-${Version} ' libvtk9-dev libgl1-mesa-dri
}

prepare() {
  local flavours=" ${WIDEFOV_FLAVOURS:-vtk paraview} "
  doing="installing packages, see above"
  in_root bash Utilities/install-packages.sh build examples test
  if [[ "$flavours" == *" paraview "* ]]; then
    in_root bash Utilities/install-packages.sh paraview
    in_root bash Utilities/fetch-paraview.sh build-paraview/paraview
  fi
}

run() {
  if [ "${WIDEFOV_ELSEWHERE:-}" != tests ]; then
    doing="running bash Examples/run.sh, see above"
    in_root bash Examples/run.sh
    echo "Testing/elsewhere.sh: $suite: pictures are in $root/srv/output"
  fi
  doing="running bash Testing/run.sh, see above"
  in_root bash Testing/run.sh "$@"
  echo "Testing/elsewhere.sh: $suite ($(say_versions)): built, and every test passed"
}

# within STEP SUITE [ARGUMENT...]
within() {
  suite="$2"
  name="$(name_of "$1" "$suite")"
  root="$roots/$name"
  doing="mounting (a container needs the right to, CAP_SYS_ADMIN)"
  trap '[ "$?" -eq 0 ] || fail "$suite: FAILED while $doing"' EXIT
  mount_all
  cp --dereference /etc/resolv.conf /etc/hosts "$root/etc/" 2> /dev/null || true
  case "$1" in
    prepare) prepare ;;
    run) run "${@:3}" ;;
    in | bare)
      trap - EXIT
      in_root "${@:3}"
      ;;
  esac
}

# ---- on the machine itself

# Less to write and to wait for, no services; and the way to the mirror is this machine's. Packages
# of ours need copyrights of others.
configure_root() {
  printf '%s\n' '#!/bin/sh' 'exit 101' > "$1/usr/sbin/policy-rc.d"
  chmod +x "$1/usr/sbin/policy-rc.d"
  printf '%s\n' force-unsafe-io 'path-exclude=/usr/share/doc/*' 'path-exclude=/usr/share/man/*' \
    'path-exclude=/usr/share/locale/*' 'path-include=/usr/share/doc/*/copyright' \
    > "$1/etc/dpkg/dpkg.cfg.d/90-widefov"
  {
    printf '%s\n' 'APT::Install-Recommends "false";' 'Acquire::Languages "none";' \
      'APT::Sandbox::User "root";' 'APT::Keep-Downloaded-Packages "true";' 'Dpkg::Use-Pty "0";'
    apt-config dump 2> /dev/null | grep -E '^Acquire::(http|https|Check|ForceIP|Retries)' || true
  } > "$1/etc/apt/apt.conf.d/90-widefov"
}

leave_nothing() {
  rm -rf --one-file-system "$part" "$log"
  rmdir "$roots/cache/$suite" "$roots/cache" "$roots" 2> /dev/null || true # where they are empty
}

# Beside the place, then renamed: an interrupted call leaves no half root.
make_root() {
  part="$roots/$name.part"
  log="$roots/$name.log"
  local script=()
  trap leave_nothing EXIT
  rm -rf --one-file-system "$part"
  mkdir -p "$roots/cache/$suite"
  # an older debootstrap does not know a newer suite, and all of them are made as sid is
  [ -e "/usr/share/debootstrap/scripts/$suite" ] || script=(sid)
  echo "Testing/elsewhere.sh: making a root of $suite in $roots, of what debootstrap brings"
  unshare --mount debootstrap --variant=minbase --cache-dir="$roots/cache/$suite" \
    "$suite" "$part" "${WIDEFOV_MIRROR:-}" "${script[@]}" > "$log" 2>&1 ||
    fail "no root of $suite could be made: $(grep '^E: ' "$log" | tail -n 1 | grep . ||
      tail -n 1 "$log" | grep . || echo debootstrap failed); look for the network, or set WIDEFOV_MIRROR"
  configure_root "$part"
  mv "$part" "$roots/$name"
  rm -f "$log"
  trap - EXIT
}

need_debootstrap() {
  local said
  ! command -v debootstrap > /dev/null || return 0
  said="$(bash "$checkout/Utilities/install-packages.sh" elsewhere 2>&1)" ||
    fail "no root of $suite can be made without debootstrap, which could not be installed: ${said##*$'\n'}"
  echo "$said"
}

become_root() {
  [ "$(id -u)" -ne 0 ] || return 0
  command -v sudo > /dev/null || fail "not root and no sudo; run it as root"
  mapfile -t kept < <(settings)
  exec sudo env "${kept[@]}" bash "${BASH_SOURCE[0]}" "$@"
}

# work_in_root STEP SUITE [ARGUMENT...]: the places to mount on that stayed empty go with the last
# call at work, for one that loses its place loses what is mounted there.
work_in_root() {
  local code=0
  exec 7< "${BASH_SOURCE[0]}"
  flock --shared 7
  unshare --mount bash "${BASH_SOURCE[0]}" --within "$@" || code=$?
  ! flock --nonblock 7 || rmdir "${made_by_builds[@]/#/$checkout/}" 2> /dev/null || true
  [ "$1" != bare ] || rm -rf --one-file-system "${roots:?}/$name"
  exit "$code"
}

main() {
  local step=run known all=("$@")
  known="$(bash "$checkout/Utilities/install-packages.sh" --suites | paste -s -d ' ')"
  if [[ " --prepare --in --bare " == *" ${1:-} "* ]]; then
    step="${1#--}"
    shift
  fi
  [ "$#" -gt 0 ] || fail "name a suite of Debian: $known"
  [[ "$step" != in && "$step" != bare ]] || [ "$#" -gt 1 ] ||
    fail "--$step $1: name a command as well"
  [ "$step" != prepare ] || [ "$#" -eq 1 ] || fail "--prepare $1 takes nothing more, not ${*:2}"
  suite="$1"
  [[ " $known " == *" $suite "* ]] || fail "no suite \"$suite\" here; there are $known"
  become_root "${all[@]}"
  name="$(name_of "$step" "$suite")"
  [ -d "$roots/$name" ] || need_debootstrap
  unshare --mount true 2> /dev/null ||
    fail "this may not mount (unshare --mount); a container needs the right to, CAP_SYS_ADMIN"
  mkdir -p "$roots"
  # one at a time, so that two calls do not make one root
  exec 9< "$roots"
  flock 9
  [ "$step" != bare ] || [ ! -d "$roots/$name" ] ||
    fail "another call is at work in $roots/$name, or was interrupted: then remove it"
  [ -d "$roots/$name" ] || make_root
  # and up to the end of what this call starts, so that two do not build in one folder
  exec 8< "$roots/$name"
  flock --nonblock 8 || fail "$name: another call is at work there; wait for its end"
  exec 9<&-
  work_in_root "$step" "$@"
}

if [ "${1:-}" = --within ]; then
  within "${@:2}"
else
  main "$@"
fi
