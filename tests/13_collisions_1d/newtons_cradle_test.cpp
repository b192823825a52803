// Right answers come from the same rule in the other form, ((m₁ − m₂) v₁ + 2 m₂ v₂)/(m₁ + m₂). An
// elastic collision conserves Σ m v², so in the variables √m v an error neither grows nor shrinks:
// after n collisions two forms differ by at most n times the rounding error of one collision. Rows
// in which a decision would depend on that are skipped. Every test asks for at least two different
// answers, so that no constant passes one.
#include "newtons_cradle.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <algorithm>

namespace {

using namespace contact::testing;
using exercise::Ball;
using Row = std::vector<Ball>;
using Velocities = std::vector<double>;

struct Course {
  Velocities velocities;
  int collisions = 0;
  double nearest = 1;  // margin of the closest decision, relative to the sum of the speeds
};

void hit(const Row& row, Velocities& v, std::size_t i) {
  const double m1 = row[i].mass;
  const double m2 = row[i + 1].mass;
  const double first = ((m1 - m2) * v[i] + 2 * m2 * v[i + 1]) / (m1 + m2);
  v[i + 1] = ((m2 - m1) * v[i + 1] + 2 * m1 * v[i]) / (m1 + m2);
  v[i] = first;
}

Velocities start(const Row& row) {
  Velocities v;
  for (const Ball& ball : row) v.push_back(ball.velocity);
  return v;
}

double sum_of_speeds(const Row& row) {
  double sum = 0;
  for (const Ball& ball : row) sum += std::abs(ball.velocity);
  return sum;
}

Course course(const Row& row, bool swaps, bool rightmost = false) {
  Course result{start(row), 0, 1};
  Velocities& v = result.velocities;
  const double size = std::max(sum_of_speeds(row), 1e-300);
  while (row.size() > 1) {
    std::size_t fastest = 0;
    for (std::size_t i = 1; i + 1 < row.size(); ++i) {
      const double more = v[i] - v[i + 1] - (v[fastest] - v[fastest + 1]);
      if (rightmost ? more >= 0 : more > 0) fastest = i;
    }
    const double closing = v[fastest] - v[fastest + 1];
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      // Pairs without a common ball may collide in any order.
      const bool apart = i > fastest + 1 || fastest > i + 1;
      if (i == fastest || apart) continue;
      const double margin = std::abs(closing - (v[i] - v[i + 1]));
      if (closing > 0) result.nearest = std::min(result.nearest, margin / size);
    }
    // A pair that has just collided separates, without doubt.
    if (closing != 0) result.nearest = std::min(result.nearest, std::abs(closing) / size);
    if (!(closing > 0) || result.collisions == 1000) break;
    if (swaps) {
      std::swap(v[fastest], v[fastest + 1]);
    } else {
      hit(row, v, fastest);
    }
    ++result.collisions;
  }
  return result;
}

Velocities as_lump(const Row& row) {
  double mass = 0;
  double momentum = 0;
  for (std::size_t i = 1; i < row.size(); ++i) {
    mass += row[i].mass;
    momentum += row[i].mass * row[i].velocity;
  }
  Row two{row[0], {mass, momentum / mass}};
  Velocities v = start(two);
  hit(two, v, 0);
  v.resize(row.size(), v[1]);
  return v;
}

Velocities one_sweep(const Row& row, bool leftwards) {
  Velocities v = start(row);
  const std::size_t pairs = row.size() - 1;
  for (std::size_t k = 0; k < pairs; ++k) {
    const std::size_t i = leftwards ? pairs - 1 - k : k;
    if (v[i] > v[i + 1]) hit(row, v, i);
  }
  return v;
}

Velocities all_at_once(const Row& row) {
  Velocities v = start(row);
  for (int round = 0; round < 1000; ++round) {
    const Velocities old = v;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      if (!(old[i] > old[i + 1])) continue;
      const double change = 2 * (old[i] - old[i + 1]) / (row[i].mass + row[i + 1].mass);
      v[i] -= change * row[i + 1].mass;
      v[i + 1] += change * row[i].mass;
    }
    if (v == old) break;
  }
  return v;
}

Velocities updated_too_early(const Row& row) {
  Velocities v = start(row);
  for (int round = 0; round < 1000; ++round) {
    std::size_t fastest = 0;
    for (std::size_t i = 1; i + 1 < row.size(); ++i) {
      if (v[i] - v[i + 1] > v[fastest] - v[fastest + 1]) fastest = i;
    }
    if (!(v[fastest] > v[fastest + 1])) break;
    const double mass = row[fastest].mass + row[fastest + 1].mass;
    v[fastest] -= 2 * (v[fastest] - v[fastest + 1]) * row[fastest + 1].mass / mass;
    v[fastest + 1] += 2 * (v[fastest] - v[fastest + 1]) * row[fastest].mass / mass;
  }
  return v;
}

