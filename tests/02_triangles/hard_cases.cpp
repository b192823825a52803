// Recomputes the answers of hard_cases.json and checks which method is right in which case.
#include "support/hard_cases.hpp"

#include <02_triangles/truth.hpp>
#include <cmath>
#include <contact/barycentric.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>
#include <limits>
#include <optional>

#include "support/generators.hpp"

using hard_cases::Case;
using hard_cases::Json;

namespace {

using contact::Ray;
using contact::Segment;
using contact::Triangle;
using contact::TriangleHit;
using contact::Vector3;
using oracle::Rational;
using oracle::Vector;

// A case has a ray (origin, direction) or a segment (start, end), and a triangle (a, b, c). The
// fields stand side by side, so that a constructed case can give each as fractions.
bool is_segment(const Case& c) { return c.has("start"); }

Triangle<double> stored_triangle(const Case& c) {
  return {c.vector("a"), c.vector("b"), c.vector("c")};
}

Triangle<Rational> meant_triangle(const Case& c) {
  return {c.exact_vector("a"), c.exact_vector("b"), c.exact_vector("c")};
}

/// A number for the table: the fraction if it is short enough to read, else the nearest double.
Json readable(const Rational& x) {
  const std::string fraction = oracle::text(x);
  if (fraction.size() <= 24) return fraction;
  const double nearest = oracle::nearest(x);
  return std::isinf(nearest) ? Json("more than the largest double")
                             : Json(hard_cases::hex(nearest));
}

std::optional<truth::Hit> meant_hit(const Case& c) {
  const Vector start = c.exact_vector(is_segment(c) ? "start" : "origin");
  const Vector second = c.exact_vector(is_segment(c) ? "end" : "direction");
  return truth::meet<Rational>(start, is_segment(c) ? Vector(second - start) : second,
                               is_segment(c), meant_triangle(c));
}

/// Whether a method decides as the exact answer does, and keeps ten bits of t. A method that says
/// where the hit is and is wrong in the third digit is not right because it said yes.
bool right(const Case& c, const std::optional<TriangleHit<double>>& got) {
  const auto exact = meant_hit(c);
  if (got.has_value() != exact.has_value()) return false;
  if (!got) return true;
  if (std::isinf(got->t)) return exact->t > oracle::exact(std::numeric_limits<double>::max());
  return oracle::error(got->t, exact->t) <= std::max(Rational(1), exact->t) / 1024;
}

template <class S>
std::optional<TriangleHit<double>> widened(const std::optional<TriangleHit<S>>& hit) {
  if (!hit) return std::nullopt;
  return TriangleHit<double>{static_cast<double>(hit->t), hit->barycentric.template cast<double>()};
}

/// A method's answer, computed in the type in which the case is stored.
template <class S, class Method>
std::optional<TriangleHit<double>> answer_in(const Case& c, const Method& method) {
  const Triangle<S> triangle = generators::rounded<S>(stored_triangle(c));
  if (is_segment(c)) {
    const Segment<double> segment{c.vector("start"), c.vector("end")};
    return widened(method(generators::rounded<S>(segment), triangle));
  }
  const Ray<double> ray{c.vector("origin"), c.vector("direction")};
  return widened(method(generators::rounded<S>(ray), triangle));
}

template <class Method>
void add(hard_cases::Runner& runner, const char* name, Method method) {
  runner.method("ray_triangle", name, [method](const Case& c, const Json&) {
    return right(c,
                 c.type() == "float" ? answer_in<float>(c, method) : answer_in<double>(c, method));
  });
}

/// Barycentric weights with coordinate k dropped, and with β as the slide has it or as it should
/// be.
std::optional<Vector3<double>> weights_dropping(const Vector3<double>& point,
                                                const Triangle<double>& t, int k, bool slide_sign) {
  const auto x = contact::drop_dimension<double>(point - t.a, k);
  const auto e1 = contact::drop_dimension<double>(t.b - t.a, k);
  const auto e2 = contact::drop_dimension<double>(t.c - t.a, k);
  const double area = contact::cross2<double>(e1, e2);
  if (area == 0) return std::nullopt;
  const double alpha = contact::cross2<double>(x, e2) / area;
  const double beta =
      (slide_sign ? contact::cross2<double>(x, e1) : contact::cross2<double>(e1, x)) / area;
  return Vector3<double>(1 - alpha - beta, alpha, beta);
}

int smallest_dimension(const Vector3<double>& v) {
  int k = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(v[i]) < std::abs(v[k])) k = i;
  }
  return k;
}

Vector3<double> normal_of(const Triangle<double>& t) { return (t.b - t.a).cross(t.c - t.a); }

std::optional<Vector> meant_weights(const Case& c) {
  return contact::barycentric(c.exact_vector("point"), meant_triangle(c));
}

bool right_weights(const Case& c, const std::optional<Vector3<double>>& got) {
  const auto exact = meant_weights(c);
  if (got.has_value() != exact.has_value()) return false;
  return !got || oracle::error(*got, *exact) <= Rational(1) / 1024;
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("02_triangles");

  runner.question("ray_triangle", [](const Case& c) -> Json {
    const auto hit = meant_hit(c);
    Json answer{{"class", "a"}, {"hit", hit.has_value()}};
    if (hit) answer["t"] = readable(hit->t);
    return answer;
  });
  add(runner, "edge tests",
      [](const auto& line, const auto& t) { return contact::intersect_by_edges(line, t); });
  add(runner, "dropped dimension",
      [](const auto& line, const auto& t) { return contact::intersect_by_dropping(line, t); });
  add(runner, "Möller–Trumbore",
      [](const auto& line, const auto& t) { return contact::intersect_moller_trumbore(line, t); });
  add(runner, "watertight",
      [](const auto& line, const auto& t) { return contact::intersect_watertight(line, t); });
  add(runner, "exact",
      [](const auto& line, const auto& t) { return contact::intersect_exact(line, t); });

  runner.question("weights", [](const Case& c) -> Json {
    const auto weights = meant_weights(c);
    Json answer{{"class", "a"}, {"weights", nullptr}};
    if (weights)
      answer["weights"] = {readable(weights->x()), readable(weights->y()), readable(weights->z())};
    return answer;
  });
  runner.method("weights", "largest dropped", [](const Case& c, const Json&) {
    return right_weights(c, contact::barycentric(c.vector("point"), stored_triangle(c)));
  });
  runner.method("weights", "smallest dropped, as on the slide", [](const Case& c, const Json&) {
    const auto t = stored_triangle(c);
    return right_weights(
        c, weights_dropping(c.vector("point"), t, smallest_dimension(normal_of(t)), false));
  });
  runner.method("weights", "sign of β as on the slide", [](const Case& c, const Json&) {
    const auto t = stored_triangle(c);
    return right_weights(
        c, weights_dropping(c.vector("point"), t, contact::largest_dimension(normal_of(t)), true));
  });
  return runner.run(argc, argv);
}
