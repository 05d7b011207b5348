#pragma once
/// What the files of molecules have in common: which of several places of an atom is read, of what
/// element it is, and its radius.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "read_sites.hpp"

namespace signum {

/// Of a residue with alternate places the atoms of one letter belong together: under another one it
/// may even be of another type, with atoms of other names. Those of its first letter are read.
class AlternatePlaces {
 public:
    /// `residue` tells it from all others; `letter` is empty where an atom has one place.
    bool takes(const std::string& residue, std::string_view letter);
    [[nodiscard]] std::int64_t left_out() const noexcept { return left_out_; }

 private:
    std::map<std::string, std::string> letters_;
    std::int64_t left_out_ = 0;
};

/// The element of an atom that names none, by its name and that of its residue: CA of ALA is
/// carbon, SOD of SOD sodium, OG of SER oxygen, whatever its columns. `may_have_two`: where the
/// residue says nothing, the first two letters are an element's if there is one.
[[nodiscard]] std::string element_by_name(std::string_view residue, std::string_view name,
                                          bool may_have_two);

/// Elements that were taken from names.
class GuessedElements {
 public:
    void add(std::string_view element) { ++counts_[std::string(element)]; }
    /// What to say of them; empty where there is none.
    [[nodiscard]] std::string note() const;

 private:
    std::map<std::string, std::int64_t> counts_;
};

/// What the caller chose, else the element's van der Waals radius in Å (io/elements.hpp); nothing
/// where neither is there.
[[nodiscard]] std::optional<double> radius_of_element(const ReadOptions& options,
                                                      std::string_view element);

/// What to do about an element without a radius.
[[nodiscard]] std::string no_radius_of(std::string_view shown, std::string_view element);

/// FILE: the notes, one after the other; empty where there is none.
[[nodiscard]] std::string joined_note(const std::string& path,
                                      const std::vector<std::string>& notes);

}  // namespace signum
