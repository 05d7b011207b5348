/* Tessellations that change, and such that move. */

#include <math.h>
#include <signum/signum.h>

#include "expect.h"

static signum_error error;

static int64_t faces_of(signum_tessellation* t) {
    signum_arrays a = SIGNUM_ARRAYS;
    SUCCEEDS(signum_tessellation_arrays(t, &a, &error));
    return a.face_count;
}

static void that_change(void) {
    const double sites[] = {0, 0, 1, 6, 0, 1, 0, 6, 1, 2, 2, 1};
    const double centres[] = {0, 0, 7, 0, 0, 7, 3, 3}, infinite[] = {0, 0, 7, 0, 0, 7, 3, INFINITY};
    const double wrong[] = {0, NAN, 0}, centre[] = {3, 1};
    signum_dynamic* d = NULL;
    signum_tessellation* t = NULL;
    double site[3];
    int32_t handle = -1;
    int i;

    SUCCEEDS(signum_dynamic_create(SIGNUM_EUCLIDEAN, SIGNUM_RADIUS, &d, &error));
    EXPECT(signum_dynamic_size(d) == 0);
    for (i = 0; i < 4; ++i) {
        SUCCEEDS(signum_dynamic_insert(d, sites + 3 * i, &handle, &error));
        EXPECT(handle == i);
    }
    SUCCEEDS(signum_dynamic_tessellation(d, &t, &error));
    EXPECT(faces_of(t) == 6);
    signum_tessellation_free(t);
    SUCCEEDS(signum_dynamic_move(d, 3, centre, &error));
    SUCCEEDS(signum_dynamic_change(d, 3, 0.5, &error));
    SUCCEEDS(signum_dynamic_site(d, 3, site, &error));
    EXPECT(site[0] == 3 && site[1] == 1 && site[2] == 0.5);
    SUCCEEDS(signum_dynamic_move_all(d, centres, 4, &error));
    SUCCEEDS(signum_dynamic_site(d, 1, site, &error));
    EXPECT(site[0] == 7 && site[1] == 0 && site[2] == 1);
    REFUSED(signum_dynamic_move_all(d, centres, 3, &error));
    REFUSED(signum_dynamic_move_all(d, NULL, 4, &error));
    REFUSED(signum_dynamic_move_all(d, infinite, 4, &error));
    SUCCEEDS(signum_dynamic_erase(d, 1, &error));
    EXPECT(signum_dynamic_size(d) == 3);
    EXPECT(signum_dynamic_contains(d, 1) == 0 && signum_dynamic_contains(d, 2) == 1);
    EXPECT(signum_dynamic_contains(d, -1) == 0 && signum_dynamic_contains(d, 99) == 0);
    FAILS(signum_dynamic_erase(d, 1, &error), SIGNUM_INVALID_ARGUMENT, 1);
    FAILS(signum_dynamic_change(d, 1, 2, &error), SIGNUM_INVALID_ARGUMENT, 1);
    FAILS(signum_dynamic_change(d, 2, NAN, &error), SIGNUM_INVALID_ARGUMENT, 2);
    FAILS(signum_dynamic_move(d, 7, centre, &error), SIGNUM_INVALID_ARGUMENT, 7);
    FAILS(signum_dynamic_move(d, 2, wrong, &error), SIGNUM_INVALID_ARGUMENT, 2);
    FAILS(signum_dynamic_site(d, -1, site, &error), SIGNUM_INVALID_ARGUMENT, -1);
    REFUSED(signum_dynamic_insert(d, wrong, &handle, &error));
    REFUSED(signum_dynamic_insert(d, NULL, &handle, &error));
    EXPECT(signum_dynamic_size(d) == 3);
    SUCCEEDS(signum_dynamic_insert(d, sites, NULL, &error));
    EXPECT(signum_dynamic_contains(d, 1) == 1);
    REFUSED(signum_dynamic_tessellation(d, NULL, &error));
    signum_dynamic_free(d);

    signum_dynamic_free(NULL);
    REFUSED(signum_dynamic_create(4, SIGNUM_RADIUS, &d, &error));
    EXPECT(d == NULL);
    REFUSED(signum_dynamic_create(SIGNUM_EUCLIDEAN, SIGNUM_WEIGHT, &d, &error));
    REFUSED(signum_dynamic_create(SIGNUM_POWER, SIGNUM_WEIGHT, NULL, &error));
    EXPECT(signum_dynamic_size(NULL) == 0 && signum_dynamic_contains(NULL, 0) == 0);
    REFUSED(signum_dynamic_insert(NULL, sites, &handle, &error));
    EXPECT(signum_dynamic_erase(NULL, 0, &error) == SIGNUM_INVALID_ARGUMENT);
    EXPECT(signum_dynamic_change(NULL, 0, 1, &error) == SIGNUM_INVALID_ARGUMENT);
    EXPECT(signum_dynamic_move(NULL, 0, centre, NULL) == SIGNUM_INVALID_ARGUMENT);
    EXPECT(signum_dynamic_site(NULL, 0, site, NULL) == SIGNUM_INVALID_ARGUMENT);
    REFUSED(signum_dynamic_move_all(NULL, centres, 0, &error));
    REFUSED(signum_dynamic_tessellation(NULL, &t, &error));
    EXPECT(t == NULL);
}

