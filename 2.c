#include <math.h>
#include <signum/signum.h>
#include <stdio.h>
int main(void) {
    const double sites[] = {0, 0, 1, 4, 0, NAN};
    signum_error error;
    signum_tessellation* t;
    if (signum_triangulate(sites, 2, 3, SIGNUM_POWER, NULL, &t, &error) == SIGNUM_INVALID_ARGUMENT)
        printf("%d\n%s\n", (int)error.site, error.message); // prints 1, site 1 is not finite
    return t != NULL;
}
