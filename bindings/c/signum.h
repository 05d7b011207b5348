#ifndef SIGNUM_SIGNUM_H
#define SIGNUM_SIGNUM_H
/// The C interface of signum: predicates, tessellations in the plane and in space, such that change
/// and such that move, Voronoi diagrams, balls that strike. C99; C++ may include it, too.
///
///     const double sites[] = {0, 0, 4, 0, 0, 3, 4, 3};
///     signum_tessellation* t = NULL;
///     signum_error error;
///     if (signum_triangulate(sites, 4, 2, SIGNUM_EUCLIDEAN, NULL, &t, &error) != SIGNUM_OK)
///         return fprintf(stderr, "%s\n", error.message), 1;
///     signum_arrays a = SIGNUM_ARRAYS;
///     signum_tessellation_arrays(t, &a, NULL);
///     for (int64_t f = 0; f < a.face_count; ++f)
///         printf("%d %d %d\n", a.faces[3 * f], a.faces[3 * f + 1], a.faces[3 * f + 2]);
///     signum_tessellation_free(t);
///
/// Laws:
///  1. A function that can fail returns a signum_status and takes, last, a signum_error, which may
///     be null. After a failure its results are as they were, but handles, which are null. What is
///     refused (a null pointer or handle, a number that is not finite, a handle that there is not)
///     is SIGNUM_INVALID_ARGUMENT. No exception leaves the library.
///  2. Who creates a handle frees it, with the function named for it; to free null does nothing.
///     Arrays that a handle shows are its own, and stay until it is freed or, where that is said,
///     changed. Arrays that are given are read during the call alone.
///  3. There is no state but that of handles: any number of threads may call anything, and share a
///     handle as long as nobody changes it. Functions that take it as const only read.
///  4. Results are those of the C++ library, whose words these are: <signum/signum.hpp>.
///  5. Coordinates are in any one unit, times in any other. Doubles are taken as exact numbers. The
///     plane is right-handed: counterclockwise is from x to y.
///  6. Structs that may grow begin with their size, which their initializers set (SIGNUM_OPTIONS
///     and others). Programs compiled with an older, shorter one go on, with what it lacks as the
///     initializer has it. A longer one than the library's is refused.
///  7. Callbacks may neither throw nor jump out. From one every function with the handle that is at
///     work and a signum_status is refused; those that count (_size, _contains, _strikes) answer,
///     and to free the handle does nothing.

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---- versions ----------------------------------------------------------------------------------

#define SIGNUM_VERSION_MAJOR 0
#define SIGNUM_VERSION_MINOR 1
#define SIGNUM_VERSION_PATCH 0
#define SIGNUM_VERSION "0.1.0"
/// Raised by what a compiled program would notice: a function that goes or changes, a struct whose
/// fields move. Not by functions that come, nor by structs that grow at their end.
#define SIGNUM_ABI 1

/// That of the library, as SIGNUM_VERSION is that of the header.
const char* signum_version(void);
/// That of the library. Who loads it at run time compares it with SIGNUM_ABI.
int32_t signum_abi(void);

// ---- errors ------------------------------------------------------------------------------------

typedef int32_t signum_status;
enum {
    SIGNUM_OK = 0,
    SIGNUM_INVALID_ARGUMENT = 1,  ///< the caller's mistake
    SIGNUM_NO_MEMORY = 2,         ///< what changes may only be freed, but for a signum_dynamic
    SIGNUM_STOPPED = 3,           ///< a callback asked for it
    SIGNUM_BROKEN_STRUCTURE = 4,  ///< inexact arithmetic led astray; exact arithmetic never does
    SIGNUM_BEYOND_RANGE = 5,      ///< the result is more than its doubles or integers can tell
    SIGNUM_INTERNAL = 6           ///< a mistake of the library
};

/// What went wrong; after a success SIGNUM_OK, -1 and "". Filled by the function that it is given
/// to.
typedef struct signum_error {
    signum_status status;
    int32_t reserved;
    int64_t site;       ///< the site, ball or handle that is to blame; -1 where it is no single one
    char message[240];  ///< for people, may change; longer ones are cut off
} signum_error;

// ---- words -------------------------------------------------------------------------------------