struct Told {
    int came;
    int went;
    signum_kinetic* of;
};
/* A handle at work is refused by all that could fail, and stays whoever frees it. */
static void is_refused(signum_kinetic* k) {
    const signum_moving_site more = {1, 1, 0, 0, 0, 0};
    signum_moving_site site = {7, 7, 7, 7, 7, 7};
    signum_tessellation* t = NULL;
    const int32_t* faces = NULL;
    int64_t count = -1;
    double time = -1;
    int32_t handle = -1;
    signum_kinetic_free(k);
    REFUSED(signum_kinetic_insert(k, &more, &handle, &error));
    FAILS(signum_kinetic_erase(k, 0, &error), SIGNUM_INVALID_ARGUMENT, -1);
    FAILS(signum_kinetic_change(k, 0, &more, &error), SIGNUM_INVALID_ARGUMENT, -1);
    FAILS(signum_kinetic_site(k, 0, &site, &error), SIGNUM_INVALID_ARGUMENT, -1);
    REFUSED(signum_kinetic_time(k, &time, &error));
    REFUSED(signum_kinetic_next_event(k, &time, &error));
    REFUSED(signum_kinetic_advance(k, 100, &error));
    REFUSED(signum_kinetic_faces(k, &faces, &count, &error));
    REFUSED(signum_kinetic_tessellation(k, &t, &error));
    REFUSED(signum_kinetic_watch(k, NULL, NULL, &error));
    EXPECT(handle == -1 && time == -1 && faces == NULL && count == -1 && t == NULL && site.x == 7);
    EXPECT(signum_kinetic_size(k) >= 3 && signum_kinetic_contains(k, 99) == 0);
}
static void on_edge(int32_t a, int32_t b, int comes, void* user) {
    struct Told* told = user;
    EXPECT(a < b);
    if (comes)
        ++told->came;
    else
        ++told->went;
    is_refused(told->of);
}

