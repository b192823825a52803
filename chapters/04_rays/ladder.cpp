// What does it cost to know whether a ray hits a ball, or a box? Each method of the chapter in
// float and in double, on random inputs and on those that are hard to decide.
#include <support/ladder.hpp>

#include <04_rays/families.hpp>
#include <contact/ray_box.hpp>
#include <contact/ray_sphere.hpp>

namespace {

using contact::Aabb;
using contact::Exact;
using contact::Ray;
using contact::Sphere;
using Point = contact::Vector3<double>;

struct Answer {
  bool hit = false;
  double t = std::nan("");     ///< of the hit; NaN if there is none, or the method only decides
  double unit = std::nan("");  ///< of the true answer: the t in which errors are counted
};

/// Wrong is a hit where there is none, or none where there is one. The error is that of t.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.wrong = got.hit != right.hit;
  if (got.hit && right.hit) verdict.error = std::abs(got.t - right.t) / right.unit;
  return verdict;
}

/// What a ray meets of the passage that a method finds.
template <class Ray, class Found>
Answer first_of(const Ray& ray, const Found& found) {
  if (!found) return {};
  const auto hit = contact::first_hit(ray, *found);
  return hit ? Answer{true, static_cast<double>(hit->t)} : Answer{};
}

const char* words(const Answer& answer) { return answer.hit ? "hit" : "miss"; }

/// What brings numbers up to this size into a figure without rounding them; 1 if they are there.
double into_figure(double size) { return size > 4 ? std::ldexp(1.0, -std::ilogb(size) + 1) : 1; }

/// What all methods of a ladder have in common.
ladder::Method named(const char* id, const char* in, const char* title, const char* scalar) {
  return {.id = std::string(id) + in, .title = title, .scalar = scalar, .exact = false};
}
ladder::Method exact(const char* id, const char* title, const char* scalar) {
  return {.id = id, .title = title, .scalar = scalar, .exact = true};
}

/// A ray as a peer gets it: origin, direction.
void ask(const Ray<double>& ray, std::vector<double>& to) {
  to.insert(to.end(), ray.origin.begin(), ray.origin.end());
  to.insert(to.end(), ray.direction.begin(), ray.direction.end());
}

namespace ball {

/// The same numbers in float and in double: the conversion is not timed.
struct Input {
  Ray<float> ray;
  Sphere<float> body;
  Ray<double> ray_in_double;
  Sphere<double> body_in_double;
  int quarter = 0;
  Point start, through;
};

Input both_types(const families::AtSphere& aimed) {
  return {aimed.ray,
          aimed.body,
          contact::in_double(aimed.ray),
          contact::in_double(aimed.body),

          static_cast<int>(aimed.quarter),
          aimed.start,
          aimed.through};
}

/// The signs of the quadratic and of its derivative at the start, and of its discriminant; t to
/// four roundings, and errors in radii.
Answer truth(const Input& input) {
  const auto in_exact = [](const Point& v) {
    return contact::Vector3<Exact>(Exact(v.x()), Exact(v.y()), Exact(v.z()));
  };
  const contact::Vector3<Exact> m =
      in_exact(input.ray_in_double.origin) - in_exact(input.body_in_double.centre);
  const contact::Vector3<Exact> d = in_exact(input.ray_in_double.direction);
  const Exact radius(input.body_in_double.radius);
  const Exact c = m.dot(m) - radius * radius;
  const Exact a = d.dot(d);
  const double unit = input.body_in_double.radius / std::sqrt(rounded<double>(a));
  if (c.sign() <= 0) return {true, 0, unit};
  const Exact b = m.dot(d);
  const Exact depth = b * b - a * c;
  if (b.sign() >= 0 || depth.sign() < 0) return {};
  return {true, rounded<double>(c) / (rounded<double>(-b) + std::sqrt(rounded<double>(depth))),
          unit};
}

/// The number of a method in the figure, or −1.
double in_figure(const std::string& id) {
  static const std::array<const char*, 4> ids{"exact", "lecture", "textbook", "nearest"};
  const std::string method = id.substr(0, id.find('-'));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (method == ids[i]) return static_cast<double>(i);
  }
  return -1;
}

/// Whether the figure, given these two points in the plane, makes this very ray of them.
template <class S>
bool made_by_figure(const Input& input, double scale, bool unit) {
  const Point ahead = scale * input.through - scale * input.start;
  const Point along = ahead / std::sqrt(ahead.head<2>().squaredNorm());
  const double moved = input.quarter > 0 ? families::power_of_ten(input.quarter) : 0;
  const contact::Vector3<S> origin = Point(scale * input.start - moved * along).cast<S>();
  const contact::Vector3<S> direction = (unit ? along : ahead).template cast<S>();
  return origin.template cast<double>() == scale * input.ray_in_double.origin &&
         direction.template cast<double>() == (unit ? 1 : scale) * input.ray_in_double.direction;
}

