// What the figures of the chapter draw: the boxes that fall are in mirror symmetry and obey
// complementarity, the iterations are those of the solver, a stack that is carried does not sink,
// a box slides as far as the formula says, rows of balls keep momentum, and friction is the nearest
// point of its disc.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <contact/cradle.hpp>
#include <contact/sine_cosine.hpp>
#include <cstddef>
#include <vector>

#include "figures/blocks.hpp"
#include "support/generators.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace two_feet {
#include "figures/two_feet.cpp"
}
namespace iterations {
#include "figures/iterations.cpp"
}
namespace stack {
#include "figures/stack.cpp"
}
namespace sliding_box {
#include "figures/sliding_box.cpp"
}
namespace cradle {
#include "figures/cradle.cpp"
}
namespace friction_disc {
#include "figures/friction_disc.cpp"
}

namespace {

using generators::Random;

two_feet::Input falling(Random& random) {
  two_feet::Input in{};
  in.restitution = random.uniform(0, 1);
  in.friction = random.chance(0.5) ? 0 : random.uniform(0, 1);
  in.tilt = random.chance(0.5) ? 0 : random.uniform(-9, 9);
  in.sideways = random.uniform(-1.5, 1.5);
  in.right_first = random.integer(0, 1);
  in.time = random.uniform(0, 0.2);
  return in;
}

iterations::Input contacts(Random& random) {
  iterations::Input in{};
  in.first = random.uniform(-1.4, 1.4);
  in.second = random.uniform(-1.4, 1.4);
  in.velocity = random.uniform(-3, 1);
  in.angular_velocity = random.uniform(-3, 3);
  in.start = {0, 0};
  in.relaxation = 1;
  in.share = 0.5;
  in.shown = random.integer(0, int(iterations::most));
  return in;
}

stack::Input boxes(double count, double made, double warm) { return {count, made, warm, 1, 3}; }

sliding_box::Input sliding(Random& random) {
  sliding_box::Input in{};
  in.speed = random.uniform(0.5, 3);
  in.direction = random.uniform(0, 90);
  in.friction = random.uniform(0.3, 1);
  in.rate = random.integer(30, 240);
  in.mean = random.integer(0, 1);
  in.time = random.uniform(0, 0.5) * in.speed / (in.friction * blocks::gravity);
  return in;
}

}  // namespace

TEST_CASE("the figure's box that falls flat without friction does not rotate if all is at once") {
  Random random(1);
  int turned = 0;
  for (int i = 0; i < generators::tried(16); ++i) {
    two_feet::Input in = falling(random);
    // Beside the origin the lever arms of the two corners are rounded differently.
    in.tilt = in.friction = in.sideways = 0;
    const two_feet::Output out = two_feet::compute(in);
    REQUIRE(out.problem == 0);
    INFO("box " << i);
    CHECK(out.angular_velocity[2] == 0);
    CHECK(out.angle[2] == 0);
    CHECK(out.after[4] == out.after[5]);
    turned += std::abs(out.angular_velocity[0]) > 0.5 ? 1 : 0;
  }
  CHECK(turned > generators::tried(14));
}

TEST_CASE("the figure's box falls in mirror images if tilt, velocity and list are reversed") {
  Random random(2);
  for (int i = 0; i < generators::tried(10); ++i) {
    const two_feet::Input in = falling(random);
    two_feet::Input mirrored = in;
    mirrored.tilt = -in.tilt;
    mirrored.sideways = -in.sideways;
    mirrored.right_first = 1 - in.right_first;
    const two_feet::Output one = two_feet::compute(in), other = two_feet::compute(mirrored);
    INFO("box " << i);
    for (const std::size_t m : {0U, 2U}) {
      CHECK(std::abs(one.angular_velocity[m] + other.angular_velocity[m]) <= 1e-8);
      CHECK(std::abs(one.after[2 * m] - other.after[2 * m + 1]) <= 1e-8);
      CHECK(std::abs(one.after[2 * m + 1] - other.after[2 * m]) <= 1e-8);
    }
  }
}

