/* Balls in flight: meeting times, strikes and who hears of them, questions. */

#include <math.h>
#include <signum/signum.h>

#include "expect.h"

static signum_error error;

struct Listener {
    signum_simulation* simulation;
    int heard;
    int stop_at;
    double last;
};
/* A simulation at work is refused by all that could fail, and stays whoever frees it. */
static void is_refused(signum_simulation* s) {
    signum_ball balls[3];
    signum_strike strike;
    double time = -1, gap = -1;
    int32_t a = 7, b = 7, found = 7;
    signum_simulation_free(s);
    REFUSED(signum_simulation_run(s, NULL, NULL, NULL, &error));
    REFUSED(signum_simulation_time(s, &time, &error));
    REFUSED(signum_simulation_balls(s, balls, 3, &error));
    REFUSED(signum_simulation_next_strike(s, 0, 1, &found, &strike, &error));
    FAILS(signum_simulation_nearest(s, 0, &b, &gap, &error), SIGNUM_INVALID_ARGUMENT, -1);
    REFUSED(signum_simulation_closest_pair(s, &a, &b, &gap, &error));
    EXPECT(time == -1 && gap == -1 && a == 7 && b == 7 && found == 7);
    EXPECT(signum_simulation_size(s) == 3 && signum_simulation_strikes(s) < 1000000);
}
static int record(const signum_strike* strike, void* user) {
    struct Listener* listener = user;
    EXPECT(strike->time >= listener->last);
    listener->last = strike->time;
    is_refused(listener->simulation);
    return ++listener->heard == listener->stop_at;
}
static int at_once(void* user) {
    struct Listener* listener = user;
    ++listener->heard;
    is_refused(listener->simulation);
    return 1;
}

