#include "support/questions.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <02_triangles/families.hpp>
#include <array>
#include <contact/barycentric.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/figure.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ray_triangle {
#include "figures/ray_triangle.cpp"
}
namespace barycentric_figure {
#include "figures/barycentric.cpp"
}

namespace questions_test {

namespace {

using contact::Ray;
using contact::Segment;
using contact::Triangle;
using contact::Vector2;
using contact::Vector3;

const Triangle<double> flat{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};

}  // namespace

KEY("crossing-fraction") {
  const auto hit = contact::intersect_by_edges(Segment<double>{{0, 0, 3}, {0, 0, -2}}, flat);
  return hit.value().t;
}

KEY("blended-temperature") {
  return contact::interpolate(Vector3<double>(0.5, 0.25, 0.25), 20.0, 60.0, 100.0);
}

KEY("which-dimension") { return contact::largest_dimension(Vector3<double>(-7, 2, 5)); }

KEY("weight-of-v2") {
  // The one candidate that gives back beta for a point that was made from it.
  const Vector2<double> e1(3, 1), e2(-1, 2);
  const double alpha = 0.25, beta = 0.5;
  const Vector2<double> x = alpha * e1 + beta * e2;
  const double area = contact::cross2(e1, e2);
  const std::array candidates{contact::cross2(x, e1) / area, contact::cross2(x, e2) / area,
                              contact::cross2(e1, x) / area, contact::cross2(e2, x) / area};
  int right = -1;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i] != beta) continue;
    CHECK(right == -1);
    right = static_cast<int>(i);
  }
  return right;
}

KEY("edge-test-steps") {
  // What each step makes, and what it needs of the others; the order follows, and it must be the
  // only one.
  return questions::only_order({{"inside", {"point", "normal"}},
                                {"normal", {}},
                                {"t", {"distances", "divisor not 0"}},
                                {"distances", {"normal"}},
                                {"point", {"t"}},
                                {"divisor not 0", {"distances"}}});
}

KEY("in-the-plane") {
  const Ray<double> ray{{-20, 0, 0}, {1, 0, 0}};
  bool none = true;
  for (const auto& hit :
       {contact::intersect_by_edges(ray, flat), contact::intersect_by_dropping(ray, flat),
        contact::intersect_moller_trumbore(ray, flat), contact::intersect_watertight(ray, flat),
        contact::intersect_exact(ray, flat)}) {
    none = none && !hit.has_value();
  }
  return none ? 2 : 0;
}

KEY("watertight-keeps") {
  bool first = false, second = false, neither = false;
  generators::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const families::Aimed aimed = families::at_shared_edge(random);
    const bool exactly_first =
        contact::intersect_exact(aimed.ray, aimed.triangles[0]).has_value() &&
        !contact::intersect_exact(aimed.ray, aimed.triangles[1]).has_value();
    if (!exactly_first) continue;
    const bool one = contact::intersect_watertight(aimed.ray, aimed.triangles[0]).has_value();
    const bool other = contact::intersect_watertight(aimed.ray, aimed.triangles[1]).has_value();
    first = first || one;
    second = second || other;
    neither = neither || (!one && !other);
  }
  if (first && second) return neither ? 3 : 1;
  return neither ? 2 : 0;
}

KEY("from-behind") {
  ray_triangle::Input in{{0, 0.6, -1}, {0, 0.6, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, 0};
  const double winning = ray_triangle::compute(in).through_the_back;
  in.origin.z() = 1;  // the same ray from the front
  return questions::Construct{winning, ray_triangle::compute(in).through_the_back};
}

KEY("balance-point") {
  barycentric_figure::Input in{
      {-1, -1, 0}, {1, -1, 0.3}, {0, 1, 0.6}, {0, -1.0 / 3, 0.3}, {20, 60, 100}};
  const double winning = barycentric_figure::compute(in).balanced;
  in.point.x() += 0.3;
  return questions::Construct{winning, barycentric_figure::compute(in).balanced};
}

KEY("weights-by-areas") {
  const Vector2<double> a(0, 0), b(4, 0), c(0, 3), p(1, 1);
  const double whole = contact::cross2(Vector2<double>(b - a), Vector2<double>(c - a));
  const double opposite = contact::cross2(Vector2<double>(b - p), Vector2<double>(c - p));
  return questions::Gaps{{"whole", whole}, {"opposite", opposite}, {"weight", opposite / whole}};
}

KEY("why-equal-rounding") {
  // Rays at a shared edge: whether a method never loses one that exactly hits.
  const auto keeps_all = [](auto hits) {
    generators::Random random(1);
    for (int i = 0; i < 20000; ++i) {
      const families::Aimed aimed = families::at_shared_edge(random);
      if (!contact::intersect_exact(aimed.ray, aimed.triangles[0]) &&
          !contact::intersect_exact(aimed.ray, aimed.triangles[1]))
        continue;
      if (!hits(aimed.ray, aimed.triangles[0]) && !hits(aimed.ray, aimed.triangles[1]))
        return false;
    }
    return true;
  };
  return questions::Claim{keeps_all([](const auto& ray, const auto& triangle) {
                            return contact::intersect_watertight(ray, triangle).has_value();
                          }),
                          keeps_all([](const auto& ray, const auto& triangle) {
                            return contact::intersect_moller_trumbore(ray, triangle).has_value();
                          })};
}

}  // namespace questions_test