/// The distance of a point p from a site with centre c and radius r.
typedef int32_t signum_metric;
enum {
    SIGNUM_POWER = 0,      ///< |p - c|^2 - r^2; points have Delaunay's triangulation
    SIGNUM_EUCLIDEAN = 1,  ///< |p - c| - r
    SIGNUM_MANHATTAN = 2,  ///< the same in the norm |x| + |y|
    SIGNUM_SUPREMUM = 3    ///< the same in the norm max(|x|, |y|)
};

/// What the third number of a site means (in space the fourth).
typedef int32_t signum_weight_is;
enum {
    SIGNUM_RADIUS = 0,
    SIGNUM_WEIGHT = 1  ///< w instead of r^2: power metric alone
};

/// The vertex at infinity, in faces and cells.
#define SIGNUM_INFINITE (-1)
/// In cells of flat sites of space, which have fewer than four vertices.
#define SIGNUM_NO_VERTEX (-2)

// ---- predicates --------------------------------------------------------------------------------
//
// They answer -1, 0 or +1, or yes (1) and no (0), exactly for all finite doubles; and
// SIGNUM_NO_SIGN for a null pointer, a number that is not finite, a metric that there is not. O(1).
// The last stages claim a few kilobytes; where there are none the program ends.
//
// A site is {x, y, r}, in space {x, y, z, r}. Names that end in _points take {x, y} and {x, y, z},
// those that end in _weights {x, y, w} and {x, y, z, w}, both in the power metric.

#define SIGNUM_NO_SIGN (-2)

/// +1 where a, b, c turn counterclockwise, 0 where they are collinear, -1 otherwise.
int signum_ccw(const double a[2], const double b[2], const double c[2]);
/// Whether a circle (diamond, square) touches i, j, k counterclockwise, ties decided by the tie
/// rule; in the power metric whether ccw of their centres is +1.
int signum_exists(signum_metric metric, const double i[3], const double j[3], const double k[3]);
/// +1 where q conflicts with the vertex of i, j, k (is nearer than they are), 0 where it touches,
/// -1 otherwise. Preconditions: signum_exists(i, j, k), and q is hidden by none of them. Where they
/// do not hold any sign may be told; a library built with assertions ends the program, here and
/// below.
int signum_in_circle(signum_metric metric, const double i[3], const double j[3], const double k[3],
                     const double q[3]);
int signum_in_circle_points(const double i[2], const double j[2], const double k[2],
                            const double q[2]);
int signum_in_circle_weights(const double i[3], const double j[3], const double k[3],
                             const double q[3]);
/// The same at the hull edge a -> b, all other sites on its left. Preconditions: neither of a and b
/// hides the other; in the power metric their centres differ.
int signum_in_circle_infinite(signum_metric metric, const double a[3], const double b[3],
                              const double q[3]);
int signum_in_circle_infinite_points(const double a[2], const double b[2], const double q[2]);
int signum_in_circle_infinite_weights(const double a[3], const double b[3], const double q[3]);
/// signum_in_circle under the tie rule, never 0; q may be hidden. `ranks` are the places of i, j, k
/// and q in the rule's order: falling radius (power metric: weight, the square of it), rising x, y,
/// index. Only their order counts.
int signum_in_circle_perturbed(signum_metric metric, const double i[3], const double j[3],
                               const double k[3], const double q[3], const int32_t ranks[4]);
int signum_in_circle_infinite_perturbed(signum_metric metric, const double a[3], const double b[3],
                                        const double q[3], const int32_t ranks[3]);
/// Whether i alone hides q: covers it, the same place and size included.
int signum_hidden(signum_metric metric, const double q[3], const double i[3]);
int signum_hidden_weights(const double q[3], const double i[3]);
/// +1 where the point p is nearer to a than to b, -1 where it is not; where both are as near 0 in
/// the power metric, elsewhere as the tie rule says.
int signum_nearer(signum_metric metric, const double p[2], const double a[3], const double b[3]);
int signum_nearer_weights(const double p[2], const double a[3], const double b[3]);

/// +1 where det(b-a, c-a, d-a) > 0, 0 where the four are coplanar, -1 otherwise.
int signum_ccw_space(const double a[3], const double b[3], const double c[3], const double d[3]);

