/// @file
/// When a moving mesh first touches another, as an exact fraction: used by
/// `contact/feature_contacts.hpp`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/filter.hpp>
#include <contact/mesh.hpp>
#include <contact/orientation.hpp>
#include <contact/segments.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace contact::contact_time_detail {

// ---------------------------------------------------------------- determinants

/// A row of a determinant: the difference of two points, or a vector.
struct Row {
  const Vector3<double>& to;
  const Vector3<double>* from = nullptr;  ///< nothing: the vector `to`

  Vector3<double> rounded() const { return from == nullptr ? to : Vector3<double>(to - *from); }
  Vector3<Exact> exact() const {
    const auto in_exact = [](const Vector3<double>& v) {
      return Vector3<Exact>(Exact(v.x()), Exact(v.y()), Exact(v.z()));
    };
    return from == nullptr ? in_exact(to) : Vector3<Exact>(in_exact(to) - in_exact(*from));
  }
  /// Whether `rounded` has no error.
  bool is_plain() const {
    if (from == nullptr) return true;
    for (int k = 0; k < 3; ++k) {
      if (two_sum(to[k], -(*from)[k]).error != 0) return false;
    }
    return true;
  }
};

inline Exact exact_determinant(const Row& p, const Row& q, const Row& r) {
  return p.exact().dot(Vector3<Exact>(q.exact().cross(r.exact())));
}

/// The sign of p·(q × r), without error.
inline int determinant_sign(const Row& p, const Row& q, const Row& r) {
  const Vector3<double> x = p.rounded(), y = q.rounded(), z = r.rounded();
  const int certain = bounded_volume(x, y, z).certain_sign();
  if (certain != 0) return certain;
  if (p.is_plain() && q.is_plain() && r.is_plain()) {
    return orient_3d_in_doubt(Vector3<double>::Zero(), y, z, x);
  }
  return exact_determinant(p, q, r).sign();
}

// ---------------------------------------------------------------- times

/// The time above/below, from 0 to 1.
struct ContactTime {
  Exact above;
  Exact below{1.0};  ///< greater than 0

  double nearest() const { return quotient<double>(above, below); }
};

/// The earliest of the times that are offered.
class EarliestTime {
 public:
  /// Whether a quotient of two bounded numbers may be from 0 to the earliest time.
  bool may_be_earlier(const Bounded& n, const Bounded& d) const {
    const double smallest = std::abs(d.value) - d.bound;
    if (!(smallest > 0)) return true;
    const double t = n.value / d.value;
    const double error = (n.bound + std::abs(t) * d.bound) / smallest + 0x1p-50 * std::abs(t);
    return !(t - 2 * error > limit_ || t + 2 * error < 0);
  }
  /// Takes n/d, if it is from 0 to 1 and earlier.
  void offer(Exact n, Exact d) {
    if (d.sign() == 0) return;
    if (d.sign() < 0) {
      n = -n;
      d = -d;
    }
    if (n.sign() < 0 || n > d) return;
    if (earliest_ && !(n * earliest_->below < earliest_->above * d)) return;
    earliest_ = ContactTime{n, d};
    limit_ = earliest_->nearest() * (1 + 0x1p-50) + std::numeric_limits<double>::min();
  }
  /// Offers the quotient of two determinants with the same last two rows.
  void offer(const Row& of_n, const Row& of_d, const Row& q, const Row& r) {
    const Vector3<double> y = q.rounded(), z = r.rounded();
    const Bounded d = bounded_volume(of_d.rounded(), y, z);
    if (may_be_earlier(bounded_volume(of_n.rounded(), y, z), d)) {
      offer(exact_determinant(of_n, q, r), exact_determinant(of_d, q, r));
    }
  }
  const std::optional<ContactTime>& earliest() const { return earliest_; }

 private:
  std::optional<ContactTime> earliest_;
  double limit_ = 1 + 0x1p-50;  // greater than the earliest time, or than 1
};

// ---------------------------------------------------------------- pairs of features

using Points = const std::vector<Vector3<double>>&;
inline const Vector3<double>& at(Points points, int i) {
  return points[static_cast<std::size_t>(i)];
}

/// A vertex that moves along d comes to a triangle. If d is parallel to the plane, it enters at an
/// edge, if at all.
inline void vertex_comes_to_triangle(EarliestTime& time, const Vector3<double>& x,
                                     const Vector3<double>& d, Points points,
                                     const std::array<int, 3>& t) {
  int side = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const Row from{at(points, t[j]), &x}, to{at(points, t[(j + 1) % 3]), &x};
    const int s = determinant_sign({d}, from, to);
    if (s * side < 0) return;
    if (s != 0) side = s;
  }
  if (side == 0) return;
  const Vector3<double>&a = at(points, t[0]), &b = at(points, t[1]), &c = at(points, t[2]);
  time.offer({a, &x}, {d}, {b, &a}, {c, &a});
}

