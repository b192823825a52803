// A ray between two triangles that share an edge, in float: which one does it hit?
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>
#include <cstdio>

using contact::Ray;
using contact::Triangle;
using contact::Vector3;

int main() {
  const Vector3<float> a(-0x1.aae2b2p-1f, 0x1.0b9248p-1f, -0x1.ec49acp-1f);
  const Vector3<float> b(-0x1.5deb0ap-1f, -0x1.8169dcp-1f, 0x1.a817ep-2f);
  const Triangle<float> near_side{a, b, {0x1.0572bp-1f, -0x1.c88cbap-2f, 0x1.c4685p-2f}};
  const Triangle<float> far_side{b, a, {-0x1.edb4ap-2f, 0x1.98a0cap-1f, 0x1.1d9824p-2f}};
  const Ray<float> ray{{0x1.81305ap-1f, -0x1.50d21p-2f, 0x1.df9492p-1f},
                       {-0x1.7b732cp+0f, -0x1.e4b4cp-6f, -0x1.e54374p-1f}};
  const auto ask = [&](const char* name, const auto& method) {
    const bool near = method(ray, near_side).has_value();
    const bool far = method(ray, far_side).has_value();
    std::printf("%-18s one: %-4s other: %-4s%s\n", name, near ? "hit" : "miss",
                far ? "hit" : "miss", near || far ? "" : "  <- lost");
  };
  ask("edge tests", [](const auto& r, const auto& t) { return contact::intersect_by_edges(r, t); });
  ask("dropped dimension",
      [](const auto& r, const auto& t) { return contact::intersect_by_dropping(r, t); });
  ask("Moller-Trumbore",
      [](const auto& r, const auto& t) { return contact::intersect_moller_trumbore(r, t); });
  ask("watertight",
      [](const auto& r, const auto& t) { return contact::intersect_watertight(r, t); });
  ask("exact", [](const auto& r, const auto& t) { return contact::intersect_exact(r, t); });
}
