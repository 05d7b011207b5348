#include "arrays.hpp"

#include <cstdint>
#include <limits>

namespace signum::python {

py::array doubles(const py::object& object) {
    // Not of a type of their own, such as arrays with a mask.
    const bool is_plain = py::type::of(object).is(py::module_::import("numpy").attr("ndarray"));
    if (is_plain && py::isinstance<py::array_t<double>>(object)) {
        auto array = py::reinterpret_borrow<py::array>(object);
        constexpr auto aligned = py::detail::npy_api::NPY_ARRAY_ALIGNED_;
        if ((py::detail::array_proxy(array.ptr())->flags & aligned) != 0) return array;
    }
    return py::module_::import("signum._exact").attr("doubles")(object).cast<py::array>();
}

Rows::Rows(const py::object& object, const std::string& what, int least, int most)
    : array_(doubles(object)) {
    const bool is_table = array_.ndim() == 2;
    if (!is_table && array_.size() == 0) {
        columns_ = least;
        return;
    }
    if (!is_table || array_.shape(1) < least || array_.shape(1) > most) {
        std::string shape;
        for (py::ssize_t k = 0; k < array_.ndim(); ++k)
            shape += (k > 0 ? ", " : "") + std::to_string(array_.shape(k));
        throw py::value_error(what + ": a table of " + std::to_string(least) +
                              (least == most ? "" : " to " + std::to_string(most)) +
                              " columns is needed, a row each; this one's shape is (" + shape +
                              ")");
    }
    first_ = static_cast<const char*>(array_.data());
    size_ = static_cast<std::size_t>(array_.shape(0));
    columns_ = static_cast<int>(array_.shape(1));
    // Of a single row NumPy may say any stride.
    row_stride_ = size_ > 1 ? array_.strides(0) : 0;
    column_stride_ = columns_ > 1 ? array_.strides(1) : 0;
}

StridedSites Rows::sites(bool third_is_weight) const noexcept {
    if (size_ == 0) return {};
    return {size_,          row_stride_, column(0), column(1), columns_ > 2 ? column(2) : nullptr,
            third_is_weight};
}

namespace {

py::array_t<std::int64_t, py::array::c_style> whole_numbers(const py::object& object,
                                                            const std::string& what) {
    auto array = py::array::ensure(object);
    if (array && array.size() == 0) return py::array_t<std::int64_t, py::array::c_style>(0);
    if (!array || (array.dtype().kind() != 'i' && array.dtype().kind() != 'u'))
        throw py::value_error(what + ": whole numbers are needed");
    constexpr std::uint64_t most = std::numeric_limits<Index>::max();
    if (array.dtype().kind() == 'u' && array.attr("max")().cast<std::uint64_t>() > most)
        throw py::value_error(what + ": there is a number beyond 32 bits");
    return py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(array);
}

Index narrowed(std::int64_t number, const std::string& what, std::size_t row) {
    const auto index = static_cast<Index>(number);
    if (index != number)
        throw py::value_error(what + ": row " + std::to_string(row) +
                              " has a number beyond 32 bits");
    return index;
}

}  // namespace

std::vector<Index> indices(const py::object& object, const std::string& what, std::size_t columns) {
    const auto array = whole_numbers(object, what);
    if (array.size() == 0) return {};
    if (array.ndim() != 2 || array.shape(1) != static_cast<py::ssize_t>(columns))
        throw py::value_error(what + ": a table of " + std::to_string(columns) +
                              " columns is needed");
    std::vector<Index> result(static_cast<std::size_t>(array.size()));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = narrowed(array.data()[i], what, i / columns);
    return result;
}

std::vector<Index> index_list(const py::object& object, const std::string& what) {
    const auto array = whole_numbers(object, what);
    if (array.ndim() > 1) throw py::value_error(what + ": a number or a row of numbers is needed");
    std::vector<Index> result(static_cast<std::size_t>(array.size()));
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = narrowed(array.data()[i], what, i);
    return result;
}

bool is_one_number(const py::object& object) {
    return py::array::ensure(object).ndim() == 0;
}

}  // namespace signum::python