/// Answered by signum_spheres.
#define SIGNUM_INFINITELY_MANY 1000
/// How many spheres signum_in_sphere may be asked about: of the power and the Euclidean metric 1
/// where one touches i, j, k, l positively oriented and 0 otherwise; of the supremum metric (cubes)
/// at most 2 and of the Manhattan metric (octahedra) at most 6, or SIGNUM_INFINITELY_MANY, and no
/// orientation.
int signum_spheres(signum_metric metric, const double i[4], const double j[4], const double k[4],
                   const double l[4]);
/// Of sphere number n of signum_spheres(i, j, k, l), from 0 on: +1 where q conflicts with it (is
/// nearer to its centre than they are), 0 where it touches it, -1 otherwise. SIGNUM_NO_SIGN where
/// there is no such sphere. (Cubes and octahedra come in the order of
/// predicates/space/rectangular.hpp.)
int signum_in_sphere(signum_metric metric, const double i[4], const double j[4], const double k[4],
                     const double l[4], const double q[4], int n);
/// In the power metric, without a look at whether it exists: the precondition is that
/// signum_ccw_space(i, j, k, l) is +1.
int signum_in_sphere_points(const double i[3], const double j[3], const double k[3],
                            const double l[3], const double q[3]);
int signum_in_sphere_weights(const double i[4], const double j[4], const double k[4],
                             const double l[4], const double q[4]);
/// Whether i alone hides q.
int signum_hidden_space(signum_metric metric, const double q[4], const double i[4]);
/// In the power metric: +1 where the point p is nearer to a than to b, 0 where both are as near, -1
/// otherwise.
int signum_nearer_space(const double p[3], const double a[4], const double b[4]);

/// signs[m] = signum_ccw of row m of a, b and c, for `count` rows of two numbers each, by vectors
/// where the library has them. SIGNUM_NO_SIGN, and nothing is written, for a null pointer or a
/// number that is not finite; 0 otherwise. O(count).
int signum_ccw_batch(const double* a, const double* b, const double* c, size_t count,
                     int8_t* signs);
/// The same of signum_in_circle_points.
int signum_in_circle_points_batch(const double* i, const double* j, const double* k,
                                  const double* q, size_t count, int8_t* signs);

/// The sign of terms[0] + terms[1] + ..., fewer than 2^32 of them. O(count log count) at most;
/// allocates only above 512 terms, and where it cannot the program ends.
int signum_sign_of_sum(const double* terms, size_t count);

// ---- tessellations of the plane ----------------------------------------------------------------

/// The exact ones give the same tessellation.
typedef int32_t signum_arithmetic;
enum {
    SIGNUM_EXACT = 0,          ///< filters, then ever dearer stages
    SIGNUM_NAIVE = 1,          ///< doubles, whose word is taken for the truth
    SIGNUM_SINGLE = 2,         ///< the same in floats
    SIGNUM_INTERVAL = 3,       ///< intervals, then exact sums
    SIGNUM_SUM = 4,            ///< exact sums alone
    SIGNUM_MULTIPRECISION = 5  ///< rationals alone
};

/// The result is the same.
typedef int32_t signum_method;
enum {
    SIGNUM_INCREMENTAL = 0,  ///< site by site
    SIGNUM_FLIPS = 1,        ///< power metric, exact arithmetic
    SIGNUM_SWEEP = 2         ///< Manhattan and supremum metric
};

/// Called now and then, by the calling thread, with the share of the work that is done, from 0
/// to 1. Anything but 0 stops the work, which then fails with SIGNUM_STOPPED. Small work may never
/// call it.
typedef int (*signum_progress)(double done, void* user);

typedef struct signum_options {
    size_t size;
    signum_arithmetic arithmetic;
    signum_method method;
    signum_weight_is weight_is;
    /// How many threads work; the result does not depend on it. 0: as many as there are cores to
    /// use. At most 1024.
    int32_t threads;
    uint64_t seed;             ///< of the order of insertion; the result does not depend on it
    signum_progress progress;  ///< may be null
    void* user;                ///< for progress
} signum_options;
#define SIGNUM_OPTIONS \
    { sizeof(signum_options), SIGNUM_EXACT, SIGNUM_INCREMENTAL, SIGNUM_RADIUS, 0, 1, NULL, NULL }

typedef struct signum_tessellation signum_tessellation;

