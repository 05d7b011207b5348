/// Long doubles with a bound: each operation adds its rounding to what its operands were off.

#include "../../filters/wide.hpp"

#include <array>

#include <gtest/gtest.h>

#include "../../core/site.hpp"

namespace signum::filters {
namespace {

TEST(Wide, SumsAddErrorsAndTheirRounding) {
    const Wide sum = Wide(1.0) + Wide(0x1p-70);
    EXPECT_GE(sum.error, Wide::u * sum.value);
    EXPECT_GE((Wide(1.0L, 0.5L) + Wide(2.0L, 0.25L)).error, 0.75L + 3 * Wide::u);
    EXPECT_GE((Wide(1.0L, 0.5L) - Wide(2.0L, 0.25L)).error, 0.75L + Wide::u);
}

TEST(Wide, ProductsAddErrorsAndTheirRounding) {
    EXPECT_GE((Wide(3.0) * Wide(5.0)).error, 15 * Wide::u);
    EXPECT_GE((Wide(-3.0L, 0.5L) * Wide(0.0)).error, 0.0L);
    EXPECT_GE((Wide(-3.0L, 0.5L) * Wide(8.0)).error, 4.0L);
    EXPECT_GE((Wide(8.0) * Wide(-3.0L, 0.5L)).error, 4.0L);
    EXPECT_GE((Wide(0.0L, 0.5L) * Wide(0.0L, 0.25L)).error, 0.125L);
}

TEST(Wide, HasASignBeyondItsError) {
    EXPECT_FALSE(Wide(1.0L, 1.0L).sign().is_certain());
    EXPECT_FALSE(Wide(-1.0L, 1.0L).sign().is_certain());
    EXPECT_EQ(Wide(-1.0L, 0.5L).sign().sign(), -1);
    EXPECT_EQ(Wide(1.0L, 0.5L).sign().sign(), 1);
}

TEST(Wide, BasesOnTheLeastAndSaysWhetherThatTurns) {
    const Point near{1, 1}, far{9, 0}, farther{0, -99};
    std::array in_place = {&farther, &far, &near};
    EXPECT_EQ(base_on_least(in_place, in_place.size() - 1), 1);
    EXPECT_EQ(in_place[2], &near);
    std::array exchanged = {&near, &far, &farther};
    EXPECT_EQ(base_on_least(exchanged, exchanged.size() - 1), -1);
    EXPECT_EQ(exchanged[2], &near);
    EXPECT_EQ(exchanged[0], &farther);
}

}  // namespace
}  // namespace signum::filters
