/// validate() of triangles and tetrahedra as other libraries give them: simplices without infinity.

#include <cstdint>
#include <string>
#include <vector>

#include "../../triangulation/validate_finite.hpp"
#include "arrays.hpp"
#include "finite.hpp"
#include "names.hpp"
#include "parts.hpp"
#include "results.hpp"
#include "space_sites.hpp"
#include "watched.hpp"

namespace signum::python {
namespace {

std::string word_of(FiniteFault fault) {
    constexpr std::array names = {"number", "flat", "overlap", "conflict"};
    return names[static_cast<std::size_t>(fault)];
}

}  // namespace

bool has_no_infinity(const py::object& faces) {
    const py::array array = py::array::ensure(faces);
    if (!array || array.ndim() != 2) return false;
    return array.shape(0) == 0 || array.shape(1) == 4 ||
           py::bool_(array.attr("min")().attr("__ge__")(0));
}

FiniteValidation validated_finite(const py::object& sites, const py::object& simplices,
                                  const std::string& weight_is, int threads,
                                  const py::object& progress) {
    const bool weights = weight_of(weight_is) == WeightIs::weight;
    const int count = threads_of(threads);
    const py::array shape = py::array::ensure(simplices);
    const bool in_space = shape && shape.ndim() == 2 && shape.shape(1) == 4;
    const auto judged = [&](const auto& cells, const auto& those) {
        return watched(progress, [&](Watch& watch) {
            return validate_finite(cells, those, {watch.token(), watch.progress(), count});
        });
    };
    if (!in_space) {
        const Rows rows(sites, "sites", 2, 3);
        refuse_too_many(rows.size());
        return judged(rows_of<std::array<Index, 3>>(simplices, "simplices"), rows.sites(weights));
    }
    return with_sites(sites_of(sites, weights), [&](auto those) {
        refuse_too_many(those.size());
        return judged(rows_of<std::array<Index, 4>>(simplices, "simplices"), those);
    });
}

void bind_finite(py::module_& module) {
    py::class_<FiniteValidation> bound(
        module, "FiniteValidation",
        "What validate() says of simplices without infinity; true where they are valid.");
    complete(bound);
    bound
        .def_readonly("valid", &FiniteValidation::valid,
                      "Whether they are a Delaunay triangulation, or with weights a regular one.")
        .def_readonly("message", &FiniteValidation::message,
                      "What is wrong and where; empty otherwise.")
        .def_property_readonly(
            "faults",
            [](const FiniteValidation& v) {
                std::vector<std::int64_t> faces;
                for (const auto& each : v.faults) faces.push_back(each.face);
                return column<std::int64_t>(std::move(faces));
            },
            "The rows of simplices at fault, int64, rising.")
        .def_property_readonly(
            "kinds",
            [](const FiniteValidation& v) {
                py::list kinds;
                for (const auto& each : v.faults) kinds.append(word_of(each.fault));
                return kinds;
            },
            "The fault of each row in `faults`: 'number', 'flat', 'overlap' or 'conflict'.")
        .def_property_readonly(
            "open",
            [](const FiniteValidation& v) {
                py::list edges;
                for (const auto& [face, between] : v.open)
                    edges.append(py::make_tuple(face, between[0], between[1]));
                return edges;
            },
            "Edges of one face that are not on the hull, (row of simplices, site, site) each; of "
            "the plane.")
        .def_property_readonly(
            "missing",
            [](const FiniteValidation& v) {
                return column<std::int64_t>(std::vector<std::int64_t>(v.missing));
            },
            "Rows of sites that should be vertices and are none, int64, rising.")
        .def(
            "__bool__", [](const FiniteValidation& v) { return v.valid; }, "The same as valid.")
        .def("__repr__", [](const FiniteValidation& v) {
            return std::string("<signum.FiniteValidation: ") +
                   (v.valid ? "valid" : "not valid: " + v.message) + ">";
        });
}

}  // namespace signum::python
