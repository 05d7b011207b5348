#!/usr/bin/env bash
# Installs the build tree into an empty prefix, and moves that to PREFIX. What was installed is what a user looks for.
set -euo pipefail
first=$(dirname "$PREFIX")/first
rm -rf "$first" "$PREFIX"
cmake --install "$BUILD" --prefix "$first" >/dev/null
mv "$first" "$PREFIX"

cd "$PREFIX"
wanted=(include/signum/signum.hpp include/signum/predicates/ccw.hpp lib/libsignum.* lib/pkgconfig/signum.pc
  lib/cmake/signum/signum-config.cmake share/doc/signum/LICENSE)
if [ -e "$BUILD/cli/signum" ]; then
  wanted+=(bin/signum share/man/man1/signum.1 share/bash-completion/completions/signum share/zsh/site-functions/_signum)
fi
for file in "${wanted[@]}"; do
  [ -s "$file" ] || { echo "not installed, or empty: $file"; exit 1; }
done
# No file names the folder that it was built or first installed in.
if grep -rlF -e "$BUILD" -e "$first" --include='*.cmake' --include='*.pc' --include='*.hpp' .; then
  echo "these know where they were made"
  exit 1
fi
echo "$(find . -type f | wc -l) files"
