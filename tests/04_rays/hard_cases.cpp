// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
#include <02_triangles/truth.hpp>
#include <04_rays/hard_round_bodies.hpp>
#include <04_rays/slab_truth.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_box.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/ray_sphere.hpp>
#include <contact/ray_triangle.hpp>

using hard_cases::Case;
using hard_cases::Json;

namespace {

using contact::Aabb;
using contact::BodyHit;
using contact::Kdop;
using contact::OrientedBox;
using contact::Passage;
using contact::Ray;
using contact::Segment;
using contact::Sphere;
using contact::Vector3;
using hard_round::by_passage;
using hard_round::is_segment;
using hard_round::with_line;
using oracle::Rational;

// ---------------------------------------------------------------- input

template <class S>
Ray<S> ray_of(const Case& c) {
  return hard_round::ray_of<S>(c);
}
template <class S>
Sphere<S> sphere_of(const Case& c) {
  return generators::rounded<S>(c.sphere("sphere"));
}
template <class S>
Aabb<S> box_of(const Case& c) {
  return {generators::rounded<S>(c.vector("low")), generators::rounded<S>(c.vector("high"))};
}
/// Three columns, one after the other.
template <class S>
OrientedBox<S> oriented_box_of(const Case& c) {
  OrientedBox<S> box;
  box.centre = generators::rounded<S>(c.vector("centre"));
  box.half_lengths = generators::rounded<S>(c.vector("half_lengths"));
  const std::vector<double> axes = c.numbers("axes");
  for (int i = 0; i < 9; ++i) box.axes(i % 3, i / 3) = static_cast<S>(axes.at(std::size_t(i)));
  return box;
}
Kdop<double> kdop_of(const Case& c) {
  const std::vector<double> low = c.numbers("low"), high = c.numbers("high");
  return {contact::kdop_normals<double>(static_cast<int>(2 * low.size())), low, high};
}

// ---------------------------------------------------------------- answers

Json answer_of(bool met, bool inside, double t, const char* kind) {
  Json answer{{"class", kind}, {"hit", met}};
  if (!met) return answer;
  if (inside) answer["inside"] = true;
  answer["t"] = hard_cases::hex(inside ? 0.0 : t);
  return answer;
}

Json sphere_answer(const Case& c) {
  const Ray<Rational> line =
      with_line<double>(c, [](const auto& stored) { return rays::exact_line(stored); });
  const auto ball = oracle::exact(sphere_of<double>(c));
  const Vector3<Rational> m = line.origin - ball.centre;
  const oracle::Quadratic form{line.direction.dot(line.direction), 2 * line.direction.dot(m),
                               m.dot(m) - ball.radius * ball.radius};
  if (form.a == 0) return answer_of(form.c <= 0, true, 0, "b");
  const std::vector<oracle::Surd> roots = form.roots();
  const bool met = !roots.empty() && oracle::sign(roots.back()) >= 0 &&
                   (!is_segment(c) || oracle::sign(roots.front() + Rational(-1)) <= 0);
  if (!met) return answer_of(false, false, 0, "b");
  return answer_of(true, oracle::sign(roots.front()) < 0, oracle::nearest(roots.front()), "b");
}

Json slabs_answer(const Case& c, const std::vector<rays::ExactSlab>& slabs) {
  const rays::SlabTruth right = rays::truth(slabs);
  const bool met = right.hits(is_segment(c));
  const bool inside = met && right.inside();
  Json answer = answer_of(met, inside, met && !inside ? oracle::nearest(*right.entry) : 0, "a");
  if (met && !inside) answer["face"] = right.entry_face;
  return answer;
}

std::vector<rays::ExactSlab> box_slabs(const Case& c) {
  const Ray<Rational> line =
      with_line<double>(c, [](const auto& stored) { return rays::exact_line(stored); });
  std::vector<rays::ExactSlab> slabs;
  for (int k = 0; k < 3; ++k) {
    slabs.push_back({line.origin(k), line.direction(k), oracle::exact(c.vector("low")(k)),
                     oracle::exact(c.vector("high")(k))});
  }
  return slabs;
}

/// With the inverse of the axes.
std::vector<rays::ExactSlab> oriented_slabs(const Case& c) {
  const Ray<Rational> line =
      with_line<double>(c, [](const auto& stored) { return rays::exact_line(stored); });
  const OrientedBox<double> box = oriented_box_of<double>(c);
  const Vector3<Rational> m = line.origin - oracle::exact(box.centre);
  std::vector<rays::ExactSlab> slabs;
  for (int k = 0; k < 3; ++k) {
    const auto axis = [&](int j) {
      return oracle::exact(Vector3<double>(box.axes.col((k + j) % 3)));
    };
    const Vector3<Rational> n = axis(1).cross(axis(2));
    const Rational height = n.dot(axis(0));
    const Rational half = oracle::exact(box.half_lengths(k));
    slabs.push_back({Rational(n.dot(m) / height), Rational(n.dot(line.direction) / height),
                     Rational(-half), half});
  }
  return slabs;
}

std::vector<rays::ExactSlab> kdop_slabs(const Case& c) {
  const Ray<Rational> line =
      with_line<double>(c, [](const auto& stored) { return rays::exact_line(stored); });
  const Kdop<double> dop = kdop_of(c);
  std::vector<rays::ExactSlab> slabs;
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const Vector3<Rational> n = oracle::exact(dop.normals[k]);
    slabs.push_back({n.dot(line.origin), n.dot(line.direction), oracle::exact(dop.low[k]),
                     oracle::exact(dop.high[k])});
  }
  return slabs;
}

