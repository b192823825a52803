#include "support/questions.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/approach.hpp>
#include <contact/box_axes.hpp>
#include <contact/certificates.hpp>
#include <contact/convex_bodies.hpp>
#include <contact/figure.hpp>
#include <contact/gjk.hpp>
#include <contact/proximity.hpp>
#include <contact/signed_distance.hpp>
#include <contact/support.hpp>
#include <vector>

namespace two_hulls_figure {
#include "figures/two_hulls.cpp"
}

namespace questions_test {

namespace {

using contact::OrientedBox;
using contact::Proximity;
using contact::Vector3;

Vector3<double> at(double x, double y, double z) { return {x, y, z}; }

OrientedBox<double> box(const Vector3<double>& centre, const Vector3<double>& half_lengths) {
  OrientedBox<double> made;
  made.centre = centre;
  made.half_lengths = half_lengths;
  return made;
}

/// How far a body reaches along n.
template <class Body>
double reach(const Body& body, const Vector3<double>& n) {
  return contact::support(body, n).dot(n) + contact::radius_of(body) * n.norm();
}

}  // namespace

KEY("interlocked") {
  // Two links of a chain, each made of four bars around a hole: one in the xy plane, one in xz.
  std::vector<OrientedBox<double>> one, other;
  for (const double side : {-1.0, 1.0}) {
    one.push_back(box(at(2 * side, 0, 0), at(0.2, 1.2, 0.2)));
    one.push_back(box(at(0, side, 0), at(2.2, 0.2, 0.2)));
    other.push_back(box(at(2 + 2 * side, 0, 0), at(0.2, 0.2, 1.2)));
    other.push_back(box(at(2, 0, side), at(2.2, 0.2, 0.2)));
  }
  other[0].centre.x() = 0.5;
  bool meet = false;
  for (const auto& a : one) {
    for (const auto& b : other) meet = meet || contact::proximity(a, b) != Proximity::disjoint;
  }
  // The hulls of the links overlap, so no plane separates the links.
  const bool hulls_overlap =
      contact::proximity(box(at(0, 0, 0), at(2.2, 1.2, 0.2)),
                         box(at(2.35, 0, 0), at(2, 0.2, 1.2))) == Proximity::overlapping;
  CHECK(hulls_overlap);
  return meet ? 0 : 1;
}

KEY("three-motions") {
  const auto along = [](const Vector3<double>& a, const Vector3<double>& b) {
    return at(1, 0, 0).dot(Vector3<double>(a - b));
  };
  using contact::Motion;
  const auto motion = [](const Vector3<double>& a, const Vector3<double>& b) {
    return contact::motion_in_contact(at(1, 0, 0), a, b);
  };
  CHECK(motion(at(1, 0, 0), at(3, 0, 0)) == Motion::colliding);
  CHECK(motion(at(2, 5, 0), at(2, -1, 0)) == Motion::resting);
  CHECK(motion(at(0, 0, 4), at(-1, 0, 0)) == Motion::separating);
  return questions::Gaps{{"colliding", along(at(1, 0, 0), at(3, 0, 0))},
                         {"resting", along(at(2, 5, 0), at(2, -1, 0))},
                         {"separating", along(at(0, 0, 4), at(-1, 0, 0))}};
}

KEY("support-of-a-capsule") {
  return reach(contact::Capsule<double>{{at(0, 0, 0), at(2, 0, 0)}, 0.5}, at(0.6, 0.8, 0));
}

KEY("support-of-an-ellipsoid") {
  const auto ellipsoid = contact::ellipsoid_from_axes<double>(
      at(0, 0, 0), contact::Matrix3<double>::Identity(), at(2, 1, 1));
  return reach(ellipsoid, at(0.6, 0.8, 0));
}

KEY("zero-axes") {
  const auto a = box(at(0, 0, 0), at(1, 1, 1)), b = box(at(5, 1, 2), at(2, 1, 3));
  int zeros = 0;
  for (int k = 0; k < contact::box_axis_count; ++k) {
    if (contact::box_axis(a, b, k) == Vector3<double>::Zero()) ++zeros;
  }
  return static_cast<double>(zeros);
}

KEY("only-the-faces") {
  // Edge against edge, 0.1 m apart along (1, 1, 0).
  const double h = std::sqrt(0.5);
  const auto a = box(at(0, 0, 0), at(1, 1, 1));
  auto b = box(at(h, h, 0) * (2 * std::sqrt(2.0) + 0.1), at(1, 1, 1));
  b.axes << h, 0.5, 0.5, -h, 0.5, 0.5, 0, h, -h;
  for (int k = 0; k < 6; ++k) {
    CHECK(contact::separation_along<double>(a, b, contact::box_axis(a, b, k)) < 0);
  }
  return contact::proximity(a, b) == Proximity::disjoint ? 1 : 0;
}

KEY("difference-of-squares") {
  const auto a = box(at(3, 1, 0), at(1, 1, 1)), b = box(at(-2, 5, 0), at(0.5, 0.5, 1));
  const auto width = [&](const Vector3<double>& n) {
    return reach(a, n) + reach(b, -n) + reach(a, -n) + reach(b, n);
  };
  return width(at(1, 0, 0)) * width(at(0, 1, 0));
}

KEY("lower-bound") {
  contact::ConvexHull<double> differences;
  differences.vertices = {at(4, 3, 0), at(4, -3, 0), at(1, 5, 0)};
  const Vector3<double> v = at(4, 0, 0);
  const Vector3<double> w = contact::support(differences, Vector3<double>(-v));
  CHECK(w == at(1, 5, 0));
  const double bound = v.dot(w) / v.norm();
  const double distance =
      contact::gjk(differences, contact::Sphere<double>{at(0, 0, 0), 0}).distance;
  CHECK(bound <= distance);
  CHECK(distance <= v.norm());
  return bound;
}

KEY("why-v-separates") {
  const contact::Triangle<double> a{at(2, 0, 0), at(5, 1, 0), at(3, 4, 2)};
  const contact::Triangle<double> b{at(-1, 1, 0), at(0, -3, 1), at(-2, 2, -2)};
  const auto separates = [&](const Vector3<double>& v) {
    return contact::separates(contact::SeparatingPlane{v, Vector3<contact::Exact>::Zero()}, a, b);
  };
  // The closest difference does; a longer one, of two vertices, need not.
  return questions::Claim{separates(contact::gjk(a, b).between), separates(a.c - b.b)};
}

KEY("undecided-means") {
  const auto cylinder = contact::cylinder_from_segment<double>(at(0, 0, 0), at(0, 0, 2), 1);
  const auto ellipsoid = contact::ellipsoid_from_axes<double>(
      at(3, 0, 1), contact::Matrix3<double>::Identity(), at(2, 1, 1));
  const auto found = contact::certified_proximity(cylinder, ellipsoid);
  CHECK(found.state == Proximity::undecided);
  CHECK(found.low < 0);
  CHECK(found.high > 0);
  return found.high - found.low < 1e-13 ? 1 : 2;
}

KEY("witness-fails") {
  // Beside each other along x; then one has moved round the other.
  const auto a = box(at(3, 0, 0), at(1, 1, 1)), moved = box(at(0, 3, 0), at(1, 1, 1));
  const auto b = box(at(0, 0, 0), at(1, 1, 1));
  const contact::SeparatingPlane kept{at(1, 0, 0), Vector3<contact::Exact>::Zero()};
  CHECK(contact::separates(kept, a, b));
  CHECK_FALSE(contact::separates(kept, moved, b));
  return contact::proximity(moved, b) == Proximity::disjoint ? 2 : 0;
}

KEY("corner-of-a-box") {
  const auto large = box(at(0, 0, 0), at(0.5, 0.5, 0.5));
  const auto small = box(at(0.4, 0.4, 0.4), at(0.05, 0.05, 0.05));
  return -contact::signed_distance(small, large).distance;
}

KEY("concave-pair") {
  // A box between two walls of one body: parted from the one, it is deeper in the other.
  auto a = box(at(0, 0, 0), at(1, 5, 5));
  const std::array walls{box(at(-1.7, 0, 0), at(1, 5, 5)), box(at(1.9, 0, 0), at(1, 5, 5))};
  const auto left = contact::signed_distance(a, walls[0]);
  const auto right = contact::signed_distance(a, walls[1]);
  CHECK(left.distance < right.distance);
  CHECK(right.distance < 0);
  a.centre -= left.normal * left.distance;
  const bool parted = contact::proximity(a, walls[1]) != Proximity::overlapping;
  return parted ? 0 : 1;
}

KEY("own-line") {
  // Close to each other with the line between them, and with the line through A.
  two_hulls_figure::Input in{};
  in.a = {-1.125, 0};
  in.b = {0.5, 0.25};
  in.turn_a = in.turn_b = {0, 1};
  in.p = {-0.1875, -1};
  in.q = {-0.1875, 1};
  const double winning = two_hulls_figure::compute(in).line_found;
  in.p.x() = in.q.x() = -1.125;
  return questions::Construct{winning, two_hulls_figure::compute(in).line_found};
}

}  // namespace questions_test
