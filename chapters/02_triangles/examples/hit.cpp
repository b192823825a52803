// One ray, one triangle, five methods.
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>
#include <cstdio>

using contact::Ray;
using contact::Triangle;
using contact::TriangleHit;
using contact::Vector3;

int main() {
  const Triangle<double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 2}};
  const Ray<double> ray{{1, 1, 5}, {0, 0, -2}};
  const auto show = [&](const char* method, const std::optional<TriangleHit<double>>& hit) {
    if (!hit) {
      std::printf("%-18s no hit\n", method);
      return;
    }
    const auto& w = hit->barycentric;
    const Vector3<double> point = ray.origin + hit->t * ray.direction;
    std::printf("%-18s t = %g at (%g, %g, %g), weights %g, %g, %g\n", method, hit->t, point.x(),
                point.y(), point.z(), w.x(), w.y(), w.z());
  };
  show("edge tests", contact::intersect_by_edges(ray, triangle));
  show("dropped dimension", contact::intersect_by_dropping(ray, triangle));
  show("Moller-Trumbore", contact::intersect_moller_trumbore(ray, triangle));
  show("watertight", contact::intersect_watertight(ray, triangle));
  show("exact", contact::intersect_exact(ray, triangle));
}
