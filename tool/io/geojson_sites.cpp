/// Points of GeoJSON (RFC 7946), alone or as features; what a feature's properties say is carried
/// along.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "json_events.hpp"
#include "nearest_word.hpp"
#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

class GeoJsonSites final : public JsonEvents {
 public:
    GeoJsonSites(InputFile& file, const ReadOptions& options)
        : JsonEvents(file,
                     "of GeoJSON points are read, such as {\"type\": \"Point\", "
                     "\"coordinates\": [x, y]}, alone, in features or in a collection"),
          options_(options),
          in_space_(options.dimension == 3) {
        result_.dimension = in_space_ ? 3 : 2;
    }

    SitesFile read() {
        parse();
        finish_feature();
        const std::size_t sites = result_.sites.size() + result_.in_space.size();
        if (sites == 0) fail({1, 1}, "no point in this file");
        std::vector<std::string> notes;
        result_.are_degrees = !in_space_ && !names_system_;
        if (result_.are_degrees)
            notes.emplace_back(
                "longitude is x and latitude is y, degrees that are taken for a plane's");
        if (heights_ > 0 && !in_space_)
            notes.push_back(
                fmt::format("heights are left out ({} of {} points); --dimension 3 takes "
                            "them for z",
                            heights_, sites));
        if (empty_ > 0)
            notes.push_back(fmt::format("{} feature{} no point {} left out", empty_,
                                        empty_ == 1 ? " that has" : "s that have",
                                        empty_ == 1 ? "is" : "are"));
        if (!notes.empty())
            result_.note = fmt::format("{}: {}", cursor().file().path(), fmt::join(notes, "; "));
        for (Attribute& each : result_.attributes) each.values.resize(sites);
        return std::move(result_);
    }

    bool start_object(std::size_t /*size*/) override {
        if (is_skipping()) return ++skipped_, true;
        if (coordinates_depth_ > 0) fail_at_structure("an object cannot stand within coordinates");
        if (is_in_properties()) return ++skipped_, true;
        const bool are_properties = !objects_.empty() && objects_.back().key == "properties";
        if (objects_.size() == most_depth)
            fail_at_structure("objects within objects within objects");
        objects_.push_back({.are_properties = are_properties, .place = cursor().structure()});
        return true;
    }
    bool key(std::string& text) override {
        if (!is_skipping()) objects_.back().key = text;
        if (objects_.size() == 1 && text == "crs") names_system_ = true;
        return true;
    }
    bool end_object() override {
        if (is_skipping()) return --skipped_, true;
        const Object object = std::move(objects_.back());
        objects_.pop_back();
        if (!object.are_properties) finish_object(object);
        return true;
    }
    bool start_array(std::size_t /*size*/) override {
        if (is_skipping()) return ++skipped_, true;
        if (objects_.empty()) fail_at_structure("an array cannot stand here");
        if (is_in_properties()) return ++skipped_, true;
        Object& object = objects_.back();
        if (object.key == "coordinates") {
            ++coordinates_depth_;
            object.depth = std::max(object.depth, coordinates_depth_);
            object.points.emplace_back();
            object.points.back().place = cursor().structure();
        } else if (object.key == "bbox") {
            ++skipped_;
        } else {
            ++arrays_;
        }
        return true;
    }
    bool end_array() override {
        if (is_skipping()) return --skipped_, true;
        if (coordinates_depth_ > 0)
            --coordinates_depth_;
        else
            --arrays_;
        return true;
    }
    bool null() override { return say_value("", true); }
    bool boolean(bool value) override { return say_value(value ? "true" : "false", false); }
    bool string(std::string& text) override {
        if (!is_skipping() && !is_in_properties() && !objects_.empty() &&
            objects_.back().key == "type") {
            objects_.back().type = text;
            return true;
        }
        return say_value(text, false);
    }
    bool number_integer(std::int64_t /*value*/) override { return add(cursor().value_text()); }
    bool number_unsigned(std::uint64_t /*value*/) override { return add(cursor().value_text()); }
    bool number_float(double /*value*/, const std::string& text) override {
        std::string plain = text;  // The parser writes the point of the locale.
        std::ranges::replace(plain, ',', '.');
        return add(plain);
    }

 private:
    struct Point {
        std::vector<double> x = {};
        Position place = {};
    };
    struct Object {
        std::string key = {};  ///< the last that was read
        std::string type = {};
        std::vector<Point> points = {};  ///< one an array within coordinates
        int depth = 0;                   ///< of these arrays
        bool are_properties = false;
        Position place = {};
    };

