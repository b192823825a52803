/// @file
/// The hard cases of spheres: whether one contains a point, the radius that encloses points or
/// spheres, and the smallest sphere.
#pragma once

#include <07_bounding_volumes/hard_common.hpp>
#include <07_bounding_volumes/sphere_truth.hpp>
#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <contact/enclosing_radius.hpp>
#include <contact/grown_sphere.hpp>
#include <contact/smallest_sphere.hpp>
#include <contact/welzl_sphere.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <support/generators.hpp>
#include <support/hard_cases.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace hard_spheres {

using contact::Sphere;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_common::applies;
using hard_common::Points;
using hard_common::points_of;
using hard_common::span_of;
using oracle::Rational;

// ---------------------------------------------------------------- a point in a sphere

template <std::floating_point S>
Sphere<S> sphere_of(const Case& c) {
  return generators::rounded<S>(c.sphere("sphere"));
}
template <std::floating_point S>
S squared(const Vector3<S>& v) {
  return v.dot(v);
}
template <std::floating_point S>
bool by_root(const Sphere<S>& sphere, const Vector3<S>& p) {
  return std::sqrt(squared<S>(p - sphere.centre)) <= sphere.radius;
}
template <std::floating_point S>
bool by_squares(const Sphere<S>& sphere, const Vector3<S>& p) {
  return squared<S>(p - sphere.centre) <= sphere.radius * sphere.radius;
}
/// p·p − 2 p·c + c·c, of which p·p and c·c can be computed beforehand.
inline bool expanded(const Sphere<double>& sphere, const Vector3<double>& p) {
  return squared(p) - 2 * p.dot(sphere.centre) + squared(sphere.centre) <=
         sphere.radius * sphere.radius;
}

template <std::floating_point S, class Inside>
void add_containment(hard_cases::Runner& runner, const std::string& name, const Inside& inside) {
  runner.method("in_sphere", name, applies<S>, [inside](const Case& c, const Json& answer) {
    return inside(sphere_of<S>(c), generators::rounded<S>(c.vector("point"))) ==
           answer.at("inside").get<bool>();
  });
}
inline void add_containment_question(hard_cases::Runner& runner) {
  using D = Sphere<double>;
  using P = Vector3<double>;
  runner.question("in_sphere", [](const Case& c) -> Json {
    const auto sphere = oracle::exact(c.sphere("sphere"));
    const auto d = sphere_truth::distance_squared(oracle::exact(c.vector("point")), sphere.centre);
    return {{"class", "a"}, {"inside", bool(d <= sphere.radius * sphere.radius)}};
  });
  add_containment<float>(runner, "root, float", by_root<float>);
  add_containment<double>(runner, "root, double", by_root<double>);
  add_containment<float>(runner, "squares, float", by_squares<float>);
  add_containment<double>(runner, "squares, double", by_squares<double>);
  add_containment<double>(runner, "expanded square, double", expanded);
  add_containment<double>(runner, "within 1e-9, double", [](const D& sphere, const P& p) {
    return std::sqrt(squared<double>(p - sphere.centre)) <= sphere.radius + 1e-9;
  });
  add_containment<double>(runner, "touching rejected, double", [](const D& sphere, const P& p) {
    return squared<double>(p - sphere.centre) < sphere.radius * sphere.radius;
  });
  runner.method("in_sphere", "the book, exact", [](const Case& c, const Json& answer) {
    const bool inside = answer.at("inside").get<bool>();
    return contact::contains(sphere_of<double>(c), c.vector("point")) == inside &&
           (c.type() == "double" ||
            contact::contains(sphere_of<float>(c), generators::rounded<float>(c.vector("point"))) ==
                inside);
  });
}

// ---------------------------------------------------------------- the radius that encloses

