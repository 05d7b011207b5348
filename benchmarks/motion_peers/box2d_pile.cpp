/// The pile of examples/scenes/sand.toml in Box2D, from the same grains: box2d FRAME.xyz SECONDS
/// prints the seconds it took, the kinetic energy at the end and how deep grains lie in one another
/// at most, in radii. With 0 seconds it judges the frame.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <box2d/box2d.h>

namespace {

struct Grain {
    double x;
    double y;
    double u;
    double v;
    double r;
};

/// The last frame.
std::vector<Grain> read(const char* path) {
    std::ifstream file(path);
    std::vector<Grain> grains;
    std::string line;
    while (std::getline(file, line)) {
        const int number = std::atoi(line.c_str());
        std::getline(file, line);
        grains.clear();
        for (int i = 0; i < number && std::getline(file, line); ++i) {
            std::istringstream text(line);
            std::string name;
            double z = 0.0;
            Grain grain{};
            text >> name >> grain.x >> grain.y >> z >> grain.u >> grain.v >> z >> grain.r;
            grains.push_back(grain);
        }
    }
    return grains;
}

double deepest(const std::vector<Grain>& grains) {
    double deepest = 0.0;
    for (std::size_t i = 0; i < grains.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double apart = std::hypot(grains[i].x - grains[j].x, grains[i].y - grains[j].y);
            const double radii = grains[i].r + grains[j].r;
            deepest = std::max(deepest, (radii - apart) / (0.5 * radii));
        }
    return deepest;
}

void add_wall(b2World& world, const std::vector<b2Vec2>& points) {
    b2BodyDef definition;
    b2Body* const wall = world.CreateBody(&definition);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        b2EdgeShape edge;
        edge.SetTwoSided(points[k], points[k + 1]);
        b2FixtureDef fixture;
        fixture.shape = &edge;
        fixture.friction = 0.5F;
        fixture.restitution = 0.2F;
        wall->CreateFixture(&fixture);
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 3) return 2;
    std::vector<Grain> grains = read(arguments[1]);
    const double seconds = std::atof(arguments[2]);
    b2World world(b2Vec2(0.0F, -10.0F));
    std::vector<b2Vec2> floor;
    for (int k = 0; k <= 36; ++k)
        floor.emplace_back(-18.0F + static_cast<float>(k), k % 2 == 0 ? 0.2F : 0.7F);
    add_wall(world, floor);
    add_wall(world, {{-10.0F, 36.0F}, {-2.2F, 10.0F}});
    add_wall(world, {{10.0F, 36.0F}, {2.2F, 10.0F}});
    add_wall(world, {{-18.0F, 36.0F}, {-18.0F, 0.0F}, {18.0F, 0.0F}, {18.0F, 36.0F}});
    std::vector<b2Body*> bodies;
    for (const Grain& grain : grains) {
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position.Set(static_cast<float>(grain.x), static_cast<float>(grain.y));
        b2Body* const body = world.CreateBody(&definition);
        b2CircleShape circle;
        circle.m_radius = static_cast<float>(grain.r);
        b2FixtureDef fixture;
        fixture.shape = &circle;
        fixture.density = 1.0F / b2_pi;
        // Box2D takes the root of the product of two frictions.
        fixture.friction = 0.5F;
        fixture.restitution = 0.2F;
        body->CreateFixture(&fixture);
        bodies.push_back(body);
    }
    const auto begin = std::chrono::steady_clock::now();
    for (int step = 0; step < seconds * 60.0; ++step) world.Step(1.0F / 60.0F, 8, 3);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    double energy = 0.0;
    for (std::size_t i = 0; i < grains.size() && seconds > 0.0; ++i) {
        grains[i].x = bodies[i]->GetPosition().x;
        grains[i].y = bodies[i]->GetPosition().y;
        energy += 0.5 * bodies[i]->GetMass() * bodies[i]->GetLinearVelocity().LengthSquared();
    }
    std::printf("%.6f %.3g %.2g\n", took.count(), energy, deepest(grains));
    return 0;
}
