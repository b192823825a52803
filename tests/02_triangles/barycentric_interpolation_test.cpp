// The weights are known by construction (small numbers, without rounding) or by exact arithmetic.
#include "barycentric_interpolation.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using exercise::Air;
using Triangle = contact::Triangle<double>;
using Vector = Eigen::Vector3d;

/// The weights of the projection of the point on the triangle's plane, rounded once at the end.
Vector exact_weights(const Triangle& triangle, const Vector& point) {
  using contact::Exact;
  using V = contact::Vector3<Exact>;
  const V a = triangle.a.cast<Exact>();
  const V e1 = triangle.b.cast<Exact>() - a, e2 = triangle.c.cast<Exact>() - a;
  const V x = point.cast<Exact>() - a, n = e1.cross(e2);
  const Exact all = n.dot(n), beta = n.dot(x.cross(e2)), gamma = n.dot(e1.cross(x));
  return {quotient<double>(all - beta - gamma, all), quotient<double>(beta, all),
          quotient<double>(gamma, all)};
}

/// A rounded method is equivalent to an exact one with an error c·u·L in each coordinate, L the
/// largest (u = 2^-53): a weight changes by that times (longest edge)/|n|. The method by dot
/// products of the edges has an additional error with the square of |e₁||e₂|/|n|. Both in
/// proportion to the weights. Over 50,000 of the random points below, areas, the dropped dimension
/// and dot products stay within c = 4.5; c = 64 is ample.
Vector bound(const Triangle& triangle, const Vector& point) {
  const Vector e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
  const double n = e1.cross(e2).norm();
  const double edge = std::max({e1.norm(), e2.norm(), (e2 - e1).norm()});
  const double largest =
      std::max({point.norm(), triangle.a.norm(), triangle.b.norm(), triangle.c.norm()});
  const double skew = e1.norm() * e2.norm() / n;
  const double weight = 1 + exact_weights(triangle, point).cwiseAbs().maxCoeff();
  return Vector::Constant(64 * 0x1p-53 * (largest * edge / n + skew * skew) * weight);
}

Vector at(const Triangle& triangle, double beta, double gamma) {
  return triangle.a + beta * (triangle.b - triangle.a) + gamma * (triangle.c - triangle.a);
}

void check(const Triangle& triangle, const Vector& point) {
  const Vector right = exact_weights(triangle, point);
  const Vector sizes = right.cwiseAbs();
  ask("What are the weights of the vertices at this point?")
      .given("triangle", triangle)
      .given("point", point)
      .suspect("beta-sign", [&] { return Vector(1 + right[1] - right[2], -right[1], right[2]); })
      .suspect("weights-of-other-corners", [&] { return Vector(right[1], right[2], right[0]); })
      .suspect("weights-of-other-corners", [&] { return Vector(right[2], right[0], right[1]); })
      .suspect("weights-of-other-corners", [&] { return Vector(right[0], right[2], right[1]); })
      .suspect("unsigned-areas", [&] { return sizes; })
      .suspect("unsigned-areas",
               [&] { return Vector(1 - sizes[1] - sizes[2], sizes[1], sizes[2]); })
      .suspect("weights-clamped", [&] { return Vector(right.cwiseMax(0.0).cwiseMin(1.0)); })
      .answer([&] { return exercise::barycentric(triangle, point); })
      .close_to(right, within(bound(triangle, point)));
}

const Triangle kTilted{{1, 0, 2}, {3, -2, -2}, {1, 4, -6}};

}  // namespace

TEST_CASE("at each vertex its own weight is one") {
  for (const Vector& corner : {kTilted.c, kTilted.b, kTilted.a}) check(kTilted, corner);
}

TEST_CASE("inside, no weight is negative, and the weighted sum of the vertices is the point") {
  check(kTilted, at(kTilted, 0.25, 0.625));
  check(kTilted, at(kTilted, 0.5, 0.125));
  check(kTilted, at(kTilted, 0.25, 0.25));
}

TEST_CASE("beyond an edge, the weight of the opposite vertex is negative") {
  check(kTilted, at(kTilted, 0.75, 0.75));
  check(kTilted, at(kTilted, -0.25, 0.5));
  check(kTilted, at(kTilted, 0.5, -0.25));
}

TEST_CASE("random points in random triangles agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  const auto no_sliver = [](const Triangle& triangle, const Vector&) {
    return (triangle.b - triangle.a).cross(triangle.c - triangle.a).norm() >= 4;
  };
  for (int asked = 0; asked < 500;) {
    const Triangle triangle{vector(8), vector(8), vector(8)};
    // Named, because compilers differ in the order in which they evaluate arguments.
    const double beta = random.uniform(-1, 2), gamma = random.uniform(-1, 2);
    const Vector point = at(triangle, beta, gamma);
    if (!no_sliver(triangle, point)) continue;
    ++asked;
    shrinkable(check, no_sliver, triangle, point);
  }
}

TEST_CASE("a triangle without area is refused") {
  check(kTilted, at(kTilted, 0.5, 0.125));
  const Triangle line{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}, point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  for (const Triangle& triangle : {line, point}) {
    ask("What are the weights of the vertices at this point?")
        .given("triangle", triangle)
        .given("point", triangle.b)
        .answer([&] { return exercise::barycentric(triangle, triangle.b); })
        .throws_invalid_argument();
  }
}

TEST_CASE("temperature and velocity are interpolated by the weights") {
  // Numbers whose products and sums need few bits, so that every order of addition gives the same.
  const Air a{280, {4, 0, -2}}, b{300, {0, 8, 2}}, c{324, {-4, 2, 16}};
  for (const Vector& weights : {Vector(0.5, 0.375, 0.125), Vector(0, 0.25, 0.75), Vector(0, 0, 1),
                                Vector(1.5, 0.25, -0.75)}) {
    const Air right{weights.dot(Vector(a.temperature, b.temperature, c.temperature)),
                    weights[0] * a.velocity + weights[1] * b.velocity + weights[2] * c.velocity};
    ask("What are the temperature and the velocity at the point with these weights?")
        .given("a", a)
        .given("b", b)
        .given("c", c)
        .given("weights", weights)
        .suspect("equal-weights",
                 [&] {
                   return Air{(a.temperature + b.temperature + c.temperature) / 3,
                              (a.velocity + b.velocity + c.velocity) / 3};
                 })
        .answer([&] { return exercise::interpolated(a, b, c, weights); })
        .close_to(right, within(1e-12));
  }
}