/// The tessellation of `count` sites, the first numbers of which stand `stride` doubles apart: of 2
/// doubles points, x and y; of 3 or more the third one is the radius or weight, and the rest is not
/// looked at. `options` may be null. Refuses, naming the site, numbers that are not finite (with
/// SIGNUM_SINGLE beyond 3.4e38), more than 357 913 941 sites, methods, arithmetics and weights that
/// the metric has not. O(n log n) expected on sites spread at random, O(n^2) in the worst case.
signum_status signum_triangulate(const double* sites, int64_t count, int64_t stride,
                                 signum_metric metric, const signum_options* options,
                                 signum_tessellation** tessellation, signum_error* error);
void signum_tessellation_free(signum_tessellation* tessellation);

/// A tessellation as plain arrays. A face is a counterclockwise triple of sites, the smallest first
/// (-1 is infinity); faces are sorted. neighbours[3f + k] is the face across the edge opposite
/// faces[3f + k]. A hidden site has an empty cell; beside it stands the visible site nearest to its
/// centre. n >= 2 visible sites have 2n - 2 faces.
typedef struct signum_arrays {
    size_t size;
    signum_metric metric;
    signum_weight_is weight_is;
    int64_t sites;  ///< how many
    int64_t face_count;
    const int32_t* faces;       ///< 3 a face
    const int32_t* neighbours;  ///< 3 a face
    int64_t hidden_count;
    const int32_t* hidden;  ///< 2 each: the site, and by whom; sorted by site
} signum_arrays;
#define SIGNUM_ARRAYS \
    { sizeof(signum_arrays), SIGNUM_POWER, SIGNUM_RADIUS, 0, 0, NULL, NULL, 0, NULL }

/// Shows the arrays of a tessellation, which stay until it is freed. O(1).
signum_status signum_tessellation_arrays(const signum_tessellation* tessellation,
                                         signum_arrays* arrays, signum_error* error);
/// The vertices of the diagram, x, y and the distance rho to its three sites a face: the nearest
/// doubles to the exact numbers, NaN where there are none. `count` is that of the doubles that
/// there is room for, three a face. O(n).
signum_status signum_tessellation_vertices(const signum_tessellation* tessellation,
                                           double* vertices, int64_t count, signum_error* error);
/// In the power metric a face whose closure contains the point, elsewhere the first face at the
/// nearest site; -1 where there is no face. O(n^(1/3)) expected on uniform sites.
signum_status signum_tessellation_locate(const signum_tessellation* tessellation,
                                         const double point[2], int32_t* face, signum_error* error);
/// The site whose cell contains the point; -1 without sites. O(n^(1/3)) expected on uniform sites.
signum_status signum_tessellation_nearest(const signum_tessellation* tessellation,
                                          const double point[2], int32_t* site,
                                          signum_error* error);

typedef struct signum_validation {
    int32_t valid;      ///< whether it is a tessellation of the sites
    int32_t canonical;  ///< whether it is the one that the tie rule chooses, in canonical order
    /// What is wrong and where; "" where nothing is.
    char message[248];
} signum_validation;

/// Certifies arrays, whoever made them, against the sites, from scratch. They may hold any numbers;
/// neighbours may be null where no two sites share several edges. Metric and weight_is are those of
/// the arrays; of the options progress and threads are heeded. What is wrong with the arrays is
/// told by `validation`, what with the sites by the status. O(n log n).
signum_status signum_validate(const signum_arrays* arrays, const double* sites, int64_t count,
                              int64_t stride, const signum_options* options,
                              signum_validation* validation, signum_error* error);

// ---- Voronoi diagrams of the plane -------------------------------------------------------------

/// The diagram of a tessellation, which it copies.
typedef struct signum_voronoi signum_voronoi;

/// Cells, counterclockwise walks along edges, are to be had in C++; of C are the arrays and areas.
typedef struct signum_diagram_arrays {
    size_t size;
    int64_t vertex_count;
    const double* vertices;  ///< x, y, rho each
    int64_t edge_count;
    /// 6 each: the sites left and right of it, the vertices it leads from and to (-1 is infinity),
    /// and the faces of the tessellation on whose circles it ends.
    const int32_t* edges;
} signum_diagram_arrays;
#define SIGNUM_DIAGRAM_ARRAYS \
    { sizeof(signum_diagram_arrays), 0, NULL, 0, NULL }

/// With `merge`, neighbouring faces whose circles are the same share a vertex, and the edge between
/// them leads from it to itself. O(n).
signum_status signum_voronoi_create(const signum_tessellation* tessellation, int32_t merge,
                                    signum_voronoi** voronoi, signum_error* error);
