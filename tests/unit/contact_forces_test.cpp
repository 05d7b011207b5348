/// Lasting contacts against statics, against the laws written anew, and without friction against
/// all sets of contacts that may press.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/effects/contact_forces.hpp"

namespace signum::motion {
namespace {

constexpr double gravity = 9.81;
constexpr double step = 0.01;

/// Bodies and contacts, as they were and as they are.
template <int D>
struct Scene {
    std::vector<ContactBody<D>> bodies;
    std::vector<Contact<D>> contacts;

    std::size_t add_body(double mass, double radius, double inertia_factor,
                         const Vector<D>& velocity = {}) {
        ContactBody<D> body;
        body.inert = {mass, radius, inertia_factor * mass * radius * radius};
        body.velocity = velocity;
        bodies.push_back(body);
        return bodies.size() - 1;
    }
    Contact<D>& touch(std::size_t a, std::size_t b, const Vector<D>& normal, double friction) {
        Contact<D> contact;
        contact.a = a;
        contact.b = b;
        contact.normal = normal;
        contact.friction = friction;
        contacts.push_back(contact);
        return contacts.back();
    }
    Contact<D>& stand(std::size_t a, const Vector<D>& normal, double friction) {
        return touch(a, Contact<D>::wall, normal, friction);
    }
    void accelerate(const Vector<D>& by) {
        for (ContactBody<D>& body : bodies)
            for (int k = 0; k < D; ++k) body.velocity[k] += by[k] * step;
    }
    ContactReport solve(double tolerance = 1e-12, int sweeps = 4000) {
        return solve_contacts<D>(bodies, contacts, step, tolerance, sweeps);
    }
    [[nodiscard]] double energy() const {
        double sum = 0.0;
        for (const ContactBody<D>& body : bodies) {
            sum += body.inert.mass * dot<D>(body.velocity, body.velocity) / 2;
            for (const double spin : body.spin.values) sum += body.inert.inertia * spin * spin / 2;
        }
        return sum;
    }
    [[nodiscard]] double fastest() const {
        double speed = 0.0;
        for (const ContactBody<D>& body : bodies) {
            speed = std::max(speed, std::sqrt(dot<D>(body.velocity, body.velocity)));
            for (const double spin : body.spin.values)
                speed = std::max(speed, std::abs(spin) * body.inert.radius);
        }
        return speed;
    }
};

// ---- The laws, in three dimensions, with arms and cross products
// ---------------------------------

using Three = Vector<3>;
template <int D>
Three in_space(const Vector<D>& v) {
    return {v[0], v[1], D == 3 ? v[D - 1] : 0.0};
}
template <int D>
Three spin_in_space(const Spin<D>& spin) {
    if constexpr (D == 2) {
        return {0.0, 0.0, spin[0]};
    } else {
        return spin;
    }
}
Three cross(const Three& a, const Three& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Three sum(const Three& a, double factor, const Three& b) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
double length(const Three& a) {
    return std::sqrt(dot<3>(a, a));
}

/// How far from the laws the velocities and impulses are, in speeds.
template <int D>
double worst_breach(const Scene<D>& after) {
    double worst = 0.0;
    for (const Contact<D>& contact : after.contacts) {
        const Three n = in_space<D>(contact.normal);
        const auto surface = [&](const ContactBody<D>& body, double side) {
            const Three arm = sum({}, side * body.inert.radius, n);
            return sum(in_space<D>(body.velocity), 1.0, cross(spin_in_space<D>(body.spin), arm));
        };
        const ContactBody<D>& a = after.bodies[contact.a];
        double mobility = 1.0 / a.inert.mass;
        Three u = surface(a, -1.0);
        if (contact.b == Contact<D>::wall) {
            u = sum(u, -1.0, in_space<D>(contact.wall_velocity));
        } else {
            const ContactBody<D>& b = after.bodies[contact.b];
            mobility += 1.0 / b.inert.mass;
            u = sum(u, -1.0, surface(b, 1.0));
        }
        const double p = contact.normal_impulse;
        const Three pt = in_space<D>(contact.tangential_impulse);
        const double normal = dot<3>(u, n);
        const Three ut = sum(u, -normal, n);
        EXPECT_GE(p, 0.0);
        EXPECT_LE(length(pt), contact.friction * p * (1 + 1e-9));
        EXPECT_LE(std::abs(dot<3>(pt, n)), 1e-12 * p);
        worst = std::max(worst, std::abs(std::min(normal + contact.gap / step, mobility * p)));
        // Not negative within the cone, and 0 where it does not slide or slides against p_t.
        if (p > 0.0) worst = std::max(worst, contact.friction * length(ut) + dot<3>(pt, ut) / p);
    }
    return worst;
}

/// How far the velocities are from those before and the impulses.
template <int D>
double worst_balance(const Scene<D>& before, const Scene<D>& after) {
    double worst = 0.0;
    std::vector<Three> velocity;
    std::vector<Three> spin;
    for (const ContactBody<D>& body : before.bodies) {
        velocity.push_back(in_space<D>(body.velocity));
        spin.push_back(spin_in_space<D>(body.spin));
    }
    for (const Contact<D>& contact : after.contacts) {
        const Three n = in_space<D>(contact.normal);
        const Three p = sum(in_space<D>(contact.tangential_impulse), contact.normal_impulse, n);
        const auto push = [&](std::size_t number, double sign, double side) {
            const ContactMass& inert = before.bodies[number].inert;
            velocity[number] = sum(velocity[number], sign / inert.mass, p);
            const Three arm = sum({}, side * inert.radius, n);
            spin[number] = sum(spin[number], sign / inert.inertia, cross(arm, p));
        };
        push(contact.a, 1.0, -1.0);
        if (contact.b != Contact<D>::wall) push(contact.b, -1.0, 1.0);
    }
    for (std::size_t i = 0; i < after.bodies.size(); ++i) {
        worst =
            std::max(worst, length(sum(in_space<D>(after.bodies[i].velocity), -1.0, velocity[i])));
        worst =
            std::max(worst, after.bodies[i].inert.radius *
                                length(sum(spin_in_space<D>(after.bodies[i].spin), -1.0, spin[i])));
    }
    return worst;
}

// ---- Statics
// -------------------------------------------------------------------------------------

TEST(ContactForces, AFloorCarriesABall) {
    Scene<3> scene;
    scene.stand(scene.add_body(2.0, 0.5, 0.4), {0.0, 0.0, 1.0}, 0.5);
    scene.accelerate({0.0, 0.0, -gravity});
    const ContactReport report = scene.solve();
    EXPECT_TRUE(report.converged());
    EXPECT_EQ(report.clusters, 1U);
    EXPECT_NEAR(scene.contacts[0].normal_impulse, 2.0 * gravity * step, 1e-15);
    EXPECT_EQ(scene.fastest(), 0.0);
}

TEST(ContactForces, EachContactOfAStackCarriesWhatIsAbove) {
    constexpr std::size_t count = 50;
    Scene<2> scene;
    double weight = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double mass = 1.0 + 0.1 * static_cast<double>(i % 7);
        weight += mass * gravity * step;
        scene.add_body(mass, 1.0, 0.5);
        scene.touch(i, i == 0 ? Contact<2>::wall : i - 1, {0.0, 1.0}, 0.3);
    }
    scene.accelerate({0.0, -gravity});
    const ContactReport report = scene.solve();
    EXPECT_TRUE(report.converged());
    EXPECT_LE(report.sweeps, 200);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR(scene.contacts[i].normal_impulse, weight, 1e-9 * weight);
        weight -= scene.bodies[i].inert.mass * gravity * step;
    }
    EXPECT_LE(scene.fastest(), 1e-9 * gravity * step);
}

/// What a ball with moment q m r² does on a slope, for a step from rest.
template <int D>
void expect_on_slope(double angle, double q, double friction) {
    Scene<D> scene;
    Vector<D> up{};
    up[D - 1] = 1.0;
    scene.stand(scene.add_body(3.0, 0.25, q), up, friction);
    Vector<D> pull{};
    pull[0] = gravity * std::sin(angle);
    pull[D - 1] = -gravity * std::cos(angle);
    scene.accelerate(pull);
    const Scene<D> before = scene;
    EXPECT_TRUE(scene.solve().converged());
    const double acceleration = friction >= std::tan(angle) * q / (1 + q)
                                    ? gravity * std::sin(angle) / (1 + q)
                                    : gravity * (std::sin(angle) - friction * std::cos(angle));
    EXPECT_NEAR(scene.bodies[0].velocity[0], acceleration * step, 1e-14);
    EXPECT_LE(worst_breach(scene), 1e-13);
    EXPECT_LE(worst_balance(before, scene), 1e-13);
}

TEST(ContactForces, OnASlopeABallRollsOrSlides) {
    for (const double angle : {0.1, 0.5, 1.0, 1.4}) {
        const double limit = std::tan(angle) / 3;  // of discs
        for (const double factor : {0.0, 0.5, 0.99, 1.01, 3.0})
            expect_on_slope<2>(angle, 0.5, factor * limit);
        for (const double friction : {0.0, 0.1, 0.3, 10.0})
            expect_on_slope<3>(angle, 0.4, friction);
    }
}

/// Three discs, one on two that lie on a slope and touch.
Scene<2> three_discs(double angle, double friction, double floor_friction) {
    Scene<2> scene;
    for (int i = 0; i < 3; ++i) scene.add_body(1.0, 1.0, 0.5);
    scene.stand(0, {0.0, 1.0}, floor_friction);
    scene.stand(1, {0.0, 1.0}, floor_friction);
    scene.touch(1, 0, {1.0, 0.0}, friction);
    const double height = std::sqrt(3.0) / 2;
    scene.touch(2, 0, {0.5, height}, friction);
    scene.touch(2, 1, {-0.5, height}, friction);
    scene.accelerate({gravity * std::sin(angle), -gravity * std::cos(angle)});
    return scene;
}

TEST(ContactForces, ThreeDiscsRestFromTheFrictionOnThatStaticsTells) {
    // Between discs tan 15°, on the floor a third of it.
    const double between = std::tan(std::numbers::pi / 12);
    for (const double a : {0.99, 1.01, 3.0}) {
        for (const double b : {0.99, 1.01, 3.0}) {
            Scene<2> scene = three_discs(0.0, a * between, b * between / 3);
            const Scene<2> before = scene;
            EXPECT_TRUE(scene.solve(1e-11, 20000).converged()) << a << ' ' << b;
            if (a > 1 && b > 1) {
                EXPECT_LE(scene.fastest(), 1e-9 * gravity * step) << a << ' ' << b;
            } else {
                EXPECT_GE(scene.fastest(), 1e-4 * gravity * step) << a << ' ' << b;
            }
            EXPECT_LE(worst_breach(scene), 1e-9 * gravity * step) << a << ' ' << b;
            EXPECT_LE(worst_balance(before, scene), 1e-13);
            for (int i = 0; i < 2; ++i)
                EXPECT_NEAR(scene.bodies[0].velocity[0], -scene.bodies[1].velocity[0], 1e-10);
        }
    }
}

TEST(ContactForces, ThreeDiscsRestOnASlopeBelowTheAngleOfFriction) {
    Scene<2> rests = three_discs(0.15, 1.0, 1.0);
    EXPECT_TRUE(rests.solve().converged());
    EXPECT_LE(rests.fastest(), 1e-9 * gravity * step);
    double along = 0.0;
    double across = 0.0;
    for (int i = 0; i < 2; ++i) {
        along += rests.contacts[static_cast<std::size_t>(i)].tangential_impulse[0];
        across += rests.contacts[static_cast<std::size_t>(i)].normal_impulse;
    }
    EXPECT_NEAR(along, -3.0 * gravity * step * std::sin(0.15), 1e-9);
    EXPECT_NEAR(across, 3.0 * gravity * step * std::cos(0.15), 1e-9);
    // Even as one block they would slide.
    Scene<2> slides = three_discs(0.15, 1.0, 0.9 * std::tan(0.15));
    EXPECT_TRUE(slides.solve(1e-11).converged());
    EXPECT_GE(slides.fastest(), 1e-3 * gravity * step);
}

/// Rows of equal discs, each in the hollows of the one below.
Scene<2> heap(std::size_t rows, double friction) {
    Scene<2> scene;
    const double height = std::sqrt(3.0) / 2;
    std::vector<std::size_t> below;
    for (std::size_t row = 0; row < rows; ++row) {
        std::vector<std::size_t> here;
        for (std::size_t i = 0; i + row < rows; ++i) {
            here.push_back(scene.add_body(1.0, 1.0, 0.5));
            if (row == 0) scene.stand(here[i], {0.0, 1.0}, friction);
            if (i > 0) scene.touch(here[i], here[i - 1], {1.0, 0.0}, friction);
            if (row == 0) continue;
            scene.touch(here[i], below[i], {0.5, height}, friction);
            scene.touch(here[i], below[i + 1], {-0.5, height}, friction);
        }
        below = here;
    }
    scene.accelerate({0.0, -gravity});
    return scene;
}

TEST(ContactForces, AHeapThatCanRestRests) {
    // Sweeps of Coulomb's law alone find one that slides.
    for (const double friction : {0.8, 10.0}) {
        Scene<2> scene = heap(12, friction);
        const Scene<2> before = scene;
        const ContactReport report = scene.solve();
        EXPECT_TRUE(report.converged());
        EXPECT_LE(report.sweeps, 1000);
        EXPECT_LE(scene.fastest(), 1e-9 * gravity * step);
        EXPECT_LE(worst_balance(before, scene), 1e-12);
        double floor = 0.0;
        for (const Contact<2>& contact : scene.contacts)
            if (contact.b == Contact<2>::wall) floor += contact.normal_impulse;
        EXPECT_NEAR(floor, 78 * gravity * step, 1e-9);
        // Again from its own impulses: nothing is left to do.
        Scene<2> again = scene;
        again.accelerate({0.0, -gravity});
        EXPECT_EQ(again.solve(1e-11).sweeps, 0);
    }
}

TEST(ContactForces, AHeapWithoutFrictionSlidesAndTheFloorStillCarriesWhatDoesNotFall) {
    Scene<2> scene = heap(8, 0.0);
    const Scene<2> before = scene;
    EXPECT_TRUE(scene.solve(1e-11).converged());
    EXPECT_LE(worst_breach(scene), 1e-9 * gravity * step);
    EXPECT_LE(worst_balance(before, scene), 1e-12);
    for (const ContactBody<2>& body : scene.bodies) EXPECT_EQ(body.spin[0], 0.0);
    EXPECT_GE(scene.fastest(), 0.1 * gravity * step);
}

// ---- Opening and closing
// -------------------------------------------------------------------------

TEST(ContactForces, AFloorThatFallsFasterLetsGo) {
    Scene<2> scene;
    Contact<2>& floor = scene.stand(scene.add_body(1.0, 1.0, 0.5), {0.0, 1.0}, 0.5);
    floor.wall_velocity = {0.3, -2.0 * gravity * step};
    floor.normal_impulse = gravity * step;
    floor.tangential_impulse = {0.1, 0.0};
    scene.accelerate({0.0, -gravity});
    const Scene<2> before = scene;
    EXPECT_TRUE(scene.solve().converged());
    EXPECT_EQ(scene.contacts[0].normal_impulse, 0.0);
    EXPECT_EQ(scene.contacts[0].tangential_impulse, Vector<2>{});
    EXPECT_EQ(scene.bodies[0].velocity, before.bodies[0].velocity);
    // One that falls more slowly takes the ball along.
    scene = before;
    scene.contacts[0].wall_velocity = {0.0, -0.5 * gravity * step};
    EXPECT_TRUE(scene.solve().converged());
    EXPECT_NEAR(scene.bodies[0].velocity[1], -0.5 * gravity * step, 1e-16);
    EXPECT_NEAR(scene.contacts[0].normal_impulse, 0.5 * gravity * step, 1e-16);
}

TEST(ContactForces, BallsThatApproachOverAGapJustTouchAfterTheStep) {
    Scene<3> scene;
    scene.add_body(1.0, 1.0, 0.4, {-5.0, 0.5, 0.0});
    scene.add_body(4.0, 2.0, 0.4, {1.0, 0.0, 0.0});
    scene.touch(0, 1, {1.0, 0.0, 0.0}, 0.2).gap = 0.02;
    const Scene<3> before = scene;
    EXPECT_TRUE(scene.solve().converged());
    const double parting = scene.bodies[0].velocity[0] - scene.bodies[1].velocity[0];
    EXPECT_NEAR(0.02 + parting * step, 0.0, 1e-15);
    EXPECT_LE(worst_balance(before, scene), 1e-14);
    EXPECT_LE(worst_breach(scene), 1e-12);
    // Slower than the gap is wide, nothing happens.
    Scene<3> slow = before;
    slow.contacts[0].gap = 0.061;
    EXPECT_EQ(slow.solve().sweeps, 0);
    EXPECT_EQ(slow.bodies[0].velocity, before.bodies[0].velocity);
}

// ---- Contacts at random
// --------------------------------------------------------------------------

template <int D>
Scene<D> random_scene(std::mt19937_64& random, std::size_t bodies, std::size_t contacts,
                      bool friction, bool gaps) {
    std::uniform_real_distribution<double> spread(-1.0, 1.0);
    Scene<D> scene;
    for (std::size_t i = 0; i < bodies; ++i) {
        Vector<D> velocity{};
        for (double& each : velocity) each = spread(random);
        scene.add_body(std::pow(10.0, spread(random)), 1.5 + spread(random), 0.45, velocity);
        for (double& spin : scene.bodies.back().spin.values) spin = spread(random);
    }
    for (std::size_t i = 0; i < contacts; ++i) {
        Vector<D> normal{};
        for (double& each : normal) each = spread(random);
        const double norm = std::sqrt(dot<D>(normal, normal));
        for (double& each : normal) each /= norm;
        const std::size_t a = random() % bodies;
        const std::size_t b = random() % bodies;
        Contact<D>& contact = scene.touch(a, a == b ? Contact<D>::wall : b, normal,
                                          friction ? std::abs(spread(random)) : 0.0);
        if (gaps) contact.gap = 0.005 * (spread(random) + 0.9);
    }
    return scene;
}

template <int D>
void expect_laws_at_random(bool gaps) {
    std::mt19937_64 random(D);
    int converged = 0;
    constexpr int trials = 200;
    for (int trial = 0; trial < trials; ++trial) {
        Scene<D> scene = random_scene<D>(random, 6, 9, trial % 4 != 0, gaps);
        if (trial % 3 == 0) scene.contacts[1].friction = 10.0;
        if (trial % 5 == 0) scene.bodies[0].inert = {1e6, 2.0, 1.6e6};
        if (trial % 7 == 0) scene.contacts.push_back(scene.contacts[2]);
        const Scene<D> before = scene;
        const ContactReport report = scene.solve(1e-11);
        EXPECT_LE(report.sweeps, 4000);
        EXPECT_LE(worst_balance(before, scene), 1e-9) << trial;
        if (!gaps) {
            EXPECT_LE(scene.energy(), before.energy() * (1 + 1e-9)) << trial;
        }
        if (!report.converged()) continue;
        ++converged;
        EXPECT_LE(worst_breach(scene), 1e-7) << trial;
    }
    EXPECT_GE(converged, trials * 9 / 10);
}

TEST(ContactForces, KeepTheLawsAndNeverAddEnergy) {
    expect_laws_at_random<2>(false);
    expect_laws_at_random<3>(false);
}
TEST(ContactForces, KeepTheLawsOverGaps) {
    expect_laws_at_random<2>(true);
    expect_laws_at_random<3>(true);
}

/// x of A x = b by elimination; nothing where A is singular.
std::optional<std::vector<double>> solution(std::vector<std::vector<double>> matrix,
                                            std::vector<double> right) {
    const std::size_t size = right.size();
    for (std::size_t k = 0; k < size; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < size; ++i)
            if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k])) pivot = i;
        if (std::abs(matrix[pivot][k]) < 1e-9) return {};
        std::swap(matrix[k], matrix[pivot]);
        std::swap(right[k], right[pivot]);
        for (std::size_t i = k + 1; i < size; ++i) {
            const double factor = matrix[i][k] / matrix[k][k];
            for (std::size_t j = k; j < size; ++j) matrix[i][j] -= factor * matrix[k][j];
            right[i] -= factor * right[k];
        }
    }
    for (std::size_t k = size; k-- > 0;) {
        for (std::size_t j = k + 1; j < size; ++j) right[k] -= matrix[k][j] * right[j];
        right[k] /= matrix[k][k];
    }
    return right;
}

