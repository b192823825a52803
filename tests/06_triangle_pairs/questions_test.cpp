#include "support/questions.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/feature_contacts.hpp>
#include <contact/figure.hpp>
#include <contact/locate_in_mesh.hpp>
#include <contact/mesh_contacts.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/pair_methods.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/triangle_intersection.hpp>
#include <contact/triangles_meet.hpp>
#include <support/generators.hpp>

namespace features_figure {
#include "figures/features.cpp"
}

namespace questions_test {

namespace {

using contact::CommonPoints;
using contact::FeatureKind;
using contact::Mesh;
using contact::Triangle;
using contact::Vector3;

Vector3<double> at(double x, double y, double z) { return {x, y, z}; }

/// A triangle in the plane z = 0, with a normal of length 2.
const Triangle<double> level{at(0, 0, 0), at(2, 0, 0), at(0, 1, 0)};

/// The six orders of a triangle's vertices.
template <class S>
std::array<Triangle<S>, 6> orders(const Triangle<S>& t) {
  return {{{t.a, t.b, t.c},
           {t.b, t.c, t.a},
           {t.c, t.a, t.b},
           {t.b, t.a, t.c},
           {t.a, t.c, t.b},
           {t.c, t.b, t.a}}};
}

/// Whether a method gives one answer for all orders of the vertices and of the triangles.
template <class S, class Method>
bool same_in_every_order(const Triangle<S>& first, const Triangle<S>& second,
                         const Method& method) {
  const bool answer = method(first, second);
  for (const Triangle<S>& t : orders(first)) {
    for (const Triangle<S>& u : orders(second)) {
      if (method(t, u) != answer || method(u, t) != answer) return false;
    }
  }
  return true;
}

Mesh<double> box(const Vector3<double>& low, const Vector3<double>& high) {
  return contact::box_mesh(low, high);
}

}  // namespace

KEY("which-distance") {
  // A normal of length 8, and a vertex 1.5 m in front of the plane.
  const Triangle<double> t{at(0, 0, 0), at(4, 0, 0), at(0, 2, 0)};
  const Vector3<double> n = (t.b - t.a).cross(t.c - t.a);
  CHECK(n.norm() == 8);
  CHECK(n.dot(at(1, 1, 1.5) - t.a) == 12);
  return 12 / n.norm();
}

KEY("second-rejection") {
  // u: 2, −1, −3 on the plane of `second`; v: 4, 1, 5 on the plane of `first`, up to a factor.
  const Triangle<double> first{at(0, 0, 2), at(1, 0, -1), at(0, 0, -3)};
  const Triangle<double> second{at(0, 4, 0), at(1, 1, 0), at(0, 5, 0)};
  const auto n = [](const Triangle<double>& t) {
    return Vector3<double>((t.b - t.a).cross(t.c - t.a));
  };
  const auto sign = [&](const Triangle<double>& of, const Vector3<double>& x) {
    return n(of).dot(x - of.a) > 0;
  };
  CHECK(sign(second, first.a) != sign(second, first.b));
  CHECK(sign(second, first.b) == sign(second, first.c));
  CHECK((sign(first, second.a) == sign(first, second.b) &&
         sign(first, second.b) == sign(first, second.c)));
  CHECK(contact::meet_by_steps(first, second).decided_in == 2);
  return contact::triangles_meet(first, second) ? 0 : 1;
}

KEY("p-on-an-edge") {
  const Triangle<double> t{at(1, 0, 3), at(5, 0, -1), at(1, 1, 3)};
  const Triangle<double> plane{at(0, 0, 0), at(8, 0, 0), at(0, 0.25, 0)};
  const Vector3<double> n = (plane.b - plane.a).cross(plane.c - plane.a);
  CHECK(n.dot(t.a) == 6);
  CHECK(n.dot(t.b) == -2);
  const auto steps = contact::meet_by_steps(t, plane);
  const Vector3<double> p = steps.p.y() == 0 ? steps.p : steps.q;
  CHECK(p.z() == 0);
  return p.x();
}

KEY("order-of-the-steps") {
  return questions::only_order({{"points", {"rejected"}},
                                {"planes", {}},
                                {"in the plane", {"points"}},
                                {"rejected", {"planes"}}});
}

KEY("coplanar-by-steps") {
  const Triangle<double> other{at(0.25, 0.25, 0), at(3, 0.25, 0), at(0.25, 3, 0)};
  CHECK(contact::triangles_meet(level, other));
  const auto steps = contact::meet_by_steps(level, other);
  CHECK(steps.coplanar);
  return steps.decided_in == 2 ? 0 : steps.crosses_plane ? 2 : 1;
}

KEY("edges-in-the-plane") {
  const auto program = [](const Triangle<double>& t1, const Triangle<double>& t2) {
    const auto flat = [](const Vector3<double>& v) {
      return contact::Vector2<double>(v.x(), v.y());
    };
    const std::array a{flat(t1.a), flat(t1.b), flat(t1.c)};
    const std::array b{flat(t2.a), flat(t2.b), flat(t2.c)};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (contact::meet<double>({a[i], a[(i + 1) % 3]}, {b[j], b[(j + 1) % 3]}) !=
            contact::Meeting::none) {
          return true;
        }
      }
    }
    const auto left = [&](std::size_t i) { return contact::orient_2d(b[i], b[(i + 1) % 3], a[0]); };
    return left(0) == left(1) && left(1) == left(2);
  };
  const Triangle<double> small{at(0.25, 0.25, 0), at(0.5, 0.25, 0), at(0.25, 0.5, 0)};
  const Triangle<double> touching{at(2, 0, 0), at(3, 1, 0), at(3, -1, 0)};
  const std::array pairs{std::array{level, small}, std::array{small, level},
                         std::array{level, touching}};
  int wrong = 3;
  for (int i = 0; i < 3; ++i) {
    const auto& [t1, t2] = pairs.at(static_cast<std::size_t>(i));
    CHECK(contact::triangles_meet(t1, t2));
    if (program(t1, t2)) continue;
    CHECK(wrong == 3);
    wrong = i;
  }
  return wrong;
}

