/// @file
/// Meshes with whole coordinates, and where a point is of them, in integers and by methods that
/// share nothing with the reference: the point is on a triangle, or a ray that meets no edge counts
/// the triangles. The tests of the exercises compare answers with these.
#pragma once

#include <algorithm>
#include <array>
#include <contact/mesh.hpp>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace solids {

using Mesh = contact::Mesh<double>;
using Point = Eigen::Vector3d;
using Triangle = contact::Triangle<double>;

/// Integers hold every product of three coordinates up to 2^16, and of two with a direction.
struct Vector {
  std::array<std::int64_t, 3> at{};
};
inline Vector difference(const Point& p, const Point& q) {
  Vector d;
  for (int i = 0; i < 3; ++i)
    d.at[static_cast<std::size_t>(i)] =
        static_cast<std::int64_t>(p[i]) - static_cast<std::int64_t>(q[i]);
  return d;
}
inline Vector cross(const Vector& u, const Vector& v) {
  const auto& [a, b, c] = u.at;
  const auto& [x, y, z] = v.at;
  return {{b * z - c * y, c * x - a * z, a * y - b * x}};
}
inline std::int64_t dot(const Vector& u, const Vector& v) {
  return u.at[0] * v.at[0] + u.at[1] * v.at[1] + u.at[2] * v.at[2];
}
inline int sign(std::int64_t x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

/// (b − a) × (c − a).
inline Vector normal(const Triangle& t) {
  return cross(difference(t.b, t.a), difference(t.c, t.a));
}
inline bool has_area(const Triangle& t) { return normal(t).at != Vector{}.at; }

/// Positive in front of the triangle, 0 in its plane.
inline std::int64_t ahead(const Triangle& t, const Point& p) {
  return dot(normal(t), difference(p, t.a));
}

/// For a point in the plane of a triangle with area: the signs that tell whether it is on the inner
/// side of each edge (+1), on its line (0) or outside.
inline std::array<int, 3> inner_sides(const Triangle& t, const Point& p) {
  const Vector n = normal(t);
  const std::size_t axis = n.at[0] != 0 ? 0 : (n.at[1] != 0 ? 1 : 2);
  const auto side = [&](const Point& from, const Point& to) {
    return sign(cross(difference(to, from), difference(p, from)).at[axis]) * sign(n.at[axis]);
  };
  return {side(t.a, t.b), side(t.b, t.c), side(t.c, t.a)};
}

/// Whether the point is on the triangle, its border included. A triangle without area has none of
/// its own: its points are on its neighbours.
inline bool on_triangle(const Triangle& t, const Point& p) {
  if (!has_area(t) || ahead(t, p) != 0) return false;
  const std::array<int, 3> sides = inner_sides(t, p);
  return std::all_of(sides.begin(), sides.end(), [](int side) { return side >= 0; });
}

inline std::vector<Triangle> triangles(const Mesh& mesh) {
  std::vector<Triangle> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) all.push_back(triangle_of(mesh, i));
  return all;
}

inline bool on_surface(const Mesh& mesh, const Point& p) {
  const std::vector<Triangle> all = triangles(mesh);
  return std::any_of(all.begin(), all.end(), [&](const Triangle& t) { return on_triangle(t, p); });
}

/// How the ray p + t·direction with t > 0 meets a triangle with area, if its line does. `t` is the
/// quotient of two integers, of which `over` is positive.
struct Meeting {
  bool at_border = false;
  std::int64_t t = 0, over = 1;
  int side = 0;  ///< of the triangle on which the ray ends: +1 in front, where it leaves the solid
};
inline std::optional<Meeting> meet(const Triangle& triangle, const Point& p, const Vector& d) {
  const Vector n = normal(triangle);
  const std::int64_t rate = dot(n, d);
  if (rate == 0) return std::nullopt;
  const Vector a = difference(triangle.a, p), b = difference(triangle.b, p),
               c = difference(triangle.c, p);
  const std::array<int, 3> sides{sign(dot(d, cross(a, b))), sign(dot(d, cross(b, c))),
                                 sign(dot(d, cross(c, a)))};
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
  if (*least < 0 && *most > 0) return std::nullopt;
  const std::int64_t t = dot(n, a) * sign(rate);
  if (t < 0) return std::nullopt;
  return Meeting{*least == 0 || *most == 0, t, rate * sign(rate), sign(rate)};
}