/// The velocities after a step without friction: of all sets of contacts the first whose equations
/// have impulses that press and leave no other contact closing.
template <int D>
std::optional<std::vector<Vector<D>>> by_active_sets(const Scene<D>& scene) {
    const std::size_t count = scene.contacts.size();
    // How the velocity of each body, the wall last, enters the parting speed of each contact.
    const auto sign = [&](std::size_t contact, std::size_t body) {
        return (scene.contacts[contact].a == body ? 1.0 : 0.0) -
               (scene.contacts[contact].b == body ? 1.0 : 0.0);
    };
    std::vector<double> parting(count);
    std::vector<std::vector<double>> mobility(count, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        parting[i] = scene.contacts[i].gap / step;
        for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
            parting[i] += sign(i, k) * dot<D>(scene.bodies[k].velocity, scene.contacts[i].normal);
            for (std::size_t j = 0; j < count; ++j)
                mobility[i][j] += sign(i, k) * sign(j, k) / scene.bodies[k].inert.mass *
                                  dot<D>(scene.contacts[i].normal, scene.contacts[j].normal);
        }
    }
    for (unsigned set = 0; set < 1U << count; ++set) {
        std::vector<std::size_t> pressing;
        for (std::size_t i = 0; i < count; ++i)
            if ((set >> i & 1U) != 0) pressing.push_back(i);
        std::vector<std::vector<double>> matrix;
        std::vector<double> right;
        for (const std::size_t i : pressing) {
            matrix.emplace_back();
            for (const std::size_t j : pressing) matrix.back().push_back(mobility[i][j]);
            right.push_back(-parting[i]);
        }
        const auto impulses = solution(matrix, right);
        if (!impulses) continue;
        bool holds = true;
        for (const double p : *impulses) holds = holds && p >= -1e-12;
        for (std::size_t i = 0; i < count; ++i) {
            double speed = parting[i];
            for (std::size_t j = 0; j < pressing.size(); ++j)
                speed += mobility[i][pressing[j]] * (*impulses)[j];
            holds = holds && speed >= -1e-10;
        }
        if (!holds) continue;
        std::vector<Vector<D>> velocities;
        for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
            velocities.push_back(scene.bodies[k].velocity);
            for (std::size_t j = 0; j < pressing.size(); ++j)
                for (int axis = 0; axis < D; ++axis)
                    velocities[k][axis] += sign(pressing[j], k) * (*impulses)[j] /
                                           scene.bodies[k].inert.mass *
                                           scene.contacts[pressing[j]].normal[axis];
        }
        return velocities;
    }
    return {};
}

