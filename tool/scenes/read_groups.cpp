#include "read_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <variant>

#include <fmt/format.h>

#include "../generate/uniform.hpp"
#include "../io/input_file.hpp"
#include "../io/motion_state.hpp"
#include "../io/read_balls.hpp"
#include "../io/read_xyz.hpp"
#include "arrangement.hpp"
#include "normal.hpp"
#include "overlaps.hpp"
#include "read_effects.hpp"
#include "snapshot.hpp"

namespace signum {
namespace {

using motion::Body;
using motion::Vector;

constexpr std::size_t most_balls = 10'000'000;

/// A group is one of these three; which keys it then cannot have.
enum class Source { file, list, made };
Source source_of(const Section& group) {
    const bool has_file = group.has("file");
    const bool has_list = group.has("list");
    if (has_file && has_list)
        group.fail_at("list",
                      "beside a file; give one of them, and the other in a group of its "
                      "own, [[balls]]");
    for (const std::string_view key : {"number", "radius", "sizes", "packing", "speed",
                                       "temperature", "seed", "arrangement", "region"})
        if ((has_file || has_list) && group.has(key))
            group.fail_at(key, fmt::format("is for balls that are made, and these are those of a "
                                           "{}; leave it out",
                                           has_file ? "file" : "list"));
    return has_file ? Source::file : has_list ? Source::list : Source::made;
}

std::vector<Section> groups_of(const Section& file) {
    std::vector<Section> groups = file.sections("balls");
    if (groups.empty()) file.fail("no balls; add [balls] with a file, a list, or a number of them");
    return groups;
}

/// The file of a group. Fails where it is not there.
std::string existing_path_of(const Section& group) {
    const std::filesystem::path name(group.optional_text("file"));
    const std::filesystem::path here(group.document().path());
    const std::string path =
        name.is_absolute() ? name.string() : (here.parent_path() / name).string();
    std::error_code error;
    const bool exists = std::filesystem::exists(path, error);
    if (error) group.fail_at("file", fmt::format("cannot read {}: {}", path, error.message()));
    if (!exists)
        group.fail_at(
            "file",
            fmt::format("there is no {}; names are relative to the scene's own directory", path));
    return path;
}

const toml::array& rows_of(const Section& group) {
    const toml::array* const rows = group.find("list")->as_array();
    if (rows == nullptr || rows->empty())
        group.fail_at("list", "no balls; write a ball an entry, as in list = [[x, y, r, vx, vy]]");
    return *rows;
}

template <int D>
Dimension density_dimension() {
    return {.length = -D, .mass = 1};
}
/// Of a ball by its radius: that of its area or volume at the group's density, and r^D where there
/// is none.
template <int D>
class Masses {
 public:
    explicit Masses(const Section& group)
        : density_(group.optional<double>("density", {density_dimension<D>(), above_0})) {}
    [[nodiscard]] double operator()(double radius) const {
        const double power = mass_of_radius(radius, D);
        return density_ ? *density_ * (motion::ball_volume<D>(1.0) * power) : power;
    }

 private:
    std::optional<double> density_;
};

/// What balls.file may name.
enum class FileKind { lines, state, frames };
FileKind kind_of_file(const std::string& path) {
    std::error_code ignored;
    // A pipe can be read but once.
    if (!std::filesystem::is_regular_file(path, ignored)) return FileKind::lines;
    const InputFile file(path, "a file of balls");
    if (file.first_character() == '{') return FileKind::state;
    return looks_like_frames(file.first_bytes()) ? FileKind::frames : FileKind::lines;
}
int dimension_of_file(const std::string& path) {
    switch (kind_of_file(path)) {
        case FileKind::state:
            return dimension_of_motion_state(path);
        case FileKind::frames:
            return read_last_frame(path).dimension;
        case FileKind::lines:
            break;
    }
    return read_balls(path).dimension;
}

/// A run may leave what start() takes for too small to be meant.
double or_0(double value) {
    return std::fabs(value) < 0x1p-150 ? 0.0 : value;
}

template <int D>
class Groups {
 public:
    Groups(const Section& file, const motion::Effects<D>& effects)
        : file_(file), effects_(effects) {}