/// What a method of the figure says of the ray and the ball with all coordinates multiplied.
template <class S>
bool hits_scaled(int method, const Ray<S>& given, const Sphere<S>& body, S scale) {
  const Ray<S> ray{given.origin * scale, given.direction * scale};
  const Sphere<S> ball{body.centre * scale, body.radius * scale};
  switch (method) {
    case 1:
      return first_of(ray, contact::passage_by_lecture(ray, ball)).hit;
    case 2:
      return first_of(ray, contact::passage_by_textbook(ray, ball)).hit;
    case 3:
      return first_of(ray, contact::passage_by_nearest_point(ray, ball)).hit;
    default:
      return contact::hits_sphere(ray, ball);
  }
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  ladder::Example example;
  example.facts = {ladder::numbers("ray's origin", input.ray.origin),
                   ladder::numbers("ray's direction", input.ray.direction),
                   ladder::numbers("centre", input.body.centre),
                   ladder::number("radius", input.body.radius),
                   {"this method", words(got)},
                   {"exact", words(right)}};
  const double number = in_figure(method.id);
  if (number < 0) {
    example.note = "The figure does not have this method.";
    return example;
  }
  if (method.id == "lecture-double" && input.quarter > 0) {
    example.note = "The direction is a unit vector only as far as floats can store one.";
    return example;
  }
  if (input.ray.origin.z() != 0 || input.ray.direction.z() != 0 || input.body.centre.z() != 0) {
    example.note = "The figure shows rays in the plane of the ball's centre.";
    return example;
  }
  if (!(input.body.radius > 0)) {
    example.note = "The figure takes no ball of radius 0.";
    return example;
  }
  const double size =
      std::max({input.start.cwiseAbs().maxCoeff(), input.through.cwiseAbs().maxCoeff(),
                input.body_in_double.centre.cwiseAbs().maxCoeff()});
  const bool single = method.scalar == "float";
  // The direction as a unit vector, or from one point to the other.
  for (const bool unit : {true, false}) {
    const double scale = input.quarter > 0 ? 1 : into_figure(size);
    const bool same = single ? made_by_figure<float>(input, scale, unit)
                             : made_by_figure<double>(input, scale, unit);
    if (!same || size * scale > 1e6) continue;
    const bool hit =
        single ? hits_scaled<float>(int(number), input.ray, input.body, float(scale))
               : hits_scaled<double>(int(number), input.ray_in_double, input.body_in_double, scale);
    if (hit != got.hit) {
      example.note = "Divided by a power of two, to fit into the figure, they do not overflow.";
      return example;
    }
    const auto plane = [scale](const Point& v) {
      return contact::Vector2<double>(v.x() * scale, v.y() * scale);
    };
    example.figure = "sphere";
    example.fields = {ladder::field("origin", plane(input.start)),
                      ladder::field("through", plane(input.through)),
                      ladder::field("centre", plane(input.body_in_double.centre)),
                      {"radius", {input.body_in_double.radius * scale}},
                      {"far", {input.quarter / 4.0}},
                      {"direction", {unit ? 0.0 : 1.0}},
                      {"method", {number}},
                      {"single", {single ? 1.0 : 0.0}}};
    if (scale != 1) example.note = "All coordinates are divided by a power of two.";
    return example;
  }
  example.note = "In the figure's form, with two points of the ray, this direction is rounded.";
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("Does the ray hit the ball?", truth, judge);
  const auto family = [&ladder](const char* id, const char* title, auto generator) {
    ladder.family(id, title, [generator](generators::Random& random) {
      return both_types(generator(random));
    });
  };
  family("ball-random", "random", families::sphere_random);
  family("ball-tangent", "tangents, rounded", families::sphere_tangent);
  family("ball-far", "100 to 1,000,000 m away", families::sphere_far);
  ladder.family(
      "ball-far-t", "the same, t in radii",
      [](generators::Random& random) { return both_types(families::sphere_far(random)); }, true);
  family("ball-lengths", "directions of every length", families::sphere_lengths);
  family("ball-surface", "start on the surface, rounded", families::sphere_surface);
  family("ball-inside", "start inside", families::sphere_inside);
  family("ball-grid", "whole numbers", families::sphere_grid);
  family("ball-beside", "a tangent, one float beside", families::sphere_beside);

  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(named(id, "-float", title, "float"), [method](const Input& input) {
      return first_of(input.ray, method(input.ray, input.body));
    });
    ladder.method(named(id, "-double", title, "double"), [method](const Input& input) {
      return first_of(input.ray_in_double, method(input.ray_in_double, input.body_in_double));
    });
  };
  in_both("lecture", "the lecture's, for unit directions",
          [](const auto& r, const auto& b) { return contact::passage_by_lecture(r, b); });
  in_both("textbook", "textbook",
          [](const auto& r, const auto& b) { return contact::passage_by_textbook(r, b); });
  in_both("nearest", "nearest point",
          [](const auto& r, const auto& b) { return contact::passage_by_nearest_point(r, b); });

  ladder.method(exact("exact-decision", "decision, filtered", "double, then exact"),
                [](const Input& input) {
                  return Answer{contact::hits_sphere(input.ray_in_double, input.body_in_double)};
                });
  ladder.method(exact("exact-hit", "first hit, filtered", "double, then exact"),
                [](const Input& input) {
                  const auto hit = contact::first_hit(input.ray_in_double, input.body_in_double);
                  return hit ? Answer{true, hit->t} : Answer{};
                });
  ladder.method(exact("unfiltered", "decision, no filter", "exact"), truth);
  // Its direction has length 1, and its answer is a point, which the page turns into t. From inside
  // it is where the ray leaves; the book's is the start.
  ladder.peer(
      {.id = "three-ray-sphere",
       .title = "three.js",
       .scalar = "JavaScript",
       .asks = 10,
       .tells = 2},
      [](const Input& input, std::vector<double>& to) {
        ask(input.ray_in_double, to);
        to.insert(to.end(), input.body_in_double.centre.begin(), input.body_in_double.centre.end());
        to.push_back(input.body_in_double.radius);
      },
      [](const double* told, const Answer& right) {
        return Answer{told[0] != 0, right.t == 0 ? std::nan("") : told[1]};
      });
  ladder.recommend("exact-decision");
  ladder.show(shown);
  return ladder;
}

}  // namespace ball

