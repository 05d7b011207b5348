/// Tessellations that change and tessellations that move.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "names.hpp"
#include "parts.hpp"
#include "results.hpp"
#include "watched.hpp"

namespace signum::python {
namespace {

using namespace py::literals;
using Dynamic = Exclusive<DynamicTessellation>;

Site site_of(const Rows& rows, std::size_t i) {
    return {rows.at(i, 0), rows.at(i, 1), rows.columns() > 2 ? rows.at(i, 2) : 0.0};
}

/// A handle a row, or the one of a single site.
py::object inserted(Dynamic& dynamic, const py::object& sites) {
    const py::array array = doubles(sites);
    const bool is_one = array.ndim() == 1 && array.size() > 0;
    const Rows rows(is_one ? array.attr("reshape")(1, -1) : py::object(array), "sites", 2, 3);
    refuse_too_many(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!are_finite(site_of(rows, i)))
            throw py::value_error("sites: row " + std::to_string(i) + " is not finite");
    std::vector<Index> handles;
    handles.reserve(rows.size());
    watched([&](Watch& watch) {
        return dynamic.use([&](DynamicTessellation& all) {
            for (std::size_t i = 0; i < rows.size(); ++i) {
                watch.at(i, rows.size());
                handles.push_back(all.insert(site_of(rows, i)));
            }
        });
    });
    if (is_one) return py::int_(handles[0]);
    return column(std::move(handles));
}

void erased(Dynamic& dynamic, const py::object& handles) {
    const std::vector<Index> all_handles = index_list(handles, "handles");
    std::vector<Index> sorted = all_handles;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end())
        throw py::value_error("handles: one of them stands there twice");
    watched([&](Watch& watch) {
        return dynamic.use([&](DynamicTessellation& all) {
            for (const Index handle : all_handles)
                (void)all.site(handle);  // throws where it is none
            for (std::size_t i = 0; i < all_handles.size(); ++i) {
                watch.at(i, all_handles.size());
                all.erase(all_handles[i]);
            }
        });
    });
}

void moved_all(Dynamic& dynamic, const py::object& centres) {
    const Rows rows(centres, "centres", 2, 2);
    std::vector<Point> points(rows.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = {rows.at(i, 0), rows.at(i, 1)};
        if (!are_finite(points[i]))
            throw py::value_error("centres: row " + std::to_string(i) + " is not finite");
    }
    used(dynamic, &DynamicTessellation::move_all, points);
}

void bind_changing(py::module_& module) {
    py::class_<Dynamic> bound(module, "DynamicTessellation",
                              R"(A tessellation whose sites come, go, grow and move.

At any time it is that of triangulate() of the sites that are there, in the order of their handles. A
handle names its site until that is erased; then it may be given to another one. One call at a time:
while one runs in another thread the next one raises RuntimeError.)");
    complete(bound);
    bound
        .def(py::init([](const std::string& metric, const std::string& weight_is,
                         const py::object& sites) {
                 auto dynamic = std::make_unique<Dynamic>(metric_of(metric), weight_of(weight_is));
                 if (!sites.is_none()) inserted(*dynamic, sites);
                 return dynamic;
             }),
             py::arg("metric") = "euclidean", py::kw_only(), py::arg("weight_is") = "radius",
             py::arg("sites") = py::none(),
             "Without sites, or with those given, whose handles are 0, 1, 2 ...")
        .def("insert", &inserted, py::arg("sites"),
             R"(Adds sites, and gives their handles: int32, or an int for one site.

Each gets the least that is free. Raises ValueError, naming the row, for a number that is not finite; then
nothing has changed. On Ctrl-C the sites up to there are in. Expected O(sqrt n) a site in no order; along
a curve up to O(n), where each new one is a neighbour of most.)")
        .def("erase", &erased, py::arg("handles"),
             "Takes one site or several away; what they hid reappears. Raises IndexError for no "
             "handle.")
        .def("change", locked<DynamicTessellation, Index, double>(&DynamicTessellation::change),
             py::arg("handle"), py::arg("third"), "Gives a site another radius, or weight.")
        .def(
            "move",
            [](Dynamic& dynamic, Index handle, const py::object& centre) {
                used(dynamic, &DynamicTessellation::move, handle, point_of(centre, "centre"));
            },
            py::arg("handle"), py::arg("centre"), "Gives a site another centre, (x, y).")
        .def("move_all", &moved_all, py::arg("centres"),
             R"(Gives every site another centre: (n, 2), in the order of their handles. O(n).

Raises ValueError unless there is one for each, all finite; then nothing has changed.)")
        .def(
            "site",
            [](Dynamic& dynamic, Index handle) {
                const Site site = dynamic.use([&](auto& all) { return all.site(handle); });
                return py::make_tuple(site.x, site.y, site.r);
            },
            py::arg("handle"),
            "(x, y, r) of a site. Raises IndexError where there is no such handle.")
        .def(
            "tessellation", locked<DynamicTessellation>(&DynamicTessellation::tessellation),
            R"(The Tessellation of the sites, numbered from 0 in the order of their handles. O(n log n).)")
        .def_property_readonly(
            "insertions",
            [](Dynamic& dynamic) { return dynamic.use(&DynamicTessellation::insertions); },
            "How many insertions all changes took up to now.")
        .def_property_readonly(
            "moves",
            [](Dynamic& dynamic) {
                const Moves moves = dynamic.use(&DynamicTessellation::moves);
                return py::dict("kept"_a = moves.kept, "mended"_a = moves.mended,
                                "built"_a = moves.built);
            },
            "How many moves left all as it was, were mended, or had all built anew.")
        .def(
            "__contains__",
            [](Dynamic& dynamic, Index handle) {
                return dynamic.use([&](auto& all) { return all.contains(handle); });
            },
            py::arg("handle"), "Whether a site has that handle.")
        .def(
            "__len__", [](Dynamic& dynamic) { return dynamic.use(&DynamicTessellation::size); },
            "How many sites there are.");
}

/// An edge that comes or goes.
struct Change {
    double time;
    Index a;
    Index b;
    bool comes;
};

/// Tells the edges of one call of advance(), where that is asked for.
class Moving : public KineticTessellation {
 public:
    using KineticTessellation::KineticTessellation;