/// A field with four numbers for each sphere: its centre and its radius.
template <std::floating_point S>
std::vector<Sphere<S>> spheres_of(const Case& c) {
  const std::vector<double> x = c.numbers("spheres");
  std::vector<Sphere<S>> spheres;
  for (std::size_t i = 0; i + 3 < x.size(); i += 4) {
    const Sphere<double> sphere{Vector3<double>(x[i], x[i + 1], x[i + 2]), x[i + 3]};
    spheres.push_back(generators::rounded<S>(sphere));
  }
  return spheres;
}
/// Whether a radius encloses all spheres about a centre.
inline bool encloses(const Vector3<double>& centre, double radius,
                     const std::vector<Sphere<double>>& spheres) {
  if (!std::isfinite(radius)) return false;
  for (const auto& sphere : spheres) {
    const Rational room = oracle::exact(radius) - oracle::exact(sphere.radius);
    const Rational d =
        sphere_truth::distance_squared(oracle::exact(sphere.centre), oracle::exact(centre));
    if (room < 0 || d > room * room) return false;
  }
  return true;
}
/// The largest of what a function makes of the distance and the radius of each sphere.
template <std::floating_point S, class Combine>
S largest(const Case& c, const Combine& combine) {
  const Vector3<S> centre = generators::rounded<S>(c.vector("centre"));
  S result = S(0);
  for (const Sphere<S>& sphere : spheres_of<S>(c)) {
    const S distance = std::sqrt(squared<S>(sphere.centre - centre));
    result = std::max(result, combine(distance, sphere.radius));
  }
  return result;
}
template <std::floating_point S>
S enclosing(const Case& c) {
  const std::vector<Sphere<S>> spheres = spheres_of<S>(c);
  return contact::enclosing_radius(generators::rounded<S>(c.vector("centre")),
                                   std::span<const Sphere<S>>(spheres));
}

/// A method is right if its radius encloses all, and is at most a millionth larger than needed.
template <std::floating_point S, class Radius>
void add_radius(hard_cases::Runner& runner, const std::string& name, const Radius& radius) {
  runner.method("enclosing_radius", name, applies<S>, [radius](const Case& c, const Json& answer) {
    const double r = static_cast<double>(radius(c));
    return encloses(c.vector("centre"), r, spheres_of<double>(c)) &&
           r <= hard_cases::unhex(answer, "radius") * (1 + 1e-6);
  });
}
inline void add_radius_question(hard_cases::Runner& runner) {
  runner.question("enclosing_radius", [](const Case& c) -> Json {
    // Bisection in the bit patterns of positive doubles, whose order is that of the numbers.
    const auto centre = c.vector("centre");
    const auto spheres = spheres_of<double>(c);
    auto low = std::uint64_t{0}, high = std::bit_cast<std::uint64_t>(HUGE_VAL);
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      const bool enough = encloses(centre, std::bit_cast<double>(middle), spheres);
      (enough ? high : low) = enough ? middle : middle + 1;
    }
    const double radius = std::bit_cast<double>(low);
    return {{"class", "a"}, {"radius", hard_cases::hex(radius)}};
  });
  const auto add = [](auto d, auto r) { return d + r; };
  add_radius<float>(runner, "distance and radius, float",
                    [add](const Case& c) { return largest<float>(c, add); });
  add_radius<double>(runner, "distance and radius, double",
                     [add](const Case& c) { return largest<double>(c, add); });
  add_radius<double>(runner, "root of the sum of squares, double", [](const Case& c) {
    return largest<double>(c, [](double d, double r) { return std::sqrt(d * d + r * r); });
  });
  add_radius<double>(runner, "centres alone, double", [](const Case& c) {
    return largest<double>(c, [](double d, double) { return d; });
  });
  runner.method("enclosing_radius", "the book, exact", [](const Case& c, const Json& answer) {
    if (enclosing<double>(c) != hard_cases::unhex(answer, "radius")) return false;
    if (c.type() == "double") return true;
    const float r = enclosing<float>(c);
    const auto centre = c.vector("centre");
    return encloses(centre, static_cast<double>(r), spheres_of<double>(c)) &&
           (r == 0 ||
            !encloses(centre, static_cast<double>(std::nextafter(r, 0.0F)), spheres_of<double>(c)));
  });
}

