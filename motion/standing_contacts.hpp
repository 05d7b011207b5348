#pragma once
/// Contacts that stand from one time step to the next: from a strike that joins until there is no
/// reaction any more and the surfaces have come apart, when they break (thesis 10.3). To break
/// where the reaction is 0 and the gap still none would let a grain that rocks between two others
/// leave one at each step and strike the other, for ever.
///
/// They are in the order of the numbers of balls and walls, and so is what is solved: it depends on
/// neither slots nor structures.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "effects/contact_forces.hpp"
#include "partner.hpp"
#include "simulation.hpp"

namespace signum::motion {

template <int D>
class StandingContacts {
 public:
    /// A ball, and a wall or a ball of a greater number.
    using Pair = std::pair<std::int32_t, Partner>;
    /// Exchanged in the last step.
    struct Momenta {
        double push = 0.0;
        Vector<D> rub{};
        /// Whether the pair may be left alone until the next step: after this one they hardly
        /// overlap.
        bool waits = true;
    };
    /// How the two of a pair lie at the beginning of a step.
    struct Place {
        Vector<D> normal{};  ///< from b, or the wall, to a
        double gap = 0.0;
        double scale = 0.0;  ///< the length of which an overlap may be a visible part
        double friction = 0.0;
        Vector<D> wall_velocity{};
        /// Of a hollow wall, that of the surface on which the centre is: a straight flight along it
        /// of length s enters it by about curvature · s²/2.
        double curvature = 0.0;
    };

    /// A pair comes into contact; false where it was.
    bool join(Pair pair) { return momenta_.try_emplace(pair).second; }
    [[nodiscard]] bool has(Pair pair) const { return momenta_.contains(pair); }
    void set(Pair pair, const Momenta& momenta) { momenta_[pair] = momenta; }
    [[nodiscard]] const std::map<Pair, Momenta>& all() const noexcept { return momenta_; }

    /// What two overlap by, since within a step they are left alone, is undone by a fifth a step:
    /// so they part slowly.
    static constexpr double undone_a_step = 0.2;

    /// Along a hollow wall flights are chords, from the surface to the surface. Of longer ones, as
    /// parts of the surface's radius, only the direction of this one is taken.
    static constexpr double longest_chord = 0.5;
    /// How far such a chord goes inwards on a way along the surface where it begins.
    [[nodiscard]] static double inwards(double curvature, double along) noexcept {
        const double x = std::min(curvature * along, longest_chord);
        return x > 0.0 ? along * x / (1.0 + std::sqrt(1.0 - x * x)) : 0.0;
    }
    /// The sine of the angle at which one of that length begins.
    [[nodiscard]] static double sine_inwards(double curvature, double length) noexcept {
        return 0.5 * std::min(curvature * length, longest_chord);
    }
    [[nodiscard]] static double speed_along(const Vector<D>& v, const Vector<D>& of_wall,
                                            const Vector<D>& normal) noexcept {
        const Vector<D> along = v - of_wall;
        const double parting = dot(along, normal);
        return std::sqrt(std::max(dot(along, along) - parting * parting, 0.0));
    }
    /// How far two in contact may come nearer to one another until the next step.
    [[nodiscard]] static double allowed(double gap, double scale) noexcept {
        return std::max(0x1p-8 * scale + gap, 0x1p-12 * scale);
    }

    /// All balls that hang together with one by contacts of balls, that one among them.
    [[nodiscard]] std::set<std::int32_t> hanging_with(std::int32_t ball) const {
        std::map<std::int32_t, std::vector<std::int32_t>> partners;
        for (const auto& [pair, momenta] : momenta_) {
            if (pair.second.is_wall()) continue;
            partners[pair.first].push_back(pair.second.code());
            partners[pair.second.code()].push_back(pair.first);
        }
        std::set<std::int32_t> found = {ball};
        std::vector<std::int32_t> next = {ball};
        while (!next.empty()) {
            const std::int32_t one = next.back();
            next.pop_back();
            for (const std::int32_t each : partners[one])
                if (found.insert(each).second) next.push_back(each);
        }
        return found;
    }

