# What runs threads (core/parallel.hpp): oneTBB; without it one thread does all.
option(SIGNUM_WITH_TBB "Work on several threads, with oneTBB; OFF: on one, with no library" ON)
# An archive names nothing that it needs: who links it by hand names this library, too.
set(SIGNUM_THREADS)
set(SIGNUM_THREADS_FILE)
if(NOT SIGNUM_WITH_TBB)
  add_compile_definitions(SIGNUM_WITHOUT_TBB)
elseif(NOT SIGNUM_ONLY_PREDICATES)
  find_package(TBB QUIET)
  if(NOT TBB_FOUND)
    message(FATAL_ERROR "signum works on several threads with oneTBB, which is not found: install it (Debian: libtbb-dev) \
or configure with -DSIGNUM_WITH_TBB=OFF for one thread")
  endif()
  set(SIGNUM_THREADS TBB::tbb)
  set(SIGNUM_THREADS_FILE "$<TARGET_FILE:TBB::tbb>")
  # The thread sanitizer does not see how tasks of a library that is compiled without it follow one another: what this file
  # instantiates of them is left out, too, and the file says what follows what.
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=thread")
    set_source_files_properties(core/parallel.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON
                                COMPILE_OPTIONS "-fno-sanitize=thread;-DSIGNUM_THREAD_SANITIZER")
  endif()
endif()