KEY("order-of-vertices") {
  generators::Random random(1);
  const auto number = [&random] { return static_cast<float>(random.uniform(-1, 1)); };
  const auto vector = [&number] {
    const float x = number();
    const float y = number();
    return Vector3<float>(x, y, number());
  };
  bool exactly = true, rounded = true;
  for (int i = 0; i < 200; ++i) {
    const Triangle<float> first{vector(), vector(), vector()};
    // Its first vertex is on the first triangle, as nearly as a float can say.
    const Triangle<float> second{first.a / 2 + first.b / 4 + first.c / 4, vector(), vector()};
    exactly = exactly && same_in_every_order(first, second, [](const auto& t, const auto& u) {
                return contact::triangles_meet(t, u);
              });
    rounded = rounded && same_in_every_order(first, second, [](const auto& t, const auto& u) {
                return contact::meet_by_orientations(t, u);
              });
  }
  return questions::Claim{exactly, rounded};
}

KEY("most-vertices") {
  const Triangle<double> up{at(-3, -2, 0), at(3, -2, 0), at(0, 4, 0)};
  const Triangle<double> down{at(-3, 2, 0), at(0, -4, 0), at(3, 2, 0)};
  const auto common = contact::intersect_triangles(up, down);
  CHECK(common.kind == CommonPoints::area);
  return static_cast<double>(common.count);
}

