/* Every predicate: a sign of each kind, a tie, and what is refused. */

#include <math.h>
#include <signum/signum.h>

#include "expect.h"

static const double nothing[4] = {0, NAN, 0, 0};

static void of_the_plane(void) {
    const double a[] = {0, 0, 0}, b[] = {8, 1, 0}, c[] = {2, 7, 0};
    const double inside[] = {3, 2, 0}, on[] = {4, 4, 0}, outside[] = {9, 90, 0};
    const double right[] = {4, 0, 0}, up[] = {0, 4, 0}; /* on is on the circle of a, right and up */
    const double below[] = {2, -1, 0}, beyond[] = {16, 2, 0}, small[] = {0, 0, -1};
    const double tied[] = {0x1p-60, 0x1p-60}, far[] = {0x1p60, 0x1p60}, beside[] = {1, 1 + 0x1p-52};
    signum_metric metric;

    EXPECT(signum_ccw(a, b, c) == 1);
    EXPECT(signum_ccw(b, a, c) == -1);
    EXPECT(signum_ccw(a, b, beyond) == 0);
    EXPECT(signum_ccw(tied, far, beside) == 1);
    {
        const double rows[] = {0, 0, 4, 0, 0, 3};
        const double ends[] = {1, 0, 4, 1, 9, 9};
        const double last[] = {0, 1, 4, 5, 0, 0};
        const double inside[] = {0.25, 0.25, 0, 0, 1, 1};
        int8_t signs[3] = {7, 7, 7};
        EXPECT(signum_ccw_batch(rows, ends, last, 3, signs) == 0);
        for (int m = 0; m < 3; ++m)
            EXPECT(signs[m] == signum_ccw(rows + 2 * m, ends + 2 * m, last + 2 * m));
        EXPECT(signum_in_circle_points_batch(rows, ends, last, inside, 1, signs) == 0 && signs[0] == 1);
        EXPECT(signum_ccw_batch(rows, ends, NULL, 3, signs) == SIGNUM_NO_SIGN);
        EXPECT(signum_ccw_batch(rows, nothing, last, 1, signs) == SIGNUM_NO_SIGN);
        EXPECT(signum_ccw_batch(NULL, NULL, NULL, 0, NULL) == 0);
    }
    EXPECT(signum_ccw(a, b, NULL) == SIGNUM_NO_SIGN);
    EXPECT(signum_ccw(a, nothing, c) == SIGNUM_NO_SIGN);

    for (metric = SIGNUM_POWER; metric <= SIGNUM_SUPREMUM; ++metric) {
        const int32_t ranks[4] = {0, 1, 2, 3};
        EXPECT(signum_exists(metric, a, b, c) == 1);
        EXPECT(signum_exists(metric, b, a, c) == 0);
        EXPECT(signum_exists(metric, a, b, nothing) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle(metric, a, b, c, inside) == 1);
        EXPECT(signum_in_circle(metric, a, b, c, outside) == -1);
        EXPECT(signum_in_circle(metric, a, b, c, nothing) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle_infinite(metric, a, b, outside) == -1);
        EXPECT(signum_in_circle_infinite(metric, a, b, NULL) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle_perturbed(metric, a, b, c, inside, ranks) == 1);
        EXPECT(signum_in_circle_perturbed(metric, a, b, c, outside, ranks) == -1);
        EXPECT(signum_in_circle_perturbed(SIGNUM_POWER, a, right, up, on, ranks) != 0);
        EXPECT(signum_in_circle_perturbed(metric, a, b, c, on, NULL) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle_infinite_perturbed(metric, a, b, outside, ranks) == -1);
        EXPECT(signum_in_circle_infinite_perturbed(metric, a, b, outside, NULL) == SIGNUM_NO_SIGN);
        EXPECT(signum_hidden(metric, small, a) == (metric != SIGNUM_POWER));
        EXPECT(signum_hidden(metric, a, b) == 0);
        EXPECT(signum_hidden(metric, NULL, b) == SIGNUM_NO_SIGN);
        EXPECT(signum_nearer(metric, inside, a, outside) == 1);
        EXPECT(signum_nearer(metric, inside, outside, a) == -1);
        EXPECT(signum_nearer(metric, nothing, a, outside) == SIGNUM_NO_SIGN);
    }
    EXPECT(signum_in_circle(SIGNUM_POWER, a, right, up, on) == 0);
    EXPECT(signum_in_circle(SIGNUM_EUCLIDEAN, a, right, up, on) == 0);
    EXPECT(signum_in_circle_infinite(SIGNUM_POWER, a, b, below) == 1);
    EXPECT(signum_in_circle_infinite(SIGNUM_EUCLIDEAN, a, b, below) == 1);
    EXPECT(signum_hidden(SIGNUM_POWER, a, small) == 1);
    EXPECT(signum_nearer(SIGNUM_POWER, inside, a, a) == 0);
    for (metric = -1; metric <= 4; metric += 5) {
        const int32_t ranks[4] = {0, 1, 2, 3};
        EXPECT(signum_exists(metric, a, b, c) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle(metric, a, b, c, on) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle_infinite(metric, a, b, on) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle_perturbed(metric, a, b, c, on, ranks) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle_infinite_perturbed(metric, a, b, c, ranks) == SIGNUM_NO_SIGN);
        EXPECT(signum_hidden(metric, a, b) == SIGNUM_NO_SIGN);
        EXPECT(signum_nearer(metric, on, a, b) == SIGNUM_NO_SIGN);
    }

    EXPECT(signum_in_circle_points(a, b, c, inside) == 1);
    EXPECT(signum_in_circle_points(a, right, up, on) == 0);
    EXPECT(signum_in_circle_points(a, b, c, nothing) == SIGNUM_NO_SIGN);
    EXPECT(signum_in_circle_infinite_points(a, b, below) == 1);
    EXPECT(signum_in_circle_infinite_points(a, b, beyond) == -1);
    EXPECT(signum_in_circle_infinite_points(NULL, b, below) == SIGNUM_NO_SIGN);
    /* A weight of -1 is no radius. */
    {
        const double light[] = {4, 4, -1}, heavy[] = {4, 4, 1}, lightest[] = {0, 0, -1};
        EXPECT(signum_in_circle_weights(a, right, up, light) == -1);
        EXPECT(signum_in_circle_weights(a, right, up, heavy) == 1);
        EXPECT(signum_in_circle_weights(a, right, up, on) == 0);
        EXPECT(signum_in_circle_weights(a, right, up, nothing) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_circle_infinite_weights(a, b, below) == 1);
        EXPECT(signum_in_circle_infinite_weights(a, nothing, below) == SIGNUM_NO_SIGN);
        EXPECT(signum_hidden_weights(lightest, a) == 1);
        EXPECT(signum_hidden_weights(a, lightest) == 0);
        EXPECT(signum_hidden_weights(a, NULL) == SIGNUM_NO_SIGN);
        EXPECT(signum_nearer_weights(on, light, heavy) == -1);
        EXPECT(signum_nearer_weights(on, light, light) == 0);
        EXPECT(signum_nearer_weights(on, light, nothing) == SIGNUM_NO_SIGN);
    }
}

