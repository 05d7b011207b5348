#!/usr/bin/env bash
# Fuzzes the targets of fuzz/targets, as long as is asked for, and goes on from where it was.
#
#   scripts/fuzz.sh TARGET[,TARGET...]|all SECONDS [--afl]
#
# SECONDS, 3 or more, are for each target, of a processor (with --afl of the clock), so that other work beside it takes
# nothing from them. libFuzzer with the address and undefined-behaviour sanitizers; with --afl AFL++, with the
# same. What it finds and its growing corpus lie in build/fuzz (FUZZ names another folder):
#
#   build/fuzz/TARGET/corpus/   what covers new code; the next run begins with it, and with fuzz/corpus/TARGET
#   build/fuzz/TARGET/found/    inputs for which the promise does not hold
#   build/fuzz/TARGET/log       what the fuzzer said
#   build/fuzz/runs.tsv         a line for each run: when, engine, target, seconds, executions, places covered,
#                               inputs, found
#
# Exit code 1 when there is anything in found/, 3 when a fuzzer does not run.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Into `spent`, seconds of the processor for the programs that have ended.
clock() {
  times >"$here/times" # a shell of its own would have none
  spent=$(awk 'NR == 2 { gsub(/[ms]/, " "); print int($1 * 60 + $2 + $3 * 60 + $4) }' "$here/times")
}
say() { printf 'signum: %s\n' "$*" >&2; }
usage() {
  sed -n '2,/^set/p' "${BASH_SOURCE[0]}" | sed '$d; s/^# \{0,1\}//' >&2
  exit 2
}

[ $# -ge 2 ] || usage
target=$1
seconds=$2
engine=libfuzzer
[ "${3:-}" = --afl ] && engine=afl
[[ $seconds =~ ^[0-9]+$ ]] && [ "$seconds" -gt 2 ] || usage # the last two seconds are not asked for
if [ "$target" = all ]; then
  mapfile -t targets < <(cd "$root/fuzz/corpus" && ls)
else
  IFS=, read -r -a targets <<<"$target"
  for each in "${targets[@]}"; do
    [ -d "$root/fuzz/corpus/$each" ] || { say "there is no target $each"; exit 2; }
  done
fi

flags='-DFUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION -O1 -g1 -fno-omit-frame-pointer -fno-sanitize-recover=all -fsanitize=address,undefined,float-cast-overflow'
case $engine in
  libfuzzer)
    for compiler in clang++-14 clang++; do command -v "$compiler" >/dev/null && break; done
    flags+=,fuzzer-no-link
    needs='clang and its fuzzer runtime (libclang-rt-14-dev)'
    ;;
  afl)
    compiler=afl-clang-fast++
    needs='AFL++ (afl++)'
    ;;
esac
command -v "$compiler" >/dev/null || { say "this needs $needs"; exit 3; }

build=$root/build/fuzz-$engine
for each in "${targets[@]}"; do # all before the first one runs
  CXX=$(command -v "$compiler") "$root/scripts/build.sh" "$build" "fuzz_$each" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE= "-DCMAKE_CXX_FLAGS=$flags" -DSIGNUM_BUILD_TESTS=OFF "-DSIGNUM_FUZZ_ENGINE=$engine"
done

folder=${FUZZ:-$root/build/fuzz}
found=0
for each in "${targets[@]}"; do
  here=$folder/$each
  mkdir -p "$here/corpus" "$here/found"
  program=$build/fuzz/targets/fuzz_$each
  dictionary=$root/fuzz/dictionaries/$each.dict
  say "$each: $seconds s with $engine"
  if [ "$engine" = libfuzzer ]; then
    options=(-max_len=65536 -timeout=900 -report_slow_units=900 -rss_limit_mb=2048 -print_final_stats=1
             -artifact_prefix="$here/found/")
    [ -f "$dictionary" ] && options+=(-dict="$dictionary")
    executions=0
    used=0
    known=$(find "$here/found" -type f | wc -l)
    clock
    begin=$spent
    # Its own limit is of the clock. What it leaves is asked for again, but for the last seconds.
    while [ $((seconds - used)) -gt 2 ] && [ "$(find "$here/found" -type f | wc -l)" -eq "$known" ]; do
      nice -n 19 "$program" -max_total_time=$((seconds - used)) "${options[@]}" "$here/corpus" "$root/fuzz/corpus/$each" \
        </dev/null >"$here/log" 2>&1 || true
      executed=$(sed -n 's/^stat::number_of_executed_units: *//p' "$here/log")
      [ -n "$executed" ] || break # it did not come to its end
      executions=$((executions + executed))
      clock
      used=$((spent - begin))
    done
    covered=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$here/log" | tail -n 1)
  else
    options=(-V "$seconds" -m none -t 5000)
    [ -f "$dictionary" ] && options+=(-x "$dictionary")
    AFL_AUTORESUME=1 AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_NO_AFFINITY=1 \
      nice -n 19 afl-fuzz "${options[@]}" -i "$root/fuzz/corpus/$each" -o "$here/afl" -- "$program" \
      </dev/null >"$here/log" 2>&1 || { tail -n 20 "$here/log" >&2; exit 3; }
    used=$seconds
    state=$here/afl/default/fuzzer_stats
    executions=$(sed -n 's/^execs_done *: *//p' "$state")
    covered=$(sed -n 's/^edges_found *: *//p' "$state")
    cp "$here"/afl/default/queue/id* "$here/corpus/"
    for one in "$here"/afl/default/{crashes,hangs}/id*; do
      [ -f "$one" ] && cp "$one" "$here/found/"
    done
  fi
  count=$(find "$here/found" -type f | wc -l)
  printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$(date -u +%FT%TZ)" "$engine" "$each" "$used" "${executions:-0}" \
    "${covered:-0}" "$(find "$here/corpus" -type f | wc -l)" "$count" | tee -a "$folder/runs.tsv"
  if [ "$engine" = libfuzzer ] && [ -z "$executed" ] && [ "$count" -eq "$known" ]; then
    tail -n 20 "$here/log" >&2
    say "$each: the fuzzer came to no end, and found nothing"
    exit 3
  fi
  if [ "$count" -gt 0 ]; then
    say "$each: $count inputs in $here/found; $here/log says what they broke"
    found=1
  fi
done
exit "$found"