void signum_voronoi_free(signum_voronoi* voronoi);
/// Shows arrays that stay until the diagram is freed. O(1).
signum_status signum_voronoi_arrays(const signum_voronoi* voronoi, signum_diagram_arrays* arrays,
                                    signum_error* error);
/// The area of every site's cell in a box {x0, y0, x1, y1}, rounded; they tile it. Null is the
/// smallest box around all centres, wider by a tenth of its longer side. `count` is that of the
/// sites. O(n).
signum_status signum_voronoi_areas(const signum_voronoi* voronoi, const double box[4],
                                   double* areas, int64_t count, signum_error* error);

// ---- tessellations of space --------------------------------------------------------------------

typedef struct signum_space_tessellation signum_space_tessellation;

/// The power tessellation of sites in space: `stride` 3 is of points, 4 or more of sites whose
/// fourth number is a radius or weight. Of the options method is not looked at, and arithmetic may
/// be exact or naive. O(n log n) expected on sites spread at random, O(n^2) in the worst case. At
/// most 2^28 sites.
signum_status signum_triangulate_space(const double* sites, int64_t count, int64_t stride,
                                       const signum_options* options,
                                       signum_space_tessellation** tessellation,
                                       signum_error* error);
void signum_space_tessellation_free(signum_space_tessellation* tessellation);

/// A cell has four vertices that turn positively, its smallest number first and the next smallest
/// second; of flat sites fewer (SIGNUM_NO_VERTEX). neighbours[4c + k] is the cell across from
/// cells[4c + k].
typedef struct signum_space_arrays {
    size_t size;
    /// That of what the centres span: 3, 2 in a plane, 1 on a line, 0 in one place, -1 of none.
    int32_t dimension;
    int32_t reserved;
    int64_t sites;
    int64_t cell_count;
    const int32_t* cells;       ///< 4 a cell
    const int32_t* neighbours;  ///< 4 a cell
    int64_t hidden_count;
    const int32_t* hidden;  ///< 2 each, as in the plane
} signum_space_arrays;
#define SIGNUM_SPACE_ARRAYS \
    { sizeof(signum_space_arrays), -1, 0, 0, 0, NULL, NULL, 0, NULL }

/// As in the plane.
signum_status signum_space_tessellation_arrays(const signum_space_tessellation* tessellation,
                                               signum_space_arrays* arrays, signum_error* error);
/// x, y, z and rho a cell: `count` is 4 a cell. NaN in cells at infinity and in flat ones.
signum_status signum_space_tessellation_vertices(const signum_space_tessellation* tessellation,
                                                 double* vertices, int64_t count,
                                                 signum_error* error);
/// As in the plane; what the fourth number is the options say. Neighbours are needed. O(n).
signum_status signum_validate_space(const signum_space_arrays* arrays, const double* sites,
                                    int64_t count, int64_t stride, const signum_options* options,
                                    signum_validation* validation, signum_error* error);

// ---- a tessellation that changes ---------------------------------------------------------------

/// Sites come, go, grow and move. A handle, the least that is free, names a site until that is
/// erased. Where SIGNUM_NO_MEMORY leaves a change, the sites are those before it.
typedef struct signum_dynamic signum_dynamic;

signum_status signum_dynamic_create(signum_metric metric, signum_weight_is weight_is,
                                    signum_dynamic** dynamic, signum_error* error);
void signum_dynamic_free(signum_dynamic* dynamic);
/// O(sqrt n) expected for sites in no order, and O(degree): in an order along a curve the new one
/// may be a neighbour of most. `handle` may be null.
signum_status signum_dynamic_insert(signum_dynamic* dynamic, const double site[3], int32_t* handle,
                                    signum_error* error);
/// O(degree log degree) expected, O(degree^2) at most, and an insertion for each site that it hid.
signum_status signum_dynamic_erase(signum_dynamic* dynamic, int32_t handle, signum_error* error);
/// Gives a site another radius or weight. As erase and insert.
signum_status signum_dynamic_change(signum_dynamic* dynamic, int32_t handle, double third,
                                    signum_error* error);
/// Gives a site another centre. O(degree) where its neighbours stay.
signum_status signum_dynamic_move(signum_dynamic* dynamic, int32_t handle, const double centre[2],
                                  signum_error* error);
