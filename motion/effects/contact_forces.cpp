#include "contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "../../core/contract.hpp"

namespace signum::motion {
namespace {

/// A gap of at most that much of the radii is none.
constexpr double closed = 0x1p-36;
/// Of the speeds that are summed, what rounding may leave of their sum after many sweeps.
constexpr double rounding = 0x1p-48;
/// No step is longer than that many times the impulses that stop each contact's approach alone: it
/// would be along impulses that cancel one another, such as those of walls that close on a ball.
constexpr double longest_step = 0x1p26;
/// Where the associated law is met that much better than Coulomb's, something slides.
constexpr double sliding = 0.01;

enum class Law { associated, coulomb };

/// A body that takes part; all walls are one of infinite mass, which stays at rest.
struct Inert {
    double mass = 0.0;
    double inertia = 0.0;
    double radius = 0.0;
    double inverse_mass = 0.0;
    double lever = 0.0;  ///< radius / inertia
};

template <int D>
struct Motion {
    Vector<D> velocity{};
    Spin<D> spin{};
};

/// A contact as the sweeps see it.
template <int D>
struct Row {
    std::size_t a;
    std::size_t b;
    Vector<D> normal;
    Vector<D> wall_velocity;
    double opening;  ///< g/h
    double friction;
    double normal_mobility;  ///< how fast the surfaces part by an impulse of 1 along the normal
    double tangential_mobility;
};

/// Impulses and the velocities that they give; or a direction, the change of both.
template <int D>
struct State {
    std::vector<Vector<D>> impulses;
    std::vector<Motion<D>> motions;

    void scale(double factor) noexcept {
        for (Vector<D>& impulse : impulses) impulse = factor * impulse;
        for (Motion<D>& motion : motions) motion = {factor * motion.velocity, factor * motion.spin};
    }
    /// this += factor · other
    void add(double factor, const State& other) noexcept {
        for (std::size_t i = 0; i < impulses.size(); ++i)
            impulses[i] = impulses[i] + factor * other.impulses[i];
        for (std::size_t i = 0; i < motions.size(); ++i)
            motions[i] = {motions[i].velocity + factor * other.motions[i].velocity,
                          motions[i].spin + factor * other.motions[i].spin};
    }
};

/// The impulse that solves one contact's problem while all others stay, and its change in parts.
template <int D>
struct Reaction {
    Vector<D> impulse{};
    double normal_change = 0.0;
    Vector<D> tangential_change{};
};

template <int D>
class Cluster {
 public:
    Cluster(std::span<ContactBody<D>> bodies, std::span<Contact<D>> contacts,
            std::span<const std::size_t> members, std::vector<std::size_t>& places, double step)
        : members_(members) {
        constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
        const auto place = [&](std::size_t body) {
            if (places[body] == unknown) {
                places[body] = bodies_.size();
                bodies_.push_back(body);
            }
            return places[body];
        };
        for (const std::size_t member : members) {
            const Contact<D>& contact = contacts[member];
            Row<D> row{};
            row.a = place(contact.a);
            row.b = contact.b == Contact<D>::wall ? unknown : place(contact.b);
            row.normal = contact.normal;
            if (contact.b == Contact<D>::wall) row.wall_velocity = contact.wall_velocity;
            row.opening = contact.gap;
            row.friction = contact.friction;
            rows_.push_back(row);
            state_.impulses.push_back(contact.tangential_impulse +
                                      contact.normal_impulse * contact.normal);
        }
        for (const std::size_t body : bodies_) {
            const auto& [velocity, spin, inert] = bodies[body];
            inert_.push_back({inert.mass, inert.inertia, inert.radius, 1.0 / inert.mass,
                              inert.radius / inert.inertia});
            state_.motions.push_back({velocity, spin});
            speed_ = std::max(speed_, norm(velocity) + inert.radius * norm(spin));
        }
        inert_.push_back({});
        state_.motions.push_back({});
        free_ = state_.motions;
        for (Row<D>& row : rows_) {
            if (row.b == unknown) row.b = bodies_.size();
            const Inert& a = inert_[row.a];
            const Inert& b = inert_[row.b];
            const bool touches = std::abs(row.opening) <= closed * (a.radius + b.radius);
            row.opening = touches ? 0.0 : row.opening / step;
            row.normal_mobility = a.inverse_mass + b.inverse_mass;
            // Without friction nothing turns, and inertia may be anything.
            row.tangential_mobility = row.normal_mobility;
            if (row.friction > 0.0)
                row.tangential_mobility += a.radius * a.lever + b.radius * b.lever;
            speed_ = std::max(speed_, norm(row.wall_velocity));
            const double parting = dot(surface_velocity(row), row.normal) + row.opening;
            approach_ = std::max(approach_, -parting);
        }
        for (const Row<D>& row : rows_) longest_ += 1.0 / row.normal_mobility;
        longest_ *= longest_step * approach_ * longest_step * approach_;
    }

