/// @file
/// The hard cases of volumes that are compared, combined, carried along and moved.
#pragma once

#include <07_bounding_volumes/carried_truth.hpp>
#include <07_bounding_volumes/hard_common.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/carried_volumes.hpp>
#include <contact/error_free.hpp>
#include <contact/moving_volumes.hpp>
#include <contact/sphere_of_spheres.hpp>
#include <contact/volumes_meet.hpp>
#include <cstddef>
#include <limits>
#include <string>
#include <support/generators.hpp>
#include <support/hard_cases.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace hard_moving {

using contact::Aabb;
using contact::CoordinateFrame;
using contact::Matrix3;
using contact::Sphere;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_common::applies;
using oracle::Rational;
using oracle::Vector;

// ---------------------------------------------------------------- input

template <std::floating_point S>
Sphere<S> sphere_of(const Case& c, const char* field) {
  return generators::rounded<S>(c.sphere(field));
}
/// Nine numbers, row by row.
template <std::floating_point S>
Matrix3<S> matrix_of(const Case& c, const std::string& field) {
  const std::vector<double> x = c.numbers(field);
  Matrix3<S> m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = S(x.at(std::size_t(i)));
  return m;
}
template <std::floating_point S>
CoordinateFrame<S> frame_of(const Case& c) {
  return {generators::rounded<S>(c.vector("origin")), matrix_of<S>(c, "axes")};
}
template <std::floating_point S>
Aabb<S> box_of(const Case& c) {
  return {generators::rounded<S>(c.vector("low")), generators::rounded<S>(c.vector("high"))};
}

// ---------------------------------------------------------------- spheres that meet

template <std::floating_point S>
bool meet_by_root(const Sphere<S>& a, const Sphere<S>& b) {
  const Vector3<S> d = a.centre - b.centre;
  return std::sqrt(d.dot(d)) <= a.radius + b.radius;
}
template <std::floating_point S>
bool meet_by_squares(const Sphere<S>& a, const Sphere<S>& b) {
  const Vector3<S> d = a.centre - b.centre;
  const S r = a.radius + b.radius;
  return d.dot(d) <= r * r;
}
/// The radius of the circle in which both surfaces meet.
inline bool meet_in_a_circle(const Sphere<double>& a, const Sphere<double>& b) {
  const Vector3<double> d = b.centre - a.centre;
  const double aa = a.radius * a.radius, bb = b.radius * b.radius, dd = d.dot(d);
  const double h = 0.5 + (aa - bb) / (2 * dd);
  return aa - h * h * dd >= 0;
}

template <std::floating_point S, class Meet>
void add_meeting(hard_cases::Runner& runner, const std::string& name, const Meet& meet) {
  runner.method("spheres_meet", name, applies<S>, [meet](const Case& c, const Json& answer) {
    return meet(sphere_of<S>(c, "first"), sphere_of<S>(c, "second")) ==
           answer.at("meet").get<bool>();
  });
}

inline void add_meeting_spheres(hard_cases::Runner& runner) {
  using D = Sphere<double>;
  runner.question("spheres_meet", [](const Case& c) -> Json {
    const auto a = oracle::exact(c.sphere("first")), b = oracle::exact(c.sphere("second"));
    const Vector d = a.centre - b.centre;
    const Rational r = a.radius + b.radius;
    return {{"class", "a"}, {"meet", bool(d.dot(d) <= r * r)}};
  });
  add_meeting<float>(runner, "root, float", meet_by_root<float>);
  add_meeting<double>(runner, "root, double", meet_by_root<double>);
  add_meeting<float>(runner, "squares, float", meet_by_squares<float>);
  add_meeting<double>(runner, "squares, double", meet_by_squares<double>);
  add_meeting<double>(runner, "touching rejected, double", [](const D& a, const D& b) {
    const Vector3<double> d = a.centre - b.centre;
    return std::sqrt(d.dot(d)) < a.radius + b.radius;
  });
  add_meeting<double>(runner, "within 1e-6, double", [](const D& a, const D& b) {
    const Vector3<double> d = a.centre - b.centre;
    return std::sqrt(d.dot(d)) <= a.radius + b.radius + 1e-6;
  });
  add_meeting<double>(runner, "square against the sum of radii", [](const D& a, const D& b) {
    const Vector3<double> d = a.centre - b.centre;
    return d.dot(d) <= a.radius + b.radius;
  });
  add_meeting<double>(runner, "circle of both surfaces, double", meet_in_a_circle);
  add_meeting<double>(runner, "the book, exact",
                      [](const D& a, const D& b) { return contact::may_meet(a, b); });
}

// ---------------------------------------------------------------- the sphere of two