namespace box {

struct Input {
  Ray<float> ray;
  Aabb<float> body;
  Ray<double> ray_in_double;
  Aabb<double> body_in_double;
};

Input both_types(const families::AtBox& aimed) {
  return {aimed.ray, aimed.body, contact::in_double(aimed.ray), contact::in_double(aimed.body)};
}

/// Each bound on t is a fraction with a positive denominator; the ray hits if no lower bound is
/// above an upper one.
Answer truth(const Input& input) {
  struct Fraction {
    Exact above, below;
  };
  std::array<Fraction, 4> lower{Fraction{Exact(0.0), Exact(1.0)}};
  std::array<Fraction, 3> upper;
  std::size_t lowers = 1, uppers = 0;
  for (int k = 0; k < 3; ++k) {
    const Exact origin(input.ray_in_double.origin(k)), rate(input.ray_in_double.direction(k));
    const Exact to_low = Exact(input.body_in_double.low(k)) - origin;
    const Exact to_high = Exact(input.body_in_double.high(k)) - origin;
    if (rate.sign() == 0) {
      if (to_low.sign() > 0 || to_high.sign() < 0) return {false};
      continue;
    }
    const bool forwards = rate.sign() > 0;
    lower[lowers++] = forwards ? Fraction{to_low, rate} : Fraction{-to_high, -rate};
    upper[uppers++] = forwards ? Fraction{to_high, rate} : Fraction{-to_low, -rate};
  }
  for (std::size_t i = 0; i < lowers; ++i) {
    for (std::size_t j = 0; j < uppers; ++j) {
      if (upper[j].above * lower[i].below < lower[i].above * upper[j].below) return {false};
    }
  }
  return {true};
}

/// The number of a method in the figure, or −1.
double in_figure(const std::string& id) {
  static const std::array<const char*, 4> ids{"exact", "division", "branchless", "padded"};
  const std::string method = id.substr(0, id.find('-'));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (method == ids[i]) return static_cast<double>(i);
  }
  return -1;
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  ladder::Example example;
  example.facts = {ladder::numbers("ray's origin", input.ray.origin),
                   ladder::numbers("ray's direction", input.ray.direction),
                   ladder::numbers("low", input.body.low),
                   ladder::numbers("high", input.body.high),
                   {"this method", words(got)},
                   {"exact", words(right)}};
  const double number = in_figure(method.id);
  const Ray<double>& ray = input.ray_in_double;
  const Aabb<double>& body = input.body_in_double;
  const Point through = ray.origin + ray.direction;
  double size = 0;
  for (const Point& p : {ray.origin, through, body.low, body.high}) {
    size = std::max(size, p.cwiseAbs().maxCoeff());
  }
  const double scale = into_figure(size);
  const bool single = method.scalar == "float";
  // The figure gets a second point of the ray, from which its methods must get this direction.
  const bool same = single ? contact::Vector3<float>(through.cast<float>() - input.ray.origin) ==
                                 input.ray.direction
                           : Point(through - ray.origin) == ray.direction;
  const auto minus_zero = [](double x) { return x == 0 && std::signbit(x); };
  if (number < 0) {
    example.note = "The figure does not have this method.";
  } else if (!same) {
    example.note = "In the figure's form, with two points of the ray, this direction is rounded.";
  } else if (std::any_of(ray.direction.begin(), ray.direction.end(), minus_zero)) {
    example.note = "In the figure's form, with two points of the ray, −0 becomes 0.";
  } else if ((body.high - body.low).maxCoeff() < size / 256) {
    example.note = "So far from the box, the figure would show it as one point.";
  } else {
    const auto plane = [scale](const Point& v) {
      return contact::Vector2<double>(v.x() * scale, v.y() * scale);
    };
    example.figure = "slabs";
    example.fields = {ladder::field("low", plane(body.low)),
                      ladder::field("high", plane(body.high)),
                      ladder::field("origin", plane(ray.origin)),
                      ladder::field("through", plane(through)),
                      {"z",
                       {body.low.z() * scale, body.high.z() * scale, ray.origin.z() * scale,
                        through.z() * scale}},
                      {"segment", {0}},
                      {"method", {number}},
                      {"divided", {1}},
                      {"single", {single ? 1.0 : 0.0}}};
    if (scale != 1) example.note = "All coordinates are divided by a power of two.";
  }
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("Does the ray hit the box?", truth, judge);
  const auto family = [&ladder](const char* id, const char* title, auto generator) {
    ladder.family(id, title, [generator](generators::Random& random) {
      return both_types(generator(random));
    });
  };
  family("box-random", "random", families::box_random);
  family("box-edge", "through an edge, rounded", families::box_edge);
  family("box-face", "in the plane of a face", families::box_face);
  family("box-far", "at an edge, far away", families::box_far);
  family("box-lengths", "directions of every length", families::box_lengths);
  family("box-surface", "start on the surface", families::box_surface);
  family("box-inside", "start inside", families::box_inside);
  family("box-grid", "whole numbers", families::box_grid);
  family("box-beside", "at an edge, one float beside", families::box_beside);

  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(named(id, "-float", title, "float"), [method](const Input& input) {
      return first_of(input.ray, method(input.ray, input.body));
    });
    ladder.method(named(id, "-double", title, "double"), [method](const Input& input) {
      return first_of(input.ray_in_double, method(input.ray_in_double, input.body_in_double));
    });
  };
  in_both("division", "slabs, divided", [](const auto& r, const auto& b) {
    return contact::passage_by_slabs_with_division(r, b);
  });
  in_both("branchless", "branchless slabs",
          [](const auto& r, const auto& b) { return contact::passage_by_branchless_slabs(r, b); });
  in_both("padded", "padded slabs",
          [](const auto& r, const auto& b) { return contact::passage_by_padded_slabs(r, b); });

  ladder.method(exact("exact-box-decision", "decision, filtered", "double, then exact"),
                [](const Input& input) {
                  return Answer{contact::hits_box(input.ray_in_double, input.body_in_double)};
                });
  ladder.method(exact("exact-box-hit", "first hit, filtered", "double, then exact"),
                [](const Input& input) {
                  const auto hit = contact::first_hit(input.ray_in_double, input.body_in_double);
                  return hit ? Answer{true, hit->t} : Answer{};
                });
  ladder.method(exact("box-unfiltered", "decision, no filter", "exact"), truth);
  ladder.peer(
      {.id = "three-ray-box", .title = "three.js", .scalar = "JavaScript", .asks = 12, .tells = 1},
      [](const Input& input, std::vector<double>& to) {
        ask(input.ray_in_double, to);
        const Aabb<double>& body = input.body_in_double;
        to.insert(to.end(), body.low.begin(), body.low.end());
        to.insert(to.end(), body.high.begin(), body.high.end());
      },
      [](const double* told, const Answer&) { return Answer{told[0] != 0}; });
  ladder.recommend("exact-box-decision");
  ladder.show(shown);
  return ladder;
}

}  // namespace box

ladder::Parts experiment() {
  ladder::Parts parts("Does the ray hit?");
  parts.add(ball::experiment());
  parts.add(box::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
