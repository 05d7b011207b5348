#!/bin/sh -e
: "${PREFIX:=/usr/local}"
cat >first.c <<'END'
#include <signum/signum.h>
#include <stdio.h>
int main(void) { printf("%d\n", signum_ccw((const double[]){0.1, 0.2}, (const double[]){0.3, 0.4}, (const double[]){0.8, 0.9})); }
END
flags=$(PKG_CONFIG_PATH="$PREFIX/lib/pkgconfig" pkg-config --cflags --libs signum)
"${CC:-cc}" first.c -o first $flags -Wl,-rpath,"$PREFIX/lib"
./first
