// The cost of a correct test of a sphere against the plane through three points.
#include <support/ladder.hpp>

#include <contact/plane.hpp>
#include <contact/sphere_plane.hpp>

#ifdef CONTACT_HAS_GMP
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/gmp.hpp>
#endif

namespace {

using contact::Plane;
using contact::Sphere;
using contact::Triangle;
using contact::Vector3;

/// One question in one type.
template <class S>
struct Asked {
  Triangle<S> points;
  Sphere<S> sphere;
  Plane<S> ready;  // for the method that reuses its plane
};

/// The numbers are floats, so that both types get the same input; the conversion is not timed.
struct Input {
  Asked<float> in_float;
  Asked<double> in_double;
};

template <class S>
Asked<S> asked(const Triangle<float>& points, const Sphere<float>& sphere) {
  const auto wide = [](const Vector3<float>& v) { return Vector3<S>(v.cast<S>()); };
  const Triangle<S> p{wide(points.a), wide(points.b), wide(points.c)};
  return {p, {wide(sphere.centre), S(sphere.radius)}, contact::plane_from_points(p.a, p.b, p.c)};
}

Input in_both_types(const Triangle<float>& points, const Sphere<float>& sphere) {
  return {asked<float>(points, sphere), asked<double>(points, sphere)};
}

Vector3<float> in_box(generators::Random& random, double size) {
  return generators::rounded<float>(Vector3<double>{
      random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)});
}

bool collinear(const Triangle<float>& t) {
  using contact::exact_vector;
  const auto raw =
      contact::raw_plane_from_points(exact_vector(t.a), exact_vector(t.b), exact_vector(t.c));
  return raw.normal == Vector3<contact::Exact>::Zero();
}

/// A random sphere near a triangle.
Input anywhere(generators::Random& random, const Vector3<float>& position, double size) {
  for (;;) {
    const Triangle<float> t{position + in_box(random, size), position + in_box(random, size),
                            position + in_box(random, size)};
    if (collinear(t)) continue;
    return in_both_types(
        t, {position + in_box(random, size), static_cast<float>(size * random.uniform())});
  }
}

/// The radius is the float nearest to the distance, plus or minus up to two ulps.
Input grazing(generators::Random& random) {
  for (;;) {
    const Triangle<float> t{in_box(random, 1), in_box(random, 1), in_box(random, 1)};
    if (collinear(t)) continue;
    const Vector3<float> centre = in_box(random, 1);
    const auto plane = asked<double>(t, {centre, 0}).ready;
    const double distance =
        std::abs(contact::signed_distance(plane, Vector3<double>(centre.cast<double>())));
    auto radius = static_cast<float>(distance);
    for (int steps = random.integer(-2, 2); steps != 0; steps += steps > 0 ? -1 : 1) {
      radius = std::nextafter(radius, steps > 0 ? 4.0f : 0.0f);
    }
    return in_both_types(t, {centre, radius});
  }
}

/// Whole numbers, and normals of whole-number length such as (1, 2, 2): the sphere touches exactly.
Input exact_touch(generators::Random& random) {
  static constexpr std::array<std::array<int, 4>, 4> quadruples{
      {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {2, 6, 9, 11}}};
  const auto& [x, y, z, length] = quadruples[static_cast<std::size_t>(random.integer(0, 3))];
  const auto whole = [&random] { return static_cast<float>(random.integer(-20, 20)); };
  const Vector3<float> a{whole(), whole(), whole()};
  // Two edges perpendicular to the normal (x, y, z).
  const Triangle<float> t{a, a + Vector3<float>(float(y), float(-x), 0),
                          a + Vector3<float>(float(z), 0, float(-x))};
  const int radius = random.integer(1, 9);
  // From the vertex along the plane, then up by the radius: (x, y, z) · (r / length) is whole if r
  // is a multiple of it.
  const int times = random.chance(0.5) ? radius : -radius;
  const Vector3<float> centre = t.b + float(times) * Vector3<float>(float(x), float(y), float(z));
  return in_both_types(t, {centre, float(radius * length)});
}

