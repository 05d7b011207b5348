/* The two files from C99: compiled apart, linked with a C compiler. */
#include <signum_predicates.hpp>
#include <stdio.h>

int main(void) {
    const double a[] = {0.1, 0.1}, b[] = {0.3, 0.3}, c[] = {0.7, 0.7}, d[] = {0.2, 0.3};
    const double i[] = {0, 0, 1}, j[] = {4, 0, 1}, k[] = {2, 5, 1};
    printf("%d %d %d %d\n", signum_ccw(a, b, c), signum_ccw(a, b, d),
           signum_exists(SIGNUM_EUCLIDEAN, i, j, k), signum_ccw(a, b, NULL));
    int8_t signs[2];
    const double rows[] = {0.1, 0.1, 0, 0}, ends[] = {0.3, 0.3, 1, 0}, last[] = {0.7, 0.7, 0, 1};
    if (signum_ccw_batch(rows, ends, last, 2, signs) != 0) return 1;
    printf("%d %d\n", signs[0], signs[1]);
    const double squares[4][4] = {{0, 0, 0, 0}, {1, 0, 1, 0}, {1, 1, 1, 1}, {0, 1, 0.5, 0.5}};
    if (signum_in_circle_points_batch(squares[0], squares[1], squares[2], squares[3], 2, signs) != 0) return 1;
    printf("%d %d\n", signs[0], signs[1]);
    return 0;
}
