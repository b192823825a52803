/// @file
/// What is true of points, edges, faces and polyhedra, in fractions.
#pragma once

#include <algorithm>
#include <array>
#include <contact/mesh.hpp>
#include <cstddef>
#include <optional>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace polyhedra_truth {

using contact::Mesh;
using generators::Random;
using oracle::Rational;

/// Of whole numbers too.
template <class T>
using Three = Eigen::Matrix<T, 3, 1>;

/// The winding number by a ray in a direction of whole numbers that is drawn again until it meets
/// no edge; nothing if the point is on the surface. Triangles without area are left out.
inline std::optional<int> winding(Random& random, const contact::Vector3<double>& point,
                                  const Mesh<double>& mesh) {
  const oracle::Vector p = oracle::exact(point);
  const auto volume = [](const oracle::Vector& a, const oracle::Vector& b,
                         const oracle::Vector& c) { return oracle::sign(a.dot(b.cross(c))); };
  for (;;) {
    oracle::Vector d;
    for (int k = 0; k < 3; ++k) d(k) = random.integer(-1000000, 1000000);
    int winding = 0;
    bool again = false;
    for (std::size_t i = 0; i < mesh.triangles.size() && !again; ++i) {
      const auto t = oracle::exact(contact::triangle_of(mesh, i));
      const oracle::Vector a = t.a - p, b = t.b - p, c = t.c - p;
      const oracle::Vector n = (b - a).cross(c - a);
      const int height = oracle::sign(n.dot(a));
      const int along = oracle::sign(n.dot(d));
      if (height == 0) {  // the point is in the plane
        if (n == oracle::Vector(0, 0, 0)) continue;
        const int ab = oracle::sign(n.dot(a.cross(b))), bc = oracle::sign(n.dot(b.cross(c))),
                  ca = oracle::sign(n.dot(c.cross(a)));
        if (ab >= 0 && bc >= 0 && ca >= 0) return std::nullopt;
        if (along == 0) again = true;
        continue;
      }
      if (along == 0) continue;  // parallel, and not in the plane
      const int ab = volume(d, a, b), bc = volume(d, b, c), ca = volume(d, c, a);
      if (std::min({ab, bc, ca}) < 0 && std::max({ab, bc, ca}) > 0) continue;
      if (ab * bc * ca == 0) again = true;
      if (height == along) winding += along;
    }
    if (!again) return winding;
  }
}

/// Whether a segment and a triangle with an area meet: no axis separates them. The candidates are
/// the normals of the faces of their Minkowski difference.
template <class T>
bool meet_by_axes(const std::array<Three<T>, 2>& s, const std::array<Three<T>, 3>& t) {
  const Three<T> d = s[1] - s[0];
  const std::array<Three<T>, 3> e{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  const Three<T> n = e[0].cross(e[1]);
  std::vector<Three<T>> axes{n, n.cross(d)};
  for (const auto& edge : e) {
    axes.push_back(d.cross(edge));
    axes.push_back(n.cross(edge));
  }
  for (const auto& axis : axes) {
    const T a0 = axis.dot(s[0]), a1 = axis.dot(s[1]);
    const T b0 = axis.dot(t[0]), b1 = axis.dot(t[1]), b2 = axis.dot(t[2]);
    if (std::max(a0, a1) < std::min({b0, b1, b2})) return false;
    if (std::max({b0, b1, b2}) < std::min(a0, a1)) return false;
  }
  return true;
}

/// The same of stored points.
inline bool edge_meets_face(const contact::Segment<double>& s, const contact::Triangle<double>& t) {
  return meet_by_axes<Rational>({oracle::exact(s.start), oracle::exact(s.end)},
                                {oracle::exact(t.a), oracle::exact(t.b), oracle::exact(t.c)});
}

/// Whether two solids meet: an edge meets a face, or a vertex is inside. Every edge, every vertex.
inline bool solids_meet(const Mesh<double>& a, const Mesh<double>& b) {
  Random random(1);
  const auto one_way = [&random](const Mesh<double>& one, const Mesh<double>& other) {
    for (std::size_t i = 0; i < one.triangles.size(); ++i) {
      const auto t = contact::triangle_of(one, i);
      for (const auto& vertex : {t.a, t.b, t.c}) {
        if (winding(random, vertex, other) != 0) return true;
      }
      for (std::size_t j = 0; j < other.triangles.size(); ++j) {
        const auto face = contact::triangle_of(other, j);
        if (polyhedra_truth::edge_meets_face({t.a, t.b}, face) ||
            polyhedra_truth::edge_meets_face({t.b, t.c}, face) ||
            polyhedra_truth::edge_meets_face({t.c, t.a}, face)) {
          return true;
        }
      }
    }
    return false;
  };
  return one_way(a, b) || one_way(b, a);
}

}  // namespace polyhedra_truth