/// 02's question, for two public reports.
Json triangle_answer(const Case& c) {
  const auto triangle = oracle::exact(c.triangle("triangle"));
  const auto ray = oracle::exact(c.ray("ray"));
  const auto hit = truth::meet<Rational>(ray.origin, ray.direction, false, triangle);
  return answer_of(hit.has_value(), false, hit ? oracle::nearest(hit->t) : 0, "a");
}

// ---------------------------------------------------------------- judges

/// The decision, and t to 2^-20 of itself: a tenth of a millimetre in a hundred metres.
template <class S>
bool right_triangle(const std::optional<contact::TriangleHit<S>>& hit, const Json& answer) {
  if (hit.has_value() != answer.at("hit").get<bool>()) return false;
  const double exact = hit ? hard_cases::unhex(answer, "t") : 0;
  return !hit || hard_cases::close(double(hit->t), exact, 0x1p-20 * std::abs(exact));
}

/// Right if the decision is, and t (0 if inside) so that the point is off by at most a thousandth
/// of the size of the body, and far away by a few roundings of the distance: 2^-49, or 2^-22 where
/// t is a float.
template <class S>
bool right(const Case& c, const std::optional<BodyHit<S>>& hit, double size, const Json& answer) {
  if (hit.has_value() != answer.at("hit").get<bool>()) return false;
  if (!hit) return true;
  if (hit->inside != answer.contains("inside")) return false;
  const double exact = hard_cases::unhex(answer, "t");
  const double length = ray_of<double>(c).direction.cwiseAbs().maxCoeff();
  const double room = length > 0 ? 0x1p-10 * size / length : 0;
  const double far = std::is_same_v<S, float> ? 0x1p-22 : 0x1p-49;
  if (std::isinf(exact)) return std::isinf(hit->t);
  return hard_cases::close(double(hit->t), exact, room + far * std::abs(exact));
}
template <class S>
bool right_ball(const Case& c, const std::optional<BodyHit<S>>& hit, const Json& answer) {
  return right(c, hit, c.sphere("sphere").radius, answer);
}
/// Also the face, if the method says one.
template <class S>
bool right_box(const Case& c, const std::optional<BodyHit<S>>& hit, const Vector3<double>& sizes,
               const Json& answer) {
  if (hit && hit->face >= 0 && (!answer.contains("face") || answer.at("face") != hit->face)) {
    return false;
  }
  return right(c, hit, sizes.maxCoeff(), answer);
}
Vector3<double> sizes_of(const Case& c) { return c.vector("high") - c.vector("low"); }

