// Right answers come from exact arithmetic on the numbers as they are stored: only normals and
// distances take a square root, at the end. The first questions of a test each bring one mistake to
// light that no question before did.
#include "manifold_2d.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

#include <18_contacts/manifold_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::ContactPoint;
using exercise::Manifold;
using exercise::Polygon;
using manifold_with_mistakes::Way;
using Vector = Eigen::Vector2d;

// ---------------------------------------------------------------- what is right

struct ExactVector {
  Exact x, y;
  explicit ExactVector(const Vector& v) : x(v.x()), y(v.y()) {}
  ExactVector(Exact a, Exact b) : x(std::move(a)), y(std::move(b)) {}
  Exact dot(const ExactVector& v) const { return x * v.x + y * v.y; }
  ExactVector operator-(const ExactVector& v) const { return {x - v.x, y - v.y}; }
};

/// An edge with the outward normal, which is as long as the edge.
struct ExactEdge {
  ExactVector start, end, along, normal;
  ExactEdge(const Polygon& polygon, std::size_t k)
      : start(polygon[k]),
        end(polygon[(k + 1) % polygon.size()]),
        along(end - start),
        normal(along.y, Exact(0.0) - along.x) {}
  Exact square() const { return along.dot(along); }
};

/// A number over the root of another one, which is greater than 0.
struct OverRoot {
  Exact number, square;
  double value() const {
    return quotient<double>(number, Exact(1.0)) / std::sqrt(quotient<double>(square, Exact(1.0)));
  }
};

/// The sign of the difference of two such numbers, from their signed squares.
int compare(const OverRoot& a, const OverRoot& b) {
  return (a.number * abs(a.number) * b.square - b.number * abs(b.number) * a.square).sign();
}

/// Remembers the closest decision, as a difference of two lengths or cosines.
struct Course {
  Manifold manifold;
  double nearest = 1;
  void decided(const OverRoot& a, const OverRoot& b) {
    nearest = std::min(nearest, std::abs(a.value() - b.value()));
  }
};

OverRoot exact_separation(const ExactEdge& edge, const Polygon& other) {
  Exact nearest = edge.normal.dot(ExactVector(other[0]) - edge.start);
  for (const Vector& vertex : other)
    nearest = std::min(nearest, edge.normal.dot(ExactVector(vertex) - edge.start));
  return {nearest, edge.square()};
}

