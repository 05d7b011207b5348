# The warnings that every file of the project is clean under.
add_library(signum_warnings INTERFACE)
target_compile_options(signum_warnings INTERFACE -Wall -Wextra -Wconversion
                       $<$<BOOL:${SIGNUM_WERROR}>:-Werror>)
