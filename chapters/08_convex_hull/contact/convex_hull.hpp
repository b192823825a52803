/// @file
/// The convex hull of points in space, built point by point.
#pragma once

#include <array>
#include <contact/hull.hpp>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace contact {

/// A hull that grows by one point at a time, as a closed surface of triangles.
///
/// Coplanar triangles stay apart until `finish`. A triangle is removed only if the new point is
/// strictly in front of it; so with exact sides no triangle without area is ever made: the horizon
/// edge of a triangle that is seen is never on one line with the point that sees it.
///
/// @tparam Sides what decides; the proof that the surface stays closed needs exact ones. With
///   rounded ones the horizon may fail to be one ring: then `stuck` is set, and nothing more is
///   added.
template <SideTest Sides>
class GrowingHull {
 public:
  /// One triangle. Neighbour i lies across the edge from corner i to corner i + 1.
  struct Triangle {
    std::array<int, 3> corner;     ///< points, counter-clockwise from outside
    std::array<int, 3> neighbour;  ///< triangles
    int first_waiting = -1;        ///< head of the list of points that wait in front of it
    std::uint32_t marked = 0;      ///< by the last search that has seen it
    int walked_by = -1;            ///< the last waiting point that has asked about it
    bool alive = true;             ///< false once it is removed
    typename Sides::Plane plane;   ///< worked out when it was made
  };

  /// Begins with the four points of a simplex of three dimensions, 3 behind 0, 1, 2.
  GrowingHull(const Sides& sides, const std::array<int, 4>& s, int point_count)
      : sides_(sides),
        next_waiting_(static_cast<std::size_t>(point_count), -1),
        sees_(static_cast<std::size_t>(point_count), -1),
        stands_for_(static_cast<std::size_t>(point_count), -1) {
    const auto [a, b, c, d] = s;
    triangles_.reserve(4 * static_cast<std::size_t>(point_count) + 16);
    make(a, b, c, {2, 3, 1});
    make(a, c, d, {0, 3, 2});
    make(a, d, b, {1, 3, 0});
    make(b, d, c, {2, 1, 0});
    for (const int corner : s) stands_for_[static_cast<std::size_t>(corner)] = corner;
  }

  /// All triangles that were ever made; those that are not alive have been removed.
  const std::vector<Triangle>& all() const { return triangles_; }
  /// Whether the horizon failed to be one ring.
  bool stuck() const { return stuck_; }
  /// The triangle that waiting point p sees, or −1 if it waits no more.
  int sees(int p) const { return sees_[static_cast<std::size_t>(p)]; }

  /// On which side of a triangle point p is.
  int side(const Triangle& t, int p) const {
    return sides_.side(t.plane, t.corner[0], t.corner[1], t.corner[2], p);
  }

  /// Lets point p wait at one of these triangles that it sees, if there is one.
  /// @return whether there is
  template <class Triangles>
  bool wait(int p, const Triangles& candidates) {
    for (const int t : candidates) {
      Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
      if (side(triangle, p) <= 0) continue;
      sees_[static_cast<std::size_t>(p)] = t;
      next_waiting_[static_cast<std::size_t>(p)] = triangle.first_waiting;
      triangle.first_waiting = p;
      return true;
    }
    sees_[static_cast<std::size_t>(p)] = -1;
    return false;
  }

  // [add]
  /// Adds point p, which sees triangle `seen`: what p sees is removed, and the horizon is joined to
  /// p. Points that waited at a triangle that is gone wait at a new one, or are inside.
  /// @param dropped dropped(p, q) is called for a point q that waited and is in the new hull now:
  /// it
  ///   may be equal to p
  template <class Dropped>
  void add(int p, int seen, const Dropped& dropped) {
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
    sees_[static_cast<std::size_t>(p)] = -1;
    stands_for_[static_cast<std::size_t>(p)] = p;
    // Of a few new triangles each is asked: that is no more than so many steps, and quicker.
    const bool few = size <= few_triangles;
    for (const int gone : removed_) {
      int q = triangles_[static_cast<std::size_t>(gone)].first_waiting;
      while (q >= 0) {
        const int next = next_waiting_[static_cast<std::size_t>(q)];
        if (q != p && !(few ? wait(q, made_) : wait_beyond(q, gone))) dropped(p, q);
        q = next;
      }
    }
    free_.insert(free_.end(), removed_.begin(), removed_.end());
  }

