# What the library is to those who link it: signum::predicates, a static one of the predicates alone; signum::signum,
# all of it, static or shared as BUILD_SHARED_LIBS says. Beside a
# shared one, which exports its interface alone (packaging/exports.map), there is a static one of the same objects,
# signum::signum_static. signum_internals is the one that has every name: for the tool and the tests.

# The same objects for a static library, for a shared one and for a module of Python; who calls one of our functions
# from another gets ours.
function(compile_as_library target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON DEFINE_SYMBOL "")
  target_compile_options(${target} PRIVATE -fno-semantic-interposition ${SIGNUM_IEEE_OPTIONS})
endfunction()

# NAME: what it is called behind signum::. Who links it needs the other libraries, not the warnings and not Boost,
# which is headers alone.
function(describe_library target name)
  if(NOT name STREQUAL "")
    add_library(signum::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  endif()
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PRIVATE ${ARGN} $<BUILD_INTERFACE:signum_warnings> $<BUILD_INTERFACE:Boost::headers>)
endfunction()

# From nothing a fifth of the time goes into reading the same headers.
set(headers_of_numbers <algorithm> <array> <cmath> <functional> <optional> <span> <stdexcept> <string> <vector>
                       ${SIGNUM_NUMBERS_HEADER})
add_library(signum_signs OBJECT ${predicate_sources})
compile_as_library(signum_signs)
describe_library(signum_signs "" ${SIGNUM_INTEGERS})
if(SIGNUM_UNITY_BUILD OR SIGNUM_ONLY_PREDICATES)
  target_precompile_headers(signum_signs PRIVATE ${headers_of_numbers})
endif()
add_library(signum_predicates STATIC $<TARGET_OBJECTS:signum_signs>)
describe_library(signum_predicates predicates ${SIGNUM_INTEGERS})
set_target_properties(signum_predicates PROPERTIES LINKER_LANGUAGE CXX)
if(SIGNUM_ONLY_PREDICATES)
  return()
endif()

# Of a text that several sources compile a program gets the first that its linker takes out of the library. Predicates
# come first, so that who asks for no more is given no more. After them who calls comes before who is called: or else
# distributed/, which calls the same insertion as construction/, would come before it.
list(REVERSE library_sources)
add_library(signum $<TARGET_OBJECTS:signum_signs> ${library_sources})
compile_as_library(signum)
describe_library(signum signum ${SIGNUM_NUMBERS} ${SIGNUM_THREADS} Threads::Threads)
if(SIGNUM_UNITY_BUILD)
  target_precompile_headers(signum REUSE_FROM signum_signs)
endif()
# g++ 12 says of an optional integer of Boost's, where there is none, that its digits were never set.
if(NOT SIGNUM_WITH_GMP AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set_source_files_properties(motion/wall_strike.cpp PROPERTIES COMPILE_OPTIONS -Wno-maybe-uninitialized)
endif()
# Before version 1 a minor version may break: it is part of the name.
set_target_properties(signum PROPERTIES VERSION ${PROJECT_VERSION}
                      SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

set(exports "${PROJECT_SOURCE_DIR}/packaging/exports.map")
include(CheckLinkerFlag)
check_linker_flag(CXX "LINKER:--version-script=${exports}" SIGNUM_HAS_VERSION_SCRIPTS)
if(BUILD_SHARED_LIBS AND SIGNUM_HAS_VERSION_SCRIPTS AND NOT SIGNUM_EXPORT_ALL)
  target_link_options(signum PRIVATE "LINKER:--version-script=${exports}" "LINKER:-Bsymbolic-functions")
  set_target_properties(signum PROPERTIES LINK_DEPENDS "${exports}")
  add_library(signum_static STATIC $<TARGET_OBJECTS:signum_signs> $<TARGET_OBJECTS:signum>)
  describe_library(signum_static signum_static ${SIGNUM_NUMBERS} ${SIGNUM_THREADS} Threads::Threads)
  set_target_properties(signum_static PROPERTIES OUTPUT_NAME signum LINKER_LANGUAGE CXX)
  add_library(signum_internals ALIAS signum_static)
else()
  add_library(signum_internals ALIAS signum)
endif()