template <int D>
void expect_as_by_active_sets() {
    std::mt19937_64 random(20 + D);
    int compared = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Scene<D> scene = random_scene<D>(random, 3, 2 + static_cast<std::size_t>(trial) % 5, false,
                                         trial % 2 == 0);
        const Scene<D> before = scene;
        const auto expected = by_active_sets<D>(scene);
        const ContactReport report = scene.solve(1e-12, 20000);
        if (!expected || !report.converged()) continue;
        ++compared;
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            for (int k = 0; k < D; ++k)
                EXPECT_NEAR(scene.bodies[i].velocity[k], (*expected)[i][k], 1e-8) << trial;
            EXPECT_EQ(scene.bodies[i].spin, before.bodies[i].spin);
        }
    }
    EXPECT_GE(compared, 290);
}

TEST(ContactForces, WithoutFrictionAreThoseOfTheSetThatPresses) {
    expect_as_by_active_sets<2>();
    expect_as_by_active_sets<3>();
}

// ---- What has no solution, or many
// ---------------------------------------------------------------

TEST(ContactForces, WallsThatCloseOnABallAreReported) {
    for (const double friction : {0.0, 0.5, 10.0}) {
        Scene<2> scene;
        const std::size_t ball = scene.add_body(1.0, 1.0, 0.5, {0.1, 0.2});
        scene.stand(ball, {0.0, 1.0}, friction).wall_velocity = {0.0, 1.0};
        scene.stand(ball, {0.0, -1.0}, friction).wall_velocity = {0.0, -1.0};
        const std::size_t other = scene.add_body(1.0, 1.0, 0.5, {0.0, -1.0});
        scene.stand(other, {0.0, 1.0}, friction);
        const ContactReport report = scene.solve(1e-10, 1000);
        EXPECT_FALSE(report.converged());
        EXPECT_EQ(report.clusters, 2U);
        EXPECT_EQ(report.unconverged, 1U);
        EXPECT_GE(report.residual, 0.1);
        EXPECT_LE(report.sweeps, 1000);
        EXPECT_LE(scene.fastest(), 10.0);
        EXPECT_EQ(scene.bodies[other].velocity[1], 0.0);
    }
}

