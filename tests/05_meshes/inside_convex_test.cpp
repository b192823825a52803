// Right answers are computed in integers. Every test asks for several answers.
#include "inside_convex.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <05_meshes/solids.hpp>

namespace {

using namespace contact::testing;
using exercise::Where;
using solids::Mesh;
using solids::Point;
using solids::Triangle;

constexpr double kFar = 0x1p15;

Point normal(const Triangle& t) { return (t.b - t.a).cross(t.c - t.a); }

void check_normal(const Triangle& face) {
  const Point right = normal(face);
  ask("What is the outward normal of the face, as long as twice its area?")
      .given("face", face)
      .suspect("face-normal-inwards", [&] { return Point(-right); })
      .suspect("normal-of-positions", [&] { return Point(face.a.cross(face.b)); })
      .suspect("face-normal-made-unit", [&] { return Point(right.normalized()); })
      .answer([&] { return exercise::outward_normal(face); })
      .equals(right);
}

void check_ahead(const Point& p, const Triangle& face) {
  const double right = normal(face).dot(p - face.a);
  ask("What is the product of the outward normal and the vector from the face to the point?")
      .given("point", p)
      .given("face", face)
      .suspect("plane-taken-through-the-origin", [&] { return normal(face).dot(p); })
      .suspect("behind-the-face-for-ahead", [&] { return -right; })
      .answer([&] { return exercise::ahead(p, face); })
      .equals(right);
}

/// The planes of the first faces with a mistake: `ahead` is positive in front of a face.
template <class Ahead>
Where by_planes(const std::vector<Triangle>& faces, std::size_t count, Ahead&& ahead,
                double epsilon = 0) {
  bool on = false;
  for (std::size_t i = 0; i < count; ++i) {
    const auto distance = ahead(faces[i]);
    if (distance > epsilon) return Where::outside;
    on = on || distance >= -epsilon;
  }
  return on ? Where::on : Where::inside;
}

Where by_sign(double ahead) {
  return ahead > 0 ? Where::outside : (ahead < 0 ? Where::inside : Where::on);
}

/// By the face whose centroid is nearest.
Where by_nearest(const std::vector<Triangle>& faces, const Point& p) {
  const auto squared = [&](const Triangle& t) { return (t.a + t.b + t.c - 3 * p).squaredNorm(); };
  const auto nearest = std::min_element(
      faces.begin(), faces.end(),
      [&](const Triangle& s, const Triangle& t) { return squared(s) < squared(t); });
  return by_sign(normal(*nearest).dot(p - nearest->a));
}

/// Behind one face is inside.
Where behind_one(const std::vector<Triangle>& faces, const Point& p) {
  bool on = false;
  for (const Triangle& t : faces) {
    const double ahead = normal(t).dot(p - t.a);
    if (ahead < 0) return Where::inside;
    on = on || ahead == 0;
  }
  return on ? Where::on : Where::outside;
}

Where by_box(const Mesh& mesh, const Point& p) {
  Eigen::AlignedBox3d box;
  for (const Point& v : mesh.vertices) box.extend(v);
  if (!box.contains(p)) return Where::outside;
  const bool on = (p.array() == box.min().array()).any() || (p.array() == box.max().array()).any();
  return on ? Where::on : Where::inside;
}

float ahead_in_float(const Triangle& t, const Point& p) {
  const Eigen::Vector3f a = t.a.cast<float>();
  const Eigen::Vector3f n = (t.b.cast<float>() - a).cross(t.c.cast<float>() - a);
  return n.dot(p.cast<float>() - a);
}

void check(const Mesh& mesh, const Point& p) {
  const std::vector<Triangle> all = solids::triangles(mesh);
  std::vector<Triangle> faces;
  std::copy_if(all.begin(), all.end(), std::back_inserter(faces), solids::has_area);
  const std::size_t n = faces.size();
  const Where right = solids::on_surface(mesh, p)  ? Where::on
                      : solids::is_inside(mesh, p) ? Where::inside
                                                   : Where::outside;
  const auto ahead = [&](const Triangle& t) { return normal(t).dot(p - t.a); };
  const auto distance = [&](const Triangle& t) { return ahead(t) / normal(t).norm(); };
  ask("Where is the point?")
      .given("mesh", mesh)
      .given("point", p)
      .suspect("first-face-decides", [&] { return by_planes(faces, 1, ahead); })
      .suspect("last-face-forgotten",
               [&] { return by_planes(faces, solids::has_area(all.back()) ? n - 1 : n, ahead); })
      .suspect("behind-one-face-is-inside", [&] { return behind_one(faces, p); })
      .suspect("nearest-face-decides", [&] { return by_nearest(faces, p); })
      .suspect("box-for-polyhedron", [&] { return by_box(mesh, p); })
      .suspect("face-without-area-counts", [&] { return by_planes(all, all.size(), ahead); })
      .suspect("absolute-epsilon", [&] { return by_planes(faces, n, distance, 1e-6); })
      .suspect("absolute-epsilon", [&] { return by_planes(faces, n, distance, 1e-9); })
      .suspect("planes-in-float",
               [&] {
                 return by_planes(faces, n,
                                  [&](const Triangle& t) { return ahead_in_float(t, p); });
               })
      .suspect_if("surface-not-told-apart",
                  [&](const Where& got) { return right == Where::on && got != Where::on; })
      .suspect_if("in-the-plane-of-a-face",
                  [&](const Where& got) {
                    return got == Where::on && right == Where::outside &&
                           std::any_of(faces.begin(), faces.end(),
                                       [&](const Triangle& t) { return ahead(t) == 0; });
                  })
      .answer([&] { return exercise::inside_convex(mesh, p); })
      .equals(right);
}

/// No vertex at the origin, no two of its faces in one plane.
const Mesh kTetrahedron =
    solids::tetrahedron({10, 10, 10}, {50, 20, 10}, {20, 60, 10}, {25, 30, 70});
const Mesh kBox = solids::box({10, 10, 10}, {18, 18, 18});

/// The box with a vertex inside the edge from its second vertex to its third. Only the bottom has
/// it; a triangle without area closes the mesh.
Mesh with_a_triangle_without_area() {
  Mesh mesh = kBox;
  mesh.vertices.emplace_back(18, 14, 10);
  // The bottom was 2, 1, 0 and 3, 2, 0.
  std::erase(mesh.triangles, std::array{2, 1, 0});
  mesh.triangles.insert(mesh.triangles.begin() + 3, {{2, 8, 0}, {8, 1, 0}, {1, 8, 2}});
  return mesh;
}

}  // namespace

