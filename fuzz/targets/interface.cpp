#include "interface.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

#include "../../bindings/c/signum.h"
#include "../../signum.hpp"

#include "bytes.hpp"

namespace signum::fuzz {
namespace {

constexpr std::size_t most_bytes = 600;
constexpr std::size_t most_sites = 24;
constexpr std::int64_t any_handle = std::numeric_limits<std::int32_t>::max();

/// Mostly numbers on a small grid; otherwise any eight bytes, and now and then what is no number.
double any_number(Choices& choices) {
    const int kind = choices.below(16);
    if (kind < 12) return choices.coordinate();
    if (kind == 12)
        return choices.below(2) == 0 ? std::numeric_limits<double>::infinity() : std::nan("");
    std::array<std::uint8_t, 8> raw;
    for (std::uint8_t& byte : raw) byte = choices.byte();
    return std::bit_cast<double>(raw);
}
template <std::size_t n>
std::array<double, n> numbers(Choices& choices) {
    std::array<double, n> result;
    for (double& number : result) number = any_number(choices);
    return result;
}
template <class... Numbers>
bool all_finite(const Numbers&... of) {
    const auto are = [](const auto& each) {
        return std::ranges::all_of(each, [](double x) { return std::isfinite(x); });
    };
    return (... && are(of));
}
/// One of those that there are, or one beside them.
std::int32_t word(Choices& choices, int count) {
    return choices.below(count + 2) - 1;
}

void must_be_a_sign(int sign, bool is_asked_well) {
    must(is_asked_well ? sign >= -1 && sign <= 1 : sign == SIGNUM_NO_SIGN,
         "a sign of what has none, or none");
}

/// What every call that can fail keeps to.
class Calls {
 public:
    signum_error* error() {
        std::memset(&error_, 0x55, sizeof error_);
        return &error_;
    }
    /// Whether it succeeded. `count` is that of the sites that it may blame, or any_handle.
    bool went_well(signum_status status, std::int64_t count) const {
        must(error_.status == status, "another status than the error's");
        must(std::memchr(error_.message, 0, sizeof error_.message) != nullptr,
             "a message without an end");
        must((status == SIGNUM_OK) == (error_.message[0] == '\0'), "a failure without a message");
        must(status != SIGNUM_INTERNAL, "a mistake of the library");
        must(status != SIGNUM_BROKEN_STRUCTURE, "a structure that exact arithmetic led astray");
        must(status >= SIGNUM_OK && status <= SIGNUM_BEYOND_RANGE, "a status that there is not");
        must(error_.site >= -1 && error_.site < count, "a site that there is not");
        return status == SIGNUM_OK;
    }

