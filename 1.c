#include <signum/signum.h>
#include <stdio.h>
int main(void) {
    const double a[] = {0, 0}, b[] = {1e-30, 1e-30}, c[] = {1e30, 1e30};
    const double i[] = {0, 0, 1}, j[] = {9, 1, 2}, k[] = {3, 8, 0}, q[] = {4, 4, 1};
    printf("%d\n", signum_ccw(a, b, c)); // prints 1
    printf("%d\n", signum_in_circle(SIGNUM_EUCLIDEAN, i, j, k, q)); // prints 1
    return 0;
}
