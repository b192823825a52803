// Right answers are computed exactly and rounded once. `forward` is stored, so it is a unit vector
// to an ulp only; the bound includes the difference of its inverse from its transpose. Every test
// expects at least two different answers, so that no constant passes.
#include "in_the_wagon.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Wagon;
using Vector = Eigen::Vector2d;

double rounded_to_double(const Exact& x) { return quotient<double>(x, Exact(1.0)); }
Vector left_of(const Wagon& wagon) { return {-wagon.forward.y(), wagon.forward.x()}; }

/// f·v and l·v for v = p − o, computed exactly.
Vector in_axes(const Wagon& wagon, const Vector& p, const Vector& o) {
  const Exact fx(wagon.forward.x());
  const Exact fy(wagon.forward.y());
  const Exact x = Exact(p.x()) - Exact(o.x());
  const Exact y = Exact(p.y()) - Exact(o.y());
  return {rounded_to_double(fx * x + fy * y), rounded_to_double(fx * y - fy * x)};
}

Vector back(const Wagon& wagon, const Vector& p) {
  const Exact fx(wagon.forward.x());
  const Exact fy(wagon.forward.y());
  const Exact x(p.x());
  const Exact y(p.y());
  return {rounded_to_double(Exact(wagon.position.x()) + x * fx - y * fy),
          rounded_to_double(Exact(wagon.position.y()) + x * fy + y * fx)};
}

Vector plain(const Wagon& wagon, const Vector& v) {
  return {wagon.forward.dot(v), left_of(wagon).dot(v)};
}
Vector turned(const Wagon& wagon, const Vector& v) {
  return v.x() * wagon.forward + v.y() * left_of(wagon);
}
Vector mirrored(const Vector& v) { return {v.x(), -v.y()}; }

/// A difference, a product and a sum; or the products before the difference; and 4 u for forward,
/// which is not exactly a unit vector. Doubled.
Vector room(const Vector& p, const Vector& o) {
  const double size = p.cwiseAbs().sum() + o.cwiseAbs().sum();
  return Vector::Constant(16 * 0x1p-53 * size);
}

void check_place(const Wagon& wagon, const Vector& p) {
  ask("What are the coordinates of the position in the wagon's frame?")
      .given("wagon", wagon)
      .given("position", p)
      .suspect("place-not-subtracted", [&]() -> Vector { return plain(wagon, p); })
      .suspect("place-subtracted-after-turning",
               [&]() -> Vector { return plain(wagon, p) - wagon.position; })
      .suspect("turned-the-other-way",
               [&]() -> Vector { return turned(wagon, p - wagon.position); })
      .suspect("left-for-right",
               [&]() -> Vector { return mirrored(plain(wagon, p - wagon.position)); })
      .answer([&] { return exercise::position_in_wagon(wagon, p); })
      .close_to(in_axes(wagon, p, wagon.position), within(room(p, wagon.position)));
}

void check_velocity(const Wagon& wagon, const Vector& v) {
  ask("What is the velocity in the wagon's axes?")
      .given("wagon", wagon)
      .given("velocity", v)
      .suspect("place-subtracted-from-velocity",
               [&]() -> Vector { return plain(wagon, v - wagon.position); })
      .suspect("place-subtracted-from-velocity",
               [&]() -> Vector { return plain(wagon, v) - wagon.position; })
      .suspect("turned-the-other-way", [&]() -> Vector { return turned(wagon, v); })
      .suspect("left-for-right", [&]() -> Vector { return mirrored(plain(wagon, v)); })
      .answer([&] { return exercise::velocity_in_wagon(wagon, v); })
      .close_to(in_axes(wagon, v, {0, 0}), within(room(v, {0, 0})));
}

void check_world(const Wagon& wagon, const Vector& p) {
  ask("What are the coordinates of the position in the world?")
      .given("wagon", wagon)
      .given("position_in_wagon", p)
      .suspect("place-not-subtracted", [&]() -> Vector { return turned(wagon, p); })
      .suspect("turned-the-other-way", [&]() -> Vector { return wagon.position + plain(wagon, p); })
      .suspect("left-for-right",
               [&]() -> Vector { return wagon.position + turned(wagon, mirrored(p)); })
      .answer([&] { return exercise::position_in_world(wagon, p); })
      .close_to(back(wagon, p), within(room(p, wagon.position)));
}

const Wagon kNorth{{2, 1}, {0, 1}};
const Wagon kSlanting{{-3, 5}, {0.6, 0.8}};

}  // namespace

TEST_CASE("ahead is ahead") {
  check_place(kNorth, {2, 4});
  check_place(kNorth, {2, -1});
  check_place({{7, 0}, {1, 0}}, {10, 0});
  check_place(kSlanting, {0, 9});
}

TEST_CASE("left is positive") {
  check_place(kSlanting, {-7, 8});
  check_place(kNorth, {1, 1});
  check_place(kNorth, {5, 1});
}

TEST_CASE("a velocity has no position") {
  check_velocity(kNorth, {0, 5});
  check_velocity(kNorth, {-2, 0});
  check_velocity(kSlanting, {6, 8});
  check_velocity({{100, 100}, {-1, 0}}, {3, 4});
}

TEST_CASE("from the wagon into the world") {
  check_world(kNorth, {3, 0});
  check_world(kNorth, {0, 2});
  check_world(kSlanting, {5, 5});
  check_world(kSlanting, {0, 0});
}

TEST_CASE("random positions agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    Vector f{random.uniform(-1, 1), random.uniform(-1, 1)};
    if (!(f.norm() > 0.1)) f = {0.6, -0.8};
    const Wagon wagon{{random.uniform(-20, 20), random.uniform(-20, 20)}, f / f.norm()};
    const Vector p{random.uniform(-20, 20), random.uniform(-20, 20)};
    check_place(wagon, p);
    check_velocity(wagon, p);
    check_world(wagon, p);
  }
}
