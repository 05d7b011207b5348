#pragma once
/// Sites of one metric that move: what is mended when all do, and when one does. Part of live.hpp,
/// which includes it.

namespace signum::triangulation {

template <class Kernel>
bool Live<Kernel>::mend() {
    Kernel kernel = kernel_of(moved_);
    Repair<Kernel> repair(*topology_, kernel, face_of_);
    const std::size_t most = 64 + count_ / most_wrong;
    const std::size_t wrong = repair.survey(most);
    if (wrong > most) return false;
    std::vector<std::pair<Index, Index>> out;  // sites, and one that was beside
    const bool has_work = wrong > 0;
    if (has_work) {
        const auto take_out = [&](Index h, const auto& look_at) {
            const HalfEdge spoke = spoke_of(h);
            const Index beside = std::max(topology_->target(spoke), topology_->apex(spoke));
            std::vector<Index> freed = {h};
            if (!detach(h, freed) || !is_built_) return false;
            face_of_[at(h)] = -1;
            for (const Index site : freed) out.emplace_back(site, beside);
            for (const Index f : patch_) look_at(f);
            return true;
        };
        if (!repair.mend(64 + count_ / most_taken, take_out)) return false;
        changes_ += repair.flips();
    } else if (!repair.hull_is_right()) {
        return false;
    }
    swap_moved();
    *kernel_ = kernel_of(sites_);
    for (const auto& [h, beside] : out) hidden_by_[at(h)] = -1;
    ++(keep_hidden() && !has_work ? moves_.kept : moves_.mended);
    // Places lie along the curve.
    std::ranges::sort(out);
    for (const auto& [h, beside] : out) {
        const Index near = face_of_[at(beside)];
        if (!is_built_ || near < 0) {
            add(h);
        } else {
            insertion_->start_from(near);
            add_near_recent(h);
        }
    }
    return true;
}

template <class Kernel>
bool Live<Kernel>::keep_hidden() {
    bool are_hidden = true;
    for (Index h = 0; at(h) < live_.size(); ++h) {
        const Index by = hidden_by_[at(h)];
        if (by < 0) continue;
        if (precedes(by, h) && hides_alone(by, h)) {
            kept_.remove(h);
            keep(by, h);
            continue;
        }
        kept_.remove(h);
        if (face_of_[at(by)] >= 0) insertion_->start_from(face_of_[at(by)]);
        add_near_recent(h);
        are_hidden = are_hidden && hidden_by_[at(h)] >= 0;
    }
    return are_hidden;
}

template <class Kernel>
bool Live<Kernel>::move_inside(Index h, Point centre) {
    const HalfEdge spoke = spoke_of(h);
    for (const HalfEdge of : topology_->fan(spoke))
        if (topology_->target(of) == infinite) return false;
    const S& s = sites_[at(h)];
    const Point before = {s.x, s.y};
    displace(h, centre);
    if (!is_star_right(spoke)) {
        displace(h, before);
        return false;
    }
    // The star is divided otherwise among its faces.
    std::vector<Index> freed;
    if constexpr (is_straight) {
        freed = taken_from_star(h);
        for (const Index list : {alone(h), with_others(h)})
            for (const Index hidden : kept_.release(list)) freed.push_back(hidden);
    } else {
        kept_.extract(alone(h), freed, [&](Index hidden) { return !kernel_->hides(h, hidden); });
    }
    add_all(freed);
    return true;
}

template <class Kernel>
bool Live<Kernel>::is_star_right(HalfEdge spoke) {
    LocalChecks<Kernel> checks(*topology_, *kernel_);
    for (const HalfEdge of : topology_->fan(spoke))
        if (!checks.face(Topology::face(of))) return false;
    for (const HalfEdge of : topology_->fan(spoke))
        if (!checks.edge(of) || !checks.edge(Topology::next(of))) return false;
    return true;
}

}  // namespace signum::triangulation
