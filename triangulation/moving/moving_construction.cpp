/// The triangulation of moving sites, built all anew for the moment at hand.

#include <algorithm>
#include <memory>
#include <utility>

#include "../insertion/collinear.hpp"
#include "../insertion/hiders.hpp"
#include "../options.hpp"
#include "../structure/spatial_order.hpp"
#include "moving_triangulation.hpp"

namespace signum::kinetic {

using Kind = Certificate::Kind;

template <class Visit>
void MovingTriangulation::for_each_edge(const Visit& visit) const {
    if (!watch_) return;
    for (std::size_t k = 1; k < line_.size(); ++k) visit(line_[k - 1], line_[k]);
    for (Index f = 0; !is_line_ && f < topology_.faces(); ++f) {
        if (topology_.is_vacant(f)) continue;
        const auto& v = topology_.vertices(f);
        for (int k = 0; k < 3; ++k)
            if (v[k] < v[(k + 1) % 3]) visit(v[k], v[(k + 1) % 3]);
    }
}

void MovingTriangulation::build() {
    ++work_.rebuilds;
    for_each_edge([&](Index a, Index b) { tell(a, b, false); });
    queue_.clear();
    pending_.clear();
    blocked_.clear();
    homeless_.clear();
    suspects_.clear();
    hull_is_suspect_ = false;
    lodgers_.clear();
    line_.clear();
    is_line_ = true;
    insertion_.reset();
    topology_ = Topology(room_);
    std::ranges::fill(hidden_by_, -1);
    std::ranges::fill(face_of_, -1);
    std::ranges::fill(home_, -1);

    std::vector<Index> order;
    std::vector<Site> places;
    for (Index i = 0; at(i) < live_.size(); ++i)
        if (live_[at(i)]) {
            order.push_back(i);
            const auto [x, y] = roughly(i);
            places.push_back({x, y, 0.0});
        }
    const LargeArray<Index> along_curve = triangulation::spatial_order({places, false}, 1);
    std::vector<Index> sorted;
    for (const Index k : along_curve) sorted.push_back(order[static_cast<std::size_t>(k)]);

    std::size_t second = 1;
    while (second < sorted.size() && kernel_.compare_along(sorted[0], sorted[second]) == 0)
        ++second;
    std::size_t third = second + 1;
    while (third < sorted.size() && kernel_.ccw(sorted[0], sorted[second], sorted[third]) == 0)
        ++third;
    if (third < sorted.size())
        build_faces(std::move(sorted), second, third);
    else
        build_line(std::move(sorted));

    for_each_edge([&](Index a, Index b) { tell(a, b, true); });
    tell_all();
}

void MovingTriangulation::build_faces(std::vector<Index> order, std::size_t second,
                                      std::size_t third) {
    is_line_ = false;
    Index b = order[second];
    Index c = order[third];
    if (kernel_.ccw(order[0], b, c) < 0) std::swap(b, c);
    insertion_ = std::make_unique<Insertion>(topology_, kernel_, hidden_by_, order[0], b, c);
    for (std::size_t k = 1; k < order.size(); ++k)
        if (k != second && k != third) insertion_->insert(order[k]);
    for (Index f = 0; f < topology_.faces(); ++f) {
        if (topology_.is_vacant(f)) continue;
        topology_.record(f).mark = 0;
        note_corners(f);
        for (HalfEdge h = Topology::first_edge(f); h < Topology::first_edge(f) + 3; ++h)
            if (h < topology_.twin(h)) pending_.push_back(h);
    }
    for (const Index i : order) {
        is_hidden_[at(i)] = hidden_by_[at(i)] >= 0;
        if (!is_hidden_[at(i)]) continue;
        home_[at(i)] = face_of_[at(triangulation::end_of_chain(hidden_by_, i))];
        homeless_.push_back(i);
    }
    if (!settle()) throw BrokenStructure("a triangulation of moving sites is not regular");
}

/// Law 5.
void MovingTriangulation::build_line(std::vector<Index> along) {
    triangulation::sort_along(kernel_, along);
    line_ = triangulation::visible_in_order(kernel_, along, hidden_by_);
    for (const Index i : along) is_hidden_[at(i)] = true;
    for (const Index i : line_) is_hidden_[at(i)] = false;
    if (line_.size() < 2) return;

    // What is to stay: who follows whom, who is above the chord of his neighbours, and who below.
    const bool along_x = kernel_.beyond(line_.back(), line_.front(), true) != 0;
    Queue::Subject number = 0;
    const auto take = [&](const Certificate& certificate) {
        const auto ahead = moment_.ahead(sites_, certificate, &tally_);
        if (ahead && ahead->root) queue_.set(number++, {*ahead->root, certificate});
        return ahead.has_value();
    };
    for (std::size_t k = 1; k < along.size(); ++k)
        static_cast<void>(
            take({{along[k], along[k - 1], along[k], along[k]}, Kind::beyond, along_x}));
    for (std::size_t k = 0, stretch = 0; k < along.size(); ++k) {
        while (stretch + 1 < line_.size() && !is_hidden_[at(along[k])] &&
               line_[stretch] != along[k])
            ++stretch;
        if (!is_hidden_[at(along[k])]) {
            if (stretch > 0 && stretch + 1 < line_.size())
                certify_in_segment(sites_, line_[stretch - 1], line_[stretch + 1], along[k],
                                   along_x, take);
        } else if (stretch + 1 < line_.size()) {
            certify_in_segment(sites_, line_[stretch], line_[stretch + 1], along[k], along_x, take);
        }
    }
}

}  // namespace signum::kinetic
