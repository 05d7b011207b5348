#pragma once
/// The laws of double-doubles (filters/double_double.hpp), of gappa's own model of doubles in
/// rounding to nearest. Written out here, for they are about the roundings themselves.

#include "../../../filters/double_double.hpp"
#include "script.hpp"

namespace signum::proofs {

/// x = xh + xl and y = yh + yl with |xl| and |yl| of half an ulp at most; scaled by powers of two
/// so that xh and yh are from 1 to 2, of a sum the greater one at least and at most. That two_sum,
/// quick_two_sum and two_product commit no error is known (core/error_free.hpp).
inline void prove_double_doubles(Scripts& scripts) {
    static_assert(filters::double_double_epsilon == 16 * 0x1p-106);
    const std::string three = "@r = float<ieee_64,ne>;\nxh = r(XH); yh = r(YH); yl = r(YL);\n";
    const std::string numbers = three + "xl = r(XL);\n";
    // 9 u² where |xy| is nearly 1 or more, u = 2^-53; the law allows 16.
    scripts.write(
        "double_double-product", "The product of two double-doubles.",
        {"xh in [1, 2] /\\ yh in [1, 2] /\\ |xl| <= 1b-53 /\\ |yl| <= 1b-53 -> "
         "|(p + low) - (xh + xl) * (yh + yl)| <= 9b-106 /\\ (xh + xl) * (yh + yl) >= 15b-4",
         numbers +
             "p = r(xh * yh); lost = xh * yh - p; a = r(xh * yl); b = r(xl * yh); c = r(a + b);\n"
             "low = r(lost + c);\n",
         "(p + low) - (xh + xl) * (yh + yl) -> (low - (lost + c)) + (c - (a + b)) + "
         "(a - xh * yl) + (b - xl * yh) - xl * yl;\n"});
    scripts.write(
        "double_double-product_with_double", "The product of a double and a double-double.",
        {"xh in [1, 2] /\\ yh in [1, 2] /\\ |yl| <= 1b-53 -> "
         "|(p + low) - xh * (yh + yl)| <= 5b-106 /\\ xh * (yh + yl) >= 15b-4",
         three + "p = r(xh * yh); lost = xh * yh - p; a = r(xh * yl); low = r(lost + a);\n",
         "(p + low) - xh * (yh + yl) -> (low - (lost + a)) + (a - xh * yl);\n"});
    // 3 u² where |x| + |y| is nearly 1 or more.
    scripts.write(
        "double_double-sum", "The sum of two double-doubles.",
        {"|xh| in [1, 2] /\\ |yh| <= 2 /\\ |xl| <= 1b-53 /\\ |yl| <= 1b-53 -> "
         "|(s + low) - ((xh + xl) + (yh + yl))| <= 3b-106 /\\ |xh + xl| >= 15b-4",
         numbers + "s = r(xh + yh); lost = (xh + yh) - s; t = r(xl + yl); low = r(lost + t);\n",
         "(s + low) - ((xh + xl) + (yh + yl)) -> (low - (lost + t)) + "
         "(t - (xl + yl));\n"});
}

}  // namespace signum::proofs
