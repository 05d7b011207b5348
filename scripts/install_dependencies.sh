#!/usr/bin/env bash
# Installs what is missing: on Debian and its relatives with apt-get, and only as root.
#
#   scripts/install_dependencies.sh [build|test|benchmark|mpi|peers]
#
# build      what the library and the tool need (the default)
# test       the same, and what the tests need
# benchmark  the same as build, and what the benchmarks need, the peers in space included
# mpi        the same as build, and what signum-mpi needs (docs/scale.md)
# peers      the same as test, and what scripts/museum.py and scripts/torture_peers.sh ask, and other
#            compilers and systems for the two files of single/
#
# Quiet and quick when everything is there. Otherwise and not as root: prints the one line to type and
# ends with exit code 3, as it does where the compiler is too old.
set -euo pipefail

oldest_gcc=12
oldest_clang=14
build=(g++ cmake ninja-build libgmp-dev libmpfr-dev libboost-dev libtbb-dev libhwy-dev libcli11-dev libfmt-dev nlohmann-json3-dev libtomlplusplus-dev zlib1g-dev gemmi-dev tao-pegtl-dev)
python=(python3-dev pybind11-dev python3-numpy python3-scipy python3-pytest python3-matplotlib python3-pandas
  python3-shapely python3-geopandas python3-nbclient python3-nbformat python3-ipykernel
  python3-pip mypy)
test=("${build[@]}" libgtest-dev librapidcheck-dev gnuplot-nox valgrind gappa doxygen libeigen3-dev libcgal-dev pkg-config librsvg2-bin dpkg-dev
  lintian "${python[@]}")
# The last three are the peers in space.
benchmark=("${build[@]}" libbenchmark-dev libcgal-dev voro++-dev voronota)
mpi=("${build[@]}" pkg-config openmpi-bin libopenmpi-dev libhdf5-openmpi-dev)
peers=("${test[@]}" python3-vtk9 libtet1.5-dev libgeos-dev libjts-java default-jdk-headless npm gfortran g++-multilib g++-mingw-w64-x86-64 wine64)

say() { printf 'signum: %s\n' "$*" >&2; }

# Whether something does what a package is for, whoever installed it.
probe() {
  case $1 in
    g++) command -v "${CXX:-g++}" >/dev/null || command -v clang++ >/dev/null ;;
    cmake) command -v cmake >/dev/null ;;
    ninja-build) command -v ninja >/dev/null ;;
    gappa | doxygen | valgrind | lintian) command -v "$1" >/dev/null ;;
    gnuplot-nox) command -v gnuplot >/dev/null ;;
    npm | gfortran) command -v "$1" >/dev/null ;;
    default-jdk-headless) command -v javac >/dev/null ;;
    voronota) command -v voronota >/dev/null ;;
    *) dpkg-query -W -f '${db:Status-Status}\n' "$1" 2>/dev/null | grep -qx installed ;;
  esac
}

# The compiler that CMake will take: CXX, else g++, else clang++.
check_compiler() {
  local compiler=${CXX:-g++} macros major
  command -v "$compiler" >/dev/null || compiler=clang++
  macros=$("$compiler" -dM -E -x c++ /dev/null) || {
    say "$compiler does not work; set CXX to g++ $oldest_gcc or later, or clang++ $oldest_clang or later"
    exit 3
  }
  major() { sed -n "s/^#define $1 //p" <<<"$macros"; }
  if grep -q '__clang_major__' <<<"$macros"; then
    [ "$(major __clang_major__)" -ge "$oldest_clang" ] && return
  else
    [ "$(major __GNUC__)" -ge "$oldest_gcc" ] && return
  fi
  say "$("$compiler" --version | head -n 1) is too old: set CXX to g++ $oldest_gcc or later, or" \
      "clang++ $oldest_clang or later"
  exit 3
}

case ${1:-build} in
  -h | --help)
    sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//p}' "$0"
    exit 0
    ;;
  build) wanted=("${build[@]}") ;;
  test) wanted=("${test[@]}") ;;
  benchmark) wanted=("${benchmark[@]}") ;;
  mpi) wanted=("${mpi[@]}") ;;
  peers) wanted=("${peers[@]}") ;;
  *)
    say "install_dependencies.sh: '$1' is none of build, test, benchmark, mpi, peers"
    exit 2
    ;;
esac

missing=()
for package in "${wanted[@]}"; do
  probe "$package" || missing+=("$package")
done

if [ ${#missing[@]} -gt 0 ]; then
  if ! command -v apt-get >/dev/null; then
    if command -v "${CXX:-g++}" >/dev/null && command -v cmake >/dev/null && command -v ninja >/dev/null; then
      # Not Debian: nobody to ask for libraries. CMake says what it does not find.
      check_compiler
      exit 0
    fi
    say "there is no apt-get here; install what Debian calls ${missing[*]}"
    exit 3
  fi
  line="apt-get install --no-install-recommends ${missing[*]}"
  if [ "$(id -u)" -ne 0 ]; then
    say "some packages are missing; as root type:"
    say "  $line"
    exit 3
  fi
  say "installing ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  log=$(mktemp)
  trap 'rm -f "$log"' EXIT
  # The lists of packages may be missing or old: then they are fetched, once.
  if ! apt-get install -y -q --no-install-recommends "${missing[@]}" >"$log" 2>&1 &&
     ! { apt-get update -q && apt-get install -y -q --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    say "could not install them; the line was"
    say "  $line"
    exit 3
  fi
fi
check_compiler
