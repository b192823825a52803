// A plank and a floor with a peak: what collision points and collision segments on their perimeters
// find, and the normal by three rules.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/perimeter.hpp>
#include <vector>

using Point = contact::Vector2<double>;

struct Input {
  Point centre;    // of the box, m
  Point front;     // from the centre, in which the box's long side points
  Point peak;      // of the floor, m
  double tiles;    // in how many segments the level floor is divided
  double spacing;  // of the points, m
  double method;   // 0 points; segments, with the normal 1 of the segment that was hit, 2 by the
                   // nearer end, as in the lecture, 3 of least penetration, the book's
};

constexpr double half_length = 1.5, half_width = 0.3;
constexpr double floor_level = -0.75, floor_left = -4.5, floor_right = 4.5, floor_bottom = -3;
constexpr double peak_left = -3.25, peak_right = -1.75;
constexpr int max_tiles = 12, max_floor = 6 + max_tiles, max_hits = 16;
constexpr int max_box_points = 60, max_floor_points = 240;
constexpr double min_spacing = 0.2;

struct Output {
  double problem;
  std::array<Point, 4> box;
  double floor_count;
  std::array<Point, max_floor> floor;
  double meets;  // 1 if the two regions have a point in common
  // Points.
  double box_points, floor_points;
  std::array<Point, max_box_points> box_point;
  std::array<Point, max_floor_points> floor_point;
  std::array<double, max_box_points> box_point_hit;      // 1 if it is in the floor or on it
  std::array<double, max_floor_points> floor_point_hit;  // 1 if it is in the box or on it
  double points_hit, points_tests;
  // Segments.
  double hits, segment_tests;
  std::array<Point, max_hits> hit_at;
  std::array<double, max_hits> box_edge, floor_edge;
  std::array<Point, max_hits> normal_of_hit, normal_by_end;
  std::array<double, max_hits> hit_differs, end_differs;  // 1 if not the book's normal
  double hit_differing, end_differing;
  // The book's face.
  double has_face, face_of_box, face_edge, depth;
  Point normal, contact_point;
  double points_miss;       // 1 if the regions meet and no point says so
  double segments_miss;     // 1 if they meet and no segments do
  double lecture_is_wrong;  // goal of a question: the rule by the nearer end gives another face
};

namespace {

using Polygon = contact::Polygon<double>;

Polygon box(const Input& in) {
  const Point along = in.front / std::sqrt(in.front.squaredNorm());
  const Point x = half_length * along, y = half_width * Point(-along.y(), along.x());
  return {in.centre - x - y, in.centre + x - y, in.centre + x + y, in.centre - x + y};
}

/// Counter-clockwise from the lower left, the tiles from right to left.
Polygon floor_of(const Input& in) {
  const int tiles = static_cast<int>(std::clamp(in.tiles, 1.0, double(max_tiles)));
  Polygon floor{{floor_left, floor_bottom}, {floor_right, floor_bottom}};
  for (int i = 0; i <= tiles; ++i)
    floor.push_back({floor_right + i * (peak_right - floor_right) / tiles, floor_level});
  floor.push_back(in.peak);
  floor.push_back({peak_left, floor_level});
  floor.push_back({floor_left, floor_level});
  return floor;
}

template <std::size_t Size>
void put_points(const std::vector<Point>& points, const Polygon& other, std::array<Point, Size>& at,
                std::array<double, Size>& hit, double& count, Output& out) {
  const contact::PointHits hits = contact::hit_points(points, other);
  for (std::size_t i = 0; i < std::min(points.size(), Size); ++i) at[i] = points[i];
  for (const int i : hits.points) {
    if (static_cast<std::size_t>(i) < Size) hit[static_cast<std::size_t>(i)] = 1;
  }
  count = double(std::min(points.size(), Size));
  out.points_hit += double(hits.points.size());
  out.points_tests += double(hits.tests);
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.centre, &in.front, &in.peak}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  if (!(in.front.cwiseAbs().maxCoeff() > 1e-6)) out.problem = contact::figure::zero_direction;
  if (!(in.spacing > 0)) out.problem = contact::figure::not_positive;
  if (out.problem != 0) return out;

  const Polygon first = box(in), second = floor_of(in);
  std::copy(first.begin(), first.end(), out.box.begin());
  std::copy(second.begin(), second.end(), out.floor.begin());
  out.floor_count = double(second.size());
  out.meets = contact::polygons_meet(first, second) ? 1 : 0;

  const double spacing = std::max(in.spacing, min_spacing);
  put_points(contact::perimeter_points(first, spacing), second, out.box_point, out.box_point_hit,
             out.box_points, out);
  put_points(contact::perimeter_points(second, spacing), first, out.floor_point,
             out.floor_point_hit, out.floor_points, out);

  const auto contact = contact::perimeter_contact(first, second);
  const auto face = contact::face_of_least_penetration(contact);
  if (face) {
    out.has_face = 1;
    out.face_of_box = face->of_first ? 1 : 0;
    out.face_edge = face->edge;
    out.depth = face->depth;
    out.normal = face->normal;
    out.contact_point = face->point;
  }
  // Two faces may lie on one line, as tiles do, so normals are compared.
  const auto differs = [&face](const Point& normal) {
    return face && normal.dot(face->normal) < 1 - 1e-9 ? 1.0 : 0.0;
  };
  out.segment_tests = double(contact.found.tests);
  for (const auto& hit : contact.found.hits) {
    const auto i = static_cast<std::size_t>(out.hits);
    if (i == max_hits) break;
    ++out.hits;
    out.hit_at[i] = hit.crossing.point;
    out.box_edge[i] = hit.first;
    out.floor_edge[i] = hit.second;
    out.normal_of_hit[i] = contact::normal_of_hit_segment(contact, hit);
    out.normal_by_end[i] = contact::normal_by_nearer_end(contact, hit);
    out.hit_differing += out.hit_differs[i] = differs(out.normal_of_hit[i]);
    out.end_differing += out.end_differs[i] = differs(out.normal_by_end[i]);
  }
  out.points_miss = out.meets != 0 && out.points_hit == 0 ? 1 : 0;
  out.segments_miss = out.meets != 0 && out.hits == 0 ? 1 : 0;
  out.lecture_is_wrong = out.end_differing > 0 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(centre, front, peak, tiles, spacing, method), Output,
       FIELDS(problem, box, floor_count, floor, meets, box_points, floor_points, box_point,
              floor_point, box_point_hit, floor_point_hit, points_hit, points_tests, hits,
              segment_tests, hit_at, box_edge, floor_edge, normal_of_hit, normal_by_end,
              hit_differs, end_differs, hit_differing, end_differing, has_face, face_of_box,
              face_edge, depth, normal, contact_point, points_miss, segments_miss,
              lecture_is_wrong))