TEST_CASE("the normal of a face points outwards") {
  check_normal({{1, 2, 3}, {5, 2, 3}, {1, 7, 3}});
  check_normal({{1, 2, 3}, {1, 7, 3}, {5, 2, 3}});
  check_normal({{-3, 7, 2}, {4, 1, -6}, {2, 2, 9}});
  check_normal({{kFar, -kFar, kFar}, {-kFar, kFar, 1 - kFar}, {-kFar, -kFar, -kFar}});
  check_normal({{1, 2, 3}, {3, 4, 5}, {6, 7, 8}});
}

TEST_CASE("the product is positive in front of a face and negative behind it") {
  check_ahead({3, 3, 9}, {{1, 2, 3}, {5, 2, 3}, {1, 7, 3}});
  check_ahead({3, 3, 1}, {{1, 2, 3}, {5, 2, 3}, {1, 7, 3}});
  check_ahead({0, 0, 0}, {{-3, 7, 2}, {4, 1, -6}, {2, 2, 9}});
  check_ahead({8, -2, 3}, {{1, 2, 3}, {5, 2, 3}, {1, 7, 3}});
  check_ahead({kFar, kFar, kFar},
              {{kFar, -kFar, kFar}, {-kFar, kFar, 1 - kFar}, {-kFar, -kFar, -kFar}});
}

TEST_CASE("a point inside is told from one outside") {
  check(kTetrahedron, {25, 30, 20});
  // Outside its bounding box: in front of the first face, and of another; and then inside the box.
  check(kTetrahedron, {30, 30, 5});
  check(kTetrahedron, {35, -10, 30});
  check(kTetrahedron, {45, 40, 40});
  // In front of one face alone.
  check(kTetrahedron, {45, 40, 12});
  check(kTetrahedron, {30, 15, 25});
  check(kTetrahedron, {12, 40, 30});
  check(kTetrahedron, {0, 0, 0});
  check(kTetrahedron, {24, 30, 60});
  const Mesh octahedron = solids::octahedron(9);
  check(octahedron, {2, -3, 3});
  for (const double x : {-5, 5}) {
    for (const double y : {-4, 4}) {
      check(octahedron, {x, y, -3});
      check(octahedron, {x, y, 3});
    }
  }
}

