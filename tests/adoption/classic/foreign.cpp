/// A program as those that the classic names were written for: it declares them itself, with C++
/// linkage, initialises as TetGen does, and divides by what they return. It looks for the Delaunay
/// triangles of points by brute force, and for their circumcentres, and
/// fails where a centre is not as far from all three corners, or where Euler's formula does not
/// hold.

#include <cmath>
#include <cstdio>
#include <vector>

void exactinit(int verbose, int noexact, int nofilter, double x, double y, double z);
double orient2d(double* a, double* b, double* c);
double incircle(double* a, double* b, double* c, double* d);
double orient3d(const double* a, const double* b, const double* c, const double* d);

namespace {

struct Place {
    double x[2];
};

}  // namespace

int main() {
    exactinit(0, 0, 0, 1.0, 1.0, 1.0);
    std::vector<Place> places;
    // Slivers: all within 1e-5 of a line.
    for (int i = 0; i < 24; ++i) places.push_back({{i / 8.0, 1e-7 * (i * i % 29) + i / 24.0}});
    const int n = static_cast<int>(places.size());
    int triangles = 0;
    int wrong = 0;
    std::vector<int> degree(places.size());
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                if (i >= j || i >= k) continue;
                double* a = places[i].x;
                double* b = places[j].x;
                double* c = places[k].x;
                const double area = orient2d(a, b, c);
                if (!(area > 0)) continue;
                bool is_empty = true;
                for (int m = 0; m < n && is_empty; ++m)
                    is_empty = m == i || m == j || m == k || !(incircle(a, b, c, places[m].x) > 0);
                if (!is_empty) continue;
                ++triangles;
                const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
                const double x = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / (2 * area);
                const double y = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / (2 * area);
                const double r = std::hypot(x, y);
                if (!(std::fabs(std::hypot(x - bx, y - by) - r) <= 1e-9 * r)) ++wrong;
                if (!(std::fabs(std::hypot(x - cx, y - cy) - r) <= 1e-9 * r)) ++wrong;
            }
    const double p[3] = {0, 0, 0}, q[3] = {1, 0, 0}, r[3] = {0, 1, 0}, s[3] = {0, 0, -1};
    if (orient3d(p, q, r, s) != 1) ++wrong;
    // Hull corners, counted by their edges: those with all others on one side.
    int hull = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            bool is_edge = i != j;
            for (int k = 0; k < n && is_edge; ++k)
                is_edge = k == i || k == j || orient2d(places[i].x, places[j].x, places[k].x) > 0;
            hull += static_cast<int>(is_edge);
        }
    if (triangles != 2 * n - 2 - hull) ++wrong;
    std::printf("%d triangles, %d hull edges, %d wrong\n", triangles, hull, wrong);
    return wrong != 0;
}
