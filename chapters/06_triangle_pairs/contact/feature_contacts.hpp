/// @file
/// Which features touch first: the first contact of a mesh that moves along a segment with one at
/// rest, exactly, and why of the six kinds of contact point–face and edge–edge suffice.
///
/// In the following a face contains its edges, and an edge its ends.
///
/// **(a)** *The distance of two triangles without a common point is that of a vertex of one from
/// the other, or that of two edges.* There are nearest pairs of points, because triangles are
/// closed and bounded. Among them take x of A and y of B such that the smallest features f of x and
/// g of y have the smallest sum of dimensions. Suppose that neither x nor y is a vertex and that
/// they are not both on edges. Then one of them, say f, is a face, and g is an edge or a face. The
/// distance of p in f and q in g has a minimum inside both features, so x − y is perpendicular to f
/// and to g. It is not zero, so it is a normal of f, and g is parallel to f. Move both points by
/// the same vector along g: the distance stays the same, until one of them comes to the border of
/// its feature. Then they are a nearest pair with smaller features: a contradiction. ∎
///
/// The hypothesis is needed: the distance of triangles that cross is 0, but an edge may pass
/// through a face far from all vertices and other edges.
///
/// **(b)** *Two triangles move continuously and have no common point at the start. If they ever
/// have one, there is a first time t at which they do, and then a vertex of one is on the other, or
/// two edges have a common point.* Triangles are closed and bounded and move continuously, so their
/// distance is a continuous function of time; so there is a first time t at which it is 0, later
/// than the start. At every time before t, by (a), it is the distance of one of 15 pairs, 6 of a
/// vertex and a triangle and 9 of two edges. So one of these pairs has it at times that come
/// arbitrarily close to t. The distance of this pair is continuous as well, so at t it is 0. ∎
///
/// Both hypotheses are needed. Triangles that have a common point at the start, or that jump, may
/// meet in an edge and a face alone. Nothing else is needed: the triangles may turn and change
/// their shape, and meshes, whose distance is the smallest of all pairs of triangles, need not be
/// closed or convex. If a face consists of coplanar triangles on the two sides of flat edges, (a)
/// and (b) hold for this face and its border: a point that moves in a straight line in the face
/// comes to an edge or a vertex of the border in the end, and flat edges on its path do not matter.
#pragma once

#include <algorithm>
#include <array>
#include <contact/contact_time.hpp>
#include <contact/exact_fraction.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_features.hpp>
#include <contact/moved_points.hpp>
#include <contact/nearest_triangles.hpp>
#include <contact/triangle_features.hpp>
#include <contact/triangle_intersection.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

namespace contact {

// [first-contact-types]
/// Two features of two meshes that are in contact.
struct FeatureContact {
  NamedFeature of_moving;                              ///< of the mesh that moves
  NamedFeature of_resting;                             ///< of the mesh at rest
  ContactKind kind = ContactKind::point_point;         ///< of the two
  Vector3<double> position = Vector3<double>::Zero();  ///< m, a common point, rounded
};

/// The first contact of a mesh that moves along a segment with one at rest.
struct FirstContact {
  double t = 0;                ///< fraction of the displacement, 0 to 1, the nearest double
  ExactFraction exact_t;       ///< without rounding
  bool apart_at_start = true;  ///< false: they have a common point before they move, and t is 0
  /// All pairs of features whose relative interiors (a vertex is its own) have a common point at
  /// that time, each once, sorted by features.
  std::vector<FeatureContact> contacts;
  /// All pairs of a vertex and a face, and of two edges, that have a common point at that time if a
  /// face contains its border and an edge its ends; `kind` is point_face or edge_edge. Not empty if
  /// the meshes were apart.
  std::vector<FeatureContact> realised_by;
};
// [/first-contact-types]

namespace feature_contacts_detail {

using contact_time_detail::ContactTime;
using contact_time_detail::MovedPoint;
using contact_time_detail::MovedVertex;
using feature_pairs_detail::FeaturePair;
using SortedTriangle = triangle_intersection_detail::SortedTriangle<MovedPoint>;
using SortedPair = triangle_intersection_detail::SortedPair<MovedPoint>;

/// A triangle of a mesh; or, of one without area, a segment between two neighbouring vertices.
struct Part {
  std::size_t triangle;
  std::array<int, 3> vertex{0, 1, 2};  ///< of the triangle; a segment has one of them twice

