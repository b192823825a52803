// Private tests, as an instructor would write them: against the contract, with what is right known
// without the student's answer.
#include "ray_triangle.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <02_triangles/exact_hit.hpp>

namespace {

using namespace contact::testing;
using Ray = contact::Ray<double>;
using Triangle = contact::Triangle<double>;
using Vector = Eigen::Vector3d;

void check(const Ray& ray, const Triangle& triangle) {
  // Numbers up to 1000 and an edge test that is off by 64 roundings: 1e-9 is more than that.
  ask("Where does the ray meet the triangle?")
      .given("ray", ray)
      .given("triangle", triangle)
      .answer([&] { return exercise::ray_triangle(ray, triangle); })
      .close_to(exact::exact_hit(ray, triangle), within(1e-9));
}

}  // namespace

TEST_CASE("a long thin triangle is hit like any other") {
  const Triangle thin{{0, 0, 0}, {512, 0, 0}, {0, 0.5, 0}};
  for (const double beta : {0.25, 0.75, 0.875, 1.25}) {
    check(exact::aimed(thin, beta, 0.125, {0, 0, -1}, 2), thin);
  }
}

TEST_CASE("rays from far away agree with exact arithmetic") {
  // Another stream than the book's own random test, which takes seed(0).
  generators::Random random(seed(1));
  for (int asked = 0; asked < 200; ++asked) {
    const auto number = [&] { return random.uniform(-8, 8); };
    const Triangle triangle{
        {number(), number(), 0}, {number(), number(), 0}, {number(), number(), 0}};
    const double beta = random.uniform(0.01, 0.49), gamma = random.uniform(0.01, 0.49);
    const Vector n = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
    if (n.norm() < 8) continue;
    check(exact::aimed(triangle, beta, gamma, {number(), number(), -8}, 100), triangle);
  }
}
