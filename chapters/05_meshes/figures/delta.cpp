// A mesh that moves while a point goes from a to b: the point's path as the mesh sees it, the chord
// that the delta matrix gives, its bound, and what each of them hits. Everything lies in z = 0, and
// the mesh turns about z.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/moving_mesh.hpp>
#include <contact/moving_mesh_certified.hpp>
#include <contact/sine_cosine.hpp>
#include <cstddef>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;
using Matrix = contact::Matrix4<double>;

struct Input {
  Point a, b;        // of the point, in the world, m
  Point start, end;  // of the mesh's origin, m
  double turned;     // of the mesh at the start, degrees
  double turn;       // θ, by which it turns in the step, degrees
  double time;       // drawn, as a fraction of the step
  double substeps;   // 1 to 16: as many chords
};

constexpr std::size_t corners = 6, path_points = 97, max_substeps = 16;

struct Output {
  double problem;
  // In the world.
  std::array<Point, corners> before, after, now;
  Point point_now;
  Point carried, carried_by_rows;  // a', by the two conventions
  // In the mesh's frame.
  std::array<Point, corners> outline;
  std::array<Point, path_points> path;
  Point path_now;
  std::array<Point, max_substeps + 1> chords;  // their ends
  double used;                                 // how many chords
  double bound;                                // of the distance of path and chords, m
  double deviation;                            // measured between points of the path, m
  double path_hit, path_s;                     // by 512 chords; s is the fraction of the step
  Point path_at;
  double chord_hit, chord_s;
  Point chord_at;
  double present_hit;  // of a b and the mesh at the end
  Point present_at;    // in the world
  double verdict;      // certified: 0 hit, 1 free, 2 undecided
  // For a reader's function: the matrices of the poses and of the point's displacement, column by
  // column, and the ends of the chord.
  std::array<double, 16> pose_before, pose_after, displaced;
  Vector seen_from, seen_to;
  std::array<double, 16> columns, rows;  // the matrices, row by row
  Point mixed;              // M₀⁻¹ M₁ of matrices for columns, applied to the column a
  double mixed_off;         // its distance from a'
  double missed, invented;  // goals of questions: the chord misses a hit of the path, or has one
                            // where the path has none
};

