#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "json_events.hpp"
#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

class JsonSites final : public JsonEvents {
 public:
    JsonSites(InputFile& file, const Columns& chosen, std::optional<int> dimension)
        : JsonEvents(file, dimension == 3 ? "sites are [[x, y, z, r], ...] with finite numbers"
                                          : "sites are [[x, y, r], ...] with finite numbers"),
          dimension_(dimension),
          is_told_(dimension) {
        if (!chosen.empty()) choose(chosen);
    }

    SitesFile read() {
        parse();
        if (!dimension_ || result_.sites.size() + result_.in_space.size() == 0)
            fail({}, "no site in this file");
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
            if (!dimension_) dimension_ = size_ == 4 ? 3 : 2;
            finish_site();
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
        if (!dimension_) dimension_ = chosen.size() == 4 ? 3 : 2;
        places_.fill(none);
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
                    {}, fmt::format("number {} is chosen twice; x, y{} and r are different numbers",
                                    place + 1, dimension_ == 3 ? ", z" : ""));
            }
            places_[which] = place;
        }
        any_number_ = true;
    }

    /// The most numbers in a site.
    [[nodiscard]] std::size_t most() const noexcept {
        return any_number_ ? none : dimension_ == 2 ? 3 : 4;
    }

    bool add(double value) {
        if (depth_ < 2) fail_at_value("a number outside of a site");
        if (size_ == most()) {
            fail_at_value(size_ == 4 ? "a fifth number in a site"
                          : is_told_
                              ? "a fourth number in a site, as those in space have it; those of "
                                "the plane are wanted here"
                              : "a fourth number in a site, where the first site has no "
                                "more than three; with --dimension 3 the third is z");
        }
        for (std::size_t which = 0; which < places_.size(); ++which) {
            if (places_[which] != size_) continue;
            numbers_[which] = value;
            positions_[which] = cursor().value();
            if (is_beyond_single(value) && !result_.first_beyond_single)
                result_.first_beyond_single = cursor().value();
        }
        ++size_;
        return true;
    }

    void finish_site() {
        const bool in_space = dimension_ == 3;
        const std::size_t coordinates = in_space ? 3 : 2;
        const auto last = *std::max_element(
            places_.begin(), places_.begin() + static_cast<std::ptrdiff_t>(coordinates));
        if (size_ <= last) {
            fail(start_, size_ == 0   ? "an empty site"
                         : size_ == 1 ? "a site of one number"
                         : in_space   ? "a site that ends before x, y and z"
                                      : "a site that ends before x and y");
        }
        result_.dimension = *dimension_;
        result_.add(numbers_, [&](std::size_t which) { return positions_[which]; });
    }

    /// What is no number may stand where nobody chose it.
    bool pass(std::string_view what) {
        if (depth_ < 2 || !any_number_ || std::ranges::count(places_, size_) > 0) {
            fail_at_value(fmt::format("{} cannot stand here", what));
        }
        ++size_;
        return true;
    }

    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    SitesFile result_;
    std::optional<int> dimension_;
    bool is_told_;  ///< the dimension, not taken from the first site
    int depth_ = 0;
    Position start_;                      ///< of the site that is being read
    std::array<double, 4> numbers_ = {};  ///< x, y, in space z, and r of it
    std::array<Position, 4> positions_ = {};
    std::size_t size_ = 0;                              ///< how many values it has so far
    std::array<std::size_t, 4> places_ = {0, 1, 2, 3};  ///< of numbers_ in a site
    bool any_number_ = false;                           ///< of values may be in a site
};

}  // namespace

SitesFile read_json_sites(InputFile& file, const ReadOptions& options) {
    return JsonSites(file, options.columns, options.dimension).read();
}

}  // namespace signum
