// What does it cost to know where a point is? Each method of the chapter in float and in double, on
// random inputs and on those that are hard to decide.
#include <support/ladder.hpp>

#include <contact/convex_polygon.hpp>
#include <contact/point_in_polygon.hpp>

namespace {

using contact::Exact;
using contact::Polygon;
using contact::Rule;
using contact::Where;
using Point = contact::Vector2<double>;

/// The same numbers in float and in double: every coordinate is a float, so that every method gets
/// the same input. The conversion is not timed.
struct Input {
  Polygon<float> polygon;
  contact::Vector2<float> p;
  Polygon<double> polygon_in_double;
  Point p_in_double;
};

struct Answer {
  Where where = Where::outside;     ///< by the even-odd rule, or by the method's own
  Where non_zero = Where::outside;  ///< the true answer by the other rule
  Rule rule = Rule::even_odd;       ///< the method's rule
  bool two_answers = false;         ///< whether the method cannot say `on`
};

/// Rounded to floats. Not inlined: GCC 12.2 with -O2 takes two doubles that are rounded to float
/// and converted back for the same doubles, and so leaves the rounding out.
[[gnu::noinline]] contact::Vector2<float> in_float(const Point& v) { return v.cast<float>(); }

Input narrowed(const std::vector<Point>& vertices, const Point& p) {
  Input input;
  input.p = in_float(p);
  input.p_in_double = input.p.cast<double>();
  for (const Point& v : vertices) {
    input.polygon.push_back(in_float(v));
    input.polygon_in_double.push_back(input.polygon.back().cast<double>());
  }
  return input;
}

/// Winding number and boundary with exact numbers and no filter.
Answer exactly(const Input& input) {
  const auto in_exact = [](const Point& v) {
    return contact::Vector2<Exact>(Exact(v.x()), Exact(v.y()));
  };
  const Point& p = input.p_in_double;
  int winding = 0;
  bool on = false;
  contact::for_each_edge(input.polygon_in_double, [&](const Point& a, const Point& b) {
    if (std::max(a.y(), b.y()) < p.y() || std::min(a.y(), b.y()) > p.y()) return;
    const int side = contact::orientation<Exact>(in_exact(a), in_exact(b), in_exact(p)).sign();
    on = on || (side == 0 && std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()));
    if (a.y() <= p.y() && p.y() < b.y() && side > 0) ++winding;
    if (b.y() <= p.y() && p.y() < a.y() && side < 0) --winding;
  });
  Answer answer{Where::on, Where::on};
  if (on) return answer;
  answer.where = winding % 2 != 0 ? Where::inside : Where::outside;
  answer.non_zero = winding != 0 ? Where::inside : Where::outside;
  return answer;
}

Where right_by(Rule rule, const Answer& truth) {
  return rule == Rule::even_odd ? truth.where : truth.non_zero;
}

/// Each method is judged by its own rule. One with two answers is not wrong on the boundary.
ladder::Verdict judge(const Answer& got, const Answer& truth) {
  const Where right = right_by(got.rule, truth);
  ladder::Verdict verdict;
  verdict.wrong = got.where != right && !(got.two_answers && right == Where::on);
  return verdict;
}

/// A point on the boundary of the square from −1 to 1, after this share of a turn. It takes no sine
/// and no cosine, which differ from machine to machine.
Point on_square(double share) {
  const double along = 4 * share;
  const int side = static_cast<int>(along);
  const double across = 2 * (along - side) - 1;
  switch (side) {
    case 0:
      return {1, across};
    case 1:
      return {-across, 1};
    case 2:
      return {-1, -across};
    default:
      return {across, -1};
  }
}

/// Once around the origin, each vertex at a random distance: concave, without crossing itself.
std::vector<Point> star(generators::Random& random, int count) {
  std::vector<Point> vertices;
  for (int i = 0; i < count; ++i) {
    const Point direction = on_square((i + random.uniform(0.05, 0.95)) / count);
    vertices.push_back(direction * random.uniform(0.2, 1));
  }
  return vertices;
}

/// On a circle, well apart, and so convex also after rounding to float.
std::vector<Point> convex(generators::Random& random, int count) {
  std::vector<Point> vertices;
  for (int i = 0; i < count; ++i) {
    const Point direction = on_square((i + random.uniform(0.1, 0.9)) / count);
    vertices.push_back(direction / std::sqrt(direction.squaredNorm()));
  }
  return vertices;
}

Point in_square(generators::Random& random) {
  const double x = random.uniform(-1, 1);
  return {x, random.uniform(-1, 1)};
}

constexpr int usual = 16;  // vertices
constexpr int many = 64;

std::size_t any_vertex(generators::Random& random, const std::vector<Point>& vertices) {
  return static_cast<std::size_t>(random.integer(0, static_cast<int>(vertices.size()) - 1));
}

