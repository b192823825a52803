// What the figures of the chapter draw: the area under a force is the impulse, the energy of a
// bounce in steps is between its bounds, and a stack's steps grow beyond its limit only.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bounce_energy.hpp>
#include <contact/penalty_force.hpp>
#include <contact/soft_to_rigid.hpp>
#include <contact/spring_impact.hpp>
#include <contact/spring_stack.hpp>
#include <contact/squash.hpp>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "support/generators.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace soft_to_rigid {
#include "figures/soft_to_rigid.cpp"
}
namespace step_and_energy {
#include "figures/step_and_energy.cpp"
}
namespace sagging_stack {
#include "figures/sagging_stack.cpp"
}

namespace {

using generators::Random;

soft_to_rigid::Input impact(Random& random) {
  soft_to_rigid::Input in{};
  in.hardness = random.uniform(0, 1);
  in.ratio = random.chance(0.2) ? 0 : random.uniform(0, 1.5);
  in.time = random.uniform(-0.1, 0.5);
  in.release = random.integer(0, 1);
  return in;
}

/// The area under samples at equal distances, by Simpson's rule.
double area(const soft_to_rigid::Samples& moment, const soft_to_rigid::Samples& force) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < force.size(); i += 2) {
    sum += force[i] + 4 * force[i + 1] + force[i + 2];
  }
  return sum * (moment[1] - moment[0]) / 3;
}

step_and_energy::Input steps(Random& random) {
  step_and_energy::Input in{};
  in.stiffness = std::abs(random.magnitude(4, 16));
  const double angle = std::abs(random.magnitude(-6, 1));
  in.step = angle / std::sqrt(in.stiffness);
  in.ratio = random.chance(0.5) ? 0 : random.uniform(0, 1.5);
  in.scheme = random.integer(0, int(step_and_energy::schemes) - 1);
  in.phase = random.uniform();
  return in;
}

/// Energies after the bounces of a scheme.
std::vector<double> energies(const step_and_energy::Output& out, double scheme) {
  const auto s = static_cast<std::size_t>(scheme);
  const std::size_t first = s * (step_and_energy::bounces + 1);
  const auto* begin = out.energy.data() + first;
  return {begin, begin + static_cast<std::size_t>(out.counted[s]) + 1};
}

}  // namespace

TEST_CASE("the area under the force that the figure draws is the impulse, whatever the stiffness") {
  Random random(1);
  int checked = 0, pulled = 0;
  for (int i = 0; i < generators::tried(1500); ++i) {
    const soft_to_rigid::Input in = impact(random);
    const soft_to_rigid::Output out = soft_to_rigid::compute(in);
    REQUIRE(out.problem == 0);
    if (!(out.duration < soft_to_rigid::last_moment)) continue;
    INFO("impact " << i);
    double all = area(out.moment, out.force);
    if (in.release == 1 && out.pulls == 1) {
      const double pull = area(out.pull_moment, out.pull_force);
      CHECK(pull < 0);
      all += pull;
      ++pulled;
    }
    CHECK(std::abs(all - out.impulse) <= 1e-4 * out.impulse);
    ++checked;
  }
  CHECK(checked > generators::tried(700));
  CHECK(pulled > generators::tried(150));
}

TEST_CASE("every contact of the figure changes the velocity by the same jump") {
  Random random(2);
  for (int i = 0; i < generators::tried(1500); ++i) {
    soft_to_rigid::Input in = impact(random);
    in.time = 0.5;
    const soft_to_rigid::Output soft = soft_to_rigid::compute(in);
    if (!(soft.duration < in.time)) continue;
    in.hardness = 1;
    const soft_to_rigid::Output rigid = soft_to_rigid::compute(in);
    INFO("impact " << i);
    CHECK(rigid.rigid == 1);
    CHECK(rigid.duration == 0);
    CHECK(std::abs(soft.velocity_now - rigid.velocity_now) <= 1e-13);
    CHECK(soft.impulse == rigid.impulse);
  }
}

TEST_CASE("the figure's ball rests on the ground while it overlaps, and keeps its area") {
  Random random(3);
  int overlapping = 0;
  for (int i = 0; i < generators::tried(1500); ++i) {
    const soft_to_rigid::Output out = soft_to_rigid::compute(impact(random));
    INFO("impact " << i);
    const double round = soft_to_rigid::radius * soft_to_rigid::radius;
    CHECK(std::abs(out.half_width * out.half_height - round) <= 1e-15);
    const double lowest = out.centre.z() - out.half_height;
    CHECK(std::abs(lowest - std::max(0.0, -out.penetration)) <= 1e-15);
    overlapping += out.penetration > 0 ? 1 : 0;
  }
  CHECK(overlapping > generators::tried(200));
}

