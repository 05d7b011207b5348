#pragma once
/// Sites at the ranks that own their places, and what these ask one another. For sources only.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "../core/insertion_rounds.hpp"
#include "../triangulation/distributed/cuts.hpp"
#include "../triangulation/distributed/exchange.hpp"
#include "../triangulation/distributed/site_store.hpp"
#include "communicator.hpp"

namespace signum::mpi {

using distributed::Answers;
using distributed::Cuts;
using distributed::Exchange;
using distributed::Kind;
using distributed::Placed;
using distributed::Questions;
using distributed::SiteStore;

/// Ranks that ask one another, all at the same time.
class RanksExchange final : public Exchange {
 public:
    RanksExchange(Communicator& ranks, const SiteStore& store) : ranks_(ranks), store_(store) {}

    [[nodiscard]] std::vector<Answers> ask(std::vector<Questions> questions) override {
        std::vector<Questions> coming(questions.size());
        carry(questions, coming, &Questions::boxes);
        carry(questions, coming, &Questions::faces);
        carry(questions, coming, &Questions::edges);
        carry(questions, coming, &Questions::hidden);
        std::vector<Answers> answers(questions.size());
        ranks_.together([&] {
            for (std::size_t r = 0; r < coming.size(); ++r)
                if (!coming[r].are_none()) answers[r] = store_.answer(coming[r]);
        });
        std::vector<Answers> result(questions.size());
        carry(answers, result, &Answers::sites);
        carry(answers, result, &Answers::nearest);
        return result;
    }
    [[nodiscard]] bool is_for_any(bool own) override { return ranks_.most(own ? 1 : 0) != 0; }

 private:
    template <class Message, class T>
    void carry(std::vector<Message>& to, std::vector<Message>& from,
               std::vector<T> Message::*member) {
        std::vector<std::vector<T>> lists;
        for (Message& each : to) lists.push_back(std::move(each.*member));
        std::vector<std::vector<T>> coming = ranks_.exchanged(lists);
        for (std::size_t r = 0; r < from.size(); ++r) from[r].*member = std::move(coming[r]);
    }

    Communicator& ranks_;
    const SiteStore& store_;
};

/// Of all sites so many, as they come by their numbers; all of them where they are few.
[[nodiscard]] inline std::vector<Placed> sampled(Communicator& ranks, std::span<const Placed> own,
                                                 std::int64_t whole, std::int64_t wanted) {
    const double share = static_cast<double>(wanted) / static_cast<double>(whole);
    std::vector<Placed> sample;
    for (const Placed& each : own)
        if (static_cast<double>(mix(static_cast<std::uint64_t>(each.id))) * 0x1p-64 < share)
            sample.push_back(each);
    sample = ranks.all_of<Placed>(sample);
    std::ranges::sort(sample, {}, &Placed::id);
    return sample;
}

struct OwnedSites {
    std::vector<Placed> sample;  ///< of all sites, on all ranks
    Cuts cuts;
    std::vector<Placed> sites;  ///< of this rank, along a curve
};

/// Each rank owns about as many. Collective.
[[nodiscard]] inline OwnedSites owned_by_place(Communicator& ranks, std::vector<Placed> sites,
                                               std::int64_t whole, const Kind& kind) {
    std::vector<Placed> sample = sampled(ranks, sites, whole, 65'536);
    std::vector<Point3> points;
    for (const Placed& each : sample) points.push_back(place_of(each));
    Cuts cuts(std::move(points), ranks.size());
    std::vector<Placed> own =
        ranks.dealt(sites, [&](const Placed& each) { return cuts.part_of(place_of(each)); });
    ranks.together([&] { order_along_curve(own, kind); });
    return {std::move(sample), std::move(cuts), std::move(own)};
}

}  // namespace signum::mpi
