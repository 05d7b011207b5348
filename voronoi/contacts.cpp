#include "contacts.hpp"

#include <stdexcept>

namespace signum {

Canonical::Canonical(const Tessellation& tessellation)
    : tessellation_(tessellation),
      face_at_(tessellation.sites().size(), -1),
      degree_(tessellation.sites().size(), 0),
      hidden_by_(tessellation.sites().size(), -1) {
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
    switch (canonical.tessellation().metric()) {
        case Metric::power:
            return power_contacts(canonical);
        case Metric::euclidean:
            return euclidean_contacts(canonical);
        case Metric::manhattan:
        case Metric::supremum:
            return rectangular_contacts(canonical);
    }
    throw std::invalid_argument("no such metric");
}

}  // namespace signum