TEST_CASE("the figure's contact pulls only if the reader allows it") {
  Random random(4);
  int pulls = 0;
  for (int i = 0; i < generators::tried(1500); ++i) {
    const soft_to_rigid::Input in = impact(random);
    const soft_to_rigid::Output out = soft_to_rigid::compute(in);
    INFO("impact " << i);
    CHECK(out.push >= 0);
    CHECK((out.force_now >= 0 || in.release == 1));
    // The centre is rounded, and the force of the ball is computed from it.
    const double scale = out.stiffness * 0x1p-52 + 0x1p-50 * std::abs(out.push);
    if (out.touches == (out.penetration >= 0 ? 1 : 0)) {
      CHECK(std::abs(out.push_vector.z() - out.push) <= scale);
    }
    pulls += out.pulled == 1 ? 1 : 0;
  }
  CHECK(pulls > generators::tried(40));
}

TEST_CASE("each bounce of the figure without damper changes the energy within its bounds") {
  Random random(5);
  int outside = 0;
  for (int i = 0; i < generators::tried(600); ++i) {
    step_and_energy::Input in = steps(random);
    in.ratio = 0;
    in.scheme = 1;
    const step_and_energy::Output out = step_and_energy::compute(in);
    REQUIRE(out.problem == 0);
    const std::vector<double> energy = energies(out, 1);
    INFO("steps " << i);
    for (std::size_t n = 1; n < energy.size(); ++n) {
      const double factor = energy[n] / energy[n - 1];
      CHECK(factor >= out.min_kept * (1 - 1e-9));
      CHECK(factor <= out.max_kept * (1 + 1e-9));
      outside += factor < 0.9 || factor > 1.1 ? 1 : 0;
    }
  }
  CHECK(outside > generators::tried(200));
}

TEST_CASE("with short steps every scheme of the figure keeps the energy of the closed form") {
  Random random(6);
  for (int i = 0; i < generators::tried(400); ++i) {
    step_and_energy::Input in = steps(random);
    in.step = 0.002 / std::sqrt(in.stiffness);
    const step_and_energy::Output out = step_and_energy::compute(in);
    const double angle = out.rate * in.step;
    INFO("steps " << i << ", scheme " << in.scheme << ", ratio " << in.ratio);
    REQUIRE(out.counted[static_cast<std::size_t>(in.scheme)] >= 1);
    CHECK(std::abs(out.first_kept - out.kept) <= 5 * angle);
    CHECK(out.has_limit == (in.scheme == 3 ? 0 : 1));
  }
}

TEST_CASE("the figure's first step in a contact is one of semi-implicit Euler") {
  Random random(7);
  for (int i = 0; i < generators::tried(500); ++i) {
    const step_and_energy::Input in = steps(random);
    const step_and_energy::Output out = step_and_energy::compute(in);
    INFO("steps " << i);
    const double pull = in.stiffness * out.first_overlap + out.damping * out.first_approach;
    const double speed = out.first_approach - in.step * pull / out.mass;
    const double unit = 0x1p-45 * (1 + std::abs(out.first_approach) + std::abs(in.step * pull));
    CHECK(std::abs(out.next_approach - speed) <= unit);
    CHECK(std::abs(out.next_penetration - (out.first_overlap + in.step * speed)) <= unit);
  }
}

TEST_CASE("the figure's stack of n boxes sags at the bottom by n times the top") {
  for (int n = 1; n <= 10; ++n) {
    const sagging_stack::Input in{double(n), 4096, 0.01, 1, 3};
    const sagging_stack::Output out = sagging_stack::compute(in);
    REQUIRE(out.problem == 0);
    const auto count = static_cast<std::size_t>(n);
    CHECK(std::abs(out.sag[0] - n * out.sag[count - 1]) <= 1e-14);
    CHECK(std::abs(out.top_sag - n * (n + 1.0) / 2 * out.sag[count - 1]) <= 1e-13);
  }
}

TEST_CASE("the figure's implicit steps lose energy until the stack rests, however long they are") {
  Random random(8);
  for (int i = 0; i < generators::tried(60); ++i) {
    const double boxes = random.integer(1, 10), step = random.uniform(0.01, 1);
    const double stiffness = random.uniform(2000, 100000);
    double last = std::numeric_limits<double>::infinity();
    for (const double time : {0.0, 1.0, 2.0, 3.0}) {
      const sagging_stack::Output out = sagging_stack::compute({boxes, stiffness, step, 1, time});
      REQUIRE(out.problem == 0);
      INFO("stack " << i << " at " << time << " s");
      CHECK(out.energy <= last);
      last = out.energy;
    }
    CHECK(last < 1);
  }
}

TEST_CASE("the figure's stack grows in steps beyond its limit, and stays bounded below") {
  Random random(9);
  for (int i = 0; i < generators::tried(60); ++i) {
    const double boxes = random.integer(2, 10), stiffness = random.uniform(2000, 100000);
    const double limit = sagging_stack::compute({boxes, stiffness, 0.01, 0, 0}).limit;
    const sagging_stack::Output below =
        sagging_stack::compute({boxes, stiffness, 0.9 * limit, 0, 3});
    const sagging_stack::Output beyond =
        sagging_stack::compute({boxes, stiffness, 1.1 * limit, 0, 3});
    INFO("stack " << i);
    CHECK(below.energy < 10);
    CHECK(below.grows == 0);
    CHECK(beyond.energy > 100);
    CHECK(beyond.grows == 1);
    CHECK(beyond.limit < beyond.limit_of_one);
  }
}
