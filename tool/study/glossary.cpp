#include "glossary.hpp"

#include <fmt/format.h>

namespace signum::study {

std::string glossary(std::string_view own_words, std::string_view example_of_tie) {
    return fmt::format(
        R"(<h2>Words</h2>
<dl>
{}<dt>plain, naive</dt><dd>Computed in doubles, whose word is taken for the truth.</dd>
<dt>exact</dt><dd>With a sign that is never wrong, for all doubles.</dd>
<dt>filter</dt><dd>Plain arithmetic that also bounds its own error, and so knows when to ask for
better.</dd>
<dt>tie</dt><dd>A sign that is exactly zero: {}. One rule decides it, so that there is one result.</dd>
<dt>perturbation</dt><dd>A random number from 0 to it is added to each coordinate.</dd>
<dt>hidden site</dt><dd>One whose cell is empty, because others cover it.</dd>
</dl>
)",
        own_words, example_of_tie);
}

}  // namespace signum::study