template <std::floating_point S>
bool encloses_exactly(const Sphere<S>& outer, const Sphere<S>& inner) {
  if (!outer.centre.allFinite() || !std::isfinite(outer.radius)) return false;
  const Vector d = oracle::exact(outer.centre) - oracle::exact(inner.centre);
  const Rational room = oracle::exact(outer.radius) - oracle::exact(inner.radius);
  return room >= 0 && d.dot(d) <= room * room;
}
/// The centre on the line of centres, the radius half of the distance and both radii.
template <std::floating_point S>
Sphere<S> half_of_the_sum(const Sphere<S>& a, const Sphere<S>& b) {
  const Vector3<S> d = b.centre - a.centre;
  const S distance = std::sqrt(d.dot(d));
  const S radius = (distance + a.radius + b.radius) / S(2);
  return {a.centre + d * ((radius - a.radius) / distance), radius};
}
/// The larger one first, if it contains the other.
template <std::floating_point S>
Sphere<S> larger_or_half_of_the_sum(const Sphere<S>& a, const Sphere<S>& b) {
  const Vector3<S> d = b.centre - a.centre;
  const S distance = std::sqrt(d.dot(d));
  if (distance + b.radius <= a.radius) return a;
  if (distance + a.radius <= b.radius) return b;
  return half_of_the_sum(a, b);
}
/// a, grown by the two points of b that are furthest along the line of centres.
template <std::floating_point S>
Sphere<S> grown_by_ends(const Sphere<S>& a, const Sphere<S>& b) {
  const Vector3<S> d = b.centre - a.centre;
  const S length = std::sqrt(d.dot(d));
  const Vector3<S> along = length > S(0) ? Vector3<S>(d / length * b.radius) : d;
  Sphere<S> result = a;
  for (const Vector3<S>& p : {Vector3<S>(b.centre + along), Vector3<S>(b.centre - along)}) {
    const Vector3<S> to = p - result.centre;
    const S far = std::sqrt(to.dot(to));
    if (far <= result.radius) continue;
    const S half = (far - result.radius) / S(2);
    result.centre += to * (half / far);
    result.radius += half;
  }
  return result;
}

/// Right if a sphere contains both, and exceeds the smallest radius by at most one part in 10⁶ and
/// two ulps of the largest coordinate, by which the centre is rounded.
template <std::floating_point S, class Make>
void add_union(hard_cases::Runner& runner, const std::string& name, const Make& make) {
  runner.method("sphere_of_two", name, applies<S>, [make](const Case& c, const Json& answer) {
    const Sphere<S> a = sphere_of<S>(c, "first"), b = sphere_of<S>(c, "second");
    const Sphere<S> both = make(a, b);
    const double smallest = hard_cases::unhex(answer, "radius");
    const S furthest = std::max(a.centre.cwiseAbs().maxCoeff(), b.centre.cwiseAbs().maxCoeff());
    return encloses_exactly(both, a) && encloses_exactly(both, b) &&
           double(both.radius) <= smallest * (1 + 1e-6) + 2 * double(contact::ulp(furthest));
  });
}

inline void add_sphere_of_two(hard_cases::Runner& runner) {
  runner.question("sphere_of_two", [](const Case& c) -> Json {
    const Sphere<double> a = c.sphere("first"), b = c.sphere("second");
    const bool first = encloses_exactly(a, b), second = encloses_exactly(b, a);
    const Vector d = oracle::exact(a.centre) - oracle::exact(b.centre);
    const oracle::Surd half{(oracle::exact(a.radius) + oracle::exact(b.radius)) / 2,
                            Rational(1) / 2, d.dot(d)};
    const double radius = first ? a.radius : (second ? b.radius : oracle::nearest(half));
    return {{"class", "b"}, {"nested", first || second}, {"radius", hard_cases::hex(radius)}};
  });
  add_union<float>(runner, "half of the sum, float", half_of_the_sum<float>);
  add_union<double>(runner, "half of the sum, double", half_of_the_sum<double>);
  add_union<float>(runner, "larger or half of the sum, float", larger_or_half_of_the_sum<float>);
  add_union<double>(runner, "larger or half of the sum, double", larger_or_half_of_the_sum<double>);
  add_union<double>(runner, "grown by two ends, double", grown_by_ends<double>);
  const auto book = []<class S>(const Sphere<S>& a, const Sphere<S>& b) {
    return contact::enclosing_sphere(a, b);
  };
  add_union<float>(runner, "the book, float", book);
  add_union<double>(runner, "the book, double", book);

  runner.question("sphere_in_sphere", [](const Case& c) -> Json {
    return {{"class", "a"}, {"contains", encloses_exactly(c.sphere("first"), c.sphere("second"))}};
  });
  const auto add = [&runner](const std::string& name, const auto& decide) {
    runner.method("sphere_in_sphere", name, [decide](const Case& c, const Json& answer) {
      return decide(c.sphere("first"), c.sphere("second")) == answer.at("contains").get<bool>();
    });
  };
  using D = Sphere<double>;
  add("centre inside", [](const D& a, const D& b) {
    return (a.centre - b.centre).squaredNorm() <= a.radius * a.radius;
  });
  add("apart by twice the first radius, or inside", [](const D& a, const D& b) {
    return (a.centre - b.centre).squaredNorm() <= 4 * a.radius * a.radius;
  });
  add("root, double", [](const D& a, const D& b) {
    const Vector3<double> d = a.centre - b.centre;
    return std::sqrt(d.dot(d)) + b.radius <= a.radius;
  });
  add("difference of radii squared, double", [](const D& a, const D& b) {
    const Vector3<double> d = a.centre - b.centre;
    return d.dot(d) <= (a.radius - b.radius) * (a.radius - b.radius);
  });
  add("the book, exact", [](const D& a, const D& b) { return contact::encloses(a, b); });
}

