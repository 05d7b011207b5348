#!/usr/bin/env bash
# All of it under the address and undefined-behaviour sanitizers, the tool, the oracles and the tests' own code too:
# builds with the preset sanitize and runs the unit and property tests. ./test puts the library alone under them.
# Half an hour on two cores.
#
#   scripts/sanitize.sh [CTEST_OPTION...]     such as -R io_
#
# Exit code 1 where a test fails, 3 where nothing can be built. JOBS as for scripts/build.sh.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
"$root/scripts/install_dependencies.sh" test
steady=$root/scripts/steady.sh
"$steady" "$root/scripts/build.sh" "$root/build/sanitize" all --preset=sanitize '-DSIGNUM_TEST_LABELS=unit;property'
"$steady" ctest --test-dir "$root/build/sanitize" --no-tests=error --output-on-failure --parallel "${JOBS:-$(nproc)}" "$@" ||
  exit 1