template <class S, class Method>
void add_ball(hard_cases::Runner& runner, const std::string& name, Method method) {
  runner.method("sphere", name, [method](const Case& c, const Json& answer) {
    return right_ball<S>(c, by_passage<S>(c, method(ray_of<S>(c), sphere_of<S>(c))), answer);
  });
}
template <class S, class Method>
void add_box(hard_cases::Runner& runner, const std::string& name, Method method) {
  runner.method("box", name, [method](const Case& c, const Json& answer) {
    return right_box<S>(c, by_passage<S>(c, method(ray_of<S>(c), box_of<S>(c))), sizes_of(c),
                        answer);
  });
}

// ---------------------------------------------------------------- methods as they are often
// written

/// Division with a tolerance: a component below 1e-6 makes the line parallel to the slab.
std::optional<Passage<double>> box_with_tolerance(const Ray<double>& ray, const Aabb<double>& box) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Passage<double> found;
  found.entry = -infinity;
  found.exit = infinity;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(ray.direction(k)) < 1e-6) {
      if (ray.origin(k) < box.low(k) || ray.origin(k) > box.high(k)) return std::nullopt;
      continue;
    }
    double first = (box.low(k) - ray.origin(k)) / ray.direction(k);
    double last = (box.high(k) - ray.origin(k)) / ray.direction(k);
    if (first > last) std::swap(first, last);
    found.entry = std::max(found.entry, first);
    found.exit = std::min(found.exit, last);
  }
  if (found.entry > found.exit) return std::nullopt;
  return found;
}