/// Gives every site another centre, x and y each, in the order of their handles; `count` is that of
/// the centres, and of the sites. A refusal changes nothing. O(n).
signum_status signum_dynamic_move_all(signum_dynamic* dynamic, const double* centres, int64_t count,
                                      signum_error* error);
/// Whether there is a site of that handle; of null 0.
int signum_dynamic_contains(const signum_dynamic* dynamic, int32_t handle);
/// How many sites there are; of null 0.
int64_t signum_dynamic_size(const signum_dynamic* dynamic);
signum_status signum_dynamic_site(const signum_dynamic* dynamic, int32_t handle, double site[3],
                                  signum_error* error);
/// The tessellation of the sites that are there, numbered from 0 in the order of their handles: a
/// handle of its own, to be freed by the caller. O(n log n).
signum_status signum_dynamic_tessellation(const signum_dynamic* dynamic,
                                          signum_tessellation** tessellation, signum_error* error);

// ---- a power tessellation whose sites move -----------------------------------------------------

/// At time t the centre is (x, y) + (vx, vy)(t - time), and in a fall g (t - time)^2 / 2 more.
typedef struct signum_moving_site {
    double x;
    double y;
    double vx;
    double vy;
    double r;
    double time;
} signum_moving_site;

/// Kept up exactly from event to event. After SIGNUM_NO_MEMORY it may only be freed.
typedef struct signum_kinetic signum_kinetic;

/// Sites get the handles 0, 1, 2 ...; `fall` is the acceleration of all, null none.
signum_status signum_kinetic_create(const signum_moving_site* sites, int64_t count, double start,
                                    const double fall[2], signum_kinetic** kinetic,
                                    signum_error* error);
void signum_kinetic_free(signum_kinetic* kinetic);
/// O(n^(1/3)) expected. `handle` may be null.
signum_status signum_kinetic_insert(signum_kinetic* kinetic, const signum_moving_site* site,
                                    int32_t* handle, signum_error* error);
signum_status signum_kinetic_erase(signum_kinetic* kinetic, int32_t handle, signum_error* error);
/// From now on the site moves otherwise. O(degree) where its neighbours stay.
signum_status signum_kinetic_change(signum_kinetic* kinetic, int32_t handle,
                                    const signum_moving_site* site, signum_error* error);
/// Of null 0.
int signum_kinetic_contains(const signum_kinetic* kinetic, int32_t handle);
int64_t signum_kinetic_size(const signum_kinetic* kinetic);
signum_status signum_kinetic_site(const signum_kinetic* kinetic, int32_t handle,
                                  signum_moving_site* site, signum_error* error);
/// Where it stands.
signum_status signum_kinetic_time(const signum_kinetic* kinetic, double* time, signum_error* error);
/// A time at which faces may change; infinity where none is ahead.
signum_status signum_kinetic_next_event(const signum_kinetic* kinetic, double* time,
                                        signum_error* error);
/// Goes on to a time, all that happens until then and at it included. Refuses one before its own.
/// O(log n) expected an event.
signum_status signum_kinetic_advance(signum_kinetic* kinetic, double time, signum_error* error);
/// The finite faces right after time(), triples of handles. They stay until the handle is freed, or
/// this is called again. O(n log n).
signum_status signum_kinetic_faces(signum_kinetic* kinetic, const int32_t** faces, int64_t* count,
                                   signum_error* error);
/// The tessellation of the sites where they are now, rounded, numbered from 0 in the order of their
/// handles: a handle of its own. SIGNUM_BEYOND_RANGE where a place is beyond the doubles. O(n log
/// n).
signum_status signum_kinetic_tessellation(const signum_kinetic* kinetic,
                                          signum_tessellation** tessellation, signum_error* error);
/// From now on on_edge is called for each edge a < b between two sites that comes or goes while a
/// function is at work; null ends it. Law 7: from it nothing is to be asked of this handle.
signum_status signum_kinetic_watch(signum_kinetic* kinetic,
                                   void (*on_edge)(int32_t a, int32_t b, int comes, void* user),
                                   void* user, signum_error* error);

// ---- balls in flight ---------------------------------------------------------------------------
//
// In the plane third coordinates are not looked at, and are told as 0.

/// At `time` its centre is x and its velocity v; it flies on x + v s + g s^2 / 2, s = t - time.
typedef struct signum_ball {
    double x[3];
    double v[3];
    double radius;
    double time;
    double mass;
} signum_ball;

