// A point and a polygon of eight vertices: where each method of the chapter puts the point, what
// each edge contributes, and at which positions of a grid the chosen method is wrong.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/arc.hpp>
#include <contact/convex_polygon.hpp>
#include <contact/figure.hpp>
#include <contact/point_in_polygon.hpp>
#include <numbers>
#include <vector>

using Point = contact::Vector2<double>;
using contact::Rule;
using contact::Where;

constexpr int count = 8;
constexpr int methods = 7;

struct Input {
  Point a, b, c, d, e, f, g, h;
  Point p;
  double method;  // 0 the book's, 1 edge tests, 2 angle sum, 3 quadrants, 4 crossings with both
                  // ends, 5 crossings, 6 scanline
  double joined;  // 0 in order, 1 every third, 2 a to e with the hole f g h
  double rule;    // 0 even-odd, 1 non-zero: for the book's method and the scanline
  double single;  // 1: points and methods in float
};

// The grid: 41 columns and 29 rows a quarter of a metre apart, around the origin, and then a row at
// the level of each vertex.
constexpr int columns = 41, rows = 29;
constexpr int cells = columns * (rows + count);

struct Output {
  double problem;
  std::array<double, count> from, to;  // vertices of each edge
  double where;                        // the book's: 0 outside, 1 on, 2 inside, by the rule
  std::array<double, methods> says;    // of each method, as `where`
  std::array<double, methods> wrong;   // 1 if a method is wrong by its own rule; what has two
                                       // answers is not wrong on the boundary
  double winding;                      // of outline and hole; 0 on the boundary of either
  std::array<double, methods> sum;     // that each method decides by: winding number, edges with
                                       // p on the inner side, rad, quadrants, crossings, steps
  std::array<double, count> part;      // of each edge, by the chosen method
  std::array<double, count> crosses;   // 1 if the edge meets the level of p, by the chosen method
  std::array<double, count> crossing;  // its x there
  std::array<double, cells> inside;    // 1 where the chosen method's rule has inside
  std::array<double, cells> missed;    // 1 where the chosen method is wrong
  double grid_wrong;                   // how many
  // Of the vertices in order, whatever is chosen, for a reader's function that takes whole numbers:
  // everything in eighths of a metre.
  double inside_in_order;               // by the even-odd rule, in double
  double in_order_clear;                // 1 if the eighths are whole and p is not on the boundary
  double where_in_pentagon;             // of a to e
  double pentagon_clear;                // 1 if the eighths are whole, and a to e are convex and
                                        // counter-clockwise
  double ends_wrong, edge_tests_wrong;  // goals of questions: methods 4 and 1 are wrong here
};