KEY("vertex-on-an-edge") {
  // A tip on the ridge of a roof.
  Mesh<double> tip;
  tip.vertices = {at(0, 0, 1), at(1, 1, 3), at(-1, 1, 3), at(0, -1, 3)};
  tip.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  Mesh<double> roof;
  roof.vertices = {at(-4, -2, 0), at(4, -2, 0), at(4, 2, 0),
                   at(-4, 2, 0),  at(-4, 0, 1), at(4, 0, 1)};
  roof.triangles = {{0, 1, 5}, {0, 5, 4}, {2, 3, 4}, {2, 4, 5},
                    {0, 3, 2}, {0, 2, 1}, {1, 2, 5}, {3, 0, 4}};
  const auto contacts = contact::mesh_contacts(tip, roof);
  CHECK(contacts.size() == 1);
  CHECK(contacts.front().of_first.kind == FeatureKind::vertex);
  CHECK(contacts.front().of_second.kind == FeatureKind::edge);
  // The tip is on the closed faces at the ridge, so point to face finds it.
  int faces = 0;
  for (std::size_t i = 0; i < roof.triangles.size(); ++i) {
    if (contact::on_triangle(tip.vertices[0], contact::triangle_of(roof, i))) ++faces;
  }
  // So does edge to edge: an edge of the tip, as a triangle without area, against the ridge.
  const bool edges =
      contact::triangles_meet<double>({tip.vertices[0], tip.vertices[1], tip.vertices[1]},
                                      {roof.vertices[4], roof.vertices[5], roof.vertices[5]});
  return faces > 0 ? (edges ? 2 : 0) : (edges ? 1 : 3);
}

KEY("how-many-orientations") {
  // The orientations that are taken, at most, for pairs that are not coplanar.
  using namespace contact::pair_orientations_detail;
  using Vertex = const Vector3<double>*;
  generators::Random random(2);
  const auto vector = [&random] {
    const double x = random.integer(-3, 3);
    const double y = random.integer(-3, 3);
    return at(x, y, random.integer(-3, 3));
  };
  int most = 0;
  for (int i = 0; i < 20000; ++i) {
    const Triangle<double> first{vector(), vector(), vector()};
    const Triangle<double> second{vector(), vector(), vector()};
    int calls = 0;
    const auto volume = [&calls](Vertex a, Vertex b, Vertex c, Vertex d) {
      ++calls;
      return contact::orient_3d(*a, *b, *c, *d);
    };
    const auto sides = [&volume](const Triangle<double>& of, const Triangle<double>& t) {
      return Sides{volume(&of.a, &of.b, &of.c, &t.a), volume(&of.a, &of.b, &of.c, &t.b),
                   volume(&of.a, &of.b, &of.c, &t.c)};
    };
    const auto same = [](const Sides& s) { return s[0] == s[1] && s[1] == s[2]; };
    const Sides u = sides(second, first);
    if (same(u)) continue;  // apart, or in one plane
    const Sides v = sides(first, second);
    if (same(v)) continue;
    const bool meet = intervals_overlap(Ordered<Vertex>{&first.a, &first.b, &first.c},
                                        Ordered<Vertex>{&second.a, &second.b, &second.c}, apex(u),
                                        apex(v), volume);
    CHECK(meet == contact::triangles_meet(first, second));
    most = std::max(most, calls);
  }
  return static_cast<double>(most);
}

KEY("fifteen-tests") {
  const int vertices = 3, edges = 3;
  return 2.0 * vertices + edges * edges;
}

KEY("make-edge-edge") {
  features_figure::Input in{};
  in.position = at(0.125, 0.25, 2);
  in.resting = 1;
  in.pose = 1;
  in.turn = 15;
  in.time = 1;
  const double winning = features_figure::compute(in).edge_edge_only;
  in.turn = 0;
  in.pose = 0;
  in.resting = 0;
  return questions::Construct{winning, features_figure::compute(in).edge_edge_only};
}

