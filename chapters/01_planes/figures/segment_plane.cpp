// A segment against a plane: signed distances of the ends, and where the segment crosses.
#include <contact/figure.hpp>
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>

struct Input {
  contact::Vector3<double> normal;  // of any length but zero
  contact::Vector3<double> point;   // of the plane
  contact::Vector3<double> start;
  contact::Vector3<double> end;
};

struct Output {
  double problem;
  contact::Vector3<double> unit_normal;
  double offset;
  double start_distance;
  double end_distance;
  double start_side;  // -1 behind, 0 on, 1 in front
  double end_side;
  contact::Vector3<double> start_foot;  // nearest point of the plane
  contact::Vector3<double> end_foot;
  double in_plane;  // 1 if both ends are on the plane
  double hit;       // 1 if there is one meeting point
  double t;
  contact::Vector3<double> meeting;
  double quarter_from_behind;  // goal of a question: starts behind, crosses at t = 1/4
};

Output compute(const Input& in) {
  Output out{};
  if (in.normal == contact::Vector3<double>::Zero()) out.problem = contact::figure::zero_normal;
  for (const auto* v : {&in.normal, &in.point, &in.start, &in.end}) {
    if (v->cwiseAbs().maxCoeff() > 1e150) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;

  const auto plane = contact::plane_from_normal_and_point(in.normal, in.point);
  out.unit_normal = plane.normal;
  out.offset = plane.offset;
  out.start_distance = contact::signed_distance(plane, in.start);
  out.end_distance = contact::signed_distance(plane, in.end);
  out.start_side = static_cast<double>(contact::side(plane, in.start));
  out.end_side = static_cast<double>(contact::side(plane, in.end));
  out.start_foot = in.start - out.start_distance * plane.normal;
  out.end_foot = in.end - out.end_distance * plane.normal;
  out.in_plane = out.start_side == 0 && out.end_side == 0 ? 1 : 0;

  const auto hit = contact::segment_plane({in.start, in.end}, plane);
  if (hit) {
    out.hit = 1;
    out.t = hit->t;
    out.meeting = hit->point;
    out.quarter_from_behind = out.start_side < 0 && std::abs(out.t - 0.25) <= 0.01 ? 1 : 0;
  }
  return out;
}

FIGURE(Input, FIELDS(normal, point, start, end), Output,
       FIELDS(problem, unit_normal, offset, start_distance, end_distance, start_side, end_side,
              start_foot, end_foot, in_plane, hit, t, meeting, quarter_from_behind))
