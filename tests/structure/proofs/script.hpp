#pragma once
/// Writes gappa scripts, a file for each proposition: of several at once gappa tries every hint on
/// every one.

#include <cmath>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

#include "expression.hpp"

namespace signum::proofs {

/// A multiple of the unit as gappa reads it.
[[nodiscard]] inline std::string written(Units number) {
    return std::to_string(number) + "b-80";
}
/// A number above 0, rounded upwards to some 60 bits.
[[nodiscard]] inline std::string written_upwards(long double number) {
    if (number == 0) return "0";
    int exponent = 0;
    const long double digits = std::ldexp(std::frexp(number, &exponent), 60);
    return std::to_string(static_cast<Units>(std::ceil(digits))) + "b" +
           std::to_string(exponent - 60);
}

/// What is to be proved, how it begins (definitions) and what helps (equal ways to write a term).
struct Proposition {
    std::string goal;
    std::string begin = {};
    std::string hint = {};
};

class Scripts {
 public:
    explicit Scripts(std::string folder) : folder_(std::move(folder)) {}

    /// NAME.g, with a line of words on top.
    void write(const std::string& name, const std::string& words, const Proposition& proposition) {
        std::ofstream file(folder_ + "/" + name + ".g");
        file << "# " << words << "\n"
             << proposition.begin << "{ " << proposition.goal << " }\n"
             << proposition.hint;
        file.close();
        if (!file) throw std::runtime_error("cannot write " + folder_ + "/" + name + ".g");
    }

    /// From the errors of operands to that of a result. A and B are exact, a and b the errors of
    /// what is computed, all of them divided by the magnitude; t is the rounding of the operation.
    /// Of a sum s is the error of the exact sum of the computed operands: by the triangle
    /// inequality at most the greater one of both times the sum of the magnitudes.
    void write(const Step& step) {
        if (!steps_.insert(step).second) return;
        const std::string left = written(step.left);
        const std::string right = written(step.right);
        const std::string t = " /\\ |t| <= " + written(rounding) + " -> ";
        if (step.operation == '*')
            write("product-" + std::to_string(step.left) + "-" + std::to_string(step.right),
                  "A product: its relative error from those of its factors.",
                  {"|A| <= 1 /\\ |B| <= 1 /\\ |a| <= " + left + " /\\ |b| <= " + right + t +
                       "|(A + a) * (B + b) * (1 + t) - A * B| <= " + written(step.result),
                   "",
                   "(A + a) * (B + b) * (1 + t) - A * B -> A * b + a * B + a * b + t * ((A + a) * "
                   "(B + b));\n"});
        else
            write("sum-" + std::to_string(step.left) + "-" + std::to_string(step.right),
                  "A sum: its relative error from those of its terms.",
                  {"|S| <= 1 /\\ |s| <= " + (step.left > step.right ? left : right) + t +
                       "|(S + s) * (1 + t) - S| <= " + written(step.result),
                   "", "(S + s) * (1 + t) - S -> s + t * (S + s);\n"});
    }

 private:
    std::string folder_;
    std::set<Step> steps_;
};

}  // namespace signum::proofs