static void of_space(void) {
    const double i[] = {0, 0, 0, 0}, j[] = {4, 0, 0, 0}, k[] = {0, 4, 0, 0}, l[] = {0, 0, 4, 0};
    const double inside[] = {1, 1, 1, 0}, on[] = {4, 4, 4, 0}, outside[] = {9, 9, 9, 0};
    const double flat[] = {4, 4, 0, 0}, small[] = {0, 0, 0, -1}, heavy[] = {4, 4, 4, 1};
    signum_metric metric;

    EXPECT(signum_ccw_space(i, j, k, l) == 1);
    EXPECT(signum_ccw_space(j, i, k, l) == -1);
    EXPECT(signum_ccw_space(i, j, k, flat) == 0);
    EXPECT(signum_ccw_space(i, j, k, NULL) == SIGNUM_NO_SIGN);
    for (metric = SIGNUM_POWER; metric <= SIGNUM_EUCLIDEAN; ++metric) {
        EXPECT(signum_spheres(metric, i, j, k, l) == 1);
        EXPECT(signum_spheres(metric, j, i, k, l) == 0);
        EXPECT(signum_in_sphere(metric, i, j, k, l, inside, 0) == 1);
        EXPECT(signum_in_sphere(metric, i, j, k, l, on, 0) == 0);
        EXPECT(signum_in_sphere(metric, i, j, k, l, outside, 0) == -1);
        EXPECT(signum_in_sphere(metric, j, i, k, l, inside, 0) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_sphere(metric, i, j, k, l, inside, 1) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_sphere(metric, i, j, k, l, NULL, 0) == SIGNUM_NO_SIGN);
    }
    {
        /* Corners of a tetrahedron in general position; the answers are held against C++ elsewhere.
         */
        const double p[] = {0, 0, 0, 0}, q[] = {7, 1, 2, 0}, r[] = {1, 6, 1, 0}, s[] = {2, 3, 8, 0};
        const int cubes = signum_spheres(SIGNUM_SUPREMUM, p, q, r, s);
        const int octahedra = signum_spheres(SIGNUM_MANHATTAN, p, q, r, s);
        EXPECT(cubes >= 0 && cubes <= 2 && octahedra >= 0 && octahedra <= 6);
        EXPECT(signum_in_sphere(SIGNUM_SUPREMUM, p, q, r, s, outside, cubes) == SIGNUM_NO_SIGN);
        EXPECT(signum_in_sphere(SIGNUM_MANHATTAN, p, q, r, s, outside, -1) == SIGNUM_NO_SIGN);
        EXPECT(signum_spheres(SIGNUM_SUPREMUM, p, p, p, p) == SIGNUM_INFINITELY_MANY);
        EXPECT(signum_in_sphere(SIGNUM_SUPREMUM, p, p, p, p, s, 0) == SIGNUM_NO_SIGN);
    }
    EXPECT(signum_spheres(SIGNUM_POWER, i, j, k, nothing) == SIGNUM_NO_SIGN);
    EXPECT(signum_spheres(4, i, j, k, l) == SIGNUM_NO_SIGN);
    EXPECT(signum_in_sphere(4, i, j, k, l, on, 0) == SIGNUM_NO_SIGN);
    EXPECT(signum_in_sphere_points(i, j, k, l, inside) == 1);
    EXPECT(signum_in_sphere_points(i, j, k, l, on) == 0);
    EXPECT(signum_in_sphere_points(i, j, k, l, nothing) == SIGNUM_NO_SIGN);
    EXPECT(signum_in_sphere_weights(i, j, k, l, heavy) == 1);
    EXPECT(signum_in_sphere_weights(i, j, k, l, on) == 0);
    EXPECT(signum_in_sphere_weights(NULL, j, k, l, on) == SIGNUM_NO_SIGN);
    EXPECT(signum_hidden_space(SIGNUM_POWER, i, small) == 1);
    EXPECT(signum_hidden_space(SIGNUM_POWER, small, i) == 0);
    for (metric = SIGNUM_EUCLIDEAN; metric <= SIGNUM_SUPREMUM; ++metric) {
        EXPECT(signum_hidden_space(metric, small, i) == 1);
        EXPECT(signum_hidden_space(metric, i, small) == 0);
    }
    EXPECT(signum_hidden_space(-1, i, small) == SIGNUM_NO_SIGN);
    EXPECT(signum_hidden_space(SIGNUM_POWER, i, nothing) == SIGNUM_NO_SIGN);
    EXPECT(signum_nearer_space(inside, i, on) == 1);
    EXPECT(signum_nearer_space(inside, on, i) == -1);
    EXPECT(signum_nearer_space(inside, i, i) == 0);
    EXPECT(signum_nearer_space(nothing, i, i) == SIGNUM_NO_SIGN);
}