    void advance(double time, Watch& looked_after, std::vector<Change>* changes) {
        if (changes != nullptr && !watches_) {
            watch([this](Index a, Index b, bool comes) {
                if (changes_ != nullptr) changes_->push_back({time_, a, b, comes});
            });
            watches_ = true;
        }
        changes_ = changes;
        const struct Forget {
            std::vector<Change>*& changes;
            ~Forget() { changes = nullptr; }
        } forget{changes_};
        if (!std::isfinite(time)) KineticTessellation::advance(time);  // which throws
        // From event to event, which leads to the same faces, so that it can be stopped between.
        for (;;) {
            const std::optional<double> next = next_event();
            if (!next || !(*next <= time)) break;
            looked_after.look(0.0);
            if (looked_after.stops()) break;
            time_ = *next;
            KineticTessellation::advance(*next);
        }
        if (!looked_after.stops()) {
            time_ = time;
            KineticTessellation::advance(time);
        }
    }

 private:
    bool watches_ = false;
    double time_ = 0.0;
    std::vector<Change>* changes_ = nullptr;
};
using Kinetic = Exclusive<Moving>;

MovingSite moving_site(const Rows& rows, std::size_t i) {
    return {rows.at(i, 0), rows.at(i, 1), rows.at(i, 3),
            rows.at(i, 4), rows.at(i, 2), rows.columns() > 5 ? rows.at(i, 5) : 0.0};
}
MovingSite one_moving_site(const py::object& object) {
    const py::array array = doubles(object);
    const Rows rows(array.ndim() == 1 ? array.attr("reshape")(1, -1) : py::object(array), "site", 5,
                    6);
    if (rows.size() != 1) throw py::value_error("site: one row is needed");
    return moving_site(rows, 0);
}

std::unique_ptr<Kinetic> moving(const py::object& sites, double start, const py::object& fall) {
    const Rows rows(sites, "sites", 5, 6);
    std::vector<MovingSite> all(rows.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = moving_site(rows, i);
        for (int k = 0; k < rows.columns(); ++k)
            if (!(rows.at(i, k) - rows.at(i, k) == 0.0))
                throw py::value_error("sites: row " + std::to_string(i) + " is not finite");
    }
    const Point g = point_of(fall, "fall");
    return watched([&](Watch&) {
        return std::make_unique<Kinetic>(std::span<const MovingSite>(all), start, Fall{g.x, g.y});
    });
}

py::object advanced(Kinetic& kinetic, double time, bool log) {
    std::vector<Change> changes;
    watched([&](Watch& watch) {
        kinetic.use([&](Moving& all) { all.advance(time, watch, log ? &changes : nullptr); });
    });
    if (!log) return py::none();
    return column(std::move(changes));
}

py::dict dictionary(const KineticStatistics& all) {
    return py::dict("times"_a = all.times, "events"_a = all.events, "flips"_a = all.flips,
                    "hidden"_a = all.hidden, "appeared"_a = all.appeared,
                    "rebuilds"_a = all.rebuilds, "filtered"_a = all.filtered,
                    "exact"_a = all.exact);
}

void bind_moving(py::module_& module) {
    py::class_<Kinetic> bound(module, "KineticTessellation",
                              R"(A power tessellation whose sites move, kept up exactly.

Sites are x, y, r, vx, vy and, if they are not of time 0, their own time: at time t the centre is
(x, y) + (vx, vy) (t - time), and where all fall alike g (t - time)^2 / 2 more. Handles and threads as those of
a DynamicTessellation.)");
    complete(bound);
    bound
        .def(py::init(&moving), py::arg("sites"), py::kw_only(), py::arg("start") = 0.0,
             py::arg("fall") = py::make_tuple(0.0, 0.0),
             "Of sites with handles 0, 1, 2 ...; raises ValueError naming the row that is not "
             "finite.")
        .def(
            "insert",
            [](Kinetic& kinetic, const py::object& site) {
                return used(kinetic, &KineticTessellation::insert, one_moving_site(site));
            },
            py::arg("site"), "Adds a site at the present time, and gives its handle.")
        .def("erase", locked<Moving, Index>(&KineticTessellation::erase), py::arg("handle"),
             "Takes a site away. Raises IndexError where there is no such handle.")
        .def(
            "change",
            [](Kinetic& kinetic, Index handle, const py::object& site) {
                used(kinetic, &KineticTessellation::change, handle, one_moving_site(site));
            },
            py::arg("handle"), py::arg("site"), "From now on a site moves otherwise.")
        .def(
            "site",
            [](Kinetic& kinetic, Index handle) {
                const MovingSite site = used(kinetic, &KineticTessellation::site, handle);
                return py::make_tuple(site.x, site.y, site.r, site.vx, site.vy, site.time);
            },
            py::arg("handle"), "(x, y, r, vx, vy, time) of a site.")
        .def_property_readonly("time", locked<Moving>(&KineticTessellation::time),
                               "The present time.")
        .def(
            "next_event",
            [](Kinetic& kinetic) -> py::object {
                const auto time = used(kinetic, &KineticTessellation::next_event);
                return time ? py::object(py::float_(*time)) : py::none();
            },
            "A time at which faces may change next: the least double not before it; None for "
            "never.")
        .def("advance", &advanced, py::arg("time"), py::kw_only(), py::arg("log") = false,
             R"(Goes on to a time, all that happens at it included.

log: whether to tell the edges between sites that come and go, a structured array of time, a, b (a < b)
and comes. Raises ValueError unless the time is finite and not past. Ctrl-C ends it between two events;
the time is then that of the last one.)")
        .def(
            "faces",
            [](Kinetic& kinetic) {
                return table<Index>(used(kinetic, &KineticTessellation::faces));
            },
            "The finite faces right after the present time: triples of handles, int32 (f, 3), "
            "sorted.")
        .def(
            "tessellation", locked<Moving>(&KineticTessellation::tessellation),
            R"(The Tessellation of the sites as they are now, at the doubles nearest to their places.

Raises OverflowError where a site is beyond the doubles. O(n log n).)")
        .def_property_readonly(
            "statistics",
            [](Kinetic& kinetic) {
                return dictionary(used(kinetic, &KineticTessellation::statistics));
            },
            "What keeping it up took, by name.")
        .def("__contains__", locked<Moving, Index>(&KineticTessellation::contains),
             py::arg("handle"), "Whether a site has that handle.")
        .def("__len__", locked<Moving>(&KineticTessellation::size), "How many sites there are.");
}

}  // namespace

void bind_dynamic(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(Change, time, a, b, comes);
    bind_changing(module);
    bind_moving(module);
}

}  // namespace signum::python