// ---------------------------------------------------------------- the smallest sphere as often
// written

template <class S>
Sphere<S> about(const Vector3<S>& centre, const Points<S>& points) {
  return {centre, contact::enclosing_radius(centre, span_of(points))};
}
/// The centre of the box and its longest half edge.
inline Sphere<double> half_the_box(const Points<double>& points) {
  const auto box = contact::aabb_of_points(span_of(points));
  const Vector3<double> half = (box.high - box.low) / 2;
  return {box.low + half, half.maxCoeff()};
}
/// The sphere that has all points on its surface; of up to four.
inline Sphere<double> circumscribed(const Points<double>& points) {
  contact::sphere_detail::Boundary<double> all;
  for (const auto& p : points) all.points[all.count++] = p;
  return contact::sphere_detail::sphere_through(all);
}
/// The sphere whose diameter is the longest distance of two points.
inline Sphere<double> of_farthest_pair(const Points<double>& points) {
  Sphere<double> best{points[0], 0};
  for (const auto& p : points) {
    for (const auto& q : points) {
      const double radius = std::sqrt(squared<double>(q - p)) / 2;
      if (radius > best.radius) best = {p + (q - p) / 2, radius};
    }
  }
  return best;
}
/// Every sphere of two, three or four points that contains the others within a share of its
/// radius; the smallest.
inline Sphere<double> of_every_support(const Points<double>& points, double share) {
  Sphere<double> best{points[0], points.size() == 1 ? 0 : HUGE_VAL};
  contact::sphere_detail::Boundary<double> chosen;
  const auto choose = [&](const auto& self, std::size_t from) -> void {
    for (std::size_t i = from; i < points.size(); ++i) {
      chosen.points[chosen.count++] = points[i];
      const auto sphere = contact::sphere_detail::sphere_through(chosen);
      const bool all_inside = std::all_of(points.begin(), points.end(), [&](const auto& p) {
        return std::sqrt(squared<double>(p - sphere.centre)) <= sphere.radius * (1 + share);
      });
      if (all_inside && sphere.radius < best.radius) best = sphere;
      if (chosen.count < 4) self(self, i + 1);
      --chosen.count;
    }
  };
  choose(choose, 0);
  return best;
}
/// Points added one by one: where one is outside by more than a share of the radius, the sphere of
/// two, three and four points is searched again among those before it.
inline Sphere<double> one_by_one(const Points<double>& points, double share) {
  using contact::sphere_detail::Boundary;
  const auto search = [&](const auto& self, std::size_t end,
                          const Boundary<double>& boundary) -> Sphere<double> {
    Sphere<double> sphere = contact::sphere_detail::sphere_through(boundary);
    if (boundary.count == 4) return sphere;
    for (std::size_t i = 0; i < end; ++i) {
      const double distance = std::sqrt(squared<double>(points[i] - sphere.centre));
      if (distance <= sphere.radius * (1 + share)) continue;
      Boundary<double> with_point = boundary;
      with_point.points[with_point.count++] = points[i];
      sphere = self(self, i, with_point);
    }
    return sphere;
  };
  return search(search, points.size(), {});
}

/// Right if it encloses all, and its radius is the smallest to a part in 10⁹ (of float, in 10⁵), or
/// as small as the nearest centre that can be stored allows.
template <std::floating_point S>
bool is_nearly_smallest(const Points<double>& points, const Sphere<S>& sphere, const Json& answer) {
  if (!sphere.centre.allFinite() || !std::isfinite(sphere.radius)) return false;
  const Rational r = oracle::exact(sphere.radius);
  const auto all = sphere_truth::exact(points);
  if (sphere_truth::largest_distance_squared(all, oracle::exact(sphere.centre)) > r * r) {
    return false;
  }
  oracle::Vector stored;
  for (int k = 0; k < 3; ++k) {
    const double exact = hard_cases::unhex(answer.at("centre").at(static_cast<std::size_t>(k)));
    stored[k] = oracle::exact(static_cast<S>(exact));
  }
  const Rational smallest = std::max(oracle::exact(hard_cases::unhex(answer, "radius_squared")),
                                     sphere_truth::largest_distance_squared(all, stored));
  const Rational room(2, std::same_as<S, float> ? 100000 : 1000000000);
  return r * r <= smallest * (1 + room);
}