static void of_sums(void) {
    const double terms[] = {1, 0x1p60, -0x1p60, -1},
                 one_more[] = {0x1p-1074, 1, 0x1p60, -0x1p60, -1};
    const double infinite[] = {1, INFINITY};
    EXPECT(signum_sign_of_sum(terms, 4) == 0);
    EXPECT(signum_sign_of_sum(terms, 3) == 1);
    EXPECT(signum_sign_of_sum(one_more, 5) == 1);
    EXPECT(signum_sign_of_sum(NULL, 0) == 0);
    EXPECT(signum_sign_of_sum(NULL, 1) == SIGNUM_NO_SIGN);
    EXPECT(signum_sign_of_sum(infinite, 2) == SIGNUM_NO_SIGN);
}

int main(void) {
    char numbers[40];
    of_the_plane();
    of_space();
    of_sums();
    EXPECT(strcmp(signum_version(), SIGNUM_VERSION) == 0);
    EXPECT(strcmp(signum_version(), PROJECT_VERSION) == 0);
    snprintf(numbers, sizeof numbers, "%d.%d.%d", SIGNUM_VERSION_MAJOR, SIGNUM_VERSION_MINOR,
             SIGNUM_VERSION_PATCH);
    EXPECT(strcmp(numbers, SIGNUM_VERSION) == 0);
    EXPECT(signum_abi() == SIGNUM_ABI);
    return mistakes != 0;
}
