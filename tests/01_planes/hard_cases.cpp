// Recomputes the answers of hard_cases.json and checks which method is right in which case.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/moving_sphere_plane.hpp>
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>
#include <contact/sphere_plane.hpp>

#include "support/generators.hpp"
#include "support/oracle_planes.hpp"

using hard_cases::Case;
using hard_cases::Json;

namespace {

using Vector = contact::Vector3<double>;
using Points = contact::Triangle<double>;

/// The plane as one would first write it: cross product, divide by the root of the sum of squares,
/// offset by a dot product.
template <class S>
contact::Plane<S> naive_plane(const contact::Triangle<S>& p) {
  const contact::Vector3<S> ab = p.b - p.a;
  const contact::Vector3<S> ac = p.c - p.a;
  const contact::Vector3<S> cross = ab.cross(ac);
  const contact::Vector3<S> normal = cross / std::sqrt(cross.dot(cross));
  return {normal, normal.dot(p.a)};
}

oracle::ExactPlane exact_plane(const Points& p) {
  return oracle::plane_through(oracle::exact(p.a), oracle::exact(p.b), oracle::exact(p.c));
}

int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : x == 0 ? 0 : 99;
}  // 99: NaN is not an answer

/// The largest relative error of a right number: 2^-40, far more than the rounding errors of a
/// sound method.
bool close(double got, double right) {
  return std::abs(got - right) <= std::ldexp(std::abs(right), -40);
}

Json hit(const std::optional<oracle::Surd>& t) {
  Json answer{{"class", "b"}, {"hit", t.has_value()}};
  if (t) answer["t"] = hard_cases::hex(oracle::nearest(*t));
  return answer;
}

/// Whether a method's hit and time agree with the answer. The time as decimal text is read back to
/// the same double.
bool same_hit(const std::optional<double>& got, const Json& answer) {
  if (got.has_value() != answer.at("hit").get<bool>()) return false;
  return !got || close(*got, std::strtod(answer.at("t").get<std::string>().c_str(), nullptr));
}

/// As in the lecture: reject if both ends are strictly above or strictly below, then divide.
template <class S>
std::optional<double> lecture_segment(const contact::Segment<S>& s,
                                      const contact::Plane<S>& plane) {
  const S start = plane.normal.dot(s.start) - plane.offset;
  const S end = plane.normal.dot(s.end) - plane.offset;
  if ((start > S(0) && end > S(0)) || (start < S(0) && end < S(0))) return std::nullopt;
  return static_cast<double>(start / (start - end));
}

/// As in the lecture: the plane is moved along its own normal whichever side the sphere is on, and
/// the time is the distance to the collision point over the distance of the whole step.
std::optional<double> lecture_moving_sphere(const contact::Sphere<double>& sphere,
                                            const Vector& way, contact::Plane<double> plane) {
  plane.offset += sphere.radius;
  const double t = (plane.offset - plane.normal.dot(sphere.centre)) / plane.normal.dot(way);
  if (t < 0 || t > 1) return std::nullopt;
  const Vector to_hit = t * way;
  return std::sqrt(to_hit.dot(to_hit)) / std::sqrt(way.dot(way));
}

void add_normalise(hard_cases::Runner& runner) {
  runner.question("normalise", [](const Case& c) {
    const auto unit = oracle::unit_normal({oracle::exact(c.vector("v")), 0});
    return Json{{"class", "b"},
                {"unit", Json::array({hard_cases::hex(oracle::nearest(unit[0])),
                                      hard_cases::hex(oracle::nearest(unit[1])),
                                      hard_cases::hex(oracle::nearest(unit[2]))})}};
  });
  const auto judge = [](const Vector& got, const Json& answer) {
    for (int i = 0; i < 3; ++i) {
      const auto text = answer.at("unit")[static_cast<std::size_t>(i)].get<std::string>();
      if (!close(got(i), std::strtod(text.c_str(), nullptr))) return false;
    }
    return true;
  };
  runner.method("normalise", "double, as first written",
                [judge](const Case& c, const Json& answer) {
                  const Vector v = c.vector("v");
                  return judge(v / std::sqrt(v.dot(v)), answer);
                });
  runner.method("normalise", "book, unit plane", [judge](const Case& c, const Json& answer) {
    return judge(contact::normalised(c.vector("v")), answer);
  });
}