namespace {

// A paddle with a hook. Its origin, about which it turns, is beside it.
const contact::Polygon<double> profile{{0.75, -0.125}, {2, -0.125},   {2, 0.75},
                                       {1.75, 0.75},   {1.75, 0.125}, {0.75, 0.125}};

Vector space(const Point& p) { return {p.x(), p.y(), 0}; }
Point plane(const Vector& v) { return v.head<2>(); }

contact::CoordinateFrame<double> turned_frame(const Point& origin, double degrees) {
  const auto [s, c] = contact::sine_cosine(degrees * 0.017453292519943295);
  contact::CoordinateFrame<double> frame{space(origin), contact::Matrix3<double>::Identity()};
  frame.axes << c, -s, 0, s, c, 0, 0, 0, 1;
  return frame;
}

std::array<Point, corners> placed(const contact::CoordinateFrame<double>& frame) {
  std::array<Point, corners> outline;
  std::transform(profile.begin(), profile.end(), outline.begin(), [&](const Point& p) {
    return plane(contact::position_in_world(frame, space(p)));
  });
  return outline;
}

std::array<double, 16> entries(const Matrix& matrix) {
  std::array<double, 16> list;
  for (std::size_t i = 0; i < 16; ++i) list[i] = matrix(int(i / 4), int(i % 4));
  return list;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.a, &in.b, &in.start, &in.end}) {
    if (v->cwiseAbs().maxCoeff() > 1e4) out.problem = contact::figure::too_large;
  }
  if (std::abs(in.turned) > 1e4 || std::abs(in.turn) > 1e4)
    out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;

  const contact::Mesh<double> mesh = contact::prism_mesh(profile, -1, 1);
  contact::RigidMotion<double> motion;
  motion.start = turned_frame(in.start, in.turned);
  motion.displacement = space(in.end - in.start);
  motion.rotation = {0, 0, in.turn * 0.017453292519943295};
  const auto pose0 = motion.start, pose1 = contact::frame_at(motion, 1.0);
  const contact::Segment<double> path{space(in.a), space(in.b)};
  const double time = std::clamp(in.time, 0.0, 1.0);
  const int substeps = static_cast<int>(std::clamp(in.substeps, 1.0, double(max_substeps)));

  out.before = placed(pose0);
  out.after = placed(pose1);
  out.now = placed(contact::frame_at(motion, time));
  out.point_now = in.a + time * (in.b - in.a);

  const Matrix m0 = contact::homogeneous_matrix(pose0), m1 = contact::homogeneous_matrix(pose1);
  const Matrix columns = contact::delta_matrix(m0, m1);
  const Matrix rows = contact::delta_matrix_rows<double>(m0.transpose(), m1.transpose());
  out.columns = entries(columns);
  out.rows = entries(rows);
  out.pose_before = entries(m0.transpose());
  out.pose_after = entries(m1.transpose());
  contact::CoordinateFrame<double> displaced;
  displaced.origin = path.end - path.start;
  out.displaced = entries(contact::homogeneous_matrix(displaced).transpose());
  const contact::Segment<double> chord = contact::chord_in_body(path, pose0, pose1);
  out.seen_from = chord.start;
  out.seen_to = chord.end;
  const Vector carried = contact::carried_column(columns, path.start);
  out.carried = plane(carried);
  out.carried_by_rows = plane(contact::carried_row(path.start, rows));
  const Matrix product = contact::inverse_of_frame_matrix(m0) * m1;
  const Vector mixed = contact::carried_column(product, path.start);
  out.mixed = plane(mixed);
  out.mixed_off = std::sqrt((mixed - carried).squaredNorm());

  std::copy(profile.begin(), profile.end(), out.outline.begin());
  const auto seen = [&](double s) { return contact::path_in_body(motion, path, s); };
  out.path_now = plane(seen(time));
  out.used = substeps;
  for (int i = 0; i <= substeps; ++i)
    out.chords[std::size_t(i)] = plane(seen(double(i) / substeps));
  for (std::size_t i = 0; i < path_points; ++i) {
    const double s = double(i) / (path_points - 1);
    out.path[i] = plane(seen(s));
    const int substep = std::min(static_cast<int>(s * substeps), substeps - 1);
    const Point from = out.chords[std::size_t(substep)], to = out.chords[std::size_t(substep) + 1];
    const Point on_chord = from + (s * substeps - substep) * (to - from);
    out.deviation = std::max(out.deviation, std::sqrt((out.path[i] - on_chord).squaredNorm()));
  }
  out.bound = contact::chord_bound(motion, path, substeps);

  if (const auto hit = contact::moving_by_substeps(path, mesh, motion, 512)) {
    out.path_hit = 1;
    out.path_s = hit->time;
    out.path_at = plane(hit->hit.point);
  }
  if (const auto hit = contact::moving_by_substeps(path, mesh, motion, substeps)) {
    out.chord_hit = 1;
    out.chord_s = hit->time;
    out.chord_at = plane(hit->hit.point);
  }
  if (const auto hit = contact::segment_against_present_mesh(path, mesh, pose1)) {
    out.present_hit = 1;
    out.present_at = plane(contact::position_in_world(pose1, hit->point));
  }
  out.verdict = double(static_cast<int>(contact::certified_moving_hit(path, mesh, motion).verdict));
  out.missed = out.path_hit > out.chord_hit ? 1 : 0;
  out.invented = out.chord_hit > out.path_hit ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(a, b, start, end, turned, turn, time, substeps), Output,
       FIELDS(problem, before, after, now, point_now, carried, carried_by_rows, outline, path,
              path_now, chords, used, bound, deviation, path_hit, path_s, path_at, chord_hit,
              chord_s, chord_at, present_hit, present_at, verdict, pose_before, pose_after,
              displaced, seen_from, seen_to, columns, rows, mixed, mixed_off, missed, invented))