TEST(ContactForces, AContactGivenTwiceIsOne) {
    for (const double friction : {0.0, 0.05, 1.0}) {
        Scene<2> once = three_discs(0.1, friction, friction);
        Scene<2> twice = once;
        for (std::size_t i = 0; i < once.contacts.size(); ++i)
            twice.contacts.push_back(once.contacts[i]);
        EXPECT_TRUE(once.solve(1e-12).converged());
        EXPECT_TRUE(twice.solve(1e-12).converged());
        for (std::size_t i = 0; i < 3; ++i)
            for (int k = 0; k < 2; ++k)
                EXPECT_NEAR(once.bodies[i].velocity[k], twice.bodies[i].velocity[k], 1e-9)
                    << friction;
    }
}

TEST(ContactForces, AHeavyBallLiesOnALightOne) {
    Scene<2> scene;
    scene.add_body(1.0, 1.0, 0.5);
    scene.add_body(1e6, 1.0, 0.5);
    scene.stand(0, {0.0, 1.0}, 0.5);
    scene.touch(1, 0, {0.0, 1.0}, 0.5);
    scene.accelerate({0.0, -gravity});
    EXPECT_TRUE(scene.solve(1e-10, 1000).converged());
    EXPECT_NEAR(scene.contacts[0].normal_impulse, 1000001 * gravity * step, 1e-3);
    EXPECT_LE(scene.fastest(), 1e-8);
}

