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
to the slowest. They are those of whole runs, with the making of the structure; where there are a thousand balls or more, of a part of a longer
run, without it.</p>
)";

constexpr std::string_view why =
    R"(<p><strong>Segments.</strong> The thesis finds that its segment tree wins everywhere. Its time goes
into checks, which it counts by the ten millions, each as dear as thousands of today’s cycles, and segments ask by far the fewest. That is so here too.
But a check has become cheap, four pairs at a time without a branch, while an exchange of ends still is an event with its own time, its
place in a queue and two ends to be told apart.</p>
<p><strong>All pairs.</strong> The thesis has them ten times slower than the rest. For a hundred balls from event to event that is gone: only the two that strike are asked
about a hundred others, and asking is cheap. With time steps all are asked about all at every step, and the gap opens again.</p>
<p><strong>The power diagram.</strong> As in the thesis it is slow, and for the thesis’s reason: its events are roots of polynomials of
degree 4. Here they are isolated exactly. With steps every certificate of a ball that is kicked is found anew.</p>
<p><strong>Cells and one large ball.</strong> As in the thesis, cells as wide as the largest ball ask about more and more pairs
as sizes spread and balls get denser, until they ask about all. Levels have cells for each size.</p>
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
    if (!page.figures.empty()) {
        Figure reasons;
        reasons.plot.name = "why";
        reasons.title = "Why the order is another one than in the thesis";
        reasons.text = why;
        page.figures.push_back({std::move(reasons), {}});
    }
    for (Figure& figure : exactness_figures(results))
        page.figures.push_back({std::move(figure), {}});
    page.glossary = motion_glossary;
    return page;
}

}  // namespace signum::study
