#pragma once
/// Sites as text, one a line: x y [r], in space x y z [r].

#include <cstddef>
#include <optional>
#include <string>

#include "input_file.hpp"
#include "read_sites.hpp"
#include "text_columns.hpp"

namespace signum {

/// Reads all sites of an open file, of 2 or 3 dimensions or of those that its header or the columns
/// tell. Throws InputError.
[[nodiscard]] SitesFile read_text_sites(InputFile& file, const ReadOptions& options);

/// Sites whose lines end before a column of radii or weights that a header names, or that somebody
/// chose: without one it is 0, and the note says so.
class MissingRadii {
 public:
    /// That of the line at which `lines` stand.
    void add(const TextColumns& lines) {
        if (count_++ == 0) place_ = lines.place_of_line();
    }
    /// To be called once, when all sites have been read.
    void note_in(SitesFile& file) const;

 private:
    std::size_t count_ = 0;
    std::string place_;  ///< of the first one
};

/// What the name of a column of radii or weights, in small letters, says about its numbers.
[[nodiscard]] std::optional<WeightIs> meaning_of_column(std::string_view name);

/// Those of space. `lines` stands at the first line, which has_header says is a header.
[[nodiscard]] SitesFile read_text_sites_in_space(TextColumns& lines, const ReadOptions& options,
                                                 bool has_header);

}  // namespace signum
