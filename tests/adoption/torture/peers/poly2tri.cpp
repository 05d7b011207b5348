// jhasse/poly2tri: left, right or collinear.
#include <poly2tri/poly2tri/common/shapes.h>

#include <poly2tri/poly2tri/common/utils.h>

#include <poly2tri/poly2tri/common/shapes.cc>

extern "C" int orient2d(const double* a, const double* b, const double* c) {
    const p2t::Orientation turn =
        p2t::Orient2d(p2t::Point(a[0], a[1]), p2t::Point(b[0], b[1]), p2t::Point(c[0], c[1]));
    return turn == p2t::CCW ? 1 : turn == p2t::CW ? -1 : 0;
}
