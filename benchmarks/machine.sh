# For run.sh and peers.sh, which source it.

# pin: the command before a program that keeps it on one core, CORE or the last that there is.
pin=()
pinned="not pinned"
if command -v taskset >/dev/null; then
  core=${CORE:-$(taskset -cp $$ | sed 's/.*[ ,-]//')}
  pin=(taskset -c "$core")
  pinned="pinned to one core"
fi

# The machine and the compiler of a build folder, in a line.
describe_machine() {
  local cpu compiler
  cpu=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2>/dev/null | sort -u | head -n 1)
  cpu=${cpu:-$(sysctl -n machdep.cpu.brand_string 2>/dev/null || uname -m)}
  compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' "$1/CMakeCache.txt")
  echo "$cpu, $(getconf _NPROCESSORS_ONLN) cores, $pinned; $(uname -sr); $("$compiler" --version | head -n 1)."
}
