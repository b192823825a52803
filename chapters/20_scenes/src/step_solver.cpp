#include <contact/stepped/step_solver.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <contact/contact_active_set.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rigid_body.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE RigidBody<double> solver_body(const SteppedSetup& setup,
                                                    const SteppedState& state, std::size_t slot,
                                                    const Vector3<double>& velocity,
                                                    const Vector3<double>& angular_velocity) {
  const SteppedBody& body = setup.bodies[slot];
  RigidBody<double> solid;
  solid.position = position_of(setup, state, slot);
  if (slot >= setup.movers || sleeps(state, slot)) return solid;  // fixed
  solid.mass = body.mass;
  solid.inverse_mass = 1 / body.mass;
  solid.velocity = velocity;
  if (!rotated_by_contacts(setup, slot)) return solid;
  const Vector3<double> inverse = body.moments.cwiseInverse();
  const auto& m = body.moments;
  solid.angular_velocity = angular_velocity;
  solid.inertia = diagonal<double>(m.x(), m.y(), m.z());
  solid.inverse_inertia = diagonal<double>(inverse.x(), inverse.y(), inverse.z());
  if (!body.round) {
    const Matrix3<double> turn = matrix_of(state.orientation[slot]) * body.axes;
    solid.inertia = rotated<double>(solid.inertia, turn);
    solid.inverse_inertia = rotated<double>(solid.inverse_inertia, turn);
  }
  // An impulse must not change a mirror-symmetric coordinate: an angular velocity that is not kept
  // would take energy with it.
  for (int k = 0; k < 3; ++k) {
    if (setup.rotates[static_cast<std::size_t>(k)]) continue;
    solid.inverse_inertia.row(k).setZero();
    solid.inverse_inertia.col(k).setZero();
  }
  return solid;
}

CONTACT_SCENES_INLINE std::vector<std::vector<std::size_t>> islands(
    const SteppedSetup& setup, const SteppedState& state,
    const std::vector<BodyContact<double>>& contacts) {
  const std::size_t none = contacts.size();
  std::vector<std::size_t> towards(contacts.size());  // a contact of the same island, or itself
  std::vector<std::size_t> first(setup.bodies.size(), none);  // of a body
  const auto root = [&](std::size_t i) {
    while (towards[i] != i) i = towards[i] = towards[towards[i]];
    return i;
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    towards[i] = i;
    for (const int body : {contacts[i].a, contacts[i].b}) {
      const std::size_t slot = index(body);
      if (slot >= setup.movers || sleeps(state, slot)) continue;
      if (first[slot] == none) first[slot] = i;
      const auto [low, high] = std::minmax({root(first[slot]), root(i)});
      towards[high] = low;
    }
  }
  std::vector<std::vector<std::size_t>> found;
  std::vector<std::size_t> number(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t top = root(i);  // not after i
    if (top == i) {
      number[i] = found.size();
      found.emplace_back();
    }
    found[number[top]].push_back(i);
  }
  return found;
}

CONTACT_SCENES_INLINE void count_iterations(SteppedState& state, std::size_t contacts,
                                            int iterations) {
  state.counts.contacts += contacts;
  state.counts.iterations += static_cast<std::uint64_t>(iterations);
}

/// Iteration budget of an island: work / contacts, and at least a few. In a crowd the minimum is
/// smaller, unless a body would penetrate another.
inline constexpr std::size_t iteration_work = 40000;

inline constexpr int min_iterations = 50;

inline constexpr std::size_t crowd_work = 100000;

inline constexpr int min_crowd_iterations = 4;

inline constexpr std::size_t bounce_work = 5000;

inline constexpr int bounce_iterations = 100;

inline constexpr int iterations_before_exact = 100;

/// Up to this many contacts are solved at once (Jacobi), so that a mirror-symmetric scene stays
/// symmetric. Larger islands would take too many iterations.
inline constexpr std::size_t max_jacobi_contacts = 8;

CONTACT_SCENES_INLINE SolverSettings<double> solver_settings(
    const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
    const std::vector<BodyContact<double>>& contacts, SolveFor what) {
  SolverSettings<double> limits = setup.solver;
  std::vector<int> count(bodies.size(), 0);
  bool alone = true;
  for (const BodyContact<double>& contact : contacts) {
    for (const int body : {contact.a, contact.b}) {
      const bool moves = bodies[index(body)].inverse_mass > 0;
      alone = alone && !(moves && ++count[index(body)] > 1);
    }
  }
  if (alone) limits.relaxation = 1;
  limits.jacobi = !alone && contacts.size() <= max_jacobi_contacts;
  std::size_t work = setup.one_by_one ? iteration_work : crowd_work;
  const int least = setup.one_by_one ? min_iterations : min_crowd_iterations;
  if (what == SolveFor::rest) {
    if (!alone) limits.relaxation = 1.8;
    limits.iterations *= 100;
    work *= 100;
  } else if (what == SolveFor::bounces) {
    limits.iterations = bounce_iterations;
    work = bounce_work;
  }
  const auto many = static_cast<int>(work / (contacts.size() + 1));
  limits.iterations = std::min(limits.iterations, std::max(many, least));
  return limits;
}

CONTACT_SCENES_INLINE SolvedContacts<double> solve_iteratively(
    SteppedState& state, const std::vector<RigidBody<double>>& bodies,
    const std::vector<BodyContact<double>>& contacts,
    const std::vector<ContactImpulse<double>>& start, const SolverSettings<double>& limits) {
  SolvedContacts<double> solved = solve_contacts<double>(bodies, contacts, start, limits);
  count_iterations(state, contacts.size(), solved.report.iterations);
  return solved;
}

