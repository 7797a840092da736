# Shared by the scripts in ci/: sourced, never run. Leaves the shell in the source root.
# shellcheck shell=bash
script=$(realpath "$0")
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
# shellcheck disable=SC2034  # used by the scripts that source this one
jobs=$(nproc)              # before the next line, which nproc would take for the number of processors
export OMP_NUM_THREADS=1   # the tests and the studies run side by side; threads inside a run only slow them

say() { printf '== %s\n' "$*"; }
die() { printf '%s: %s\n' "${0##*/}" "$1" >&2; exit "${2:-2}"; }

# Under `sudo ci/...` only the installation needs root. What is built belongs to the owner of the checkout.
drop_root() {
  if [[ $EUID -eq 0 && ${SUDO_UID:-0} -ne 0 && $(stat -c %u .) -eq $SUDO_UID ]]; then
    exec sudo -n -H -u "#$SUDO_UID" env PLUMBLINE_SETUP_DONE=1 bash "$script" "$@"
  fi
}

# Installs what is missing for a preset and for groups of ci/packages, once per invocation: set_up PRESET [GROUP]...
set_up() {
  local with=() group
  case $1 in clang | sanitize | tsan) with=(--with clang) ;; esac
  for group in "${@:2}"; do with+=(--with "$group"); done
  [[ -n ${PLUMBLINE_SETUP_DONE:-} ]] || ci/setup "${with[@]}"
}

# Ubuntu has Chromium as a snap only, which its package cannot bring into a container: tests in a browser are skipped.
has_browser_package() { ! grep -qs '^ID=ubuntu' /etc/os-release; }

# Configures and builds a preset: configure_and_build PRESET [TARGET]...
configure_and_build() {
  say "configure and build: preset $1, build/$1, $jobs jobs"
  cmake --preset "$1"
  cmake --build --preset "$1" --parallel "$jobs" ${2:+--target "${@:2}"}
}
