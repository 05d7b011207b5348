#pragma once
/// Right after which time a triangulation of moving sites stands. For sources only.

#include <limits>
#include <optional>

#include "../../core/sign.hpp"
#include "../../roots/polynomial.hpp"
#include "certificate.hpp"

namespace signum::kinetic {

/// A double not far from a root.
[[nodiscard]] inline double near(const roots::Root& root) noexcept {
    return root.low >= -std::numeric_limits<double>::max() ? root.low : root.high;
}

/// That a certificate becomes 0. Another one of the same sites has the same polynomial, or the
/// opposite one.
struct Event {
    roots::Root root;
    Certificate certificate;
};

/// 1 where two certificates have one polynomial, -1 where theirs differ by their signs, and
/// otherwise 0.
[[nodiscard]] Sign relation(const Certificate& a, const Certificate& b) noexcept;

/// The sign of a - b where their intervals overlap.
[[nodiscard]] Sign compare_overlapping(const Sites& sites, const Event& a, const Event& b,
                                       roots::Tally* tally);
/// The sign of a - b.
[[nodiscard]] inline Sign compare(const Sites& sites, const Event& a, const Event& b,
                                  roots::Tally* tally) {
    if (a.root.high < b.root.low) return -1;
    if (b.root.high < a.root.low) return 1;
    return compare_overlapping(sites, a, b, tally);
}
[[nodiscard]] Sign compare(const Sites& sites, const Event& a, double t, roots::Tally* tally);

/// A double, or the time of an event, with sites as they were when it was set.
class Moment {
 public:
    explicit Moment(double t) : time_(t) {}
    Moment(const Moment&) = delete;
    Moment& operator=(const Moment&) = delete;

    void set(double t) {
        polynomial_.reset();
        is_current_ = false;
        time_ = t;
        radius_ = 0.0;
    }
    void set(const Sites& sites, const Event& event) {
        if (event.root.is_double()) return set(event.root.low);
        polynomial_.reset();
        form_.emplace(event.certificate, sites);
        for (std::size_t k = 0; k < 4; ++k) {
            sites_[k] = *form_->sites[k];
            form_->sites[k] = &sites_[k];
        }
        polynomial_.emplace(*form_, near(event.root));
        event_ = event;
        time_ = near(event.root);
        radius_ = event.root.high - event.root.low;
        is_current_ = true;
    }
    /// One of the sites has become another one; the time stays.
    void sites_have_changed() noexcept { is_current_ = false; }
    [[nodiscard]] bool is_double() const noexcept { return !polynomial_; }
    /// The double, or one not far from the event.
    [[nodiscard]] double time() const noexcept { return time_; }
    /// Precondition: not is_double().
    [[nodiscard]] roots::RootOf root() const { return {*polynomial_, event_.root}; }

    /// Whether a certificate has the event's polynomial; 0 where that cannot be told at once.
    [[nodiscard]] Sign relation_to(const Certificate& certificate) const noexcept {
        return is_current_ ? relation(certificate, event_.certificate) : 0;
    }

    /// The sign of a certificate right after the time where it has the event's polynomial; 0 where
    /// that cannot be told at once.
    [[nodiscard]] Sign own_sign(const Certificate& certificate) const noexcept {
        return relation_to(certificate) * event_.root.after;
    }

    /// The sign of the event's time less the moment's.
    [[nodiscard]] Sign compare(const Sites& sites, const Event& event, roots::Tally* tally) const;

    /// The sign of a certificate right after the time: 0 where it is 0 for ever.
    [[nodiscard]] Sign sign_after(const Sites& sites, const Certificate& certificate,
                                  roots::Tally* tally) const;
    /// At the time itself.
    [[nodiscard]] Sign sign_then(const Sites& sites, const Certificate& certificate,
                                 roots::Tally* tally) const;

    /// The sign of a certificate right after, and its first root from then on.
    struct Ahead {
        Sign sign = 0;
        std::optional<roots::Root> root;
    };
    /// Nothing where it is 0 for ever.
    [[nodiscard]] std::optional<Ahead> ahead(const Sites& sites, const Certificate& certificate,
                                             roots::Tally* tally) const;

 private:
    /// Where three sites turn the same way at all times near this one, for certain.
    [[nodiscard]] filters::Verdict turn(const Sites& sites, const Certificate& certificate,
                                        roots::Tally* tally) const;

    double time_;
    double radius_ = 0.0;  ///< the event is no farther from the time
    bool is_current_ = false;
    Event event_{};
    std::array<MovingSite, 4> sites_;
    std::optional<CertificateForm> form_;
    std::optional<roots::Polynomial> polynomial_;
};

}  // namespace signum::kinetic
