#!/bin/sh -e
: "${PREFIX:=/usr/local}"
cat >first.cpp <<'END'
#include <cstdio>
#include <signum/predicates/ccw.hpp>
int main() { std::printf("%d\n", signum::ccw({0.1, 0.2}, {0.3, 0.4}, {0.8, 0.9})); }  // doubles say 1
END
flags=$(PKG_CONFIG_PATH="$PREFIX/lib/pkgconfig" pkg-config --cflags --libs signum)
"${CXX:-g++}" -std=c++20 first.cpp -o first $flags -Wl,-rpath,"$PREFIX/lib"
./first