// ---------------------------------------------------------------- carried along

/// Right if the image of the witness, a point of the volume, is in the carried one.
template <std::floating_point S, class Carry>
void add_carried(hard_cases::Runner& runner, const std::string& question, const std::string& name,
                 const Carry& carry) {
  runner.method(question, name, applies<S>, [carry](const Case& c, const Json&) {
    const Vector p = carried_truth::image(frame_of<double>(c), oracle::exact(c.vector("witness")));
    return carried_truth::inside(carry(c), p);
  });
}
inline Json image_of_witness(const Case& c) {
  const Vector witness = oracle::exact(c.vector("witness"));
  if (c.has("sphere") ? !carried_truth::inside(c.sphere("sphere"), witness)
                      : !carried_truth::inside(box_of<double>(c), witness)) {
    throw hard_cases::CorpusError(c.name() + ": the witness is not in the volume");
  }
  const Vector p = carried_truth::image(frame_of<double>(c), oracle::exact(c.vector("witness")));
  return {{"class", "a"}, {"image", hard_cases::hex(oracle::nearest(p))}};
}

template <std::floating_point S>
Sphere<S> as_it_is(const Case& c) {
  return contact::transformed(sphere_of<S>(c, "sphere"), frame_of<S>(c));
}
template <std::floating_point S>
Aabb<S> low_and_high(const Case& c) {
  const Aabb<S> box = box_of<S>(c);
  const Vector3<S> p = contact::position_in_world(frame_of<S>(c), box.low);
  const Vector3<S> q = contact::position_in_world(frame_of<S>(c), box.high);
  return {p.cwiseMin(q), p.cwiseMax(q)};
}
template <std::floating_point S>
Aabb<S> eight_corners(const Case& c) {
  const Aabb<S> box = box_of<S>(c);
  std::vector<Vector3<S>> points;
  for (int k = 0; k < 8; ++k) {
    Vector3<S> p;
    for (int i = 0; i < 3; ++i) p[i] = ((k >> i) & 1) != 0 ? box.high[i] : box.low[i];
    points.push_back(contact::position_in_world(frame_of<S>(c), p));
  }
  return contact::aabb_of_points(hard_common::span_of<S>(points));
}
/// Centre and extents, from half sizes. `magnitudes`: of the axes, which is right but for rounding.
template <std::floating_point S>
Aabb<S> centre_and_extents(const Case& c, bool magnitudes) {
  const Aabb<S> box = box_of<S>(c);
  const CoordinateFrame<S> frame = frame_of<S>(c);
  const Vector3<S> centre =
      contact::position_in_world(frame, Vector3<S>((box.low + box.high) / S(2)));
  const Vector3<S> half = (box.high - box.low) / S(2);
  Vector3<S> extent = magnitudes ? Vector3<S>(frame.axes.cwiseAbs() * half)
                                 : Vector3<S>((frame.axes * half).cwiseAbs());
  return {centre - extent, centre + extent};
}

