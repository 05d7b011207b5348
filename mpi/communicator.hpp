#pragma once
/// MPI, as far as it is used here: arrays of plain values between the ranks of a communicator.
///
/// Law: every call is collective. What fails on a rank within together() is an exception there, and
/// OtherFailed on all others at their next call. Lack of memory may come in the middle of a call,
/// where the others cannot be told: within together() it ends all ranks.

#include <mpi.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace signum::mpi {

/// Another rank has failed, and says why.
class OtherFailed : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

class Communicator {
 public:
    /// Communicates beside what the program says over the same ranks. Collective.
    explicit Communicator(MPI_Comm other) {
        MPI_Comm_dup(other, &comm_);
        MPI_Comm_rank(comm_, &rank_);
        MPI_Comm_size(comm_, &size_);
    }
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;
    ~Communicator() { MPI_Comm_free(&comm_); }

    [[nodiscard]] MPI_Comm get() const noexcept { return comm_; }
    [[nodiscard]] std::size_t rank() const noexcept { return static_cast<std::size_t>(rank_); }
    [[nodiscard]] std::size_t size() const noexcept { return static_cast<std::size_t>(size_); }
    /// How many bytes this rank has sent to others.
    [[nodiscard]] std::uint64_t sent() const noexcept { return sent_; }
    /// The processor time spent in MPI, most of it waiting.
    [[nodiscard]] double seconds() const noexcept { return seconds_; }
    /// Whether a failure is known to all ranks.
    [[nodiscard]] bool has_failed() const noexcept { return has_failed_; }

    /// Work of one rank, and its failures those of all: throws what it threw here, and OtherFailed
    /// elsewhere.
    template <class Work>
    void together(const Work& work) {
        try {
            work();
        } catch (const std::bad_alloc&) {
            give_up("not enough memory; take more ranks, on more machines");
        } catch (const std::length_error&) {
            give_up("more than a rank can send or hold; take more ranks");
        } catch (...) {
            if (!has_failed_) static_cast<void>(gate(true));
            throw;
        }
        pass();
    }

    [[nodiscard]] std::int64_t sum(std::int64_t own) { return reduced(own, MPI_INT64_T, MPI_SUM); }
    [[nodiscard]] std::int64_t most(std::int64_t own) { return reduced(own, MPI_INT64_T, MPI_MAX); }
    /// The sum over the ranks before this one.
    [[nodiscard]] std::int64_t sum_before(std::int64_t own) {
        pass();
        std::int64_t result = 0;
        timed([&] { MPI_Exscan(&own, &result, 1, MPI_INT64_T, MPI_SUM, comm_); });
        return rank_ == 0 ? 0 : result;
    }
    /// What each rank has, rank by rank.
    template <class T>
    [[nodiscard]] std::vector<T> all_of(std::span<const T> own) {
        pass();
        const std::vector<int> counts = gathered(counted(own.size()));
        const std::vector<int> begins = begins_of(counts);
        std::vector<T> all(total(counts));
        const Type<T> type;
        timed([&] {
            MPI_Allgatherv(own.data(), counted(own.size()), type.get(), all.data(), counts.data(),
                           begins.data(), type.get(), comm_);
        });
        sent_ += own.size() * sizeof(T) * (size() - 1);
        return all;
    }
    /// To each rank a list; from each rank one.
    template <class T>
    [[nodiscard]] std::vector<std::vector<T>> exchanged(const std::vector<std::vector<T>>& lists) {
        std::vector<T> sending;
        std::vector<int> to(size());
        for (std::size_t r = 0; r < size(); ++r) {
            to[r] = counted(lists[r].size());
            sending.insert(sending.end(), lists[r].begin(), lists[r].end());
        }
        std::vector<int> begins;
        const std::vector<T> coming = carried(std::move(sending), to, begins);
        std::vector<std::vector<T>> result(size());
        for (std::size_t r = 0; r < size(); ++r)
            result[r].assign(coming.begin() + begins[r], coming.begin() + begins[r + 1]);
        return result;
    }
    /// To each rank the items of which rank_of(item) names it; what comes, rank after rank. Takes
    /// the items.
    template <class T, class RankOf>
    [[nodiscard]] std::vector<T> dealt(std::vector<T>& items, const RankOf& rank_of) {
        std::vector<int> to(size());
        for (const T& each : items) ++to[rank_of(each)];
        std::vector<int> next = begins_of(to);
        std::vector<T> sending(items.size());
        for (const T& each : items) sending[static_cast<std::size_t>(next[rank_of(each)]++)] = each;
        items = {};
        return carried(std::move(sending), to, next);
    }