/// Bound on the rounding error of n collisions of masses from 1 to `spread`: 16 u of the speeds
/// each, and as much for the other form.
double room(const Row& row, const Course& right) {
  double light = row.empty() ? 1 : row[0].mass;
  double heavy = light;
  for (const Ball& ball : row) {
    light = std::min(light, ball.mass);
    heavy = std::max(heavy, ball.mass);
  }
  return 32 * 0x1p-53 * right.collisions * sum_of_speeds(row) * (heavy / light);
}

double momentum(const Row& row, const Velocities& v) {
  double sum = 0;
  for (std::size_t i = 0; i < row.size(); ++i) sum += row[i].mass * v[i];
  return sum;
}

double energy(const Row& row, const Velocities& v) {
  double sum = 0;
  for (std::size_t i = 0; i < row.size(); ++i) sum += row[i].mass * v[i] * v[i] / 2;
  return sum;
}

bool energy_alone_differs(const Row& row, const Velocities& got) {
  if (got.size() != row.size() || row.size() < 2) return false;
  double mass = 0;
  for (const Ball& ball : row) mass += ball.mass;
  const double speed = sum_of_speeds(row);
  const Velocities before = start(row);
  const double gained = energy(row, got) - energy(row, before);
  return std::abs(momentum(row, got) - momentum(row, before)) <= 1e-9 * mass * speed &&
         std::abs(gained) > 1e-6 * mass * speed * speed;
}

void check(const Row& row) {
  const Course right = course(row, false);
  const Velocities allowed(row.size(), room(row, right));
  ask("What are the velocities when no neighbours approach any more?")
      .given("row", row)
      .suspect("swaps-whatever-the-mass", [&] { return course(row, true).velocities; })
      .suspect("row-as-a-lump", [&] { return as_lump(row); })
      .suspect("rightmost-of-equals", [&] { return course(row, false, true).velocities; })
      .suspect_if("energy-not-conserved",
                  [&](const Velocities& got) {
                    // All pairs at once do not conserve it either, which is another mistake.
                    const Velocities at_once = all_at_once(row);
                    const auto near = [](double x, double y) { return std::abs(x - y) < 1e-9; };
                    return energy_alone_differs(row, got) &&
                           !std::equal(got.begin(), got.end(), at_once.begin(), at_once.end(),
                                       near);
                  })
      .suspect("one-sweep", [&] { return one_sweep(row, false); })
      .suspect("one-sweep", [&] { return one_sweep(row, true); })
      .suspect("all-pairs-at-once", [&] { return all_at_once(row); })
      .suspect("updated-too-early", [&] { return updated_too_early(row); })
      .answer([&] { return exercise::settled(row); })
      .close_to(right.velocities, within(allowed));
}

Row equals(const Velocities& velocities) {
  Row row;
  for (const double v : velocities) row.push_back({1, v});
  return row;
}

}  // namespace

TEST_CASE("one in, one out") {
  check(equals({1, 0}));
  check(equals({1, 0, 0, 0, 0}));
  check(equals({0, 0, 0, -2}));
}

TEST_CASE("as many leave as come in") {
  check(equals({1, 1, 0, 0, 0}));
  check(equals({3, 3, 3, 0, 0}));
  check(equals({0, 0, 0, -1, -1}));
}

TEST_CASE("balls that come in from both sides") {
  check(equals({1, 0, 0, -1}));
  check(equals({2, 1, 0, 0, -4}));
  check(equals({-1, 0, 1}));
  check({});
  check(equals({7}));
}

TEST_CASE("a heavy ball among light ones") {
  check({{1, 3}, {2, 0}, {1, 0}});
  check({{4, 5}, {1, 0}, {1, 0}});
  check({{1, 8}, {1, 0}, {7, 0}});
  check({{1, 4}, {1, 0}, {3, -4}});  // both pairs approach at the same speed
}

TEST_CASE("random rows settle by the rule of the contract") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 200;) {
    Row row;
    for (int n = random.integer(2, 7); n > 0; --n) {
      const double mass = random.uniform(1, 4);
      row.push_back({mass, random.uniform(-9, 9)});
    }
    if (course(row, false).nearest < 1e-9) continue;
    check(row);
    ++asked;
  }
}