    /// How many sweeps it took to the least residual, which is that of the state afterwards.
    int solve(double tolerance, int sweeps) {
        const std::vector<Vector<D>> last_impulses = state_.impulses;
        state_.impulses.assign(rows_.size(), {});
        best_ = state_;
        keep_if_better(residual(Law::coulomb));
        if (best_residual_ <= tolerance) return 0;
        state_.impulses = last_impulses;
        push_all();
        keep_if_better(residual(Law::coulomb));
        if (best_residual_ <= tolerance) return 0;

        state_ = best_;
        int done = associated(tolerance, sweeps / 2);
        if (best_residual_ > tolerance) done += coulomb(tolerance, sweeps - done);
        return done;
    }

    [[nodiscard]] double residual() const noexcept { return best_residual_; }

    void store(std::span<ContactBody<D>> bodies, std::span<Contact<D>> contacts) const {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            bodies[bodies_[i]].velocity = best_.motions[i].velocity;
            bodies[bodies_[i]].spin = best_.motions[i].spin;
        }
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            Contact<D>& contact = contacts[members_[i]];
            const Vector<D>& normal = rows_[i].normal;
            contact.normal_impulse = std::max(dot(best_.impulses[i], normal), 0.0);
            contact.tangential_impulse = best_.impulses[i] - contact.normal_impulse * normal;
            if (rows_[i].friction == 0.0) contact.tangential_impulse = {};
        }
    }

 private:
    /// Of a's surface relative to b's. The arms are -R_a n and R_b n.
    [[nodiscard]] Vector<D> surface_velocity(const Row<D>& row) const noexcept {
        const Motion<D>& a = state_.motions[row.a];
        const Motion<D>& b = state_.motions[row.b];
        const Spin<D> rolling = -inert_[row.a].radius * a.spin - inert_[row.b].radius * b.spin;
        return turned(rolling, row.normal) + (a.velocity - b.velocity - row.wall_velocity);
    }

    /// Changes are told without the impulse that they change wherever they can be: an impulse that
    /// is large to a light body is known less well than the light body's velocity.
    [[nodiscard]] Reaction<D> reaction(const Row<D>& row, const Vector<D>& impulse,
                                       const Vector<D>& velocity, Law law) const noexcept {
        const double friction = row.friction;
        const double pressing = dot(impulse, row.normal);
        const double parting = dot(velocity, row.normal);
        const Vector<D> rubbing = impulse - pressing * row.normal;

        // What would stop all motion at the contact: its tangential part, and how far that is
        // outside the cone, by which the associated law presses harder.
        Reaction<D> result;
        result.normal_change = -(parting + row.opening) / row.normal_mobility;
        Vector<D> stopping{};
        if (friction > 0.0)
            stopping = rubbing - 1.0 / row.tangential_mobility * velocity +
                       parting / row.tangential_mobility * row.normal;
        const double wanted = norm(stopping);
        if (law == Law::associated) {
            const double outside = wanted - friction * (pressing + result.normal_change);
            if (outside > 0.0)
                result.normal_change +=
                    friction * row.tangential_mobility * outside /
                    (row.normal_mobility + friction * friction * row.tangential_mobility);
        }
        const double pressed = pressing + result.normal_change;

        if (!(pressed > 0.0)) {
            result.normal_change = -pressing;
            result.tangential_change = -1.0 * rubbing;
            return result;
        }
        if (friction > 0.0 && wanted <= friction * pressed) {
            result.tangential_change = parting / row.tangential_mobility * row.normal -
                                       1.0 / row.tangential_mobility * velocity;
            result.impulse = impulse + result.tangential_change + result.normal_change * row.normal;
            return result;
        }
        Vector<D> rubs{};
        if (friction > 0.0) rubs = friction * pressed / wanted * stopping;
        result.tangential_change = rubs - rubbing;
        result.impulse = rubs + pressed * row.normal;
        return result;
    }

    void push(const Row<D>& row, const Vector<D>& impulse) noexcept {
        Motion<D>& a = state_.motions[row.a];
        Motion<D>& b = state_.motions[row.b];
        a.velocity = a.velocity + inert_[row.a].inverse_mass * impulse;
        b.velocity = b.velocity - inert_[row.b].inverse_mass * impulse;
        // Without friction nothing turns, by rounding neither.
        if (row.friction == 0.0) return;
        const Spin<D> turning = torque(row.normal, impulse);
        a.spin = a.spin - inert_[row.a].lever * turning;
        b.spin = b.spin - inert_[row.b].lever * turning;
    }

