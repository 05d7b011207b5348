#pragma once
/// What benchmarks measure: time, memory, and what is in the middle of several tries.

#include <algorithm>
#include <ctime>
#include <fstream>
#include <vector>

#include <malloc.h>
#include <unistd.h>

namespace signum::benchmarks {

/// That this process has computed up to now.
inline double seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// What this process takes of the machine's memory; of arrays that lie on pages of their own the
/// heap's own count would include what is left out to reach the next page, and never touched.
inline double bytes_taken() {
    ::malloc_trim(0);
    long all = 0;
    long resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Precondition: there are values. Of an even number the greater one of the two in the middle.
inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

}  // namespace signum::benchmarks
