// Every test asks for at least two different answers, so that no constant passes one.
#include "drop_test.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;

void check_restitution(double drop, double rebound) {
  // A quotient and a root: 1.5 u. Two roots and a quotient: 3 u, and 2 u of our own.
  const double right = std::sqrt(rebound / drop);
  ask("What is the coefficient of restitution?")
      .given("drop", drop)
      .given("rebound", rebound)
      .suspect("ratio-of-heights", [&] { return rebound / drop; })
      .suspect("heights-the-wrong-way-up", [&] { return std::sqrt(drop / rebound); })
      .answer([&] { return exercise::restitution(drop, rebound); })
      .close_to(right, within(8 * 0x1p-53 * right));
}

void check_height(double drop, double k, int bounces) {
  double right = drop;
  double with_k = drop;
  for (int i = 0; i < bounces; ++i) {
    right *= k * k;
    with_k *= k;
  }
  // Two roundings a bounce, in whatever order; a power function is off by less than as many again.
  const double bound = (4 * bounces + 8) * 0x1p-53 * right;
  ask("How high does the ball rise after these bounces?")
      .given("drop", drop)
      .given("k", k)
      .given("bounces", bounces)
      .suspect("height-times-k", [&] { return with_k; })
      .suspect("same-loss-each-bounce", [&] { return drop - (1 - k * k) * drop * bounces; })
      .answer([&] { return exercise::height_after(drop, k, bounces); })
      .close_to(right, within(bound));
}

}  // namespace

TEST_CASE("k is a ratio of speeds") {
  check_restitution(1, 0.25);
  check_restitution(2, 0.5);
  check_restitution(4, 2.25);
  check_restitution(3, 3);
  check_restitution(3, 0);
}

TEST_CASE("one bounce multiplies the height by k squared") {
  check_height(1, 0.5, 1);
  check_height(2, 0.75, 1);
  check_height(2, 0.75, 0);
  check_height(2, 1, 1);
}

TEST_CASE("each bounce starts from the height before") {
  check_height(1, 0.5, 2);
  check_height(1, 0.5, 5);
  check_height(3, 0.875, 4);
  check_height(3, 0, 3);
}

TEST_CASE("random drops agree") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double drop = random.uniform(0.1, 9);
    const double rebound = drop * random.uniform(0.01, 0.99);
    check_restitution(drop, rebound);
    const double k = random.uniform(0.1, 0.99);
    check_height(drop, k, random.integer(1, 12));
  }
}