/// A step of a metre some kilometres out; the radius differs from the distance by one part in 2^8
/// to 2^14.
Input far_away(generators::Random& random) {
  const Vector3<float> position = generators::rounded<float>(
      Vector3<double>{random.magnitude(8, 12), random.magnitude(8, 12), random.magnitude(8, 12)});
  Input input = anywhere(random, position, 1);
  const Asked<double>& q = input.in_double;
  const double distance =
      std::abs(contact::signed_distance_from_point(q.ready.normal, q.points.a, q.sphere.centre));
  const auto radius = static_cast<float>(distance * (1 + random.magnitude(-14, -8)));
  input.in_float.sphere.radius = radius;
  input.in_double.sphere.radius = static_cast<double>(radius);
  return input;
}

/// One scene in units of a nanometre or so written in metres: 2^-40 to 2^-28.
Input small(generators::Random& random) {
  return anywhere(random, Vector3<float>::Zero(), std::ldexp(1.0, random.integer(-40, -28)));
}

template <class S>
bool unnormalised(const Asked<S>& q) {
  const auto raw = contact::raw_plane_from_points(q.points.a, q.points.b, q.points.c);
  return std::abs(raw.normal.dot(q.sphere.centre) - raw.offset) <= q.sphere.radius;
}

template <class S>
bool written_first(const Asked<S>& q) {
  const auto raw = contact::raw_plane_from_points(q.points.a, q.points.b, q.points.c);
  const Vector3<S> normal = raw.normal / std::sqrt(raw.normal.dot(raw.normal));
  return std::abs(normal.dot(q.sphere.centre) - normal.dot(q.points.a)) <= q.sphere.radius;
}

template <class S>
bool squared(const Asked<S>& q) {
  return contact::sphere_meets_plane(
      q.sphere, contact::raw_plane_from_points(q.points.a, q.points.b, q.points.c));
}

template <class S>
bool unit_plane(const Asked<S>& q) {
  return contact::sphere_meets_plane(
      q.sphere, contact::plane_from_points(q.points.a, q.points.b, q.points.c));
}

template <class S>
bool kept_plane(const Asked<S>& q) {
  return contact::sphere_meets_plane(q.sphere, q.ready);
}

bool unfiltered(const Asked<double>& q) {
  using contact::exact_vector;
  const Sphere<contact::Exact> sphere{exact_vector(q.sphere.centre),
                                      contact::Exact(q.sphere.radius)};
  return contact::sphere_meets_plane(
      sphere, contact::raw_plane_from_points(exact_vector(q.points.a), exact_vector(q.points.b),
                                             exact_vector(q.points.c)));
}

#ifdef CONTACT_HAS_GMP
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

bool by_rationals(const Asked<double>& q) {
  const auto rational = [](const Vector3<double>& v) {
    return Vector3<Rational>(Rational(v.x()), Rational(v.y()), Rational(v.z()));
  };
  const Sphere<Rational> sphere{rational(q.sphere.centre), Rational(q.sphere.radius)};
  return contact::sphere_meets_plane(
      sphere, contact::raw_plane_from_points(rational(q.points.a), rational(q.points.b),
                                             rational(q.points.c)));
}
#endif

