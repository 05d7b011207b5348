#pragma once
/// Tables 10.4.1 to 10.4.5 of the thesis (M. Gavrilova, Proximity and Applications in General
/// Metrics, Calgary 1998), as far as its scan can be read; NaN is what cannot. Of table 10.4.4 the
/// columns of 50 % and 70 % are missing, and of the last row all but the times.

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

namespace signum::study::thesis {

inline constexpr double unread = std::numeric_limits<double>::quiet_NaN();

/// Of a structure at one packing.
struct Effort {
    double seconds;
    double events;  ///< "topological events"
    double checks;
};
inline constexpr std::array packings = {0.05, 0.2, 0.33, 0.5, 0.7};
struct Line {
    std::string_view structure;  ///< our name of it
    std::string_view name;       ///< the thesis's
    std::array<Effort, packings.size()> at;
};
struct PackingTable {
    double size_ratio;
    std::array<std::string_view, packings.size()> radii;
    std::array<double, packings.size()> strikes;
    std::array<double, packings.size()> predictions;
    std::array<Line, 5> lines;

    /// Of a structure that it has.
    [[nodiscard]] constexpr const Effort& at_packing(std::string_view structure,
                                                     std::size_t packing) const {
        std::size_t i = 0;
        while (lines[i].structure != structure) ++i;
        return lines[i].at[packing];
    }
};

/// Tables 10.4.1 and 10.4.2.
inline constexpr PackingTable one_size = {1.0,
                                          {"2.5", "5", "6.5", "8", "9.5"},
                                          {174, 387, 661, 1143, 4170},
                                          {199855, 199459, 198941, 198009, 192371},
                                          {{{"pairs",
                                             "straightforward",
                                             {{{1114.61, 0, 20645172},
                                               {1149.92, 0, 20712569},
                                               {1218.85, 0, 20783008},
                                               {1181.12, 0, 20949474},
                                               {1255.10, 0, 21899782}}}},
                                            {"cells",
                                             "regular subdivision",
                                             {{{96.50, 1718, 93137},
                                               {107.82, 825, 352322},
                                               {117.71, 582, 625788},
                                               {137.04, 569, 1036721},
                                               {166.15, 759, 1443880}}}},
                                            {"tree",
                                             "spatial tree",
                                             {{{103.04, 1718, 93137},
                                               {112.60, 825, 352322},
                                               {128.36, 582, 625788},
                                               {149.40, 569, 1036721},
                                               {171.81, 759, 1443880}}}},
                                            {"segments",
                                             "segment tree",
                                             {{{106.94, 13038, 11542},
                                               {116.33, 13324, 52610},
                                               {121.72, 13362, 116468},
                                               {129.68, 14466, 226571},
                                               {151.87, 30094, 337770}}}},
                                            {"delaunay",
                                             "dynamic power diagram",
                                             {{{304.84, 778, 1926240},
                                               {317.74, 604, 1922883},
                                               {312.64, 601, 1925194},
                                               {320.92, 482, 1929483},
                                               {333.89, 770, 1979036}}}}}}};

/// Tables 10.4.3 and 10.4.4.
inline constexpr PackingTable many_sizes = {10.0,
                                            {"0.4–4", "1–10", "1.8–18", "3–27", "5–50"},
                                            {189, 375, 488, 695, 3127},
                                            {199816, 199416, 199209, 198912, 220282},
                                            {{{"pairs",
                                               "straightforward",
                                               {{{1332.66, 0, 20657627},
                                                 {1330.30, 0, 20713235},
                                                 {1284.71, 0, 20741959},
                                                 {unread, unread, unread},
                                                 {unread, unread, unread}}}},
                                              {"cells",
                                               "regular subdivision",
                                               {{{103.26, 1161, 298667},
                                                 {147.31, 413, 1523006},
                                                 {242.66, 257, 3648103},
                                                 {unread, unread, unread},
                                                 {unread, unread, unread}}}},
                                              {"tree",
                                               "spatial tree",
                                               {{{111.99, 1161, 298667},
                                                 {156.75, 413, 1523006},
                                                 {247.72, 257, 3648103},
                                                 {unread, unread, unread},
                                                 {unread, unread, unread}}}},
                                              {"segments",
                                               "segment tree",
                                               {{{109.68, 12432, 14154},
                                                 {121.49, 11927, 52167},
                                                 {121.77, 11050, 91584},
                                                 {unread, unread, unread},
                                                 {unread, unread, unread}}}},
                                              {"delaunay",
                                               "dynamic power diagram",
                                               {{{303.85, unread, unread},
                                                 {308.47, unread, unread},
                                                 {318.73, unread, unread},
                                                 {unread, unread, unread},
                                                 {unread, unread, unread}}}}}}};

/// Table 10.4.5. Its times are a figure (10.4.3), of which the scan has no numbers.
inline constexpr std::array numbers = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
inline constexpr std::array densities = {4.5, 8.5, 12.5, 15.0, 20.0, 23.0, 26.5, 31.0, 33.5, 35.0};
inline constexpr std::array strikes_by_number = {3, 5, 8, 24, 31, 52, 47, 79, 121, 128};
inline constexpr std::array predictions_by_number = {4014,  8021,  12026, 16006, 20000,
                                                     23985, 27972, 31902, 35871, 39854};

}  // namespace signum::study::thesis
