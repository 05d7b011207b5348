#pragma once
/// MPI, as far as it is used here: arrays of plain values between the ranks of a communicator.
///
/// Law: every call is collective. A rank that fails between two of them says so at the next one,
/// and all others throw there.

#include <mpi.h>

#include <cstdint>
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

    /// Work of one rank, and its failures those of all: throws what it threw here, and OtherFailed
    /// elsewhere.
    template <class Work>
    void together(const Work& work) {
        try {
            work();
        } catch (const OtherFailed&) {
            throw;
        } catch (...) {
            static_cast<void>(gate(true));
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
        MPI_Exscan(&own, &result, 1, MPI_INT64_T, MPI_SUM, comm_);
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
        MPI_Allgatherv(own.data(), counted(own.size()), type.get(), all.data(), counts.data(),
                       begins.data(), type.get(), comm_);
        sent_ += own.size() * sizeof(T) * (size() - 1);
        return all;
    }
    /// To each rank a list; from each rank one.
    template <class T>
    [[nodiscard]] std::vector<std::vector<T>> exchanged(const std::vector<std::vector<T>>& lists) {
        pass();
        std::vector<int> to(size());
        std::vector<int> from(size());
        std::vector<T> sending;
        for (std::size_t r = 0; r < size(); ++r) {
            to[r] = counted(lists[r].size());
            sending.insert(sending.end(), lists[r].begin(), lists[r].end());
            if (r != rank()) sent_ += lists[r].size() * sizeof(T);
        }
        MPI_Alltoall(to.data(), 1, MPI_INT, from.data(), 1, MPI_INT, comm_);
        const std::vector<int> to_begins = begins_of(to);
        const std::vector<int> from_begins = begins_of(from);
        std::vector<T> coming(total(from));
        const Type<T> type;
        MPI_Alltoallv(sending.data(), to.data(), to_begins.data(), type.get(), coming.data(),
                      from.data(), from_begins.data(), type.get(), comm_);
        std::vector<std::vector<T>> result(size());
        for (std::size_t r = 0; r < size(); ++r)
            result[r].assign(coming.begin() + from_begins[r],
                             coming.begin() + from_begins[r] + from[r]);
        return result;
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

    [[nodiscard]] bool gate(bool has_failed) {
        const int own = has_failed ? 1 : 0;
        int any = 0;
        MPI_Allreduce(&own, &any, 1, MPI_INT, MPI_MAX, comm_);
        return any != 0;
    }
    void pass() {
        if (gate(false)) throw OtherFailed("another rank has failed");
    }
    [[nodiscard]] std::int64_t reduced(std::int64_t own, MPI_Datatype type, MPI_Op operation) {
        pass();
        std::int64_t result = 0;
        MPI_Allreduce(&own, &result, 1, type, operation, comm_);
        return result;
    }
    [[nodiscard]] std::vector<int> gathered(int own) {
        std::vector<int> all(size());
        MPI_Allgather(&own, 1, MPI_INT, all.data(), 1, MPI_INT, comm_);
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
        return static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
    }

    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0;
    int size_ = 1;
    std::uint64_t sent_ = 0;
};

}  // namespace signum::mpi
