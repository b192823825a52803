// One point in place of a manifold: what a rod does that falls flat.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <cstddef>
#include <vector>

namespace one_point_test {
namespace {

using V = contact::Vector3<double>;

/// A rod of 1 kg, 2 m long, that falls flat onto the ground at 1 m/s.
const V half{1, 0.05, 0.05};

struct Landing {
  std::vector<contact::RigidBody<double>> bodies;
  std::vector<contact::BodyContact<double>> contacts;
};
Landing landing() {
  const V position(0, 0, 0.05);
  Landing made;
  made.bodies = {contact::immovable<double>(V(0, 0, 0), V(0, 0, 0), V(0, 0, 0)),
                 contact::rigid_body<double>(1.0, contact::box_inertia<double>(1.0, V(2 * half)),
                                             position, V(0, 0, -1), V(0, 0, 0))};
  const contact::OrientedBox<double> rod{position, contact::Matrix3<double>::Identity(), half};
  const contact::HalfSpace<double> ground{{V(0, 0, 1), 0}};
  const auto manifold = contact::contact_manifold(rod, ground, 1e-9);
  for (const auto& p : manifold.points) {
    made.contacts.push_back({1, 0, p.point, manifold.normal, 0, 0});
  }
  return made;
}

/// The vertical velocity of the rod's point there.
double velocity_up(const contact::RigidBody<double>& rod, const V& point) {
  return contact::velocity_at(rod, point).z();
}

}  // namespace

TEST_CASE("a rod that falls flat stops without turning on all its points") {
  const Landing made = landing();
  REQUIRE(made.contacts.size() == 4);
  const auto solved = contact::solve_contacts<double>(made.bodies, made.contacts);
  CHECK(solved.bodies[1].velocity.norm() <= 1e-10);
  CHECK(solved.bodies[1].angular_velocity.norm() <= 1e-10);
}

TEST_CASE("with one point of the manifold the rod turns, and its other end enters the ground") {
  for (std::size_t only = 0; only < 4; ++only) {
    Landing made = landing();
    made.contacts = {made.contacts[only]};
    const V here = made.contacts[0].point;
    const V opposite(-here.x(), -here.y(), here.z());
    const auto solved = contact::solve_contacts<double>(made.bodies, made.contacts);
    CHECK(solved.bodies[1].angular_velocity.norm() > 0.5);
    CHECK(std::abs(velocity_up(solved.bodies[1], here)) <= 1e-10);
    CHECK(velocity_up(solved.bodies[1], opposite) < -1.5);  // 1 before
  }
}

}  // namespace one_point_test