KEY("vertices-only") {
  const auto vertex_on_face = [](const Mesh<double>& a, const Mesh<double>& b) {
    for (const auto* pair : {&a, &b}) {
      const Mesh<double>& other = pair == &a ? b : a;
      for (const Vector3<double>& v : pair->vertices) {
        for (std::size_t i = 0; i < other.triangles.size(); ++i) {
          if (contact::on_triangle(v, contact::triangle_of(other, i))) return true;
        }
      }
    }
    return false;
  };
  const Mesh<double> table = box(at(0, -10, -1), at(10, 10, 0));
  Mesh<double> cone;
  cone.vertices = {at(3, 0, 0), at(4, 1, 3), at(2, 1, 3), at(3, -1, 3)};
  cone.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  // A pole with a triangular section that leans against the edge of the table at x = 0.
  Mesh<double> pole;
  pole.vertices = {at(-4, 0, -4), at(4, 0, 4),    at(-5, 1, -3),
                   at(3, 1, 5),   at(-5, -1, -3), at(3, -1, 5)};
  pole.triangles = {{0, 1, 3}, {0, 3, 2}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 5}, {2, 5, 4}, {0, 2, 4}, {1, 5, 3}};
  const Mesh<double> falling = box(at(1, -1, 0), at(3, 1, 2));
  CHECK(vertex_on_face(falling, table));
  CHECK(vertex_on_face(cone, table));
  const auto contacts = contact::mesh_contacts(pole, table);
  CHECK(contacts.size() == 1);
  CHECK(contacts.front().of_first.kind == FeatureKind::edge);
  CHECK(contacts.front().of_second.kind == FeatureKind::edge);
  return vertex_on_face(pole, table) ? 3 : 1;
}

KEY("apart-at-the-root") {
  const contact::MeshTree<double> first(contact::ball_mesh(1.0, 3));
  Mesh<double> far = contact::ball_mesh(1.0, 3);
  for (Vector3<double>& v : far.vertices) v.x() += 9;
  contact::PairCounts counts;
  CHECK_FALSE(contact::any_meeting(first, contact::MeshTree<double>(far), &counts));
  CHECK(counts.triangles == 0);
  return counts.boxes == 1 ? 0 : counts.boxes < 100 ? 1 : 2;
}

KEY("pairs-at-a-vertex") {
  Mesh<double> tip;
  tip.vertices = {at(0, 0, 0), at(2, 0, 3), at(1, 2, 3), at(-2, 1, 3), at(-2, -1, 3), at(1, -2, 3)};
  for (int i = 1; i <= 5; ++i) tip.triangles.push_back({0, i % 5 + 1, i});
  Mesh<double> square;
  square.vertices = {at(-1, -1, 0), at(1, -1, 0), at(1, 1, 0), at(-1, 1, 0)};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  CHECK(contact::mesh_contacts(tip, square).size() == 1);
  return static_cast<double>(contact::meeting_triangles(tip, square).size());
}

KEY("box-on-box") {
  const Mesh<double> lower = box(at(0, 0, 0), at(12, 12, 4));
  const Mesh<double> upper = box(at(4, 3, 4), at(16, 15, 8));
  const auto contacts = contact::mesh_contacts(upper, lower);
  CHECK(contacts.size() == 4);
  const auto vertex_on_face = [](const contact::MeshContact<double>& c) {
    const FeatureKind a = c.of_first.kind, b = c.of_second.kind;
    return (a == FeatureKind::vertex && b == FeatureKind::face) ||
           (a == FeatureKind::face && b == FeatureKind::vertex);
  };
  return static_cast<double>(std::count_if(contacts.begin(), contacts.end(), vertex_on_face));
}

KEY("inside-without-contact") {
  const Mesh<double> small = contact::ball_mesh(1.0, 2), large = contact::ball_mesh(5.0, 2);
  const std::size_t one = contact::meeting_triangles(small, large).size();
  const std::size_t other = contact::meeting_triangles(large, small).size();
  return one != other ? 2 : one == 0 ? 1 : 0;
}

}  // namespace questions_test
