#include "support/questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/collision_1d.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/cradle.hpp>
#include <contact/friction_pyramid.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/two_contacts.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <vector>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>

#include "figures/blocks.hpp"
namespace questions_test {

namespace two_feet {
#include "figures/two_feet.cpp"
}
namespace iterations {
#include "figures/iterations.cpp"
}
namespace stack {
#include "figures/stack.cpp"
}

namespace {

using Vector = contact::Vector3<double>;
using Bodies = std::vector<contact::RigidBody<double>>;
using Contacts = std::vector<contact::BodyContact<double>>;

/// The box of 2 m × 1 m in the plane of x and z, and the ground.
Bodies falling_box() {
  auto box = contact::rigid_body<double>(1, contact::box_inertia<double>(1, {2, 1, 1}),
                                         Vector::Zero(), Vector(0, 0, -1), Vector::Zero());
  return {box, contact::immovable<double>(Vector::Zero(), Vector::Zero(), Vector::Zero())};
}

/// Its corners, the left one first.
Contacts corners() {
  Contacts two(2);
  for (std::size_t i = 0; i < 2; ++i) {
    two[i].b = 1;
    two[i].point = Vector(i == 0 ? -1 : 1, 0, -0.5);
    two[i].normal = Vector(0, 0, 1);
  }
  return two;
}

/// The velocities of both corners after one visit to each of them, in the order of the list, and
/// those after the first visit.
std::array<double, 3> after_visits() {
  const Contacts both = corners();
  const Bodies first = contact::after_normal_impulses<double>(
      falling_box(), {both[0]}, *contact::complementary_impulses<double>(falling_box(), {both[0]}));
  const Bodies second = contact::after_normal_impulses<double>(
      first, {both[1]}, *contact::complementary_impulses<double>(first, {both[1]}));
  return {contact::contact_velocity<double>(first, both[1]),
          contact::contact_velocity<double>(second, both[0]),
          contact::contact_velocity<double>(second, both[1])};
}

contact::TwoContactMatrix<double> matrix_of_corners() {
  const auto a = contact::inverse_effective_mass_matrix<double>(falling_box(), corners());
  CHECK(std::abs(a[0][0] - 3.4) < 1e-12);
  CHECK(std::abs(a[0][1] + 1.4) < 1e-12);
  return {a[0][0], a[0][1], a[1][1]};
}

}  // namespace

KEY("other-corner") { return -after_visits()[0]; }

KEY("how-many-hold") { return 2; }

KEY("which-order") { return 1; }

KEY("left-corner-again") {
  CHECK(std::abs(after_visits()[2]) < 1e-12);
  return -after_visits()[1];
}

KEY("find-closing") {
  two_feet::Input state{0, 0, 0, 0, 0, 0};
  const double winning = two_feet::compute(state).closes;
  state.restitution = 1;
  return questions::Construct{winning, two_feet::compute(state).closes};
}

KEY("both-push") {
  const auto x = contact::solve_two_contacts<double>(matrix_of_corners(), -1, -1);
  CHECK(x->pushes == contact::TwoContactCase::both);
  CHECK(std::abs(x->first - x->second) < 1e-15);
  return x->first;
}

KEY("pushes-though-it-separates") {
  const auto x = contact::solve_two_contacts<double>(matrix_of_corners(), -1, 0.2);
  CHECK(std::abs(x->first - 0.325) < 1e-12);
  return x->second;
}

KEY("table-on-four-legs") {
  // Legs at the corners of a square: one diagonal more, the other less, changes nothing.
  auto table = contact::rigid_body<double>(1, contact::box_inertia<double>(1, {1, 1, 1}),
                                           Vector::Zero(), Vector(0, 0, -1), Vector::Zero());
  const Bodies bodies{table,
                      contact::immovable<double>(Vector::Zero(), Vector::Zero(), Vector::Zero())};
  Contacts legs(4);
  for (std::size_t i = 0; i < 4; ++i) {
    legs[i].b = 1;
    legs[i].point = Vector(i % 2 == 0 ? 0.5 : -0.5, i / 2 == 0 ? 0.5 : -0.5, -0.5);
    legs[i].normal = Vector(0, 0, 1);
  }
  const auto even = contact::after_normal_impulses<double>(bodies, legs, {0.25, 0.25, 0.25, 0.25});
  const auto odd = contact::after_normal_impulses<double>(bodies, legs, {0.5, 0, 0, 0.5});
  CHECK((even[0].velocity - odd[0].velocity).norm() < 1e-15);
  CHECK((even[0].angular_velocity - odd[0].angular_velocity).norm() < 1e-15);
  return 2;
}

KEY("three-balls") {
  const auto x = contact::solve_two_contacts<double>({2, -1, 2}, -2, 0);
  CHECK(std::abs(x->second - 2.0 / 3) < 1e-12);
  return 1 - x->first;
}

KEY("clamp-the-sum") {
  // A ball of 1 kg that leaves the ground at 0.5 m/s, of a contact that has given 0.3 N·s.
  Bodies bodies = falling_box();
  bodies[0].velocity = Vector(0, 0, 0.5);
  Contacts one{corners()[0]};
  one[0].point = Vector(0, 0, -0.5);
  auto impulses = std::vector<contact::detail::ImpulseComponents<double>>{{0.3, 0, 0}};
  contact::detail::gauss_seidel_iteration<double>(
      bodies, contact::detail::prepared_contacts<double>(bodies, one), impulses, 1);
  CHECK(impulses[0][0] == 0);
  return bodies[0].velocity.z() - 0.5;
}

KEY("iterations-for-a-micrometre") {
  for (int count = 1;; ++count) {
    contact::SolverSettings<double> settings;
    settings.iterations = count;
    settings.tolerance = 0;
    const auto solved = contact::solve_contacts<double>(falling_box(), corners(), {}, settings);
    if (-contact::contact_velocity<double>(solved.bodies, corners()[0]) <= 1e-6)
      return double(count);
  }
}

KEY("find-slow") {
  iterations::Input state{-0.1, 0.05, -2.5, 0.4, {0, 0}, 1, 0.5, 3};
  const double winning = iterations::compute(state).slow;
  state.first = -1;
  return questions::Construct{winning, iterations::compute(state).slow};
}

KEY("pyramid-diagonal") {
  return contact::bounded_friction<double>(contact::FrictionBound::pyramid, {9, 9}, 0.5 * 2).norm();
}

KEY("sliding-distance") {
  std::vector<contact::ShapedBody<double>> scene{
      contact::ground(contact::Plane<double>{Vector(0, 0, 1), 0}),
      contact::solid_box<double>(1, Vector(0.5, 0.5, 0.25), Vector(0, 0, 0.125))};
  scene[1].motion.velocity = Vector(3, 0, 0);
  for (auto& body : scene) body.friction = 0.5;
  contact::StepSettings<double> settings;
  settings.gravity = Vector(0, 0, -9.81);
  settings.step = 1.0 / 64;
  contact::StepMemory<double> memory;
  for (int i = 0; i < 64; ++i) contact::step_contacts(scene, memory, settings);
  return scene[1].motion.position.x();
}

KEY("find-a-warm-stack") {
  stack::Input state{8, 10, 1, 1, 3};
  const double winning = stack::compute(state).warmed;
  state.warm = 0;
  return questions::Construct{winning, stack::compute(state).warmed};
}

}  // namespace questions_test