    /// A part of a time step begins, for the contacts of which takes(pair). place(pair) tells how
    /// they lie, body(number) -> ContactBody<D> what a ball is after the forces, put(number, body)
    /// takes its velocity and spin after the reactions. Of an overlap a part is undone. Contacts
    /// without a reaction break; told is how many.
    template <class Takes, class PlaceOf, class BodyOf, class Put>
    ContactReport begin_step(double step, double undone, const LastingContacts& effect,
                             const Takes& takes, const PlaceOf& place, const BodyOf& body,
                             const Put& put, std::uint64_t& broken) {
        std::map<std::int32_t, std::size_t> index;
        for (const auto& [pair, momenta] : momenta_) {
            if (!takes(pair)) continue;
            index.try_emplace(pair.first);
            if (pair.second.is_ball()) index.try_emplace(pair.second.code());
        }
        bodies_.clear();
        for (auto& [number, at] : index) {
            at = bodies_.size();
            bodies_.push_back(body(number));
        }
        contacts_.clear();
        gaps_.clear();
        for (const auto& [pair, momenta] : momenta_) {
            if (!takes(pair)) continue;
            const Place lies = place(pair);
            const std::size_t a = index[pair.first];
            const double along =
                lies.curvature > 0.0
                    ? step * speed_along(bodies_[a].velocity, lies.wall_velocity, lies.normal)
                    : 0.0;
            const double gap = lies.gap - inwards(lies.curvature, along);
            gaps_.push_back({gap, lies.scale, lies.curvature * along <= longest_chord});
            contacts_.push_back(
                {a, pair.second.is_ball() ? index[pair.second.code()] : Contact<D>::wall,
                 lies.normal, gap - (lies.gap < 0.0 ? (1.0 - undone) * lies.gap : 0.0),
                 lies.friction, lies.wall_velocity, momenta.push, momenta.rub});
        }
        const ContactReport report =
            solve_contacts<D>(bodies_, contacts_, step, effect.tolerance, effect.sweeps);
        for (const auto& [number, at] : index) put(number, bodies_[at]);
        auto solved = contacts_.begin();
        auto gap = gaps_.begin();
        for (auto each = momenta_.begin(); each != momenta_.end();) {
            if (!takes(each->first)) {
                ++each;
                continue;
            }
            const double nearer = step * approach(*solved);
            // Those that overlap by a visible part of the radii part first; then the gap after the
            // step is to be one.
            const double visible = 0x1p-10 * gap->scale;
            const bool stays_close = gap->width < -visible || gap->width - nearer < visible;
            if (solved->normal_impulse > 0.0 || stays_close) {
                each->second = {
                    solved->normal_impulse, solved->tangential_impulse,
                    gap->is_for_whole_step && nearer <= allowed(gap->width, gap->scale)};
                ++each;
            } else {
                each = momenta_.erase(each);
                ++broken;
            }
            ++solved;
            ++gap;
        }
        return report;
    }

 private:
    [[nodiscard]] double approach(const Contact<D>& contact) const noexcept {
        const Vector<D>& of_b =
            contact.b == Contact<D>::wall ? contact.wall_velocity : bodies_[contact.b].velocity;
        return dot(of_b, contact.normal) - dot(bodies_[contact.a].velocity, contact.normal);
    }
    /// As it is, not undone.
    struct Gap {
        double width = 0.0;  ///< less what a chord of a hollow wall goes inwards
        double scale = 0.0;
        bool is_for_whole_step = true;
    };

    std::map<Pair, Momenta> momenta_;
    std::vector<ContactBody<D>> bodies_;
    std::vector<Contact<D>> contacts_;
    std::vector<Gap> gaps_;  // of them
};

}  // namespace signum::motion
