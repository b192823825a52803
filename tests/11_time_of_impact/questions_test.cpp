#include "support/questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/bisection.hpp>
#include <contact/conservative_advancement.hpp>
#include <contact/moving_spheres.hpp>
#include <contact/moving_triangles.hpp>
#include <contact/offset_plane.hpp>
#include <contact/previous_free_state.hpp>
#include <contact/relative_motion.hpp>
#include <contact/sliced_steps.hpp>
#include <contact/swept_volumes.hpp>
#include <contact/tunnelling.hpp>
#include <utility>

namespace questions_test {

namespace {

using contact::ImpactBracket;
using contact::Sphere;
using contact::Vector3;

/// Whether a gap that closes from `gap` by `path` in the step is closed at t.
auto closed(double gap, double path) {
  return [=](double t) { return gap - path * t <= 0; };
}

}  // namespace

KEY("late-by") {
  const auto found = contact::sliced_step(closed(2, 5), 1.0, 3);
  REQUIRE(found.has_value());
  return found->hit - 2.0 / 5.0;
}

KEY("slices-for-the-bullet") {
  const auto bullet = contact::mover(0.1, 0.1, 0.0);
  // 1 mm is added to the wall: 0.4 + 0.1 + 0.1, rounded down, is below 0.6.
  int slices = 1;
  while (!contact::slab_tunnelling(bullet, 0.401, 9.0 / slices).nothing_passes()) ++slices;
  CHECK(!contact::slab_tunnelling(bullet, 0.4, 9.0 / (slices - 1)).nothing_passes());
  return double(slices);
}

KEY("interpolated") {
  return contact::interpolated_impact(ImpactBracket<double>{1.0 / 3, 2.0 / 3}, 1.0, -2.0);
}

KEY("after-two-and-a-quarter") {
  // A contact in the middle of what is left, as it is known after two halvings.
  double last = 0;
  const auto overlap = [&](double t) { return last = t, t >= 2.3; };
  const auto bracket = contact::bisect_impact(overlap, ImpactBracket<double>{2, 3}, 2);
  CHECK(bracket.free == 2.25);
  contact::bisect_impact(overlap, bracket, 1);
  return last;
}

KEY("halvings-to-a-millimetre") {
  return double(contact::halvings_to(ImpactBracket<double>{0, 1}, 0.001 / 0.2));
}

KEY("which-beginning") {
  const auto overlap = [](double t) { return (t >= 0.2 && t <= 0.3) || t >= 0.7; };
  return contact::bisect_impact(overlap, ImpactBracket<double>{0, 1}, 50).hit;
}

KEY("rests-above") {
  return contact::gaps_of_previous_free_state<double>({1.0, 0.0, 2.7}, 3, 100).back();
}

KEY("time-of-the-ball") {
  const auto hit = contact::sphere_plane_impact<double>({{0, 0, 3}, 0.5}, {4, 0, -5},
                                                        {Vector3<double>::UnitZ(), 0});
  REQUIRE(hit.has_value());
  return hit->t;
}

KEY("which-point") {
  const Vector3<double> start(0, 0, 3), velocity(4, 0, -5);
  const auto hit =
      contact::sphere_plane_impact<double>({start, 0.5}, velocity, {Vector3<double>::UnitZ(), 0});
  REQUIRE(hit.has_value());
  const Vector3<double> there = start + hit->t * velocity;
  CHECK(there.z() == 0.5);  // not on the plane
  return there == Vector3<double>(2, 0, 0.5) ? 1 : 0;
}

KEY("first-root") {
  const auto t = contact::moving_spheres_impact<double>({{-10, 1.2, 0}, 1}, {20, 0, 0},
                                                        {{0, 0, 0}, 1}, {0, 0, 0});
  REQUIRE(t.has_value());
  return *t;
}

KEY("how-close") {
  const contact::MovingPoint<double> a{{-4, 0, 0}, {8, 0, 0}}, b{{0, -2, 0}, {0, 8, 0}};
  CHECK(contact::paths_meet(a, b, 0.0));
  return contact::closest_approach(a, b).distance;
}

KEY("swept-enough") {
  // The swept volumes meet in both cases; the second disc is at rest only in the first.
  const Sphere<double> a{{-4, 0, 0}, 0.5}, rests{{0, 0, 0}, 0.5}, moves{{0, -2, 0}, 0.5};
  const Vector3<double> along(8, 0, 0), across(0, 8, 0), none = Vector3<double>::Zero();
  CHECK(contact::swept_spheres_meet(a, along, rests, none));
  CHECK(contact::swept_spheres_meet(a, along, moves, across));
  return questions::Claim{contact::moving_spheres_impact(a, along, rests, none).has_value(),
                          contact::moving_spheres_impact(a, along, moves, across).has_value()};
}

KEY("fifteen-intervals") {
  const std::array<std::pair<double, double>, 4> overlaps{
      {{0.1, 0.6}, {0.3, 0.9}, {0, 0.5}, {0, 1}}};
  double first = 0, last = 1;
  for (const auto& [begin, end] : overlaps) {
    first = std::max(first, begin);
    last = std::min(last, end);
  }
  CHECK(last == 0.5);
  return first;
}

KEY("missed-depth") { return contact::missed_chord(0.5, 0.6).depth; }

KEY("first-advance") {
  contact::RotatingBox<double> rod, wall;
  rod.half_lengths = {1, 1e-9, 1e-9};
  rod.velocity = {2, 0, 0};
  rod.angular_velocity = {0, 0, 3};
  wall.half_lengths = {1, 1, 1};
  return 1.0 / contact::approach_bound(rod, wall);
}

KEY("never-past") {
  // A gap of 1 m closes at 2 m/s; the bound is twice the speed, or half of it.
  const auto gap = [](double t) { return 1 - 2 * t; };
  const auto ends_before = [&](double bound) {
    return contact::conservative_advancement(gap, bound, 1.0, 0.001, 1000).t <= 0.5;
  };
  return questions::Claim{ends_before(4.0), ends_before(1.0)};
}

KEY("root-is-not-enough") {
  // The vertex crosses the plane z = 0 at 0.3, beside the triangle or on it.
  const contact::Triangle<double> face{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto meets = [&](double x) {
    return contact::vertex_face_impact<double>({{x, 0.25, -0.3}, {x, 0.25, 0.7}}, {face, face})
        .has_value();
  };
  return meets(0.25) && !meets(2) ? 1 : 0;
}

}  // namespace questions_test
