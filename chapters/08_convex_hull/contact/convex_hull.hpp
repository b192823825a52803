/// @file
/// The convex hull of points in space, by the incremental algorithm.
#pragma once

#include <array>
#include <contact/hull.hpp>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace contact {

/// The incremental algorithm: a closed surface of triangles to which one point is added at a time.
///
/// Coplanar triangles are joined only in `finish`. A triangle is removed only if the new point is
/// strictly in front of it. So with exact decisions no triangle without area is made: a horizon
/// edge of a triangle that the point sees is never collinear with that point.
///
/// @tparam Sides the orientation predicate; the proof that the surface stays closed needs an exact
///   one. With a rounded one the horizon may fail to be one ring: then `stuck` is set, and nothing
///   more is added.
template <SideTest Sides>
class IncrementalHull {
 public:
  /// One triangle. Neighbour i shares the edge from vertex i to vertex i + 1.
  struct Triangle {
    std::array<int, 3> vertex;     ///< points, counter-clockwise from outside
    std::array<int, 3> neighbour;  ///< triangles
    int first_conflict = -1;       ///< head of its conflict list
    std::uint32_t marked = 0;      ///< number of the last search that visited it
    int walked_by = -1;            ///< the last point whose walk tested it
    bool alive = true;             ///< false once it is removed
    typename Sides::Plane plane;   ///< computed when it was made
  };

  /// Starts with a tetrahedron: point 3 is behind 0, 1, 2.
  IncrementalHull(const Sides& sides, const std::array<int, 4>& s, int point_count)
      : sides_(sides),
        next_conflict_(static_cast<std::size_t>(point_count), -1),
        conflict_face_(static_cast<std::size_t>(point_count), -1),
        representative_(static_cast<std::size_t>(point_count), -1) {
    const auto [a, b, c, d] = s;
    triangles_.reserve(4 * static_cast<std::size_t>(point_count) + 16);
    make(a, b, c, {2, 3, 1});
    make(a, c, d, {0, 3, 2});
    make(a, d, b, {1, 3, 0});
    make(b, d, c, {2, 1, 0});
    for (const int vertex : s) representative_[static_cast<std::size_t>(vertex)] = vertex;
  }

  /// All triangles; those that are not alive have been removed.
  const std::vector<Triangle>& all() const { return triangles_; }
  /// Whether the horizon failed to be one ring.
  bool stuck() const { return stuck_; }
  /// The triangle in whose conflict list point p is, or −1 if it is in none.
  int conflict_face(int p) const { return conflict_face_[static_cast<std::size_t>(p)]; }

  /// On which side of a triangle point p is.
  int side(const Triangle& t, int p) const {
    return sides_.side(t.plane, t.vertex[0], t.vertex[1], t.vertex[2], p);
  }

  /// Puts point p into the conflict list of the first of these triangles that it sees.
  /// @return whether it sees one
  template <class Triangles>
  bool add_conflict(int p, const Triangles& candidates) {
    for (const int t : candidates) {
      Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
      if (side(triangle, p) <= 0) continue;
      conflict_face_[static_cast<std::size_t>(p)] = t;
      next_conflict_[static_cast<std::size_t>(p)] = triangle.first_conflict;
      triangle.first_conflict = p;
      return true;
    }
    conflict_face_[static_cast<std::size_t>(p)] = -1;
    return false;
  }

  /// Adds point p, which sees triangle `seen`: removes the triangles that p sees and connects the
  /// horizon to p. Points in the conflict list of a removed triangle move to that of a new one, or
  /// are dropped if they see none.
  /// @param dropped dropped(p, q) is called for each point q that is dropped because it is in the
  ///   new hull; it may be equal to p
  template <class Dropped>
  void add(int p, int seen, const Dropped& dropped) {
    // [add-triangles]
    find_horizon(p, seen);
    if (stuck_) return;
    const std::size_t size = horizon_.size();
    made_.clear();
    for (const Edge& edge : horizon_) made_.push_back(allocate(edge, p));
    for (std::size_t i = 0; i < size; ++i) {
      Triangle& triangle = triangles_[static_cast<std::size_t>(made_[i])];
      triangle.neighbour[1] = made_[(i + 1) % size];
      triangle.neighbour[2] = made_[(i + size - 1) % size];
    }
    // [/add-triangles]
    conflict_face_[static_cast<std::size_t>(p)] = -1;
    representative_[static_cast<std::size_t>(p)] = p;
    // A few new triangles are tested in turn, which is faster than walking.
    const bool few = size <= few_triangles;
    for (const int gone : removed_) {
      int q = triangles_[static_cast<std::size_t>(gone)].first_conflict;
      while (q >= 0) {
        const int next = next_conflict_[static_cast<std::size_t>(q)];
        if (q != p && !(few ? add_conflict(q, made_) : add_conflict_beyond(q, gone))) dropped(p, q);
        q = next;
      }
    }
    free_.insert(free_.end(), removed_.begin(), removed_.end());
  }

