#!/usr/bin/env bash
# Lines and branches of core/, exact/, filters/ and predicates/ that the tests come by: builds library
# and tests with g++'s counters in build/coverage, runs the tests, and lets gcovr add up.
#
#   scripts/coverage.sh [TEST...]     by default those below; any other of tests/unit and tests/property, too
#
# Writes build/coverage/report.html and prints a table of folders and what no test came by. A branch that
# only an exception takes is not counted: of predicates none throws but out of memory, which ends the
# program. Exit code 1 where lines or branches of a folder are below 95 %. Half an hour on two cores.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
build=$root/build/coverage
least=95
[ $# -gt 0 ] || set -- additive_names_test allocations_test cut_dyadic_test dyadic_test elementary_test error_free_test \
  expansion_test handles_test interval_test multiprecision_test predicates_stages_test sign_of_sum_test sum_test \
  arithmetic_test balls_predicates_test euclidean_predicates_test hard_cases_test power_canonical_test \
  additive_canonical_test predicates_test rectangular_predicates_test rectangular_space_test space_predicates_test \
  any_dimension_predicates_test naive_test spatial_test ball_diagram_test record_test

say() { printf 'signum: %s\n' "$*" >&2; }
command -v gcovr >/dev/null || { say "this needs gcovr (apt-get install gcovr)"; exit 3; }

# Not inlined, so that a line of a header is counted where it is written; without contracts, whose
# failing branches no test may take.
for test in "$@"; do
  CXX=g++ "$root/scripts/build.sh" "$build" "$test" -DCMAKE_BUILD_TYPE=Debug '-DCMAKE_CXX_FLAGS_DEBUG=-DNDEBUG' \
    '-DCMAKE_CXX_FLAGS=-O1 -fno-inline -g1 --coverage -fprofile-update=atomic' -DSIGNUM_BUILD_TOOL=OFF \
    '-DSIGNUM_TEST_LABELS=unit;property'
done
find "$build" -name '*.gcda' -delete
for test in "$@"; do
  echo "== $test"
  program=$(find "$build/tests" "$build/fuzz" -maxdepth 2 -type f -name "$test" -perm -u+x | head -n 1)
  "$program" --gtest_brief=1 || exit 1
done

measure() {  # FOLDER OPTION...
  local folder=$1
  shift
  gcovr --root "$root" --object-directory "$build" --filter "$root/$folder/" --exclude-throw-branches \
    --exclude-unreachable-branches "$@" "$build"
}
measure '(core|exact|filters|predicates)' --html-details "$build/report.html" >/dev/null
below=0
for folder in core exact filters predicates; do
  summary=$(measure "$folder" --json-summary --json-summary-pretty)
  lines=$(sed -n 's/^ *"line_percent": \([0-9.]*\),*$/\1/p' <<<"$summary" | tail -n 1)
  branches=$(sed -n 's/^ *"branch_percent": \([0-9.]*\),*$/\1/p' <<<"$summary" | tail -n 1)
  echo "$folder: lines $lines %, branches $branches %"
  awk -v l="$lines" -v b="$branches" -v least=$least 'BEGIN { exit !(l < least || b < least) }' && below=1
done
exit $below