CONTACT_SCENES_INLINE SolvedContacts<double> solve_resting(
    SteppedState& state, const std::vector<RigidBody<double>>& bodies,
    const std::vector<BodyContact<double>>& contacts,
    const std::vector<ContactImpulse<double>>& start, const SolverSettings<double>& limits) {
  SolverSettings<double> few = limits;
  few.iterations = std::min(limits.iterations, iterations_before_exact);
  auto swept = solve_iteratively(state, bodies, contacts, start, few);
  if (!(swept.report.last_change > limits.tolerance)) return swept;
  auto finished = solve_active_set<double>(bodies, contacts, swept.impulses);
  if (finished) {
    SolverSettings<double> one = limits;
    one.iterations = 1;
    one.relaxation = 1;
    const auto look = solve_iteratively(state, bodies, contacts, finished->impulses, one);
    finished->report = look.report;
    if (look.report.last_change <= 8 * std::max(limits.tolerance, look.report.rounding))
      return *finished;
  }
  SolverSettings<double> many = limits;
  many.iterations -= few.iterations;
  if (many.iterations < 1) return finished ? *finished : swept;
  swept = solve_iteratively(state, bodies, contacts, finished ? finished->impulses : swept.impulses,
                            many);
  if (finished && finished->report.last_change < swept.report.last_change) return *finished;
  return swept;
}

CONTACT_SCENES_INLINE void settle(const SteppedSetup& setup,
                                  const std::vector<RigidBody<double>>& bodies,
                                  const std::vector<BodyContact<double>>& contacts,
                                  SolvedContacts<double>& solved) {
  if (solved.report.settled || contacts.size() > max_settled_contacts) return;
  auto exact = solve_active_set<double>(bodies, contacts, solved.impulses, FrictionLaw::coulomb,
                                        setup.solver.tolerance);
  if (exact && exact->report.residual < solved.report.residual) solved = std::move(*exact);
}

/// Between bodies whose masses differ by more than this, iterations converge too slowly, and with
/// friction they get an exact solve. For others more iterations cost less.
inline constexpr double unlike_masses = 64;

CONTACT_SCENES_INLINE bool unfinished(const SteppedSetup& setup,
                                      const std::vector<RigidBody<double>>& bodies,
                                      const std::vector<BodyContact<double>>& contacts, double left,
                                      double time, SolveFor what) {
  double fastest = 0;
  bool has_friction = false;
  for (const BodyContact<double>& contact : contacts) {
    fastest = std::max(fastest, contact.min_velocity);
    has_friction = has_friction || contact.friction > 0;
  }
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const RigidBody<double>& body : bodies) {
    if (!(body.inverse_mass > 0)) continue;
    least = std::min(least, body.mass);
    most = std::max(most, body.mass);
  }
  const bool unlike = most >= unlike_masses * least;
  if (has_friction && !unlike) return false;
  if (left * time > max_residual(setup)) return true;
  if (what == SolveFor::impacts || (what == SolveFor::anything && unlike && setup.one_by_one))
    return left > 8 * setup.solver.tolerance;
  return what == SolveFor::bounces &&
         left > (has_friction ? fastest / 64
                              : std::max(8 * setup.solver.tolerance, fastest * 0x1p-30));
}

CONTACT_SCENES_INLINE void solve_residual(const SteppedSetup& setup,
                                          const std::vector<RigidBody<double>>& bodies,
                                          std::vector<BodyContact<double>> contacts, double time,
                                          SolvedContacts<double>& solved) {
  auto all = solve_active_set<double>(bodies, contacts, solved.impulses);
  if (!all && solved.report.last_change * time > max_residual(setup)) {
    all = solve_active_set<double>(bodies, contacts, solved.impulses, FrictionLaw::cones);
    for (BodyContact<double>& contact : contacts) contact.friction = 0;
    if (!all) all = solve_active_set<double>(bodies, contacts, solved.impulses);
  }
  if (all) solved = std::move(*all);
}

CONTACT_SCENES_INLINE std::vector<ContactImpulse<double>> solve_now(
    const SteppedSetup& setup, SteppedState& state,
    const std::vector<BodyContact<double>>& contacts) {
  const auto make = [&](std::size_t slot) {
    return solver_body(setup, state, slot, velocity_of(setup, state, slot),
                       angular_velocity_of(state, slot));
  };
  const auto give = [&](std::size_t slot, const RigidBody<double>& body) {
    state.velocity.set(slot, body.velocity);
    if (rotated_by_contacts(setup, slot)) state.angular_velocity.set(slot, body.angular_velocity);
  };
  return solve_islands(setup, state, contacts, {}, 0.0, SolveFor::impacts, make, give);
}

CONTACT_SCENES_INLINE void record_hit(const SteppedSetup& setup, SteppedState& state,
                                      Substep& substep,
                                      const std::vector<BodyContact<double>>& contacts,
                                      const std::vector<ContactImpulse<double>>& impulses,
                                      std::size_t first, std::size_t last) {
  SceneHit hit;
  hit.time = time_of_substep(setup, state, substep);
  state.counts.doubts.add(RunDoubt::contact, hit.time);
  state.counts.doubts.add(RunDoubt::hit, hit.time);
  hit.first = setup.bodies[index(contacts[first].a)].body;
  hit.second = setup.bodies[index(contacts[first].b)].body;
  for (std::size_t i = first; i < last; ++i) {
    hit.point += contacts[i].point / static_cast<double>(last - first);
    hit.impulse += contacts[i].normal * impulses[i].normal + impulses[i].tangential;
  }
  substep.hits.push_back(hit);
  ++state.counts.hits;
}

}  // namespace detail

}  // namespace contact