    /// Makes the motions those of the impulses, anew: what is added up over many sweeps drifts
    /// away, fast where impulses are large and nearly cancel one another.
    void push_all() noexcept {
        state_.motions = free_;
        for (std::size_t i = 0; i < rows_.size(); ++i) push(rows_[i], state_.impulses[i]);
    }

    void react(std::size_t number, Law law) noexcept {
        const Row<D>& row = rows_[number];
        const Reaction<D> result =
            reaction(row, state_.impulses[number], surface_velocity(row), law);
        state_.impulses[number] = result.impulse;
        push(row, result.tangential_change + result.normal_change * row.normal);
    }

    void sweep_to_and_fro(Law law) noexcept {
        for (std::size_t i = 0; i < rows_.size(); ++i) react(i, law);
        for (std::size_t i = rows_.size(); i-- > 0;) react(i, law);
        push_all();
    }

    [[nodiscard]] double residual(Law law) const noexcept {
        double largest = 0.0;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            const Row<D>& row = rows_[i];
            const Reaction<D> result =
                reaction(row, state_.impulses[i], surface_velocity(row), law);
            const double speed = std::max(std::abs(result.normal_change) * row.normal_mobility,
                                          norm(result.tangential_change) * row.tangential_mobility);
            const double rounded =
                rounding * (speed_ + norm(state_.impulses[i]) * row.tangential_mobility);
            if (!std::isfinite(speed - rounded)) return std::numeric_limits<double>::infinity();
            largest = std::max(largest, speed - rounded);
        }
        return largest > 0.0 ? largest / approach_ : 0.0;
    }

    void keep_if_better(double residual) {
        if (!(residual < best_residual_)) return;
        best_residual_ = residual;
        best_ = state_;
    }

    /// The product of two directions by the energy p·Wp, W the change of surface velocities by
    /// impulses: that of their velocities by the masses.
    [[nodiscard]] double energy(const State<D>& a, const State<D>& b) const noexcept {
        double sum = 0.0;
        for (std::size_t i = 0; i < inert_.size(); ++i)
            sum += inert_[i].mass * dot(a.motions[i].velocity, b.motions[i].velocity) +
                   inert_[i].inertia * dot(a.motions[i].spin, b.motions[i].spin);
        return sum;
    }

    /// The same of a direction by itself, as if no contact knew of the others.
    [[nodiscard]] double separate_energies(const State<D>& direction) const noexcept {
        double sum = 0.0;
        for (std::size_t i = 0; i < rows_.size(); ++i)
            sum += rows_[i].normal_mobility * dot(direction.impulses[i], direction.impulses[i]);
        return sum;
    }

    /// What the associated law makes least, among impulses within the cones.
    [[nodiscard]] double objective() const noexcept {
        double sum = energy(state_, state_) / 2;
        for (std::size_t i = 0; i < rows_.size(); ++i)
            sum += rows_[i].opening * dot(state_.impulses[i], rows_[i].normal) -
                   dot(state_.impulses[i], rows_[i].wall_velocity);
        return sum;
    }

    /// How fast that falls along a direction.
    [[nodiscard]] double descent(const State<D>& direction) const noexcept {
        double sum = 0.0;
        for (std::size_t i = 0; i < rows_.size(); ++i)
            sum -= dot(direction.impulses[i], surface_velocity(rows_[i])) +
                   rows_[i].opening * dot(direction.impulses[i], rows_[i].normal);
        return sum;
    }

    int associated(double tolerance, int sweeps) {
        State<D> last;  // what the last sweeps and the step after them changed
        State<D> good = state_;
        double lowest = std::numeric_limits<double>::infinity();
        double length = 0.0;
        int raised = 0;
        int done = 0;
        while (done + 2 <= sweeps) {
            const State<D> before = state_;
            sweep_to_and_fro(Law::associated);
            done += 2;
            const double remaining = residual(Law::coulomb);
            keep_if_better(remaining);
            if (remaining <= tolerance || !std::isfinite(remaining) ||
                residual(Law::associated) <= sliding * remaining)
                break;

            // A step may leave the cones, and sweeps from there may end higher. Sweeps alone do
            // not. In piles that rest that is rare; where it is not, conjugate gradients are no
            // help.
            const double now = objective();
            if (now > lowest) {
                state_ = good;
                if (++raised == 4) break;
                length = 0.0;
                lowest = std::numeric_limits<double>::infinity();
                continue;
            }
            lowest = now + 0x1p-46 * std::abs(now);
            good = state_;

            // On along what the sweeps changed, made conjugate to the last step, and along that: as
            // far as the objective falls.
            State<D> swept = state_;
            swept.add(-1.0, before);
            const double last_length = std::exchange(length, separate_energies(swept));
            const auto step_along = [&](const State<D>& direction, double fall, double curvature) {
                if (!(curvature > 0.0)) return;
                const double factor = fall / curvature;
                if (factor * factor * separate_energies(direction) <= longest_)
                    state_.add(factor, direction);
            };
            double last_energy = 0.0;
            double last_descent = 0.0;
            if (length <= 4.0 * last_length) {
                last_energy = energy(last, last);
                last_descent = descent(last);
                if (last_energy > 0.0) swept.add(-energy(swept, last) / last_energy, last);
            }
            const double swept_descent = descent(swept);
            step_along(swept, swept_descent, energy(swept, swept));
            step_along(last, last_descent, last_energy);
            push_all();
            last = state_;
            last.add(-1.0, before);
        }
        return done;
    }

    int coulomb(double tolerance, int sweeps) {
        State<D> search;
        bool searching = false;
        double length = std::numeric_limits<double>::infinity();
        int done = 0;
        while (done + 2 <= sweeps) {
            State<D> swept = state_;
            sweep_to_and_fro(Law::coulomb);
            done += 2;
            const double remaining = residual(Law::coulomb);
            keep_if_better(remaining);
            if (remaining <= tolerance || !std::isfinite(remaining)) break;

            const State<D> before = std::move(swept);
            swept = state_;
            swept.add(-1.0, before);
            // Where the sweeps change more than those before did, the search starts anew with the
            // next.
            const double now = separate_energies(swept);
            if (now == 0.0) break;
            if (!(now < length)) {
                searching = false;
            } else if (!std::exchange(searching, true)) {
                search = std::move(swept);
            } else {
                const double ratio = now / length;
                state_.add(ratio, search);
                push_all();
                search.scale(ratio);
                search.add(1.0, swept);
            }
            length = now;
        }
        return done;
    }

    std::vector<Row<D>> rows_;
    std::vector<Inert> inert_;
    std::vector<Motion<D>> free_;  ///< without impulses
    State<D> state_;
    State<D> best_;
    double best_residual_ = std::numeric_limits<double>::infinity();
    double approach_ = 0.0;                 ///< the largest before
    double longest_ = 0.0;                  ///< of a step, its separate energies
    double speed_ = 0.0;                    ///< a bound on those of surfaces before
    std::span<const std::size_t> members_;  ///< to each row its contact
    std::vector<std::size_t> bodies_;       ///< to each place the body
};

