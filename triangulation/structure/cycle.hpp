#pragma once
/// A cycle as a range: first, next(first), next(next(first)), … until first comes again.

#include <iterator>
#include <utility>

namespace signum::triangulation {

/// For a range-for, which compiles to the do-while loop that one would write by hand. Precondition:
/// going on from the first place leads back to it.
template <class Place, class Next>
class Cycle {
 public:
    class Iterator {
     public:
        Iterator(Place first, const Next& next) : first_(first), place_(first), next_(next) {}
        [[nodiscard]] const Place& operator*() const noexcept { return place_; }
        Iterator& operator++() {
            place_ = next_(place_);
            is_under_way_ = true;
            return *this;
        }
        [[nodiscard]] bool operator==(std::default_sentinel_t) const {
            return is_under_way_ && place_ == first_;
        }

     private:
        Place first_;
        Place place_;
        Next next_;
        bool is_under_way_ = false;
    };

    Cycle(Place first, Next next) : first_(first), next_(std::move(next)) {}
    [[nodiscard]] Iterator begin() const { return {first_, next_}; }
    [[nodiscard]] std::default_sentinel_t end() const noexcept { return {}; }

 private:
    Place first_;
    Next next_;
};

}  // namespace signum::triangulation
