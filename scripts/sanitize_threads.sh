#!/usr/bin/env bash
# Eight threads under the thread sanitizer: builds library and test with the preset tsan, without
# the tool, and runs the test, which must pass and stay silent. Some ten minutes on two cores.
#
#   scripts/sanitize_threads.sh [TEST...]     threads_test and parallel_test by default; any other unit test, too
#
# Exit code 1 where the sanitizer has something to say or a test fails. JOBS as for scripts/build.sh.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
build=$root/build/tsan
[ $# -gt 0 ] || set -- threads_test parallel_test

steady=$root/scripts/steady.sh
for test in "$@"; do
  "$steady" "$root/scripts/build.sh" "$build" "$test" --preset=tsan -DSIGNUM_BUILD_TOOL=OFF \
    -DSIGNUM_TEST_LABELS=unit
done
log=$build/threads.log
# What oneTBB does by itself, which is compiled without the sanitizer: core/parallel.cpp says how tasks follow one another.
echo 'called_from_lib:libtbb.so' >"$build/suppressions"
for test in "$@"; do
  echo "== $test"
  if ! TSAN_OPTIONS="second_deadlock_stack=1 exitcode=66 suppressions=$build/suppressions" "$steady" "$build/tests/$test" >"$log" 2>&1 ||
    grep -q 'ThreadSanitizer' "$log"; then
    cat "$log" >&2
    exit 1
  fi
  grep -E '^\[ *(OK|PASSED) *\]' "$log"
done
