/// The stages of a meeting time against the exact one: the filter's interval contains it, whatever
/// the input, and double-doubles tell the same double or nothing. On generic input both nearly
/// always tell.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/exact_meeting.hpp"
#include "../../motion/meeting.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../thoroughness.hpp"

namespace signum::motion {
namespace {

using oracle_test::Random;

/// How two balls lie and fly where the one asks for the other; old ones since long ago.
enum class Kind { generic, grazing, almost_touching, alike, small_integers, many_binades, old };
constexpr Kind hostile_kinds[] = {Kind::grazing,        Kind::almost_touching, Kind::alike,
                                  Kind::small_integers, Kind::many_binades,    Kind::old};

enum class Space { open, walls, periodic };
constexpr Space all_spaces[] = {Space::open, Space::walls, Space::periodic};

constexpr double half_side = 4.0;

/// Ball 0 asks at `now`; the others are its crowd.
template <int D>
struct Question {
    Effects<D> effects;
    std::vector<Ball<D>> balls;
    double now = 3.0;
};

enum class Flight { straight, falling, growing };

template <int D>
class Questions {
 public:
    explicit Questions(std::uint64_t seed) : random_(seed) {}
    [[nodiscard]] Random& random() noexcept { return random_; }

    Question<D> next(Kind kind, Space space, Flight flight, std::size_t crowd) {
        Question<D> question;
        if (random_.below(2) == 0)  // late, so that a tick of the clock is long
            question.now =
                std::ldexp(1.0 + random_.unit(), random_.below(kind == Kind::generic ? 20 : 40));
        Effects<D>& effects = question.effects;
        if (space != Space::open) {
            effects.box.emplace();
            effects.box->low.fill(-half_side);
            effects.box->high.fill(half_side);
            effects.periodic = space == Space::periodic;
        }
        if (flight == Flight::falling || (flight == Flight::growing && random_.below(2) == 0))
            for (double& g : effects.gravity)
                g = kind == Kind::small_integers ? random_.below(3) - 1
                                                 : number(kind == Kind::old ? 0x1p-24 : 1.0);
        const Ball<D> asker = asking(kind);
        question.balls.push_back(asker);
        for (std::size_t k = 0; k < crowd; ++k) question.balls.push_back(partner(kind, asker));
        if (flight == Flight::growing) {
            // So fast that they double, or hardly at all.
            effects.growth = {(random_.unit() + 0x1p-20) / (1.0 + question.now), 0.0};
            if (random_.below(2) == 0) effects.growth->rate *= std::ldexp(1.0, -random_.below(60));
            effects.growth->until = 2.0 * question.now + 1.0;
            const double factor = 1.0 + effects.growth->rate * question.now;
            for (Ball<D>& ball : question.balls) ball.radius /= factor;
        }
        const bool ages = random_.below(4) > 0;
        for (Ball<D>& ball : question.balls) {
            const bool is_young = !ages || (kind == Kind::old && &ball == &question.balls[0]);
            take_back(ball, is_young ? 0.0 : age(kind), question);
        }
        return question;
    }

    /// The same in other units: all numbers are within 2^±150.
    void scale(Question<D>& question) {
        const int length = random_.below(161) - 80;
        const int speed = random_.below(81) - 40;
        const int time = length - speed;
        const auto multiply = [](double& x, int exponent) { x = std::ldexp(x, exponent); };
        for (Ball<D>& ball : question.balls) {
            for (double& x : ball.x) multiply(x, length);
            for (double& v : ball.v) multiply(v, speed);
            multiply(ball.radius, length);
            multiply(ball.time, time);
        }
        multiply(question.now, time);
        for (double& g : question.effects.gravity) multiply(g, speed - time);
        if (question.effects.growth) {
            multiply(question.effects.growth->rate, -time);
            multiply(question.effects.growth->until, time);
        }
        if (question.effects.box) {
            for (double& x : question.effects.box->low) multiply(x, length);
            for (double& x : question.effects.box->high) multiply(x, length);
        }
    }