static void that_move(void) {
    /* The fourth one flies through the edge between the second and the third. */
    signum_moving_site sites[4] = {
        {0, 0, 0, 0, 0, 0}, {4, 0, 0, 0, 0, 0}, {0, 4, 0, 0, 0, 0}, {9, 9, -1, -1, 0, 0}};
    const signum_moving_site more = {-5, -5, 0, 0, 1, 0};
    const double fall[] = {0, -1}, endless[] = {0, INFINITY};
    signum_kinetic* k = NULL;
    signum_tessellation* t = NULL;
    signum_moving_site site;
    struct Told told = {0, 0, NULL};
    const int32_t* faces = NULL;
    int64_t count = -1;
    double time = -1;
    int32_t handle = -1;

    SUCCEEDS(signum_kinetic_create(sites, 4, 0, NULL, &k, &error));
    EXPECT(signum_kinetic_size(k) == 4);
    SUCCEEDS(signum_kinetic_faces(k, &faces, &count, &error));
    EXPECT(count == 2 && faces[0] == 0 && faces[1] == 1 && faces[2] == 2);
    /* On their circle at (4, 4), and then the diagonal is another one. */
    SUCCEEDS(signum_kinetic_next_event(k, &time, &error));
    EXPECT(time == 5);
    told.of = k;
    SUCCEEDS(signum_kinetic_watch(k, on_edge, &told, &error));
    SUCCEEDS(signum_kinetic_advance(k, time, &error));
    EXPECT(told.came == 1 && told.went == 1);
    /* The same from the others that tell. */
    SUCCEEDS(signum_kinetic_insert(k, &more, &handle, &error));
    EXPECT(told.came == 4);
    site = more;
    site.x = 50;
    SUCCEEDS(signum_kinetic_change(k, handle, &site, &error));
    EXPECT(told.went > 1);
    told.went = 0;
    SUCCEEDS(signum_kinetic_erase(k, handle, &error));
    EXPECT(told.went > 1);
    SUCCEEDS(signum_kinetic_watch(k, NULL, NULL, &error));
    SUCCEEDS(signum_kinetic_faces(k, &faces, &count, &error));
    EXPECT(count == 2 && faces[0] == 0 && faces[1] == 1 && faces[2] == 3);
    SUCCEEDS(signum_kinetic_time(k, &time, &error));
    EXPECT(time == 5);
    SUCCEEDS(signum_kinetic_tessellation(k, &t, &error));
    EXPECT(faces_of(t) == 6);
    signum_tessellation_free(t);
    SUCCEEDS(signum_kinetic_insert(k, &more, &handle, &error));
    EXPECT(handle == 4 && signum_kinetic_contains(k, 4) == 1);
    SUCCEEDS(signum_kinetic_site(k, 4, &site, &error));
    EXPECT(site.x == -5 && site.y == -5 && site.r == 1);
    site.vx = 1;
    SUCCEEDS(signum_kinetic_change(k, 4, &site, &error));
    SUCCEEDS(signum_kinetic_erase(k, 4, &error));
    EXPECT(signum_kinetic_contains(k, 4) == 0);
    FAILS(signum_kinetic_erase(k, 4, &error), SIGNUM_INVALID_ARGUMENT, 4);
    FAILS(signum_kinetic_change(k, 4, &more, &error), SIGNUM_INVALID_ARGUMENT, 4);
    FAILS(signum_kinetic_site(k, 4, &site, &error), SIGNUM_INVALID_ARGUMENT, 4);
    SUCCEEDS(signum_kinetic_insert(k, &more, NULL, &error));
    site.y = NAN;
    REFUSED(signum_kinetic_insert(k, &site, &handle, &error));
    FAILS(signum_kinetic_change(k, 0, &site, &error), SIGNUM_INVALID_ARGUMENT, 0);
    REFUSED(signum_kinetic_insert(k, NULL, &handle, &error));
    EXPECT(signum_kinetic_change(k, 0, NULL, NULL) == SIGNUM_INVALID_ARGUMENT);
    EXPECT(signum_kinetic_site(k, 0, NULL, NULL) == SIGNUM_INVALID_ARGUMENT);
    REFUSED(signum_kinetic_advance(k, 4, &error));
    REFUSED(signum_kinetic_advance(k, INFINITY, &error));
    REFUSED(signum_kinetic_faces(k, NULL, &count, &error));
    REFUSED(signum_kinetic_faces(k, &faces, NULL, &error));
    REFUSED(signum_kinetic_time(k, NULL, &error));
    REFUSED(signum_kinetic_next_event(k, NULL, &error));
    REFUSED(signum_kinetic_tessellation(k, NULL, &error));
    signum_kinetic_free(k);

    /* In a fall nothing changes places; and in the end they are beyond the doubles. */
    SUCCEEDS(signum_kinetic_create(sites, 3, 0, fall, &k, &error));
    SUCCEEDS(signum_kinetic_next_event(k, &time, &error));
    EXPECT(time == INFINITY);
    SUCCEEDS(signum_kinetic_advance(k, 1e300, &error));
    FAILS(signum_kinetic_tessellation(k, &t, &error), SIGNUM_BEYOND_RANGE, -1);
    EXPECT(t == NULL);
    signum_kinetic_free(k);
    signum_kinetic_free(NULL);

    REFUSED(signum_kinetic_create(sites, 3, 0, endless, &k, &error));
    EXPECT(k == NULL);
    REFUSED(signum_kinetic_create(sites, 3, NAN, NULL, &k, &error));
    REFUSED(signum_kinetic_create(NULL, 3, 0, NULL, &k, &error));
    REFUSED(signum_kinetic_create(sites, -3, 0, NULL, &k, &error));
    REFUSED(signum_kinetic_create(sites, 3, 0, NULL, NULL, &error));
    sites[2].vx = INFINITY;
    FAILS(signum_kinetic_create(sites, 3, 0, NULL, &k, &error), SIGNUM_INVALID_ARGUMENT, 2);
    EXPECT(signum_kinetic_size(NULL) == 0 && signum_kinetic_contains(NULL, 0) == 0);
    REFUSED(signum_kinetic_insert(NULL, &more, &handle, &error));
    EXPECT(signum_kinetic_erase(NULL, 0, NULL) == SIGNUM_INVALID_ARGUMENT);
    EXPECT(signum_kinetic_change(NULL, 0, &more, NULL) == SIGNUM_INVALID_ARGUMENT);
    EXPECT(signum_kinetic_site(NULL, 0, &site, NULL) == SIGNUM_INVALID_ARGUMENT);
    REFUSED(signum_kinetic_time(NULL, &time, &error));
    REFUSED(signum_kinetic_next_event(NULL, &time, &error));
    REFUSED(signum_kinetic_advance(NULL, 0, &error));
    REFUSED(signum_kinetic_faces(NULL, &faces, &count, &error));
    REFUSED(signum_kinetic_tessellation(NULL, &t, &error));
    REFUSED(signum_kinetic_watch(NULL, on_edge, &told, &error));
}

int main(void) {
    that_change();
    that_move();
    return mistakes != 0;
}
