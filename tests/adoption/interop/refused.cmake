# What is refused when it is compiled, and in which words. Run with COMPILER, INCLUDES (a list of
# flags) and SCRATCH; HEADERS lists the headers of interop/ whose library is there.
cmake_minimum_required(VERSION 3.25)
file(MAKE_DIRECTORY "${SCRATCH}")

# STATEMENTS do not compile, and the compiler says SENTENCE; where that is empty they do.
function(expect header statements sentence)
  get_filename_component(name "${header}" NAME_WE)
  if(NOT name IN_LIST HEADERS)
    return()
  endif()
  file(WRITE "${SCRATCH}/refused.cpp" "#include <signum/interop/${header}>\nint main() {\n${statements}\n}\n")
  execute_process(COMMAND ${COMPILER} -std=c++20 ${INCLUDES} -fsyntax-only "${SCRATCH}/refused.cpp"
                  RESULT_VARIABLE code ERROR_VARIABLE error)
  if(sentence STREQUAL "")
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "should compile:\n${statements}\n${error}")
    endif()
    return()
  endif()
  string(FIND "${error}" "${sentence}" position)
  if(code EQUAL 0 OR position LESS 0)
    message(FATAL_ERROR "should be refused with \"${sentence}\":\n${statements}\n${error}")
  endif()
endfunction()

expect(eigen.hpp "Eigen::MatrixXd m(3, 2); (void)signum::eigen::sites(m);" "")
expect(eigen.hpp "Eigen::MatrixXf m(3, 2); (void)signum::eigen::sites(m);"
       "signum takes sites from matrices of double")
expect(eigen.hpp "Eigen::MatrixXd n(3, 2); (void)signum::eigen::sites(2.0 * n);"
       "signum takes sites from numbers in memory")
expect(boost_geometry.hpp "
using Degrees = boost::geometry::model::point<double, 2, boost::geometry::cs::geographic<boost::geometry::degree>>;
(void)signum::boost_geometry::sites(std::vector<Degrees>());"
       "project longitudes and latitudes first")