/// An edge from p to q that moves along d comes to an edge from r to s. If the two and d are
/// parallel to a plane, an end of one comes to the other, if at all.
inline void edge_comes_to_edge(EarliestTime& time, const Vector3<double>& p,
                               const Vector3<double>& q, const Vector3<double>& d,
                               const Vector3<double>& r, const Vector3<double>& s) {
  const int of_p = determinant_sign({r, &p}, {d}, {s, &r});
  const int of_q = determinant_sign({r, &q}, {d}, {s, &r});
  if (of_p * of_q > 0 || (of_p == 0 && of_q == 0)) return;
  const int of_r = determinant_sign({q, &p}, {d}, {r, &p});
  const int of_s = determinant_sign({q, &p}, {d}, {s, &p});
  if (of_r * of_s <= 0) time.offer({r, &p}, {d}, {q, &p}, {s, &r});
}

/// A vertex that moves along d comes to an edge from r to s, all in one plane: x + t d = r + b (s −
/// r). If d is parallel to the edge, it comes to a vertex first.
inline void vertex_comes_to_edge(EarliestTime& time, const Vector3<double>& x,
                                 const Vector3<double>& d, const Vector3<double>& r,
                                 const Vector3<double>& s) {
  if (determinant_sign({r, &x}, {d}, {s, &r}) != 0) return;
  const Vector3<Exact> w = Row{r, &x}.exact(), along = Row{d}.exact(), edge = Row{s, &r}.exact();
  const Vector3<Exact> normal = along.cross(edge);
  int k = 0;
  while (k < 3 && normal[k].sign() == 0) ++k;
  if (k == 3) return;
  const Exact b = w.cross(along)[k];
  if (b.sign() * normal[k].sign() < 0 || abs(b) > abs(normal[k])) return;
  time.offer(w.cross(edge)[k], normal[k]);
}

/// A vertex that moves along d comes to the vertex r.
inline void vertex_comes_to_vertex(EarliestTime& time, const Vector3<double>& x,
                                   const Vector3<double>& d, const Vector3<double>& r) {
  const Vector3<double> zero = Vector3<double>::Zero();
  for (int k = 0; k < 3; ++k) {
    const auto flat = [k](const Vector3<double>& v) { return drop_dimension<double>(v, k); };
    const Bounded off = segments_detail::bounded_cross(flat(x), flat(r), flat(zero), flat(d));
    if (off.certain_sign() != 0) return;
  }
  const Vector3<Exact> w = Row{r, &x}.exact(), along = Row{d}.exact();
  if (w.cross(along) != Vector3<Exact>::Zero()) return;
  int k = 0;
  while (k < 3 && along[k].sign() == 0) ++k;
  if (k < 3) time.offer(w[k], along[k]);
}

// ---------------------------------------------------------------- meshes

/// The vertices and edges that the triangles of a mesh have.
struct UsedFeatures {
  std::vector<int> vertices;
  std::vector<std::array<int, 2>> edges;

  explicit UsedFeatures(const Mesh<double>& mesh) {
    for (const std::array<int, 3>& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        vertices.push_back(t[k]);
        edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }
};

/// The vertices of one mesh that move along d come to the other.
inline void vertices_come(EarliestTime& time, const Mesh<double>& one, const UsedFeatures& of_one,
                          const Vector3<double>& d, const Mesh<double>& other,
                          const UsedFeatures& of_other) {
  for (const int i : of_one.vertices) {
    const Vector3<double>& x = at(one.vertices, i);
    for (const auto& t : other.triangles) vertex_comes_to_triangle(time, x, d, other.vertices, t);
    for (const auto& [r, s] : of_other.edges) {
      vertex_comes_to_edge(time, x, d, at(other.vertices, r), at(other.vertices, s));
    }
  }
}

/// The first time from 0 to 1 at which a vertex of one mesh is on a triangle of the other, or two
/// edges have a common point.
inline std::optional<ContactTime> first_time(const Mesh<double>& moving, const Vector3<double>& d,
                                             const Mesh<double>& resting) {
  const UsedFeatures of_moving(moving), of_resting(resting);
  EarliestTime time;
  const Vector3<double> back = -d;
  vertices_come(time, moving, of_moving, d, resting, of_resting);
  vertices_come(time, resting, of_resting, back, moving, of_moving);
  for (const auto& [p, q] : of_moving.edges) {
    for (const auto& [r, s] : of_resting.edges) {
      edge_comes_to_edge(time, at(moving.vertices, p), at(moving.vertices, q), d,
                         at(resting.vertices, r), at(resting.vertices, s));
    }
  }
  for (const int i : of_moving.vertices) {
    for (const int j : of_resting.vertices) {
      vertex_comes_to_vertex(time, at(moving.vertices, i), d, at(resting.vertices, j));
    }
  }
  return time.earliest();
}

}  // namespace contact::contact_time_detail