/// Whether the point is inside a closed mesh, by a ray that meets no edge. The point is not on the
/// surface.
inline bool is_inside(const Mesh& mesh, const Point& p) {
  const std::vector<Triangle> all = triangles(mesh);
  for (std::int64_t k = 0;; ++k) {
    const Vector d{{1009 + k, 613 - 7 * k, 211 + 29 * k}};
    int met = 0;
    bool is_clear = true;
    for (const Triangle& t : all) {
      if (!has_area(t)) continue;
      const auto meeting = meet(t, p, d);
      is_clear = is_clear && dot(normal(t), d) != 0 && !(meeting && meeting->at_border);
      met += meeting ? 1 : 0;
    }
    if (is_clear) return met % 2 == 1;
  }
}

inline bool all_whole(const Mesh& mesh, const Point& p, double limit) {
  const auto is_whole = [limit](const Point& v) {
    return v == v.array().round().matrix() && v.cwiseAbs().maxCoeff() <= limit;
  };
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_whole) && is_whole(p);
}

inline bool indices_fit(const Mesh& mesh) {
  const auto fits = [&](int i) { return i >= 0 && i < static_cast<int>(mesh.vertices.size()); };
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const auto& t) { return std::all_of(t.begin(), t.end(), fits); });
}

/// Whether no vertex is in front of a face, and each edge belongs to as many triangles in one
/// direction as in the other.
inline bool is_convex(const Mesh& mesh) {
  std::vector<std::pair<int, int>> there, back;
  for (const auto& [a, b, c] : mesh.triangles) {
    there.insert(there.end(), {{a, b}, {b, c}, {c, a}});
    back.insert(back.end(), {{b, a}, {c, b}, {a, c}});
  }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  bool has_volume = false;
  for (const Triangle& t : triangles(mesh)) {
    for (const Point& v : mesh.vertices) {
      if (ahead(t, v) > 0) return false;
      has_volume = has_volume || ahead(t, v) < 0;
    }
  }
  return has_volume && there == back;
}

/// a, b, c, d counter-clockwise: divided along a–c.
inline void add_quad(Mesh& mesh, int a, int b, int c, int d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

inline Mesh tetrahedron(const Point& a, const Point& b, const Point& c, const Point& d) {
  return {{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

inline Mesh octahedron(double radius) {
  return {{{radius, 0, 0},
           {-radius, 0, 0},
           {0, radius, 0},
           {0, -radius, 0},
           {0, 0, radius},
           {0, 0, -radius}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// The polygon is counter-clockwise, and `caps` divides it into triangles.
inline Mesh prism(const std::vector<Eigen::Vector2d>& polygon,
                  const std::vector<std::array<int, 3>>& caps, double low, double high) {
  Mesh mesh;
  const int n = static_cast<int>(polygon.size());
  for (const double z : {low, high}) {
    for (const Eigen::Vector2d& v : polygon) mesh.vertices.emplace_back(v.x(), v.y(), z);
  }
  for (const auto& [a, b, c] : caps) {
    mesh.triangles.push_back({c, b, a});
    mesh.triangles.push_back({a + n, b + n, c + n});
  }
  for (int i = 0; i < n; ++i) add_quad(mesh, i, (i + 1) % n, (i + 1) % n + n, i + n);
  return mesh;
}

inline Mesh box(const Point& low, const Point& high) {
  return prism({{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}},
               {{0, 1, 2}, {0, 2, 3}}, low.z(), high.z());
}

/// The 26 points of a 3 × 3 × 3 grid around its centre, each moved away from it by a factor: 48
/// triangles, which the centre sees all.
inline Mesh star(const std::array<int, 26>& factors) {
  Mesh mesh;
  std::array<int, 27> index{};
  int next = 0;
  for (int i = 0; i < 27; ++i) {
    const Point direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (direction.isZero(0)) continue;
    index[static_cast<std::size_t>(i)] = next;
    mesh.vertices.push_back(factors[static_cast<std::size_t>(next++)] * direction);
  }
  const std::array<int, 3> step{1, 3, 9};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int u = step[(axis + 1) % 3], v = step[(axis + 2) % 3];
    const auto vertex = [&](int layer, int i, int j) {
      return index[static_cast<std::size_t>(layer * step[axis] + i * u + j * v)];
    };
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        add_quad(mesh, vertex(2, i, j), vertex(2, i + 1, j), vertex(2, i + 1, j + 1),
                 vertex(2, i, j + 1));
        add_quad(mesh, vertex(0, i, j), vertex(0, i, j + 1), vertex(0, i + 1, j + 1),
                 vertex(0, i + 1, j));
      }
    }
  }
  return mesh;
}

inline Mesh moved(Mesh mesh, const Eigen::Matrix3d& map, const Point& shift) {
  for (Point& v : mesh.vertices) v = map * v + shift;
  return mesh;
}

inline Mesh inside_out(Mesh mesh) {
  for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
  return mesh;
}

inline Mesh together(Mesh mesh, const Mesh& other) {
  const int n = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + n, b + n, c + n});
  return mesh;
}

}  // namespace solids
