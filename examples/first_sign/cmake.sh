#!/bin/sh -e
cat >first.cpp <<'END'
#include <cstdio>
#include <signum/predicates/ccw.hpp>
int main() { std::printf("%d\n", signum::ccw({0.1, 0.2}, {0.3, 0.4}, {0.8, 0.9})); }  // doubles say 1
END
printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(first LANGUAGES CXX)' 'find_package(signum REQUIRED)' \
  'add_executable(first first.cpp)' 'target_link_libraries(first PRIVATE signum::signum)' >CMakeLists.txt
cmake -B build -DCMAKE_PREFIX_PATH="${PREFIX:-/usr/local}" >log && cmake --build build >>log
build/first