 private:
    /// From -size to size, of 60 random bits before it is rounded.
    double number(double size) {
        return size * (2.0 * (random_.unit() + 0x1p-30 * random_.unit()) - 1.0);
    }
    double sign() { return random_.below(2) == 0 ? -1.0 : 1.0; }
    /// ±2^-4 to ±2^-55, or 0.
    double little() {
        return random_.below(8) == 0 ? 0.0 : std::ldexp(sign(), -random_.below(52) - 4);
    }
    Vector<D> vector(double size) {
        Vector<D> v;
        for (double& each : v) each = number(size);
        return v;
    }
    Vector<D> direction() {
        for (;;) {
            Vector<D> v = vector(1.0);
            const double length = std::sqrt(dot(v, v));
            if (length < 0.125) continue;
            for (double& each : v) each /= length;
            return v;
        }
    }
    Vector<D> small_integers(int size) {
        Vector<D> v;
        for (double& each : v) each = random_.below(2 * size + 1) - size;
        return v;
    }

    Ball<D> asking(Kind kind) {
        if (kind == Kind::small_integers)
            return {small_integers(3), small_integers(2), 0.5 + 0.5 * random_.below(2), 0.0};
        return {vector(half_side - 1.0), vector(1.0), 0.5 + number(0.5), 0.0};
    }
    /// As it is at the time of the question.
    Ball<D> partner(Kind kind, const Ball<D>& asker) {
        Ball<D> ball = asking(kind);
        const double radii = asker.radius + ball.radius;
        const Vector<D> normal = direction();
        if (kind == Kind::many_binades) {
            const auto stretch = [&] { return std::ldexp(1.0, -random_.below(40)); };
            for (double& x : ball.x) x *= stretch();
            for (double& v : ball.v) v *= stretch();
            ball.radius *= stretch();
        } else if (kind == Kind::alike) {
            ball.v = asker.v;
            double& v = ball.v[random_.below(D)];
            if (random_.below(2) == 0) v += little();
            if (random_.below(4) == 0) v = std::nextafter(v, sign() * infinity);
        } else if (kind == Kind::almost_touching) {
            const double distance = radii * (1.0 + little());
            for (int k = 0; k < D; ++k) ball.x[k] = asker.x[k] + distance * normal[k];
        } else if (kind == Kind::grazing) {
            // Past one another at a right angle to the normal, before or after they are nearest.
            Vector<D> along{};
            along[0] = -normal[1];
            along[1] = normal[0];
            const double distance = radii * (1.0 + little());
            const double speed = number(2.0);
            const double before = number(2.0);
            for (int k = 0; k < D; ++k) {
                ball.x[k] = asker.x[k] + distance * normal[k] - speed * before * along[k];
                ball.v[k] = asker.v[k] + speed * along[k];
            }
        }
        return ball;
    }
    double age(Kind kind) {
        if (kind == Kind::small_integers) return random_.below(3);
        if (kind == Kind::old) return std::ldexp(1.0 + random_.unit(), random_.below(28) - 4);
        if (random_.below(4) == 0) return std::ldexp(1.0, -random_.below(50));
        return 2.0 * random_.unit();
    }
    /// To a time of its own.
    void take_back(Ball<D>& ball, double age, const Question<D>& question) {
        const Effects<D>& effects = question.effects;
        ball.time = question.now - age;
        for (int k = 0; k < D; ++k) {
            const double fallen = effects.gravity[k] * age;
            ball.x[k] -= (ball.v[k] - 0.5 * fallen) * age;
            ball.v[k] -= fallen;
            if (effects.periodic)
                ball.x[k] -= 2.0 * half_side * nearest_integer(ball.x[k] / (2.0 * half_side));
        }
    }