/// The plane and the sphere, drawn smaller by a power of two if they are large.
template <class S>
ladder::Example shown(const Asked<S>& q, int got, int right) {
  const auto verdict = [](int meets) { return meets != 0 ? "they meet" : "they do not meet"; };
  ladder::Example example;
  example.facts = {ladder::numbers("a", q.points.a),
                   ladder::numbers("b", q.points.b),
                   ladder::numbers("c", q.points.c),
                   ladder::numbers("centre", q.sphere.centre),
                   ladder::number("radius", q.sphere.radius),
                   {"this method", verdict(got)},
                   {"exact", verdict(right)}};
  const auto wide = [](const Vector3<S>& v) { return Vector3<double>(v.template cast<double>()); };
  const Vector3<double> a = wide(q.points.a);
  Vector3<double> normal = (wide(q.points.b) - a).cross(wide(q.points.c) - a);
  const double size = std::max({a.cwiseAbs().maxCoeff(), wide(q.points.b).cwiseAbs().maxCoeff(),
                                wide(q.points.c).cwiseAbs().maxCoeff(),
                                wide(q.sphere.centre).cwiseAbs().maxCoeff()});
  const double largest = normal.cwiseAbs().maxCoeff();
  if (size > 200) {
    example.note = "This is some kilometres from the origin, outside the figure.";
  } else if (size < 0x1p-10 || !(largest > 0)) {
    example.note = "This is too small for the figure, and enlarged it would not underflow.";
  } else {
    const double scale = size > 4 ? 0x1p-5 : 1;
    normal *= std::ldexp(1.0, -std::ilogb(largest));
    example.figure = "moving_sphere";
    example.fields = {ladder::field("normal", normal),
                      ladder::field("point", Vector3<double>(a * scale)),
                      ladder::field("centre", Vector3<double>(wide(q.sphere.centre) * scale)),
                      {"radius", {static_cast<double>(q.sphere.radius) * scale}},
                      {"displacement", {0, 0, 0}}};
    example.note = "The figure gets the plane by its normal, rounded to double.";
    if (scale < 1) example.note += " All lengths are divided by 32.";
  }
  return example;
}

ladder::Ladder<Input, int> experiment() {
  const auto truth = [](const Input& input) { return int(unfiltered(input.in_double)); };
  const auto judge = [](const int& got, const int& right) {
    ladder::Verdict verdict;
    verdict.wrong = got != right;
    return verdict;
  };
  ladder::Ladder<Input, int> ladder("Does the sphere meet the plane through three points?", truth,
                                    judge);

  ladder.family("random", "random", [](generators::Random& random) {
    return anywhere(random, Vector3<float>::Zero(), 1);
  });
  ladder.family("grazing", "grazing", grazing);
  ladder.family("exact-touch", "whole numbers, exactly touching", exact_touch);
  ladder.family("far", "far from the origin", far_away);
  ladder.family("small", "very small", small);

  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(
        {.id = std::string(id) + "-float", .title = title, .scalar = "float", .exact = false},
        [method](const Input& input) { return int(method(input.in_float)); });
    ladder.method(
        {.id = std::string(id) + "-double", .title = title, .scalar = "double", .exact = false},
        [method](const Input& input) { return int(method(input.in_double)); });
  };
  in_both("unnormalised", "normal not normalised", [](const auto& q) { return unnormalised(q); });
  in_both("first", "as first written", [](const auto& q) { return written_first(q); });
  in_both("squared", "squared, no root", [](const auto& q) { return squared(q); });
  in_both("unit", "the book's unit plane", [](const auto& q) { return unit_plane(q); });
  in_both("kept", "the same, plane made beforehand", [](const auto& q) { return kept_plane(q); });

  const auto exact = [&ladder](const char* id, const char* title, const char* scalar, auto method) {
    ladder.method({.id = id, .title = title, .scalar = scalar, .exact = true},
                  [method](const Input& input) { return int(method(input.in_double)); });
  };
  exact("exact", "exact, filtered", "double, then exact", [](const Asked<double>& q) {
    return contact::sphere_meets_plane_exactly(q.sphere, q.points.a, q.points.b, q.points.c);
  });
  exact("exact-unfiltered", "exact, no filter", "exact", unfiltered);
#ifdef CONTACT_HAS_GMP
  exact("rational", "squared, rational numbers (GMP)", "rational", by_rationals);
#endif
  ladder.recommend("exact");
  ladder.show(
      [](const Input& input, const int& got, const int& right, const ladder::Method& method) {
        return method.scalar == "float" ? shown(input.in_float, got, right)
                                        : shown(input.in_double, got, right);
      });
  return ladder;
}

}  // namespace

LADDER(experiment)
