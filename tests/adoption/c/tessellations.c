/* Tessellations of the plane and of space, and diagrams: results, and every way to be refused. */

#include <math.h>
#include <signum/signum.h>
#include <stdlib.h>

#include "expect.h"

static signum_error error;

/* A share of the work that is never done: stops at the first call. */
static int stops(double done, void* user) {
    ++*(int*)user;
    EXPECT(done >= 0 && done <= 1);
    return 1;
}
static int goes_on(double done, void* user) {
    (void)done;
    ++*(int*)user;
    return 0;
}

/* What is being made is not there yet; what is there answers, though it is being validated. */
struct Handles {
    signum_tessellation** made;
    signum_space_tessellation** made_in_space;
    const signum_tessellation* there;
    int calls;
};
static int looks_around(double done, void* user) {
    struct Handles* handles = user;
    signum_arrays a = SIGNUM_ARRAYS;
    signum_voronoi* voronoi = NULL;
    const double origin[] = {0, 0};
    int32_t number = -7;
    (void)done;
    ++handles->calls;
    if (handles->made != NULL) EXPECT(*handles->made == NULL);
    if (handles->made_in_space != NULL) EXPECT(*handles->made_in_space == NULL);
    if (handles->there == NULL) return 0;
    SUCCEEDS(signum_tessellation_arrays(handles->there, &a, &error));
    SUCCEEDS(signum_tessellation_locate(handles->there, origin, &number, &error));
    SUCCEEDS(signum_tessellation_nearest(handles->there, origin, &number, &error));
    EXPECT(number >= 0);
    SUCCEEDS(signum_voronoi_create(handles->there, 1, &voronoi, &error));
    signum_voronoi_free(voronoi);
    return 0;
}

/* Numbers without order, the same everywhere. */
static double* scattered(int64_t count) {
    double* numbers = malloc((size_t)count * sizeof *numbers);
    uint32_t state = 1;
    int64_t i;
    if (numbers == NULL) exit(2);
    for (i = 0; i < count; ++i) {
        state = state * 1664525u + 1013904223u;
        numbers[i] = (double)(state >> 8);
    }
    return numbers;
}

static void in_the_plane(void) {
    const double sites[] = {0, 0, 1, 6, 0, 1, 0, 6, 1, 6, 6, 1, 3, 3, 2, 3, 3, 1};
    const double point[] = {1, 0.5}, nowhere[] = {0, INFINITY};
    signum_tessellation* t = NULL;
    signum_metric metric;

    for (metric = SIGNUM_POWER; metric <= SIGNUM_SUPREMUM; ++metric) {
        signum_arrays a = SIGNUM_ARRAYS;
        signum_validation v;
        double vertices[3 * 8];
        int32_t number = -7;
        SUCCEEDS(signum_triangulate(sites, 6, 3, metric, NULL, &t, &error));
        SUCCEEDS(signum_tessellation_arrays(t, &a, &error));
        EXPECT(a.size == sizeof a && a.metric == metric && a.weight_is == SIGNUM_RADIUS);
        EXPECT(a.sites == 6 && a.face_count == 8 && a.hidden_count == 1);
        EXPECT(a.hidden[0] == 5 && a.hidden[1] == 4);
        SUCCEEDS(signum_tessellation_vertices(t, vertices, 24, &error));
        REFUSED(signum_tessellation_vertices(t, vertices, 23, &error));
        REFUSED(signum_tessellation_vertices(t, NULL, 24, &error));
        SUCCEEDS(signum_tessellation_locate(t, point, &number, &error));
        EXPECT(number >= 0 && number < 8);
        SUCCEEDS(signum_tessellation_nearest(t, point, &number, &error));
        EXPECT(number == 0);
        REFUSED(signum_tessellation_locate(t, nowhere, &number, &error));
        REFUSED(signum_tessellation_locate(t, NULL, &number, &error));
        REFUSED(signum_tessellation_locate(t, point, NULL, &error));
        REFUSED(signum_tessellation_nearest(t, nowhere, &number, &error));
        REFUSED(signum_tessellation_nearest(t, point, NULL, &error));
        EXPECT(number == 0);
        SUCCEEDS(signum_validate(&a, sites, 6, 3, NULL, &v, &error));
        EXPECT(v.valid == 1 && v.canonical == 1 && v.message[0] == '\0');
        a.neighbours = NULL; /* needed where two sites share several edges, as discs may */
        SUCCEEDS(signum_validate(&a, sites, 6, 3, NULL, &v, &error));
        EXPECT(v.valid == 1 || metric != SIGNUM_POWER);
        a.face_count -= 1;
        SUCCEEDS(signum_validate(&a, sites, 6, 3, NULL, &v, &error));
        EXPECT(v.valid == 0 && v.canonical == 0 && v.message[0] != '\0');
        a.face_count = -1;
        REFUSED(signum_validate(&a, sites, 6, 3, NULL, &v, &error));
        a.face_count = 0;
        a.hidden_count = 1;
        a.hidden = NULL;
        REFUSED(signum_validate(&a, sites, 6, 3, NULL, &v, &error));
        a.hidden_count = 0;
        SUCCEEDS(signum_validate(&a, sites, 5, 3, NULL, &v, &error));
        EXPECT(v.valid == 0);
        a.metric = 4;
        REFUSED(signum_validate(&a, sites, 6, 3, NULL, &v, &error));
        a.size = 12;
        REFUSED(signum_validate(&a, sites, 6, 3, NULL, &v, &error));
        REFUSED(signum_validate(NULL, sites, 6, 3, NULL, &v, &error));
        signum_tessellation_free(t);
    }
}

