# What stands behind the multiprecision stages (exact/numbers.hpp): GMP and MPFR or, without any
# library, Boost's integers.
option(SIGNUM_WITH_GMP "Compute with GMP and MPFR; OFF: with Boost's integers, which need no library" ON)
if(SIGNUM_WITH_GMP)
  find_package(GMP REQUIRED)
  find_package(MPFR REQUIRED)
  set(SIGNUM_NUMBERS MPFR::MPFR GMP::GMP)
  set(SIGNUM_NUMBERS_HEADER <boost/multiprecision/gmp.hpp>)
else()
  add_compile_definitions(SIGNUM_WITHOUT_GMP)
  set(SIGNUM_NUMBERS)
  set(SIGNUM_NUMBERS_HEADER <boost/multiprecision/cpp_int.hpp>)
endif()