 private:
    /// A value as so many bytes.
    template <class T>
    class Type {
        static_assert(std::is_trivially_copyable_v<T>);

     public:
        Type() {
            MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &type_);
            MPI_Type_commit(&type_);
        }
        Type(const Type&) = delete;
        Type& operator=(const Type&) = delete;
        ~Type() { MPI_Type_free(&type_); }
        [[nodiscard]] MPI_Datatype get() const noexcept { return type_; }

     private:
        MPI_Datatype type_;
    };

    /// `begins` becomes where what came from each rank begins, and the end.
    template <class T>
    [[nodiscard]] std::vector<T> carried(std::vector<T> sending, const std::vector<int>& to,
                                         std::vector<int>& begins) {
        pass();
        sent_ += (sending.size() - static_cast<std::size_t>(to[rank()])) * sizeof(T);
        std::vector<int> from(size());
        timed([&] { MPI_Alltoall(to.data(), 1, MPI_INT, from.data(), 1, MPI_INT, comm_); });
        begins = begins_of(from);
        begins.push_back(counted(total(from)));
        // There is nobody else.
        if (size() == 1) return sending;
        const std::vector<int> to_begins = begins_of(to);
        std::vector<T> coming(total(from));
        const Type<T> type;
        timed([&] {
            MPI_Alltoallv(sending.data(), to.data(), to_begins.data(), type.get(), coming.data(),
                          from.data(), begins.data(), type.get(), comm_);
        });
        return coming;
    }
    /// What can happen between two calls that all ranks make, and in the middle of one, ends all.
    [[noreturn]] void give_up(const char* why) const noexcept {
        std::fprintf(stderr, "signum-mpi: rank %d: %s\n", rank_, why);
        MPI_Abort(comm_, 3);
        std::abort();
    }
    [[nodiscard]] bool gate(bool has_failed) {
        const int own = has_failed ? 1 : 0;
        int any = 0;
        timed([&] { MPI_Allreduce(&own, &any, 1, MPI_INT, MPI_MAX, comm_); });
        has_failed_ = any != 0;
        return has_failed_;
    }
    template <class Call>
    void timed(const Call& call) {
        const std::clock_t start = std::clock();
        call();
        seconds_ += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    void pass() {
        if (gate(false)) throw OtherFailed("another rank has failed");
    }
    [[nodiscard]] std::int64_t reduced(std::int64_t own, MPI_Datatype type, MPI_Op operation) {
        pass();
        std::int64_t result = 0;
        timed([&] { MPI_Allreduce(&own, &result, 1, type, operation, comm_); });
        return result;
    }
    [[nodiscard]] std::vector<int> gathered(int own) {
        std::vector<int> all(size());
        timed([&] { MPI_Allgather(&own, 1, MPI_INT, all.data(), 1, MPI_INT, comm_); });
        return all;
    }
    /// MPI counts in int. Values beyond it would be beyond what a rank holds.
    [[nodiscard]] static int counted(std::size_t size) {
        if (size > std::size_t{0x7FFFFFFF}) throw std::length_error("too much for one message");
        return static_cast<int>(size);
    }
    [[nodiscard]] static std::vector<int> begins_of(const std::vector<int>& counts) {
        std::vector<int> begins(counts.size());
        std::int64_t sum = 0;
        for (std::size_t r = 0; r < counts.size(); ++r) {
            begins[r] = counted(static_cast<std::size_t>(sum));
            sum += counts[r];
        }
        return begins;
    }
    [[nodiscard]] static std::size_t total(const std::vector<int>& counts) {
        return static_cast<std::size_t>(
            std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
    }

    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0;
    int size_ = 1;
    std::uint64_t sent_ = 0;
    double seconds_ = 0.0;
    bool has_failed_ = false;
};

}  // namespace signum::mpi