/* Two balls fly at each other between walls; in space a third one looks on. */
static void strikes(int32_t dimension) {
    const signum_ball balls[3] = {{{-3, 0, 0}, {1, 0, 0}, 1, 0, 1},
                                  {{3, 0, 0}, {-1, 0, 0}, 1, 0, 1},
                                  {{0, 4, 3}, {0, 0, 0}, 0.5, 0, 2}};
    signum_ball after[3];
    signum_effects effects = SIGNUM_EFFECTS(2);
    signum_limits limits = SIGNUM_LIMITS;
    signum_simulation* s = NULL;
    struct Listener listener = {NULL, 0, -1, 0};
    signum_strike strike;
    signum_ending ending = -1;
    double time = -1, gap;
    int32_t a, b, found = -1;
    int i;

    effects.dimension = dimension;
    effects.box = SIGNUM_WALLS;
    for (i = 0; i < 3; ++i) {
        effects.low[i] = -5;
        effects.high[i] = 5;
    }
    SUCCEEDS(signum_simulation_create(balls, 3, &effects, &s, &error));
    EXPECT(signum_simulation_size(s) == 3 && signum_simulation_strikes(s) == 0);
    SUCCEEDS(signum_simulation_closest_pair(s, &a, &b, &gap, &error));
    EXPECT(a == 0 && b == (dimension == 2 ? 2 : 1) && gap == (dimension == 2 ? 3.5 : 4));
    SUCCEEDS(signum_simulation_nearest(s, 0, &b, &gap, &error));
    EXPECT((dimension == 2) == (b == 2));
    EXPECT(gap == (dimension == 2 ? 3.5 : 4));
    SUCCEEDS(signum_simulation_next_strike(s, 0, HUGE_VAL, &found, &strike, &error));
    EXPECT(found == 1 && strike.time == 2 && strike.wall == 0 && strike.a == 0 && strike.b == 1);
    SUCCEEDS(signum_simulation_next_strike(s, 0, 1, &found, &strike, &error));
    EXPECT(found == 0);

    /* To the first strike, and stopped right before it. */
    listener.simulation = s;
    listener.stop_at = 1;
    limits.record = record;
    limits.user = &listener;
    SUCCEEDS(signum_simulation_run(s, &limits, &ending, NULL, &error));
    EXPECT(ending == SIGNUM_STOPPED_BY_CALLER && listener.heard == 1 &&
           signum_simulation_strikes(s) == 0);
    /* From there on: the two, then each its wall. */
    limits.until = 5;
    SUCCEEDS(signum_simulation_run(s, &limits, &ending, &strike, &error));
    EXPECT(ending == SIGNUM_UNTIL && listener.heard == 4 && signum_simulation_strikes(s) == 3);
    SUCCEEDS(signum_simulation_time(s, &time, &error));
    EXPECT(time == 5);
    SUCCEEDS(signum_simulation_balls(s, after, 3, &error));
    EXPECT(after[0].time == 5 && after[0].x[0] == -4 && after[0].v[0] == 1 && after[0].radius == 1);
    EXPECT(after[2].mass == 2 && after[2].x[2] == (dimension == 2 ? 0 : 3));
    limits.until = HUGE_VAL;
    limits.strikes = 2;
    SUCCEEDS(signum_simulation_run(s, &limits, &ending, NULL, &error));
    EXPECT(ending == SIGNUM_STRIKES && signum_simulation_strikes(s) == 5);
    limits.record = NULL;
    limits.stop = at_once;
    limits.strikes = 1000000;
    listener.heard = 0;
    SUCCEEDS(signum_simulation_run(s, &limits, &ending, NULL, &error));
    EXPECT(ending == SIGNUM_STOPPED_BY_CALLER && listener.heard > 0);
    /* Older limits have no callbacks. */
    listener.heard = 0;
    limits.strikes = 10;
    limits.size = offsetof(signum_limits, record);
    SUCCEEDS(signum_simulation_run(s, &limits, NULL, NULL, &error));
    EXPECT(listener.heard == 0);
    limits.size = 4;
    REFUSED(signum_simulation_run(s, &limits, NULL, NULL, &error));
    limits.size = sizeof limits;
    limits.until = NAN;
    REFUSED(signum_simulation_run(s, &limits, NULL, NULL, &error));
    REFUSED(signum_simulation_balls(s, after, 2, &error));
    REFUSED(signum_simulation_balls(s, NULL, 3, &error));
    REFUSED(signum_simulation_time(s, NULL, &error));
    REFUSED(signum_simulation_next_strike(s, 0, 1, &found, &strike, &error));
    REFUSED(signum_simulation_next_strike(s, 0, 1, NULL, &strike, &error));
    REFUSED(signum_simulation_next_strike(s, 0, 1, &found, NULL, &error));
    FAILS(signum_simulation_nearest(s, 3, &b, &gap, &error), SIGNUM_INVALID_ARGUMENT, 3);
    EXPECT(signum_simulation_nearest(s, 0, NULL, &gap, NULL) == SIGNUM_INVALID_ARGUMENT);
    EXPECT(signum_simulation_nearest(s, 0, &b, NULL, NULL) == SIGNUM_INVALID_ARGUMENT);
    REFUSED(signum_simulation_closest_pair(s, NULL, &b, &gap, &error));
    REFUSED(signum_simulation_closest_pair(s, &a, NULL, &gap, &error));
    REFUSED(signum_simulation_closest_pair(s, &a, &b, NULL, &error));
    signum_simulation_free(s);
}