TEST_CASE("the figure's impact of all contacts at once adds no energy and leaves none closing") {
  Random random(3);
  for (int i = 0; i < generators::tried(20); ++i) {
    const two_feet::Input in = falling(random);
    const two_feet::Output out = two_feet::compute(in);
    INFO("box " << i);
    CHECK(out.energy[2] <= 1 + 1e-12);
    // A corner above the ground may approach it.
    if (in.tilt == 0) CHECK(std::min(out.after[4], out.after[5]) >= -1e-8);
    CHECK(out.sunk[2] <= 1e-3);
  }
}

TEST_CASE("the impulses that the figure gives for both feet are what its box gets") {
  Random random(4);
  for (int i = 0; i < generators::tried(16); ++i) {
    two_feet::Input in = falling(random);
    in.friction = in.tilt = 0;
    const two_feet::Output out = two_feet::compute(in);
    INFO("box " << i);
    const double up = out.velocity + (out.impulses[0] + out.impulses[1]) / out.mass;
    const double turn =
        (out.lever_arms[0] * out.impulses[0] + out.lever_arms[1] * out.impulses[1]) / out.inertia;
    for (const int k : {0, 1}) {
      const double velocity = up + turn * out.lever_arms[k];
      CHECK(std::abs(velocity - out.after[4 + std::size_t(k)]) <= 1e-8);
      CHECK(std::abs(velocity - in.restitution * 3) <= 1e-8);
    }
  }
}

TEST_CASE("the figure's iterations are those of the solver") {
  Random random(5);
  int pushed = 0;
  for (int i = 0; i < generators::tried(300); ++i) {
    const iterations::Input in = contacts(random);
    const iterations::Output out = iterations::compute(in);
    REQUIRE(out.problem == 0);
    using Vector = contact::Vector3<double>;
    const Vector zero = Vector::Zero(), moments(out.inertia, out.inertia, out.inertia);
    const std::vector<contact::RigidBody<double>> bodies{
        contact::rigid_body_from_axes<double>(
            out.mass, moments, contact::Matrix3<double>::Identity(), zero,
            Vector(0, in.velocity, 0), Vector(0, 0, in.angular_velocity)),
        contact::immovable<double>(zero, zero, zero)};
    const std::vector<contact::BodyContact<double>> both{
        {0, 1, Vector(in.first, 0, 0), Vector(0, 1, 0), 0, 0},
        {0, 1, Vector(in.second, 0, 0), Vector(0, 1, 0), 0, 0}};
    for (const int made : {1, 2, 7}) {
      contact::SolverSettings<double> settings;
      settings.iterations = made;
      settings.tolerance = 0;
      const auto solved = contact::solve_contacts(bodies, both, {}, settings);
      settings.jacobi = true;
      const auto together = contact::solve_contacts(bodies, both, {}, settings);
      INFO("contacts " << i << " after " << made);
      for (const std::size_t k : {0U, 1U}) {
        const auto at = static_cast<Eigen::Index>(k);
        const auto n = static_cast<std::size_t>(made);
        CHECK(std::abs(solved.impulses[k].normal - out.gauss_seidel[2 * n][at]) <= 1e-12);
        CHECK(std::abs(together.impulses[k].normal - out.jacobi[n][at]) <= 1e-12);
        pushed += solved.impulses[k].normal > 0 ? 1 : 0;
      }
    }
  }
  CHECK(pushed > generators::tried(500));
}

TEST_CASE("the figure's error of Gauss-Seidel shrinks by the square of the coupling") {
  Random random(6);
  int checked = 0;
  for (int i = 0; i < generators::tried(300); ++i) {
    const iterations::Input in = contacts(random);
    const iterations::Output out = iterations::compute(in);
    if (out.which != 3 || out.singular != 0) continue;
    INFO("contacts " << i);
    // From the second iteration on both contacts push.
    const double now = (out.gauss_seidel[4] - out.impulses).norm();
    const double next = (out.gauss_seidel[6] - out.impulses).norm();
    CHECK(next <= now * (out.rate + 1e-9) + 1e-12);
    ++checked;
  }
  CHECK(checked > generators::tried(40));
}

