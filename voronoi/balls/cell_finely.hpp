#pragma once
/// The cell of a ball where patches are divided finely. Part of cell.hpp, which includes it.

namespace signum::balls {

template <class Leaf>
[[gnu::noinline]] bool CellSearch::divide_finely(const Patch& patch, const std::vector<Slot>& list,
                                                 int steady, const Leaf& leaf) {
    if (patch.line != nullptr || failures_ >= most_failures) return false;
    const Seen* best = nullptr;
    for (const Slot slot : list)
        if (const Seen& q = seen_[slot];
            !q.is_wild && (best == nullptr || value(q, patch) > value(*best, patch)))
            best = &q;
    Point3 axis;
    double longest = 0.0;
    for (const Slot slot : list) {
        if (seen_[slot].is_wild) continue;
        const Point3 a = minus(seen_[slot].a, best->a);
        if (!(dot(a, a) > longest)) continue;
        longest = dot(a, a);
        axis = a;
    }
    if (!(longest > 0x1p-900 && longest < 0x1p900)) return false;
    const bool is_line = are_on_a_line(list, axis);
    if (!is_line && (steady < least_steady_of_charts || !(patch.delta < 0.125))) return false;
    const Frame frame(is_line ? axis : patch.v, is_line ? patch.v : axis);
    forms_.clear();
    slots_of_forms_.clear();
    wild_.clear();
    for (const Slot slot : list) {
        if (seen_[slot].is_wild) {
            wild_.push_back(slot);
            continue;
        }
        const std::optional<FineForm> f = fine_form(tree_.ball(ball_), tree_.ball(places_[slot]));
        if (!f) return false;
        forms_.push_back(frame.of(*f));
        slots_of_forms_.push_back(slot);
    }
    members_.resize(most_depth_of_halvings + 1);
    members_[0].clear();
    for (std::uint32_t number = 0; number < forms_.size(); ++number)
        members_[0].push_back({number, {}});
    halvings_left_ = most_halvings;
    if (is_line)
        halve(Band(patch.v, patch.delta, frame), 0, leaf);
    else
        halve(Chart(patch.v, patch.delta, frame), 0, leaf);
    if (halvings_left_ > 0) return true;
    ++failures_;
    return false;
}

inline bool CellSearch::are_on_a_line(const std::vector<Slot>& list, const Point3& axis) {
    constexpr double most_off = 0x1p-12;  // a square
    const double length = dot(axis, axis);
    sorted_.clear();
    for (const Slot slot : list) {
        const Seen& q = seen_[slot];
        if (!q.is_wild) sorted_.emplace_back(dot(q.a, axis), slot);
    }
    std::sort(sorted_.begin(), sorted_.end());
    std::size_t off = 0;
    for (std::size_t k = 1; k < sorted_.size(); ++k) {
        const Point3 a = minus(seen_[sorted_[k].second].a, seen_[sorted_[k - 1].second].a);
        const double along = dot(a, axis), square = dot(a, a);
        off += !(square - along * along / length <= most_off * square);
    }
    return 4 * off <= sorted_.size();
}

template <class Region, class Leaf>
[[gnu::noinline]] void CellSearch::halve(const Region& region, std::size_t depth,
                                         const Leaf& leaf) {
    if (--halvings_left_ <= 0) return;
    std::vector<Member>& list = members_[depth];
    double f_least = 0.0;
    std::erase_if(list, [&](Member& m) {
        const FineForm& f = forms_[m.number];
        m.value = region.value(f);
        const double slack = 0x1p-50 * std::fabs(m.value.high) +
                             bound(region, f.x.high, f.y.high, f.z.high, f.b.high, f.error);
        f_least = std::max(f_least, m.value.high - slack);
        return m.value.high + slack < 0.0;
    });
    const bool is_open = !(f_least > 0.0);
    take_out_less(list, region);
    std::size_t later = 0, of_other_kinds = 0;
    const auto count = [&](Slot slot) {
        later += seen_[slot].is_later;
        of_other_kinds += seen_[slot].is_later && !seen_[slot].is_of_its_kind;
    };
    for (const Member& m : list) count(slots_of_forms_[m.number]);
    for (const Slot slot : wild_) count(slot);
    if (list.size() > most_in_a_list && later >= 3 && of_other_kinds > 0 &&
        depth < most_depth_of_halvings) {
        const FineForm& first = forms_[list.front().number];
        Spread spread;
        double error = 0.0;
        for (const Member& m : list) {
            const FineForm& f = forms_[m.number];
            spread.take(difference(f.x, first.x), difference(f.y, first.y),
                        difference(f.z, first.z), difference(f.b, first.b));
            error = std::max(error, f.error);
        }
        // What no halves take away need not be half of all.
        auto [in_first, in_second, rest] = region.parts_of_change(spread);
        rest += error;
        for (const int interval : {0, 1}) {
            double& part = interval == 0 ? in_first : in_second;
            if (!region.has_halves(interval)) rest += std::exchange(part, 0.0);
        }
        if (in_first + in_second > rest) {
            for (const int number : {0, 1}) {
                members_[depth + 1] = members_[depth];
                halve(region.half(in_first >= in_second ? 0 : 1, number), depth + 1, leaf);
            }
            return;
        }
    }
    fine_list_ = wild_;
    for (const Member& m : list) fine_list_.push_back(slots_of_forms_[m.number]);
    finish(fine_list_, is_open, later, of_other_kinds, leaf);
}

template <class Region>
[[gnu::noinline]] void CellSearch::take_out_less(std::vector<Member>& list, const Region& region) {
    if (list.size() < 2) return;
    const auto is_greater = [](const Member& a, const Member& b) {
        return a.value.high != b.value.high ? a.value.high > b.value.high
               : a.value.low != b.value.low ? a.value.low > b.value.low
                                            : a.number < b.number;
    };
    const Member top = *std::ranges::min_element(list, is_greater);
    const FineForm& first = forms_[top.number];
    std::array<Member, 9> greatest;
    greatest.fill(top);
    std::array<double, 9> values;
    values.fill(-HUGE_VAL);
    for (const Member& m : list) {
        const FineForm& f = forms_[m.number];
        const double middle = difference(m.value, top.value);
        const auto [in_first, in_second] =
            region.rise(difference(f.x, first.x), difference(f.y, first.y),
                        difference(f.z, first.z), difference(f.b, first.b));
        for (std::size_t k = 0; k < 9; ++k) {
            const double there = middle + (static_cast<double>(k % 3) - 1.0) * in_first +
                                 (static_cast<double>(k / 3) - 1.0) * in_second;
            if (!(there > values[k])) continue;
            values[k] = there;
            greatest[k] = m;
        }
    }
    std::erase_if(list, [&](const Member& m) {
        return std::ranges::any_of(greatest,
                                   [&](const Member& j) { return is_less(m, j, region); });
    });
    std::ranges::sort(list, is_greater);
    if (list.size() > most_in_pairs) return;
    std::size_t kept = 0;
    for (const Member& m : list) {
        const std::span<const Member> greater(list.data(), kept);
        if (!std::ranges::any_of(greater, [&](const Member& j) { return is_less(m, j, region); }))
            list[kept++] = m;
    }
    list.resize(kept);
}

}  // namespace signum::balls
