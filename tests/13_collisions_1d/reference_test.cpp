#include <catch2/catch_test_macros.hpp>
#include <contact/collision_1d.hpp>

TEST_CASE("the truck and the parked car leave at one velocity") {
  const auto truck = contact::line_body(3000.0, 20.0);
  const auto car = contact::line_body(1000.0, 0.0);
  const auto after = contact::collide(truck, car, 0.0);
  CHECK(after.first == 15);
  CHECK(after.second == 15);
}
