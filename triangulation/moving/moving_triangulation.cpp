#include "moving_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "../../exact/kept_environment.hpp"
#include "../dynamic/local_checks.hpp"
#include "../dynamic/near_face.hpp"
#include "../insertion/delete.hpp"
#include "../structure/flip.hpp"

namespace signum::kinetic {

using Kind = Certificate::Kind;
using triangulation::Gap;

MovingTriangulation::MovingTriangulation(double start, Fall fall)
    : sites_{{}, fall},
      moment_(start),
      kernel_(sites_, moment_, tally_),
      queue_(0, Order{&sites_, &tally_}) {}
MovingTriangulation::~MovingTriangulation() = default;

// ---- sites ----

void MovingTriangulation::make_room(std::size_t sites) {
    if (sites <= room_) return;
    // Where memory is short all is as it was, but for what is larger than it has to be.
    const std::size_t room = std::max(sites, 2 * room_);
    const std::size_t faces = room < 2 ? 0 : 2 * room - 2;
    moving_.reserve(room);
    sites_.moving = moving_;
    live_.reserve(room);
    hidden_by_.resize(room, -1);
    none_hidden_.resize(room, -1);
    is_hidden_.resize(room, false);
    face_of_.resize(room, -1);
    home_.resize(room, -1);
    lodgers_.make_room(faces, room);
    queue_.make_room(4 * std::max(faces, room));
    topology_.make_room(room);
    room_ = room;
    if (!is_line_)
        insertion_ = std::make_unique<Insertion>(topology_, kernel_, hidden_by_, recent_);
}

Index MovingTriangulation::put(const MovingSite& site) {
    Index i = 0;
    if (free_.empty()) {
        i = static_cast<Index>(live_.size());
        make_room(live_.size() + 1);
        live_.push_back(true);
        moving_.push_back(site);
    } else {
        i = *free_.begin();
        free_.erase(free_.begin());
        live_[at(i)] = true;
        moving_[at(i)] = site;
        moment_.sites_have_changed();
    }
    sites_.moving = moving_;
    ++count_;
    return i;
}

void MovingTriangulation::insert(std::span<const MovingSite> sites) {
    make_room(live_.size() + sites.size());
    for (const MovingSite& site : sites) {
        const Index i = put(site);
        is_hidden_[at(i)] = true;
    }
    build();
}

Index MovingTriangulation::insert(const MovingSite& site) {
    const Index i = put(site);
    if (is_line_) {
        build();
        return i;
    }
    is_hidden_[at(i)] = true;
    home_[at(i)] = face_near(i);
    homeless_.push_back(i);
    settle_or_build();
    return i;
}

void MovingTriangulation::erase(Index i) {
    live_[at(i)] = false;
    --count_;
    free_.insert(i);
    if (is_line_) return build();
    if (is_hidden_[at(i)]) {
        queue_.erase(subject(i));
        lodgers_.remove(i);
    } else {
        if (!take_out(i)) return build();
        settle_or_build();
    }
}

void MovingTriangulation::change(Index i, const MovingSite& site) {
    if (is_line_) {
        moving_[at(i)] = site;
        moment_.sites_have_changed();
        return build();
    }
    if (is_hidden_[at(i)]) {
        queue_.erase(subject(i));
        lodgers_.remove(i);
    } else {
        const HalfEdge spoke = topology_.spoke(face_of(i), i);
        for (const HalfEdge of : topology_.fan(spoke)) {
            release_hidden(Topology::face(of));
            forget_edges(Topology::face(of));
        }
        const MovingSite before = std::exchange(moving_[at(i)], site);
        moment_.sites_have_changed();
        if (keeps_star(i)) return settle_or_build();
        for (const HalfEdge of : topology_.fan(spoke)) forget_edges(Topology::face(of));
        moving_[at(i)] = before;
        if (!take_out(i)) {
            moving_[at(i)] = site;
            return build();
        }
    }
    moving_[at(i)] = site;
    moment_.sites_have_changed();
    is_hidden_[at(i)] = true;
    homeless_.push_back(i);
    settle_or_build();
}

/// A visible site has become another one. Whether all around it is right nevertheless.
bool MovingTriangulation::keeps_star(Index i) {
    bool on_hull = false;
    for (const HalfEdge of : topology_.fan(topology_.spoke(face_of(i), i))) {
        const Index f = Topology::face(of);
        const auto& v = topology_.vertices(f);
        if (topology_.is_infinite(f))
            on_hull = true;
        else if (kernel_.ccw(v[0], v[1], v[2]) <= 0)
            return false;
        if (!is_right(of) || !is_right(Topology::next(of))) return false;
    }
    return !on_hull || hull_winds_once();
}

/// The gap that a visible site leaves is closed, and its edges are to be looked at.
bool MovingTriangulation::take_out(Index i) {
    std::vector<Index> faces;
    const HalfEdge spoke = topology_.spoke(face_of(i), i);
    const Index outside = Topology::face(topology_.twin(Topology::next(spoke)));
    std::vector<Index> ring;
    for (const HalfEdge of : topology_.fan(spoke)) {
        faces.push_back(Topology::face(of));
        ring.push_back(topology_.target(of));
    }
    for (const Index f : faces) {
        release_hidden(f);
        forget_edges(f);
    }
    const Gap gap = triangulation::Deletion<MovingKernel>(*insertion_, none_hidden_).erase(spoke);
    face_of_[at(i)] = -1;
    if (gap != Gap::closed) return false;
    for (const Index v : ring) tell(i, v, false);
    recent_ = outside;
    std::erase_if(faces, [&](Index f) { return topology_.is_vacant(f); });
    for (const Index f : faces) topology_.record(f).mark = 1;
    for (const Index f : faces) {
        note_corners(f);
        for (HalfEdge h = Topology::first_edge(f); h < Topology::first_edge(f) + 3; ++h) {
            pending_.push_back(h);
            const HalfEdge t = topology_.twin(h);
            if (h < t && topology_.record(Topology::face(t)).mark != 0)
                tell(topology_.origin(h), topology_.target(h), true);
        }
    }
    for (const Index f : faces) topology_.record(f).mark = 0;
    home_[at(i)] = recent_;
    return true;
}

// ---- time ----

void MovingTriangulation::advance(double t) {
    while (!queue_.empty() && is_next_by(t)) step();
    moment_.set(t);
}

std::optional<double> MovingTriangulation::next_time() const {
    if (queue_.empty()) return std::nullopt;
    const auto& [event, number, subject] = queue_.top();
    if (told_event_.load(std::memory_order_acquire) == number)
        return told_time_.load(std::memory_order_relaxed);
    const CertificateForm form(event.certificate, sites_);
    const roots::Polynomial polynomial(form, near(event.root));
    const double time = polynomial.narrowed(event.root, nullptr).high;
    told_time_.store(time, std::memory_order_relaxed);
    told_event_.store(number, std::memory_order_release);
    return time;
}

bool MovingTriangulation::is_next_by(double t) {
    const auto& [event, number, subject] = queue_.top();
    if (told_event_.load(std::memory_order_relaxed) == number)
        return told_time_.load(std::memory_order_relaxed) <= t;
    return kinetic::compare(sites_, event, t, &tally_) <= 0;
}

/// All events of the next time.
void MovingTriangulation::step() {
    moment_.set(sites_, queue_.top().when);
    ++work_.times;
    if (is_line_) {
        ++work_.events;
        return build();
    }
    do {
        const Queue::Subject subject = queue_.pop().subject;
        ++work_.events;
        if ((subject & 3) == 3) {
            const auto q = static_cast<Index>(subject >> 2);
            lodgers_.remove(q);
            homeless_.push_back(q);
        } else {
            pending_.push_back(subject);
        }
    } while (!queue_.empty() && moment_.compare(sites_, queue_.top().when, &tally_) == 0);
    note_flat(pending_);
    // The hull winds otherwise only where it has been folded back at a corner. There the faces in
    // the corner are flat, and the hull's edges at both sides of it have a root, too.
    if (pending_.size() > 1)
        for (const HalfEdge h : pending_)
            hull_is_suspect_ |= topology_.is_infinite(Topology::face(h)) ||
                                topology_.is_infinite(Topology::face(topology_.twin(h)));
    settle_or_build();
}

/// The faces beside edges with a root that are flat at the time, and all that are flat beside
/// those.
void MovingTriangulation::note_flat(std::span<const HalfEdge> edges) {
    const std::size_t first = suspects_.size();
    const auto look_at = [&](Index f) {
        if (topology_.is_infinite(f) || topology_.record(f).mark != 0) return;
        const auto& v = topology_.vertices(f);
        const Certificate turn{{v[0], v[1], v[2], v[2]}, Kind::left_turn};
        if (moment_.sign_then(sites_, turn, &tally_) != 0) return;
        topology_.record(f).mark = 1;
        suspect(f);
    };
    for (const HalfEdge h : edges) {
        look_at(Topology::face(h));
        look_at(Topology::face(topology_.twin(h)));
    }
    for (std::size_t k = first; k < suspects_.size(); ++k)
        for (unsigned e = 0; e < 3; ++e)
            look_at(Topology::face(topology_.twin(Topology::first_edge(suspects_[k].face) + e)));
    for (std::size_t k = first; k < suspects_.size(); ++k)
        topology_.record(suspects_[k].face).mark = 0;
}

// ---- what is right ----

bool MovingTriangulation::is_right(HalfEdge h) {
    const auto [b, c, a, d] = topology_.about(h);
    const Queue::Subject edge = topology_.edge(h);
    if (a == d) {
        queue_.erase(edge);
        return false;
    }
    Sign sign = 0;
    const auto take = [&](const Certificate& certificate) {
        std::optional<roots::Root> root;
        sign = moment_.own_sign(certificate);
        if (sign >= 0) {
            const auto ahead = moment_.ahead(sites_, certificate, &tally_);
            if (!ahead) return false;
            sign = ahead->sign;
            root = ahead->root;
        }
        if (sign > 0 && root)
            queue_.set(edge, {*root, certificate});
        else
            queue_.erase(edge);
        return true;
    };
    if (a == infinite || d == infinite) {
        if (!take(d == infinite ? Certificate{{a, b, c, c}, Kind::left_turn}
                                : Certificate{{d, c, b, b}, Kind::left_turn}))
            queue_.erase(edge);
        return sign > 0;
    }
    if (b == infinite || c == infinite) {
        const Index before = b == infinite ? a : d;
        const Index middle = b == infinite ? c : b;
        const Index after = b == infinite ? d : a;
        if (!take({{before, middle, after, after}, Kind::left_turn})) {
            queue_.erase(edge);
            // Between them, and staying there: who passes another one has a root then.
            const bool along_x = kernel_.beyond(after, before, true) != 0;
            if (kernel_.beyond(middle, before, along_x) != kernel_.beyond(after, middle, along_x))
                return false;
            certify_in_segment(sites_, before, after, middle, along_x, take);
        }
        return sign > 0;
    }
    if (!certify_outside(sites_, a, b, c, d, take)) queue_.erase(edge);
    return sign >= 0;
}

bool MovingTriangulation::has_three_edges(HalfEdge spoke) const noexcept {
    HalfEdge h = topology_.around_origin(spoke);
    if (h == spoke) return false;
    h = topology_.around_origin(h);
    return h != spoke && topology_.around_origin(h) == spoke;
}

bool MovingTriangulation::may_be(Index a, Index b, Index c) {
    if (a == infinite || b == infinite || c == infinite) return true;
    const Sign turn = kernel_.ccw(a, b, c);
    suspects_flat_ |= turn == 0;
    return turn >= 0;
}
void MovingTriangulation::suspect(Index face) {
    const auto& v = topology_.vertices(face);
    suspects_.push_back({face, {v[0], v[1], v[2]}});
}
bool MovingTriangulation::is_cleared(const Face& suspect) {
    const auto& v = topology_.vertices(suspect.face);
    return !std::equal(v, v + 3, suspect.vertex) || topology_.is_infinite(suspect.face) ||
           kernel_.ccw(v[0], v[1], v[2]) > 0;
}

bool MovingTriangulation::hull_winds_once() {
    return triangulation::LocalChecks<MovingKernel>(topology_, kernel_).hull(infinite_face_);
}

// ---- changes ----

void MovingTriangulation::forget_edges(Index face) {
    for (HalfEdge h = Topology::first_edge(face); h < Topology::first_edge(face) + 3; ++h)
        queue_.erase(topology_.edge(h));
}
/// Whoever lies in the face has to be looked for.
void MovingTriangulation::release_hidden(Index face) {
    if (lodgers_.is_empty(face)) return;
    for (const Index q : lodgers_.release(face)) {
        queue_.erase(subject(q));
        homeless_.push_back(q);
    }
}
void MovingTriangulation::note_corner(Index v, Index face) {
    if (v == infinite)
        infinite_face_ = face;
    else
        face_of_[at(v)] = face;
}
void MovingTriangulation::note_corners(Index face) {
    recent_ = face;
    for (const Index v : topology_.vertices(face)) note_corner(v, face);
}

/// Flips an edge that fails, or hides one of its ends; false where neither can be done.
bool MovingTriangulation::make_right(HalfEdge h) {
    const HalfEdge t = topology_.twin(h);
    const auto [b, c, a, d] = topology_.about(h);
    if (b != infinite && has_three_edges(h)) return hide(h);
    if (c != infinite && has_three_edges(t)) return hide(t);
    if (a == d) return false;
    // Infinity keeps three edges, and gets none twice.
    if ((b == infinite && has_three_edges(h)) || (c == infinite && has_three_edges(t)))
        return false;
    if (a == infinite || d == infinite) {
        const HalfEdge inner = a == infinite ? topology_.previous(t) : topology_.previous(h);
        for (const HalfEdge of : topology_.fan(inner))
            if (topology_.target(of) == infinite) return false;
    }
    suspects_flat_ = false;
    if (!may_be(a, b, d) || !may_be(d, c, a)) return false;
    const Index f = Topology::face(h);
    const Index g = Topology::face(t);
    release_hidden(f);
    release_hidden(g);
    tell(b, c, false);
    flip(topology_, h);
    tell(a, d, true);
    ++work_.flips;
    recent_ = f;
    // The others have kept the face that they had.
    note_corner(b, f);
    note_corner(c, g);
    if (suspects_flat_) {
        suspect(f);
        suspect(g);
    }
    const HalfEdge in_f = Topology::first_edge(f);
    const HalfEdge in_g = Topology::first_edge(g);
    // Their events stay in the queue until they get others, but for those of half-edges that stand
    // for their edges no more.
    for (const HalfEdge edge : {in_f, in_f + 1, in_g, in_g + 1, in_f + 2}) {
        queue_.erase(std::max(edge, topology_.twin(edge)));
        pending_.push_back(edge);
    }
    return true;
}

/// The origin of h, which has three edges, goes behind the face that is left.
bool MovingTriangulation::hide(HalfEdge h) {
    const Index v = topology_.origin(h);
    std::array<Index, 3> faces{};
    std::array<Index, 3> corners{};
    std::size_t k = 0;
    bool at_hull = false;
    for (const HalfEdge of : topology_.fan(h)) {
        faces[k] = Topology::face(of);
        corners[k++] = topology_.target(of);
        // Infinity keeps three edges.
        if (topology_.target(of) == infinite && has_three_edges(topology_.twin(of))) at_hull = true;
    }
    suspects_flat_ = false;
    if (at_hull || !may_be(corners[0], corners[1], corners[2])) return false;
    for (const Index face : faces) {
        forget_edges(face);
        release_hidden(face);
    }
    for (const Index u : corners) tell(v, u, false);
    remove_vertex(topology_, h);
    insertion_->vacant().push(faces[1]);
    insertion_->vacant().push(faces[2]);
    ++work_.hidden;
    face_of_[at(v)] = -1;
    is_hidden_[at(v)] = true;
    home_[at(v)] = faces[0];
    homeless_.push_back(v);
    note_corners(faces[0]);
    if (suspects_flat_) suspect(faces[0]);
    for (unsigned e = 0; e < 3; ++e) pending_.push_back(Topology::first_edge(faces[0]) + e);
    return true;
}

bool MovingTriangulation::settle() {
    // More than flips in good order take, and what is asked again after one; that would come to an
    // end, but building is sooner done.
    std::uint64_t left = 64 + 8 * static_cast<std::uint64_t>(topology_.faces());
    for (;;) {
        while (!pending_.empty()) {
            const HalfEdge h = pending_.back();
            pending_.pop_back();
            if (topology_.is_vacant(Topology::face(h)) || is_right(h)) continue;
            if (!make_right(h)) {
                blocked_.push_back(h);
                continue;
            }
            if (left < 1 + blocked_.size()) return false;
            left -= 1 + blocked_.size();
            pending_.insert(pending_.end(), blocked_.begin(), blocked_.end());
            blocked_.clear();
        }
        if (!blocked_.empty()) return false;
        for (const Face& face : suspects_)
            if (!is_cleared(face)) return false;
        suspects_.clear();
        if (hull_is_suspect_ && !hull_winds_once()) return false;
        hull_is_suspect_ = false;
        if (homeless_.empty()) return true;
        const Index q = homeless_.back();
        homeless_.pop_back();
        place(q);
    }
}

/// A hidden site gets the face in which it lies, or appears there.
void MovingTriangulation::place(Index q) {
    const Index before = home_[at(q)];
    const Index start = topology_.is_vacant(before) ? recent_ : before;
    const Index f = triangulation::locate(topology_, kernel_, start, q);
    const auto& v = topology_.vertices(f);
    if (topology_.is_infinite(f) || kernel_.conflicts(v[0], v[1], v[2], q)) return appear(f, q);
    home_[at(q)] = f;
    lodgers_.add(f, q);
    schedule_hidden(q);
}

/// One face becomes three around a site.
void MovingTriangulation::appear(Index face, Index q) {
    forget_edges(face);
    release_hidden(face);
    auto& vacant = insertion_->vacant();
    std::array<Index, 3> faces = {face, 0, 0};
    for (std::size_t k = 1; k < 3; ++k)
        faces[k] = vacant.empty() ? topology_.add_face(infinite, infinite, infinite) : vacant.pop();
    std::array<Index, 3> corners{};
    std::array<HalfEdge, 3> outside{};
    for (std::size_t k = 0; k < 3; ++k) {
        const HalfEdge h = Topology::first_edge(face) + static_cast<HalfEdge>(k);
        corners[k] = topology_.origin(h);
        outside[k] = topology_.twin(h);
    }
    for (std::size_t k = 0; k < 3; ++k)
        topology_.record(faces[k]) = {{corners[k], corners[(k + 1) % 3], q}, 0, {0, 0, 0}};
    is_hidden_[at(q)] = false;
    ++work_.appeared;
    for (std::size_t k = 0; k < 3; ++k) {
        const HalfEdge h = Topology::first_edge(faces[k]);
        topology_.glue(h, outside[k]);
        topology_.glue(h + 1, Topology::first_edge(faces[(k + 1) % 3]) + 2);
        tell(q, corners[k], true);
    }
    for (const Index f : faces) {
        note_corners(f);
        suspect(f);
        for (unsigned e = 0; e < 2; ++e) pending_.push_back(Topology::first_edge(f) + e);
    }
}

void MovingTriangulation::schedule_hidden(Index q) {
    std::optional<Event> first;
    const auto take = [&](const Certificate& certificate) {
        const auto ahead = moment_.ahead(sites_, certificate, &tally_);
        if (!ahead) return false;
        if (ahead->root) {
            const Event event{*ahead->root, certificate};
            if (!first || kinetic::compare(sites_, event, *first, &tally_) < 0) first = event;
        }
        return true;
    };
    const auto& v = topology_.vertices(home_[at(q)]);
    certify_outside(sites_, v[0], v[1], v[2], q, take);
    for (int k = 0; k < 3; ++k)
        static_cast<void>(take({{v[k], v[(k + 1) % 3], q, q}, Kind::left_turn}));
    if (first)
        queue_.set(subject(q), *first);
    else
        queue_.erase(subject(q));
}

// ---- who lies near, and who is told ----

std::array<double, 2> MovingTriangulation::roughly(Index i) const noexcept {
    const MovingSite& site = moving_[at(i)];
    const double s = moment_.time() - site.time;
    const auto along = [&](double x, double v, double g) {
        const double place = x + s * (v + 0.5 * g * s);
        return std::isfinite(place) ? place : 0.0;
    };
    return {along(site.x, site.vx, sites_.fall.x), along(site.y, site.vy, sites_.fall.y)};
}

Index MovingTriangulation::face_near(Index q) const {
    const std::array<double, 2> there = roughly(q);
    const std::span<const Index> face_of(face_of_.data(), live_.size());
    return triangulation::near_face(topology_, face_of, recent_, [&](Index v) {
        const std::array<double, 2> here = roughly(v);
        const double dx = here[0] - there[0];
        const double dy = here[1] - there[1];
        return dx * dx + dy * dy;
    });
}

/// On the way edges may come and go again.
void MovingTriangulation::tell_all() {
    std::ranges::sort(changed_edges_);
    for (std::size_t k = 0; k < changed_edges_.size();) {
        const auto [a, b, by] = changed_edges_[k];
        int sum = 0;
        for (; k < changed_edges_.size() && changed_edges_[k][0] == a && changed_edges_[k][1] == b;
             ++k)
            sum += changed_edges_[k][2];
        if (sum == 0) continue;
        const exact::KeptEnvironment kept;
        watch_(a, b, sum > 0);
    }
    changed_edges_.clear();
}

}  // namespace signum::kinetic
