#include "moment.hpp"

#include <algorithm>
#include <span>

namespace signum::kinetic {
namespace {

std::size_t sites_of(Certificate::Kind kind) {
    return kind == Certificate::Kind::outside ? 4 : 3;
}

}  // namespace

Sign relation(const Certificate& a, const Certificate& b) noexcept {
    if (a.kind != b.kind || a.along_x != b.along_x) return 0;
    // Nearly all have other sites.
    const auto sum = [](const Certificate& c) {
        return c.sites[0] + c.sites[1] + c.sites[2] +
               (c.kind == Certificate::Kind::outside ? c.sites[3] : 0);
    };
    if (sum(a) != sum(b)) return 0;
    if (a.kind != Certificate::Kind::outside && a.kind != Certificate::Kind::left_turn)
        return a.sites == b.sites ? 1 : 0;
    // Determinants: every exchange of two sites changes the sign.
    const std::size_t n = sites_of(a.kind);
    std::array<Index, 4> from = b.sites;
    Sign sign = 1;
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t there = k;
        while (there < n && from[there] != a.sites[k]) ++there;
        if (there == n) return 0;
        if (there != k) {
            std::swap(from[k], from[there]);
            sign = -sign;
        }
    }
    return sign;
}

Sign compare_overlapping(const Sites& sites, const Event& a, const Event& b, roots::Tally* tally) {
    const CertificateForm form(a.certificate, sites);
    const roots::Polynomial p(form, near(a.root));
    const Sign same = relation(a.certificate, b.certificate);
    if (same != 0)
        return roots::compare({p, a.root}, {p, same > 0 ? b.root : b.root.of_negative()}, tally);
    const CertificateForm other_form(b.certificate, sites);
    const roots::Polynomial q(other_form, near(b.root));
    return roots::compare({p, a.root}, {q, b.root}, tally);
}

Sign compare(const Sites& sites, const Event& a, double t, roots::Tally* tally) {
    if (a.root.high < t) return -1;
    if (t < a.root.low) return 1;
    const CertificateForm form(a.certificate, sites);
    const roots::Polynomial p(form, near(a.root));
    return roots::compare({p, a.root}, t, tally);
}

Sign Moment::compare(const Sites& sites, const Event& event, roots::Tally* tally) const {
    if (is_double()) return kinetic::compare(sites, event, time_, tally);
    if (event.root.high < event_.root.low) return -1;
    if (event_.root.high < event.root.low) return 1;
    const Sign same = relation_to(event.certificate);
    if (same != 0)
        return roots::compare({*polynomial_, same > 0 ? event.root : event.root.of_negative()},
                              root(), tally);
    const CertificateForm form(event.certificate, sites);
    const roots::Polynomial p(form, near(event.root));
    return roots::compare({p, event.root}, root(), tally);
}

filters::Verdict Moment::turn(const Sites& sites, const Certificate& certificate,
                              roots::Tally* tally) const {
    if (certificate.kind != Certificate::Kind::left_turn) return filters::Verdict::uncertain();
    const auto& [a, b, c, rest] = certificate.sites;
    const auto verdict = bounded_turn(sites[a], sites[b], sites[c], {sites.fall, time_}, radius_);
    if (verdict.is_certain() && tally != nullptr) ++tally->filtered;
    return verdict;
}

Sign Moment::sign_after(const Sites& sites, const Certificate& certificate,
                        roots::Tally* tally) const {
    if (const Sign own = own_sign(certificate); own != 0) return own;
    if (const auto verdict = turn(sites, certificate, tally); verdict.is_certain())
        return verdict.sign();
    const CertificateForm form(certificate, sites);
    const roots::Polynomial p(form, time_);
    return is_double() ? p.sign_after(time_, tally) : p.sign_after(root(), tally);
}

Sign Moment::sign_then(const Sites& sites, const Certificate& certificate,
                       roots::Tally* tally) const {
    if (relation_to(certificate) != 0) return 0;
    if (const auto verdict = turn(sites, certificate, tally); verdict.is_certain())
        return verdict.sign();
    const CertificateForm form(certificate, sites);
    const roots::Polynomial p(form, time_);
    return is_double() ? p.sign_at(time_, tally) : p.sign_at(root(), tally);
}

std::optional<Moment::Ahead> Moment::ahead(const Sites& sites, const Certificate& certificate,
                                           roots::Tally* tally) const {
    Ahead result;
    const Sign same = relation_to(certificate);
    if (same != 0) {
        result.sign = same * event_.root.after;
        result.root = polynomial_->first_root(root(), tally);
        if (result.root && same < 0) result.root = result.root->of_negative();
        return result;
    }
    const CertificateForm form(certificate, sites);
    const roots::Polynomial p(form, time_);
    result.root = is_double() ? p.first_root(time_, tally) : p.first_root(root(), tally);
    // From the moment to the root the sign does not change.
    if (result.root) {
        result.sign = result.root->before();
    } else {
        result.sign = is_double() ? p.sign_after(time_, tally) : p.sign_after(root(), tally);
    }
    if (result.sign == 0) return std::nullopt;
    return result;
}

}  // namespace signum::kinetic