Course right_course(const Polygon& a, const Polygon& b, double margin) {
  Course course;
  // All edges, those of a first.
  std::vector<ExactEdge> edges;
  std::vector<OverRoot> separations;
  for (const auto& [polygon, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (std::size_t k = 0; k < polygon->size(); ++k) {
      edges.emplace_back(*polygon, k);
      separations.push_back(exact_separation(edges.back(), *other));
    }
  }
  std::size_t best = 0;
  for (std::size_t k = 1; k < edges.size(); ++k)
    if (compare(separations[k], separations[best]) > 0) best = k;
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (k != best) course.decided(separations[best], separations[k]);
  const bool on_a = best < a.size();
  const ExactEdge& reference = edges[best];
  const Exact square = reference.square(), zero(0.0), two(2.0);
  // The cosines of the other polygon's normals, times the length of the reference edge.
  const std::size_t begin = on_a ? a.size() : 0, end = on_a ? edges.size() : a.size();
  const auto cosine = [&](std::size_t k) {
    return OverRoot{reference.normal.dot(edges[k].normal), edges[k].square() * square};
  };
  std::size_t incident = begin;
  for (std::size_t k = begin; k < end; ++k)
    if (compare(cosine(k), cosine(incident)) < 0) incident = k;
  for (std::size_t k = begin; k < end; ++k)
    if (k != incident) course.decided(cosine(incident), cosine(k));
  course.nearest = std::min(course.nearest, -cosine(incident).value() / 4);
  // The incident edge runs against the reference edge, so its end comes first along that.
  const ExactVector &from = edges[incident].end, &to = edges[incident].start;
  const Exact first = reference.along.dot(from - reference.start);
  const Exact last = reference.along.dot(to - reference.start), width = last - first;
  const double sign = on_a ? -1 : 1;
  const double length = std::sqrt(rounded<double>(square));
  const Vector outward{rounded<double>(reference.normal.x) / length,
                       rounded<double>(reference.normal.y) / length};
  course.manifold.normal = outward * sign;
  for (const Exact& x : {first, last})
    for (const Exact& y : {zero, square}) course.decided({x, square}, {y, square});
  if (last < zero || first > square) return course;
  const Exact from_height = reference.normal.dot(from - reference.start);
  const Exact to_height = reference.normal.dot(to - reference.start);
  const Exact begins = std::max(first, zero), ends = std::min(last, square);
  for (const Exact& t : {begins, ends}) {
    // Over `width`: the point at t, and its height times the length of the reference edge.
    const Exact p = last - t, q = t - first;
    const Exact height = from_height * p + to_height * q;
    const OverRoot distance{height, square * width * width};
    const OverRoot limit{Exact(margin), Exact(1.0)};
    course.decided(distance, limit);
    if (compare(distance, limit) > 0) continue;
    const Exact under = two * square * width;
    const auto middle = [&](const Exact& f, const Exact& g, const Exact& normal) {
      return quotient<double>(two * square * (f * p + g * q) - normal * height, under);
    };
    course.manifold.points.push_back(
        {{middle(from.x, to.x, reference.normal.x), middle(from.y, to.y, reference.normal.y)},
         distance.value()});
    if (begins == ends) break;
  }
  return course;
}

/// Whether the points are right and the normal is the opposite one.
bool is_reversed(const Manifold& got, const Manifold& right) {
  const auto same = [](const ContactPoint& one, const ContactPoint& other) {
    return (one.point - other.point).norm() <= 1e-6 &&
           std::abs(one.distance - other.distance) <= 1e-6;
  };
  return (got.normal + right.normal).norm() <= 1e-6 &&
         std::equal(got.points.begin(), got.points.end(), right.points.begin(), right.points.end(),
                    same);
}

// ---------------------------------------------------------------- questions

void check(const Polygon& a, const Polygon& b, double margin) {
  const Manifold right = right_course(a, b, margin).manifold;
  std::vector<Suspect<Manifold>> suspects;
  const auto suspect = [&](std::string_view id, Way way) {
    suspects.push_back(
        {id, [&, way] { return manifold_with_mistakes::contact_manifold(a, b, margin, way); }});
  };
  suspect("reference-edge-of-a-alone", Way::only_a);
  suspect("reference-edge-of-smallest-separation", Way::deepest_edge);
  suspect("separation-of-the-farthest-vertex", Way::farthest_vertex);
  suspect("edges-taken-clockwise", Way::clockwise);
  suspect("normals-as-long-as-the-edges", Way::not_unit);
  suspects.push_back({"manifold-normal-from-a-to-b",
                      [&](const Manifold& got) { return is_reversed(got, right); }});
  suspect("incident-edge-faces-the-same-way", Way::incident_alike);
  suspect("incident-edge-after-the-nearest-vertex", Way::incident_at_vertex);
  suspect("incident-edge-not-clipped", Way::not_clipped);
  suspect("incident-edge-clipped-at-one-end", Way::one_end);
  suspect("incident-edge-stretched", Way::stretched);
  suspect("margin-left-out", Way::no_margin);
  suspect("points-beyond-the-margin", Way::all_points);
  suspect("margin-excluded", Way::strict);
  suspect("penetration-for-the-distance", Way::depth);
  suspect("contact-points-on-the-incident-edge", Way::on_incident);
  suspect("contact-points-on-the-reference-edge", Way::on_reference);
  suspect("deepest-point-alone", Way::deepest);
  suspect("mean-of-the-contact-points", Way::mean);
  suspect("contact-points-in-the-other-order", Way::other_order);
  suspect("single-contact-twice", Way::twice);
  double size = 1;
  for (const Polygon* polygon : {&a, &b})
    for (const Vector& vertex : *polygon) size = std::max(size, vertex.cwiseAbs().maxCoeff());
  // Some 30 roundings of numbers of this size; the cosine of the edges' angle is at least 4e-6, and
  // errors along the incident edge grow by its inverse.
  ask("What are the contact points of the polygons?")
      .given("a", a)
      .given("b", b)
      .given("margin", margin)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::contact_manifold(a, b, margin); })
      .close_to(right, within(1e-9 * size));
}

