/// @file
/// Bodies that stand on a plane from above or below, for the tests of contacts: they touch, and no
/// point is inside both.
#pragma once

#include <05_meshes/solids.hpp>
#include <support/generators.hpp>

namespace touching_bodies {

using solids::Mesh;
using solids::Point;

/// What a body is made of; see upper().
struct Recipe {
  int kind;
  std::array<int, 8> base;  ///< x and y of four points
  std::array<int, 2> top;   ///< x and y of an apex, or by how much a prism leans
  int order;                ///< of its triangles and vertices; 0 as made
};

inline constexpr int kinds = 6;
inline constexpr double height = 3;

inline Eigen::Vector2d base_point(const Recipe& recipe, int i) {
  const auto at = static_cast<std::size_t>(2 * i);
  return {recipe.base[at], recipe.base[at + 1]};
}
inline Point in_space(const Eigen::Vector2d& p, double z) { return {p.x(), p.y(), z}; }

/// Whether p, q, r are counter-clockwise.
inline bool turns_left(const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                       const Eigen::Vector2d& r) {
  const Eigen::Vector2d u = q - p, v = r - p;
  return u.x() * v.y() - u.y() * v.x() > 0;
}

inline Mesh pyramid(const std::vector<Eigen::Vector2d>& base, const Point& apex) {
  Mesh mesh;
  const int n = static_cast<int>(base.size());
  for (const Eigen::Vector2d& p : base) mesh.vertices.push_back(in_space(p, 0));
  mesh.vertices.push_back(apex);
  for (int i = 0; i < n; ++i) mesh.triangles.push_back({i, (i + 1) % n, n});
  for (int i = 1; i + 1 < n; ++i) mesh.triangles.push_back({i + 1, i, 0});
  return mesh;
}

inline Mesh leaning_prism(const std::vector<Eigen::Vector2d>& base, const Recipe& recipe) {
  std::vector<std::array<int, 3>> caps{{0, 1, 2}};
  if (base.size() == 4) caps.push_back({0, 2, 3});
  Eigen::Matrix3d lean = Eigen::Matrix3d::Identity();
  lean(0, 2) = recipe.top[0];
  lean(1, 2) = recipe.top[1];
  return solids::moved(solids::prism(base, caps, 0, height), lean, {0, 0, 0});
}

/// Four vertices, of which the first few are on the plane; empty without volume.
inline Mesh tetrahedron(const Recipe& recipe, int on_plane) {
  std::array<Point, 4> p;
  for (int i = 0; i < 4; ++i)
    p[static_cast<std::size_t>(i)] = in_space(base_point(recipe, i), i < on_plane ? 0 : height);
  const Mesh mesh = solids::tetrahedron(p[0], p[1], p[2], p[3]);
  const std::int64_t ahead = solids::ahead(triangle_of(mesh, 0), p[3]);
  return ahead == 0 ? Mesh{} : (ahead < 0 ? mesh : solids::inside_out(mesh));
}

/// A body above the plane z = 0, with a part of its surface in it. Empty if the recipe makes none.
inline Mesh upper(const Recipe& recipe) {
  if (recipe.kind == 4) return tetrahedron(recipe, 2);
  if (recipe.kind == 5) return tetrahedron(recipe, 1);
  std::vector<Eigen::Vector2d> base;
  for (int i = 0; i < (recipe.kind % 2 == 0 ? 3 : 4); ++i) base.push_back(base_point(recipe, i));
  if (!turns_left(base[0], base[1], base[2])) return {};
  if (base.size() == 4 && !turns_left(base[0], base[2], base[3])) return {};
  if (recipe.kind < 2) return leaning_prism(base, recipe);
  return pyramid(base, {double(recipe.top[0]), double(recipe.top[1]), height});
}

/// The same mesh, with triangles and vertices in another order.
inline Mesh reordered(const Mesh& mesh, int order) {
  if (order == 0) return mesh;
  generators::Random random(static_cast<std::uint64_t>(order));
  const auto shuffle = [&](auto& list) {
    for (std::size_t i = list.size(); i > 1; --i)
      std::swap(list[i - 1],
                list[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  };
  std::vector<std::size_t> from(mesh.vertices.size());
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = i;
  shuffle(from);
  Mesh result;
  std::vector<int> to(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    result.vertices.push_back(mesh.vertices[from[i]]);
    to[from[i]] = static_cast<int>(i);
  }
  const auto index = [&](int v) { return to[static_cast<std::size_t>(v)]; };
  for (const auto& [a, b, c] : mesh.triangles)
    result.triangles.push_back({index(b), index(c), index(a)});
  shuffle(result.triangles);
  return result;
}

/// Like solids::moved, with the outside remaining outside.
inline Mesh placed(const Mesh& mesh, const Eigen::Matrix3d& map, const Point& shift) {
  const Mesh result = solids::moved(mesh, map, shift);
  return map.determinant() > 0 ? result : solids::inside_out(result);
}

/// Below the plane.
inline Mesh lower(const Recipe& recipe) {
  return placed(upper(recipe), Eigen::Vector3d(1, 1, -1).asDiagonal(), {0, 0, 0});
}

inline Recipe any_recipe(generators::Random& random, int size) {
  Recipe recipe{random.integer(0, kinds - 1), {}, {}, random.integer(0, 1000)};
  for (int& x : recipe.base) x = random.integer(-size, size);
  for (int& x : recipe.top) x = random.integer(-1, 1);
  return recipe;
}

}  // namespace touching_bodies
