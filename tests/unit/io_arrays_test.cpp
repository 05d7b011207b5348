/// Sites from arrays of numbers: NumPy's .npy and doubles without a head; and arrays of faces.

#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../../tool/io/read_sites.hpp"
#include "../../tool/io/write_sites.hpp"
#include "../../tool/io/write_tessellation.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"

#include "io_refusal.hpp"
#include "io_scratch.hpp"

namespace signum {
namespace {

using namespace std::string_literals;
using Sites = std::vector<Site>;
using Sites3 = std::vector<Site3>;

const Sites hard = {{0.1, 4.9e-324, 1}, {1.7976931348623157e308, -0.0, 2}, {1. / 3, 5, 0}};
const Sites3 corner = {{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 2, 1}, {2, 2, 2, 1.5}};

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers, bool are_swapped = false) {
    std::string result;
    for (const Number number : numbers) {
        std::string bytes(sizeof number, '\0');
        std::memcpy(bytes.data(), &number, sizeof number);
        if (are_swapped) bytes.assign(bytes.rbegin(), bytes.rend());
        result += bytes;
    }
    return result;
}

std::string with_head(std::string_view dictionary, const std::string& numbers, char version = 1) {
    const auto length = static_cast<unsigned>(dictionary.size());
    std::string head = "\x93NUMPY"s + version + '\0';
    for (int digit = 0; digit < (version == 1 ? 2 : 4); ++digit)
        head += static_cast<char>(length >> 8 * digit);
    return head.append(dictionary) + numbers;
}
std::string array(std::string_view type, std::string_view shape, const std::string& numbers,
                  std::string_view is_by_columns = "False") {
    return with_head(fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': {}, }}    \n",
                                 type, is_by_columns, shape),
                     numbers);
}

SitesFile read(std::string_view contents, ReadOptions options = {}) {
    if (options.input == SitesInput::text) options.input = SitesInput::npy;
    const test::Scratch scratch;
    return read_sites(scratch.file("f", contents), options);
}
std::string wrong(std::string_view contents, ReadOptions options = {}) {
    if (options.input == SitesInput::text) options.input = SitesInput::npy;
    return test::refusal(contents,
                         [&](const std::string& path) { return read_sites(path, options); });
}

template <class Number>
void expect_type(std::string_view name) {
    const std::vector<Number> numbers = {0, 1, 2, 30, 40, 50};
    for (const bool is_swapped : {false, true}) {
        const auto type = fmt::format("{}{}", is_swapped ? '>' : '<', name);
        EXPECT_EQ(read(array(type, "(2, 3)", bytes_of(numbers, is_swapped))).sites,
                  (Sites{{0, 1, 2}, {30, 40, 50}}))
            << type;
    }
}

TEST(NpySites, OfEveryTypeAndOrderOfBytes) {
    expect_type<double>("f8");
    expect_type<float>("f4");
    expect_type<std::int8_t>("i1");
    expect_type<std::int16_t>("i2");
    expect_type<std::int32_t>("i4");
    expect_type<std::int64_t>("i8");
    expect_type<std::uint8_t>("u1");
    expect_type<std::uint16_t>("u2");
    expect_type<std::uint32_t>("u4");
    expect_type<std::uint64_t>("u8");
    EXPECT_EQ(read(array("|i1", "(1, 2)", "\x01\xFF")).sites, (Sites{{1, -1, 0}}));
    EXPECT_EQ(
        read(array("<u8", "(1, 2)", bytes_of<std::uint64_t>({~0ULL, (1ULL << 53) + 1}))).sites,
        (Sites{{0x1p64, 0x1p53, 0}}))
        << "to the nearest double";
}

TEST(NpySites, ByRowsAndByColumns) {
    const auto numbers = bytes_of<double>({1, 2, 3, 4, 5, 6});
    EXPECT_EQ(read(array("<f8", "(3, 2)", numbers)).sites,
              (Sites{{1, 2, 0}, {3, 4, 0}, {5, 6, 0}}));
    EXPECT_EQ(read(array("<f8", "(3, 2)", numbers, "True")).sites,
              (Sites{{1, 4, 0}, {2, 5, 0}, {3, 6, 0}}));
    EXPECT_EQ(read(array("<f8", "(2, 3)", numbers, "True"), {.columns = {"3", "1"}}).sites,
              (Sites{{5, 1, 0}, {6, 2, 0}}));
    EXPECT_EQ(read(array("<f8", "(2, 3)", numbers), {.dimension = 3}).in_space,
              (Sites3{{1, 2, 3, 0}, {4, 5, 6, 0}}));
    EXPECT_EQ(read(array("<f8", "(1, 6)", numbers), {.columns = {"6", "5", "4", "1"}}).in_space,
              (Sites3{{6, 5, 4, 1}}));
    const SitesFile space = read(array("<f8", "(1, 4)", numbers.substr(16)));
    EXPECT_EQ(space.dimension, 3);
    EXPECT_EQ(space.in_space, (Sites3{{3, 4, 5, 6}}));
    EXPECT_TRUE(read(array("<f8", "(2, 3)", numbers)).third_may_be_z);
    EXPECT_FALSE(read(array("<f8", "(2, 3)", numbers), {.dimension = 2}).third_may_be_z);
}

