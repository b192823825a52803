// Two bodies in the plane and a bounding volume of each: which kinds of volumes say that the bodies
// are apart, whether they are, and how often each kind is wrong at random positions.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/carried_volumes.hpp>
#include <contact/figure.hpp>
#include <contact/hull_2d.hpp>
#include <contact/perimeter.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/slab_volumes.hpp>
#include <contact/smallest_circle.hpp>
#include <contact/volumes_meet.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;
using Polygon = contact::Polygon<double>;
using Frame = contact::CoordinateFrame<double>;

struct Input {
  Point a, b;               // positions of the bodies, m
  Point turn_a, turn_b;     // the direction of each body's x axis, of any length
  double shape_a, shape_b;  // 0 star, 1 rod, 2 L, 3 disc
  double kind;              // of the volumes that are drawn: 0 circle, 1 AABB, 2 the object's box,
                            // 3 8-DOP, 4 hull
  double positions;         // how many random ones are tested, at most 1,000
  double drawn;             // which ones: another number, other positions
};

constexpr std::size_t shapes = 4, kinds = 5, max_vertices = 12, max_corners = 12;

struct Output {
  double problem;
  // Of each body:
  std::array<double, 2> vertices;
  std::array<std::array<Point, max_vertices>, 2> vertex;
  // Its volume of the chosen kind: a circle, or the vertices of a polygon.
  std::array<double, 2> corners;
  std::array<std::array<Point, max_corners>, 2> corner;
  std::array<Point, 2> centre;
  std::array<double, 2> radius;
  double meet;                     // 1 if the bodies meet, exactly
  std::array<double, kinds> says;  // 1: may meet
  std::array<double, kinds> wrong;
  double wrong_count;
  // At the random positions: how often the bodies meet, and how often the volumes do; the rest of
  // these are wrong.
  double tested, tested_meet;
  std::array<double, kinds> tested_says, tested_wrong;
  // Goals of questions.
  double hulls_wrong;         // hulls meet and the bodies do not
  double circles_better;      // circles say apart, and AABBs may meet
  double only_circles_wrong;  // of the volumes, only the circles meet
};

namespace {

/// A body in its own frame, counter-clockwise, with the volumes that it carries along.
struct Body {
  Polygon outline;
  contact::Sphere<double> circle;
  contact::Aabb<double> box;
};

Point on_circle(double radius, int i, int n) {
  const auto [sine, cosine] = contact::sine_cosine(6.283185307179586 * i / n);
  return {radius * cosine, radius * sine};
}

Polygon outline_of(std::size_t shape) {
  Polygon outline;
  switch (shape) {
    case 1:
      return {{-1.375, -0.125}, {1.375, -0.125}, {1.375, 0.125}, {-1.375, 0.125}};
    case 2:
      return {{-0.75, -1}, {0.75, -1}, {0.75, -0.625}, {-0.375, -0.625}, {-0.375, 1}, {-0.75, 1}};
    case 3:
      for (int i = 0; i < 12; ++i) outline.push_back(on_circle(0.875, i, 12));
      return outline;
    default:
      for (int i = 0; i < 10; ++i) outline.push_back(on_circle(i % 2 == 0 ? 1.25 : 0.5, i, 10));
      return outline;
  }
}

/// In space the bodies are prisms from z = −1 to 1, and a circle is a sphere around the outline.
std::vector<Vector> in_space(const Polygon& outline) {
  std::vector<Vector> points;
  for (const Point& p : outline) points.push_back({p.x(), p.y(), 0});
  return points;
}

const Body& body(double number) {
  static const std::array<Body, shapes> bodies = [] {
    std::array<Body, shapes> made;
    for (std::size_t i = 0; i < shapes; ++i) {
      made[i].outline = outline_of(i);
      const auto circle = contact::smallest_circle<double>(made[i].outline).circle;
      made[i].circle = {{circle.centre.x(), circle.centre.y(), 0}, circle.radius};
      const std::vector<Vector> points = in_space(made[i].outline);
      made[i].box = contact::aabb_of_points<double>(points);
      made[i].box.low.z() = -1;
      made[i].box.high.z() = 1;
    }
    return made;
  }();
  return bodies[number >= 1 && number < double(shapes) ? static_cast<std::size_t>(number) : 0];
}

/// A body where it is now, with its volumes: the circle and the object's box are carried along, the
/// others are made again from the vertices.
struct Placed {
  Polygon outline, hull;
  contact::Sphere<double> circle;
  contact::Aabb<double> aabb;
  contact::OrientedBox<double> box;
  contact::Kdop<double> dop;
};

Placed placed(const Body& body, const Point& at, const Point& direction) {
  const Point along = direction / std::sqrt(direction.squaredNorm());
  Frame frame;
  frame.origin = {at.x(), at.y(), 0};
  frame.axes.col(0) = Vector(along.x(), along.y(), 0);
  frame.axes.col(1) = Vector(-along.y(), along.x(), 0);
  Placed result;
  std::vector<Vector> points;
  for (const Point& p : body.outline) {
    points.push_back(contact::position_in_world(frame, Vector(p.x(), p.y(), 0)));
    result.outline.push_back(points.back().head<2>());
  }
  for (const int i : contact::convex_hull_2d(result.outline))
    result.hull.push_back(result.outline[static_cast<std::size_t>(i)]);
  result.circle = contact::carried(body.circle, frame);
  result.aabb = contact::aabb_of_points<double>(points);
  result.box = contact::carried(body.box, frame);
  static const std::vector<Vector> normals = contact::plane_dop_normals<double>(8);
  result.dop = contact::kdop_of_points<double>(normals, points);
  return result;
}

struct Answers {
  std::array<bool, kinds> says;
  bool meet;
};

// [five-kinds]
Answers compare(const Placed& a, const Placed& b) {
  return {{contact::may_meet(a.circle, b.circle), contact::may_meet(a.aabb, b.aabb),
           contact::may_meet(a.box, b.box), contact::may_meet(a.dop, b.dop),
           contact::polygons_meet(a.hull, b.hull)},
          contact::polygons_meet(a.outline, b.outline)};
}
// [/five-kinds]

/// Numbers with the same bits on every machine: Knuth's 64-bit linear congruential generator.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  /// In [−1, 1).
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return double(state_ >> 32U) / 2147483648.0 - 1;
  }
  /// A random direction: points in the unit disc, not too near its centre.
  Point direction() {
    for (;;) {
      const double x = next();
      const double y = next();
      const double square = x * x + y * y;
      if (square > 0.01 && square <= 1) return {x, y};
    }
  }

 private:
  std::uint64_t state_;
};

