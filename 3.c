#include <signum/signum.h>
#include <stdio.h>
static int record(const signum_strike* strike, void* user) {
    (void)user;
    return printf("%g\n", strike->time) < 0; // prints 2, 6.5
}
int main(void) {
    const signum_ball balls[] = {{{0}, {1}, 1, 0, 1}, {{6}, {-1}, 1, 0, 1}};
    signum_effects effects = SIGNUM_EFFECTS(2);
    signum_limits limits = SIGNUM_LIMITS;
    signum_simulation* s = NULL;
    effects.box = SIGNUM_WALLS;
    effects.low[0] = effects.low[1] = -4;
    effects.high[0] = effects.high[1] = 9.5;
    limits.strikes = 2;
    limits.record = record;
    if (signum_simulation_create(balls, 2, &effects, &s, NULL) != SIGNUM_OK) return 1;
    signum_simulation_run(s, &limits, NULL, NULL, NULL);
    signum_simulation_free(s);
    return 0;
}
