// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// "impulses": the velocities of bodies after simultaneous contacts without friction; class (a), the
// complementarity problem solved in fractions and each coordinate rounded once. "friction" and
// "planar friction": the same with Coulomb's law; see hard_friction.hpp. A method is right if the
// error of every velocity is at most 2^-30 of the largest initial one. "energy", "symmetry" and
// "row": what must hold for any impulses; see hard_invariants.hpp. "points": the number of contact
// points of two bodies; class (a), by counting corners and clipping polygons in fractions. A count
// is right if it is equal. "normal": how far two boxes are apart along the best of fifteen axes;
// class (b).
//
// "support", "pieces" and "points in the plane": where two bodies rest on each other; class (a),
// the vertices of the common part of two faces or edges in fractions, without those that coincide
// or lie between others to within 2^-20 of the smaller face. A method is right if it has as many
// points, each within 2^-16, and the normal within 2^-9. "four points": the largest area that four
// points can hold; class (a). "same point": which point was at the same corner in the previous
// step; class (a).
#include "support/hard_cases.hpp"

#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <vector>

#include "hard_boxes.hpp"
#include "hard_choices.hpp"
#include "hard_friction.hpp"
#include "hard_invariants.hpp"
#include "hard_pieces.hpp"
#include "hard_polygons.hpp"
#include "hard_problem.hpp"
#include "hard_regions.hpp"

using hard_cases::Case;
using hard_cases::Json;
using hard_problem::iterate;
using hard_problem::Problem;
using hard_problem::problem;
using hard_problem::right;
using hard_problem::RigidBody;
using hard_problem::Rule;
using oracle::Rational;

namespace {

/// All velocities to their least values simultaneously, pulls included.
std::vector<RigidBody<double>> glued(const Problem<double>& p) {
  std::vector<double> wanted;
  for (const auto& c : p.contacts) {
    wanted.push_back(c.min_velocity - contact::contact_velocity(p.bodies, c));
  }
  const auto x = contact::detail::solve_linear(
      contact::inverse_effective_mass_matrix(p.bodies, p.contacts), wanted);
  return x ? contact::after_normal_impulses(p.bodies, p.contacts, *x) : p.bodies;
}

void add_impulses(hard_cases::Runner& runner) {
  runner.question("impulses", [](const Case& c) {
    const auto p = problem<Rational>(c);
    const auto x = contact::complementary_impulses(p.bodies, p.contacts);
    if (!x) return Json{{"class", "a"}, {"motion", Json::array()}};
    return Json{{"class", "a"},
                {"motion", hard_problem::motion_of(
                               contact::after_normal_impulses(p.bodies, p.contacts, *x))}};
  });
  const auto method = [&runner](const char* name, auto solve) {
    runner.method("impulses", name, [solve](const Case& c, const Json& answer) {
      return right<double>(c, solve(problem<double>(c)), answer);
    });
  };
  const auto by_rule = [&method](const char* name, const Rule& rule) {
    method(name, [rule](const Problem<double>& p) { return iterate(p, rule); });
  };
  by_rule("one contact after the other", {1});
  by_rule("the same, in reversed order", {1, true});
  by_rule("each change clamped, a hundred iterations", {100});
  Rule shared{1};
  shared.shared = true;
  by_rule("each impulse divided by the number of contacts", shared);
  Rule by_mass{1000};
  by_mass.accumulate = by_mass.by_mass = true;
  by_rule("masses in place of effective masses", by_mass);
  method("one point for the manifold", [](const Problem<double>& p) {
    Rule rule{1000};
    rule.accumulate = true;
    return iterate(hard_problem::with_mean_points(p), rule);
  });
  method("simultaneous, pulls allowed", glued);
  runner.method("impulses", "float, a thousand iterations", [](const Case& c, const Json& answer) {
    Rule rule{1000};
    rule.accumulate = true;
    return right<float>(c, iterate(problem<float>(c), rule), answer);
  });
  method("ten iterations", [](const Problem<double>& p) { return hard_problem::by_book(p, 10); });
  method("book", [](const Problem<double>& p) { return hard_problem::by_book(p, 200000); });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("18_contacts");
  add_impulses(runner);
  hard_friction::add(runner);
  hard_invariants::add(runner);
  hard_boxes::add(runner);
  hard_regions::add(runner);
  hard_pieces::add(runner);
  hard_polygons::add(runner);
  hard_choices::add(runner);
  return runner.run(argc, argv);
}