struct Tested {
  double shape_a = -1, shape_b = -1, positions = -1, drawn = -1;
  double meet = 0;
  std::array<double, kinds> says{}, wrong{};
};

/// B at random positions in a square around A, twice as wide as the two circles together, and both
/// in random directions. Further away no circles meet.
Tested test_positions(const Input& in, double positions) {
  Tested result{in.shape_a, in.shape_b, positions, in.drawn, 0, {}, {}};
  const Body &a = body(in.shape_a), &b = body(in.shape_b);
  const double far = a.circle.radius + b.circle.radius;
  Numbers numbers(static_cast<std::uint64_t>(std::clamp(in.drawn, 0.0, 1e6)));
  for (int i = 0; i < static_cast<int>(positions); ++i) {
    const Point turn_a = numbers.direction(), turn_b = numbers.direction();
    const double x = far * numbers.next();
    const double y = far * numbers.next();
    const Answers found = compare(placed(a, {0, 0}, turn_a), placed(b, {x, y}, turn_b));
    result.meet += found.meet ? 1 : 0;
    for (std::size_t k = 0; k < kinds; ++k) {
      result.says[k] += found.says[k] ? 1 : 0;
      result.wrong[k] += found.says[k] != found.meet ? 1 : 0;
    }
  }
  return result;
}

/// The same for the same bodies and positions, while a body is dragged.
const Tested& tested(const Input& in, double positions) {
  static Tested last;
  if (last.shape_a != in.shape_a || last.shape_b != in.shape_b || last.positions != positions ||
      last.drawn != in.drawn)
    last = test_positions(in, positions);
  return last;
}

void list_polygon(const Polygon& polygon, std::size_t which, Output& out) {
  out.corners[which] = double(polygon.size());
  std::copy(polygon.begin(), polygon.end(), out.corner[which].begin());
}

/// What is drawn of one body.
void draw(const Placed& body, double kind, std::size_t which, Output& out) {
  out.vertices[which] = double(body.outline.size());
  std::copy(body.outline.begin(), body.outline.end(), out.vertex[which].begin());
  const auto corner = [](const Vector& v) -> Point { return v.head<2>(); };
  if (kind == 1) {
    const Point low = corner(body.aabb.low), high = corner(body.aabb.high);
    list_polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, which, out);
  } else if (kind == 2) {
    Polygon corners;
    for (const int k : {0, 1, 3, 2}) corners.push_back(corner(contact::box_corner(body.box, k)));
    list_polygon(corners, which, out);
  } else if (kind == 3) {
    list_polygon(contact::plane_dop_vertices(body.dop), which, out);
  } else if (kind == 4) {
    list_polygon(body.hull, which, out);
  } else {
    out.centre[which] = corner(body.circle.centre);
    out.radius[which] = body.circle.radius;
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const Point* p : {&in.a, &in.b, &in.turn_a, &in.turn_b}) {
    if (p->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  for (const Point* turn : {&in.turn_a, &in.turn_b}) {
    if (!(turn->cwiseAbs().maxCoeff() > 1e-100)) out.problem = contact::figure::zero_direction;
  }
  if (out.problem != 0) return out;

  const Placed a = placed(body(in.shape_a), in.a, in.turn_a);
  const Placed b = placed(body(in.shape_b), in.b, in.turn_b);
  draw(a, in.kind, 0, out);
  draw(b, in.kind, 1, out);
  const Answers found = compare(a, b);
  out.meet = found.meet ? 1 : 0;
  for (std::size_t k = 0; k < kinds; ++k) {
    out.says[k] = found.says[k] ? 1 : 0;
    out.wrong[k] = found.says[k] != found.meet ? 1 : 0;
    out.wrong_count += out.wrong[k];
  }
  const double apart =
      kinds - (out.says[0] + out.says[1] + out.says[2] + out.says[3] + out.says[4]);
  out.hulls_wrong = out.wrong[4];
  out.only_circles_wrong = out.says[0] == 1 && apart == kinds - 1 ? 1 : 0;
  out.circles_better = out.says[0] == 0 && out.says[1] == 1 ? 1 : 0;

  out.tested = std::floor(std::clamp(in.positions, 0.0, 1000.0));
  const Tested& often = tested(in, out.tested);
  out.tested_meet = often.meet;
  out.tested_says = often.says;
  out.tested_wrong = often.wrong;
  return out;
}

FIGURE(Input, FIELDS(a, b, turn_a, turn_b, shape_a, shape_b, kind, positions, drawn), Output,
       FIELDS(problem, vertices, vertex, corners, corner, centre, radius, meet, says, wrong,
              wrong_count, tested, tested_meet, tested_says, tested_wrong, hulls_wrong,
              circles_better, only_circles_wrong))