    BallsOfScene<D> read() {
        for (const Section& group : groups_of(file_)) {
            switch (source_of(group)) {
                case Source::file:
                    read_file(group);
                    break;
                case Source::list:
                    read_list(group);
                    break;
                case Source::made:
                    make(group);
                    break;
            }
            ++group_;
        }
        return std::move(result_);
    }

 private:
    void begin_at(ScenePlace place, bool is_made = false) {
        result_.origins.push_back({result_.bodies.size(), std::move(place), is_made});
    }

    void read_file(const Section& group) {
        const std::string path = existing_path_of(group);
        const FileKind kind = kind_of_file(path);
        if (kind != FileKind::frames && group.has("density"))
            group.fail_at("density",
                          "is for balls that are made or listed; a file says the masses");
        begin_at({path, {}, ""});
        const std::size_t first = result_.bodies.size();
        if (kind == FileKind::state) {
            refuse_other_dimension(group, path, dimension_of_motion_state(path));
            take_state(checked_motion_state<D>(path));
        } else if (kind == FileKind::frames) {
            const BallsFile file = read_last_frame(path);
            // In space all may lie in one plane.
            if (file.dimension == 3) refuse_other_dimension(group, path, 3);
            take_frame(group, file);
        } else {
            const BallsFile file = read_balls(path);
            refuse_other_dimension(group, path, file.dimension);
            take_lines(file);
            if (!file.note.empty()) result_.notes.push_back(file.note);
        }
        if (kind != FileKind::lines) part(std::span(result_.bodies).subspan(first), effects_);
        result_.files.push_back(path);
    }

    static void refuse_other_dimension(const Section& group, const std::string& path,
                                       int dimension) {
        if (dimension != D)
            group.fail_at("file",
                          fmt::format("the balls of {} lie in {}, and the scene in {}; give one "
                                      "dimension to both",
                                      path, dimension == 2 ? "the plane" : "space",
                                      D == 2 ? "the plane" : "space"));
    }

    void take_lines(const BallsFile& file) {
        for (const BallLine& ball : file.balls) {
            result_.origins.back().lines.push_back(ball.position);
            Body<D>& body = result_.bodies.emplace_back();
            std::copy_n(ball.x.begin(), D, body.x.begin());
            std::copy_n(ball.v.begin(), D, body.v.begin());
            body.radius = ball.radius;
            body.mass = ball.mass;
        }
    }

    void take_frame(const Section& group, const BallsFile& file) {
        const std::size_t first = result_.bodies.size();
        take_lines(file);
        const Masses<D> mass(group);
        for (Body<D>& body : std::span(result_.bodies).subspan(first)) {
            if (body.radius == 0.0)
                result_.fail(static_cast<std::size_t>(&body - result_.bodies.data()),
                             "a ball of radius 0, which needs a mass, and frames have none; give a "
                             "state, or lines of balls");
            body.mass = mass(body.radius);
            for (double& x : body.x) x = or_0(x);
            for (double& v : body.v) v = or_0(v);
        }
    }

    /// As they are at the state's time.
    void take_state(const MotionState<D>& saved) {
        result_.origins.back().is_of_state = true;
        Snapshot<D> snapshot(saved.state, saved.effects, saved.state.time);
        std::size_t i = 0;
        for (const MotionFrame::Ball& ball : snapshot.frame().balls) {
            Body<D>& body = result_.bodies.emplace_back();
            std::ranges::transform(std::span(ball.x).first(D), body.x.begin(), or_0);
            std::ranges::transform(std::span(ball.v).first(D), body.v.begin(), or_0);
            body.radius = ball.radius;
            body.mass = saved.state.masses[i];
            if (effects_.friction && !saved.state.spins.empty())
                std::ranges::transform(saved.state.spins[i], body.spin.begin(), or_0);
            ++i;
        }
    }

