/// @file
/// Rays aimed at balls and at boxes, for the ladder and for the comparison with other programs.
/// Every coordinate is a float, so that every method in every scalar gets the same input.
#pragma once

#include <support/generators.hpp>

#include <cmath>
#include <contact/aabb.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <limits>

namespace families {

using contact::Aabb;
using contact::Ray;
using contact::Sphere;
using generators::Random;
using Point = contact::Vector3<double>;

/// A ray at a ball. One in eight lies in the plane z = 0, where a figure can show it.
struct AtSphere {
  Ray<float> ray;
  Sphere<float> body;
  Point start;         ///< before it was moved back
  Point through;       ///< the ray is from start to this
  double quarter = 0;  ///< its start was moved back by 10^(quarter/4); 0: not moved
};
struct AtBox {
  Ray<float> ray;
  Aabb<float> body;
};

/// Rounded to floats. Not inlined: GCC 12.2 with -O2 takes two doubles that are rounded to float
/// and converted back for the same doubles, and so leaves the rounding out.
[[gnu::noinline]] inline contact::Vector3<float> in_float(const Point& v) {
  return v.cast<float>();
}
/// The double that a coordinate becomes by that.
inline double rounded(double x) { return in_float({x, 0, 0}).cast<double>().x(); }
inline Point rounded(const Point& v) { return in_float(v).cast<double>(); }

inline Point in_cube(Random& random) {
  return Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}
/// By rejection: no sine and cosine, which differ from machine to machine.
inline Point unit(Random& random) {
  for (;;) {
    const Point v = in_cube(random);
    const double square = v.dot(v);
    if (square > 0.01 && square <= 1) return v / std::sqrt(square);
  }
}
inline Point whole(Random& random, int largest) {
  return Point{double(random.integer(-largest, largest)), double(random.integer(-largest, largest)),
               double(random.integer(-largest, largest))};
}
/// A whole direction that is not 0.
inline Point whole_direction(Random& random, int largest) {
  for (;;) {
    const Point v = whole(random, largest);
    if (v != Point::Zero()) return v;
  }
}
/// The neighbouring float of one coordinate.
inline float beside(Random& random, float x) {
  return std::nextafter(x, random.chance(0.5) ? 4.0f * std::abs(x) + 1 : -4.0f * std::abs(x) - 1);
}

// Balls --------------------------------------------------------------------------------------

inline bool in_a_plane(Random& random) { return random.chance(0.125); }
inline Point flattened(const Point& v, bool flat) { return flat ? Point(v.x(), v.y(), 0) : v; }
/// A unit vector, in the plane z = 0 if flat.
inline Point direction(Random& random, bool flat) {
  for (;;) {
    const Point v = flattened(in_cube(random), flat);
    const double square = v.dot(v);
    if (square > 0.01 && square <= 1) return v / std::sqrt(square);
  }
}
/// A unit vector across another one.
inline Point across(Random& random, const Point& along, bool flat) {
  for (;;) {
    const Point v = (flat ? Point(Point::UnitZ()) : unit(random)).cross(along);
    const double square = v.dot(v);
    if (square > 0.01) return (random.chance(0.5) ? v : Point(-v)) / std::sqrt(square);
  }
}

inline Sphere<double> any_sphere(Random& random, bool flat) {
  const Point centre = flattened(in_cube(random), flat);
  return {rounded(centre), rounded(random.uniform(0.25, 1))};
}
inline AtSphere at_sphere(const Point& start, const Point& direction, const Sphere<double>& ball) {
  return {{in_float(start), in_float(direction)},
          {in_float(ball.centre), static_cast<float>(ball.radius)},
          start,
          start + direction};
}
/// From a start towards a point of the plane perpendicular to its axis, this many radii from the
/// centre. The direction is a unit vector, as rounded.
inline AtSphere aside(Random& random, const Sphere<double>& ball, double distance, double radii,
                      bool flat) {
  const Point start = rounded(ball.centre + distance * ball.radius * direction(random, flat));
  const Point axis = (ball.centre - start).normalized();
  const Point target = rounded(ball.centre + radii * ball.radius * across(random, axis, flat));
  AtSphere aimed = at_sphere(start, (target - start).normalized(), ball);
  aimed.through = target;
  return aimed;
}

inline AtSphere sphere_random(Random& random) {
  const bool flat = in_a_plane(random);
  const Sphere<double> ball = any_sphere(random, flat);
  const double distance = random.uniform(1.5, 6);
  return aside(random, ball, distance, random.uniform(0, 1.6), flat);
}
/// A tangent, as rounded.
inline AtSphere sphere_tangent(Random& random) {
  const bool flat = in_a_plane(random);
  const Sphere<double> ball = any_sphere(random, flat);
  const double distance = random.uniform(1.5, 6);
  // The tangent from this distance passes the plane perpendicular to its axis further out than the
  // radius.
  const double radii = distance / std::sqrt(distance * distance - 1);
  return aside(random, ball, distance, radii, flat);
}
/// 10^k for k in quarters, as the figure of the chapter has it.
inline double power_of_ten(int quarters) {
  constexpr double quarter[] = {1, 1.7782794100389228, 3.1622776601683795, 5.623413251903491};
  double power = quarter[quarters % 4];
  for (int i = 0; i < quarters / 4; ++i) power *= 10;
  return power;
}
/// Moved back by 100 to 10⁶, along a line up to two radii from the centre.
inline AtSphere sphere_far(Random& random) {
  const bool flat = in_a_plane(random);
  const Sphere<double> ball = any_sphere(random, flat);
  const double radii = random.uniform(0, 2);
  AtSphere aimed = aside(random, ball, 3, radii, flat);
  // Parallel to the axis, so that the distance of the line is that of the start.
  const Point ahead = aimed.through - aimed.start;
  const Point along = ahead / std::sqrt(ahead.squaredNorm());
  const int quarters = random.integer(8, 24);
  aimed.quarter = quarters;
  aimed.ray.origin = in_float(aimed.start - power_of_ten(quarters) * along);
  aimed.ray.direction = in_float(along);
  return aimed;
}
/// As at random, with a direction of 2^-70 to 2^70, whose fourth power overflows in float.
inline AtSphere sphere_lengths(Random& random) {
  AtSphere aimed = sphere_random(random);
  aimed.ray.direction *= static_cast<float>(std::ldexp(1.0, random.integer(-70, 70)));
  aimed.through = aimed.start + aimed.ray.direction.cast<double>();
  return aimed;
}
/// Starts on the surface, as rounded, in any direction.
inline AtSphere sphere_surface(Random& random) {
  const bool flat = in_a_plane(random);
  const Sphere<double> ball = any_sphere(random, flat);
  const Point start = rounded(ball.centre + ball.radius * direction(random, flat));
  return at_sphere(start, direction(random, flat), ball);
}
/// Starts inside, not near the surface.
inline AtSphere sphere_inside(Random& random) {
  const bool flat = in_a_plane(random);
  const Sphere<double> ball = any_sphere(random, flat);
  const double distance = random.uniform(0, 0.9) * ball.radius;
  const Point start = rounded(ball.centre + distance * direction(random, flat));
  return at_sphere(start, direction(random, flat), ball);
}
/// Whole numbers: many tangents, many starts on the surface.
inline AtSphere sphere_grid(Random& random) {
  const bool flat = in_a_plane(random);
  const Point centre = flattened(whole(random, 4), flat);
  const double radius = random.integer(0, 4);
  const Point start = flattened(whole(random, 6), flat);
  Point along = Point::Zero();
  while (along == Point::Zero()) along = flattened(whole(random, 2), flat);
  return at_sphere(start, along, {centre, radius});
}
/// A tangent of whole numbers, with the start one float off it, or the radius.
inline AtSphere sphere_beside(Random& random) {
  const bool flat = in_a_plane(random);
  const int axis = random.integer(0, flat ? 1 : 2);
  const int aside = flat ? 1 - axis : (axis + 1) % 3;
  const Point centre = flattened(whole(random, 4), flat);
  double radius = random.integer(1, 4);
  Point start = centre;
  start(axis) += radius + random.integer(2, 8);
  start(aside) += random.chance(0.5) ? radius : -radius;
  double& moved = random.chance(0.5) ? radius : start(aside);
  moved = beside(random, static_cast<float>(moved));
  return at_sphere(start, -Point::Unit(axis), {centre, radius});
}

// Boxes --------------------------------------------------------------------------------------

inline Aabb<double> any_box(Random& random) {
  const Point centre = in_cube(random);
  const Point half{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)};
  return {rounded(centre - half), rounded(centre + half)};
}
inline AtBox aimed_at_box(const Point& origin, const Point& direction, const Aabb<double>& box) {
  return {{in_float(origin), in_float(direction)}, {in_float(box.low), in_float(box.high)}};
}
inline Point in_box(Random& random, const Aabb<double>& box) {
  const Point share{random.uniform(), random.uniform(), random.uniform()};
  return box.low + share.cwiseProduct(box.high - box.low);
}

