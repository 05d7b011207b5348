/// Tessellations of the plane.

#include <string>

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../triangulation/vertices.hpp"
#include "../../voronoi/contacts.hpp"
#include "finite.hpp"
#include "names.hpp"
#include "parts.hpp"
#include "results.hpp"
#include "watched.hpp"

namespace signum::python {
namespace {

/// Of every point the answer of a question: one number for one point.
template <class Ask>
py::object answers(const py::object& points, const std::string& what, Ask ask) {
    const py::array array = doubles(points);
    const bool is_one = array.ndim() == 1 && array.size() == 2;
    const Rows rows(is_one ? array.attr("reshape")(1, 2) : py::object(array), what, 2, 2);
    std::vector<Index> result = watched([&](Watch& watch) {
        std::vector<Index> all(rows.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            watch.at(i, all.size());
            const Point point = {rows.at(i, 0), rows.at(i, 1)};
            if (!are_finite(point))
                throw std::invalid_argument(what + ": row " + std::to_string(i) + " is not finite");
            all[i] = ask(point);
        }
        return all;
    });
    if (is_one) return py::int_(result[0]);
    return column(std::move(result));
}

py::dict dictionary(const Statistics& statistics) {
    py::dict result;
    for (const Counter& counter : counters)
        result[counter.name] =
            statistics.counted ? py::object(py::int_(statistics.*counter.count)) : py::none();
    result["seconds"] = statistics.seconds;
    return result;
}

Tessellation triangulated(const py::object& sites, const std::string& metric,
                          const std::string& weight_is, const std::string& method,
                          const std::string& arithmetic, std::uint64_t seed, int threads,
                          bool count, const py::object& progress, const std::string& order) {
    const Metric in_metric = metric_of(metric);
    const bool weights = weight_of(weight_is) == WeightIs::weight;
    Options options;
    options.method = named(method, "method", all_methods);
    options.arithmetic = arithmetic_of(arithmetic);
    options.seed = seed;
    options.threads = threads_of(threads);
    options.count = count;
    options.order = named(order, "order", all_orders);
    const Rows rows(sites, "sites", 2, 3);
    return watched(progress, [&](Watch& watch) {
        options.stop = watch.token();
        options.progress = watch.progress();
        return triangulate(rows.sites(weights), in_metric, options);
    });
}

py::object validated(const py::object& sites, const py::object& faces, const py::object& metric,
                     const py::object& neighbours, const py::object& hidden,
                     const std::string& weight_is, int threads, const py::object& progress) {
    if (metric.is_none() && neighbours.is_none() && hidden.is_none() && has_no_infinity(faces))
        return py::cast(validated_finite(sites, faces, weight_is, threads, progress));
    const int count = threads_of(threads);
    const Rows rows(sites, "sites", 2, 3);
    refuse_too_many(rows.size());
    TessellationArrays arrays;
    arrays.metric = metric_of(metric.is_none() ? "euclidean" : py::cast<std::string>(metric));
    arrays.weight_is = weight_of(weight_is);
    arrays.sites = static_cast<std::int64_t>(rows.size());
    arrays.faces = rows_of<Face>(faces, "faces");
    if (!neighbours.is_none()) arrays.neighbours = rows_of<Face>(neighbours, "neighbours");
    if (!hidden.is_none()) arrays.hidden = rows_of<Hidden>(hidden, "hidden");
    return py::cast(watched(progress, [&](Watch& watch) {
        return validate(arrays, rows.sites(arrays.weight_is == WeightIs::weight),
                        {watch.token(), watch.progress(), count});
    }));
}

py::array_t<bool> may_share_edge(const Tessellation& tessellation, const py::object& pairs) {
    const std::vector<Edge> edges = rows_of<Edge>(pairs, "pairs");
    py::array_t<bool> result(static_cast<py::ssize_t>(edges.size()));
    bool* answer = result.mutable_data();
    watched([&](Watch& watch) {
        const Canonical canonical(tessellation);
        const Contacts contacts = contacts_of(canonical);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            watch.at(i, edges.size());
            answer[i] = contacts(edges[i][0], edges[i][1]);
        }
    });
    return result;
}

void bind_tessellation(py::module_& module) {
    py::class_<Tessellation> bound(module, "Tessellation",
                                   R"(The tessellation of sites in the plane.

What triangulate() gives. Its arrays are read-only views of its memory, which they keep alive; it can
be asked from several threads at once.)");
    complete(bound);
    bound
        .def_property_readonly(
            "metric", [](const Tessellation& t) { return text(name_of(t.metric())); },
            "'power', 'euclidean', 'manhattan' or 'supremum'.")
        .def_property_readonly(
            "weight_is", [](const Tessellation& t) { return text(name_of(t.weight_is())); },
            "What the third number of a site is: 'radius' or 'weight'.")
        .def_property_readonly(
            "sites", shown<double>(&Tessellation::sites),
            "All sites in the order given, hidden ones included: float64 (n, 3), x, y, r.")
        .def_property_readonly(
            "faces", shown<Index>(&Tessellation::faces),
            R"(Counterclockwise triples of sites, int32 (2n-2, 3), -1 being infinity.

The smallest number comes first, and faces are sorted, so that the same sites have the same array.)")
        .def_property_readonly(
            "neighbours", shown<Index>(&Tessellation::neighbours),
            "int32 (2n-2, 3): neighbours[f, k] is the face across from corner k of face f.")
        .def_property_readonly(
            "hidden", shown<Index>(&Tessellation::hidden),
            "int32 (m, 2): sites whose cells are empty, and the visible site nearest to each "
            "centre.")
        .def_property_readonly(
            "statistics", [](const Tessellation& t) { return dictionary(t.statistics()); },
            "What the construction did: counters (None unless count=True asked for them), seconds.")
        .def(
            "edges",
            [](const Tessellation& t) {
                return table<Index>(watched([&](Watch&) { return t.edges(); }));
            },
            R"(All edges, int32 (3n-3, 2), those to infinity (-1, a) included, smaller number first.

Sorted. Sites that share several edges appear as often. O(n log n).)")
        .def(
            "vertices",
            [](const Tessellation& t) {
                return table<double>(watched([&](Watch&) { return vertices(t); }));
            },
            R"(The vertex of the Voronoi diagram of every face: float64 (2n-2, 3), x, y, rho.

rho is its distance from its three sites in the metric. Each number is the double nearest to the exact
value; NaN for a face with infinity, and where it is beyond the doubles. O(n).)")
        .def(
            "neighbours_of",
            [](const Tessellation& t, Index site) { return column(t.neighbours(site)); },
            py::arg("site"),
            R"(The sites joined to a site, counterclockwise from the smallest, -1 for infinity.

Empty for a hidden site. Raises IndexError where there is no such site.)")
        .def(
            "locate",
            [](const Tessellation& t, const py::object& points) {
                return answers(points, "points", [&](Point p) { return t.locate(p); });
            },
            py::arg("points"),
            R"(A face that contains each point: int32, or an int for one point.

In the power metric its closure contains the point, exactly, and outside the hull it is an infinite face
whose edge sees it; in the others, whose edges are curved, the first face at the site nearest to it. -1
where there is no face. O(n^(1/3)) a point on uniform sites. Raises ValueError naming the row that is not
finite.)")
        .def(
            "nearest",
            [](const Tessellation& t, const py::object& points) {
                return answers(points, "points", [&](Point p) { return t.nearest(p); });
            },
            py::arg("points"),
            R"(The site whose cell contains each point, exactly: int32, or an int for one point.

-1 without sites; errors and time as locate().)")
        .def("may_share_edge", &may_share_edge, py::arg("pairs"),
             R"(Whether two sites share an edge however ties are decided: bool (k,) for int (k, 2).

What is False of an edge that another program has found, is a wrong one. This tessellation must be one
that an exact arithmetic made. Raises IndexError where there is no such site.)")
        .def(
            "validate",
            [](const Tessellation& t, const py::object& progress, int threads) {
                const int count = threads_of(threads);
                return watched(progress, [&](Watch& watch) {
                    return validate(t, {watch.token(), watch.progress(), count});
                });
            },
            py::arg("progress") = py::none(), py::kw_only(), py::arg("threads") = 0,
            "Judges the tessellation from scratch, in numbers of the judge's own: a Validation.")
        .def(
            "__len__", [](const Tessellation& t) { return t.sites().size(); },
            "How many sites there are.")
        .def("__repr__", [](const Tessellation& t) {
            return "<signum.Tessellation: " + std::string(name_of(t.metric())) + ", " +
                   std::to_string(t.sites().size()) + " sites, " +
                   std::to_string(t.faces().size()) + " faces, " +
                   std::to_string(t.hidden().size()) + " hidden>";
        });
}

}  // namespace