TEST_CASE("the lines of the figure pass through the solution where both contacts push") {
  Random random(7);
  int checked = 0;
  for (int i = 0; i < generators::tried(300); ++i) {
    const iterations::Output out = iterations::compute(contacts(random));
    if (out.which != 3 || out.crosses[0] == 0 || out.crosses[1] == 0) continue;
    INFO("contacts " << i);
    for (const auto& line : {out.line1, out.line2}) {
      const contact::Vector2<double> along = line[1] - line[0], from = out.impulses - line[0];
      CHECK(std::abs(along.x() * from.y() - along.y() * from.x()) <= 1e-9);
      for (const auto& end : line) {
        CHECK(end.maxCoeff() <= iterations::high + 1e-9);
        CHECK(end.minCoeff() >= iterations::low - 1e-9);
      }
    }
    ++checked;
  }
  CHECK(checked > generators::tried(30));
}

TEST_CASE("the figure's stack sinks with few iterations from 0, and less with a warm start") {
  for (const double count : {4.0, 10.0}) {
    const auto cold = stack::compute(boxes(count, 4, 0));
    const auto warm = stack::compute(boxes(count, 4, 1));
    const auto more = stack::compute(boxes(count, 32, 1));
    REQUIRE(cold.problem == 0);
    INFO(count << " boxes");
    CHECK(cold.sunk_now > stack::goal);
    CHECK(warm.sunk_now < cold.sunk_now / 4);
    CHECK(more.sunk_now < warm.sunk_now);
    // Both curves are drawn, whichever of the two stacks is.
    CHECK(cold.sunk_now == cold.sunk_from_zero.back());
    CHECK(warm.sunk_now == warm.sunk_warm.back());
    CHECK(cold.sunk_from_zero == warm.sunk_from_zero);
    CHECK(cold.sunk_warm == warm.sunk_warm);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      CHECK(std::abs(more.load[i] - more.weight[i]) <= 0.01 * more.weight[i]);
  }
}

TEST_CASE("the figure's box slides as far as v v / (2 mu g), up to one step") {
  Random random(8);
  for (int i = 0; i < generators::tried(15); ++i) {
    const sliding_box::Input in = sliding(random);
    const auto out = sliding_box::compute(in);
    REQUIRE(out.problem == 0);
    INFO("box " << i);
    const double loss = in.friction * blocks::gravity / in.rate;  // m/s in a step
    CHECK(std::abs(out.cone_distance - out.formula) <= (in.mean == 1 ? loss : in.speed) / in.rate);
    const contact::Vector2<double> line = out.ahead * out.cone_distance;
    CHECK((out.cone_stop - line).norm() <= 1e-12);
    // It slides: the force is on the edge of the cone.
    CHECK((out.cone_friction + out.ahead * in.friction).norm() <= 1e-12);
  }
}

TEST_CASE("the figure's box with the pyramid loses each component of its velocity by itself") {
  Random random(11);
  for (int i = 0; i < generators::tried(15); ++i) {
    sliding_box::Input in = sliding(random);
    in.direction = random.uniform(5, 85);
    in.time = 0.1 * in.speed / (in.friction * blocks::gravity) *
              std::min(in.direction, 90 - in.direction) / 90;
    const auto out = sliding_box::compute(in);
    REQUIRE(out.problem == 0);
    INFO("box " << i);
    const contact::Vector2<double> wanted = out.ahead.cwiseProduct(out.ahead) * out.formula;
    CHECK((out.pyramid_stop - wanted).norm() <= 1.5 * in.speed / in.rate);
    CHECK(out.pyramid_distance <= out.cone_distance + 1e-12);
    CHECK(std::abs(out.pyramid_friction.x() + in.friction) <= 1e-12);
    CHECK(std::abs(out.pyramid_friction.y() + in.friction) <= 1e-12);
  }
  // Along a tangent the two are the same, and on the diagonal the pyramid stops at 1/√2.
  const auto along = sliding_box::compute({3, 0, 0.5, 60, 1, 0.2});
  CHECK(along.pyramid_stop == along.cone_stop);
  const auto diagonal = sliding_box::compute({3, 45, 0.5, 60, 1, 0.2});
  CHECK(std::abs(diagonal.pyramid_distance * std::sqrt(2.0) - diagonal.formula) <= 1e-3);
  CHECK(std::abs(diagonal.pyramid_aside) <= 1e-12);
}

TEST_CASE("the curves that the figure gives for where boxes stop are where they stop") {
  for (const std::size_t i : {0U, 7U, 15U, 30U}) {
    const double degrees = 90.0 * double(i) / double(sliding_box::directions - 1);
    const auto out = sliding_box::compute({2, degrees, 0.4, 240, 1, 0.2});
    INFO(degrees);
    CHECK((out.cone_stops[i] - out.cone_stop).norm() <= 1e-4);
    CHECK((out.pyramid_stops[i] - out.pyramid_stop).norm() <= 1e-4);
  }
}

