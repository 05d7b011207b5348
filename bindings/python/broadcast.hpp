#pragma once
/// A function of rows, called for all rows of arrays of any shape, as NumPy's own functions are:
/// the last axis of an operand is a row, the others are matched from behind, and one of length 1
/// serves for all.

#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "../../core/strided_sites.hpp"
#include "arrays.hpp"
#include "watched.hpp"

namespace signum::python {

/// A row of an operand.
struct Row {
    const char* first;
    std::ptrdiff_t stride;
    int columns;

    /// 0 beyond its end: a radius that is not there.
    [[nodiscard]] double operator[](int k) const noexcept {
        return k < columns ? *reinterpret_cast<const double*>(first + k * stride) : 0.0;
    }
    [[nodiscard]] bool is_finite() const noexcept {
        for (int k = 0; k < columns; ++k)
            if (!((*this)[k] - (*this)[k] == 0.0)) return false;
        return true;
    }
};

/// What to call an operand, and how many numbers its rows may have.
struct Operand {
    std::string name;
    int least;
    int most;
};
/// Those whose names are letters.
template <std::size_t size>
[[nodiscard]] std::array<Operand, size - 1> operands(const char (&letters)[size], int least,
                                                     int most) {
    std::array<Operand, size - 1> result;
    for (std::size_t i = 0; i + 1 < size; ++i) result[i] = {{letters[i]}, least, most};
    return result;
}

template <std::size_t n>
class Broadcast {
 public:
    /// Throws ValueError where the shapes do not match.
    Broadcast(const std::array<py::object, n>& objects, const std::array<Operand, n>& operands) {
        for (std::size_t i = 0; i < n; ++i) {
            const py::array array = doubles(objects[i]);
            const py::ssize_t last = array.ndim() - 1;
            const Operand& operand = operands[i];
            if (last < 0 || array.shape(last) < operand.least || array.shape(last) > operand.most)
                throw py::value_error(
                    operand.name + ": " + std::to_string(operand.least) +
                    (operand.least == operand.most ? "" : " to " + std::to_string(operand.most)) +
                    " numbers are needed along the last axis");
            arrays_[i] = array;
            rows_[i] = {static_cast<const char*>(array.data()), array.strides(last),
                        static_cast<int>(array.shape(last))};
            if (static_cast<std::size_t>(last) > shape_.size())
                shape_.insert(shape_.begin(), static_cast<std::size_t>(last) - shape_.size(), 1);
        }
        for (std::size_t i = 0; i < n; ++i) match(operands[i].name, arrays_[i]);
        for (std::size_t i = 0; i < n; ++i) {
            steps_[i].assign(shape_.size(), 0);
            const auto own = static_cast<std::size_t>(arrays_[i].ndim() - 1);
            for (std::size_t k = 0; k < own; ++k)
                if (arrays_[i].shape(static_cast<py::ssize_t>(k)) != 1)
                    steps_[i][shape_.size() - own + k] =
                        arrays_[i].strides(static_cast<py::ssize_t>(k));
        }
    }

    /// The same of points, one axis of rows: batch(sites of each operand, signs). False, and
    /// nothing is done, where there are more axes or none, or a number is not finite.
    template <class Batch>
    [[nodiscard]] bool as_batch(py::object& answer, const Batch& batch) const {
        if (shape_.size() != 1) return false;
        const auto size = static_cast<std::size_t>(shape_[0]);
        std::array<StridedSites, n> sites;
        bool are_finite = true;
        py::array_t<std::int8_t> result(shape_);
        const std::span<std::int8_t> signs(result.mutable_data(), size);
        watched([&](Watch&) {
            for (std::size_t i = 0; i < n; ++i) {
                Row row = rows_[i];
                const auto* const x = reinterpret_cast<const double*>(row.first);
                const auto* const y = reinterpret_cast<const double*>(row.first + row.stride);
                sites[i] = StridedSites(size, steps_[i][0], x, y);
                for (std::size_t m = 0; m < size && are_finite; ++m, row.first += steps_[i][0])
                    are_finite = row.is_finite();
            }
            if (are_finite) batch(sites, signs);
        });
        if (are_finite) answer = std::move(result);
        return are_finite;
    }
    /// function(rows) for all, in C order, with the interpreter free: an array, or a plain number
    /// where there is one row. Throws ValueError, naming the place, for a number that is not finite
    /// and for what the function throws as std::invalid_argument.
    template <class Function>
    py::object operator()(Function function) const {
        using Result = std::decay_t<decltype(function(rows_))>;
        using Stored = std::conditional_t<std::is_same_v<Result, int>, std::int8_t, Result>;
        py::array_t<Stored> result(shape_);
        Stored* next = result.mutable_data();
        const auto size = static_cast<std::size_t>(result.size());
        watched([&](Watch& watch) {
            std::vector<std::size_t> place(shape_.size(), 0);
            std::array<Row, n> rows = rows_;
            for (std::size_t i = 0; i < size; ++i) {
                watch.at(i, size);
                next[i] = static_cast<Stored>(checked_call(function, rows, place));
                advance(place, rows);
            }
        });
        if (shape_.empty()) return result.attr("item")();
        return result;
    }

 private:
    void match(const std::string& name, const py::array& array) {
        const auto own = static_cast<std::size_t>(array.ndim() - 1);
        for (std::size_t k = 0; k < own; ++k) {
            py::ssize_t& length = shape_[shape_.size() - own + k];
            const py::ssize_t other = array.shape(static_cast<py::ssize_t>(k));
            if (other == length || other == 1) continue;
            if (length != 1) throw py::value_error(name + ": its shape does not match the others'");
            length = other;
        }
    }
    void advance(std::vector<std::size_t>& place, std::array<Row, n>& rows) const noexcept {
        for (std::size_t axis = shape_.size(); axis-- > 0;) {
            ++place[axis];
            for (std::size_t i = 0; i < n; ++i) rows[i].first += steps_[i][axis];
            if (place[axis] < static_cast<std::size_t>(shape_[axis])) return;
            for (std::size_t i = 0; i < n; ++i)
                rows[i].first -= steps_[i][axis] * static_cast<std::ptrdiff_t>(place[axis]);
            place[axis] = 0;
        }
    }
    template <class Function>
    static auto checked_call(Function& function, const std::array<Row, n>& rows,
                             const std::vector<std::size_t>& place) {
        try {
            for (const Row& row : rows)
                if (!row.is_finite()) throw std::invalid_argument("a number is not finite");
            return function(rows);
        } catch (const std::invalid_argument& error) {
            std::string where;
            for (const std::size_t at : place)
                where += (where.empty() ? "row " : ", ") + std::to_string(at);
            throw std::invalid_argument(where + (where.empty() ? "" : ": ") + error.what());
        }
    }

    std::array<py::array, n> arrays_;
    std::array<Row, n> rows_{};
    std::vector<py::ssize_t> shape_;
    std::array<std::vector<std::ptrdiff_t>, n> steps_;
};

}  // namespace signum::python
