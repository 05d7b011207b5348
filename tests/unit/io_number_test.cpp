#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "../../tool/io/number.hpp"

namespace signum {
namespace {

double value(std::string_view text) {
    const Number number = parse_number(text);
    EXPECT_EQ(number.fault, NumberFault::none) << text;
    return number.value;
}

TEST(Number, ReadsDecimals) {
    EXPECT_EQ(value("1"), 1.0);
    EXPECT_EQ(value("+1.5"), 1.5);
    EXPECT_EQ(value("-2e-3"), -2e-3);
    EXPECT_EQ(value(".5"), 0.5);
    EXPECT_EQ(value("5."), 5.0);
    EXPECT_EQ(value("1E+5"), 1e5);
    EXPECT_EQ(value("0.1000000000000000055511151231257827021181583404541015625"), 0.1);
    EXPECT_EQ(value("9007199254740993"), 9007199254740992.0);  // halves to even
    EXPECT_TRUE(std::signbit(value("-0")));
}

TEST(Number, ReadsHexadecimals) {
    EXPECT_EQ(value("0x1.8p-3"), 0.1875);
    EXPECT_EQ(value("-0X1P2"), -4.0);
    EXPECT_EQ(value("0x.8"), 0.5);
    EXPECT_EQ(value("0xff"), 255.0);
    EXPECT_EQ(value("0x1.00000000000008p0"), 1.0);  // halves to even
    EXPECT_EQ(value("0x1.000000000000080000001p0"), 0x1.0000000000001p0);
}

TEST(Number, ReadsTheSmallestToTheNearest) {
    const double least = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(value("4.9e-324"), least);
    EXPECT_EQ(value("3e-324"), least);
    EXPECT_EQ(value("2e-324"), 0.0);
    EXPECT_EQ(value("1e-999"), 0.0);
    EXPECT_EQ(value("1e-99999999999999999999999"), 0.0);
    EXPECT_TRUE(std::signbit(value("-1e-999")));
    EXPECT_EQ(value("0x1p-1074"), least);
    EXPECT_EQ(value("0x1p-1075"), 0.0);
    EXPECT_EQ(value("0x1p-99999"), 0.0);
    EXPECT_EQ(value("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_EQ(value("0e99999999999999999999"), 0.0);
}

TEST(Number, ReadsTheLargest) {
    const double most = std::numeric_limits<double>::max();
    EXPECT_EQ(value("1.7976931348623158e308"), most);
    EXPECT_EQ(value("0x1.fffffffffffff7p1023"), most);
    for (const char* text :
         {"1.7976931348623159e308", "1e999", "-1e999", "1e99999999999999999999999", "0x1p1024",
          "0x1.fffffffffffff8p1023", "-0x1p99999999999999999999"}) {
        EXPECT_EQ(parse_number(text).fault, NumberFault::out_of_range) << text;
    }
    EXPECT_EQ(parse_number("1" + std::string(400, '0')).fault, NumberFault::out_of_range);
    EXPECT_EQ(value("0." + std::string(400, '0') + "1e401"), 1.0);
}

TEST(Number, RefusesInfinityAndNaN) {
    for (const char* text : {"nan", "NaN", "-nan", "inf", "+inf", "-Infinity", "nan(1)"}) {
        EXPECT_EQ(parse_number(text).fault, NumberFault::not_finite) << text;
    }
}

TEST(Number, RefusesEverythingElse) {
    for (const char* text :
         {"",           "+",    "-",   ".",    "e5",    "1e",    "1e+",   "1x",
          "x",          "1,5",  "1 ",  " 1",   "--1",   "+-1",   "-+1",   "0x",
          "0x1.8p+-02", "0x-1", "0xg", "0x1p", "0xinf", "0x0x1", "1.2.3", "1f"}) {
        EXPECT_EQ(parse_number(text).fault, NumberFault::word) << text;
    }
}

TEST(Number, Explains) {
    EXPECT_EQ(
        explain(NumberFault::word, "a\x01"),
        "'a\\x01' is not a number; write a decimal or hexadecimal float, such as 1.5, -2e-3 or "
        "0x1.8p-3");
    EXPECT_EQ(explain(NumberFault::not_finite, "nan"),
              "'nan' is not a finite number; write a finite one");
    EXPECT_EQ(explain(NumberFault::out_of_range, "1e999"),
              "'1e999' is beyond the range of a double; the largest is about 1.797e308");
    EXPECT_EQ(explain(NumberFault::not_finite, std::string(41, 'n')),
              "'" + std::string(40, 'n') + "...' is not a finite number; write a finite one");
}

}  // namespace
}  // namespace signum
