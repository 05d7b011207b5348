#include "svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "document.hpp"
#include "paths.hpp"
#include "shapes.hpp"
#include "space_view.hpp"

namespace signum {
namespace {

/// As the tints of a diagram in the plane, and stronger: light falls on them at an angle.
using Colour = std::array<double, 3>;
constexpr std::array<Colour, 6> solid_colours = {{{138, 190, 231},
                                                  {244, 190, 96},
                                                  {126, 205, 174},
                                                  {228, 158, 197},
                                                  {236, 226, 120},
                                                  {190, 190, 202}}};

/// Of length 1: from the upper right, past the eye.
constexpr Point3 to_the_light = {6.0 / 7.0, 3.0 / 7.0, 2.0 / 7.0};

class SolidsPicture {
 public:
    SolidsPicture(std::span<const Site3> sites, const SpaceCells& cells,
                  std::span<const SpacePolyhedron> polyhedra, std::size_t face_limit)
        : sites_(sites),
          cells_(cells),
          polyhedra_(polyhedra),
          exponent_(exponent_of(cells.box)),
          middle_(middle_of(cells.box)),
          frame_(discs_of_box(), picture_width),
          pens_(20.0),
          legend_(document_width, shapes_of(Metric::power).outline) {
        choose_cells();
        choose_tints();
        choose_faces(face_limit);
    }

    void write(std::ostream& out) {
        describe();
        write_box(false);
        write_cells();
        write_box(true);
        SvgText directions;
        write_directions(directions, frame_.height());
        write_document(out, fmt::format("power cells of {} sites in space", sites_.size()), frame_,
                       pens_, legend_, drawing_, directions);
    }

 private:
    struct Face {
        Index site;
        std::size_t number;  ///< in its polyhedron
        Point3 normal;       ///< outward, of length 1
    };

    /// The box, divided by 2^exponent, is of length 1 to 4.
    static int exponent_of(const Box3& box) noexcept {
        double longest = 0.0;
        for (const auto axis : {&Point3::x, &Point3::y, &Point3::z})
            longest = std::max(longest, box.high.*axis / 2 - box.low.*axis / 2);
        return std::ilogb(longest);
    }
    static Point3 middle_of(const Box3& box) noexcept {
        return {box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2,
                box.low.z / 2 + box.high.z / 2};
    }
    /// From the middle of the box, divided.
    [[nodiscard]] Point3 placed(const Point3& p) const noexcept {
        const auto divided = [this](double length) { return std::ldexp(length, -exponent_); };
        return {divided(p.x - middle_.x), divided(p.y - middle_.y), divided(p.z - middle_.z)};
    }
    [[nodiscard]] static Point projected(const Point3& placed) noexcept {
        return {dot_product(placed, to_the_right), dot_product(placed, upward)};
    }
    /// Of eight, by the bits for x, y and z; a set one is the higher side.
    [[nodiscard]] Point3 box_corner(unsigned bits) const noexcept {
        const auto& [low, high] = cells_.box;
        return placed({(bits & 1U) != 0 ? high.x : low.x, (bits & 2U) != 0 ? high.y : low.y,
                       (bits & 4U) != 0 ? high.z : low.z});
    }
    [[nodiscard]] std::vector<Site> discs_of_box() const {
        std::vector<Site> discs;
        for (unsigned bits = 0; bits < 8; ++bits) {
            const Point at = projected(box_corner(bits));
            discs.push_back({at.x, at.y, 0.0});
        }
        return discs;
    }
    [[nodiscard]] bool is_drawn(Index site) const {
        return is_drawn_[static_cast<std::size_t>(site)] != 0;
    }

    void choose_cells() {
        is_drawn_.assign(polyhedra_.size(), 0);
        for (const SpacePolyhedron& each : polyhedra_) {
            if (each.corners.empty()) continue;
            ++solid_;
            const bool is_cut = std::ranges::any_of(each.beyond, is_box_side);
            if (is_cut) ++cut_;
            is_drawn_[static_cast<std::size_t>(each.site)] = is_cut ? 0 : 1;
        }
        if (cut_ < solid_) return;
        for (const SpacePolyhedron& each : polyhedra_)
            is_drawn_[static_cast<std::size_t>(each.site)] = each.corners.empty() ? 0 : 1;
    }
    /// One that no neighbour before it has, where there is one.
    void choose_tints() {
        tints_.assign(polyhedra_.size(), 0);
        for (std::size_t site = 0; site < polyhedra_.size(); ++site) {
            std::array<int, solid_colours.size()> uses = {};
            for (const Index beyond : polyhedra_[site].beyond)
                if (!is_box_side(beyond) && static_cast<std::size_t>(beyond) < site &&
                    is_drawn(beyond))
                    ++uses[tints_[static_cast<std::size_t>(beyond)]];
            const auto least = std::ranges::min_element(uses);
            tints_[site] = static_cast<std::size_t>(least - uses.begin());
        }
    }
    /// Those of the surface that are turned to the eye, far cells first; of too many the nearest.
    void choose_faces(std::size_t limit) {
        std::vector<Index> order;
        for (const SpacePolyhedron& each : polyhedra_)
            if (is_drawn(each.site)) order.push_back(each.site);
        const auto height = [this](Index site) {
            const auto& [x, y, z, r] = sites_[static_cast<std::size_t>(site)];
            return dot_product(placed({x, y, z}), to_the_eye);
        };
        std::ranges::stable_sort(order, {}, height);
        for (const Index site : order) {
            const SpacePolyhedron& solid = polyhedra_[static_cast<std::size_t>(site)];
            for (std::size_t f = 0; f < solid.beyond.size(); ++f) {
                if (!is_box_side(solid.beyond[f]) && is_drawn(solid.beyond[f])) continue;
                const Point3 normal = normal_of(solid, f);
                if (dot_product(normal, to_the_eye) > 0.0) faces_.push_back({site, f, normal});
            }
        }
        all_faces_ = faces_.size();
        if (all_faces_ > limit)
            faces_.erase(faces_.begin(), faces_.end() - static_cast<std::ptrdiff_t>(limit));
    }
    /// By Newell's sum over the corners; nothing for a face without area.
    [[nodiscard]] Point3 normal_of(const SpacePolyhedron& solid, std::size_t face) const {
        const auto loop = solid.corners_of(face);
        Point3 sum;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const auto at = [&](std::size_t place) {
                return placed(solid.corners[static_cast<std::size_t>(loop[place % loop.size()])]);
            };
            const Point3 p = at(k);
            const Point3 q = at(k + 1);
            sum = {sum.x + (p.y - q.y) * (p.z + q.z), sum.y + (p.z - q.z) * (p.x + q.x),
                   sum.z + (p.x - q.x) * (p.y + q.y)};
        }
        const double length = std::sqrt(dot_product(sum, sum));
        if (!(length > 0.0)) return {};
        return {sum.x / length, sum.y / length, sum.z / length};
    }