TEST_CASE("a point on a face, on an edge or at a vertex is on") {
  check(kBox, {14, 12, 13});
  for (const Point& on :
       {Point(14, 12, 10), Point(14, 14, 18), Point(10, 11, 17), Point(18, 18, 11),
        Point(18, 12, 10), Point(10, 10, 10), Point(18, 18, 18)})
    check(kBox, on);
  check(kTetrahedron, {30, 15, 10});
  check(kTetrahedron, {25, 30, 10});
  check(kTetrahedron, {25, 30, 70});
  check(kTetrahedron, {35, 40, 10});
}

TEST_CASE("in the plane of a face is not yet on the face") {
  check(kBox, {14, 12, 13});
  for (const Point& beside : {Point(20, 12, 10), Point(5, 5, 10), Point(18, 14, 30),
                              Point(10, 9, 17), Point(18, 18, 19), Point(0, 18, 10)})
    check(kBox, beside);
  check(kTetrahedron, {0, 0, 10});
  check(kTetrahedron, {90, 30, 10});
  // Where normals and products are as small as they can be.
  const Mesh small = solids::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  for (const Point& beside : {Point(0, 0, -1), Point(-1, 0, 0), Point(0, -1, 0), Point(1, 1, 0)})
    check(small, beside);
}

TEST_CASE("a triangle without area bounds nothing") {
  const Mesh mesh = with_a_triangle_without_area();
  check(mesh, {14, 12, 13});
  check(mesh, {12, 16, 11});
  check(mesh, {18, 14, 10});
  check(mesh, {18, 14, 12});
  check(mesh, {18, 30, 10});
}

TEST_CASE("a point beside a large face is not on it") {
  const Mesh large = solids::tetrahedron({-kFar, -kFar, -kFar}, {kFar, kFar - 1, -kFar},
                                         {-kFar, kFar, 1 - kFar}, {kFar - 3, -kFar, kFar});
  check(large, {0, 0, 0});
  // The points of its faces that are nearest to being on them.
  for (const Triangle& t : solids::triangles(large)) {
    const Point middle = ((t.a + t.b + t.c) / 3).array().round().matrix();
    for (const double x : {-1, 0, 1}) {
      for (const double y : {-1, 0, 1}) {
        for (const double z : {-1, 0, 1}) check(large, middle + Point(x, y, z));
      }
    }
  }
  // A face whose plane is x - N y + N² z = const: one step in x is 4 nanometres from it.
  constexpr double kN = 0x1p14;
  const Point a(-25'000, -25'000, -3);
  const Mesh level = solids::tetrahedron(a, a + 3 * Point(kN, 1, 0), a + 3 * Point(0, kN, 1),
                                         a + Point(10'000, 10'000, 30'000));
  const Point on = a + Point(kN, kN + 1, 1);
  check(level, on);
  for (const double x : {-2, -1, 1, 2}) check(level, on + Point(x, 0, 0));
}

TEST_CASE("random convex polyhedra agree with integers") {
  generators::Random random(seed(0));
  const auto judged = [](const Mesh& mesh, const Point& p) {
    return mesh.triangles.size() >= 4 && solids::indices_fit(mesh) &&
           solids::all_whole(mesh, p, kFar) && solids::is_convex(mesh);
  };
  std::array<int, 26> ones{};
  ones.fill(1);
  const std::array<Mesh, 4> shapes{
      solids::octahedron(2), solids::star(ones), kBox,
      solids::prism({{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}},
                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, -1, 1)};
  for (int asked = 0; asked < 300;) {
    const int size = asked % 2 == 0 ? 3 : 400;
    const auto number = [&](int limit) { return double(random.integer(-limit, limit)); };
    const auto vector = [&](int limit) {
      const double x = number(limit);
      const double y = number(limit);
      return Point(x, y, number(limit));
    };
    Eigen::Matrix3d map;
    for (int i = 0; i < 3; ++i) map.col(i) = vector(size);
    if (map.determinant() <= 0) continue;
    const Point shift = vector(8 * size);
    const Mesh mesh = solids::moved(shapes[static_cast<std::size_t>(asked % 4)], map, shift);
    // On a third of the points the vertices weigh in whole numbers: often on a face or its plane.
    Point p = vector(3 * size) + mesh.vertices[0];
    if (asked % 3 == 0) p = map * vector(2) + shift;
    if (!judged(mesh, p)) continue;
    ++asked;
    shrinkable(check, judged, mesh, p);
  }
}