/// At the level of a vertex.
Input at_level(generators::Random& random) {
  const std::vector<Point> vertices = star(random, usual);
  const double y = vertices[any_vertex(random, vertices)].y();
  return narrowed(vertices, {random.uniform(-1, 1), y});
}

/// On an edge or a vertex, before rounding to float.
Input at_edge(generators::Random& random) {
  const std::vector<Point> vertices = star(random, usual);
  const std::size_t i = any_vertex(random, vertices);
  const Point &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
  return narrowed(vertices, a + (random.chance(0.1) ? 0.0 : random.uniform()) * (b - a));
}

/// The edge passes close to the origin, and so does p, where floats are so close to each other that
/// the methods in double round too coarsely.
Input at_edge_near_origin(generators::Random& random) {
  std::vector<Point> vertices = star(random, usual);
  const std::size_t i = any_vertex(random, vertices);
  const std::size_t next = (i + 1) % vertices.size();
  const Point middle = vertices[i] + random.uniform(0.1, 0.9) * (vertices[next] - vertices[i]);
  for (Point& v : vertices) v = in_float(v - middle).cast<double>();
  const Point a = vertices[i], along = vertices[next] - a;
  const int major = std::abs(along.x()) > std::abs(along.y()) ? 0 : 1;
  Point p;
  p[major] = static_cast<float>(random.uniform(-1, 1) * 0x1p-24);
  p[1 - major] = a[1 - major] + (p[major] - a[major]) / along[major] * along[1 - major];
  return narrowed(vertices, p);
}

/// Whole numbers up to 4.
Input on_grid(generators::Random& random) {
  std::vector<Point> vertices = star(random, usual);
  for (Point& v : vertices) v = {std::round(4 * v.x()), std::round(4 * v.y())};
  const double x = random.integer(-4, 4);
  return narrowed(vertices, {x, double(random.integer(-4, 4))});
}

/// A million metres from the origin, where floats are a sixteenth or an eighth apart.
Input far(generators::Random& random) {
  std::vector<Point> vertices = star(random, usual);
  const Point offset{random.magnitude(19, 19), random.magnitude(19, 20)};
  for (Point& v : vertices) v = 8 * v + offset;
  return narrowed(vertices, 8 * in_square(random) + offset);
}

/// A polygon of length 2 and a thickness of 2^-19.
Input thin(generators::Random& random) {
  std::vector<Point> vertices = star(random, usual);
  const double slope = random.uniform(-1, 1);
  const auto flattened = [slope](const Point& v) {
    return Point(v.x(), slope * v.x() + 0x1p-20 * v.y());
  };
  for (Point& v : vertices) v = flattened(v);
  return narrowed(vertices, flattened(in_square(random)));
}

/// Random vertices in a random order.
Input crossing_itself(generators::Random& random) {
  std::vector<Point> vertices;
  for (int i = 0; i < usual; ++i) vertices.push_back(in_square(random));
  return narrowed(vertices, in_square(random));
}

constexpr std::size_t shown_vertices = 8;

/// One vertex less, as long as there are more than the figure has.
std::vector<Input> simpler(const Input& input) {
  std::vector<Input> all;
  if (input.polygon.size() <= shown_vertices) return all;
  for (std::size_t i = 0; i < input.polygon.size(); ++i) {
    all.push_back(input);
    const auto at = static_cast<std::ptrdiff_t>(i);
    all.back().polygon.erase(all.back().polygon.begin() + at);
    all.back().polygon_in_double.erase(all.back().polygon_in_double.begin() + at);
  }
  return all;
}

/// The number of a method in the figure, or −1.
double in_figure(const std::string& id) {
  static const std::array<const char*, 7> ids{"where", "edges",     "angles",  "quadrants",
                                              "ends",  "crossings", "scanline"};
  const std::string method = id.substr(0, id.find('-'));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (method == ids[i]) return static_cast<double>(i);
  }
  return -1;
}

