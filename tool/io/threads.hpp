#pragma once
/// How many threads read and write files: one number of the program, as Options::threads; --threads
/// sets it before anything is read.

namespace signum {

inline int threads_of_files = 0;

}  // namespace signum
