#pragma once
/// What all other scripts take for granted of one operation, proved of gappa's own model of
/// doubles.

#include "script.hpp"

namespace signum::proofs {

/// In every rounding mode: a result that is no denormal errs by 2^-52 of itself at most, a product
/// below that by 2^-1074, a sum below that not at all.
inline void prove_rounding(Scripts& scripts) {
    for (const std::string mode : {"ne", "up", "dn", "zr"}) {
        const std::string begin = "@rounded = float<ieee_64," + mode + ">;\n";
        scripts.write(
            "rounding-" + mode, "One operation whose result is no denormal.",
            {"|x| in [3b-1023, 1b1023] -> |rounded(x) -/ x| <= " + written(rounding), begin});
        scripts.write("underflow-" + mode, "One product whose result is small.",
                      {"|x| in [0, 3b-1023] -> |rounded(x) - x| <= 1b-1074", begin});
        scripts.write("small-sum-" + mode, "One sum of doubles whose result is small.",
                      {"@FIX(x, -1074) /\\ |x| in [0, 3b-1023] -> rounded(x) = x", begin});
    }
}

}  // namespace signum::proofs