    void read_list(const Section& group) {
        const Masses<D> mass(group);
        for (const toml::node& node : rows_of(group)) {
            const toml::array* const row = node.as_array();
            constexpr std::size_t least = 2 * D + 1;
            constexpr std::size_t most = least + 1 + (D == 2 ? 1 : 3);
            const std::size_t size = row == nullptr ? 0 : row->size();
            if (size != least && size != least + 1 && size != most)
                group.document().fail(
                    node.source(),
                    fmt::format("list: {}, and a ball in {}; write {}",
                                row == nullptr ? std::string(kind_of(node))
                                               : fmt::format("{} entries", size),
                                D == 2 ? "the plane has 5, 6 or 7" : "space has 7, 8 or 11",
                                D == 2 ? "[x, y, r, vx, vy, mass, spin]"
                                       : "[x, y, z, r, vx, vy, vz, mass, sx, sy, sz]"));
            const auto number = [&](std::size_t i, const Quantity& quantity) {
                return read_value<double>(group.document(), (*row)[i], "list", quantity);
            };
            Body<D> body;
            for (int k = 0; k < D; ++k) {
                const auto axis = static_cast<std::size_t>(k);
                body.x[k] = number(axis, {dimensions::length});
                body.v[k] = number(D + 1 + axis, {dimensions::speed});
            }
            body.radius = number(D, {dimensions::length, from_0});
            if (row->size() == least && body.radius == 0.0)
                group.document().fail((*row)[D].source(),
                                      "list: a ball of radius 0 needs a mass; write it as one more "
                                      "entry, the last");
            body.mass = row->size() > least ? number(least, {dimensions::mass, above_0})
                                            : mass(body.radius);
            for (std::size_t i = least + 1; i < row->size(); ++i) {
                double& spin = body.spin[static_cast<int>(i - least) - 1];
                spin = number(i, {dimensions::angular_speed});
                if (spin != 0.0 && !effects_.friction)
                    group.document().fail((*row)[i].source(),
                                          "list: a spin, and nothing that would heed it; add "
                                          "[effects.friction], or leave the spin out");
            }
            begin_at(group.document().place_of(node.source()));
            result_.bodies.push_back(body);
        }
    }

    /// Of the group's own stream of random numbers, one for each purpose.
    [[nodiscard]] std::uint64_t seed_for(const Section& group, std::uint64_t purpose) const {
        const std::uint64_t seed =
            group.optional_whole("seed", 0, std::uint64_t{1} << 62).value_or(1);
        return (seed * 1'000'003 + group_) * 8 + purpose;
    }

    Region<D> region_of(const Section& group) const {
        Region<D> region;
        if (const auto section = group.optional_section("region")) {
            region.box = read_box<D>(*section);
            refuse_region_outside(group, region.box);
            region.volume = region.box.volume();
            return region;
        }
        if (effects_.box) {
            region.box = box_at(*effects_.box, effects_, 0.0);
            region.periodic = effects_.periodic;
            region.volume = region.box.volume();
            return region;
        }
        for (const auto& obstacle : effects_.obstacles) {
            const auto* const sphere = std::get_if<motion::Sphere<D>>(&obstacle);
            if (sphere == nullptr || sphere->side != motion::Sphere<D>::Side::inside) continue;
            for (int k = 0; k < D; ++k) {
                region.box.low[k] = sphere->centre[k] - sphere->radius;
                region.box.high[k] = sphere->centre[k] + sphere->radius;
            }
            region.volume = motion::ball_volume<D>(1.0) * power(sphere->radius);
            return region;
        }
        group.fail(
            "no place to put the balls; add a box, a wall around them, or region = {low = "
            "[0, 0], high = [1, 1]}");
    }

    void refuse_region_outside(const Section& group, const motion::Box<D>& region) const {
        if (!effects_.box) return;
        for (int k = 0; k < D; ++k)
            if (region.low[k] < effects_.box->low[k] || region.high[k] > effects_.box->high[k])
                group.fail_at("region",
                              fmt::format("goes beyond the box along {}, {} to {}; give one inside "
                                          "it",
                                          "xyz"[k], effects_.box->low[k], effects_.box->high[k]));
    }

    static double power(double radius) {
        return D == 2 ? radius * radius : radius * radius * radius;
    }

    /// By Newton's steps from above: libraries round theirs differently, and radii are to be the
    /// same on every machine.
    static double cube_root(double x) {
        double root = std::max(x, 1.0);
        for (;;) {
            const double next = root - (root - x / (root * root)) / 3.0;
            if (!(next < root)) return root;
            root = next;
        }
    }

