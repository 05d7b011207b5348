#!/usr/bin/env bash
# The program of machines/ prints what it must in every floating-point environment that there is here.
# scripts/machines.sh asks other compilers, flags and machines.
set -uo pipefail
signs=$1
expected=$(dirname "${BASH_SOURCE[0]}")/machines/signs.txt
asked=0
for environment in nearest upward downward zero flush; do
  output=$("$signs" "$environment")
  code=$?
  [ "$environment" != nearest ] && [ $code -eq 3 ] && continue
  if [ $code -ne 0 ] || ! diff <(echo "$output") "$expected"; then
    echo "signs $environment: exit code $code, or other signs than $expected has"
    exit 1
  fi
  asked=$((asked + 1))
done
echo "the same signs in $asked environments"