static void what_is_refused(void) {
    double sites[] = {0, 0, 1, 6, 0, 1, 0, 6, 1};
    signum_tessellation* t = (signum_tessellation*)&error;
    signum_arrays a = SIGNUM_ARRAYS;
    signum_validation v;
    double number;
    int32_t found;

    sites[5] = NAN;
    FAILS(signum_triangulate(sites, 3, 3, SIGNUM_POWER, NULL, &t, &error), SIGNUM_INVALID_ARGUMENT,
          1);
    EXPECT(t == NULL);
    EXPECT(strstr(error.message, "site 1") != NULL);
    /* Without its third number it is a point, and legal. */
    SUCCEEDS(signum_triangulate(sites, 2, 2, SIGNUM_POWER, NULL, &t, &error));
    SUCCEEDS(signum_tessellation_arrays(t, &a, &error));
    FAILS(signum_validate(&a, sites, 3, 3, NULL, &v, &error), SIGNUM_INVALID_ARGUMENT, 1);
    REFUSED(signum_validate(&a, sites, 2, 2, NULL, NULL, &error));
    signum_tessellation_free(t);
    EXPECT(signum_triangulate(sites, 3, 3, SIGNUM_POWER, NULL, &t, NULL) ==
           SIGNUM_INVALID_ARGUMENT);
    sites[5] = 1;

    REFUSED(signum_triangulate(NULL, 3, 3, SIGNUM_POWER, NULL, &t, &error));
    REFUSED(signum_triangulate(sites, -1, 3, SIGNUM_POWER, NULL, &t, &error));
    REFUSED(signum_triangulate(sites, INT64_MAX, 3, SIGNUM_POWER, NULL, &t, &error));
    REFUSED(signum_triangulate(sites, 3, 1, SIGNUM_POWER, NULL, &t, &error));
    REFUSED(signum_triangulate(sites, 3, INT64_MAX, SIGNUM_POWER, NULL, &t, &error));
    REFUSED(signum_triangulate(sites, 3, 3, -1, NULL, &t, &error));
    REFUSED(signum_triangulate(sites, 3, 3, SIGNUM_POWER, NULL, NULL, &error));
    SUCCEEDS(signum_triangulate(NULL, 0, 2, SIGNUM_POWER, NULL, &t, &error));
    SUCCEEDS(signum_tessellation_nearest(t, sites, &found, &error));
    EXPECT(found == -1);
    signum_tessellation_free(t);
    signum_tessellation_free(NULL);

    REFUSED(signum_tessellation_arrays(NULL, &a, &error));
    REFUSED(signum_tessellation_vertices(NULL, &number, 0, &error));
    REFUSED(signum_tessellation_locate(NULL, sites, &found, &error));
    REFUSED(signum_tessellation_nearest(NULL, sites, &found, &error));
}