/// A k-DOP by rounded slabs with division.
std::optional<Passage<double>> kdop_by_division(const Ray<double>& ray, const Kdop<double>& dop) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Passage<double> found;
  found.entry = -infinity;
  found.exit = infinity;
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const double at = dop.normals[k].dot(ray.origin), speed = dop.normals[k].dot(ray.direction);
    double first = (dop.low[k] - at) / speed, last = (dop.high[k] - at) / speed;
    if (first > last) std::swap(first, last);
    if (first > found.entry) found.entry = first;
    if (last < found.exit) found.exit = last;
  }
  if (found.entry > found.exit) return std::nullopt;
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("04_rays");

  runner.question("sphere", sphere_answer);
  add_ball<float>(runner, "lecture, float",
                  [](const auto& r, const auto& b) { return contact::passage_by_lecture(r, b); });
  add_ball<double>(runner, "lecture, double",
                   [](const auto& r, const auto& b) { return contact::passage_by_lecture(r, b); });
  add_ball<float>(runner, "textbook, float",
                  [](const auto& r, const auto& b) { return contact::passage_by_textbook(r, b); });
  add_ball<double>(runner, "textbook, double",
                   [](const auto& r, const auto& b) { return contact::passage_by_textbook(r, b); });
  add_ball<float>(runner, "nearest point, float", [](const auto& r, const auto& b) {
    return contact::passage_by_nearest_point(r, b);
  });
  add_ball<double>(runner, "nearest point, double", [](const auto& r, const auto& b) {
    return contact::passage_by_nearest_point(r, b);
  });
  runner.method("sphere", "the book, exact", [](const Case& c, const Json& answer) {
    return with_line<double>(c, [&](const auto& line) {
      const auto ball = sphere_of<double>(c);
      const auto hit = contact::first_hit(line, ball);
      return contact::hits_sphere(line, ball) == hit.has_value() &&
             right_ball<double>(c, hit, answer);
    });
  });

  runner.question("box", [](const Case& c) { return slabs_answer(c, box_slabs(c)); });
  add_box<double>(runner, "slabs with division, double", [](const auto& r, const auto& b) {
    return contact::passage_by_slabs_with_division(r, b);
  });
  add_box<double>(runner, "tolerance 1e-6, double", box_with_tolerance);
  add_box<float>(runner, "branchless slabs, float", [](const auto& r, const auto& b) {
    return contact::passage_by_branchless_slabs(r, b);
  });
  add_box<double>(runner, "branchless slabs, double", [](const auto& r, const auto& b) {
    return contact::passage_by_branchless_slabs(r, b);
  });
  add_box<double>(runner, "padded slabs, double", [](const auto& r, const auto& b) {
    return contact::passage_by_padded_slabs(r, b);
  });
  runner.method("box", "the book, exact", [](const Case& c, const Json& answer) {
    return with_line<double>(c, [&](const auto& line) {
      const auto hit = contact::first_hit(line, box_of<double>(c));
      return contact::hits_box(line, box_of<double>(c)) == hit.has_value() &&
             right_box<double>(c, hit, sizes_of(c), answer);
    });
  });

  runner.question("oriented_box", [](const Case& c) { return slabs_answer(c, oriented_slabs(c)); });
  const auto by_frame = [&runner]<class S>(const std::string& name, S) {
    runner.method("oriented_box", name, [](const Case& c, const Json& answer) {
      const auto found = contact::passage_by_frame(ray_of<S>(c), oriented_box_of<S>(c));
      return right_box<S>(c, by_passage<S>(c, found), c.vector("half_lengths"), answer);
    });
  };
  by_frame("in its frame, float", 0.0f);
  by_frame("in its frame, double", 0.0);
  runner.method("oriented_box", "the book, exact", [](const Case& c, const Json& answer) {
    return with_line<double>(c, [&](const auto& line) {
      const auto hit = contact::first_hit(line, oriented_box_of<double>(c));
      return right_box<double>(c, hit, c.vector("half_lengths"), answer);
    });
  });

  runner.question("kdop", [](const Case& c) { return slabs_answer(c, kdop_slabs(c)); });
  runner.method("kdop", "slabs with division, double", [](const Case& c, const Json& answer) {
    return right_box<double>(c,
                             by_passage<double>(c, kdop_by_division(ray_of<double>(c), kdop_of(c))),
                             Vector3<double>(1, 1, 1), answer);
  });
  runner.method("kdop", "the box around it, double", [](const Case& c, const Json& answer) {
    const Kdop<double> dop = kdop_of(c);
    const Aabb<double> box{{dop.low[0], dop.low[1], dop.low[2]},
                           {dop.high[0], dop.high[1], dop.high[2]}};
    return with_line<double>(c, [&](const auto& line) {
      return right_box<double>(c, contact::first_hit(line, box), Vector3<double>(1, 1, 1), answer);
    });
  });
  runner.method("kdop", "the book, exact", [](const Case& c, const Json& answer) {
    return with_line<double>(c, [&](const auto& line) {
      return right_box<double>(c, contact::first_hit(line, kdop_of(c)), Vector3<double>(1, 1, 1),
                               answer);
    });
  });

  runner.question("triangle", triangle_answer);
  runner.method("triangle", "Möller–Trumbore, float", [](const Case& c, const Json& answer) {
    return right_triangle(contact::intersect_moller_trumbore(
                              ray_of<float>(c), generators::rounded<float>(c.triangle("triangle"))),
                          answer);
  });
  runner.method("triangle", "Möller–Trumbore, double", [](const Case& c, const Json& answer) {
    return right_triangle(
        contact::intersect_moller_trumbore(ray_of<double>(c), c.triangle("triangle")), answer);
  });
  runner.method("triangle", "the book, exact", [](const Case& c, const Json& answer) {
    return right_triangle(contact::intersect_exact(ray_of<double>(c), c.triangle("triangle")),
                          answer);
  });

  hard_round::add_questions(runner);
  return runner.run(argc, argv);
}