typedef int32_t signum_box;
enum {
    SIGNUM_NO_BOX = 0,
    SIGNUM_WALLS = 1,    ///< balls strike its sides
    SIGNUM_PERIODIC = 2  ///< the cell of a periodic world
};

typedef int32_t signum_obstacle_kind;
enum {
    SIGNUM_HALF_SPACE = 0,  ///< balls are where at . x >= size + speed t
    SIGNUM_PILLAR = 1,      ///< a circle or sphere; balls are outside
    SIGNUM_DRUM = 2,        ///< the same; balls are inside
    SIGNUM_SEGMENT = 3      ///< a thin wall in the plane, at rest, struck from both sides
};

/// What balls strike beside the box. It has no mass.
typedef struct signum_obstacle {
    signum_obstacle_kind kind;
    int32_t reserved;
    double at[3];  ///< the normal of a half space; a centre at t = 0; one end of a segment
    double to[3];  ///< the velocity of a centre; the other end of a segment
    double size;   ///< the offset of a half space, times |at|; a radius, from 0
    double speed;  ///< of a half space along its normal, times |at|
} signum_obstacle;

/// What acts on balls. docs/motion.md says what each effect does, and which go together: a box that
/// shakes has SIGNUM_WALLS, a fluid and contacts that last have a time step. Of an effect that is
/// off no other number is looked at.
typedef struct signum_effects {
    size_t size;
    int32_t dimension;  ///< 2 or 3
    signum_box box;
    double low[3];  ///< low < high along each axis, where there is a box
    double high[3];
    double gravity[3];
    double restitution;       ///< of two balls, from 0 to 1, elastic
    double wall_restitution;  ///< of a ball and a wall
    double contact_duration;  ///< a strike is elastic that follows one within it; 0 is never
    double growth_rate;       ///< radii are r (1 + rate t), 0 is none
    double growth_until;
    double law_speed;      ///< restitutions are those at this speed; 0: they do not depend on it
    double law_power;      ///< 1 - restitution goes as speed to that power, above 0, at most 8
    int32_t has_friction;  ///< whether balls spin, and rub; else the next four are not looked at
    int32_t reserved;
    double friction;                ///< of two balls, from 0
    double wall_friction;           ///< of a ball and a wall
    double tangential_restitution;  ///< from -1 to 1: 0 stops the sliding, 1 turns it back
    double inertia;                 ///< I / m r^2, above 0, at most 1: 1/2 of discs, 2/5 of balls
    double shake_amplitude[3];      ///< the box's sides go by amplitude sin(frequency t + phase)
    double shake_frequency;         ///< in radians per unit of time; 0: the box does not shake
    double shake_phase;             ///< in radians
    double fluid_velocity[3];       ///< at the origin
    double fluid_gradient[9];       ///< of axis k along axis l at 3 k + l
    double fluid_linear;            ///< drag, from 0; both 0: there is no fluid
    double fluid_quadratic;         ///< from 0
    double contact_speed;           ///< who would part slower stays in contact; 0 is nobody
    double contact_tolerance;       ///< between 0 and 1
    int32_t contact_sweeps;         ///< from 2
    int32_t reserved_too;
    double time_step;  ///< forces act in steps of that time; 0: flights are parabolas
    const signum_obstacle* obstacles;  ///< their walls are numbered from 2 * dimension on
    int64_t obstacle_count;
} signum_effects;
/// Of free flight and elastic strikes.
#define SIGNUM_EFFECTS(dimension)                                                                  \
    {                                                                                              \
        sizeof(signum_effects), (dimension), SIGNUM_NO_BOX, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1, 1, \
            0, 0, 0, 0, 0.2, 0, 0, 0, 0, 0, 0.5, {0, 0, 0}, 0, 0, {0, 0, 0},                       \
            {0, 0, 0, 0, 0, 0, 0, 0, 0}, 0, 0, 0, 1e-10, 1000, 0, 0, NULL, 0                       \
    }

/// When two balls meet: the nearest double to the exact time, not before the later of their own
/// times; infinity where never. Heeded are gravity, growth and a periodic box; in this one meetings
/// later than `until` are none, and the search takes time in proportion to the box lengths flown
/// until then. Masses are not looked at.
signum_status signum_meeting_time(const signum_ball* a, const signum_ball* b,
                                  const signum_effects* effects, double until, double* time,
                                  signum_error* error);