TEST(NpySites, HeadsOfEveryVersionAndLayout) {
    const auto numbers = bytes_of<double>({1, 2});
    const std::string_view head = "{\"shape\":(1,2),'fortran_order':False,'descr':'=f8'}";
    for (const char version : {'\x01', '\x02', '\x03'})
        EXPECT_EQ(read(with_head(head, numbers, version)).sites, (Sites{{1, 2, 0}}));
    for (const std::string_view broken :
         {"", "{", "{}", "{'shape': (1, 2), 'descr': '<f8'}", "{'shape': (1, -2), 'descr': '<f8'",
          "{'shape': (1, 2), 'fortran_order': no, 'descr': '<f8'}",
          "{'shape': (1, 2), 'fortran_order': False, 'descr': '<f8'} x",
          "{'shape': (1, 2), 'fortran_order': False, 'descr': '<f8", "{'shap': (1, 2)}",
          "{'shape': (99999999999999999999, 2)}"}) {
        EXPECT_EQ(wrong(with_head(broken, numbers)),
                  " its head is none that NumPy writes: " + in_quotes(broken));
    }
}

TEST(NpySites, WrongOnesAreRefused) {
    const auto numbers = bytes_of<double>({1, 2, 3, 4, 5, 6});
    const std::string good = array("<f8", "(3, 2)", numbers);
    const std::string magic =
        " this is no array of NumPy's, which begins with a byte 93 and NUMPY; if it is text, add "
        "--read-as text";
    EXPECT_EQ(wrong(""), magic);
    EXPECT_EQ(wrong("1 2 3\n4 5 6\n"), magic);
    EXPECT_EQ(wrong(good.substr(0, 7)), magic);
    EXPECT_EQ(wrong(good.substr(0, 9)), " the file ends within its head");
    EXPECT_EQ(wrong(good.substr(0, 30)), " the file ends within its head");
    EXPECT_EQ(wrong(with_head("", "", 4)), " version 4 of the format .npy; 1 to 3 are read");
    EXPECT_EQ(wrong("\x93NUMPY\x02\0\xFF\xFF\xFF\x7F"s),
              " a head of 2147483647 bytes; the longest that is read has 65536");
    EXPECT_EQ(wrong(good.substr(0, good.size() - 1)), " the file ends in row 3 of 3");
    EXPECT_EQ(wrong(good + "x"), " bytes beyond the array of shape (3, 2)");
    EXPECT_EQ(wrong(array("<f8", "(3, 2)", numbers, "True").substr(0, good.size() - 20)),
              " the file ends in row 1 of 3 of column 2");
    EXPECT_EQ(wrong(array("<f8", "(0, 2)", "")), " no site in this file");
    EXPECT_EQ(wrong(array("<f8", "(6,)", numbers)),
              " an array of shape (6); sites are rows of numbers, an array of two axes");
    EXPECT_EQ(wrong(array("<f8", "(6, 1)", numbers)),
              " rows of 1 numbers; sites of the plane have 2 or 3; choose columns by --columns, as "
              "in --columns 1,2,3");
    EXPECT_EQ(wrong(array("<f8", "(3, 2)", numbers), {.dimension = 3}),
              " rows of 2 numbers; sites in space have 3 or 4; choose columns by --columns, as in "
              "--columns 1,2,3,4");
    EXPECT_EQ(wrong(array("<f8", "(1, 20000)", numbers)), " 20000 columns; 10000 are the most");
    EXPECT_EQ(wrong(array("<c16", "(3, 2)", numbers)),
              " an array of type '<c16'; floats of 32 and 64 bits and integers are read: save "
              "array.astype(float)");
    EXPECT_TRUE(wrong(with_head("{'descr': [('x', '<f8')], 'shape': (3,)}", numbers))
                    .starts_with(" an array of fields with names; "));
    for (const std::string_view column : {"x", "0", "3", "1.5"})
        EXPECT_EQ(
            wrong(good, {.columns = {"1", std::string(column)}}),
            fmt::format(" column '{}' is chosen; the columns of this array have no names, and "
                        "numbers from 1 to 2",
                        column));
    EXPECT_EQ(wrong(good, {.columns = {"2", "2"}}), " column 2 is chosen twice");
}