void bind_plane(py::module_& module) {
    static py::exception<BrokenStructure> broken(module, "BrokenStructure", PyExc_RuntimeError);
    broken.attr("__doc__") =
        "Inexact arithmetic led a construction astray. Exact ones never raise it.";

    py::class_<Validation> bound(module, "Validation",
                                 "What validate() says; true where the result is valid.");
    complete(bound);
    bound.def_readonly("valid", &Validation::valid, "Whether it is a tessellation of the sites.")
        .def_readonly("canonical", &Validation::canonical,
                      "Whether it is the one that the rule of ties chooses, its arrays in order.")
        .def_readonly("message", &Validation::message, "What is wrong and where; empty otherwise.")
        .def_readonly("filtered", &Validation::filtered, "Questions that a filter decided.")
        .def_readonly("multiprecision", &Validation::multiprecision,
                      "Questions that took exact numbers.")
        .def(
            "__bool__", [](const Validation& v) { return v.valid; }, "The same as valid.")
        .def("__repr__", [](const Validation& v) {
            return std::string("<signum.Validation: ") + (v.valid ? "valid" : "not valid") +
                   (v.canonical ? ", canonical" : "") +
                   (v.message.empty() ? "" : ": " + v.message) + ">";
        });
    bind_tessellation(module);

    module.def("triangulate", &triangulated, py::arg("sites"), py::arg("metric") = "euclidean",
               py::kw_only(), py::arg("weight_is") = "radius", py::arg("method") = "incremental",
               py::arg("arithmetic") = "exact", py::arg("seed") = 1, py::arg("threads") = 0,
               py::arg("count") = false, py::arg("progress") = py::none(),
               py::arg("order") = "index",
               R"(The tessellation of sites in the plane: a Tessellation.

sites: x, y and a radius, or x and y alone (radius 0), a row each. An array of doubles is read where it
lies, whatever its strides; other numbers are converted, and refused where that would round.
metric: 'power' (Laguerre; with equal radii Delaunay), 'euclidean' (discs), 'manhattan' (diamonds) or
'supremum' (squares), or an alias of the command line.
weight_is: 'weight' where the third number of a site of the power metric is not r but r squared.
method: 'incremental', 'flips' (power) or 'sweep' (manhattan, supremum). The result is the same.
arithmetic: 'exact', or another one, to see what accuracy costs: 'naive', 'single', 'interval', 'sum',
'multiprecision'.
seed: of the random order of insertion, on which the result does not depend.
threads: how many work, on which the result does not depend either; 0 is as many as there are cores to use.
count: whether to fill the counters of Tessellation.statistics.
progress: called now and then with the share of the work done.
order: of the faces: 'index', by the numbers of their sites, or 'curve', by their places along a Hilbert
curve, so that near ones stand together. Either depends on the sites alone.

Sites may touch, nest and coincide; ties are decided by one rule, so that the result depends on the sites
alone. Raises ValueError, naming the site by its row, for a number that is not finite; BrokenStructure
where inexact arithmetic fails; KeyboardInterrupt on Ctrl-C; whatever progress raises. Other threads run
meanwhile; they must not write to the array. O(n log n) expected.)");
    module.def("validate", &validated, py::arg("sites"), py::arg("faces"),
               py::arg("metric") = py::none(), py::kw_only(), py::arg("neighbours") = py::none(),
               py::arg("hidden") = py::none(), py::arg("weight_is") = "radius",
               py::arg("threads") = 0, py::arg("progress") = py::none(),
               R"(Whether arrays, whoever made them, are a tessellation of the sites: a Validation.

faces as those of a Tessellation, those with infinity (-1) included, in any order; metric as for
triangulate(), 'euclidean' where it is None; neighbours may be
missing where no two sites share several edges; hidden, sites whose cells are empty, with who hides them;
threads as for triangulate().

Without infinity, and without metric, neighbours and hidden, faces are simplices as SciPy, Qhull, Triangle
or TetGen give them, triangles or tetrahedra in any order and orientation: whether they are a Delaunay
triangulation of the sites or, where these have a last number, a regular one, whichever ties allow: a
FiniteValidation.
Raises ValueError for a site that is not finite.)");
}

}  // namespace signum::python