namespace {

std::array<Point, count> vertices_of(const Input& in) {
  return {in.a, in.b, in.c, in.d, in.e, in.f, in.g, in.h};
}

/// The outline, and the hole if there is one, with the ends of all edges. The hole goes round the
/// other way, so that winding numbers and the methods' sums can be added up.
template <class S>
struct Shape {
  contact::PolygonWithHoles<S> polygon;
  std::array<std::size_t, count> from{}, to{};
};

template <class S>
Shape<S> joined(const std::array<Point, count>& vertices, double how) {
  Shape<S> shape;
  const auto outline = [&](std::size_t edge, std::vector<std::size_t> order) {
    contact::Polygon<S> polygon;
    for (std::size_t i = 0; i < order.size(); ++i) {
      shape.from[edge + i] = order[i];
      shape.to[edge + i] = order[(i + 1) % order.size()];
      polygon.push_back(vertices[order[i]].cast<S>());
    }
    return polygon;
  };
  if (how == 1) {
    shape.polygon.outer = outline(0, {0, 3, 6, 1, 4, 7, 2, 5});
  } else if (how == 2) {
    shape.polygon.outer = outline(0, {0, 1, 2, 3, 4});
    contact::Polygon<S> hole = outline(5, {5, 6, 7});
    if (contact::area_sign(hole) == contact::area_sign(shape.polygon.outer))
      hole = outline(5, {7, 6, 5});
    shape.polygon.holes.push_back(hole);
  } else {
    shape.polygon.outer = outline(0, {0, 1, 2, 3, 4, 5, 6, 7});
  }
  return shape;
}

/// `contact::angle_sum`'s angle of one edge, with an arc tangent that is the same on every machine.
template <class S>
S angle(const contact::Vector2<S>& to_a, const contact::Vector2<S>& to_b) {
  const S across = contact::cross2<S>(to_a, to_b);
  const S size = S(contact::portable_angle(double(std::abs(across)), double(to_a.dot(to_b))));
  return across < 0 ? -size : size;
}

template <class S>
S sum_of_angles(const contact::Polygon<S>& polygon, const contact::Vector2<S>& p) {
  S sum = S(0);
  contact::for_each_edge(polygon,
                         [&](const auto& a, const auto& b) { sum += angle<S>(a - p, b - p); });
  return sum;
}

/// Counter-clockwise, as the edge tests expect it.
template <class S>
contact::Polygon<S> counter_clockwise(const contact::Polygon<S>& polygon) {
  return contact::area_sign(polygon) < 0 ? contact::reversed(polygon) : polygon;
}

/// What a method says of one closed outline.
template <class S>
Where ask(int method, const contact::Polygon<S>& polygon, const contact::Vector2<S>& p, Rule rule) {
  switch (method) {
    case 1:
      return contact::where_by_edges(counter_clockwise(polygon), p);
    case 2:
      return std::abs(sum_of_angles(polygon, p)) > std::numbers::pi_v<S> ? Where::inside
                                                                         : Where::outside;
    case 3:
      return contact::where_by_quadrants(polygon, p);
    case 4:
      return contact::where_by_crossings_with_ends(polygon, p);
    case 5:
      return contact::where_by_crossings(polygon, p);
    case 6:
      return contact::where_by_scanline(polygon, p, rule);
    default:
      return contact::where(polygon, p, rule);
  }
}

/// The same of a polygon with holes: inside of the outer polygon and of no hole.
template <class S>
Where ask(int method, const contact::PolygonWithHoles<S>& polygon, const contact::Vector2<S>& p,
          Rule rule) {
  if (method == 0) return contact::where(polygon, p, rule);
  Where answer = ask(method, polygon.outer, p, rule);
  for (const auto& hole : polygon.holes) {
    if (answer != Where::inside) break;
    const Where in_hole = ask(method, hole, p, rule);
    if (in_hole != Where::outside) answer = in_hole == Where::on ? Where::on : Where::outside;
  }
  return answer;
}

/// Angles and quadrants have the non-zero rule, crossings the even-odd rule.
Rule rule_of(int method, Rule chosen) {
  return method == 2 || method == 3   ? Rule::non_zero
         : method == 4 || method == 5 ? Rule::even_odd
                                      : chosen;
}

bool two_answers(int method) { return method >= 2; }

bool is_wrong(int method, Where said, Where truth) {
  return said != truth && !(two_answers(method) && truth == Where::on);
}

struct Edge {
  double part = 0;  // what it adds to the method's sum
  bool crosses = false;
  double crossing = 0;
};

/// What a method sees of the edge from a to b. An edge alone is a polygon that goes there and back.
template <class S>
Edge part_of(int method, const contact::Vector2<S>& a, const contact::Vector2<S>& b,
             const contact::Vector2<S>& p, double orientation) {
  if (method == 1) {
    const S side = S(orientation) * contact::orientation<S>(a, b, p);
    return {side > 0 ? 1.0 : side < 0 ? -1.0 : 0.0};
  }
  if (method == 2) return {double(angle<S>(a - p, b - p))};
  if (method == 3) {
    // As `quadrant_sum`.
    const auto quadrant = [&p](const contact::Vector2<S>& v) {
      return v.y() >= p.y() ? (v.x() >= p.x() ? 0 : 1) : (v.x() < p.x() ? 2 : 3);
    };
    const int change = (quadrant(b) - quadrant(a) + 4) % 4;
    if (change == 2) return {contact::cross2<S>(a - p, b - p) > S(0) ? 2.0 : -2.0};
    return {change == 3 ? -1.0 : double(change)};
  }
  Edge edge;
  if (method == 4) {
    // As `crossings_with_ends`.
    edge.crosses =
        a.y() != b.y() && std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
    if (edge.crosses)
      edge.crossing = double(a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    edge.part = edge.crosses && edge.crossing > double(p.x()) ? 1 : 0;
    return edge;
  }
  const auto there_and_back = contact::scanline<S>({a, b}, p.y());
  if (there_and_back.empty()) return edge;
  edge.crosses = true;
  edge.crossing = double(there_and_back.front().x);
  for (const auto& crossing : there_and_back) {
    if (crossing.step == (b.y() > a.y() ? 1 : -1)) edge.crossing = double(crossing.x);
  }
  if (double(p.x()) < edge.crossing) edge.part = method == 5 || b.y() > a.y() ? 1 : -1;
  return edge;
}

template <class S>
void compute_in(const Input& in, Output& out) {
  const auto vertices = vertices_of(in);
  const Shape<S> shape = joined<S>(vertices, in.joined);
  const contact::Vector2<S> p = in.p.cast<S>();
  const Rule rule = in.rule == 1 ? Rule::non_zero : Rule::even_odd;
  const int method = in.method >= 0 && in.method < methods ? static_cast<int>(in.method) : 0;
  const auto number = [](Where where) { return double(static_cast<int>(where)); };

  out.where = number(contact::where(shape.polygon, p, rule));
  for (int m = 0; m < methods; ++m) {
    const Where said = ask(m, shape.polygon, p, rule);
    const Where truth = contact::where(shape.polygon, p, rule_of(m, rule));
    out.says[static_cast<std::size_t>(m)] = number(said);
    out.wrong[static_cast<std::size_t>(m)] = is_wrong(m, said, truth) ? 1 : 0;
  }
  out.edge_tests_wrong = out.wrong[1];
  out.ends_wrong = out.wrong[4];

  const auto add = [&](const contact::Polygon<S>& outline) {
    out.winding += contact::winding_number(outline, p).value_or(0);
    out.sum[2] += double(sum_of_angles(outline, p));
    out.sum[3] += contact::quadrant_sum(outline, p);
    out.sum[4] += contact::crossings_with_ends(outline, p);
    out.sum[5] += contact::crossings(outline, p);
  };
  add(shape.polygon.outer);
  for (const auto& hole : shape.polygon.holes) add(hole);
  out.sum[0] = out.winding;

  const double turn = contact::area_sign(shape.polygon.outer) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < count; ++i) {
    out.from[i] = double(shape.from[i]);
    out.to[i] = double(shape.to[i]);
    const contact::Vector2<S> a = vertices[shape.from[i]].template cast<S>();
    const contact::Vector2<S> b = vertices[shape.to[i]].template cast<S>();
    const Edge edge = part_of<S>(method, a, b, p, turn);
    out.part[i] = edge.part;
    out.crosses[i] = edge.crosses ? 1 : 0;
    out.crossing[i] = edge.crossing;
    if (part_of<S>(1, a, b, p, turn).part > 0) ++out.sum[1];
    out.sum[6] += part_of<S>(6, a, b, p, turn).part;
  }

  for (int row = 0; row < rows + count; ++row) {
    const double y =
        row < rows ? 0.25 * (row - rows / 2) : vertices[static_cast<std::size_t>(row - rows)].y();
    for (int column = 0; column < columns; ++column) {
      const auto q = Point(0.25 * (column - columns / 2), y).cast<S>().eval();
      const Where truth = contact::where(shape.polygon, q, rule_of(method, rule));
      const auto cell = static_cast<std::size_t>(row * columns + column);
      out.inside[cell] = truth == Where::inside ? 1 : 0;
      out.missed[cell] = is_wrong(method, ask<S>(method, shape.polygon, q, rule), truth) ? 1 : 0;
      out.grid_wrong += out.missed[cell];
    }
  }
}

void compute_in_order(const Input& in, Output& out) {
  const auto vertices = vertices_of(in);
  const auto whole = [](const Point& p) {
    return (8 * p).eval() == (8 * p).array().round().matrix();
  };
  const contact::Polygon<double> all(vertices.begin(), vertices.end());
  const contact::Polygon<double> pentagon(vertices.begin(), vertices.begin() + 5);
  const Where where = contact::where(all, in.p);
  out.inside_in_order = where == Where::inside ? 1 : 0;
  out.in_order_clear =
      where != Where::on && whole(in.p) && std::all_of(all.begin(), all.end(), whole) ? 1 : 0;
  out.where_in_pentagon = double(static_cast<int>(contact::where(pentagon, in.p)));
  out.pentagon_clear = contact::is_convex(pentagon) && contact::area_sign(pentagon) > 0 &&
                               whole(in.p) && std::all_of(pentagon.begin(), pentagon.end(), whole)
                           ? 1
                           : 0;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.a, &in.b, &in.c, &in.d, &in.e, &in.f, &in.g, &in.h, &in.p}) {
    if (v->cwiseAbs().maxCoeff() > (in.single == 1 ? 1e15 : 1e100))
      out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;
  in.single == 1 ? compute_in<float>(in, out) : compute_in<double>(in, out);
  compute_in_order(in, out);
  return out;
}

FIGURE(Input, FIELDS(a, b, c, d, e, f, g, h, p, method, joined, rule, single), Output,
       FIELDS(problem, from, to, where, says, wrong, winding, sum, part, crosses, crossing, inside,
              missed, grid_wrong, inside_in_order, in_order_clear, where_in_pentagon,
              pentagon_clear, ends_wrong, edge_tests_wrong))