static void what_is_refused(void) {
    signum_ball balls[2] = {{{0, 0, 0}, {0, 0, 0}, 1, 0, 1}, {{9, 0, 0}, {0, 0, 0}, 1, 0, 1}};
    signum_effects effects = SIGNUM_EFFECTS(3);
    signum_simulation* s = NULL;
    signum_ending ending;
    double time, gap;
    int32_t a, b, found;
    signum_strike strike;

    /* Nobody, and one alone. */
    SUCCEEDS(signum_simulation_create(NULL, 0, &effects, &s, &error));
    SUCCEEDS(signum_simulation_closest_pair(s, &a, &b, &gap, &error));
    EXPECT(a == -1 && b == -1 && gap == INFINITY);
    SUCCEEDS(signum_simulation_run(s, NULL, &ending, &strike, &error));
    EXPECT(ending == SIGNUM_NOTHING);
    signum_simulation_free(s);
    SUCCEEDS(signum_simulation_create(balls, 1, &effects, &s, &error));
    SUCCEEDS(signum_simulation_nearest(s, 0, &b, &gap, &error));
    EXPECT(b == -1 && gap == INFINITY);
    signum_simulation_free(s);
    signum_simulation_free(NULL);

    balls[1].v[2] = NAN;
    FAILS(signum_simulation_create(balls, 2, &effects, &s, &error), SIGNUM_INVALID_ARGUMENT, 1);
    EXPECT(s == NULL);
    balls[1].v[2] = 0;
    balls[1].mass = 0;
    FAILS(signum_simulation_create(balls, 2, &effects, &s, &error), SIGNUM_INVALID_ARGUMENT, 1);
    balls[1].mass = 1;
    balls[1].x[0] = 1;
    FAILS(signum_simulation_create(balls, 2, &effects, &s, &error), SIGNUM_INVALID_ARGUMENT, 1);
    balls[1].x[0] = 9;
    REFUSED(signum_simulation_create(NULL, 2, &effects, &s, &error));
    REFUSED(signum_simulation_create(balls, -2, &effects, &s, &error));
    REFUSED(signum_simulation_create(balls, 2, NULL, &s, &error));
    REFUSED(signum_simulation_create(balls, 2, &effects, NULL, &error));
    effects.restitution = 2;
    REFUSED(signum_simulation_create(balls, 2, &effects, &s, &error));
    REFUSED(signum_meeting_time(balls, balls + 1, &effects, HUGE_VAL, &time, &error));
    /* Of a program from before friction: what lies behind is not looked at. */
    effects.restitution = 1;
    effects.law_speed = NAN;
    effects.obstacle_count = 7;
    effects.size = offsetof(signum_effects, law_speed);
    SUCCEEDS(signum_simulation_create(balls, 2, &effects, &s, &error));
    signum_simulation_free(s);
    effects.law_speed = 0;
    effects.obstacle_count = 0;
    effects.restitution = 2;
    /* Of an older program, which knew of no restitution. */
    effects.size = offsetof(signum_effects, restitution);
    SUCCEEDS(signum_simulation_create(balls, 2, &effects, &s, &error));
    signum_simulation_free(s);
    effects.size = sizeof effects;
    effects.restitution = 1;
    effects.box = 3;
    REFUSED(signum_simulation_create(balls, 2, &effects, &s, &error));
    effects.box = SIGNUM_NO_BOX;
    effects.dimension = 4;
    REFUSED(signum_simulation_create(balls, 2, &effects, &s, &error));
    effects.dimension = 3;
    effects.size = sizeof effects + 8;
    REFUSED(signum_simulation_create(balls, 2, &effects, &s, &error));

    EXPECT(signum_simulation_size(NULL) == 0 && signum_simulation_strikes(NULL) == 0);
    REFUSED(signum_simulation_run(NULL, NULL, NULL, NULL, &error));
    REFUSED(signum_simulation_time(NULL, &time, &error));
    REFUSED(signum_simulation_balls(NULL, balls, 0, &error));
    REFUSED(signum_simulation_next_strike(NULL, 0, 1, &found, &strike, &error));
    EXPECT(signum_simulation_nearest(NULL, 0, &b, &gap, NULL) == SIGNUM_INVALID_ARGUMENT);
    REFUSED(signum_simulation_closest_pair(NULL, &a, &b, &gap, &error));
}

/* One ball, until a time; the wall that it strikes last, or -1. */
static int32_t last_wall;
static int keep_wall(const signum_strike* strike, void* user) {
    (void)user;
    last_wall = strike->wall ? strike->b : -1;
    return 0;
}
static void flies(signum_ball* ball, const signum_effects* effects, double until, double spin[3]) {
    signum_simulation* s = NULL;
    signum_limits limits = SIGNUM_LIMITS;
    signum_ending ending = -1;
    limits.until = until;
    limits.record = keep_wall;
    last_wall = -1;
    SUCCEEDS(signum_simulation_create(ball, 1, effects, &s, &error));
    SUCCEEDS(signum_simulation_run(s, &limits, &ending, NULL, &error));
    EXPECT(ending == SIGNUM_UNTIL || ending == SIGNUM_NOTHING);
    SUCCEEDS(signum_simulation_spins(s, spin, 1, &error));
    REFUSED(signum_simulation_spins(s, spin, 2, &error));
    REFUSED(signum_simulation_spins(s, NULL, 1, &error));
    SUCCEEDS(signum_simulation_balls(s, ball, 1, &error));
    signum_simulation_free(s);
}