/// Two balls a < b, or ball a and wall b: 2 axis, 1 more for the upper one; then the obstacles.
typedef struct signum_strike {
    double time;
    double impulse;  ///< along the normal
    int32_t wall;    ///< whether b is one
    int32_t a;
    int32_t b;
    int32_t reserved;
} signum_strike;

typedef int32_t signum_ending;
enum {
    SIGNUM_UNTIL = 0,              ///< the time came
    SIGNUM_STRIKES = 1,            ///< so many are done
    SIGNUM_NOTHING = 2,            ///< nothing meets any more
    SIGNUM_STOPPED_BY_CALLER = 3,  ///< a callback said so
    SIGNUM_COLLAPSE = 4            ///< balls strike without end
};

typedef struct signum_limits {
    size_t size;
    double until;      ///< events at that time are included
    uint64_t strikes;  ///< from now on
    /// Called with each strike right before it is done; anything but 0 stops, and the next run
    /// begins with that strike. May be null.
    int (*record)(const signum_strike* strike, void* user);
    int (*stop)(void* user);  ///< asked now and then whether to stop; may be null
    void* user;               ///< for both
} signum_limits;
/// Without end. Balls in a periodic box that never meet fly for ever, then.
#define SIGNUM_LIMITS \
    { sizeof(signum_limits), HUGE_VAL, UINT64_MAX, NULL, NULL, NULL }

/// The balls of one simulation. After SIGNUM_NO_MEMORY it may only be freed.
typedef struct signum_simulation signum_simulation;

/// Balls at t = 0, their own times not looked at. Refuses, naming the ball, numbers that are not
/// finite or beyond 2^150, negative radii, masses that are not positive, balls outside their walls
/// or that overlap. O(n) expected for balls of like sizes.
signum_status signum_simulation_create(const signum_ball* balls, int64_t count,
                                       const signum_effects* effects,
                                       signum_simulation** simulation, signum_error* error);
void signum_simulation_free(signum_simulation* simulation);
/// Goes on as far as the limits say. `ending` and `last` (of a collapse who struck last) may be
/// null. SIGNUM_BEYOND_RANGE where a ball flies so fast, or so late, that the clock cannot tell its
/// strike from a miss. O(1) expected a strike in a gas.
signum_status signum_simulation_run(signum_simulation* simulation, const signum_limits* limits,
                                    signum_ending* ending, signum_strike* last,
                                    signum_error* error);
/// The time before which nothing is left to do.
signum_status signum_simulation_time(const signum_simulation* simulation, double* time,
                                     signum_error* error);
/// The balls in their order, each at its own time; `count` is theirs. O(n).
signum_status signum_simulation_balls(const signum_simulation* simulation, signum_ball* balls,
                                      int64_t count, signum_error* error);
/// How fast they turn, three numbers a ball, `count` balls: the angular velocity about each axis,
/// in the plane about the third. Balls start without; 0 where there is no friction. O(n).
signum_status signum_simulation_spins(const signum_simulation* simulation, double* spins,
                                      int64_t count, signum_error* error);
/// How many; of null 0.
int64_t signum_simulation_size(const signum_simulation* simulation);
/// How many strikes have been done; of null 0.
uint64_t signum_simulation_strikes(const signum_simulation* simulation);

// Questions, which disturb nothing: a copy looks ahead. O(n) to make it.

/// The first strike later than `time` and not later than `until`; `found` is 0 where there is none.
signum_status signum_simulation_next_strike(const signum_simulation* simulation, double time,
                                            double until, int32_t* found, signum_strike* strike,
                                            signum_error* error);
/// The nearest neighbour of a ball at the present time, and the gap between their surfaces, the
/// nearest double; -1 and infinity of a ball alone. Which of two gaps is less is decided exactly.
/// O(n).
signum_status signum_simulation_nearest(const signum_simulation* simulation, int32_t ball,
                                        int32_t* neighbour, double* gap, signum_error* error);
/// The closest pair at the present time; -1 twice and infinity where there are fewer than two
/// balls. O(n log n) expected.
signum_status signum_simulation_closest_pair(const signum_simulation* simulation, int32_t* a,
                                             int32_t* b, double* gap, signum_error* error);

#ifdef __cplusplus
}  // extern "C"
#endif

#endif
