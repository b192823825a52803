// A hull and one more point: the triangles that it sees, its horizon, and the hull afterwards.
#include <array>
#include <contact/convex_hull.hpp>
#include <contact/figure.hpp>
#include <map>
#include <utility>
#include <vector>

using Point = contact::Vector3<double>;

struct Input {
  Point p;        // the new point
  double turned;  // 0: the triangles that it sees; 1: the hull afterwards
};

constexpr int count = 12;
constexpr int most = 22;

struct Output {
  double problem;
  std::array<Point, count> points;
  double faces;                         // triangles of the hull before
  std::array<double, 3 * most> vertex;  // three indices a triangle
  std::array<double, most> seen;        // 1 if p is in front
  double seen_count;
  double horizon_count;
  std::array<double, 2 * most> horizon;  // ends of its edges
  double vertices_before, vertices_after, faces_after;
  double sees_many;  // goal of a question: p sees eight triangles or more
};

Output compute(const Input& in) {
  Output out{};
  out.vertex.fill(-1);
  out.horizon.fill(-1);
  if (in.p.cwiseAbs().maxCoeff() > 1e100) {
    out.problem = contact::figure::too_large;
    return out;
  }
  // Nearly an icosahedron, with coordinates in whole eighths.
  const double s = 0.625, l = 1;
  std::vector<Point> points;
  for (const double x : {-s, s}) {
    for (const double y : {-l, l}) {
      points.push_back({0, x, y});
      points.push_back({x, y, 0});
      points.push_back({y, 0, x});
    }
  }
  for (std::size_t i = 0; i < count; ++i) out.points[i] = points[i];
  const contact::Hull hull = contact::convex_hull(points);
  const auto triangles = contact::triangles(hull);
  const auto at = [&points](int i) { return points[static_cast<std::size_t>(i)]; };
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t t = 0; t < triangles.size() && t < most; ++t) {
    const auto [a, b, c] = triangles[t];
    out.vertex[3 * t] = a;
    out.vertex[3 * t + 1] = b;
    out.vertex[3 * t + 2] = c;
    ++out.faces;
    if (contact::orient_3d(at(a), at(b), at(c), in.p) <= 0) continue;
    out.seen[t] = 1;
    ++out.seen_count;
    for (const auto& edge : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      ++edges[edge];
      --edges[{edge.second, edge.first}];
    }
  }
  for (const auto& [edge, surplus] : edges) {
    if (surplus <= 0) continue;
    const auto place = static_cast<std::size_t>(2 * out.horizon_count);
    out.horizon[place] = edge.first;
    out.horizon[place + 1] = edge.second;
    ++out.horizon_count;
  }
  out.vertices_before = static_cast<double>(hull.vertices.size());
  points.push_back(in.p);
  const contact::Hull after = contact::convex_hull(points);
  out.vertices_after = static_cast<double>(after.vertices.size());
  out.faces_after = after.face_count();
  out.sees_many = out.seen_count >= 8 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(p, turned), Output,
       FIELDS(problem, points, faces, vertex, seen, seen_count, horizon_count, horizon,
              vertices_before, vertices_after, faces_after, sees_many))
