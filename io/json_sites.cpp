#include <algorithm>
#include <array>

#include "json_events.hpp"
#include "json_sites.hpp"
#include "number.hpp"

namespace signum {
namespace {

class JsonSites final : public JsonEvents {
 public:
    explicit JsonSites(InputFile& file)
        : JsonEvents(file, "sites are [[x, y, r], ...] with finite numbers") {}

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
        }
        return true;
    }
    bool end_array() override {
        if (depth_-- == 2) {
            if (size_ < 2) fail(start_, size_ == 0 ? "an empty site" : "a site of one number");
            result_.sites.push_back({numbers_[0], numbers_[1], size_ == 3 ? numbers_[2] : 0.0});
        }
        return true;
    }
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
    bool add(double value) {
        if (depth_ < 2) fail_at_value("a number outside of a site");
        if (size_ == numbers_.size()) fail_at_value("a fourth number in a site");
        numbers_[size_++] = value;
        return true;
    }

    SitesFile result_;
    int depth_ = 0;
    Position start_;  ///< of the site that is being read
    std::array<double, 3> numbers_ = {};
    std::size_t size_ = 0;
};

}  // namespace

SitesFile read_json_sites(InputFile& file) {
    return JsonSites(file).read();
}

}  // namespace signum