template <std::floating_point S, class Make>
void add_sphere(hard_cases::Runner& runner, const std::string& name, const Make& make) {
  runner.method("smallest_sphere", name, applies<S>, [make](const Case& c, const Json& answer) {
    return is_nearly_smallest<S>(points_of<double>(c), make(points_of<S>(c)), answer);
  });
}
template <std::floating_point S>
bool book_is_right(const Case& c, const Json& answer) {
  const Points<S> points = points_of<S>(c);
  const auto found = contact::smallest_sphere(span_of(points));
  const auto count = static_cast<std::size_t>(found.support_count);
  const auto ball = sphere_truth::certified(sphere_truth::exact(points),
                                            std::span<const int>(found.support.data(), count));
  return ball && is_nearly_smallest(points_of<double>(c), found.sphere, answer) &&
         found.radius_squared == hard_cases::unhex(answer, "radius_squared");
}
inline void add_smallest_methods(hard_cases::Runner& runner) {
  using D = Points<double>;
  using F = Points<float>;
  add_sphere<float>(runner, "the lecture's, float",
                    [](const F& p) { return contact::sphere_grown_as_given(span_of(p)); });
  add_sphere<double>(runner, "the lecture's, double",
                     [](const D& p) { return contact::sphere_grown_as_given(span_of(p)); });
  add_sphere<double>(runner, "the lecture's, radius enclosing",
                     [](const D& p) { return contact::grown_sphere(span_of(p)); });
  add_sphere<double>(runner, "about the mean, radius enclosing",
                     [](const D& p) { return contact::centroid_sphere(span_of(p)); });
  add_sphere<double>(runner, "about the box's centre, radius enclosing",
                     [](const D& p) { return contact::box_centre_sphere(span_of(p)); });
  add_sphere<double>(runner, "about the origin, radius enclosing",
                     [](const D& p) { return about<double>(Vector3<double>::Zero(), p); });
  add_sphere<double>(runner, "half the box, double", half_the_box);
  add_sphere<double>(runner, "farthest pair, double", of_farthest_pair);
  runner.method(
      "smallest_sphere", "through all points, double",
      [](const Case& c) { return points_of<double>(c).size() <= 4; },
      [](const Case& c, const Json& answer) {
        const D points = points_of<double>(c);
        return is_nearly_smallest(points, about(circumscribed(points).centre, points), answer);
      });
  add_sphere<float>(runner, "Welzl, float",
                    [](const F& p) { return contact::welzl_sphere(span_of(p)); });
  add_sphere<double>(runner, "Welzl, double",
                     [](const D& p) { return contact::welzl_sphere(span_of(p)); });
  add_sphere<double>(runner, "Welzl, radius enclosing",
                     [](const D& p) { return about(contact::welzl_sphere(span_of(p)).centre, p); });
  add_sphere<double>(runner, "one by one within 1e-14, radius enclosing",
                     [](const D& p) { return about(one_by_one(p, 1e-14).centre, p); });
  add_sphere<double>(runner, "every support within 1e-9, radius enclosing",
                     [](const D& p) { return about(of_every_support(p, 1e-9).centre, p); });
  runner.method("smallest_sphere", "the book, exact", [](const Case& c, const Json& answer) {
    return book_is_right<double>(c, answer) &&
           (c.type() == "double" || book_is_right<float>(c, answer));
  });
}

/// Adds them to a runner; the question of the smallest sphere itself is in hard_common.hpp.
inline void add_questions(hard_cases::Runner& runner) {
  add_containment_question(runner);
  add_radius_question(runner);
  add_smallest_methods(runner);
}

}  // namespace hard_spheres
