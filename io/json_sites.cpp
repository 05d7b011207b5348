#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "json_events.hpp"
#include "json_sites.hpp"
#include "number.hpp"

namespace signum {
namespace {

class JsonSites final : public JsonEvents {
 public:
    JsonSites(InputFile& file, const Columns& chosen)
        : JsonEvents(file, "sites are [[x, y, r], ...] with finite numbers") {
        if (!chosen.empty()) choose(chosen);
    }

    SitesFile read() {
        parse();
        if (result_.sites.empty()) fail({}, "no site in this file");
        return std::move(result_);
    }

    bool start_array(std::size_t /*size*/) override {
        if (depth_ == 2) fail_at_structure("an array within a site");
        if (++depth_ == 2) {
            start_ = cursor().structure();
            size_ = 0;
            numbers_ = {};
        }
        return true;
    }
    bool end_array() override {
        if (depth_-- == 2) {
            if (size_ <= std::max(places_[0], places_[1])) {
                fail(start_, size_ == 0   ? "an empty site"
                             : size_ == 1 ? "a site of one number"
                                          : "a site that ends before x and y");
            }
            result_.sites.push_back({numbers_[0], numbers_[1], numbers_[2]});
        }
        return true;
    }
    bool null() override { return pass("null"); }
    bool boolean(bool value) override { return pass(value ? "true" : "false"); }
    bool string(std::string& /*text*/) override { return pass("a string"); }
    bool number_integer(std::int64_t value) override { return add(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) override { return add(static_cast<double>(value)); }
    bool number_float(double /*value*/, const std::string& text) override {
        // The parser writes the point of the locale.
        std::string plain = text;
        std::replace(plain.begin(), plain.end(), ',', '.');
        const Number number = parse_number(plain);
        if (number.fault != NumberFault::none) {
            cursor().file().fail(cursor().value(), explain(number.fault, plain));
        }
        return add(number.value);
    }

 private:
    /// Takes the places that the caller chose, from 1.
    void choose(const Columns& chosen) {
        places_ = {none, none, none};
        for (std::size_t which = 0; which < chosen.size(); ++which) {
            const std::optional<std::uint64_t> number = parse_whole_number(chosen[which]);
            if (!number || *number == 0) {
                cursor().file().fail(
                    {}, fmt::format("{} is chosen, and the numbers of a site in JSON have no "
                                    "names; choose by number, from 1",
                                    in_quotes(chosen[which])));
            }
            const std::size_t place = *number - 1;
            if (std::ranges::count(places_, place) > 0) {
                cursor().file().fail(
                    {}, fmt::format("number {} is chosen twice; x, y and r are different numbers",
                                    place + 1));
            }
            places_[which] = place;
        }
        most_ = none;
    }

    bool add(double value) {
        if (depth_ < 2) fail_at_value("a number outside of a site");
        if (size_ == most_) fail_at_value("a fourth number in a site");
        for (std::size_t which = 0; which < places_.size(); ++which) {
            if (places_[which] != size_) continue;
            numbers_[which] = value;
            if (which == 2 && value < 0.0 && !result_.first_negative) {
                result_.first_negative = cursor().value();
            }
            if (is_beyond_single(value) && !result_.first_beyond_single)
                result_.first_beyond_single = cursor().value();
        }
        ++size_;
        return true;
    }

    /// What is no number may stand where nobody chose it.
    bool pass(std::string_view what) {
        if (depth_ < 2 || most_ != none || std::ranges::count(places_, size_) > 0) {
            fail_at_value(fmt::format("{} cannot stand here", what));
        }
        ++size_;
        return true;
    }

    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    SitesFile result_;
    int depth_ = 0;
    Position start_;                                 ///< of the site that is being read
    std::array<double, 3> numbers_ = {};             ///< x, y and r of it
    std::size_t size_ = 0;                           ///< how many values it has so far
    std::array<std::size_t, 3> places_ = {0, 1, 2};  ///< of x, y and r in a site
    std::size_t most_ = 3;                           ///< values in a site, or none
};

}  // namespace

SitesFile read_json_sites(InputFile& file, const Columns& columns) {
    return JsonSites(file, columns).read();
}

}  // namespace signum
