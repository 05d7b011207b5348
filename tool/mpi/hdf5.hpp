#pragma once
/// HDF5 by all ranks together: files, arrays of two axes and slices of their rows.

#include <hdf5.h>
#include <mpi.h>

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../../mpi/communicator.hpp"
#include "../io/errors.hpp"

namespace signum::mpi {

/// What HDF5 knows by a number, and how it is closed.
class Handle {
 public:
    Handle(hid_t id, herr_t (*close)(hid_t)) noexcept : id_(id), close_(close) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle& operator=(Handle&&) = delete;
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    [[nodiscard]] bool is_there() const noexcept { return id_ >= 0; }
    // NOLINTNEXTLINE(google-explicit-constructor): for HDF5's own functions
    operator hid_t() const noexcept { return id_; }

 private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// Access by all ranks of a communicator.
[[nodiscard]] inline Handle access_by(MPI_Comm comm) {
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_fapl_mpio(access, comm, MPI_INFO_NULL);
    return access;
}

/// The rows that a rank reads of so many: the first one, and how many.
[[nodiscard]] inline std::pair<std::uint64_t, std::uint64_t> share_of(const Communicator& ranks,
                                                                      std::uint64_t rows) {
    const auto begin = [&](std::uint64_t k) {
        return static_cast<std::uint64_t>(static_cast<unsigned __int128>(rows) * k / ranks.size());
    };
    return {begin(ranks.rank()), begin(ranks.rank() + 1) - begin(ranks.rank())};
}

/// An array that is read. Throws InputError.
class Dataset {
 public:
    Dataset(const std::string& file, const Handle& opened, const std::string& path)
        : name_(file + ":" + path), set_(H5Dopen2(opened, path.c_str(), H5P_DEFAULT), H5Dclose) {
        if (!set_.is_there())
            throw InputError(file, fmt::format("there is no array {} in it", path));
        const Handle space(H5Dget_space(set_), H5Sclose);
        axes_ = H5Sget_simple_extent_ndims(space);
        if (axes_ < 1 || axes_ > 2)
            throw InputError(name_, fmt::format("an array of {} axes; sites are rows", axes_));
        H5Sget_simple_extent_dims(space, shape_.data(), nullptr);
    }
    [[nodiscard]] std::uint64_t rows() const noexcept { return shape_[0]; }
    [[nodiscard]] std::uint64_t columns() const noexcept { return axes_ == 1 ? 1 : shape_[1]; }
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// Some of its rows, as doubles or as 64-bit integers. By each rank for itself: in a call of
    /// all, one that cannot read would leave the others waiting.
    template <class Number>
    [[nodiscard]] std::vector<Number> read(std::uint64_t first, std::uint64_t count) const {
        constexpr bool are_doubles = std::is_same_v<Number, double>;
        const Handle stored(H5Dget_type(set_), H5Tclose);
        const H5T_class_t kind = H5Tget_class(stored);
        if (kind != H5T_INTEGER && !(are_doubles && kind == H5T_FLOAT))
            throw InputError(name_, are_doubles ? "it holds no numbers" : "it holds no integers");
        if (count == 0) return {};
        const Handle space(H5Dget_space(set_), H5Sclose);
        const std::array<hsize_t, 2> begin = {first, 0};
        const std::array<hsize_t, 2> extent = {count, columns()};
        std::vector<Number> numbers(count * columns());
        const Handle memory(H5Screate_simple(axes_, extent.data(), nullptr), H5Sclose);
        H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, extent.data(), nullptr);
        const hid_t type = are_doubles ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64;
        if (H5Dread(set_, type, memory, space, H5P_DEFAULT, numbers.data()) < 0)
            throw InputError(name_, "it cannot be read as numbers");
        return numbers;
    }

 private:
    std::string name_;
    Handle set_;
    int axes_ = 0;
    std::array<hsize_t, 2> shape_ = {0, 0};
};

}  // namespace signum::mpi