  /// Lets point q, which sees removed triangle `gone`, wait at one of the triangles just made that
  /// it sees, if there is one: found on a walk over the removed triangles that q sees, whose length
  /// does not depend on how many were made.
  ///
  /// Why the walk finds one: what q saw of the old hull is one patch. If it reaches beyond the
  /// horizon, q saw both triangles at the edge where the walk first gets there, and so it sees the
  /// new one at that edge, whose plane lies between theirs. If it does not, the walk comes to every
  /// triangle that q saw; and q can see the new triangle of an edge only if it saw one of the two
  /// there.
  /// @return whether there is one
  bool wait_beyond(int q, int gone) {
    walk_.assign(1, gone);
    triangles_[static_cast<std::size_t>(gone)].walked_by = q;
    while (!walk_.empty()) {
      const Triangle& here = triangles_[static_cast<std::size_t>(walk_.back())];
      walk_.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const int beyond = here.neighbour[i];
        Triangle& other = triangles_[static_cast<std::size_t>(beyond)];
        if (other.alive) {  // the horizon: across the edge there is a new triangle now
          const int back = edge_to(other, here.corner[(i + 1) % 3]);
          if (wait(q, std::array{other.neighbour[static_cast<std::size_t>(back)]})) {
            walk_.clear();
            return true;
          }
        } else if (other.walked_by != q) {
          other.walked_by = q;
          if (side(other, q) > 0) walk_.push_back(beyond);
        }
      }
    }
    sees_[static_cast<std::size_t>(q)] = -1;
    return false;
  }
  // [/add]

  /// So many new triangles are asked in turn; among more, `wait_beyond` walks.
  static constexpr std::size_t few_triangles = 16;

  /// The triangles that the last search removed.
  const std::vector<int>& removed() const { return removed_; }
  /// The triangles that took their place, in order round the horizon.
  const std::vector<int>& made() const { return made_; }

  /// Makes `index` the one that is told for point p.
  void stand_for(int p, int index) { stands_for_[static_cast<std::size_t>(p)] = index; }

  // [finish]
  /// The hull: triangles of one plane joined into one face, and corners that are on an edge or
  /// within a face left out. `name(p)` is what stands in the result for point p.
  template <class Name>
  Hull finish(const Name& name) {
    Hull hull;
    hull.dimension = 3;
    hull.closed = !stuck_;
    const auto flat_across = [this](const Triangle& t, int i) {
      const Triangle& other =
          triangles_[static_cast<std::size_t>(t.neighbour[static_cast<std::size_t>(i)])];
      const int back = edge_to(other, t.corner[static_cast<std::size_t>((i + 1) % 3)]);
      return side(t, other.corner[static_cast<std::size_t>((back + 2) % 3)]) == 0;
    };
    // Bit i: across edge i the surface goes on in the same plane.
    std::vector<std::uint8_t> flat(triangles_.size(), 0);
    std::vector<int> ways(stands_for_.size(), 0);  // boundary edges that start at a point
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& triangle = triangles_[t];
      if (!triangle.alive) continue;
      for (int i = 0; i < 3; ++i) {
        const auto other = triangle.neighbour[static_cast<std::size_t>(i)];
        bool is_flat = false;
        if (static_cast<std::size_t>(other) < t) {  // asked from the other side already
          const Triangle& there = triangles_[static_cast<std::size_t>(other)];
          const int back = edge_to(there, triangle.corner[static_cast<std::size_t>((i + 1) % 3)]);
          is_flat = (flat[static_cast<std::size_t>(other)] >> back & 1) != 0;
        } else {
          is_flat = flat_across(triangle, i);
        }
        if (is_flat) {
          flat[t] = static_cast<std::uint8_t>(flat[t] | 1 << i);
        } else {
          ++ways[static_cast<std::size_t>(triangle.corner[static_cast<std::size_t>(i)])];
        }
      }
    }
    // Walk round each face along the edges that are not flat.
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
          const int corner = triangles_[at].corner[static_cast<std::size_t>(edge)];
          // Two ways from a point are the two of one edge: it lies on that.
          if (ways[static_cast<std::size_t>(corner)] > 2) polygon.push_back(name(corner));
          edge = (edge + 1) % 3;
          // Rounded sides may have folded the surface, so that a corner's triangles are no ring.
          std::size_t turns = 0;
          while (flat[at] >> edge & 1) {
            if (++turns > triangles_.size()) {
              hull.closed = false;
              return hull;
            }
            const int shared = triangles_[at].corner[static_cast<std::size_t>(edge)];
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

  /// What was told to stand for point p.
  int standing_for(int p) const { return stands_for_[static_cast<std::size_t>(p)]; }

 private:
  /// A horizon edge: edge `index` of removed triangle `inner`, seen from there.
  struct Edge {
    int from, to, outer, outer_edge;
  };
  struct Step {
    int triangle, edge, left;
  };

  const Sides& sides_;
  std::vector<Triangle> triangles_;
  std::vector<int> free_, next_waiting_, sees_, stands_for_;
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

  /// The edge of a triangle that starts at this corner.
  static int edge_to(const Triangle& triangle, int corner) {
    return triangle.corner[0] == corner ? 0 : triangle.corner[1] == corner ? 1 : 2;
  }

  // [horizon]
  /// Walks over all triangles that p sees, depth first and each time round in order: so the edges
  /// beyond which p sees nothing come out in order too, as one ring.
  void find_horizon(int p, int seen) {
    search_ += 2;  // marked == search_: seen; search_ + 1: asked and not seen
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
      const int to = triangle.corner[(edge + 1) % 3];
      const int back = edge_to(other, to);
      if (other.marked != search_ + 1) {
        if (side(other, p) > 0) {
          enter(beyond, (back + 1) % 3, 2);
          continue;
        }
        other.marked = search_ + 1;
      }
      horizon_.push_back({triangle.corner[edge], to, beyond, back});
    }
    // With exact sides this is never so.
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

/// The same order of numbers on every machine (splitmix64), to shuffle with.
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
/// The hull by random increments, with the sides that `Sides` decides.
template <SideTest Sides, class... Arguments>
Hull convex_hull_with(const std::vector<Vector3<double>>& points, Arguments... arguments) {
  require_finite_points(points);
  // In random order, and copied so: then what is used together lies together.
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
  GrowingHull<Sides> hull(sides, simplex.points, n);

  // Of equal points the one with the least index is told.
  std::vector<int> name = order;
  const auto dropped = [&](int p, int q) {
    const auto at = [&shuffled](int i) { return shuffled[static_cast<std::size_t>(i)]; };
    if (at(p) != at(q)) return;
    int& told = name[static_cast<std::size_t>(p)];
    told = std::min(told, order[static_cast<std::size_t>(q)]);
  };
  for (int p = 0; p < n; ++p) {
    if (hull.wait(p, std::array{0, 1, 2, 3})) continue;
    for (const int corner : simplex.points) dropped(corner, p);
  }
  for (int p = 0; p < n && !hull.stuck(); ++p) {
    if (hull.sees(p) >= 0) hull.add(p, hull.sees(p), dropped);
  }
  return hull.finish([&name](int p) { return name[static_cast<std::size_t>(p)]; });
}
// [/convex-hull-with]

// [convex-hull]
/// The convex hull of points in space, with every decision exact.
///
/// Every point is on or inside it, every face is a convex polygon, and all of one plane is one
/// face; `Hull` says what comes back for points in a plane, on a line, all equal, or none.
///
/// @param points m, any number, any scale; throws std::invalid_argument unless all are finite
///
/// Limits: exact for every finite input; fewer than 2^29 points. For points in a random order, no
/// four of them in one plane, the expected time is O(n log n). The order is shuffled, but the same
/// each time: who knows it can make points for which it is bad.
///
/// Source: Clarkson and Shor, Applications of Random Sampling in Computational Geometry II, 1989,
/// who keep for each point all triangles that it sees; that one is enough to wait at is from
/// Barber, Dobkin and Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996.
inline Hull convex_hull(const std::vector<Vector3<double>>& points) {
  return convex_hull_with<ExactSides>(points);
}
// [/convex-hull]

}  // namespace contact
