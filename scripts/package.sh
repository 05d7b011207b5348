#!/usr/bin/env bash
# Makes the Debian packages libsignum0.1, libsignum-dev, signum and, where it can be built, python3-signum, and checks
# them: lintian finds no error, dpkg unpacks them into a bare root, and what lies there works.
#
#   scripts/package.sh [BUILD]    BUILD is build/package; the packages lie in BUILD/packages
#
# MAINTAINER is whom they name: NAME <ADDRESS>. CXX chooses the compiler, JOBS how many of them run at a time.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$(realpath -m "${1:-$root/build/package}")
say() { printf 'signum: %s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }

options=(-DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DBUILD_SHARED_LIBS=ON -DSIGNUM_BUILD_TESTS=OFF
  -DSIGNUM_UNITY_BUILD=OFF -DSIGNUM_DEBIAN=ON -DSIGNUM_ZSH_FOLDER=share/zsh/vendor-completions)
[ -z "${MAINTAINER:-}" ] || options+=("-DSIGNUM_MAINTAINER=$MAINTAINER")
python=/usr/bin/python3
with_python=false
if [ -e "$root/bindings/python/CMakeLists.txt" ] && "$python" -c 'import numpy' 2>/dev/null; then
  with_python=true
  options+=(-DSIGNUM_BUILD_PYTHON=ON "-DSIGNUM_PYTHON=$python")
fi
"$root/scripts/build.sh" "$build" all "${options[@]}"

packages=$build/packages
rm -rf "$packages"
(cd "$build" && cpack -B "$packages" >"$build/cpack.log" 2>&1) || { cat "$build/cpack.log" >&2; fail "cpack failed"; }
rm -rf "$packages/_CPack_Packages"
version=$(dpkg-deb -f "$packages"/libsignum-dev_*.deb Version)
architecture=$(dpkg --print-architecture)

if $with_python; then
  # CPack knows one prefix for all; Python's modules have a folder of their own.
  stage=$build/debian/python3-signum.root
  rm -rf "$stage"
  DESTDIR='' cmake --install "$build" --component python --strip --prefix "$stage/usr/lib/python3/dist-packages" >/dev/null
  mkdir -p "$stage/DEBIAN" "$stage/usr/share/doc/python3-signum"
  cp "$build"/debian/libsignum-dev/{copyright,changelog.gz} "$stage/usr/share/doc/python3-signum"
  minor=$("$python" -c 'import sys; print(sys.version_info.minor)')
  cat >"$stage/DEBIAN/control" <<CONTROL
Package: python3-signum
Version: $version
Section: python
Priority: optional
Architecture: $architecture
Maintainer: $(dpkg-deb -f "$packages"/libsignum-dev_*.deb Maintainer)
Depends: libsignum${version%.*} (= $version), python3 (>= 3.$minor), python3 (<< 3.$((minor + 1))), python3-numpy, libc6, libgcc-s1, libstdc++6
Description: Exact signs, and the tessellations built on them
 Signs of geometric predicates that are right for all finite doubles,
 tessellations and Voronoi diagrams in four metrics, for arrays of NumPy.
CONTROL
  find "$stage" -type d -exec chmod 755 {} +
  find "$stage/usr" -type f -exec chmod 644 {} +
  dpkg-deb --root-owner-group -Zxz --build "$stage" "$packages/python3-signum_${version}_$architecture.deb" >/dev/null
fi

lintian --allow-root "$packages"/*.deb | tee "$build/lintian.log" || true
! grep -q '^E:' "$build/lintian.log" || fail "lintian finds errors"

# A bare root: nothing in it but dpkg's own files, and then these packages.
bare=$(mktemp -d)
trap 'rm -rf "$bare"' EXIT
mkdir -p "$bare"/var/lib/dpkg/{info,updates,triggers} "$bare/tmp"
touch "$bare/var/lib/dpkg/status"
dpkg --root="$bare" --force-not-root --unpack "$packages"/*.deb >"$build/dpkg.log" 2>&1 || { cat "$build/dpkg.log" >&2; fail "dpkg does not unpack them"; }
dpkg --root="$bare" --verify || fail "dpkg finds files that differ"
libraries=$bare/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
[ "$("$bare/usr/bin/signum" --version)" = "signum $version" ] || fail "the tool does not run"
[ "$("$bare/usr/bin/signum" sign ccw -- 0.1 0.2 0.3 0.4 0.8 0.9 2>/dev/null)" = "-1 exact" ] || fail "the tool errs"
cat >"$bare/tmp/first.cpp" <<'PROGRAM'
#include <cstdio>
#include <signum/predicates/ccw.hpp>
int main() { std::printf("%d\n", signum::ccw({0.1, 0.2}, {0.3, 0.4}, {0.8, 0.9})); }
PROGRAM
flags=$(PKG_CONFIG_PATH=$libraries/pkgconfig pkg-config --cflags --libs signum)
# shellcheck disable=SC2086
"${CXX:-g++}" -std=c++20 "$bare/tmp/first.cpp" -o "$bare/tmp/first" $flags
[ "$(LD_LIBRARY_PATH=$libraries "$bare/tmp/first")" = -1 ] || fail "a program against libsignum-dev errs"
MANPATH=$bare/usr/share/man man -l "$bare/usr/share/man/man1/signum.1.gz" >/dev/null 2>"$build/man.log" || fail "no manual page"
if $with_python; then
  [ "$(LD_LIBRARY_PATH=$libraries PYTHONPATH=$bare/usr/lib/python3/dist-packages "$python" -c \
    'import signum; print(signum.ccw((0.1, 0.2), (0.3, 0.4), (0.8, 0.9)))')" = -1 ] || fail "the module errs"
fi
say "$(cd "$packages" && ls ./*.deb | tr '\n' ' ')work in a bare root"
