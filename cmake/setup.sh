# What ./run and ./check share: packages and build. Sourced by both; `top` is the root of the source tree.

# Threads that wait should sleep: spinning ones, ours and those of the BLAS, take the cores that the work needs.
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive} OPENBLAS_THREAD_TIMEOUT=${OPENBLAS_THREAD_TIMEOUT:-4}

# Prints the packages of the named sections of packages.txt.
packages() {
  awk -v wanted=" $* " '/^# section:/ {on = index(wanted, " " $3 " ")} /^[^#]/ && on {print $1}' "$top/packages.txt"
}

# Installs the packages of the named sections that are not there yet.
install_packages() {
  if ! command -v dpkg-query apt-get >/dev/null; then
    echo "This is not Debian or Ubuntu: the libraries of packages.txt must be there already." >&2
    return
  fi
  local installed missing
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' 2>/dev/null | awk '$2 == "installed" {print $1}')
  missing=$(packages "$@" | grep -vxF "$installed" | tr '\n' ' ') || true
  [ -n "$missing" ] || return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! sudo -n true 2>/dev/null; then
      echo "Packages are missing. Please type:  sudo apt-get update && sudo apt-get install -y $missing" >&2
      exit 2
    fi
    as_root=(sudo)
  fi
  local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing)
  "${install[@]}" || { "${as_root[@]}" apt-get update && "${install[@]}"; }
}

# build TESTS [TARGET...]: configures build/release where that has not been done, and builds. TESTS is ON or OFF.
build() {
  local folder=$top/build/release tests=$1
  shift
  if [ ! -f "$folder/build.ninja" ] ||
    { [ "$tests" = ON ] && ! grep -q '^SHORELINE_BUILD_TESTS:BOOL=ON$' "$folder/CMakeCache.txt"; }; then
    cmake -S "$top" --preset release -DSHORELINE_BUILD_TESTS="$tests"
  fi
  cmake --build "$folder" --parallel "$(nproc)" ${1:+--target "$@"}
}
