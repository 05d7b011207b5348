#pragma once
/// The sites of a picture: outlines in true size with a number of their own under the pointer, dots
/// for centres and crosses for those of hidden sites, crowds.

#include "../../triangulation/tessellation.hpp"
#include "frame.hpp"
#include "legend.hpp"
#include "shapes.hpp"
#include "style.hpp"
#include "svg_text.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace signum {

/// The sites as they are drawn: radii in the plane, at least 0.
[[nodiscard]] std::vector<Site> drawn_sites(const Tessellation& tessellation);

class DrawnSites {
 public:
    /// Of more than `limit` sites the smallest become dots without a number. Nothing is copied.
    DrawnSites(const Tessellation& tessellation, const Frame& frame, const Pens& pens,
               std::size_t limit);

    /// The outlines, the largest first, so that every site can be reached by the pointer.
    void write_outlines(SvgText& text) const;
    /// Centres, and the sites too small for an outline.
    void write_dots(SvgText& text) const;
    void describe(Legend& legend) const;
    /// The sites whose centres are in the picture.
    [[nodiscard]] std::vector<Index> centred_in_picture() const;

    [[nodiscard]] bool is_hidden(std::size_t site) const { return hidden_by_[site] != infinite; }
    [[nodiscard]] Point centre(Index site) const {
        const Site& s = tessellation_.sites()[static_cast<std::size_t>(site)];
        return frame_.at({s.x, s.y});
    }

 private:
    void write_crowd(SvgText& text, bool hidden) const;
    void write_outline(SvgText& text, std::size_t site) const;
    void write_title(SvgText& text, std::size_t site) const;
    /// How far a site's centre is from the nearest point of the picture, and from the farthest.
    [[nodiscard]] double nearest(std::size_t site) const;
    [[nodiscard]] double farthest(std::size_t site) const;
    [[nodiscard]] bool is_in_picture(std::size_t site) const;

    const Tessellation& tessellation_;
    const Frame& frame_;
    const Pens& pens_;
    const Shapes& shapes_;
    std::vector<Index> hidden_by_;  // -1 for a visible site
    std::vector<double> radii_;     // in pixels
    double smallest_ = 0.0;         // smaller sites are dots without a number
};

}  // namespace signum
