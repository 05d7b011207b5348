#include "of_metric.hpp"

namespace signum {

Canonical::Canonical(const Tessellation& tessellation)
    : tessellation_(tessellation),
      face_at_(tessellation.sites().size(), -1),
      degree_(tessellation.sites().size(), 0),
      hidden_by_(tessellation.sites().size(), -1) {
    tessellation.expect_neighbours();
    const auto faces = tessellation.faces();
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const Index v : faces[f]) {
            if (v == infinite) continue;
            face_at_[static_cast<std::size_t>(v)] = static_cast<Index>(f);
            ++degree_[static_cast<std::size_t>(v)];
        }
    for (const Hidden& hidden : tessellation.hidden())
        hidden_by_[static_cast<std::size_t>(hidden.site)] = hidden.by;
}

Contacts contacts_of(const Canonical& canonical) {
    return contacts_in(canonical.tessellation().metric(), canonical);
}

Contacts contacts_in(Metric metric, const Canonical& canonical) {
    return with_metric(metric, [&]<class M>(M) { return contacts_in<M>(canonical); });
}

}  // namespace signum