TEST_CASE("the figure's rows of balls keep momentum, and energy without loss") {
  Random random(9);
  for (int i = 0; i < generators::tried(100); ++i) {
    cradle::Input in{};
    in.balls = random.integer(2, 7);
    in.moving = random.integer(1, int(in.balls) - 1);
    in.restitution = random.chance(0.5) ? 1 : random.uniform(0, 1);
    in.time = 1.8;
    const auto out = cradle::compute(in);
    double one = 0, once = 0;
    for (std::size_t k = 0; k < cradle::max_balls; ++k) {
      one += out.one_after[k];
      once += out.once_after[k];
    }
    INFO("row " << i);
    CHECK(std::abs(one - out.moving) <= 1e-12);
    CHECK(std::abs(once - out.moving) <= 1e-12);
    CHECK(out.one_energy <= 1 + 1e-12);
    CHECK(out.once_energy <= 1 + 1e-12);
    if (in.restitution == 1) {
      CHECK(out.one_energy >= 1 - 1e-12);
      CHECK(out.once_energy >= 1 - 1e-12);
      // As in Newton's cradle.
      CHECK(out.one_leave == out.moving);
    }
  }
}

TEST_CASE("the figure's one ball against two at rest: the last leaves alone, or all move") {
  const auto out = cradle::compute({3, 1, 1, 1.5});
  const std::array<double, 3> one{0, 0, 1}, once{-1.0 / 3, 2.0 / 3, 2.0 / 3};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(std::abs(out.one_after[k] - one[k]) <= 1e-15);
    CHECK(std::abs(out.once_after[k] - once[k]) <= 1e-15);
  }
  CHECK(out.one_leave == 1);
  CHECK(out.once_leave == 3);
  CHECK(out.differ == 1);
}

TEST_CASE("the friction that the figure draws is the nearest point of the disc") {
  Random random(10);
  int slid = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    friction_disc::Input in{};
    in.sum = {random.uniform(-2, 2), random.uniform(-2, 2)};
    in.slip = {random.uniform(-2, 2), random.uniform(-2, 2)};
    in.effective_mass = random.uniform(0.2, 2);
    in.mu = random.uniform(0, 1);
    in.normal = random.uniform(0, 4);
    const friction_disc::Output out = friction_disc::compute(in);
    REQUIRE(out.problem == 0);
    INFO("contact " << i);
    CHECK(out.after.norm() <= out.limit * (1 + 1e-15));
    slid += out.sticks == 0 ? 1 : 0;
    if (out.sticks == 1) {
      CHECK(out.left.norm() <= 1e-14 * (1 + in.slip.norm() + in.sum.norm() / in.effective_mass));
    } else {
      CHECK(out.after.norm() >= out.limit * (1 - 1e-15));
      // No other point of the disc is nearer: they all lie behind the line through this one.
      const double angle = random.uniform(0, 6.28), share = random.uniform(0, 1);
      const auto turn = contact::sine_cosine(angle);
      const contact::Vector2<double> other =
          contact::Vector2<double>(turn.cosine, turn.sine) * (out.limit * share);
      CHECK((out.wanted - out.after).dot(other - out.after) <= 1e-12);
    }
  }
  CHECK(slid > generators::tried(500));
}

TEST_CASE("the goals of the questions are missed where the figures begin, and can be reached") {
  CHECK(two_feet::compute({0.4, 0, 0, 0, 0, 0.12}).closes == 0);
  CHECK(two_feet::compute({0, 0, 0, 0, 0, 0.12}).closes == 1);
  CHECK(two_feet::compute({1, 0, 0, 0, 0, 0.12}).closes == 0);
  CHECK(iterations::compute({-1.2, 0.9, -2.5, 0.4, {0, 0}, 1, 0.5, 3}).slow == 0);
  CHECK(iterations::compute({-0.1, 0.05, -2.5, 0.4, {0, 0}, 1, 0.5, 3}).slow == 1);
  CHECK(stack::compute(boxes(8, 4, 0)).warmed == 0);
  CHECK(stack::compute(boxes(8, 10, 1)).warmed == 1);
}