  /// Puts point q, which sees the removed triangle `gone`, into the conflict list of a new triangle
  /// that it sees, if there is one. A walk over the removed triangles that q sees finds it; the
  /// length of the walk does not depend on the number of new triangles.
  ///
  /// The walk finds one if there is one: the triangles that q saw on the old hull form one
  /// connected patch. If the patch extends beyond the horizon, the walk reaches a horizon edge
  /// where q saw both triangles. So q sees the new triangle there, whose plane lies between theirs.
  /// If it does not, the walk reaches every triangle that q saw, and q can see the new triangle of
  /// an edge only if it saw one of the two old ones there.
  /// @return whether there is one
  // [walk]
  bool add_conflict_beyond(int q, int gone) {
    walk_.assign(1, gone);
    triangles_[static_cast<std::size_t>(gone)].walked_by = q;
    while (!walk_.empty()) {
      const Triangle& here = triangles_[static_cast<std::size_t>(walk_.back())];
      walk_.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const int beyond = here.neighbour[i];
        Triangle& other = triangles_[static_cast<std::size_t>(beyond)];
        if (other.alive) {  // a horizon edge: its other triangle is now a new one
          const int back = edge_to(other, here.vertex[(i + 1) % 3]);
          if (add_conflict(q, std::array{other.neighbour[static_cast<std::size_t>(back)]})) {
            walk_.clear();
            return true;
          }
        } else if (other.walked_by != q) {
          other.walked_by = q;
          if (side(other, q) > 0) walk_.push_back(beyond);
        }
      }
    }
    conflict_face_[static_cast<std::size_t>(q)] = -1;
    return false;
  }
  // [/walk]

  /// Up to this many new triangles are tested in turn; with more, `add_conflict_beyond` walks.
  static constexpr std::size_t few_triangles = 16;

  /// The triangles that the last call of `add` removed.
  const std::vector<int>& removed() const { return removed_; }
  /// The triangles that replaced them, in the order of the horizon.
  const std::vector<int>& made() const { return made_; }

  /// Reports point p as `index`.
  void set_representative(int p, int index) {
    representative_[static_cast<std::size_t>(p)] = index;
  }

  // [finish]
  /// The hull: coplanar neighbours are joined into one face, and points on an edge or in the
  /// interior of a face are left out. `name(p)` is the index that the result has for point p.
  template <class Name>
  Hull finish(const Name& name) {
    Hull hull;
    hull.dimension = 3;
    hull.closed = !stuck_;
    const auto flat_across = [this](const Triangle& t, int i) {
      const Triangle& other =
          triangles_[static_cast<std::size_t>(t.neighbour[static_cast<std::size_t>(i)])];
      const int back = edge_to(other, t.vertex[static_cast<std::size_t>((i + 1) % 3)]);
      return side(t, other.vertex[static_cast<std::size_t>((back + 2) % 3)]) == 0;
    };
    // Bit i: the neighbour across edge i is coplanar.
    std::vector<std::uint8_t> flat(triangles_.size(), 0);
    std::vector<int> ways(representative_.size(), 0);  // boundary edges that start at a point
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& triangle = triangles_[t];
      if (!triangle.alive) continue;
      for (int i = 0; i < 3; ++i) {
        const auto other = triangle.neighbour[static_cast<std::size_t>(i)];
        bool is_flat = false;
        if (static_cast<std::size_t>(other) < t) {  // tested already, as the neighbour's edge
          const Triangle& there = triangles_[static_cast<std::size_t>(other)];
          const int back = edge_to(there, triangle.vertex[static_cast<std::size_t>((i + 1) % 3)]);
          is_flat = (flat[static_cast<std::size_t>(other)] >> back & 1) != 0;
        } else {
          is_flat = flat_across(triangle, i);
        }
        if (is_flat) {
          flat[t] = static_cast<std::uint8_t>(flat[t] | 1 << i);
        } else {
          ++ways[static_cast<std::size_t>(triangle.vertex[static_cast<std::size_t>(i)])];
        }
      }
    }
    // Walk round each face along its boundary edges.
    std::vector<std::uint8_t> done(triangles_.size(), 0);
    std::vector<int> polygon;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!triangles_[t].alive) continue;
      for (int i = 0; i < 3; ++i) {
        if ((flat[t] | done[t]) >> i & 1) continue;
        polygon.clear();
        std::size_t at = t;
        int edge = i;
        do {
          done[at] = static_cast<std::uint8_t>(done[at] | 1 << edge);
          const int vertex = triangles_[at].vertex[static_cast<std::size_t>(edge)];
          // If only two boundary edges start at a point, it lies on an edge of the hull.
          if (ways[static_cast<std::size_t>(vertex)] > 2) polygon.push_back(name(vertex));
          edge = (edge + 1) % 3;
          // After rounded decisions the triangles at a vertex may form no ring.
          std::size_t turns = 0;
          while (flat[at] >> edge & 1) {
            if (++turns > triangles_.size()) {
              hull.closed = false;
              return hull;
            }
            const int shared = triangles_[at].vertex[static_cast<std::size_t>(edge)];
            at = static_cast<std::size_t>(triangles_[at].neighbour[static_cast<std::size_t>(edge)]);
            edge = edge_to(triangles_[at], shared);
          }
        } while (((done[at] >> edge) & 1) == 0);
        hull.closed = hull.closed && polygon.size() >= 3;
        hull.add_face(polygon);
      }
    }
    for (std::size_t p = 0; p < ways.size(); ++p) {
      if (ways[p] > 2) hull.vertices.push_back(name(static_cast<int>(p)));
    }
    std::sort(hull.vertices.begin(), hull.vertices.end());
    return hull;
  }
  // [/finish]

  /// The index that is reported for point p.
  int representative(int p) const { return representative_[static_cast<std::size_t>(p)]; }

 private:
  /// A horizon edge, directed as in the removed triangle, and the kept triangle beyond it.
  struct Edge {
    int from, to, outer, outer_edge;
  };
  struct Step {
    int triangle, edge, left;
  };

  const Sides& sides_;
  std::vector<Triangle> triangles_;
  std::vector<int> free_, next_conflict_, conflict_face_, representative_;
  std::vector<Edge> horizon_;
  std::vector<int> removed_, made_, walk_;
  std::vector<Step> steps_;
  std::uint32_t search_ = 0;
  bool stuck_ = false;

  void make(int a, int b, int c, const std::array<int, 3>& neighbour) {
    triangles_.push_back({{a, b, c}, neighbour, -1, 0, -1, true, sides_.plane(a, b, c)});
  }

  int allocate(const Edge& edge, int p) {
    int index = static_cast<int>(triangles_.size());
    if (free_.empty()) {
      triangles_.emplace_back();
    } else {
      index = free_.back();
      free_.pop_back();
    }
    triangles_[static_cast<std::size_t>(index)] = {{edge.from, edge.to, p},
                                                   {edge.outer, -1, -1},
                                                   -1,
                                                   0,
                                                   -1,
                                                   true,
                                                   sides_.plane(edge.from, edge.to, p)};
    triangles_[static_cast<std::size_t>(edge.outer)]
        .neighbour[static_cast<std::size_t>(edge.outer_edge)] = index;
    return index;
  }

  /// The edge of a triangle that starts at this vertex.
  static int edge_to(const Triangle& triangle, int vertex) {
    return triangle.vertex[0] == vertex ? 0 : triangle.vertex[1] == vertex ? 1 : 2;
  }

  // [horizon]
  /// Visits all triangles that p sees, depth first, and the edges of each in order, so the horizon
  /// edges are found in order, as one ring.
  void find_horizon(int p, int seen) {
    search_ += 2;  // marked == search_: seen; search_ + 1: tested and not seen
    horizon_.clear();
    removed_.clear();
    const auto enter = [this](int t, int edge, int left) {
      Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
      triangle.marked = search_;
      triangle.alive = false;
      removed_.push_back(t);
      steps_.push_back({t, edge, left});
    };
    enter(seen, 0, 3);
    while (!steps_.empty()) {
      Step& step = steps_.back();
      if (step.left == 0) {
        steps_.pop_back();
        continue;
      }
      const Triangle& triangle = triangles_[static_cast<std::size_t>(step.triangle)];
      const auto edge = static_cast<std::size_t>(step.edge);
      step.edge = (step.edge + 1) % 3;
      --step.left;
      const int beyond = triangle.neighbour[edge];
      Triangle& other = triangles_[static_cast<std::size_t>(beyond)];
      if (other.marked == search_) continue;
      const int to = triangle.vertex[(edge + 1) % 3];
      const int back = edge_to(other, to);
      if (other.marked != search_ + 1) {
        if (side(other, p) > 0) {
          enter(beyond, (back + 1) % 3, 2);
          continue;
        }
        other.marked = search_ + 1;
      }
      horizon_.push_back({triangle.vertex[edge], to, beyond, back});
    }
    // This cannot happen with exact decisions.
    if (horizon_.size() < 3) stuck_ = true;
    for (std::size_t i = 0; i < horizon_.size() && !stuck_; ++i) {
      stuck_ = horizon_[i].to != horizon_[(i + 1) % horizon_.size()].from;
    }
    if (stuck_) {
      for (const int t : removed_) triangles_[static_cast<std::size_t>(t)].alive = true;
    }
  }
  // [/horizon]
};

