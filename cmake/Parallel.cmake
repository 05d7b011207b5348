# What runs threads (core/parallel.hpp): oneTBB; without it one thread does all.
option(SIGNUM_WITH_TBB "Work on several threads, with oneTBB; OFF: on one, with no library" ON)
if(SIGNUM_WITH_TBB AND NOT SIGNUM_ONLY_PREDICATES)
  find_package(TBB REQUIRED)
  set_source_files_properties(core/parallel.cpp PROPERTIES COMPILE_DEFINITIONS SIGNUM_WITH_TBB)
  set(SIGNUM_THREADS TBB::tbb)
endif()