static void options(void) {
    const double sites[] = {0, 0, 1, 6, 0, 1, 0, 6, 1, 1e300, 0, 1};
    const int64_t many = 20000;
    double* scatter = scattered(3 * many);
    signum_tessellation *t = NULL, *again = NULL;
    signum_options o = SIGNUM_OPTIONS;
    signum_arrays a = SIGNUM_ARRAYS, b = SIGNUM_ARRAYS;
    signum_validation v;
    struct Handles handles = {NULL, NULL, NULL, 0};
    int calls = 0;

    /* All that can be asked for gives one result. */
    SUCCEEDS(signum_triangulate(scatter, many, 2, SIGNUM_POWER, NULL, &t, &error));
    SUCCEEDS(signum_tessellation_arrays(t, &a, &error));
    o.method = SIGNUM_FLIPS;
    o.seed = 7;
    o.progress = goes_on;
    o.user = &calls;
    SUCCEEDS(signum_triangulate(scatter, many, 2, SIGNUM_POWER, &o, &again, &error));
    SUCCEEDS(signum_tessellation_arrays(again, &b, &error));
    EXPECT(calls > 0 && a.face_count == b.face_count);
    EXPECT(memcmp(a.faces, b.faces, (size_t)a.face_count * 12) == 0);
    signum_tessellation_free(again);

    /* Handles seen from callbacks. */
    o.progress = looks_around;
    o.user = &handles;
    handles.made = &again;
    handles.there = t;
    SUCCEEDS(signum_triangulate(scatter, many, 2, SIGNUM_POWER, &o, &again, &error));
    signum_tessellation_free(again);
    handles.made = NULL;
    SUCCEEDS(signum_validate(&a, scatter, many, 2, &o, &v, &error));
    EXPECT(v.canonical == 1 && handles.calls > 1);

    /* Stopped, with nothing to free. */
    o.user = &calls;
    o.method = SIGNUM_INCREMENTAL;
    o.progress = stops;
    calls = 0;
    FAILS(signum_triangulate(scatter, many, 2, SIGNUM_POWER, &o, &again, &error), SIGNUM_STOPPED,
          -1);
    EXPECT(again == NULL && calls == 1);
    FAILS(signum_triangulate(scatter, many, 3, SIGNUM_EUCLIDEAN, &o, &again, &error),
          SIGNUM_STOPPED, -1);
    calls = 0;
    FAILS(signum_validate(&a, scatter, many, 2, &o, &v, &error), SIGNUM_STOPPED, -1);
    EXPECT(calls == 1);
    signum_tessellation_free(t);

    /* An older program's options are shorter: seed, progress and user are as if it knew of none. */
    calls = 0;
    o.size = offsetof(signum_options, seed);
    SUCCEEDS(signum_triangulate(scatter, many, 2, SIGNUM_POWER, &o, &t, &error));
    EXPECT(calls == 0);
    signum_tessellation_free(t);
    o.size = sizeof o.size;
    SUCCEEDS(signum_triangulate(scatter, 100, 2, SIGNUM_POWER, &o, &t, &error));
    signum_tessellation_free(t);
    o.size = 0;
    REFUSED(signum_triangulate(scatter, 100, 2, SIGNUM_POWER, &o, &t, &error));
    o.size = sizeof o + 8;
    REFUSED(signum_triangulate(scatter, 100, 2, SIGNUM_POWER, &o, &t, &error));
    o.size = sizeof o - 1;
    REFUSED(signum_triangulate(scatter, 100, 2, SIGNUM_POWER, &o, &t, &error));
    /* What is shown fills no more than there is room for, and says how much. */
    {
        const double square[] = {0, 0, 4, 0, 0, 4, 4, 4};
        signum_arrays short_one = SIGNUM_ARRAYS;
        SUCCEEDS(signum_triangulate(square, 4, 2, SIGNUM_POWER, NULL, &t, &error));
        short_one.size = offsetof(signum_arrays, face_count);
        short_one.face_count = -5;
        SUCCEEDS(signum_tessellation_arrays(t, &short_one, &error));
        EXPECT(short_one.sites == 4 && short_one.face_count == -5);
        EXPECT(short_one.size == offsetof(signum_arrays, face_count));
        short_one.size = 3;
        REFUSED(signum_tessellation_arrays(t, &short_one, &error));
        REFUSED(signum_tessellation_arrays(t, NULL, &error));
        signum_tessellation_free(t);
    }

    {
        signum_options wrong = SIGNUM_OPTIONS;
        wrong.arithmetic = 6;
        REFUSED(signum_triangulate(sites, 3, 3, SIGNUM_POWER, &wrong, &t, &error));
        wrong.arithmetic = SIGNUM_SINGLE;
        FAILS(signum_triangulate(sites, 4, 3, SIGNUM_POWER, &wrong, &t, &error),
              SIGNUM_INVALID_ARGUMENT, 3);
        wrong.arithmetic = SIGNUM_EXACT;
        wrong.method = 3;
        REFUSED(signum_triangulate(sites, 3, 3, SIGNUM_POWER, &wrong, &t, &error));
        wrong.method = SIGNUM_SWEEP;
        REFUSED(signum_triangulate(sites, 3, 3, SIGNUM_POWER, &wrong, &t, &error));
        SUCCEEDS(signum_triangulate(sites, 3, 3, SIGNUM_MANHATTAN, &wrong, &t, &error));
        signum_tessellation_free(t);
        wrong.method = SIGNUM_INCREMENTAL;
        wrong.threads = -1;
        REFUSED(signum_triangulate(sites, 3, 3, SIGNUM_POWER, &wrong, &t, &error));
        wrong.threads = 1025;
        REFUSED(signum_triangulate(sites, 3, 3, SIGNUM_POWER, &wrong, &t, &error));
        wrong.threads = 2;
        SUCCEEDS(signum_triangulate(sites, 3, 3, SIGNUM_POWER, &wrong, &t, &error));
        signum_tessellation_free(t);
        wrong.threads = 0;
        wrong.weight_is = 2;
        REFUSED(signum_triangulate(sites, 3, 3, SIGNUM_POWER, &wrong, &t, &error));
        wrong.weight_is = SIGNUM_WEIGHT;
        REFUSED(signum_triangulate(sites, 3, 3, SIGNUM_EUCLIDEAN, &wrong, &t, &error));
        SUCCEEDS(signum_triangulate(sites, 3, 3, SIGNUM_POWER, &wrong, &t, &error));
        SUCCEEDS(signum_tessellation_arrays(t, &a, &error));
        EXPECT(a.weight_is == SIGNUM_WEIGHT);
        SUCCEEDS(signum_validate(&a, sites, 3, 3, NULL, &v, &error));
        EXPECT(v.canonical == 1);
        signum_tessellation_free(t);
    }
    free(scatter);
}