/// To each contact the number of its cluster; clusters are numbered as their first contacts come.
template <int D>
std::vector<std::size_t> clusters(std::size_t bodies, std::span<const Contact<D>> contacts) {
    std::vector<std::size_t> parent(bodies);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t body) {
        while (parent[body] != body) body = parent[body] = parent[parent[body]];
        return body;
    };
    for (const Contact<D>& contact : contacts)
        if (contact.b != Contact<D>::wall) parent[root(contact.a)] = root(contact.b);
    constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> number(bodies, unknown);
    std::vector<std::size_t> result;
    std::size_t count = 0;
    for (const Contact<D>& contact : contacts) {
        std::size_t& cluster = number[root(contact.a)];
        if (cluster == unknown) cluster = count++;
        result.push_back(cluster);
    }
    return result;
}

}  // namespace

template <int D>
ContactReport solve_contacts(std::span<ContactBody<D>> bodies, std::span<Contact<D>> contacts,
                             double step, double tolerance, int sweeps) {
    SIGNUM_EXPECTS(step > 0.0 && tolerance > 0.0 && sweeps >= 0);
    const std::vector<std::size_t> cluster_of =
        clusters<D>(bodies.size(), {contacts.data(), contacts.size()});
    std::vector<std::size_t> members(contacts.size());
    std::iota(members.begin(), members.end(), std::size_t{0});
    std::stable_sort(members.begin(), members.end(),
                     [&](std::size_t i, std::size_t j) { return cluster_of[i] < cluster_of[j]; });

    ContactReport report;
    std::vector<std::size_t> places(bodies.size(), std::numeric_limits<std::size_t>::max());
    for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
        while (end < members.size() && cluster_of[members[end]] == cluster_of[members[begin]])
            ++end;
        Cluster<D> cluster(bodies, contacts, {members.data() + begin, end - begin}, places, step);
        report.sweeps = std::max(report.sweeps, cluster.solve(tolerance, sweeps));
        report.residual = std::max(report.residual, cluster.residual());
        ++report.clusters;
        if (!(cluster.residual() <= tolerance)) ++report.unconverged;
        cluster.store(bodies, contacts);
    }
    return report;
}

template ContactReport solve_contacts<2>(std::span<ContactBody<2>>, std::span<Contact<2>>, double,
                                         double, int);
template ContactReport solve_contacts<3>(std::span<ContactBody<3>>, std::span<Contact<3>>, double,
                                         double, int);

}  // namespace signum::motion