  /// The feature of the triangle from that of the part.
  Feature as_given(const Feature& feature) const {
    const auto at = [&](int i) { return vertex[static_cast<std::size_t>(i % 3)]; };
    if (feature.kind == FeatureKind::face) return feature;
    if (feature.kind == FeatureKind::vertex) return {FeatureKind::vertex, at(feature.index)};
    return {FeatureKind::edge, edge_between(at(feature.index), at(feature.index + 1))};
  }
};
inline std::vector<Part> parts_of(const Mesh<double>& mesh) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto sorted = triangle_intersection_detail::sorted_triangle(triangle_of(mesh, i));
    const auto& [a, b, c] = sorted.index;
    if (sorted.set.size == 3 || sorted.at[0] == sorted.at[1] || sorted.at[1] == sorted.at[2]) {
      parts.push_back({i});
    } else {
      parts.push_back({i, {a, b, b}});
      parts.push_back({i, {b, c, c}});
    }
  }
  return parts;
}

/// Collects what two meshes have in common at a time.
class ContactList {
 public:
  ContactList(const Mesh<double>& moving, const Vector3<double>& displacement,
              const Mesh<double>& resting, const ContactTime& time)
      : moving_(moving),
        resting_(resting),
        of_moving_(moving),
        of_resting_(resting),
        moving_vertices_(moved_vertices(moving, displacement, time)),
        resting_vertices_(moved_vertices(resting, Vector3<double>::Zero(), time)) {}

  /// Adds the contacts of two triangles or segments.
  void add(const Part& of_moving, const Part& of_resting) {
    const auto first = points_of(of_moving, moving_, moving_vertices_);
    const auto second = points_of(of_resting, resting_, resting_vertices_);
    if (!may_meet(first, second)) return;
    const SortedPair pair{SortedTriangle(first), SortedTriangle(second)};
    const int n = pair.pairs.count;
    const auto as_given = [&](int k) {
      const FeaturePair given = pair.as_given(k);
      return FeaturePair{of_moving.as_given(given.of_first), of_resting.as_given(given.of_second)};
    };
    const std::size_t i = of_moving.triangle, j = of_resting.triangle;
    for (int k = 0; k < n; ++k) {
      const FeaturePair p = as_given(k);
      const Vector3<double> x = position(pair, k);
      add_smallest(i, j, p, x);
      add_closed(i, j, p, x);
      if (n == 1 || (n == 2 && k == 1)) continue;
      // The side to the next vertex.
      const FeaturePair q = as_given((k + 1) % n);
      add_smallest(i, j, joined(p, q), (x + position(pair, (k + 1) % n)) / 2);
    }
    if (n > 2) add_smallest(i, j, {}, middle(pair));
  }
  /// Sorts, and moves them to the result.
  void move_to(FirstContact& found) {
    sort(smallest_);
    sort(closed_);
    found.contacts = std::move(smallest_);
    found.realised_by = std::move(closed_);
  }

 private:
  const Mesh<double>& moving_;
  const Mesh<double>& resting_;
  FeatureNames of_moving_, of_resting_;
  std::vector<MovedVertex> moving_vertices_, resting_vertices_;
  std::vector<FeatureContact> smallest_, closed_;

  static std::array<MovedPoint, 3> points_of(const Part& part, const Mesh<double>& mesh,
                                             const std::vector<MovedVertex>& vertices) {
    const auto at = [&](std::size_t k) {
      const auto i = static_cast<std::size_t>(part.vertex[k]);
      return MovedPoint{&vertices[static_cast<std::size_t>(mesh.triangles[part.triangle][i])]};
    };
    return {at(0), at(1), at(2)};
  }
  /// Whether no plane x, y or z = constant is between them, by their rounded coordinates.
  static bool may_meet(const std::array<MovedPoint, 3>& s, const std::array<MovedPoint, 3>& t) {
    const auto error = [](const std::array<MovedPoint, 3>& u) {
      return std::max({u[0].vertex->error(), u[1].vertex->error(), u[2].vertex->error()});
    };
    const double room = 2 * (error(s) + error(t));
    for (int k = 0; k < 3; ++k) {
      const auto [s_low, s_high] = std::minmax({s[0].near()[k], s[1].near()[k], s[2].near()[k]});
      const auto [t_low, t_high] = std::minmax({t[0].near()[k], t[1].near()[k], t[2].near()[k]});
      if (s_low - t_high > room || t_low - s_high > room) return false;
    }
    return true;
  }
  /// A vertex of the common set, rounded.
  static Vector3<double> position(const SortedPair& sorted, int k) {
    using Set = feature_pairs_detail::PointSet<Vector3<double>>;
    const auto near = [](const feature_pairs_detail::PointSet<MovedPoint>& set) {
      return Set{{set.at[0].near(), set.at[1].near(), set.at[2].near()}, set.size};
    };
    return bounded_position(sorted.pairs[k], near(sorted.low.set), near(sorted.high.set)).value;
  }
  static Vector3<double> middle(const SortedPair& sorted) {
    Vector3<double> sum = Vector3<double>::Zero();
    for (int k = 0; k < sorted.pairs.count; ++k) sum += position(sorted, k);
    return sum / sorted.pairs.count;
  }
  static FeaturePair joined(const FeaturePair& p, const FeaturePair& q) {
    return {smallest_with(p.of_first, q.of_first), smallest_with(p.of_second, q.of_second)};
  }