inline AtBox box_random(Random& random) {
  const Aabb<double> box = any_box(random);
  const Point origin = 5 * in_cube(random);
  const Point middle = (box.low + box.high) / 2;
  const Point target = middle + 1.7 * (in_box(random, box) - middle);
  return aimed_at_box(origin, target - origin, box);
}
/// Through a point of an edge, as rounded.
inline Point on_edge(Random& random, const Aabb<double>& box) {
  Point target = in_box(random, box);
  const int axis = random.integer(0, 2);
  for (const int k : {(axis + 1) % 3, (axis + 2) % 3}) {
    target(k) = random.chance(0.5) ? box.low(k) : box.high(k);
  }
  return target;
}
inline AtBox box_edge(Random& random) {
  const Aabb<double> box = any_box(random);
  const Point origin = rounded(5 * in_cube(random));
  return aimed_at_box(origin, on_edge(random, box) - origin, box);
}
/// In the plane of a face: a component of the direction is 0, and the origin is on the face.
inline AtBox box_face(Random& random) {
  const Aabb<double> box = any_box(random);
  const int axis = random.integer(0, 2);
  const bool upper = random.chance(0.5);
  Point origin = rounded(5 * in_cube(random));
  Point target = box.low + 1.5 * (in_box(random, box) - box.low);
  origin(axis) = target(axis) = upper ? box.high(axis) : box.low(axis);
  // One of its signs of zero: both are common.
  Point direction = target - origin;
  direction(axis) = random.chance(0.5) ? 0.0 : -0.0;
  return aimed_at_box(origin, direction, box);
}
/// A thousand to a million sizes away, at an edge.
inline AtBox box_far(Random& random) {
  const Aabb<double> box = any_box(random);
  const Point origin =
      rounded(Point{random.magnitude(10, 19), random.magnitude(10, 19), random.magnitude(10, 19)});
  return aimed_at_box(origin, on_edge(random, box) - origin, box);
}
/// As at random, with a direction of 2^-140 to 2^120: the smaller ones have a reciprocal that
/// overflows in float.
inline AtBox box_lengths(Random& random) {
  AtBox aimed = box_random(random);
  const double length = std::ldexp(1.0, random.integer(-140, 120));
  aimed.ray.direction = in_float(aimed.ray.direction.cast<double>() * length);
  return aimed;
}
/// Starts on a face, an edge or a corner, in any direction.
inline AtBox box_surface(Random& random) {
  const Aabb<double> box = any_box(random);
  Point origin = rounded(in_box(random, box));
  const int faces = random.integer(1, 3), axis = random.integer(0, 2);
  for (int i = 0; i < faces; ++i) {
    const int k = (axis + i) % 3;
    origin(k) = random.chance(0.5) ? box.low(k) : box.high(k);
  }
  Point direction = in_cube(random);
  if (random.chance(0.5)) direction(random.integer(0, 2)) = 0;
  return aimed_at_box(origin, direction, box);
}
/// Starts inside, not near a face.
inline AtBox box_inside(Random& random) {
  const Aabb<double> box = any_box(random);
  const Point middle = (box.low + box.high) / 2;
  const Point origin = middle + 0.9 * (in_box(random, box) - middle);
  return aimed_at_box(origin, in_cube(random), box);
}
/// Whole numbers: lines in faces, along edges, through corners; flat boxes.
inline AtBox box_grid(Random& random) {
  const Point one = whole(random, 3), other = whole(random, 3);
  const Point origin = whole(random, 5);
  return aimed_at_box(origin, whole_direction(random, 2),
                      {one.cwiseMin(other), one.cwiseMax(other)});
}
/// At an edge of whole numbers, with one coordinate of the origin or of the edge one float off.
inline AtBox box_beside(Random& random) {
  const Point one = whole(random, 3);
  const Point size{double(random.integer(1, 3)), double(random.integer(1, 3)),
                   double(random.integer(1, 3))};
  const Aabb<double> box{one, one + size};
  const Point edge = on_edge(random, box);
  const Point direction = whole_direction(random, 3);
  AtBox aimed = aimed_at_box(edge - random.integer(1, 3) * direction, direction, box);
  aimed.ray.origin = in_float(aimed.ray.origin.cast<double>());
  const int k = random.integer(0, 2);
  switch (random.integer(0, 2)) {
    case 0:
      aimed.ray.origin(k) = beside(random, aimed.ray.origin(k));
      break;
    case 1:
      aimed.body.low(k) = beside(random, aimed.body.low(k));
      break;
    default:
      aimed.body.high(k) = beside(random, aimed.body.high(k));
  }
  return aimed;
}

}  // namespace families
