#!/usr/bin/env bash
# `cmake --install` finds all it looks for where ./run has built, and README says where that is.
set -euo pipefail
fail() { echo "$1"; exit 1; }

line=$(grep 'scripts/build.sh' "$SOURCES/run") || fail "./run calls scripts/build.sh no more"
read -r folder target options < <(sed -E 's|.*"\$root/(build/[a-z]+)" ([a-z_]+)(.*)|\1 \2\3|' <<<"$line")
grep -q "cmake --install $folder --prefix" "$SOURCES/README.md" ||
  fail "README does not say that ./run builds in $folder"

# Configured as ./run does; what the target comes to, Ninja knows without building it.
command -v ninja >/dev/null || { echo "no Ninja"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
read -ra given <<<"$options"
cmake -S "$SOURCES" -B "$scratch" -G Ninja -DCMAKE_CXX_COMPILER="$CXX" "${given[@]}" >/dev/null
ninja -C "$scratch" -t commands "$target" >"$scratch/plan"
wanted=0
while read -r product; do
  # What configuring has written is there.
  [ -e "$product" ] && continue
  wanted=$((wanted + 1))
  grep -qF "${product#"$scratch"/}" "$scratch/plan" || fail "installed, but not built by $target: $product"
done < <(find "$scratch" -name cmake_install.cmake -exec grep -ho "\"$scratch/[^\"$]*\"" {} + | tr -d '"' | sort -u)
[ "$wanted" -ge 3 ] || fail "only $wanted products are installed"
echo "$wanted products"
