#include <signum/exact/sign_of_sum.hpp>
#include <signum/predicates/ccw.hpp>

/// 0 where the signs are right that rounding gets wrong.
int main() {
    const double terms[] = {1e300, 1.0, -1e300, -1e-300};
    const bool right =
        signum::ccw({0.1, 0.2}, {0.3, 0.4}, {0.8, 0.9}) == -1 && signum::sign_of_sum(terms) == 1;
    return right ? 0 : 1;
}
