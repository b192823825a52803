// One set of points and several methods for its hull: where they differ, at most one is right.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/convex_hull.hpp>
#include <contact/exact.hpp>
#include <contact/figure.hpp>
#include <contact/gift_wrapping.hpp>
#include <map>
#include <utility>
#include <vector>

using Point = contact::Vector3<double>;

struct Input {
  Point a, b, c, d, e, f, g, h;
  double method;   // 0 exact, 1 angles as on the slide, 2 signed angles, 3 incremental with an
                   // epsilon, 4 incremental in float, 5 in double, 6 wrapping in double
  double epsilon;  // m, for method 3
  double shown;    // how many triangles are shown
  double flat;     // 0: as they are; k: flattened to 10^-k of their heights, onto a sloping plane
};

constexpr int count = 8;
constexpr int most = 24;

struct Output {
  double problem;
  double dimension, corners, faces;        // of the exact hull
  double triangles;                        // made by the method
  double closed;                           // 1 if they close
  double right;                            // 1 if they are the hull
  std::array<double, 3 * most> vertex;     // three indices a triangle
  std::array<double, most> in_front;       // how many points are exactly in front of it
  double open_edges;                       // edges that belong to one triangle only
  std::array<double, 2 * 3 * most> open;   // their ends
  double outside;                          // points that are exactly in front of some triangle
  double found;                            // vertices of the exact hull that the method has
  std::array<double, count> lost;          // 1 for those that it lacks
  std::array<double, 3 * count> position;  // positions as stored, with the heights stretched back
};

namespace {

constexpr double slope_x = 0.3, slope_y = 0.7;

double power_of_ten(double k) {
  double power = 1;
  for (; k > 0; --k) power *= 10;
  return power;
}

/// The point flattened onto the sloping plane, as doubles store it.
Point pressed(const Point& p, double power) {
  return {p.x(), p.y(), slope_x * p.x() + slope_y * p.y() + p.z() / power};
}

/// The height of a stored point above the sloping plane, times the power.
double drawn_up(const Point& p, double power) {
  using contact::Exact;
  const Exact plane = Exact(slope_x) * Exact(p.x()) + Exact(slope_y) * Exact(p.y());
  return quotient<double>((Exact(p.z()) - plane) * Exact(power), Exact(1.0));
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  std::vector<Point> points{in.a, in.b, in.c, in.d, in.e, in.f, in.g, in.h};
  out.vertex.fill(-1);
  out.open.fill(-1);
  for (const Point& p : points) {
    if (p.cwiseAbs().maxCoeff() > 1e100) out.problem = contact::figure::too_large;
  }
  if (!(in.epsilon >= 0)) out.problem = contact::figure::not_positive;
  if (out.problem != 0) return out;

  const double flat = in.flat > 0 ? std::min(std::round(in.flat), 16.0) : 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point& p = points[i];
    Point drawn = p;
    if (flat > 0) {
      p = pressed(p, power_of_ten(flat));
      drawn.z() = drawn_up(p, power_of_ten(flat));
    }
    for (int k = 0; k < 3; ++k) out.position[3 * i + static_cast<std::size_t>(k)] = drawn[k];
  }

  const contact::Hull exact = contact::convex_hull(points);
  out.dimension = exact.dimension;
  out.corners = static_cast<double>(exact.vertices.size());
  out.faces = exact.face_count();

  std::vector<std::array<int, 3>> triangles;
  std::vector<int> corners;
  bool closed = true;
  if (in.method == 1 || in.method == 2) {
    const auto fold = in.method == 1 ? contact::FoldAngle::unsigned_ : contact::FoldAngle::signed_;
    const contact::Wrapping wrapping = contact::wrap_by_angles<double>(points, fold);
    triangles = wrapping.triangles;
    closed = wrapping.closed;
  } else if (in.method >= 3 && in.method <= 6) {
    using contact::RoundedSides;
    const contact::Hull hull =
        in.method == 3   ? contact::convex_hull_with<RoundedSides<double>>(points, in.epsilon)
        : in.method == 4 ? contact::convex_hull_with<RoundedSides<float>>(points)
        : in.method == 5 ? contact::convex_hull_with<RoundedSides<double>>(points)
                         : contact::gift_wrap_with<RoundedSides<double>>(points);
    triangles = contact::triangles(hull);
    closed = hull.closed;
  } else {
    triangles = contact::triangles(exact);
  }
  if (triangles.size() > most) triangles.resize(most);
  for (const auto& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  out.triangles = static_cast<double>(triangles.size());
  out.closed = closed ? 1 : 0;
  for (const int vertex : exact.vertices) {
    const bool has = std::binary_search(corners.begin(), corners.end(), vertex);
    (has ? out.found : out.lost[static_cast<std::size_t>(vertex)]) += 1;
  }

  const auto at = [&points](int i) { return points[static_cast<std::size_t>(i)]; };
  std::array<bool, count> outside{};
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [i, j, k] = triangles[t];
    out.vertex[3 * t] = i;
    out.vertex[3 * t + 1] = j;
    out.vertex[3 * t + 2] = k;
    for (int p = 0; p < count; ++p) {
      if (contact::orient_3d(at(i), at(j), at(k), at(p)) <= 0) continue;
      outside[static_cast<std::size_t>(p)] = true;
      ++out.in_front[t];
    }
    for (const auto& edge : {std::pair{i, j}, std::pair{j, k}, std::pair{k, i}}) {
      ++edges[edge];
      --edges[{edge.second, edge.first}];
    }
  }
  for (const auto& [edge, surplus] : edges) {
    if (surplus <= 0 || 2 * out.open_edges + 2 > static_cast<double>(out.open.size())) continue;
    const auto position = static_cast<std::size_t>(2 * out.open_edges);
    out.open[position] = edge.first;
    out.open[position + 1] = edge.second;
    ++out.open_edges;
  }
  for (const bool is_outside : outside) out.outside += is_outside;
  const double needed = out.dimension == 3 ? 2 * out.corners - 4 : 2 * (out.corners - 2);
  out.right = closed && out.open_edges == 0 && out.outside == 0 && corners == exact.vertices &&
                      (out.dimension < 2 || out.triangles == needed)
                  ? 1
                  : 0;
  return out;
}

FIGURE(Input, FIELDS(a, b, c, d, e, f, g, h, method, epsilon, shown, flat), Output,
       FIELDS(problem, dimension, corners, faces, triangles, closed, right, vertex, in_front,
              open_edges, open, outside, found, lost, position))