    Random random_;
};

/// How often each stage told.
struct Told {
    int asked = 0;
    int told = 0;
    int never = 0;
    int intervals = 0;
    int refined = 0;
};

/// What is told against the exact time; refine(about) is the second stage.
template <class Refine>
void expect_contains(const Meeting& meeting, double exact, double now, const Refine& refine,
                     Told& told) {
    ++told.asked;
    if (meeting.early == -infinity) {
        ASSERT_EQ(meeting.late, infinity);
        return;
    }
    ++told.told;
    if (meeting.early == infinity) {
        ASSERT_EQ(meeting.late, infinity);
        ASSERT_EQ(exact, infinity);
        ++told.never;
        return;
    }
    ++told.intervals;
    ASSERT_LE(now, meeting.early);
    ASSERT_LE(meeting.early, exact);
    ASSERT_LE(exact, meeting.late);
    const double refined = refine(0.5 * (meeting.early + meeting.late));
    if (std::isnan(refined)) return;
    ASSERT_EQ(refined, exact);
    ++told.refined;
}

/// Whether the nearest image is the same for all numbers that differ by what is rounded.
template <int D>
bool has_clear_image(const Vector<D>& a, const Vector<D>& b, const Effects<D>& effects) {
    if (!effects.periodic) return true;
    for (int k = 0; k < D; ++k) {
        const double turns = (a[k] - b[k]) / (effects.box->high[k] - effects.box->low[k]);
        if (std::fabs(std::fabs(turns - nearest_integer(turns)) - 0.5) < 0x1p-20) return false;
    }
    return true;
}

template <int D>
MeetingFilter<D> filter_of(const Question<D>& question) {
    MeetingFilter<D> filter(question.effects, Kernel::exact);
    for (const Ball<D>& ball : question.balls) filter.include(ball);
    return filter;
}

template <int D>
void ask_for_crowd(const Question<D>& question, MeetingFilter<D>& filter, Told& told) {
    const Effects<D>& effects = question.effects;
    const std::vector<Ball<D>>& balls = question.balls;
    const double now = question.now;
    const auto asker = filter.asker(balls[0], now);
    Crowd crowd;
    for (Slot j = 1; j < balls.size(); ++j) crowd.push(j);
    asker.meetings(balls.data(), crowd);
    for (std::size_t k = 0; k < crowd.size; ++k) {
        const Ball<D>& other = balls[crowd.who[k]];
        const Vector<D> x = centre(balls[0], now, effects);
        const Vector<D> y = centre(other, now, effects);
        if (!has_clear_image(x, y, effects)) continue;
        const Image<D> image = nearest_image(x, y, effects);
        const double exact = exact_meeting(balls[0], other, image, effects);
        // What met between T and now is not asked about.
        if (exact <= now && std::max(balls[0].time, other.time) < now) continue;
        SCOPED_TRACE("one of the crowd: " + std::to_string(k));
        expect_contains(
            {crowd.early[k], crowd.late[k]}, exact, now,
            [&](double about) { return refined_meeting(balls[0], other, image, effects, about); },
            told);
        if (testing::Test::HasFatalFailure()) return;
    }
}

template <int D>
void ask_for_walls(const Question<D>& question, MeetingFilter<D>& filter, Told& told) {
    const Effects<D>& effects = question.effects;
    const double now = question.now;
    for (const Ball<D>& ball : question.balls) {
        const auto asker = filter.asker(ball, now);
        for (Wall wall = 0; wall < 2 * D; ++wall) {
            const double exact = exact_meeting(ball, wall, effects);
            if (exact <= now && ball.time < now) continue;
            const Vector<D>& sides = wall % 2 != 0 ? effects.box->high : effects.box->low;
            SCOPED_TRACE("wall " + std::to_string(wall));
            expect_contains(
                asker.meeting(wall, sides[wall / 2]), exact, now,
                [&](double about) { return refined_meeting(ball, wall, effects, about); }, told);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

struct ToldOfBoth {
    Told crowd;
    Told walls;
};

template <int D>
void ask(const Question<D>& question, ToldOfBoth& told) {
    MeetingFilter<D> filter = filter_of(question);
    ask_for_crowd(question, filter, told.crowd);
    if (question.effects.box && !question.effects.periodic && !testing::Test::HasFatalFailure())
        ask_for_walls(question, filter, told.walls);
}

template <int D, Flight its_flight>
struct World {
    static constexpr int dimension = D;
    static constexpr Flight flight = its_flight;
};

template <class World>
class MeetingFilterOf : public testing::Test {};
using Worlds = testing::Types<World<2, Flight::straight>, World<2, Flight::falling>,
                              World<2, Flight::growing>, World<3, Flight::straight>,
                              World<3, Flight::falling>, World<3, Flight::growing>>;
struct NameOfWorld {
    template <class World>
    static std::string GetName(int /*number*/) {
        return std::string(World::dimension == 2 ? "Plane" : "Space") +
               (World::flight == Flight::falling   ? "WithGravity"
                : World::flight == Flight::growing ? "WithGrowth"
                                                   : "");
    }
};
TYPED_TEST_SUITE(MeetingFilterOf, Worlds, NameOfWorld);

TYPED_TEST(MeetingFilterOf, GenericBallsTellsNearlyAlways) {
    constexpr int D = TypeParam::dimension;
    Questions<D> questions(1801);
    for (const Space space : all_spaces) {
        ToldOfBoth told;
        for (int i = 0; i < 60; ++i) {
            SCOPED_TRACE("case " + std::to_string(i));
            Question<D> question =
                questions.next(Kind::generic, space, TypeParam::flight, Crowd::capacity);
            if (i % 2 != 0) questions.scale(question);
            ask<D>(question, told);
            if (this->HasFatalFailure()) return;
        }
        for (const Told& each : {told.crowd, told.walls}) {
            if (each.asked == 0) continue;
            EXPECT_GT(each.told, 0.95 * each.asked);
            EXPECT_GT(each.never, 0);
            EXPECT_GT(each.intervals, 0.01 * each.asked);
            EXPECT_GT(each.refined, 0.99 * each.intervals);
        }
        EXPECT_GT(told.crowd.asked, 2000);
        EXPECT_EQ(told.walls.asked > 0, space == Space::walls);
    }
}

TYPED_TEST(MeetingFilterOf, HostileBallsIsRightWhereItTells) {
    constexpr int D = TypeParam::dimension;
    Questions<D> questions(1802);
    int asked = 0;
    int told_of_all = 0;
    for (const Kind kind : hostile_kinds) {
        ToldOfBoth told;
        for (const Space space : all_spaces) {
            for (int i = 0; i < (is_sanitized ? 10 : 40); ++i) {
                SCOPED_TRACE("kind " + std::to_string(static_cast<int>(kind)) + ", space " +
                             std::to_string(static_cast<int>(space)) + ", case " +
                             std::to_string(i));
                Question<D> question = questions.next(kind, space, TypeParam::flight, 32);
                if (i % 2 != 0) questions.scale(question);
                ask<D>(question, told);
                if (this->HasFatalFailure()) return;
            }
        }
        EXPECT_GT(told.crowd.told, told.crowd.asked / 5);
        EXPECT_GT(told.crowd.intervals, 0);
        asked += told.crowd.asked;
        told_of_all += told.crowd.told;
    }
    EXPECT_LT(told_of_all, 0.95 * asked);
}

/// Lanes of four, and what is left of them: nobody's answer depends on the others asked about.
TYPED_TEST(MeetingFilterOf, CrowdsOfEverySizeTellsWhatItTellsOfOne) {
    constexpr int D = TypeParam::dimension;
    Questions<D> questions(1803);
    for (std::size_t size = 1; size <= Crowd::capacity; ++size) {
        SCOPED_TRACE("size " + std::to_string(size));
        const Question<D> question = questions.next(size % 2 != 0 ? Kind::generic : Kind::grazing,
                                                    size % 3 != 0 ? Space::open : Space::periodic,
                                                    TypeParam::flight, Crowd::capacity);
        MeetingFilter<D> filter = filter_of(question);
        const auto asker = filter.asker(question.balls[0], question.now);
        Crowd crowd;
        for (std::size_t k = 0; k < size; ++k)
            crowd.push(1 + static_cast<Slot>(questions.random().below(Crowd::capacity)));
        asker.meetings(question.balls.data(), crowd);
        ASSERT_EQ(crowd.size, size);
        ASSERT_EQ(crowd.is_full(), size == Crowd::capacity);
        for (std::size_t k = 0; k < size; ++k) {
            Crowd one;
            one.push(crowd.who[k]);
            asker.meetings(question.balls.data(), one);
            ASSERT_EQ(crowd.early[k], one.early[0]) << "one of the crowd: " << k;
            ASSERT_EQ(crowd.late[k], one.late[0]) << "one of the crowd: " << k;
        }
    }
}

/// What the first stage cannot tell, by hand.
TEST(MeetingStages, ThatTheFilterLeavesOpen) {
    const Effects<2> effects;
    std::vector<Ball<2>> balls(2);
    Ball<2>& a = balls[0];
    Ball<2>& b = balls[1];
    a.radius = b.radius = 0.5;
    a.v = {1.0, 0.0};
    const auto told = [&] {
        MeetingFilter<2> filter(effects, Kernel::exact);
        for (const Ball<2>& ball : balls) filter.include(ball);
        Crowd crowd;
        crowd.push(1);
        filter.asker(a, 0.0).meetings(balls.data(), crowd);
        return Meeting{crowd.early[0], crowd.late[0]};
    };
    const auto is_unknown = [](const Meeting& m) {
        return m.early == -infinity && m.late == infinity;
    };
    const auto is_never = [](const Meeting& m) {
        return m.early == infinity && m.late == infinity;
    };
    b.x = {3.0, 0.0};
    EXPECT_LT(told().early, 2.0);
    EXPECT_GT(told().late, 2.0);
    EXPECT_LT(told().late - told().early, 0x1p-35);
    b.x = {3.0, 1.0};  // they graze
    EXPECT_TRUE(is_unknown(told()));
    b.x = {3.0, 1.125};
    EXPECT_TRUE(is_never(told()));
    b.x = {1.0, 0.0};  // they touch
    EXPECT_TRUE(is_unknown(told()));
    b.v = {2.0, 0.0};
    EXPECT_TRUE(is_never(told()));
    b.v = a.v;
    EXPECT_TRUE(is_never(told()));
}

TEST(MeetingStages, OfAGrazeDoubleDoublesTellNothing) {
    const Ball<2> a{{0.0, 0.0}, {1.0, 0.0}, 0.5, 0.0};
    Ball<2> b{{3.0, 1.0}, {0.0, 0.0}, 0.5, 0.0};
    EXPECT_TRUE(std::isnan(refined_meeting(a, b, {}, Effects<2>{}, 3.0)));
    EXPECT_EQ(exact_meeting(a, b, {}, Effects<2>{}), infinity);
    b.x[1] = std::nextafter(1.0, 0.0);
    const double exact = exact_meeting(a, b, {}, Effects<2>{});
    EXPECT_LT(exact, 3.0);
    EXPECT_TRUE(std::isnan(refined_meeting(a, b, {}, Effects<2>{}, 3.0)));
    EXPECT_EQ(refined_meeting(a, b, {}, Effects<2>{}, exact), exact);
}

/// At 1 + 2^-53, between two doubles, only rationals know that the even one is meant.
TEST(MeetingStages, OfAHalfwayTimeDoubleDoublesTellNothing) {
    const Ball<2> a{{0.0, 0.0}, {1.0, 0.0}, 0.5, 0.0};
    Ball<2> b{{2.0, 0.0}, {0.0, 0.0}, 0.5 - 0x1p-53, 0.0};
    EXPECT_TRUE(std::isnan(refined_meeting(a, b, {}, Effects<2>{}, 1.0)));
    EXPECT_EQ(exact_meeting(a, b, {}, Effects<2>{}), 1.0);
    b.radius -= 0x1p-54;  // at 1 + 3/4 ulp
    EXPECT_EQ(refined_meeting(a, b, {}, Effects<2>{}, 1.0), 1.0 + 0x1p-52);
    EXPECT_EQ(exact_meeting(a, b, {}, Effects<2>{}), 1.0 + 0x1p-52);

    Effects<2> walls;
    walls.box = Box<2>{{-1.5 - 0x1p-52, -2.0}, {1.5, 2.0}};
    const Ball<2> to_left{{0x1p-53, 0.0}, {-1.0, 0.0}, 0.5, 0.0};
    EXPECT_TRUE(std::isnan(refined_meeting(to_left, 0, walls, 1.0)));
    EXPECT_EQ(exact_meeting(to_left, 0, walls), 1.0 + 0x1p-51);  // of 1 + 3/2 ulp
}

}  // namespace
}  // namespace signum::motion
