#pragma once
/// Questions between parts of one process, whose sites lie in memory, or in a file that is mapped.

#include <cstddef>
#include <span>
#include <vector>

#include "exchange.hpp"
#include "site_store.hpp"

namespace signum::distributed {

/// Parts whose sites can all be looked at.
class SharedExchange final : public Exchange {
 public:
    /// Nothing is copied.
    explicit SharedExchange(std::span<const SiteStore> stores) : stores_(stores) {}
    [[nodiscard]] std::vector<Answers> ask(std::vector<Questions> questions) override {
        std::vector<Answers> answers(questions.size());
        for (std::size_t q = 0; q < questions.size(); ++q)
            if (!questions[q].are_none()) answers[q] = stores_[q].answer(questions[q]);
        return answers;
    }
    [[nodiscard]] bool is_for_any(bool own) override { return own; }

 private:
    std::span<const SiteStore> stores_;
};

}  // namespace signum::distributed