bool is_convex(const Polygon& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector &p = polygon[k], &q = polygon[(k + 1) % polygon.size()],
                 &r = polygon[(k + 2) % polygon.size()];
    const Vector u = q - p, v = r - q;
    if (!(u.x() * v.y() - u.y() * v.x() > 1e-3)) return false;
    if (p.cwiseAbs().maxCoeff() > 10) return false;
  }
  // Turning left at each vertex, and once in all: every vertex is to the left of every edge.
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    for (const Vector& r : polygon)
      if ((q - p).x() * (r - p).y() - (q - p).y() * (r - p).x() < -1e-12) return false;
  }
  return polygon.size() >= 3;
}

/// Whether rounding changes no decision.
bool is_clear(const Polygon& a, const Polygon& b, double margin) {
  if (margin < 0 || margin > 10 || !is_convex(a) || !is_convex(b)) return false;
  return right_course(a, b, margin).nearest >= 1e-6;
}

Polygon box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

const Polygon kGround = box(-4, -2, 4, 0);

}  // namespace

TEST_CASE("a box lies on a wide one") {
  check(box(-1, -0.25, 2, 1), kGround, 0);
  check(kGround, box(-1, -0.25, 2, 1), 0);
  check({{2, 1}, {-1, 1}, {-1, -0.25}, {2, -0.25}}, kGround, 0.5);
}

TEST_CASE("the edges overlap in part") {
  check(box(2, -0.5, 6, 1), kGround, 0);
  check(box(-6, -0.5, -3, 1), kGround, 0);
  check(box(3, -1, 7, 5), box(-1, 0, 3.5, 4), 0.25);
}

TEST_CASE("a box that stands on a vertex has one contact point") {
  check({{0, -0.25}, {4, 2.75}, {1, 6.75}, {-3, 3.75}}, kGround, 0.125);
  check(kGround, {{1, -0.5}, {3, 1}, {1.5, 3}, {-0.5, 1.5}}, 0.25);
  check({{1, 0.25}, {2, 3}, {-2, 0.5}}, kGround, 0.375);
}

TEST_CASE("the margin decides for each point") {
  check({{-1, -0.125}, {1, 0.125}, {0, 3}}, kGround, 0.25);
  check({{1, 0.25}, {2, 3}, {-2, 0.5}}, kGround, 0.625);
  check(box(-1, 0.25, 1, 2), kGround, 0.25);
  check(box(-1, 0.25, 1, 2), kGround, 0.125);
  check({{-1, 0}, {1, 0.5}, {0, 3}}, kGround, 0);
  check({{0, -0.25}, {1, 0.75}, {0, 1.75}, {-1, 0.75}}, kGround, 1);
}

TEST_CASE("boxes that meet at a vertex") {
  check(box(0, 0, 1, 1), box(1, -1, 2, 0), 0);
  check(box(0, 0, 1, 1), box(1.5, -1.25, 3, -0.25), 1);
  check(box(0, 0, 1, 1), box(1.5, -1, 3, 0), 1);
  check(box(0, 0, 1, 1), box(1.5, -0.5, 3, -0.125), 1);
  check(box(0, 0, 1, 1), box(1.5, 1.125, 3, 1.5), 1);
}

TEST_CASE("random polygons agree with exact arithmetic") {
  generators::Random random(seed(0));
  // One or two points in each quadrant of a circle, by the tangent of half the angle.
  const auto polygon = [&](const Vector& centre, double radius) {
    Polygon made;
    for (int quadrant = 0; quadrant < 4; ++quadrant) {
      const double first = random.uniform(0, 0.4), second = random.uniform(0.6, 0.9);
      const bool both = random.chance(0.3);
      for (const double t : {first, second}) {
        if (!both && t == first) continue;
        Vector p = Vector(1 - t * t, 2 * t) / (1 + t * t);
        for (int turn = 0; turn < quadrant; ++turn) p = Vector(-p.y(), p.x());
        made.push_back(centre + p * radius);
      }
    }
    return made;
  };
  for (int asked = 0; asked < 60;) {
    const Polygon a = polygon({0, 0}, random.uniform(0.5, 2));
    const Vector offset{random.uniform(-3, 3), random.uniform(-3, 3)};
    const Polygon b = polygon(offset, random.uniform(0.5, 2));
    const double margin = random.uniform(0, 0.5);
    if (!is_clear(a, b, margin)) continue;
    ++asked;
    shrinkable(check, is_clear, a, b, margin);
  }
}