    [[nodiscard]] bool is_skipping() const noexcept { return skipped_ > 0; }
    [[nodiscard]] bool is_in_properties() const {
        return !objects_.empty() && objects_.back().are_properties;
    }

    bool add(const std::string& digits) {
        if (is_skipping()) return true;
        if (is_in_properties()) {
            const std::string name = in_small_letters(objects_.back().key);
            const auto third = std::ranges::find(names_of_third, name);
            if (third != names_of_third.end()) {
                third_ = number_of(digits);
                third_place_ = cursor().value();
                if (name != "r")
                    result_.third = name == "weight" ? WeightIs::weight : WeightIs::radius;
                return true;
            }
            return say_value(digits, true);
        }
        if (coordinates_depth_ == 0) return true;
        Point& point = objects_.back().points.back();
        if (point.x.size() == most_coordinates)
            fail_at_value("a point of more than four coordinates");
        point.x.push_back(number_of(digits));
        return true;
    }
    double number_of(const std::string& digits) const {
        const Number number = parse_number(digits);
        if (number.fault != NumberFault::none)
            cursor().file().fail(cursor().value(), explain(number.fault, digits));
        return number.value;
    }

    /// A property, if it is one.
    bool say_value(std::string_view text, bool is_number) {
        if (is_skipping() || !is_in_properties()) {
            if (coordinates_depth_ > 0) fail_at_value("coordinates are numbers");
            return true;
        }
        if (!options_.attributes) return true;
        const std::string& name = objects_.back().key;
        const auto [found, is_new] = attribute_of_.try_emplace(name, result_.attributes.size());
        if (is_new) {
            if (result_.attributes.size() == most_attributes)
                fail_at_value(fmt::format("more than {} names of properties", most_attributes));
            result_.attributes.push_back({name, {}});
        }
        values_[found->second] = text;
        if (!text.empty()) result_.attributes[found->second].is_number &= is_number;
        return true;
    }

    void finish_object(const Object& object) {
        const bool is_feature = object.type == "Feature";
        if (object.points.empty()) {
            if (is_feature) finish_feature();
            return;
        }
        const bool is_point = object.type == "Point" && object.depth == 1;
        if (!is_point && !(object.type == "MultiPoint" && object.depth <= 2))
            fail(object.place, object.type == "Point" || object.type == "MultiPoint"
                                   ? "coordinates of another shape than those of points"
                               : object.type.empty()
                                   ? "coordinates without a type"
                                   : fmt::format("a {} is no point", object.type));
        for (const Point& point : object.points) {
            if (point.x.empty() && !is_point) continue;  // the array about a MultiPoint's
            const std::size_t least = in_space_ ? 3 : 2;
            if (point.x.size() < least)
                fail(point.place, fmt::format("a point of less than {} coordinates", least));
            points_.push_back(point);
        }
    }

    /// All its points have its properties.
    void finish_feature() {
        if (points_.empty() && !objects_.empty()) ++empty_;
        for (const Point& point : points_) {
            if (point.x.size() > 2) ++heights_;
            const std::array<double, 4> numbers = {
                point.x[0], point.x[1], in_space_ ? point.x[2] : third_, in_space_ ? third_ : 0.0};
            result_.add(numbers, [&](std::size_t which) {
                return which < 2 || (in_space_ && which == 2) ? point.place : third_place_;
            });
            const std::size_t sites = result_.sites.size() + result_.in_space.size();
            for (const auto& [attribute, value] : values_) {
                result_.attributes[attribute].values.resize(sites);
                result_.attributes[attribute].values.back() = value;
            }
        }
        points_.clear();
        values_.clear();
        third_ = 0.0;
    }

    static constexpr std::array<std::string_view, 3> names_of_third = {"r", "radius", "weight"};
    static constexpr std::size_t most_depth = 100;
    static constexpr std::size_t most_coordinates = 4;
    static constexpr std::size_t most_attributes = 10'000;

    const ReadOptions& options_;
    bool in_space_;
    SitesFile result_;
    std::vector<Object> objects_;
    int arrays_ = 0;
    int skipped_ = 0;  ///< depth in what is not read
    int coordinates_depth_ = 0;
    bool names_system_ = false;  ///< another coordinate system than the one of RFC 7946
    std::vector<Point> points_;  ///< of the feature that is read
    double third_ = 0.0;
    Position third_place_;
    std::map<std::string, std::size_t> attribute_of_;
    std::map<std::size_t, std::string> values_;  ///< of the feature, by attribute
    std::size_t heights_ = 0;
    std::size_t empty_ = 0;
};

}  // namespace

SitesFile read_geojson_sites(InputFile& file, const ReadOptions& options) {
    return GeoJsonSites(file, options).read();
}

}  // namespace signum
