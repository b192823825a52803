// Right answers are computed in integers, by way of all pairs of triangles. Every test asks for
// several answers.
#include "mesh_contacts.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <06_triangle_pairs/touching_bodies.hpp>
#include <06_triangle_pairs/whole_contacts.hpp>

namespace {

using namespace contact::testing;
using exercise::Feature;
using exercise::MeshContact;
using solids::Mesh;
using solids::Point;
using whole_contacts::Contact;
using whole_contacts::Contacts;
using whole_contacts::Edges;
using whole_contacts::Name;
using Features = std::vector<Feature>;
using MaybeFeature = std::optional<Feature>;
using Found = std::vector<MeshContact>;

constexpr double kTolerance = 1e-9;

Feature feature(const Name& name) {
  Feature result{-1, -1, -1};
  std::copy(name.begin(), name.end(), result.begin());
  return result;
}
MaybeFeature maybe(const Name& name) {
  return name.empty() ? MaybeFeature{} : MaybeFeature{feature(name)};
}
Features features(const std::vector<Name>& names) {
  Features result;
  for (const Name& name : names) result.push_back(feature(name));
  return result;
}

/// With its indices in order, and the -1 behind them.
Feature ordered(Feature one) {
  std::sort(one.begin(), one.end(), [](int x, int y) { return y < 0 ? x >= 0 : x >= 0 && x < y; });
  return one;
}
Features each_ordered(Features all) {
  for (Feature& one : all) one = ordered(one);
  return all;
}
Features in_order(Features all) {
  std::sort(all.begin(), all.end());
  return all;
}
Features repeated(const Features& all) {
  Features twice;
  for (const Feature& one : all) twice.insert(twice.end(), 2, one);
  return twice;
}

void check_edges(const Mesh& mesh) {
  const Features right = features(whole_contacts::edges(mesh));
  const auto with = [&](Edges kind) { return features(whole_contacts::edges(mesh, kind)); };
  const auto tolerant = [&](double cosine) {
    return features(whole_contacts::edges_with_tolerance(mesh, cosine));
  };
  ask("Which edges does the body have?")
      .given("mesh", mesh)
      .suspect("flat-edge-counted", [&] { return with(Edges::of_mesh); })
      .suspect("edge-for-each-triangle", [&] { return repeated(right); })
      .suspect("flat-by-equal-normals", [&] { return with(Edges::with_other_normals); })
      .suspect("flat-by-equal-normals", [&] { return with(Edges::with_other_unit_normals); })
      .suspect("concave-edge-taken-for-flat", [&] { return with(Edges::convex); })
      .suspect("absolute-epsilon", [&] { return tolerant(0.9999); })
      .suspect("absolute-epsilon", [&] { return tolerant(0.999); })
      .suspect("absolute-epsilon", [&] { return tolerant(0.99); })
      .suspect_if("indices-not-in-order",
                  [&](const Features& got) {
                    return each_ordered(got) != got && in_order(each_ordered(got)) == right;
                  })
      .suspect_if("names-not-in-order",
                  [&](const Features& got) { return got != right && in_order(got) == right; })
      .answer([&] { return exercise::edges_of(mesh); })
      .equals(right);
}

/// Of all triangles that contain the point, the last one.
Name last_face(const Mesh& mesh, const Point& p, const Name& right) {
  const auto all = whole_contacts::triangles_at(mesh, p);
  return right.size() == 3 ? whole_contacts::face(mesh, all.back()) : right;
}

/// The first triangle in whose plane the point is.
Name in_a_plane(const Mesh& mesh, const Point& p, const Name& right) {
  for (std::size_t i = 0; right.empty() && i < mesh.triangles.size(); ++i) {
    if (solids::ahead(triangle_of(mesh, i), p) == 0) return whole_contacts::face(mesh, i);
  }
  return right;
}

/// For a vertex, the first edge that ends there.
Name edge_first(const Mesh& mesh, const Name& right) {
  if (right.size() != 1) return right;
  const std::vector<Name> edges = whole_contacts::edges(mesh);
  return *std::find_if(edges.begin(), edges.end(), [&](const Name& edge) {
    return edge[0] == right[0] || edge[1] == right[0];
  });
}

void check_feature(const Mesh& mesh, const Point& p) {
  const auto triangles = whole_contacts::triangles_at(mesh, p);
  const Name name = whole_contacts::feature_at(mesh, p);
  const MaybeFeature right = maybe(name);
  ask("Which is the smallest feature that contains the point?")
      .given("mesh", mesh)
      .given("point", p)
      .suspect("flat-edge-counted",
               [&] { return maybe(whole_contacts::feature_at(mesh, p, Edges::of_mesh)); })
      .suspect("larger-feature-named",
               [&] { return right ? maybe(whole_contacts::face(mesh, triangles[0])) : right; })
      .suspect("vertex-named-as-an-edge", [&] { return maybe(edge_first(mesh, name)); })
      .suspect("last-triangle-named", [&] { return maybe(last_face(mesh, p, name)); })
      .suspect("plane-for-triangle", [&] { return maybe(in_a_plane(mesh, p, name)); })
      .suspect_if("indices-not-in-order",
                  [&](const MaybeFeature& got) {
                    return got && got != right && MaybeFeature{ordered(*got)} == right;
                  })
      .answer([&] { return exercise::feature_at(mesh, p); })
      .equals(right);
}

Found found(const Contacts& contacts) {
  Found result;
  for (const auto& [of_a, of_b, position] : contacts)
    result.push_back({feature(of_a), feature(of_b), position});
  return result;
}

bool is_of_vertices(const Contact& one) { return one.of_a.size() == 1 || one.of_b.size() == 1; }
bool is_of_two_vertices(const Contact& one) { return one.of_a.size() == 1 && one.of_b.size() == 1; }

/// With a vertex of B named first.
Contacts exchanged(Contacts all) {
  for (Contact& one : all) {
    if (one.of_b.size() == 1 && one.of_a.size() > 1) std::swap(one.of_a, one.of_b);
  }
  return whole_contacts::sorted(std::move(all));
}

std::vector<Suspect<Found>> suspects(const Mesh& a, const Mesh& b, const Contacts& right) {
  using namespace whole_contacts;
  std::vector<Suspect<Found>> all;
  const auto add = [&](std::string_view id, auto contacts) {
    all.emplace_back(id, [contacts] { return found(contacts()); });
  };
  const auto add_those = [&](std::string_view id, auto keep) {
    add(id, [&right, keep] { return those(right, keep); });
  };
  add("flat-edge-counted", [&] { return contacts(a, b, Edges::of_mesh); });
  add("contact-for-each-triangle", [&] { return with_each_triangle(a, b); });
  add("contact-not-once", [&] { return of_pairs(a, b); });
  add("contact-not-once", [&] {
    Contacts repeated;
    for (const Contact& one : right) {
      const std::size_t of_a = triangles_at(a, one.position).size();
      const std::size_t of_b = triangles_at(b, one.position).size();
      const bool by_edges = !is_of_vertices(one);
      repeated.insert(
          repeated.end(),
          by_edges ? 1 : (is_vertex(one.of_a) ? of_b : 0) + (is_vertex(one.of_b) ? of_a : 0), one);
    }
    return repeated;
  });
  add("contact-not-once", [&] {
    Contacts repeated;
    for (const Contact& one : right)
      repeated.insert(repeated.end(), is_of_vertices(one) ? 1 : 4, one);
    return repeated;
  });
  add("vertex-pair-twice", [&] { return twice(right, is_of_two_vertices); });
  add_those("vertices-of-b-left-out",
            [](const Contact& x) { return is_vertex(x.of_a) || !is_of_vertices(x); });
  add_those("crossing-edges-left-out", is_of_vertices);
  add_those("vertices-left-out", [](const Contact& x) { return !is_of_vertices(x); });
  add("ends-taken-for-crossings", [&] { return with_ends(a, b); });
  add("bodies-exchanged", [&] { return exchanged(right); });
  add("four-contacts-kept", [&] {
    return Contacts(right.begin(), right.begin() + std::min<std::ptrdiff_t>(4, std::ssize(right)));
  });
  for (const double distance : {0.01, 0.02, 0.1, 0.5, 1.0})
    add("near-contacts-merged", [&, distance] { return merged(right, distance); });
  return all;
}

/// The same contacts, whatever their order.
bool same_but_for_order(const Found& got, const Found& right) {
  const auto less = [](const MeshContact& x, const MeshContact& y) {
    return std::tie(x.of_a, x.of_b) < std::tie(y.of_a, y.of_b);
  };
  Found one = got;
  std::stable_sort(one.begin(), one.end(), less);
  return one.size() == right.size() &&
         std::equal(one.begin(), one.end(), right.begin(),
                    [&](const MeshContact& x, const MeshContact& y) {
                      return x.of_a == y.of_a && x.of_b == y.of_b &&
                             (x.position - y.position).cwiseAbs().maxCoeff() <= kTolerance;
                    });
}

void check_contacts(const Mesh& a, const Mesh& b) {
  const Contacts contacts = whole_contacts::contacts(a, b);
  const Found right = found(contacts);
  ask("Where do the bodies touch?")
      .given("a", a)
      .given("b", b)
      .suspects(suspects(a, b, contacts))
      .suspect_if("names-not-in-order",
                  [&](const Found& got) {
                    const auto is_ordered = [](const MeshContact& x, const MeshContact& y) {
                      return std::tie(x.of_a, x.of_b) <= std::tie(y.of_a, y.of_b);
                    };
                    return same_but_for_order(got, right) &&
                           std::adjacent_find(got.begin(), got.end(),
                                              [&](const MeshContact& x, const MeshContact& y) {
                                                return !is_ordered(x, y);
                                              }) != got.end();
                  })
      .suspect_if("first-contact-alone",
                  [&](const Found& got) {
                    return got.size() == 1 && right.size() > 1 &&
                           std::any_of(right.begin(), right.end(), [&](const MeshContact& one) {
                             return same_but_for_order(got, {one});
                           });
                  })
      .answer([&] { return exercise::mesh_contacts(a, b); })
      .close_to(right, within(kTolerance));
}

/// Both as A and as B.
void check_both(const Mesh& a, const Mesh& b) {
  check_contacts(a, b);
  check_contacts(b, a);
}

Mesh body(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Mesh mesh = solids::tetrahedron(a, b, c, d);
  return solids::ahead(triangle_of(mesh, 0), d) < 0 ? mesh : solids::inside_out(mesh);
}

/// A body with its lowest vertex at a point, and one with its upper face in the plane z = 0.
Mesh on_its_tip(const Point& tip) {
  return body(tip + Point(-3, -2, 6), tip, tip + Point(4, -1, 6), tip + Point(0, 5, 6));
}
Mesh ground() { return body({-20, -10, 0}, {20, -10, 0}, {0, 0, -20}, {0, 30, 0}); }

/// Bodies with their lowest and highest edge in the plane z = 0.
Mesh on_its_edge(const Point& from, const Point& to) {
  return body({0, 15, 7}, from, {1, -15, 7}, to);
}
Mesh under_its_edge(const Point& from, const Point& to) {
  return body({24, 1, -6}, from, {-26, 0, -6}, to);
}

Mesh box(const Point& low, const Point& high) { return solids::box(low, high); }
/// With its upper face in the plane z = 0, divided along x = y.
Mesh slab() { return box({-20, -20, -5}, {20, 20, 0}); }

/// A prism of height 5 on the plane z = 0. Its caps are a trapezoid, or an L.
Mesh trapezoid() {
  return solids::prism({{0, 0}, {9, 0}, {6, 4}, {3, 4}}, {{0, 1, 2}, {0, 2, 3}}, 0, 5);
}
Mesh angle() {
  return solids::prism({{0, 0}, {12, 0}, {12, 4}, {4, 4}, {4, 10}, {0, 10}},
                       {{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}, 0, 5);
}
Mesh hexagon() {
  return solids::prism({{4, 0}, {2, 3}, {-2, 3}, {-4, 0}, {-2, -3}, {2, -3}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 0, 5);
}
/// A roof that is hardly higher in the middle.
Mesh low_roof() {
  return solids::prism({{-90, 0}, {0, -8}, {90, 0}, {0, 1}}, {{0, 1, 3}, {1, 2, 3}}, 0, 50);
}

Mesh octahedron() { return solids::octahedron(8); }

Mesh mixed(const Mesh& mesh) { return touching_bodies::reordered(mesh, 7); }

}  // namespace

TEST_CASE("each edge is named once, and all are in order") {
  check_edges(ground());
  check_edges(octahedron());
  check_edges(on_its_tip({1, 2, 3}));
  check_edges(mixed(octahedron()));
}

TEST_CASE("an edge between two triangles of a flat face is no edge") {
  check_edges(slab());
  check_edges(trapezoid());
  check_edges(mixed(trapezoid()));
  check_edges(
      solids::moved(trapezoid(), Eigen::Matrix3d{{3, 2, 0}, {-1, -2, 1}, {0, -1, 0}}, {-3, 5, 2}));
  check_edges(angle());
  check_edges(mixed(angle()));
}

TEST_CASE("a hardly bent edge is an edge") {
  check_edges(low_roof());
  check_edges(mixed(low_roof()));
}

TEST_CASE("the smallest feature that contains a point is named") {
  const Mesh mesh = octahedron();
  check_feature(mesh, {2, 2, 4});
  check_feature(mesh, {2, -2, 4});
  check_feature(mesh, {-3, -3, -2});
  check_feature(mesh, {4, 0, 4});
  check_feature(mesh, {0, -2, -6});
  check_feature(mesh, {0, 0, 8});
  check_feature(mesh, {-8, 0, 0});
  check_feature(mesh, {1, 2, 3});
  check_feature(mesh, {10, 1, -3});
  // Half a metre from an edge.
  check_feature(body({0, 0, 0}, {2, 1, 0}, {2, -3, 0}, {1, 0, -5}), {1, 0, 0});
  for (const Point& p : {Point(2, 2, 4), Point(4, 4, 0), Point(0, 8, 0)})
    check_feature(mixed(mesh), p);
}

TEST_CASE("a point on a flat edge is inside a face") {
  check_feature(slab(), {3, -7, 0});
  check_feature(slab(), {3, 3, 0});
  check_feature(slab(), {-11, -11, -5});
  check_feature(slab(), {20, 3, 0});
  check_feature(slab(), {20, 20, 0});
  check_feature(mixed(slab()), {3, 3, 0});
  check_feature(mixed(slab()), {-11, -11, -5});
  check_feature(angle(), {2, 2, 0});
  check_feature(angle(), {8, 4, 5});
}

TEST_CASE("a vertex on a face is one contact") {
  check_both(on_its_tip({0, 0, 0}), ground());
  check_both(on_its_tip({1, 3, 0}), ground());
  check_both(on_its_tip({1, 3, 2}), ground());
}

TEST_CASE("two edges that cross are one contact") {
  check_both(on_its_edge({-6, -2, 0}, {8, 2, 0}), under_its_edge({-1, -7, 0}, {2, 5, 0}));
  check_both(on_its_edge({-6, 0, 0}, {8, 0, 0}), under_its_edge({2, -3, 0}, {2, 5, 0}));
}

TEST_CASE("a vertex on an edge or a vertex is one contact") {
  check_both(on_its_tip({1, 0, 0}), under_its_edge({-4, 0, 0}, {5, 0, 0}));
  check_both(on_its_tip({-4, 0, 0}), under_its_edge({-4, 0, 0}, {5, 0, 0}));
  check_both(on_its_edge({-4, 0, 0}, {8, 2, 0}), under_its_edge({-4, 0, 0}, {5, -1, 0}));
}

TEST_CASE("parallel edges touch at the ends of their overlap") {
  check_both(on_its_edge({-4, 0, 0}, {8, 0, 0}), under_its_edge({-6, 0, 0}, {5, 0, 0}));
  check_both(on_its_edge({-4, 0, 0}, {5, 0, 0}), under_its_edge({-6, 0, 0}, {5, 0, 0}));
}

TEST_CASE("nothing touches a flat edge") {
  check_both(on_its_tip({3, 3, 0}), slab());
  check_both(on_its_edge({-2, 1, 0}, {4, -3, 0}), slab());
  check_both(on_its_tip({3, 3, 0}), mixed(slab()));
}

TEST_CASE("a box stands on a box") {
  const Mesh lower = box({0, 0, -6}, {12, 12, 0});
  check_both(box({4, 3, 0}, {16, 15, 6}), lower);
  check_both(box({2, 2, 0}, {8, 9, 6}), lower);
  check_both(box({-4, 3, 0}, {20, 8, 6}), lower);
  check_both(box({0, 0, 0}, {12, 12, 6}), lower);
  check_both(box({0, 4, 0}, {12, 20, 6}), lower);
  check_both(box({12, 12, 0}, {20, 15, 6}), lower);
}

TEST_CASE("there may be more than four contacts") {
  check_both(hexagon(), slab());
  check_both(solids::moved(hexagon(), Eigen::Matrix3d::Identity(), {18, 19, 0}), slab());
  check_both(angle(), box({-2, -2, -5}, {8, 8, 0}));
}

TEST_CASE("near contacts are different ones") {
  // A vertex is 4 mm inside a face, and one or two edges from it cross the edge of the face.
  const Mesh wide = body({-99, -55, 0}, {99, 54, 0}, {90, -100, 0}, {0, 0, -50});
  check_both(body({10, 5, 0}, {-2, 30, 0}, {40, -30, 0}, {9, 20, 20}), wide);
  check_both(body({10, 5, 0}, {-2, 30, 0}, {20, 40, 0}, {9, 20, 20}), wide);
  check_both(body({10, 5, 0}, {-30, 25, 0}, {11, 40, 0}, {9, 20, 20}), wide);
}

TEST_CASE("random bodies agree with integers") {
  using touching_bodies::Recipe;
  using Map = Eigen::Matrix3d;
  generators::Random random(seed(0));
  const auto mesh = [](const Mesh& made, const Recipe& recipe, const Map& map) {
    return touching_bodies::reordered(touching_bodies::placed(made, map, {1, -2, 3}), recipe.order);
  };
  const auto is_made = [](const Mesh& made, const Map& map) {
    return !made.vertices.empty() &&
           solids::all_whole(solids::moved(made, map, {1, -2, 3}), Point(0, 0, 0), 100);
  };
  const auto judged = [&](const Recipe& a, const Recipe& b, const Map& map, const Point& p) {
    if (map != map.array().round().matrix() || std::abs(map.determinant()) < 0.5) return false;
    if (p != p.array().round().matrix() || !(p.cwiseAbs().maxCoeff() <= 9)) return false;
    for (const Recipe& recipe : {a, b}) {
      if (recipe.kind < 0 || recipe.kind >= touching_bodies::kinds || recipe.order < 0)
        return false;
      for (int x : recipe.base)
        if (std::abs(x) > 9) return false;
    }
    return is_made(touching_bodies::upper(a), map) && is_made(touching_bodies::lower(b), map);
  };
  const auto check = [&](const Recipe& a, const Recipe& b, const Map& map, const Point& p) {
    const Mesh upper = mesh(touching_bodies::upper(a), a, map);
    const Mesh lower = mesh(touching_bodies::lower(b), b, map);
    check_edges(upper);
    check_feature(upper, map * p + Point(1, -2, 3));
    check_contacts(upper, lower);
  };
  for (int asked = 0; asked < 150;) {
    const int size = random.integer(1, 4);
    const Recipe a = touching_bodies::any_recipe(random, size);
    const Recipe b = touching_bodies::any_recipe(random, size);
    const auto number = [&](int limit) { return double(random.integer(-limit, limit)); };
    Map map = Map::Identity();
    if (asked % 2 == 1) {
      for (int i = 0; i < 9; ++i) map(i) = number(3);
    }
    const double x = number(size);
    const double y = number(size);
    const double z = asked % 3 == 0 ? number(3) : 0;
    const Point p(x, y, z);
    if (!judged(a, b, map, p)) continue;
    // Most of them touch.
    const Mesh upper = touching_bodies::upper(a), lower = touching_bodies::lower(b);
    if (asked % 5 != 0 && whole_contacts::contacts(upper, lower).empty()) continue;
    ++asked;
    shrinkable(check, judged, a, b, map, p);
  }
}
