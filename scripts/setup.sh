#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what is missing, and only that: Debian packages for the given groups, and the npm packages
# of the lock file. Called by every npm script; does nothing, quickly, when all is there.
#
#   scripts/setup.sh [wasm] [native] [test] [house] [fresh]   (default: the first three)
set -eu
cd "$(dirname "$0")/.."

wasm='cmake ninja-build emscripten libeigen3-dev libfast-float-dev'
native='cmake ninja-build g++ libeigen3-dev libfast-float-dev libfmt-dev libcli11-dev
  nlohmann-json3-dev'
tests='clang libclang-rt-14-dev clang-format clang-tidy libgtest-dev libbenchmark-dev doxygen
  chromium fonts-dejavu-core'
house='universal-ctags'
fresh='debootstrap'

[ $# -gt 0 ] || set -- wasm native test
wanted=
for group in "$@"; do
  case $group in
    wasm) wanted="$wanted $wasm" ;;
    native) wanted="$wanted $native" ;;
    test) wanted="$wanted $tests" ;;
    house) wanted="$wanted $house" ;;
    fresh) wanted="$wanted $fresh" ;;
    *) echo "setup: unknown group '$group' (wasm, native, test, house, fresh)" >&2; exit 2 ;;
  esac
done

if command -v dpkg >/dev/null 2>&1; then
  missing=
  for package in $wanted; do
    case " $missing " in *" $package "*) continue ;; esac
    dpkg -s "$package" 2>/dev/null | grep -q '^Status: install ok installed' ||
      missing="$missing $package"
  done
  if [ -n "$missing" ]; then
    as_root=
    if [ "$(id -u)" -ne 0 ]; then
      if ! command -v sudo >/dev/null 2>&1; then
        echo "setup: these Debian packages are missing:$missing" >&2
        echo "setup: run as root: apt-get update && apt-get install -y$missing" >&2
        exit 1
      fi
      as_root=sudo
    fi
    echo "setup: installing$missing"
    # Another program may hold apt's lock for a while; wait for it instead of failing.
    apt() { $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=600 "$@"; }
    apt update
    # shellcheck disable=SC2086  # a list of words is meant
    apt install -y --no-install-recommends $missing
  fi
else
  echo "setup: no dpkg here; make sure that these are installed:$wanted" >&2
fi

# npm writes this file at the end of an installation.
stamp=node_modules/.package-lock.json
if [ ! -f "$stamp" ] || [ package-lock.json -nt "$stamp" ]; then
  npm ci
  touch "$stamp"
fi