/// Pseudo-random numbers for the shuffle, the same on every machine (splitmix64).
class HullShuffle {
 public:
  /// 64 random bits.
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// A number below `count`.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

 private:
  std::uint64_t state_ = 8;
};

// [convex-hull-with]
/// The hull by the randomised incremental algorithm, with the orientation predicate `Sides`.
template <SideTest Sides, class... Arguments>
Hull convex_hull_with(const std::vector<Vector3<double>>& points, Arguments... arguments) {
  require_finite_points(points);
  // The points are copied in random order, so that points used together are close in memory.
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  HullShuffle random;
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  std::vector<Vector3<double>> shuffled;
  shuffled.reserve(points.size());
  for (const int i : order) shuffled.push_back(points[static_cast<std::size_t>(i)]);

  const Simplex simplex = first_simplex(shuffled);
  if (simplex.dimension < 3) return flat_hull(points, first_simplex(points));
  const Sides sides(shuffled, arguments...);
  const int n = static_cast<int>(points.size());
  IncrementalHull<Sides> hull(sides, simplex.points, n);

  // Of equal points the one with the least index is reported.
  std::vector<int> name = order;
  const auto dropped = [&](int p, int q) {
    const auto at = [&shuffled](int i) { return shuffled[static_cast<std::size_t>(i)]; };
    if (at(p) != at(q)) return;
    int& told = name[static_cast<std::size_t>(p)];
    told = std::min(told, order[static_cast<std::size_t>(q)]);
  };
  for (int p = 0; p < n; ++p) {
    if (hull.add_conflict(p, std::array{0, 1, 2, 3})) continue;
    for (const int vertex : simplex.points) dropped(vertex, p);
  }
  for (int p = 0; p < n && !hull.stuck(); ++p) {
    if (hull.conflict_face(p) >= 0) hull.add(p, hull.conflict_face(p), dropped);
  }
  return hull.finish([&name](int p) { return name[static_cast<std::size_t>(p)]; });
}
// [/convex-hull-with]

// [convex-hull]
/// The convex hull of points in space, with every decision exact.
///
/// Every point is on or inside it, every face is a convex polygon, and each plane has at most one
/// face. `Hull` says what is returned for points in a plane, on a line, all equal, or none.
///
/// @param points m, any number, any scale; throws std::invalid_argument unless all are finite
///
/// Limits: exact for every finite input; fewer than 2^29 points. The expected time is O(n log n)
/// for points in random order, no four of them coplanar. The order is shuffled, but with a fixed
/// seed: an attacker who knows it can construct points for which it is bad.
///
/// Source: Clarkson and Shor, Applications of Random Sampling in Computational Geometry II, 1989,
/// who keep for each point all triangles that it sees. Barber, Dobkin and Huhdanpaa, The Quickhull
/// Algorithm for Convex Hulls, 1996, show that one conflict list per point is enough.
inline Hull convex_hull(const std::vector<Vector3<double>>& points) {
  return convex_hull_with<ExactSides>(points);
}
// [/convex-hull]

}  // namespace contact