inline void add_carried_volumes(hard_cases::Runner& runner) {
  runner.question("carried_sphere", image_of_witness);
  add_carried<float>(runner, "carried_sphere", "radius as it is, float", as_it_is<float>);
  add_carried<double>(runner, "carried_sphere", "radius as it is, double", as_it_is<double>);
  add_carried<double>(runner, "carried_sphere", "times the longest axis", [](const Case& c) {
    Sphere<double> sphere = as_it_is<double>(c);
    const Matrix3<double> axes = matrix_of<double>(c, "axes");
    double longest = 0;
    for (int j = 0; j < 3; ++j) {
      longest = std::max(longest, axes.col(j).dot(axes.col(j)));
    }
    sphere.radius *= std::sqrt(longest);
    return sphere;
  });
  add_carried<double>(runner, "carried_sphere", "the book, double", [](const Case& c) {
    return contact::carried(c.sphere("sphere"), frame_of<double>(c));
  });
  add_carried<float>(runner, "carried_sphere", "the book, float", [](const Case& c) {
    return contact::carried(sphere_of<float>(c, "sphere"), frame_of<float>(c));
  });

  runner.question("carried_box", image_of_witness);
  add_carried<double>(runner, "carried_box", "lowest and highest corner", low_and_high<double>);
  add_carried<double>(runner, "carried_box", "extents without magnitudes",
                      [](const Case& c) { return centre_and_extents<double>(c, false); });
  add_carried<float>(runner, "carried_box", "extents, float",
                     [](const Case& c) { return centre_and_extents<float>(c, true); });
  add_carried<double>(runner, "carried_box", "extents, double",
                      [](const Case& c) { return centre_and_extents<double>(c, true); });
  add_carried<float>(runner, "carried_box", "eight corners, float", eight_corners<float>);
  add_carried<double>(runner, "carried_box", "eight corners, double", eight_corners<double>);
  add_carried<double>(runner, "carried_box", "the book, double", [](const Case& c) {
    return contact::aabb_of_carried(box_of<double>(c), frame_of<double>(c));
  });
  add_carried<float>(runner, "carried_box", "the book, float", [](const Case& c) {
    return contact::aabb_of_carried(box_of<float>(c), frame_of<float>(c));
  });
}

// ---------------------------------------------------------------- a motion that turns

/// A body in a box of its frame, which turns `turns` times by the whole quaternion `turn` while its
/// origin moves straight; right if the witness is in the box after `at` of the turns.
struct Motion {
  carried_truth::WholeQuaternion turn;
  Vector from, to;
  int turns, at;

  explicit Motion(const Case& c)
      : from(oracle::exact(c.vector("from"))),
        to(oracle::exact(c.vector("to"))),
        turns(int(c.number("turns"))),
        at(int(c.number("at"))) {
    const std::vector<double> q = c.numbers("turn");
    turn = {q.at(0), q.at(1), q.at(2), q.at(3)};
  }
  carried_truth::ExactMatrix rotation(int n) const {
    carried_truth::WholeQuaternion q;
    for (int i = 0; i < n; ++i) q = turn * q;
    return carried_truth::rotation_of(q);
  }
  Vector position(int n, const Vector& p) const {
    return Vector(from + Rational(n) / turns * (to - from)) + Vector(rotation(n) * p);
  }
  CoordinateFrame<double> frame(int n) const {
    return {oracle::nearest(n == 0 ? from : to), carried_truth::stored<double>(rotation(n))};
  }
};

inline void add_motions(hard_cases::Runner& runner) {
  runner.question("motion", [](const Case& c) -> Json {
    const Motion motion(c);
    const Vector witness = oracle::exact(c.vector("witness"));
    if (!carried_truth::inside(box_of<double>(c), witness)) {
      throw hard_cases::CorpusError(c.name() + ": the witness is not in the body");
    }
    const Vector p = motion.position(motion.at, witness);
    return {{"class", "a"}, {"position", hard_cases::hex(oracle::nearest(p))}};
  });
  const auto add = [&runner](const std::string& name, const auto& make) {
    runner.method("motion", name, [make](const Case& c, const Json&) {
      const Motion motion(c);
      const Vector p = motion.position(motion.at, oracle::exact(c.vector("witness")));
      return carried_truth::inside(make(c, motion), p);
    });
  };
  add("the start displaced", [](const Case& c, const Motion& motion) {
    const Aabb<double> start = contact::aabb_of_carried(box_of<double>(c), motion.frame(0));
    return contact::aabb_of_swept_box<double>(start,
                                              oracle::nearest(Vector(motion.to - motion.from)));
  });
  add("both ends", [](const Case& c, const Motion& motion) {
    return enclosing_box(contact::aabb_of_carried(box_of<double>(c), motion.frame(0)),
                         contact::aabb_of_carried(box_of<double>(c), motion.frame(motion.turns)));
  });
  add("both ends and the middle", [](const Case& c, const Motion& motion) {
    CoordinateFrame<double> middle = motion.frame(motion.turns / 2);
    middle.origin = oracle::nearest(Vector((motion.from + motion.to) / Rational(2)));
    const Aabb<double> ends =
        enclosing_box(contact::aabb_of_carried(box_of<double>(c), motion.frame(0)),
                      contact::aabb_of_carried(box_of<double>(c), motion.frame(motion.turns)));
    return enclosing_box(ends, contact::aabb_of_carried(box_of<double>(c), middle));
  });
  add("the book", [](const Case& c, const Motion& motion) {
    return contact::aabb_of_motion(box_of<double>(c), motion.frame(0), motion.frame(motion.turns));
  });
}

/// Adds them to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  add_meeting_spheres(runner);
  add_sphere_of_two(runner);
  add_carried_volumes(runner);
  add_motions(runner);
}

}  // namespace hard_moving