/// The polygon and the point, times a power of two that makes the polygon fill the figure: that
/// rounds nothing.
ladder::Example shown(const Input& input, const Answer& got, const Answer& truth,
                      const ladder::Method& method) {
  const auto words = [](Where where) {
    return where == Where::on ? "on" : where == Where::inside ? "inside" : "outside";
  };
  ladder::Example example;
  example.facts = {ladder::numbers("p", input.p)};
  const bool named = input.polygon.size() <= shown_vertices;
  for (std::size_t i = 0; i < input.polygon.size(); ++i) {
    const std::string name = named ? std::string(1, char('a' + i)) : "v" + std::to_string(i);
    example.facts.push_back(ladder::numbers(name, input.polygon[i]));
  }
  example.facts.push_back({"this method", words(got.where)});
  example.facts.push_back({"exact", words(right_by(got.rule, truth))});

  double low = std::numeric_limits<double>::infinity(), high = -low;
  double size = input.p_in_double.cwiseAbs().maxCoeff();
  for (const Point& v : input.polygon_in_double) {
    size = std::max(size, v.cwiseAbs().maxCoeff());
    low = std::min(low, v.x());
    high = std::max(high, v.x());
  }
  const double number = in_figure(method.id);
  if (number < 0) {
    example.note = "The figure does not have this method.";
  } else if (input.polygon.size() != shown_vertices) {
    example.note =
        "The figure shows eight vertices, and with any eight of these that were tried the method "
        "is right.";
  } else if (high - low < size / 64) {
    example.note = "So far from the origin, the figure would show the polygon as one point.";
  } else {
    // The largest coordinate becomes 1.75 to 3.5.
    const double scale = std::ldexp(1.0, -std::ilogb(size / 1.75));
    example.figure = "where";
    for (std::size_t i = 0; i < shown_vertices; ++i) {
      example.fields.push_back(
          ladder::field(std::string(1, char('a' + i)), Point(input.polygon_in_double[i] * scale)));
    }
    example.fields.push_back(ladder::field("p", Point(input.p_in_double * scale)));
    example.fields.push_back({"method", {number}});
    example.fields.push_back({"joined", {0}});
    example.fields.push_back({"rule", {got.rule == Rule::non_zero ? 1.0 : 0.0}});
    example.fields.push_back({"single", {method.scalar == "float" ? 1.0 : 0.0}});
    if (scale != 1) example.note = "All coordinates are multiplied by a power of two.";
  }
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("Where is the point?", exactly, judge);

  const auto anywhere = [](auto polygon, int count) {
    return [polygon, count](generators::Random& random) {
      const std::vector<Point> vertices = polygon(random, count);
      return narrowed(vertices, in_square(random));
    };
  };
  ladder.family("random", "random", anywhere(star, usual));
  ladder.family("random-64", "random, 64 vertices", anywhere(star, many));
  ladder.family("convex", "convex, 64 vertices", anywhere(convex, many));
  ladder.family("level", "at the level of a vertex", at_level);
  ladder.family("edge", "on an edge, rounded", at_edge);
  ladder.family("origin", "on an edge, near the origin", at_edge_near_origin);
  ladder.family("grid", "whole numbers up to 4", on_grid);
  ladder.family("far", "far from the origin", far);
  ladder.family("thin", "thin", thin);
  ladder.family("self-crossing", "polygons that cross themselves", crossing_itself);

  const auto in_both = [&ladder](const char* id, const char* title, Rule rule, auto method) {
    const auto answer = [rule](Where where) { return Answer{where, where, rule, true}; };
    ladder.method(
        {.id = std::string(id) + "-float", .title = title, .scalar = "float", .exact = false},
        [method, answer](const Input& input) { return answer(method(input.polygon, input.p)); });
    ladder.method(
        {.id = std::string(id) + "-double", .title = title, .scalar = "double", .exact = false},
        [method, answer](const Input& input) {
          return answer(method(input.polygon_in_double, input.p_in_double));
        });
  };
  in_both("angles", "sum of angles", Rule::non_zero, [](const auto& polygon, const auto& p) {
    return contact::where_by_angle_sum(polygon, p);
  });
  in_both("quadrants", "quadrants", Rule::non_zero, [](const auto& polygon, const auto& p) {
    return contact::where_by_quadrants(polygon, p);
  });
  in_both("ends", "crossings, both ends", Rule::even_odd, [](const auto& polygon, const auto& p) {
    return contact::where_by_crossings_with_ends(polygon, p);
  });
  in_both("crossings", "crossings", Rule::even_odd, [](const auto& polygon, const auto& p) {
    return contact::where_by_crossings(polygon, p);
  });
  in_both("scanline", "scanline", Rule::non_zero, [](const auto& polygon, const auto& p) {
    return contact::where_by_scanline(polygon, p);
  });

  const auto of_three = [&ladder](const char* id, const char* title, const char* scalar, bool exact,
                                  auto method) {
    ladder.method({.id = id, .title = title, .scalar = scalar, .exact = exact},
                  [method](const Input& input) {
                    const Where where = method(input.polygon_in_double, input.p_in_double);
                    return Answer{where, where};
                  });
  };
  of_three("edges-double", "edge tests, for convex polygons", "double", false,
           [](const auto& polygon, const auto& p) { return contact::where_by_edges(polygon, p); });
  of_three(
      "bisection", "bisection, for convex polygons", "double, then exact", false,
      [](const auto& polygon, const auto& p) { return contact::where_by_bisection(polygon, p); });
  of_three("where", "winding number, filtered", "double, then exact", true,
           [](const auto& polygon, const auto& p) { return contact::where(polygon, p); });
  ladder.method({.id = "exact-unfiltered",
                 .title = "winding number, no filter",
                 .scalar = "exact",
                 .exact = true},
                exactly);
  ladder.recommend("where");
  ladder.show(shown);
  ladder.simplify(simpler);
  return ladder;
}

}  // namespace

LADDER(experiment)