    /// Radii in [from, to], one after the other.
    class Radii {
     public:
        Radii(double from, double to, bool fills_alike, std::uint64_t seed)
            : from_(from), to_(to), fills_alike_(fills_alike), uniform_(seed) {}
        double operator()() {
            if (from_ == to_) return from_;
            const double u = uniform_();
            double radius = 0.0;
            if (!fills_alike_) {
                radius = from_ + u * (to_ - from_);
            } else if (D == 2) {
                // As many of a radius as it has parts of the area, r^-2: 1/r is uniform.
                radius = 1.0 / (1.0 / from_ - u * (1.0 / from_ - 1.0 / to_));
            } else {
                // r^-3: 1/r² is uniform.
                const double low = 1.0 / (from_ * from_);
                const double high = 1.0 / (to_ * to_);
                radius = 1.0 / std::sqrt(low - u * (low - high));
            }
            return std::clamp(radius, from_, to_);
        }

     private:
        double from_;
        double to_;
        bool fills_alike_;
        Uniform uniform_;
    };

    Radii radii_of(const Section& group) const {
        double from = 1.0;
        double to = 1.0;
        if (const toml::node* const node = group.find("radius")) {
            if (const toml::array* const range = node->as_array()) {
                if (range->size() != 2)
                    group.fail_at("radius", fmt::format("{} numbers; a range is [least, largest]",
                                                        range->size()));
                from = read_value<double>(group.document(), (*range)[0], "radius",
                                          {dimensions::length, above_0});
                to = read_value<double>(group.document(), (*range)[1], "radius",
                                        {dimensions::length, above_0});
                if (from > to)
                    group.fail_at("radius", fmt::format("the range goes from {} down to {}; write "
                                                        "the least one first",
                                                        from, to));
            } else {
                from = to = group.required<double>("radius", {dimensions::length, above_0}, "");
            }
        }
        const std::array<std::string, 2> words = {"uniform", D == 2 ? "area" : "volume"};
        const auto sizes = group.optional_word("sizes", words);
        if (sizes && from == to)
            group.fail_at("sizes",
                          "says how radii are spread over a range; give radius = [least, "
                          "largest], or leave sizes out");
        return Radii(from, to, sizes && *sizes == words[1], seed_for(group, 0));
    }

    std::vector<double> radii_to_place(const Section& group, const Region<D>& region) const {
        const auto number = group.optional_whole("number", 1, most_balls);
        const auto packing = group.optional<double>(
            "packing", {dimensions::number, {0.0, 0.95, true, "a share above 0, at most 0.95"}});
        const bool has_radius = group.has("radius");
        if (!number && !packing && !has_radius)
            group.fail("no balls; give a file, a list, or a number with a radius or a packing");
        if (number && !packing && !has_radius)
            group.fail("neither radius nor packing; one of them says how large the balls are");
        if (!number && !(packing && has_radius))
            group.fail("number is missing; give it, or both radius and packing, which tell it");
        Radii radius = radii_of(group);
        std::vector<double> radii;
        double filled = 0.0;
        const double wanted = packing.value_or(0.0) * region.volume / motion::ball_volume<D>(1.0);
        while (number ? radii.size() < *number : true) {
            const double next = radius();
            if (!number && filled + power(next) > wanted) break;
            filled += power(next);
            radii.push_back(next);
            if (radii.size() > most_balls)
                group.fail("more than 10 million balls fill that share; give larger radii");
        }
        if (radii.empty())
            group.fail_at("packing",
                          "less than one ball fills; give a larger packing, or smaller "
                          "radii");
        if (number && packing) {
            const double ratio = wanted / filled;
            const double scale = D == 2 ? std::sqrt(ratio) : cube_root(ratio);
            for (double& each : radii) each *= scale;
        }
        return radii;
    }

    void make(const Section& group) {
        const Region<D> region = region_of(group);
        const std::vector<double> radii = radii_to_place(group, region);
        static const std::array<std::string, 3> arrangements = {"random", "lattice", "growth"};
        const std::string arrangement =
            group.optional_word("arrangement", arrangements).value_or("random");
        const Surroundings<D> surroundings{result_.bodies, effects_.obstacles};
        std::vector<Vector<D>> centres;
        try {
            centres = arrangement == "lattice" ? place_on_lattice<D>(region, radii, surroundings)
                      : arrangement == "growth"
                          ? place_by_growth<D>(region, radii, surroundings, seed_for(group, 1))
                          : place_by_chance<D>(region, radii, surroundings, seed_for(group, 1));
        } catch (const NoPlaceError& error) {
            group.fail(error.what());
        }
        const Masses<D> mass(group);
        begin_at(group.place(), true);
        const std::size_t first = result_.bodies.size();
        for (std::size_t i = 0; i < radii.size(); ++i)
            result_.bodies.push_back({centres[i], {}, radii[i], mass(radii[i]), {}});
        set_velocities(group, std::span(result_.bodies).subspan(first));
    }

