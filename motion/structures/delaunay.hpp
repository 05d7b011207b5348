#pragma once
/// The power triangulation of the discs, kept up while they fly (thesis 9.3,
/// triangulation/moving/): in the plane.
///
/// Discs that touch are neighbours in it. For where they touch, at p, both have power 0, and every
/// other disc, as interiors are disjoint, a greater one: p lies in both cells and in no other. So
/// the pair has an edge when it meets; the edge came with an event, which proposed the pair, or was
/// there at the start; and at a strike all neighbours are proposed.
///
/// Time. When it is asked the triangulation is that right after the time of the clock, exactly. It
/// is asked at the first double that is surely not before an event, or later by so little that
/// discs fly past one another by less than the margin.
///
/// Roundings. The third of three discs that touch one another, of radii a, b and c, has the power
/// 4abc/(a+b) at the place where the others touch, and no disc a lesser one. Places that are off by
/// d change powers by some d times the largest radius. So the pair has its edge already when places
/// are off by the margin: that is far less than the square of the smallest radius by the largest
/// one. Where radii are too different, or too small beside the coordinates, the structure is not
/// used (choose).
///
/// In a periodic box a pair may meet across the boundary. Each disc has a copy in the box, and
/// where it is near the lower side of an axis another one a length farther, beyond the upper side;
/// near two lower sides three. All these are discs of a packing, too, and of two discs that meet
/// there are two copies that meet: along each axis either both in the box, or that of the lower one
/// beyond it. A copy is in the box, or farther out by the slack at most; "near" is less than a
/// largest diameter and the slack, and a copy that is no more needed goes a slack later. As images
/// are seen that are nearest, a disc is asked again when it has flown an eighth of the box
/// (Pairs in world.hpp): at that time, or when the edge came, the image that it strikes is the
/// nearest one.
///
/// A row. Discs that are on one line for ever have no faces, and every event and every strike
/// builds their line anew, O(n log n); to ask for the neighbours of one takes O(n). That is for few
/// discs; a row of many is for any other structure.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "../../triangulation/moving/moving_triangulation.hpp"
#include "../cells.hpp"
#include "../simulation.hpp"
#include "../sketch.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Delaunay {
    static_assert(D == 2);

 public:
    explicit Delaunay(const World<D>& world, Structure = Structure::delaunay)
        : Delaunay(world, Spread<D>(world)) {}

    template <class Propose>
    void near(Slot i, const Propose& propose) const {
        neighbours_.clear();
        for (const Index site : discs_[i].copies)
            if (site >= 0) collect_neighbours(i, site);
        std::ranges::sort(neighbours_);
        neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
        for (const Slot j : neighbours_) propose(j);
    }

    /// When the disc is to be asked again, its copies change, or the triangulation does, of which
    /// one disc takes care: whoever hears of an event that is earlier than the one taken care of.
    [[nodiscard]] double next(Slot i, double now) {
        follow(i, now);
        double time = std::min(discs_[i].ask_at, border(i, now));
        if (!discs_[i].untold.empty() || !new_pairs_.empty()) time = now;
        const double due = next_flip();
        if (i == holder_ || due < held_) {
            holder_ = i;
            held_ = due;
            time = std::min(time, due);
        }
        return std::max(time, now);
    }

    template <class Propose, class Touch>
    void own_event(Slot i, double now, const Propose& propose, const Touch& touch) {
        cross(i, now);
        triangulation_->advance(now);
        if (now >= discs_[i].ask_at) {
            discs_[i].ask_at = ask_after(i, now);
            near(i, propose);
        }
        note_new_pairs();
        // A touch may bring new ones.
        pairs_told_.swap(new_pairs_);
        for (const auto& [a, b] : pairs_told_) {
            if (a == i || b == i) {
                propose(a == i ? b : a);
            } else {
                discs_[a].untold.push_back(b);
                touch(a);
            }
        }
        pairs_told_.clear();
        for (const Slot j : discs_[i].untold) propose(j);
        discs_[i].untold.clear();
    }

    [[nodiscard]] double margin() const noexcept { return margin_; }

    /// Neighbours; slots stand for numbers.
    void sketch(double, Sketch<D>& sketch) const {
        for (Slot i = 0; i < discs_.size(); ++i) near(i, [&](Slot j) { link(sketch, i, j); });
    }

 private:
    struct Disc {
        /// By how many lengths of the box its copy in the box is shifted, along each axis.
        Vector<D> base{};
        /// The sites of the copy in the box and, 1 and 2 more, of those beyond its sides; or -1.
        std::array<Index, 4> copies = {-1, -1, -1, -1};
        double ask_at = infinity;
        /// New neighbours that are to be proposed at its next event.
        std::vector<Slot> untold;
    };

    Delaunay(const World<D>& world, const Spread<D>& spread)
        : world_(world),
          margin_(std::min(
              spread.margin(),
              0x1p-6 * (spread.smallest_radius / spread.largest_radius) * spread.smallest_radius)),
          slack_(spread.largest_radius),
          belt_(2.0 * spread.largest_radius + slack_ + 4.0 * margin_),
          discs_(world.balls.size()),
          triangulation_(std::make_unique<kinetic::MovingTriangulation>(
              world.start, Fall{world.effects.gravity[0], world.effects.gravity[1]})) {
        std::vector<MovingSite> sites;
        for (Slot i = 0; i < discs_.size(); ++i) {
            const Vector<D> x = world.centre(i, world.start);
            unsigned ghosts = 0;
            for (int k = 0; k < D && world.effects.periodic; ++k) {
                const double low = world.effects.box->low[k];
                discs_[i].base[k] = std::floor((x[k] - low) * world.inverse_length[k]);
                if (inside(i, k, x[k]) < belt_) ghosts |= 1U << k;
            }
            for (unsigned copy = 0; copy < 4; ++copy) {
                if ((copy & ~ghosts) != 0) continue;
                discs_[i].copies[copy] = static_cast<Index>(sites.size());
                sites.push_back(site_of(i, copy));
                owners_.push_back(i);
            }
            discs_[i].ask_at = ask_after(i, world.start);
        }
        triangulation_->insert(sites);
        triangulation_->watch([this](Index a, Index b, bool comes) {
            if (comes) new_edges_.emplace_back(a, b);
        });
    }

    /// Of edges that have come the discs; a site's owner is known only when it is in.
    void note_new_pairs() {
        for (const auto& [a, b] : new_edges_) {
            const Slot i = owners_[static_cast<std::size_t>(a)];
            const Slot j = owners_[static_cast<std::size_t>(b)];
            if (i != j) new_pairs_.emplace_back(i, j);
        }
        new_edges_.clear();
    }

    /// A place along an axis, from the box's lower side on, of the copy in the box.
    [[nodiscard]] double inside(Slot i, int k, double x) const noexcept {
        return (x - world_.effects.box->low[k]) - discs_[i].base[k] * world_.length[k];
    }
    [[nodiscard]] MovingSite site_of(Slot i, unsigned copy) const noexcept {
        const Ball<D>& ball = world_.balls[i];
        Vector<D> x = ball.x;
        for (int k = 0; k < D && world_.effects.periodic; ++k)
            x[k] -= (discs_[i].base[k] - ((copy >> k & 1) != 0 ? 1.0 : 0.0)) * world_.length[k];
        return {x[0], x[1], ball.v[0], ball.v[1], ball.radius, ball.time};
    }
    void collect_neighbours(Slot i, Index site) const {
        const auto take = [&](Index other) {
            if (other == infinite) return;
            const Slot j = owners_[static_cast<std::size_t>(other)];
            if (j != i) neighbours_.push_back(j);
        };
        if (triangulation_->is_line()) {
            const auto line = triangulation_->line();
            for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                if (line[k] == site) take(line[k + 1]);
                if (line[k + 1] == site) take(line[k]);
            }
            return;
        }
        const kinetic::Topology& topology = triangulation_->topology();
        const Index face = triangulation_->face_of(site);
        // No disc of a packing is hidden, nor one that lies a margin inside another one.
        if (face < 0) return;
        for (const kinetic::HalfEdge h : topology.fan(topology.spoke(face, site)))
            take(topology.target(h));
    }

    /// When the triangulation's next event is over, or up to so little later as its discs fly past
    /// one another by less than the margin: to narrow its root takes as long as a flip.
    [[nodiscard]] double next_flip() const {
        const kinetic::Event* event = triangulation_->next_event();
        if (event == nullptr) return infinity;
        const auto& sites = event->certificate.sites;
        const Vector<D> v = velocity_at_start(sites[0]);
        double fastest = 0.0;
        for (const Index site : sites) {
            const Vector<D> u = velocity_at_start(site);
            fastest = std::max(fastest, std::hypot(u[0] - v[0], u[1] - v[1]));
        }
        const double width = event->root.high - event->root.low;
        return 2.0 * fastest * width <= margin_ ? event->root.high : *triangulation_->next_time();
    }
    /// As if it had flown like that since then: what falls keeps its velocity to all that falls.
    [[nodiscard]] Vector<D> velocity_at_start(Index site) const {
        const MovingSite& s = triangulation_->site(site);
        const Vector<D>& g = world_.effects.gravity;
        const double since = s.time - world_.start;
        return {s.vx - g[0] * since, s.vy - g[1] * since};
    }

    /// The disc may have struck something.
    void follow(Slot i, double now) {
        const MovingSite& was = triangulation_->site(discs_[i].copies[0]);
        if (was == site_of(i, 0)) return;
        triangulation_->advance(now);
        // At a strike places are brought into the box; copies stay where they are.
        if (world_.effects.periodic) {
            const Ball<D> before{{was.x, was.y}, {was.vx, was.vy}, was.r, was.time};
            const Vector<D> then = centre(before, now, world_.effects);
            const Vector<D> here = world_.centre(i, now);
            for (int k = 0; k < D; ++k)
                discs_[i].base[k] = nearest_integer((here[k] - then[k]) * world_.inverse_length[k]);
        }
        for (unsigned copy = 0; copy < 4; ++copy)
            if (const Index site = discs_[i].copies[copy]; site >= 0)
                triangulation_->change(site, site_of(i, copy));
        note_new_pairs();
        discs_[i].ask_at = ask_after(i, now);
    }

    [[nodiscard]] double ask_after(Slot i, double now) const noexcept {
        return stride_ < infinity ? now + world_.time_for(i, now, stride_) : infinity;
    }
    /// How far along an axis the copy in the box may fly as it is.
    struct Stay {
        double low;
        double high;
    };
    [[nodiscard]] Stay stay(Slot i, int k) const noexcept {
        if (discs_[i].copies[1U << k] >= 0) return {-slack_, belt_ + slack_};
        return {belt_, world_.length[k] + slack_};
    }
    /// When the disc's copies change.
    [[nodiscard]] double border(Slot i, double now) const noexcept {
        double time = infinity;
        if (!world_.effects.periodic) return time;
        const Vector<D> x = world_.centre(i, now);
        const Vector<D> v = world_.velocity(i, now);
        for (int k = 0; k < D; ++k) {
            const auto [low, high] = stay(i, k);
            const double place = inside(i, k, x[k]);
            const double way = world_.falls ? std::min(place - low, high - place)
                               : v[k] > 0.0 ? high - place
                                            : place - low;
            if (way <= margin_) return now;
            const double g = std::fabs(world_.effects.gravity[k]);
            const double speed = std::fabs(v[k]);
            time = std::min(time,
                            now + 2.0 * way / (speed + std::sqrt(speed * speed + 2.0 * g * way)));
        }
        return time;
    }
    void cross(Slot i, double now) {
        if (!world_.effects.periodic) return;
        for (int k = 0; k < D; ++k) {
            const auto [low, high] = stay(i, k);
            const double place = inside(i, k, world_.centre(i, now)[k]);
            if (place > low + 2.0 * margin_ && place < high - 2.0 * margin_) continue;
            triangulation_->advance(now);
            Disc& disc = discs_[i];
            const unsigned bit = 1U << k;
            const bool was_low = disc.copies[bit] >= 0;
            const bool goes_up = place >= high - 2.0 * margin_;
            // From beyond a side to the other one: the copies are there already, but for one.
            if (was_low != goes_up) disc.base[k] += goes_up ? 1.0 : -1.0;
            for (const unsigned copy : {0U, 3U ^ bit}) {
                Index& in_box = disc.copies[copy];
                Index& beyond = disc.copies[copy | bit];
                if (in_box < 0) continue;
                if (was_low && goes_up) {
                    remove(beyond);
                } else if (was_low) {
                    remove(in_box);
                    in_box = std::exchange(beyond, -1);
                } else if (goes_up) {
                    beyond = in_box;
                    add(i, copy);
                } else {
                    add(i, copy | bit);
                }
            }
        }
    }
    void remove(Index& site) {
        if (site < 0) return;
        triangulation_->erase(site);
        site = -1;
    }
    void add(Slot i, unsigned copy) {
        const Index site = triangulation_->insert(site_of(i, copy));
        if (static_cast<std::size_t>(site) >= owners_.size())
            owners_.resize(static_cast<std::size_t>(site) + 1);
        owners_[static_cast<std::size_t>(site)] = i;
        discs_[i].copies[copy] = site;
        note_new_pairs();
    }

    const World<D>& world_;
    double margin_;
    double slack_;
    double belt_;
    double stride_ = world_.stride();
    std::vector<Disc> discs_;
    std::vector<Slot> owners_;  ///< of sites
    std::unique_ptr<kinetic::MovingTriangulation> triangulation_;
    Slot holder_ = ~Slot{0};  ///< who takes care of the triangulation's next event, and when
    double held_ = infinity;
    std::vector<std::pair<Index, Index>> new_edges_;  ///< between sites
    std::vector<std::pair<Slot, Slot>> new_pairs_;    ///< of discs that have become neighbours
    std::vector<std::pair<Slot, Slot>> pairs_told_;   ///< those that are just being told
    mutable std::vector<Slot> neighbours_;
};

}  // namespace signum::motion