TEST(ContactForces, AClusterKnowsNothingOfOthers) {
    Scene<2> alone = heap(5, 0.4);
    Scene<2> beside = alone;
    const Scene<2> other = three_discs(0.3, 0.2, 0.1);
    const std::size_t first = beside.bodies.size();
    beside.bodies.insert(beside.bodies.end(), other.bodies.begin(), other.bodies.end());
    for (Contact<2> contact : other.contacts) {
        contact.a += first;
        if (contact.b != Contact<2>::wall) contact.b += first;
        beside.contacts.insert(
            beside.contacts.begin() + static_cast<std::ptrdiff_t>(beside.contacts.size() / 2),
            contact);
    }
    EXPECT_EQ(alone.solve(1e-10, 300).clusters, 1U);
    EXPECT_EQ(beside.solve(1e-10, 300).clusters, 2U);
    for (std::size_t i = 0; i < alone.bodies.size(); ++i) {
        EXPECT_EQ(alone.bodies[i].velocity, beside.bodies[i].velocity);
        EXPECT_EQ(alone.bodies[i].spin, beside.bodies[i].spin);
    }
}

TEST(ContactForces, AWrongStartDoesNoHarm) {
    Scene<2> scene = heap(6, 0.9);
    for (Contact<2>& contact : scene.contacts) {
        contact.normal_impulse = 1e6;
        contact.tangential_impulse = {-contact.normal[1] * 3e6, contact.normal[0] * 3e6};
    }
    EXPECT_TRUE(scene.solve(1e-11, 1000).converged());
    EXPECT_LE(scene.fastest(), 1e-8 * gravity * step);
}

TEST(ContactForces, NothingIsDoneWithoutContacts) {
    Scene<2> scene;
    scene.add_body(1.0, 1.0, 0.5, {1.0, 2.0});
    const ContactReport report = scene.solve();
    EXPECT_TRUE(report.converged());
    EXPECT_EQ(report.clusters, 0U);
    EXPECT_EQ(report.sweeps, 0);
    EXPECT_EQ(scene.bodies[0].velocity, (Vector<2>{1.0, 2.0}));
}

}  // namespace
}  // namespace signum::motion