void add_side(hard_cases::Runner& runner) {
  runner.question("side", [](const Case& c) {
    const auto plane = exact_plane(c.triangle("plane"));
    return Json{{"class", "a"}, {"side", oracle::side(plane, oracle::exact(c.vector("x")))}};
  });
  runner.method("side", "float", [](const Case& c, const Json& answer) {
    const auto plane = naive_plane(generators::rounded<float>(c.triangle("plane")));
    const auto x = generators::rounded<float>(c.vector("x"));
    return sign_of(static_cast<double>(plane.normal.dot(x) - plane.offset)) ==
           answer.at("side").get<int>();
  });
  runner.method("side", "double, as first written", [](const Case& c, const Json& answer) {
    const auto plane = naive_plane(c.triangle("plane"));
    return sign_of(plane.normal.dot(c.vector("x")) - plane.offset) == answer.at("side").get<int>();
  });
  runner.method("side", "book, unit plane", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    const auto plane = contact::plane_from_points(p.a, p.b, p.c);
    return static_cast<int>(contact::side(plane, c.vector("x"))) == answer.at("side").get<int>();
  });
  runner.method("side", "book, difference first", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    const auto plane = contact::plane_from_points(p.a, p.b, p.c);
    return sign_of(contact::signed_distance_from_point(plane.normal, p.a, c.vector("x"))) ==
           answer.at("side").get<int>();
  });
  runner.method("side", "book, exact", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    return static_cast<int>(contact::side_of_points_exactly(p.a, p.b, p.c, c.vector("x"))) ==
           answer.at("side").get<int>();
  });
}

void add_exists(hard_cases::Runner& runner) {
  runner.question("plane_from_points", [](const Case& c) {
    return Json{{"class", "a"}, {"plane", exact_plane(c.triangle("plane")).exists()}};
  });
  // Right only if the normal is right too: a normal of rounding noise is not a plane found.
  const auto good_normal = [](const Case& c, const auto& plane, double tolerance) {
    const auto unit = oracle::unit_normal(exact_plane(c.triangle("plane")));
    for (int i = 0; i < 3; ++i) {
      const auto& right = unit[static_cast<std::size_t>(i)];
      if (!(oracle::error(static_cast<double>(plane.normal(i)), right) < tolerance)) return false;
    }
    return true;
  };
  runner.method("plane_from_points", "float", [good_normal](const Case& c, const Json& answer) {
    const auto plane = naive_plane(generators::rounded<float>(c.triangle("plane")));
    const bool found = contact::all_finite(plane.normal);
    return found == answer.at("plane").get<bool>() && (!found || good_normal(c, plane, 1e-3));
  });
  runner.method("plane_from_points", "double, as first written",
                [good_normal](const Case& c, const Json& answer) {
                  const auto plane = naive_plane(c.triangle("plane"));
                  const bool found = contact::all_finite(plane.normal);
                  return found == answer.at("plane").get<bool>() &&
                         (!found || good_normal(c, plane, 1e-9));
                });
  runner.method("plane_from_points", "book, unit plane",
                [good_normal](const Case& c, const Json& answer) {
                  const Points p = c.triangle("plane");
                  try {
                    return good_normal(c, contact::plane_from_points(p.a, p.b, p.c), 1e-9) &&
                           answer.at("plane").get<bool>();
                  } catch (const std::invalid_argument&) {
                    return !answer.at("plane").get<bool>();
                  }
                });
}