    void describe() {
        legend_.line("edge", "the box");
        if (cut_ < solid_) {
            legend_.note("cells: {} that the box does not cut are drawn, {} that it cuts are not",
                         solid_ - cut_, cut_);
        } else {
            legend_.note("cells: {}, all cut by the box", solid_);
        }
        if (faces_.size() < all_faces_)
            legend_.note("faces: the {} nearest of {} drawn", faces_.size(), all_faces_);
        legend_.note("seen from far away, 23 degrees to the right of z and 16 above");
    }

    /// The three edges at the farthest corner lie behind all cells, the others before them.
    void write_box(bool in_front) {
        constexpr unsigned farthest = 0;
        Paths paths(drawing_, "edge");
        for (unsigned from = 0; from < 8; ++from)
            for (const unsigned axis : {1U, 2U, 4U}) {
                const unsigned to = from | axis;
                const bool is_behind = from == farthest;
                if (to == from || is_behind == in_front) continue;
                paths.line(Conic::straight(frame_.at(projected(box_corner(from))),
                                           frame_.at(projected(box_corner(to)))));
            }
    }
    void write_cells() {
        drawing_.add("<g stroke=\"#333\" stroke-width=\"{}\" stroke-linejoin=\"round\">\n",
                     Px{stroke_width()});
        for (std::size_t next = 0; next < faces_.size();) {
            const Index site = faces_[next].site;
            drawing_.add("<g><title>{}, volume {:.4g}</title>\n", site,
                         cells_.measures[static_cast<std::size_t>(site)].volume);
            for (; next < faces_.size() && faces_[next].site == site; ++next)
                write_face(faces_[next]);
            drawing_.add("</g>\n");
        }
        drawing_.add("</g>\n");
    }
    /// Thinner where there are many.
    [[nodiscard]] double stroke_width() const noexcept {
        return std::clamp(20.0 / std::sqrt(1.0 + static_cast<double>(faces_.size())), 0.25, 1.2);
    }
    void write_face(const Face& face) {
        const double share = dot_product(face.normal, to_the_light);
        const double light = 0.72 + 0.28 * share;
        const Colour& colour = solid_colours[tints_[static_cast<std::size_t>(face.site)]];
        drawing_.add("<polygon fill=\"#");
        for (const double part : colour)
            drawing_.add("{:02x}", static_cast<unsigned>(std::lround(part * light)));
        drawing_.add("\" points=\"");
        const SpacePolyhedron& solid = polyhedra_[static_cast<std::size_t>(face.site)];
        const char* blank = "";
        for (const Index corner : solid.corners_of(face.number)) {
            const Point at =
                frame_.at(projected(placed(solid.corners[static_cast<std::size_t>(corner)])));
            drawing_.add("{}{},{}", blank, Px{at.x}, Px{at.y});
            blank = " ";
        }
        drawing_.add("\"/>\n");
    }

    std::span<const Site3> sites_;
    const SpaceCells& cells_;
    std::span<const SpacePolyhedron> polyhedra_;
    int exponent_;
    Point3 middle_;
    Frame frame_;
    Pens pens_;
    Legend legend_;
    std::vector<std::uint8_t> is_drawn_;  // by site
    std::vector<std::size_t> tints_;      // by site
    std::size_t solid_ = 0;               // cells that have a volume in the box
    std::size_t cut_ = 0;                 // and sides of the box
    std::vector<Face> faces_;             // in the order of drawing
    std::size_t all_faces_ = 0;
    SvgText drawing_;
};

}  // namespace

void write_space_cells_svg(std::ostream& out, std::span<const Site3> sites, const SpaceCells& cells,
                           std::span<const SpacePolyhedron> polyhedra, std::size_t face_limit) {
    SolidsPicture(sites, cells, polyhedra, face_limit).write(out);
}

}  // namespace signum