static void diagrams(void) {
    const double sites[] = {1, 1, 3, 1, 1, 3, 3, 3}, box[] = {0, 0, 4, 4}, wrong[] = {0, 0, 0, 4};
    const double endless[] = {0, 0, 4, INFINITY};
    signum_tessellation* t = NULL;
    signum_voronoi* d = NULL;
    signum_diagram_arrays a = SIGNUM_DIAGRAM_ARRAYS;
    double areas[4];
    int i, of_no_length = 0;

    SUCCEEDS(signum_triangulate(sites, 4, 2, SIGNUM_EUCLIDEAN, NULL, &t, &error));
    SUCCEEDS(signum_voronoi_create(t, 0, &d, &error));
    SUCCEEDS(signum_voronoi_arrays(d, &a, &error));
    EXPECT(a.vertex_count == 2 && a.edge_count == 5);
    signum_voronoi_free(d);
    SUCCEEDS(signum_voronoi_create(t, 1, &d, &error));
    /* The diagram has a copy. */
    signum_tessellation_free(t);
    SUCCEEDS(signum_voronoi_arrays(d, &a, &error));
    EXPECT(a.vertex_count == 1 && a.edge_count == 5);
    EXPECT(a.vertices[0] == 2 && a.vertices[1] == 2 && a.vertices[2] == sqrt(2));
    for (i = 0; i < 5; ++i) of_no_length += a.edges[6 * i + 2] == a.edges[6 * i + 3];
    EXPECT(of_no_length == 1);
    SUCCEEDS(signum_voronoi_areas(d, box, areas, 4, &error));
    for (i = 0; i < 4; ++i) EXPECT(areas[i] == 4);
    SUCCEEDS(signum_voronoi_areas(d, NULL, areas, 4, &error));
    for (i = 0; i < 4; ++i) EXPECT(fabs(areas[i] - 1.2 * 1.2) < 1e-12);
    REFUSED(signum_voronoi_areas(d, box, areas, 3, &error));
    REFUSED(signum_voronoi_areas(d, box, NULL, 4, &error));
    REFUSED(signum_voronoi_areas(d, wrong, areas, 4, &error));
    REFUSED(signum_voronoi_areas(d, endless, areas, 4, &error));
    REFUSED(signum_voronoi_areas(NULL, box, areas, 4, &error));
    REFUSED(signum_voronoi_arrays(NULL, &a, &error));
    REFUSED(signum_voronoi_arrays(d, NULL, &error));
    signum_voronoi_free(d);
    signum_voronoi_free(NULL);
    REFUSED(signum_voronoi_create(NULL, 0, &d, &error));
    EXPECT(d == NULL);
    REFUSED(signum_voronoi_create(NULL, 0, NULL, &error));
}