 private:
    signum_error error_{};
};

signum_options any_options(Choices& choices) {
    signum_options options = SIGNUM_OPTIONS;
    if (choices.below(8) == 0) options.size = choices.byte();
    if (choices.below(4) == 0) options.method = word(choices, 3);
    if (choices.below(4) == 0) options.weight_is = word(choices, 2);
    // Arithmetic that rounds may be led astray.
    if (choices.below(4) == 0)
        options.arithmetic = choices.below(2) == 0 ? SIGNUM_INTERVAL : SIGNUM_MULTIPRECISION;
    if (choices.below(16) == 0) options.arithmetic = 6 + choices.byte();
    options.seed = choices.byte();
    return options;
}

void build_in_plane(Choices& choices) {
    Calls calls;
    const signum_metric metric = word(choices, 4);
    const signum_options options = any_options(choices);
    const std::int64_t stride = choices.below(8) == 0 ? choices.below(6) - 1 : 3;
    std::vector<double> sites;
    while (choices.are_left() && sites.size() < 3 * most_sites) {
        const auto [x, y, r] = numbers<3>(choices);
        sites.insert(sites.end(), {x, y, r});
    }
    const auto count = static_cast<std::int64_t>(sites.size()) / std::max<std::int64_t>(stride, 3);
    signum_tessellation* tessellation = nullptr;
    if (!calls.went_well(signum_triangulate(sites.data(), count, stride, metric, &options,
                                            &tessellation, calls.error()),
                         count)) {
        must(tessellation == nullptr, "a handle of what failed");
        return;
    }
    signum_arrays arrays = SIGNUM_ARRAYS;
    must(calls.went_well(signum_tessellation_arrays(tessellation, &arrays, calls.error()), count),
         "no arrays");
    must(arrays.sites == count, "another number of sites");
    signum_validation verdict{};
    must(calls.went_well(signum_validate(&arrays, sites.data(), count, stride, nullptr, &verdict,
                                         calls.error()),
                         count),
         "no verdict");
    must(verdict.valid != 0 && verdict.canonical != 0,
         "a tessellation that is not the canonical one");
    std::vector<double> vertices(static_cast<std::size_t>(3 * arrays.face_count));
    must(calls.went_well(signum_tessellation_vertices(tessellation, vertices.data(),
                                                      3 * arrays.face_count, calls.error()),
                         count),
         "no vertices");
    must(arrays.face_count == 0 || !calls.went_well(signum_tessellation_vertices(
                                                        tessellation, vertices.data(),
                                                        3 * arrays.face_count - 1, calls.error()),
                                                    count),
         "vertices without room");
    const auto point = numbers<2>(choices);
    std::int32_t face = -7;
    std::int32_t nearest = -7;
    const bool located = calls.went_well(
        signum_tessellation_locate(tessellation, point.data(), &face, calls.error()), count);
    const bool found = calls.went_well(
        signum_tessellation_nearest(tessellation, point.data(), &nearest, calls.error()), count);
    must(located == all_finite(point) && found == located, "a point that is no point");
    must(located ? face >= -1 && face < arrays.face_count : face == -7, "a face that there is not");
    must(found ? nearest >= -1 && nearest < count : nearest == -7, "a site that there is not");
    signum_voronoi* voronoi = nullptr;
    must(calls.went_well(
             signum_voronoi_create(tessellation, choices.below(2), &voronoi, calls.error()), count),
         "no diagram");
    std::vector<double> areas(static_cast<std::size_t>(count));
    const std::array<double, 4> box = numbers<4>(choices);
    static_cast<void>(
        calls.went_well(signum_voronoi_areas(voronoi, choices.below(2) == 0 ? nullptr : box.data(),
                                             areas.data(), count, calls.error()),
                        count));
    signum_voronoi_free(voronoi);
    signum_tessellation_free(tessellation);
}

void build_in_space(Choices& choices) {
    Calls calls;
    const signum_options options = any_options(choices);
    std::vector<double> sites;
    while (choices.are_left() && sites.size() < 4 * most_sites) {
        const auto [x, y, z, r] = numbers<4>(choices);
        sites.insert(sites.end(), {x, y, z, r});
    }
    const auto count = static_cast<std::int64_t>(sites.size() / 4);
    signum_space_tessellation* tessellation = nullptr;
    if (!calls.went_well(signum_triangulate_space(sites.data(), count, 4, &options, &tessellation,
                                                  calls.error()),
                         count)) {
        must(tessellation == nullptr, "a handle of what failed");
        return;
    }
    signum_space_arrays arrays = SIGNUM_SPACE_ARRAYS;
    must(calls.went_well(signum_space_tessellation_arrays(tessellation, &arrays, calls.error()),
                         count),
         "no arrays");
    signum_options as = SIGNUM_OPTIONS;
    as.weight_is =
        options.size >= offsetof(signum_options, threads) ? options.weight_is : SIGNUM_RADIUS;
    signum_validation verdict{};
    must(calls.went_well(
             signum_validate_space(&arrays, sites.data(), count, 4, &as, &verdict, calls.error()),
             count),
         "no verdict");
    must(verdict.valid != 0 && verdict.canonical != 0,
         "a tessellation of space that is not the canonical one");
    signum_space_tessellation_free(tessellation);
}

void change(Choices& choices) {
    Calls calls;
    signum_dynamic* dynamic = nullptr;
    if (!calls.went_well(
            signum_dynamic_create(word(choices, 4), word(choices, 2), &dynamic, calls.error()),
            any_handle)) {
        must(dynamic == nullptr, "a handle of what failed");
        return;
    }
    std::int64_t size = 0;
    while (choices.are_left()) {
        const int kind = choices.below(6);
        const std::int32_t handle = choices.below(most_sites + 2) - 1;
        const bool is_there = signum_dynamic_contains(dynamic, handle) != 0;
        const auto site = numbers<3>(choices);
        if (kind < 2 && size < static_cast<std::int64_t>(most_sites)) {
            std::int32_t given = -7;
            const bool done = calls.went_well(
                signum_dynamic_insert(dynamic, site.data(), &given, calls.error()), any_handle);
            must(done == all_finite(site), "a site that is none, or one that was refused");
            must(done ? signum_dynamic_contains(dynamic, given) != 0 : given == -7,
                 "a handle that there is not");
            size += done ? 1 : 0;
        } else if (kind == 2) {
            const bool done =
                calls.went_well(signum_dynamic_erase(dynamic, handle, calls.error()), any_handle);
            must(done == is_there, "a site that was not there, or that stayed");
            size -= done ? 1 : 0;
        } else if (kind == 3) {
            const bool done = calls.went_well(
                signum_dynamic_change(dynamic, handle, site[2], calls.error()), any_handle);
            must(done == (is_there && std::isfinite(site[2])), "a change of nothing, or none");
        } else {
            const bool done = calls.went_well(
                signum_dynamic_move(dynamic, handle, site.data(), calls.error()), any_handle);
            must(done == (is_there && std::isfinite(site[0]) && std::isfinite(site[1])),
                 "a move of nothing, or none");
        }
        must(signum_dynamic_size(dynamic) == size, "another number of sites");
    }
    signum_tessellation* tessellation = nullptr;
    must(calls.went_well(signum_dynamic_tessellation(dynamic, &tessellation, calls.error()),
                         any_handle),
         "no tessellation");
    signum_tessellation_free(tessellation);
    signum_dynamic_free(dynamic);
}

void move(Choices& choices) {
    Calls calls;
    const auto next = [&] {
        const auto place = numbers<2>(choices);
        return signum_moving_site{place[0],
                                  place[1],
                                  choices.below(5) - 2.0,
                                  choices.below(5) - 2.0,
                                  choices.radius(),
                                  static_cast<double>(choices.below(3))};
    };
    const std::array<double, 2> fall = {0.0, choices.below(2) - 1.0};
    signum_kinetic* kinetic = nullptr;
    must(calls.went_well(
             signum_kinetic_create(nullptr, 0, 0.0, fall.data(), &kinetic, calls.error()),
             any_handle),
         "no beginning");
    double time = 0.0;
    for (int step = 0; choices.are_left() && step < 40; ++step) {
        const int kind = choices.below(5);
        const std::int32_t handle = choices.below(14) - 1;
        const bool is_there = signum_kinetic_contains(kinetic, handle) != 0;
        const signum_moving_site site = next();
        const bool is_fine = std::isfinite(site.x) && std::isfinite(site.y);
        signum_status status = SIGNUM_OK;
        if (kind < 2 && signum_kinetic_size(kinetic) < 12) {
            status = signum_kinetic_insert(kinetic, &site, nullptr, calls.error());
            must(is_fine || status != SIGNUM_OK, "a site that is none");
        } else if (kind == 2) {
            status = signum_kinetic_erase(kinetic, handle, calls.error());
            must(is_there || status != SIGNUM_OK, "a site that was not there");
        } else if (kind == 3) {
            status = signum_kinetic_change(kinetic, handle, &site, calls.error());
            must((is_there && is_fine) || status != SIGNUM_OK, "a change of nothing");
        } else {
            const double until =
                choices.below(4) == 0 ? any_number(choices) : time + choices.below(16) / 8.0;
            // Sites that cross one another without end are for the other targets.
            status = signum_kinetic_advance(kinetic, std::min(until, time + 4.0), calls.error());
            must(!(until < time) || status != SIGNUM_OK, "a step backwards");
        }
        static_cast<void>(calls.went_well(status, any_handle));
        must(calls.went_well(signum_kinetic_time(kinetic, &time, calls.error()), any_handle),
             "no time");
        const std::int32_t* faces = nullptr;
        std::int64_t count = -1;
        must(calls.went_well(signum_kinetic_faces(kinetic, &faces, &count, calls.error()),
                             any_handle) &&
                 count >= 0,
             "no faces");
    }
    signum_kinetic_free(kinetic);
}

void fly(Choices& choices) {
    Calls calls;
    signum_effects effects = SIGNUM_EFFECTS(choices.below(4));
    effects.box = word(choices, 3);
    const auto low = numbers<3>(choices);
    for (int k = 0; k < 3; ++k) {
        effects.low[k] = choices.below(4) == 0 ? low[static_cast<std::size_t>(k)] : -1.0;
        effects.high[k] = 9.0;
        effects.gravity[k] = choices.below(3) - 1.0;
    }
    if (choices.below(4) == 0) effects.restitution = any_number(choices);
    if (choices.below(4) == 0) effects.growth_rate = any_number(choices);
    if (choices.below(4) == 0) effects.contact_duration = 0.125;
    std::vector<signum_ball> balls;
    while (choices.are_left() && balls.size() < 6) {
        const auto place = numbers<3>(choices);
        signum_ball ball = {{place[0], place[1], place[2]}, {}, choices.below(3) * 0.5, 0.0, 1.0};
        for (double& v : ball.v) v = choices.below(5) - 2;
        balls.push_back(ball);
    }
    const auto count = static_cast<std::int64_t>(balls.size());
    if (count >= 2) {
        double time = -7.0;
        const bool told = calls.went_well(
            signum_meeting_time(&balls[0], &balls[1], &effects, 8.0, &time, calls.error()), count);
        must(told ? time >= 0.0 : time == -7.0, "a meeting before its time");
    }
    signum_simulation* simulation = nullptr;
    if (!calls.went_well(
            signum_simulation_create(balls.data(), count, &effects, &simulation, calls.error()),
            count)) {
        must(simulation == nullptr, "a handle of what failed");
        return;
    }
    signum_limits limits = SIGNUM_LIMITS;
    limits.until = choices.below(4) == 0 ? any_number(choices) : choices.below(16) / 4.0;
    limits.strikes = static_cast<std::uint64_t>(choices.below(64));
    if (choices.below(8) == 0) limits.size = choices.byte();
    // Without that many strikes, or a time, balls in a periodic box may fly for ever.
    if (!(limits.until <= 64.0)) limits.until = 64.0;
    signum_ending ending = -7;
    signum_strike last{};
    if (calls.went_well(signum_simulation_run(simulation, &limits, &ending, &last, calls.error()),
                        count))
        must(ending >= SIGNUM_UNTIL && ending <= SIGNUM_COLLAPSE, "an ending that there is not");
    must(signum_simulation_size(simulation) == count, "another number of balls");
    must(calls.went_well(signum_simulation_balls(simulation, balls.data(), count, calls.error()),
                         count),
         "no balls");
    std::int32_t neighbour = -7;
    double gap = 0.0;
    const std::int32_t ball = choices.below(9) - 1;
    const bool told = calls.went_well(
        signum_simulation_nearest(simulation, ball, &neighbour, &gap, calls.error()), count);
    must(told || (neighbour == -7 && gap == 0.0), "a result of what failed");
    signum_simulation_free(simulation);
}

}  // namespace

void predicates_of_c_target(Bytes bytes) {
    Choices choices(bytes.first(std::min(bytes.size(), most_bytes)));
    const auto site = [](const std::array<double, 3>& s) { return Site{s[0], s[1], s[2]}; };
    while (choices.are_left()) {
        const signum_metric metric = word(choices, 4);
        const bool is_metric = metric >= 0 && metric < 4;
        const auto i = numbers<3>(choices);
        const auto j = numbers<3>(choices);
        const auto k = numbers<3>(choices);
        const auto q = numbers<3>(choices);
        const auto of_centres = [&](const auto&... s) {
            return (... && (std::isfinite(s[0]) && std::isfinite(s[1])));
        };
        const int turn = signum_ccw(i.data(), j.data(), k.data());
        must_be_a_sign(turn, of_centres(i, j, k));
        if (turn != SIGNUM_NO_SIGN)
            must(turn == ccw(site(i), site(j), site(k)), "another turn than that of C++");
        const int exists = signum_exists(metric, i.data(), j.data(), k.data());
        must_be_a_sign(exists, is_metric && all_finite(i, j, k));
        must_be_a_sign(signum_hidden(metric, q.data(), i.data()), is_metric && all_finite(q, i));
        must_be_a_sign(signum_nearer(metric, q.data(), i.data(), j.data()),
                       is_metric && of_centres(q) && all_finite(i, j));
        if (exists == 1 && all_finite(q)) {
            bool is_hidden = false;
            for (const auto* m : {&i, &j, &k})
                is_hidden |= signum_hidden(metric, q.data(), m->data()) == 1;
            if (!is_hidden)
                must_be_a_sign(signum_in_circle(metric, i.data(), j.data(), k.data(), q.data()),
                               true);
        }
        const auto a = numbers<4>(choices);
        const auto b = numbers<4>(choices);
        const auto c = numbers<4>(choices);
        const auto d = numbers<4>(choices);
        const auto e = numbers<4>(choices);
        const int spheres = signum_spheres(metric, a.data(), b.data(), c.data(), d.data());
        must(is_metric && all_finite(a, b, c, d) ? spheres >= 0 : spheres == SIGNUM_NO_SIGN,
             "spheres of nothing, or none");
        const int most = spheres == SIGNUM_INFINITELY_MANY ? 0 : spheres;
        for (int n = -1; n <= std::max(most, 0); ++n)
            must_be_a_sign(
                signum_in_sphere(metric, a.data(), b.data(), c.data(), d.data(), e.data(), n),
                n >= 0 && n < most && all_finite(e));
        const std::array<double, 6> terms = {i[0], j[0], k[0], q[0], a[0], b[0]};
        const int sum = signum_sign_of_sum(terms.data(), terms.size());
        must_be_a_sign(sum, all_finite(terms));
        if (sum != SIGNUM_NO_SIGN) must(sum == sign_of_sum(terms), "another sum than that of C++");
    }
}

void structures_of_c_target(Bytes bytes) {
    Choices choices(bytes.first(std::min(bytes.size(), most_bytes)));
    constexpr std::array works = {build_in_plane, build_in_space, change, move, fly};
    works[static_cast<std::size_t>(choices.below(static_cast<int>(works.size())))](choices);
}

}  // namespace signum::fuzz
