#pragma once
/// HDF5 by all ranks together: files, arrays of two axes and slices of their rows.

#include <hdf5.h>
#include <mpi.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>

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
[[nodiscard]] inline Handle collective_transfer() {
    Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
    H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
    return transfer;
}

}  // namespace signum::mpi