static void in_space(void) {
    const double sites[] = {0, 0, 0, 1, 6, 0, 0, 1, 0, 6, 0, 1, 0, 0, 6, 1, 1, 1, 1, 1, 1, 1, 1, 0};
    const double flat[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const int64_t many = 20000;
    double* scatter = scattered(3 * many);
    signum_space_tessellation* t = NULL;
    signum_space_arrays a = SIGNUM_SPACE_ARRAYS;
    signum_options o = SIGNUM_OPTIONS;
    signum_validation v;
    struct Handles handles = {NULL, &t, NULL, 0};
    double vertices[4 * 64];
    int calls = 0;

    SUCCEEDS(signum_triangulate_space(sites, 6, 4, NULL, &t, &error));
    SUCCEEDS(signum_space_tessellation_arrays(t, &a, &error));
    EXPECT(a.dimension == 3 && a.sites == 6 && a.cell_count == 8 && a.hidden_count == 1);
    EXPECT(a.hidden[0] == 5 && a.hidden[1] == 4);
    SUCCEEDS(signum_space_tessellation_vertices(t, vertices, 4 * a.cell_count, &error));
    REFUSED(signum_space_tessellation_vertices(t, vertices, 3 * a.cell_count, &error));
    REFUSED(signum_space_tessellation_vertices(NULL, vertices, 0, &error));
    SUCCEEDS(signum_validate_space(&a, sites, 6, 4, NULL, &v, &error));
    EXPECT(v.valid == 1 && v.canonical == 1 && v.message[0] == '\0');
    SUCCEEDS(signum_validate_space(&a, sites, 5, 4, NULL, &v, &error));
    EXPECT(v.valid == 0 && v.message[0] != '\0');
    REFUSED(signum_validate_space(&a, sites, 6, 2, NULL, &v, &error));
    REFUSED(signum_validate_space(&a, sites, 6, 4, NULL, NULL, &error));
    REFUSED(signum_validate_space(NULL, sites, 6, 4, NULL, &v, &error));
    a.neighbours = NULL;
    REFUSED(signum_validate_space(&a, sites, 6, 4, NULL, &v, &error));
    REFUSED(signum_space_tessellation_arrays(t, NULL, &error));
    REFUSED(signum_space_tessellation_arrays(NULL, &a, &error));
    signum_space_tessellation_free(t);
    signum_space_tessellation_free(NULL);

    SUCCEEDS(signum_triangulate_space(flat, 4, 3, NULL, &t, &error));
    SUCCEEDS(signum_space_tessellation_arrays(t, &a, &error));
    EXPECT(a.dimension == 2 && a.cells[3] == SIGNUM_NO_VERTEX);
    signum_space_tessellation_free(t);
    o.weight_is = SIGNUM_WEIGHT;
    SUCCEEDS(signum_triangulate_space(sites, 6, 4, &o, &t, &error));
    SUCCEEDS(signum_space_tessellation_arrays(t, &a, &error));
    SUCCEEDS(signum_validate_space(&a, sites, 6, 4, &o, &v, &error));
    EXPECT(v.canonical == 1);
    signum_space_tessellation_free(t);

    o.progress = looks_around;
    o.user = &handles;
    SUCCEEDS(signum_triangulate_space(scatter, many, 3, &o, &t, &error));
    signum_space_tessellation_free(t);
    EXPECT(handles.calls > 0);
    o.progress = stops;
    o.user = &calls;
    FAILS(signum_triangulate_space(scatter, many, 3, &o, &t, &error), SIGNUM_STOPPED, -1);
    EXPECT(t == NULL && calls == 1);
    o.progress = NULL;
    o.arithmetic = SIGNUM_SUM;
    REFUSED(signum_triangulate_space(scatter, 10, 3, &o, &t, &error));
    scatter[7] = -INFINITY;
    /* Of too many none is looked at: not site 2, nor what lies behind the array. */
    REFUSED(signum_triangulate_space(scatter, ((int64_t)1 << 28) + 1, 3, NULL, &t, &error));
    FAILS(signum_triangulate_space(scatter, 10, 3, NULL, &t, &error), SIGNUM_INVALID_ARGUMENT, 2);
    REFUSED(signum_triangulate_space(scatter, 10, 2, NULL, &t, &error));
    REFUSED(signum_triangulate_space(NULL, 10, 3, NULL, &t, &error));
    REFUSED(signum_triangulate_space(scatter, 1, 3, NULL, NULL, &error));
    free(scatter);
}

int main(void) {
    in_the_plane();
    what_is_refused();
    options();
    diagrams();
    in_space();
    return mistakes != 0;
}
