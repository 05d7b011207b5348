#!/usr/bin/env bash
# Lines and branches of core/, exact/, filters/ and predicates/ that the tests come by: builds library
# and tests with g++'s counters in build/coverage, runs the tests, and adds up (scripts/covered.py).
#
#   scripts/coverage.sh [TEST...]     by default those below; any other of tests/unit and tests/property, too
#
# Prints a table of folders and, below each, what no test came by. Exit code 1 where lines or branches of a
# folder are below 95 %. Half an hour on two cores.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
build=$root/build/coverage
[ $# -gt 0 ] || set -- additive_names_test allocations_test ball_bounds_test cut_dyadic_test dyadic_test elementary_test \
  environments_test error_free_test expansion_test filter_windows_test handles_test interval_test meeting_filter_test \
  multiprecision_test pages_test polynomial_test predicates_stages_test real_roots_test rectangular_bounds_test \
  sign_of_sum_test space_bounds_test sum_test tessellation_test tie_rule_test wide_test \
  arithmetic_test balls_predicates_test euclidean_predicates_test hard_cases_test power_canonical_test \
  additive_canonical_test predicates_test rectangular_predicates_test rectangular_space_test space_predicates_test \
  any_dimension_predicates_test naive_test spatial_test

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

"$root/scripts/covered.py" "$build"