  void add_smallest(std::size_t i, std::size_t j, const FeaturePair& pair,
                    const Vector3<double>& x) {
    add_to(smallest_, of_moving_.of(i, pair.of_first), of_resting_.of(j, pair.of_second), x);
  }
  /// The pairs of a vertex and a face and of two edges that have the point.
  void add_closed(std::size_t i, std::size_t j, const FeaturePair& pair, const Vector3<double>& x) {
    const NamedFeature f = of_moving_.of(i, pair.of_first), g = of_resting_.of(j, pair.of_second);
    if (f.kind == FeatureKind::vertex) add_to(closed_, f, of_resting_.of(j, {}), x);
    if (g.kind == FeatureKind::vertex) add_to(closed_, of_moving_.of(i, {}), g, x);
    for (int e = 0; e < 3; ++e) {
      if (of_moving_.is_flat(i, e) || !contains({FeatureKind::edge, e}, pair.of_first)) continue;
      for (int h = 0; h < 3; ++h) {
        if (of_resting_.is_flat(j, h) || !contains({FeatureKind::edge, h}, pair.of_second))
          continue;
        add_to(closed_, of_moving_.of(i, {FeatureKind::edge, e}),
               of_resting_.of(j, {FeatureKind::edge, h}), x);
      }
    }
  }
  static void add_to(std::vector<FeatureContact>& list, const NamedFeature& f,
                     const NamedFeature& g, const Vector3<double>& x) {
    const bool there = std::any_of(list.begin(), list.end(), [&](const FeatureContact& c) {
      return c.of_moving == f && c.of_resting == g;
    });
    if (!there) list.push_back({f, g, contact_kind(f.kind, g.kind), x});
  }
  static void sort(std::vector<FeatureContact>& list) {
    std::sort(list.begin(), list.end(), [](const FeatureContact& c, const FeatureContact& d) {
      return std::tie(c.of_moving, c.of_resting) < std::tie(d.of_moving, d.of_resting);
    });
  }
};

/// Whether two triangles of the meshes have a common point where they are.
inline bool meet_now(const Mesh<double>& a, const Mesh<double>& b) {
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      if (common_points(triangle_of(a, i), triangle_of(b, j)) != CommonPoints::none) return true;
    }
  }
  return false;
}
inline bool finite_mesh(const Mesh<double>& mesh) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [](const Vector3<double>& x) { return all_finite(x); });
}

}  // namespace feature_contacts_detail

// [first-contact]
/// The first contact of a mesh that moves along a segment with one at rest, without rounding.
///
/// The first time is the smallest of those at which a vertex of one mesh comes to a triangle of the
/// other or two edges come to each other (by (b) in this file's comment no other pair can be
/// first), a quotient of two determinants. A floating-point filter leaves out most pairs; the
/// others are compared as exact fractions. Then every pair of triangles is asked, at that exact
/// time, which of their features meet.
///
/// The surfaces are meant: a mesh inside another one is apart from it. If the meshes have a common
/// point at the start, t is 0 and the contacts are those of the start: then `realised_by` may be
/// empty. With a zero displacement only the start counts. Flat edges are no edges (`FeatureNames`).
/// Triangles without area are segments or points.
///
/// Overflow and underflow change neither time nor features, but `t` may be rounded to 0. Positions
/// are rounded, without a bound: possibly infinite or NaN if a coordinate or the length of an edge
/// overflows.
///
/// Each vertex against each triangle and each edge against each edge: for small meshes.
/// @param moving m, where it starts
/// @param displacement m
/// @param resting m
/// @return nothing if they never meet, if one has no triangle, or if a number is not finite
inline std::optional<FirstContact> first_contact(const Mesh<double>& moving,
                                                 const Vector3<double>& displacement,
                                                 const Mesh<double>& resting) {
  using namespace feature_contacts_detail;
  if (!finite_mesh(moving) || !finite_mesh(resting) || !all_finite(displacement)) {
    return std::nullopt;
  }
  FirstContact found;
  found.apart_at_start = !meet_now(moving, resting);
  std::optional<ContactTime> time = ContactTime{};
  if (found.apart_at_start) {
    time = contact_time_detail::first_time(moving, displacement, resting);
    if (!time) return std::nullopt;
    found.t = time->nearest();
    found.exact_t = ExactFraction(time->above) / ExactFraction(time->below);
  }
  ContactList list(moving, displacement, resting, *time);
  const std::vector<Part> of_resting = parts_of(resting);
  for (const Part& part : parts_of(moving)) {
    for (const Part& other : of_resting) list.add(part, other);
  }
  list.move_to(found);
  return found;
}
// [/first-contact]

}  // namespace contact
