#pragma once
/// Between NumPy's arrays and the library's views and vectors. Nothing is copied on the way in
/// where an array holds aligned doubles of this machine, whatever its strides; nothing on the way
/// out.

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "../../core/index.hpp"
#include "../../core/strided_sites.hpp"

namespace signum::python {

namespace py = pybind11;

/// The object itself where its doubles can be read in place; otherwise a new array of the same
/// numbers. Throws ValueError for a number that no double is (signum/_exact.py).
[[nodiscard]] py::array doubles(const py::object& object);

/// A table of doubles, a row a site, a point or a ball. It keeps its array alive, and is itself to
/// be destroyed by who holds the interpreter.
class Rows {
 public:
    /// `what` names it in errors; throws ValueError unless there are from `least` to `most`
    /// columns.
    Rows(const py::object& object, const std::string& what, int least, int most);

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] int columns() const noexcept { return columns_; }
    [[nodiscard]] double at(std::size_t row, int column) const noexcept {
        return *reinterpret_cast<const double*>(
            first_ + static_cast<std::ptrdiff_t>(row) * row_stride_ + column * column_stride_);
    }
    /// Of two or three columns.
    [[nodiscard]] StridedSites sites(bool third_is_weight) const noexcept;

 private:
    [[nodiscard]] const double* column(int k) const noexcept {
        return reinterpret_cast<const double*>(first_ + k * column_stride_);
    }

    py::array array_;
    const char* first_ = nullptr;
    std::size_t size_ = 0;
    int columns_ = 0;
    std::ptrdiff_t row_stride_ = 0;
    std::ptrdiff_t column_stride_ = 0;
};

/// A table of whole numbers that fit 32 bits, `columns` wide.
[[nodiscard]] std::vector<Index> indices(const py::object& object, const std::string& what,
                                         std::size_t columns);
/// The same as rows that are nothing but their numbers.
template <class Row>
[[nodiscard]] std::vector<Row> rows_of(const py::object& object, const std::string& what) {
    const std::vector<Index> numbers = indices(object, what, sizeof(Row) / sizeof(Index));
    std::vector<Row> rows(numbers.size() * sizeof(Index) / sizeof(Row));
    if (!rows.empty()) std::memcpy(rows.data(), numbers.data(), rows.size() * sizeof(Row));
    return rows;
}

/// One number, or as many as the object has: handles, sites.
[[nodiscard]] std::vector<Index> index_list(const py::object& object, const std::string& what);
[[nodiscard]] bool is_one_number(const py::object& object);

/// The array that looks at `data`, which `base` owns; it cannot be written to.
template <class Number>
[[nodiscard]] py::array view(const Number* data, std::vector<py::ssize_t> shape,
                             std::vector<py::ssize_t> strides, py::handle base) {
    py::array array(py::dtype::of<Number>(), std::move(shape), std::move(strides), data, base);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}
/// Of elements that are `columns` numbers each and nothing else.
template <class Number, class Element>
[[nodiscard]] py::array table(std::span<const Element> elements, py::handle base) {
    constexpr std::size_t columns = sizeof(Element) / sizeof(Number);
    static_assert(sizeof(Element) == columns * sizeof(Number));
    return view(
        reinterpret_cast<const Number*>(elements.data()),
        {static_cast<py::ssize_t>(elements.size()), static_cast<py::ssize_t>(columns)},
        {static_cast<py::ssize_t>(sizeof(Element)), static_cast<py::ssize_t>(sizeof(Number))},
        base);
}

/// What an object's method tells of its own memory, as a read-only property: a table.
template <class Number, class Class, class Element>
[[nodiscard]] auto shown(std::span<const Element> (Class::*elements)() const) {
    return [elements](const py::object& self) {
        return table<Number>((self.cast<const Class&>().*elements)(), self);
    };
}

/// A vector that Python owns from now on.
template <class Element>
struct Owned {
    const std::vector<Element>* elements;
    py::capsule base;
};
template <class Element>
[[nodiscard]] Owned<Element> owned(std::vector<Element> elements) {
    auto* vector = new std::vector<Element>(std::move(elements));
    return {vector, py::capsule(vector, [](void* there) {
                delete static_cast<std::vector<Element>*>(there);
            })};
}
template <class Number, class Element>
[[nodiscard]] py::array table(std::vector<Element> elements) {
    const Owned<Element> kept = owned(std::move(elements));
    return table<Number>(std::span<const Element>(*kept.elements), kept.base);
}
/// Numbers alone, or records: one dimension.
template <class Number>
[[nodiscard]] py::array column(std::span<const Number> numbers, py::handle base) {
    return view(numbers.data(), {static_cast<py::ssize_t>(numbers.size())},
                {static_cast<py::ssize_t>(sizeof(Number))}, base);
}
template <class Number>
[[nodiscard]] py::array column(std::vector<Number> numbers) {
    const Owned<Number> kept = owned(std::move(numbers));
    return column(std::span<const Number>(*kept.elements), kept.base);
}
/// The numbers that begin `offset` numbers into each element, `columns` of them.
template <class Number, class Element>
[[nodiscard]] py::array part(std::span<const Element> elements, std::size_t offset,
                             std::size_t columns, py::handle base) {
    std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(elements.size())};
    std::vector<py::ssize_t> strides = {static_cast<py::ssize_t>(sizeof(Element))};
    if (columns > 1) {
        shape.push_back(static_cast<py::ssize_t>(columns));
        strides.push_back(static_cast<py::ssize_t>(sizeof(Number)));
    }
    return view(reinterpret_cast<const Number*>(elements.data()) + (elements.empty() ? 0 : offset),
                std::move(shape), std::move(strides), base);
}

}  // namespace signum::python
