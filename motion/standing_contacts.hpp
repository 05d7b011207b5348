#pragma once
/// Contacts that stand from one time step to the next: from a strike that joins until there is no
/// reaction any more and the surfaces have come apart, when they break (thesis 10.3). To break
/// where the reaction is 0 and the gap still none would let a grain that rocks between two others
/// leave one at each step and strike the other, for ever.
///
/// They are in the order of the numbers of balls and walls, and so is what is solved: it depends on
/// neither slots nor structures.

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "effects/contact_forces.hpp"
#include "simulation.hpp"

namespace signum::motion {

template <int D>
class StandingContacts {
 public:
    /// Numbers: of a ball, and of a ball greater than that or a wall as -1 - wall.
    using Pair = std::pair<std::int32_t, std::int32_t>;
    /// Exchanged in the last step.
    struct Momenta {
        double push = 0.0;
        Vector<D> rub{};
    };
    /// How the two of a pair lie at the beginning of a step.
    struct Place {
        Vector<D> normal{};  ///< from b, or the wall, to a
        double gap = 0.0;
        double friction = 0.0;
        Vector<D> wall_velocity{};
    };

    /// A pair comes into contact; false where it was.
    bool join(Pair pair) { return momenta_.try_emplace(pair).second; }
    [[nodiscard]] bool has(Pair pair) const { return momenta_.contains(pair); }
    void set(Pair pair, const Momenta& momenta) { momenta_[pair] = momenta; }
    [[nodiscard]] const std::map<Pair, Momenta>& all() const noexcept { return momenta_; }

    /// What two overlap by, since within a step they are left alone, is undone by a fifth a step:
    /// so they part slowly.
    static constexpr double undone_a_step = 0.2;

    /// A step begins. place(pair) tells how they lie, body(number) -> ContactBody<D> what a ball is
    /// after the forces, put(number, body) takes its velocity and spin after the reactions.
    /// Contacts without a reaction break; told is how many.
    template <class PlaceOf, class BodyOf, class Put>
    ContactReport begin_step(double step, const LastingContacts& effect, const PlaceOf& place,
                             const BodyOf& body, const Put& put, std::uint64_t& broken) {
        std::map<std::int32_t, std::size_t> index;
        for (const auto& [pair, momenta] : momenta_) {
            index.try_emplace(pair.first);
            if (pair.second >= 0) index.try_emplace(pair.second);
        }
        bodies_.clear();
        for (auto& [number, at] : index) {
            at = bodies_.size();
            bodies_.push_back(body(number));
        }
        contacts_.clear();
        for (const auto& [pair, momenta] : momenta_) {
            const Place lies = place(pair);
            contacts_.push_back({index[pair.first],
                                 pair.second >= 0 ? index[pair.second] : Contact<D>::wall,
                                 lies.normal, lies.gap < 0.0 ? undone_a_step * lies.gap : lies.gap,
                                 lies.friction, lies.wall_velocity, momenta.push, momenta.rub});
        }
        const ContactReport report =
            solve_contacts<D>(bodies_, contacts_, step, effect.tolerance, effect.sweeps);
        for (const auto& [number, at] : index) put(number, bodies_[at]);
        auto solved = contacts_.begin();
        for (auto each = momenta_.begin(); each != momenta_.end(); ++solved) {
            if (solved->normal_impulse > 0.0 || stays_close(*solved, step)) {
                each->second = {solved->normal_impulse, solved->tangential_impulse};
                ++each;
            } else {
                each = momenta_.erase(each);
                ++broken;
            }
        }
        return report;
    }

 private:
    /// Whether the gap after the step is not a visible part of the radii.
    [[nodiscard]] bool stays_close(const Contact<D>& contact, double step) const {
        const ContactBody<D>& a = bodies_[contact.a];
        double radius = a.inert.radius;
        Vector<D> v = a.velocity;
        if (contact.b != Contact<D>::wall) {
            radius = std::min(radius, bodies_[contact.b].inert.radius);
            for (int k = 0; k < D; ++k) v[k] -= bodies_[contact.b].velocity[k];
        } else {
            for (int k = 0; k < D; ++k) v[k] -= contact.wall_velocity[k];
        }
        return contact.gap + step * dot(v, contact.normal) < 0x1p-10 * radius;
    }

    std::map<Pair, Momenta> momenta_;
    std::vector<ContactBody<D>> bodies_;
    std::vector<Contact<D>> contacts_;
};

}  // namespace signum::motion