    void set_velocities(const Section& group, std::span<Body<D>> bodies) const {
        const auto one_speed = group.optional<double>("speed", {dimensions::speed, from_0});
        const auto temperature =
            group.optional<double>("temperature", {dimensions::energy, from_0});
        if (one_speed && temperature)
            group.fail_at("temperature", "beside speed; give one of them");
        Normal normal(seed_for(group, 2));
        if (one_speed) {
            for (Body<D>& body : bodies) {
                for (double& v : body.v) v = normal();
                body.v = *one_speed / norm(body.v) * body.v;
            }
        }
        if (!temperature || *temperature == 0.0) return;
        if (bodies.size() < 2)
            group.fail_at("temperature",
                          "of one ball, whose momentum is to be 0; give speed, or "
                          "more balls");
        draw_maxwell(bodies, *temperature, normal);
    }

    /// Momentum 0, and a kinetic energy of D/2 temperatures a ball, both but for rounding.
    static void draw_maxwell(std::span<Body<D>> bodies, double temperature, Normal& normal) {
        Vector<D> momentum{};
        double mass_of_all = 0.0;
        for (Body<D>& body : bodies) {
            for (int k = 0; k < D; ++k) {
                body.v[k] = normal() / std::sqrt(body.mass);
                momentum[k] += body.mass * body.v[k];
            }
            mass_of_all += body.mass;
        }
        double twice_kinetic = 0.0;
        for (Body<D>& body : bodies) {
            for (int k = 0; k < D; ++k) {
                body.v[k] -= momentum[k] / mass_of_all;
                twice_kinetic += body.mass * body.v[k] * body.v[k];
            }
        }
        const double scale =
            std::sqrt(D * static_cast<double>(bodies.size()) * temperature / twice_kinetic);
        for (Body<D>& body : bodies)
            for (double& v : body.v) v *= scale;
    }

    const Section& file_;
    const motion::Effects<D>& effects_;
    BallsOfScene<D> result_;
    std::uint64_t group_ = 0;
};

int dimension_of_list(const Section& group) {
    const toml::array& rows = rows_of(group);
    const toml::array* const row = rows[0].as_array();
    if (row == nullptr) return 0;
    if (row->size() == 5 || row->size() == 6) return 2;
    // Seven may be either.
    return row->size() == 8 || row->size() == 11 ? 3 : 0;
}

}  // namespace

template <int D>
void BallsOfScene<D>::fail(std::size_t ball, std::string_view message) const {
    const auto after = std::ranges::upper_bound(origins, ball, {}, &Origin::first);
    const Origin& origin = *std::prev(after);
    if (!origin.lines.empty())
        throw InputError(origin.place.file, origin.lines[ball - origin.first], message);
    if (origin.is_of_state)
        throw InputError(origin.place.file,
                         fmt::format("ball {}: {}", ball - origin.first, message));
    if (!origin.is_made) origin.place.fail(message);
    origin.place.fail(
        fmt::format("[balls]: ball {} of the group: {}", ball - origin.first, message));
}

template <int D>
BallsOfScene<D> read_groups(const Section& file, const motion::Effects<D>& effects) {
    return Groups<D>(file, effects).read();
}

int dimension_of_groups(const Section& file) {
    for (const Section& group : groups_of(file)) {
        int dimension = 0;
        switch (source_of(group)) {
            case Source::file:
                dimension = dimension_of_file(existing_path_of(group));
                break;
            case Source::list:
                dimension = dimension_of_list(group);
                break;
            case Source::made:
                if (const auto region = group.optional_section("region"))
                    if (const toml::node* const low = region->find("low"))
                        if (const toml::array* const array = low->as_array())
                            dimension = static_cast<int>(array->size());
                break;
        }
        if (dimension == 2 || dimension == 3) return dimension;
    }
    return 0;
}

template struct BallsOfScene<2>;
template struct BallsOfScene<3>;
template BallsOfScene<2> read_groups(const Section&, const motion::Effects<2>&);
template BallsOfScene<3> read_groups(const Section&, const motion::Effects<3>&);

}  // namespace signum
