// A returned index is only compared, not used. Every test expects a hit somewhere.
#include "first_hit.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <02_triangles/exact_hit.hpp>

namespace {

using namespace contact::testing;
using exact::aimed;
using exact::exact_hit;
using exercise::FirstHit;
using Ray = contact::Ray<double>;
using Scene = std::vector<contact::Triangle<double>>;
using Triangle = contact::Triangle<double>;
using Vector = Eigen::Vector3d;
using Found = std::optional<FirstHit>;

/// Every hit of the whole line after `from`, in the order of the list.
std::vector<FirstHit> hits(const Ray& ray, const Scene& scene, double from) {
  const Ray start{ray.origin + from * ray.direction, ray.direction};
  std::vector<FirstHit> all;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (const auto hit = exact_hit(start, scene[i])) all.push_back({int(i), hit->t + from});
  }
  return all;
}

/// The first hit in the order `before(one, other)`.
template <class Before>
Found least(const std::vector<FirstHit>& all, Before&& before) {
  Found found;
  for (const FirstHit& hit : all) {
    if (!found || before(hit, *found)) found = hit;
  }
  return found;
}

Found nearest(const std::vector<FirstHit>& all) {
  return least(all, [](const FirstHit& x, const FirstHit& y) { return x.t < y.t; });
}

/// `tolerance` bounds the error of t.
void check(const Ray& ray, const Scene& scene, double tolerance) {
  const auto ahead = hits(ray, scene, 0);
  const Found right = nearest(ahead);
  ask("Which triangle does the ray meet first?")
      .given("ray", ray)
      .given("triangles", scene)
      .suspect("first-in-list", [&] { return ahead.empty() ? Found{} : Found{ahead.front()}; })
      .suspect("last-hit-kept", [&] { return ahead.empty() ? Found{} : Found{ahead.back()}; })
      .suspect("farthest-hit",
               [&] {
                 return least(ahead,
                              [](const FirstHit& x, const FirstHit& y) { return x.t > y.t; });
               })
      .suspect("hits-behind-origin", [&] { return nearest(hits(ray, scene, -1000)); })
      .suspect("counts-from-one",
               [&] {
                 return right ? Found{FirstHit{right->index + 1, right->t}} : right;
               })
      .answer([&] { return exercise::first_hit(ray, scene); })
      .close_to(right, within(tolerance));
}

/// A triangle perpendicular to the z axis at this height.
Triangle floor_at(double z) { return {{-4, -4, z}, {4, -4, z}, {0, 4, z}}; }

const Ray kUp{{0, 0, 0}, {0, 0, 2}};

}  // namespace

TEST_CASE("the nearest triangle is found at any position in the list") {
  check(kUp, {floor_at(8)}, 1e-12);
  check(kUp, {floor_at(16), floor_at(4), floor_at(32), floor_at(8)}, 1e-12);
  check(kUp, {floor_at(4), floor_at(16), floor_at(8), floor_at(32)}, 1e-12);
  check(kUp, {floor_at(16), floor_at(32), floor_at(8), floor_at(4)}, 1e-12);
  const Triangle aside{{10, 10, 1}, {12, 10, 1}, {10, 12, 1}};
  check(kUp, {aside, floor_at(16), aside, floor_at(4)}, 1e-12);
  // A determinant of exactly 1.
  check({{0.25, 0.25, 3}, {0, 0, -1}}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 1e-12);
}

TEST_CASE("triangles behind the origin do not count, and without a hit there is nothing") {
  check(kUp, {floor_at(-4), floor_at(8), floor_at(-2), floor_at(16)}, 1e-12);
  check(kUp, {floor_at(8), floor_at(0), floor_at(4)}, 1e-12);
  check(kUp, {floor_at(-4), floor_at(-8)}, 1e-12);
  check(kUp, {}, 1e-12);
  // Parallel to the ray, and without area.
  const Triangle wall{{0, -1, 1}, {0, 1, 1}, {0, 0, 5}}, line{{-1, 0, 1}, {0, 0, 1}, {1, 0, 1}};
  check(kUp, {wall, line, floor_at(8)}, 1e-12);
}

TEST_CASE("a hit on an edge or at a vertex counts") {
  const Vector a{0, -4, 4}, b{4, 0, 4}, c{0, 4, 4}, corner{0, 0, 4};
  const auto check_touching = [](const Triangle& touched) {
    const Scene scene{floor_at(16), floor_at(8), touched, floor_at(32)};
    ask("Which triangle does the ray meet first?")
        .given("ray", kUp)
        .given("triangles", scene)
        .suspect("touching-rejected",
                 [] {
                   return Found{FirstHit{1, 4}};
                 })
        .answer([&] { return exercise::first_hit(kUp, scene); })
        .close_to(FirstHit{2, 2}, within(1e-12));
  };
  for (const Triangle& touched : {Triangle{a, b, c}, Triangle{b, c, a}, Triangle{c, a, b}})
    check_touching(touched);
  for (const Triangle& touched :
       {Triangle{corner, b, c}, Triangle{b, c, corner}, Triangle{c, corner, b}})
    check_touching(touched);
}

TEST_CASE("of triangles hit at the same t the first in the list counts") {
  // The same triangle twice: every program finds the same t for both.
  const Scene scene{floor_at(16), floor_at(8), floor_at(8), floor_at(8)};
  ask("Which triangle does the ray meet first?")
      .given("ray", kUp)
      .given("triangles", scene)
      .suspect("later-of-equals",
               [] {
                 return Found{FirstHit{3, 4}};
               })
      .answer([&] { return exercise::first_hit(kUp, scene); })
      .close_to(FirstHit{1, 4}, within(1e-12));
}

TEST_CASE("random scenes agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 100;) {
    const Vector direction = vector(2);
    if (direction.norm() < 1) continue;
    Scene scene;
    std::vector<double> places;
    const Ray ray{vector(1), direction};
    while (scene.size() < 12) {
      // Built so that the line meets it at t with these weights, clear of edges, of grazing and of
      // the other triangles.
      const double beta = random.uniform(-0.5, 1), gamma = random.uniform(-0.5, 1);
      const double t = random.uniform(-8, 16), alpha = 1 - beta - gamma;
      const Vector e1 = vector(8), e2 = vector(8), n = e1.cross(e2);
      if (n.norm() < std::max(4.0, e1.norm() * e2.norm() / 4)) continue;
      if (std::abs(n.dot(direction)) < n.norm() * direction.norm() / 4) continue;
      if (std::min({std::abs(alpha), std::abs(beta), std::abs(gamma), std::abs(t)}) < 1e-3)
        continue;
      const auto too_near = [&](double other) { return std::abs(t - other) < 1e-3; };
      if (std::any_of(places.begin(), places.end(), too_near)) continue;
      places.push_back(t);
      const Vector a = ray.origin + t * direction - beta * e1 - gamma * e2;
      scene.push_back({a, a + e1, a + e2});
    }
    ++asked;
    // As in ray_triangle's test: 64 u L |e1||e2|/(|n| cos) for a direction of at least 1, with
    // L < 128, |e1||e2| < 4 |n| and cos > 1/4.
    check(ray, scene, 2e-11);
  }
}
