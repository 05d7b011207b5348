#include <signum/signum.h>
#include <stdio.h>
int main(void) {
    const double sites[] = {0, 0, 4, 0, 0, 3, 4, 3, 2, 1};
    signum_tessellation* t = NULL;
    signum_arrays a = SIGNUM_ARRAYS;
    if (signum_triangulate(sites, 5, 2, SIGNUM_EUCLIDEAN, NULL, &t, NULL) != SIGNUM_OK) return 1;
    signum_tessellation_arrays(t, &a, NULL);
    printf("%d\n", (int)a.face_count); // prints 8
    signum_tessellation_free(t); }
