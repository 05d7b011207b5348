#include "page.hpp"

#include <string_view>
#include <utility>

#include "figures.hpp"
#include "results.hpp"

namespace signum::study {
namespace {

constexpr std::string_view motion_introduction =
    R"(<p>Balls fly, fall and strike one another in a box that shakes. Who strikes whom next? Asking every ball
about every other one is slow; <em>structures</em> propose a few pairs that may be next. M. Gavrilova’s thesis
(<em>Proximity and Applications in General Metrics</em>, Calgary 1998, chapter 10) compared five of them. This study repeats its tables
10.4.1 to 10.4.5, adds structures it did not have and balls it could not run, and asks what accuracy costs: signum tells every strike in
the exact order.</p>
<p><strong>The shaker.</strong> The thesis’s box is 200 by 200, runs last 10 s, time steps are 0.005 s; radii and packings are in its tables. How it
shook, with which gravity and which losses, it does not say. Here the box goes up and down by 5 once a second, gravity is 9.81, a strike
keeps 0.9 of the speed along its normal, and one that comes within a thousandth of a second of the last one keeps all, so that nothing
collapses. So numbers of strikes are not to be compared. What can be compared is the order of the structures and how times grow.
Of radii 1 : 10 and 5 to 10, discs of any size and of twice that size fill as much in all; with that most of the thesis’s radii come out of its
packings.</p>
<p><strong>Steps and events.</strong> The thesis recomputes every ball at every step, whoever strikes (its <em>predict trajectory
events</em>), and that is most of its time. Where a formula gives the flight, steps are not needed; both ways are measured.</p>
<p>Times are medians of passes over all experiments, in each of which the structures take turns; a thin bar reaches from the fastest pass
to the slowest. Where structures are compared they are those of whole runs, with the making of the structure; where there are a thousand balls or
more, and where accuracy is asked about, of the run alone.</p>
)";

constexpr std::string_view motion_glossary = R"(<h2>Words</h2>
<dl>
<dt>strike</dt><dd>Two balls, or a ball and a side of the box, touch and change their velocities.</dd>
<dt>structure</dt><dd>What proposes the pairs that may strike: <code>pairs</code> all of them (“straightforward”),
<code>cells</code> those in cells side by side (“regular subdivision”), <code>tree</code> the same where only occupied cells are kept (“spatial tree”),
<code>segments</code> those whose projections overlap (“segment tree”), <code>delaunay</code> neighbours in the power triangulation
(“dynamic PD”), <code>levels</code> cells of several sizes, <code>lists</code> balls in shells that overlap. <code>auto</code> chooses.</dd>
<dt>own event</dt><dd>An event of the structure alone: a centre enters a cell, ends change places (“topological event”).</dd>
<dt>check</dt><dd>A ball is asked when it meets another one (“collision check”).</dd>
<dt>prediction</dt><dd>A ball’s velocity is found anew at a time step (“predict trajectory event”).</dd>
<dt>packing</dt><dd>The share of the box that balls fill.</dd>
<dt>plain</dt><dd>Computed in doubles, whose word is taken for the truth.</dd>
</dl>
)";

}  // namespace

Page motion_page(const std::vector<MotionRow>& rows) {
    const MotionResults results(rows);
    Page page;
    page.title = "What strikes next: structures, accuracy and time steps";
    page.introduction = motion_introduction;
    for (Figure& figure : structure_figures(results))
        page.figures.push_back({std::move(figure), {}});
    for (Figure& figure : exactness_figures(results))
        page.figures.push_back({std::move(figure), {}});
    page.glossary = motion_glossary;
    return page;
}

}  // namespace signum::study