static void every_effect(void) {
    const signum_ball above = {{0, 2, 0}, {0, 0, 0}, 1, 0, 1};
    signum_obstacle obstacles[1] = {{SIGNUM_HALF_SPACE, 0, {0, 1, 0}, {0, 0, 0}, 0, 0}};
    signum_effects effects = SIGNUM_EFFECTS(2);
    signum_ball ball = above;
    signum_simulation* s = NULL;
    double spin[3] = {7, 7, 7};

    /* It falls by 1 until t = 1, and comes with the speed 2. */
    effects.obstacles = obstacles;
    effects.obstacle_count = 1;
    effects.gravity[1] = -2;
    effects.wall_restitution = 0.5;
    flies(&ball, &effects, 1, spin);
    EXPECT(last_wall == 4 && ball.v[1] == 1 && ball.x[1] == 1);
    EXPECT(spin[0] == 0 && spin[1] == 0 && spin[2] == 0);
    /* Half as large a loss at half the speed, by a linear law. */
    effects.law_speed = 4;
    effects.law_power = 1;
    ball = above;
    flies(&ball, &effects, 1, spin);
    EXPECT(ball.v[1] == 1.5);
    effects.law_power = -1;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
    effects.law_speed = 0;

    /* What slides comes to roll: a third of its momentum turns it. */
    effects.gravity[1] = 0;
    effects.has_friction = 1;
    effects.wall_friction = 10;
    ball = above;
    ball.v[0] = 1;
    ball.v[1] = -1;
    flies(&ball, &effects, 1, spin);
    EXPECT(fabs(ball.v[0] - 2.0 / 3) < 1e-15 && fabs(spin[2] + 2.0 / 3) < 1e-15);
    effects.inertia = 0;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
    effects.has_friction = 0;

    /* It falls, and comes to rest. */
    effects.gravity[1] = -1;
    effects.contact_speed = 0.25;
    effects.time_step = 0.125;
    ball = above;
    flies(&ball, &effects, 16, spin);
    EXPECT(fabs(ball.x[1] - 1) < 1e-2 && fabs(ball.v[1]) < 1e-6);
    effects.contact_sweeps = 1;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
    effects.contact_speed = 0;
    effects.gravity[1] = 0;

    /* A fluid at rest takes speed away, one that flows takes the ball along. */
    effects.obstacle_count = 0;
    effects.fluid_linear = 1;
    ball = above;
    ball.v[0] = 1;
    flies(&ball, &effects, 1, spin);
    EXPECT(fabs(ball.v[0] - exp(-1)) < 1e-2);
    effects.fluid_velocity[0] = 1;
    effects.fluid_gradient[1] = 0.5;
    ball = above;
    flies(&ball, &effects, 16, spin);
    EXPECT(fabs(ball.v[0] - 2) < 1e-2 && fabs(ball.v[1]) < 1e-6);
    effects.fluid_linear = 0;
    effects.fluid_quadratic = -1;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
    effects.fluid_quadratic = 0;
    effects.time_step = 0;

    /* Round walls, and thin ones. */
    effects.obstacle_count = 1;
    effects.wall_restitution = 1;
    obstacles[0].kind = SIGNUM_DRUM;
    obstacles[0].at[1] = 2;
    obstacles[0].size = 3;
    ball = above;
    ball.v[0] = 1;
    flies(&ball, &effects, 2, spin);
    EXPECT(last_wall == 4 && ball.v[0] == -1);
    obstacles[0].kind = SIGNUM_PILLAR;
    FAILS(signum_simulation_create(&above, 1, &effects, &s, &error), SIGNUM_INVALID_ARGUMENT, 0);
    obstacles[0].at[0] = 6;
    ball = above;
    ball.v[0] = 1;
    flies(&ball, &effects, 2, spin);
    EXPECT(last_wall == 4 && ball.v[0] == -1);
    obstacles[0].to[0] = -1;
    ball = above;
    flies(&ball, &effects, 2, spin);
    EXPECT(last_wall == 4 && ball.v[0] == -2);
    obstacles[0].kind = SIGNUM_SEGMENT;
    obstacles[0].at[0] = obstacles[0].to[0] = 6;
    obstacles[0].at[1] = -1;
    obstacles[0].to[1] = 9;
    ball = above;
    ball.v[0] = 1;
    flies(&ball, &effects, 5, spin);
    EXPECT(last_wall == 4 && ball.v[0] == -1);
    effects.dimension = 3;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
    obstacles[0].kind = 4;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
    effects.obstacles = NULL;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
    effects.obstacle_count = -1;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
    effects.obstacle_count = 0;

    /* A floor that rises from 1 below, at half a unit of time: they meet at 1, and part as fast. */
    effects.obstacles = obstacles;
    effects.obstacle_count = 1;
    effects.dimension = 2;
    obstacles[0].kind = SIGNUM_HALF_SPACE;
    obstacles[0].at[0] = 0;
    obstacles[0].at[1] = 1;
    obstacles[0].size = -1;
    obstacles[0].speed = 0.5;
    ball = above;
    ball.v[1] = -1.5;
    flies(&ball, &effects, 1, spin);
    EXPECT(last_wall == 4 && ball.x[1] == 0.5 && ball.v[1] == 2.5);
    effects.obstacle_count = 0;

    /* Three axes to turn about; a floor that goes to and fro. */
    effects.dimension = 3;
    effects.box = SIGNUM_WALLS;
    effects.high[0] = effects.high[1] = effects.high[2] = 4;
    effects.shake_amplitude[1] = 0.125;
    effects.shake_frequency = 1;
    effects.has_friction = 1;
    effects.inertia = 0.4;
    ball = above;
    ball.x[0] = ball.x[2] = 2;
    ball.v[1] = -1;
    ball.v[2] = 1;
    flies(&ball, &effects, 1.5, spin);
    EXPECT(last_wall >= 2 && ball.v[1] > 1 && spin[0] > 0 && spin[1] == 0 && spin[2] == 0);
    effects.box = SIGNUM_NO_BOX;
    REFUSED(signum_simulation_create(&above, 1, &effects, &s, &error));
}

