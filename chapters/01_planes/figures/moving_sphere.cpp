// A moving sphere against a plane: the centre against the plane moved by the radius.
#include <contact/figure.hpp>
#include <contact/moving_sphere_plane.hpp>
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>
#include <contact/sphere_plane.hpp>

struct Input {
  contact::Vector3<double> normal;  // of any length but zero
  contact::Vector3<double> point;   // of the plane
  contact::Vector3<double> centre;  // of the sphere at the start of the step
  double radius;
  contact::Vector3<double> displacement;  // of the centre during the step
};

struct Output {
  double problem;
  contact::Vector3<double> unit_normal;
  double offset;
  double start_distance;
  double start_side;                      // direction in which the plane is moved: 1 or -1
  contact::Vector3<double> offset_point;  // the plane's point on the plane moved by the radius
  double gap;                             // distance of the sphere's surface from the plane
  double closing;                         // closing distance of the displacement
  double overlap_at_start;
  double hit;
  double t;
  contact::Vector3<double> touch_centre;
  contact::Vector3<double> contact_point;
  contact::Vector3<double> contact_normal;
  contact::Vector3<double> end_centre;
  double end_depth;   // penetration at the end of the step without a collision response; 0 if
                      // clear
  double centre_hit;  // result of a test of the centre against the plane itself
  double centre_t;
  double
      half_way_from_behind;  // goal of a question: starts behind, touches at half the displacement
};

Output compute(const Input& in) {
  Output out{};
  if (in.normal == contact::Vector3<double>::Zero()) out.problem = contact::figure::zero_normal;
  if (!(in.radius > 0)) out.problem = contact::figure::not_positive;
  if (in.radius > 1e150) out.problem = contact::figure::too_large;
  for (const auto* v : {&in.normal, &in.point, &in.centre, &in.displacement}) {
    if (v->cwiseAbs().maxCoeff() > 1e150) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;

  const auto plane = contact::plane_from_normal_and_point(in.normal, in.point);
  const contact::Sphere<double> sphere{in.centre, in.radius};
  const double distance = contact::signed_distance(plane, in.centre);
  const double towards = plane.normal.dot(in.displacement);
  const double side = distance > 0 || (distance == 0 && towards <= 0) ? 1 : -1;
  out.unit_normal = plane.normal;
  out.offset = plane.offset;
  out.start_distance = distance;
  out.start_side = side;
  out.offset_point = in.point + side * in.radius * plane.normal;
  out.gap = side * distance - in.radius;
  out.closing = -side * towards;
  out.overlap_at_start = contact::sphere_meets_plane(sphere, plane) ? 1 : 0;
  out.end_centre = in.centre + in.displacement;
  out.end_depth = std::max(0.0, in.radius - side * contact::signed_distance(plane, out.end_centre));

  const auto touch = contact::moving_sphere_plane(sphere, in.displacement, plane);
  if (touch) {
    out.hit = 1;
    out.t = touch->t;
    out.touch_centre = touch->centre;
    out.contact_point = touch->point;
    out.contact_normal = touch->normal;
    out.half_way_from_behind = side < 0 && std::abs(out.t - 0.5) <= 0.01 ? 1 : 0;
  }
  const auto centre_only = contact::segment_plane({in.centre, out.end_centre}, plane);
  if (centre_only) {
    out.centre_hit = 1;
    out.centre_t = centre_only->t;
  }
  return out;
}

FIGURE(Input, FIELDS(normal, point, centre, radius, displacement), Output,
       FIELDS(problem, unit_normal, offset, start_distance, start_side, offset_point, gap, closing,
              overlap_at_start, hit, t, touch_centre, contact_point, contact_normal, end_centre,
              end_depth, centre_hit, centre_t, half_way_from_behind))
