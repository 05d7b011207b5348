#pragma once
/// Contacts that are told in IEEE 754's environment, whatever that of who asks. For sources only.

#include <utility>

#include "../exact/floating_environment.hpp"
#include "contacts.hpp"

namespace signum {

[[nodiscard]] inline Contacts in_any_environment(Contacts contacts) {
    return [contacts = std::move(contacts)](Index i, Index j) {
        const exact::IeeeEnvironment environment;
        return contacts(i, j);
    };
}

}  // namespace signum