static void meetings(void) {
    signum_ball a = {{0, 0, NAN}, {1, 0, NAN}, 1, 0, 0}, b = {{10, 0, 0}, {-1, 0, 0}, 1, 0, 0};
    signum_effects effects = SIGNUM_EFFECTS(2);
    double time = -1;

    SUCCEEDS(signum_meeting_time(&a, &b, &effects, HUGE_VAL, &time, &error));
    EXPECT(time == 4);
    b.v[0] = 1;
    SUCCEEDS(signum_meeting_time(&a, &b, &effects, HUGE_VAL, &time, &error));
    EXPECT(time == INFINITY);
    /* Radii 1 + t meet where 2 (1 + t) = 10. */
    effects.growth_rate = 1;
    effects.growth_until = 8;
    SUCCEEDS(signum_meeting_time(&a, &b, &effects, HUGE_VAL, &time, &error));
    EXPECT(time == 4);
    a.radius = -1;
    REFUSED(signum_meeting_time(&a, &b, &effects, HUGE_VAL, &time, &error));
    a.radius = 1;
    effects.growth_rate = -1;
    REFUSED(signum_meeting_time(&a, &b, &effects, HUGE_VAL, &time, &error));
    effects.growth_rate = 0;
    effects.box = SIGNUM_PERIODIC;
    effects.high[0] = effects.high[1] = 20;
    b.v[0] = 2;
    SUCCEEDS(signum_meeting_time(&a, &b, &effects, 100, &time, &error));
    EXPECT(time == 8);
    REFUSED(signum_meeting_time(&a, &b, &effects, HUGE_VAL, &time, &error));
    REFUSED(signum_meeting_time(&a, &b, &effects, NAN, &time, &error));
    EXPECT(time == 8);
    effects.dimension = 3;
    REFUSED(signum_meeting_time(&a, &b, &effects, 100, &time, &error));
    effects.dimension = 2;
    a.radius = INFINITY;
    REFUSED(signum_meeting_time(&a, &b, &effects, 100, &time, &error));
    REFUSED(signum_meeting_time(NULL, &b, &effects, 100, &time, &error));
    REFUSED(signum_meeting_time(&a, NULL, &effects, 100, &time, &error));
    REFUSED(signum_meeting_time(&a, &b, NULL, 100, &time, &error));
    REFUSED(signum_meeting_time(&a, &b, &effects, 100, NULL, &error));
}

int main(void) {
    strikes(2);
    strikes(3);
    what_is_refused();
    every_effect();
    meetings();
    return mistakes != 0;
}