TEST(NpySites, NumbersHaveAPlace) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto numbers = bytes_of<double>({1, 2, 3, -infinity, -5, 1e300});
    for (const std::string_view is_by_columns : {"False", "True"}) {
        const std::string contents = array("<f8", "(2, 3)", numbers, is_by_columns);
        EXPECT_EQ(wrong(contents), is_by_columns == "True"
                                       ? "2:2: -inf where a finite number should be"
                                       : "2:1: -inf where a finite number should be");
    }
    const SitesFile file = read(array("<f8", "(2, 3)", bytes_of<double>({-1, 2, 3, 1e300, -4, -5})),
                                {.columns = {"2", "1", "3"}});
    ASSERT_TRUE(file.first_negative && file.first_beyond_single);
    EXPECT_EQ(file.first_negative->line, 2);
    EXPECT_EQ(file.first_negative->column, 3);
    EXPECT_EQ(file.first_beyond_single->line, 2);
    EXPECT_EQ(file.first_beyond_single->column, 1);
}

/// A head alone does not make anything large.
TEST(NpySites, AHeadThatPromisesTooMuch) {
    EXPECT_EQ(wrong(array("<f8", "(18446744073709551615, 3)", "")),
              fmt::format(" the file ends in row 1 of {}", max_sites + 1));
    EXPECT_EQ(wrong(array("<f8", "(9000000000, 3)", "", "True")),
              fmt::format(" the file ends in row 1 of {} of column 1", max_sites + 1));
}

TEST(NpySites, AreNoText) {
    EXPECT_EQ(test::refusal(array("<f8", "(1, 2)", ""),
                            [](const std::string& path) { return read_sites(path, {}); }),
              " this is an array of NumPy's; add --read-as npy, or call it .npy");
}

TEST(F64Sites, AreRowsOfDoubles) {
    const ReadOptions plane = {.input = SitesInput::f64};
    const ReadOptions space = {.dimension = 3, .input = SitesInput::f64};
    const auto numbers = bytes_of<double>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    EXPECT_EQ(read(numbers, plane).sites, (Sites{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}}));
    EXPECT_EQ(read(numbers, space).in_space, (Sites3{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}}));
    EXPECT_EQ(wrong("", plane), " no site in this file");
    EXPECT_EQ(wrong(numbers.substr(0, 95), plane),
              " the file ends within site 3, which has 24 bytes: 3 doubles; if it is text, add "
              "--read-as text");
    EXPECT_EQ(
        wrong(bytes_of<double>({1, 2, 3, 4, std::numeric_limits<double>::quiet_NaN(), 6}), plane),
        "2:2: nan where a finite number should be");
}

/// More than a block of them.
TEST(ArraySites, ReadBackWhatWasWritten) {
    Sites many = hard;
    for (int i = 0; i < 40'000; ++i) many.push_back({i / 7.0, -i / 3.0, i % 5 / 11.0});
    Sites3 in_space = corner;
    for (int i = 0; i < 40'000; ++i) in_space.push_back({i / 7.0, -i / 3.0, i % 5 / 11.0, 1e-300});
    for (const auto& [format, input] : {std::pair{SitesFormat::npy, SitesInput::npy},
                                        std::pair{SitesFormat::f64, SitesInput::f64}}) {
        std::ostringstream plane, space;
        write_sites(plane, std::span<const Site>(many), format);
        write_sites(space, std::span<const Site3>(in_space), format);
        EXPECT_EQ(read(plane.str(), {.input = input}).sites, many);
        EXPECT_EQ(read(space.str(), {.dimension = 3, .input = input}).in_space, in_space);
    }
}

template <class Tessellation, class Rows>
void expect_arrays(const Tessellation& tessellation, const Rows& rows, std::size_t vertices) {
    std::ostringstream npy, raw;
    write_npy(npy, tessellation);
    write_i32(raw, tessellation);
    std::vector<std::int32_t> numbers;
    for (const auto& row : rows)
        numbers.insert(numbers.end(), row.begin(),
                       row.begin() + static_cast<std::ptrdiff_t>(vertices));
    const std::string bytes = bytes_of(numbers);
    EXPECT_EQ(raw.str(), bytes);
    const std::string head = npy.str().substr(0, 128);
    EXPECT_EQ(npy.str().substr(128), bytes);
    EXPECT_EQ(head.substr(0, 10), "\x93NUMPY\x01\0\x76\0"s);
    EXPECT_TRUE(head.substr(10).starts_with(fmt::format(
        "{{'descr': '<i4', 'fortran_order': False, 'shape': ({}, {}), }}", rows.size(), vertices)))
        << head;
    EXPECT_EQ(head.back(), '\n');
}

TEST(ArraysOfFaces, AreTheTable) {
    const Tessellation plane = triangulate(hard, Metric::power);
    expect_arrays(plane, plane.faces(), 3);
    const SpaceTessellation space = triangulate(std::span<const Site3>(corner), Power{});
    expect_arrays(space, space.cells, 4);
    const SpaceTessellation flat = triangulate(std::span<const Site3>(corner).first(3), Power{});
    ASSERT_EQ(flat.dimension, 2);
    expect_arrays(flat, flat.cells, 3);
}

}  // namespace
}  // namespace signum