void add_segment(hard_cases::Runner& runner) {
  runner.question("segment_plane", [](const Case& c) {
    const auto crossing =
        oracle::crossing(oracle::exact(c.segment("segment")), exact_plane(c.triangle("plane")));
    Json answer{{"class", "a"}, {"hit", crossing.has_value()}};
    if (crossing) answer["t"] = hard_cases::hex(oracle::nearest(crossing->t));
    return answer;
  });
  runner.method("segment_plane", "as in the lecture", [](const Case& c, const Json& answer) {
    return same_hit(lecture_segment(c.segment("segment"), naive_plane(c.triangle("plane"))),
                    answer);
  });
  runner.method("segment_plane", "book, unit plane", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    const auto got =
        contact::segment_plane(c.segment("segment"), contact::plane_from_points(p.a, p.b, p.c));
    return same_hit(got ? std::optional(got->t) : std::nullopt, answer);
  });
  runner.method("segment_plane", "book, exact", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    const auto raw = contact::raw_plane_from_points<oracle::Rational>(
        oracle::exact(p.a), oracle::exact(p.b), oracle::exact(p.c));
    const auto got = contact::segment_plane<oracle::Rational>(oracle::exact(c.segment("segment")),
                                                              {raw.normal, raw.offset});
    return same_hit(got ? std::optional(oracle::nearest(got->t)) : std::nullopt, answer);
  });
}

void add_sphere(hard_cases::Runner& runner) {
  runner.question("sphere_plane", [](const Case& c) {
    return Json{{"class", "a"},
                {"meets", oracle::meets(oracle::exact(c.sphere("sphere")),
                                        exact_plane(c.triangle("plane")))}};
  });
  runner.method("sphere_plane", "as in the lecture", [](const Case& c, const Json& answer) {
    const auto plane = naive_plane(c.triangle("plane"));
    const auto sphere = c.sphere("sphere");
    return (std::abs(plane.normal.dot(sphere.centre) - plane.offset) < sphere.radius) ==
           answer.at("meets").get<bool>();
  });
  runner.method("sphere_plane", "double, squared form", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    return contact::sphere_meets_plane(c.sphere("sphere"),
                                       contact::raw_plane_from_points(p.a, p.b, p.c)) ==
           answer.at("meets").get<bool>();
  });
  runner.method("sphere_plane", "book, unit plane", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    return contact::sphere_meets_plane(c.sphere("sphere"),
                                       contact::plane_from_points(p.a, p.b, p.c)) ==
           answer.at("meets").get<bool>();
  });
  runner.method("sphere_plane", "book, exact", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    return contact::sphere_meets_plane_exactly(c.sphere("sphere"), p.a, p.b, p.c) ==
           answer.at("meets").get<bool>();
  });
}

void add_moving_sphere(hard_cases::Runner& runner) {
  runner.question("moving_sphere_plane", [](const Case& c) {
    return hit(oracle::first_touch(oracle::exact(c.sphere("sphere")),
                                   oracle::exact(c.vector("displacement")),
                                   exact_plane(c.triangle("plane"))));
  });
  runner.method(
      "moving_sphere_plane", "only where the step ends", [](const Case& c, const Json& answer) {
        auto sphere = c.sphere("sphere");
        sphere.centre += c.vector("displacement");
        const bool meets = contact::sphere_meets_plane(sphere, naive_plane(c.triangle("plane")));
        return same_hit(meets ? std::optional(1.0) : std::nullopt, answer);
      });
  runner.method("moving_sphere_plane", "as in the lecture", [](const Case& c, const Json& answer) {
    return same_hit(lecture_moving_sphere(c.sphere("sphere"), c.vector("displacement"),
                                          naive_plane(c.triangle("plane"))),
                    answer);
  });
  runner.method("moving_sphere_plane", "book, unit plane", [](const Case& c, const Json& answer) {
    const Points p = c.triangle("plane");
    const auto got = contact::moving_sphere_plane(c.sphere("sphere"), c.vector("displacement"),
                                                  contact::plane_from_points(p.a, p.b, p.c));
    return same_hit(got ? std::optional(got->t) : std::nullopt, answer);
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("01_planes");
  add_side(runner);
  add_exists(runner);
  add_normalise(runner);
  add_segment(runner);
  add_sphere(runner);
  add_moving_sphere(runner);
  return runner.run(argc, argv);
}
