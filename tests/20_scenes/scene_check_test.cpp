// check_scene() on scenes that a program makes, and the matter of shapes against closed forms.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/inertia.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_check.hpp>
#include <contact/scene/scene_solids.hpp>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::BallShape;
using contact::BoxShape;
using contact::CapsuleShape;
using contact::HalfSpaceShape;
using contact::HullShape;
using contact::Matrix3;
using contact::Rotor;
using contact::Scene;
using contact::SceneBody;
using contact::SceneFault;
using contact::Vector3;
using generators::Random;
using oracle::Rational;

namespace {

constexpr double u = 0x1p-53;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

SceneBody body_of(const std::string& name, const contact::SceneShape& shape,
                  const Vector3<double>& position, bool moves = true) {
  SceneBody body;
  body.name = name;
  body.shape = shape;
  body.position = position;
  body.moves = moves;
  if (moves) {
    body.mass = 1;
    body.inertia = contact::solid_inertia(shape, 1);
  }
  return body;
}

/// A floor and, far from each other, one body of every other shape.
Scene sound() {
  Scene scene;
  scene.name = "sound";
  scene.about = "Nothing is wrong.";
  scene.materials.push_back({"steel", 0.5, 0.25, 100.0, 1});
  scene.materials.push_back({"glass", 1, 0, std::nullopt, 0});
  scene.bodies.push_back(body_of("floor", HalfSpaceShape{}, {0, 0, 0}, false));
  scene.bodies.push_back(body_of("ball", BallShape{0.5}, {0, 0, 1}));
  scene.bodies.push_back(body_of("box", BoxShape{{1, 1, 1}}, {10, 0, 2}));
  scene.bodies.push_back(body_of("rod", CapsuleShape{0.5, 1}, {20, 0, 2}));
  scene.bodies.push_back(
      body_of("stone", HullShape{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}}, {30, 0, 2}));
  scene.bodies.push_back(body_of("post", BoxShape{{1, 1, 1}}, {40, 0, 0}, false));
  scene.duration = 1;
  scene.tolerance.position = 1e-6;
  scene.expect.push_back({"speed", "ball", 0.5, 5, 1e-9, "It falls."});
  return scene;
}

std::string all(const std::vector<SceneFault>& faults) {
  std::string text;
  for (const SceneFault& fault : faults) text += contact::fault_text(fault) + "\n";
  return text;
}

/// A number of a scene, by its path.
struct Place {
  std::string path;
  std::function<double&(Scene&)> number;
};

std::vector<Place> places() {
  std::vector<Place> list{
      {"duration", [](Scene& s) -> double& { return s.duration; }},
      {"tolerance.position", [](Scene& s) -> double& { return *s.tolerance.position; }},
      {"output.every", [](Scene& s) -> double& { return s.output.every; }},
      {"materials[0].restitution", [](Scene& s) -> double& { return s.materials[0].restitution; }},
      {"materials[0].friction", [](Scene& s) -> double& { return s.materials[0].friction; }},
      {"materials[0].stiffness", [](Scene& s) -> double& { return *s.materials[0].stiffness; }},
      {"materials[0].damping", [](Scene& s) -> double& { return s.materials[0].damping; }},
      {"bodies[0].shape.offset",
       [](Scene& s) -> double& { return std::get<HalfSpaceShape>(s.bodies[0].shape).offset; }},
      {"bodies[1].mass", [](Scene& s) -> double& { return s.bodies[1].mass; }},
      {"bodies[1].shape.radius",
       [](Scene& s) -> double& { return std::get<BallShape>(s.bodies[1].shape).radius; }},
      {"bodies[1].orientation.quaternion",
       [](Scene& s) -> double& { return s.bodies[1].orientation.w; }},
      {"bodies[3].shape.radius",
       [](Scene& s) -> double& { return std::get<CapsuleShape>(s.bodies[3].shape).radius; }},
      {"bodies[3].shape.half_length",
       [](Scene& s) -> double& { return std::get<CapsuleShape>(s.bodies[3].shape).half_length; }},
      {"expect[0].time", [](Scene& s) -> double& { return s.expect[0].time; }},
      {"expect[0].value", [](Scene& s) -> double& { return s.expect[0].value; }},
      {"expect[0].within", [](Scene& s) -> double& { return s.expect[0].within; }},
  };
  for (int k = 0; k < 3; ++k) {
    const std::string end = '[' + std::to_string(k) + ']';
    list.push_back({"gravity" + end, [k](Scene& s) -> double& { return s.gravity(k); }});
    list.push_back(
        {"bodies[1].position" + end, [k](Scene& s) -> double& { return s.bodies[1].position(k); }});
    list.push_back(
        {"bodies[1].velocity" + end, [k](Scene& s) -> double& { return s.bodies[1].velocity(k); }});
    list.push_back(
        {"bodies[1].spin" + end, [k](Scene& s) -> double& { return s.bodies[1].spin(k); }});
    list.push_back({"bodies[0].shape.normal" + end, [k](Scene& s) -> double& {
                      return std::get<HalfSpaceShape>(s.bodies[0].shape).normal(k);
                    }});
    list.push_back({"bodies[2].shape.half_lengths" + end, [k](Scene& s) -> double& {
                      return std::get<BoxShape>(s.bodies[2].shape).half_lengths(k);
                    }});
    list.push_back({"bodies[4].shape.points[2]" + end, [k](Scene& s) -> double& {
                      return std::get<HullShape>(s.bodies[4].shape).points[2](k);
                    }});
  }
  return list;
}

/// The gap of two bodies, which must be one that can be told.
double gap_of(const SceneBody& a, const SceneBody& b) {
  const auto gap = contact::starting_gap(a, b);
  REQUIRE(gap);
  CHECK(*contact::starting_gap(b, a) == *gap);
  return *gap;
}

Rational squared(const oracle::Vector& v) { return v.dot(v); }

}  // namespace

TEST_CASE("A scene without a fault has none") {
  const auto faults = contact::check_scene(sound());
  INFO(all(faults));
  CHECK(faults.empty());
}

TEST_CASE("Every number of a scene is refused where it is none, by its path") {
  for (const Place& place : places()) {
    for (const double bad : {no_number, infinity, -infinity, 1.5e30, -1.5e30}) {
      Scene scene = sound();
      place.number(scene) = bad;
      const auto faults = contact::check_scene(scene);
      INFO(place.path << " = " << bad << "\n" << all(faults));
      REQUIRE(faults.size() >= 1);
      bool told = false;
      for (const SceneFault& fault : faults) told = told || fault.path == place.path;
      CHECK(told);
      CHECK(faults.size() == 1);
    }
  }
}

TEST_CASE("What a file cannot say is checked all the same") {
  const auto only = [](const Scene& scene, const std::string& path, const std::string& says) {
    const auto faults = contact::check_scene(scene);
    INFO(path << ": " << says << "\n" << all(faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].path == path);
    CHECK(faults[0].allowed.find(says) != std::string::npos);
  };
  Scene scene = sound();
  scene.bodies[1].inertia(0, 0) *= 1 + 2 * u;
  only(scene, "bodies[1].inertia", "solid_inertia()");
  scene = sound();
  scene.bodies[5].inertia(1, 1) = 1;
  only(scene, "bodies[5].inertia", "does not move");
  scene = sound();
  scene.bodies[5].mass = 1;
  only(scene, "bodies[5].mass", "does not move");
  scene = sound();
  scene.bodies[5].spin.x() = 1;
  only(scene, "bodies[5].spin", "does not move");
  scene = sound();
  scene.bodies[1].material = 2;
  only(scene, "bodies[1].material", "one of the materials");
  scene = sound();
  scene.bodies[0].position.x() = 1;
  only(scene, "bodies[0].position", "normal and offset");
  scene = sound();
  scene.bodies[0].orientation = {0, {1, 0, 0}};
  only(scene, "bodies[0].orientation.quaternion", "normal and offset");
  scene = sound();
  scene.bodies[0].moves = true;
  scene.bodies[0].mass = 1;
  only(scene, "bodies[0].moves", "never moves");
  scene = sound();
  scene.materials[1].damping = 1;
  only(scene, "materials[1].damping", "no stiffness");
  scene = sound();
  scene.bodies[2].name = "ball";
  only(scene, "bodies[2].name", "another body");
}

TEST_CASE("A box of corners has the volume and the inertia of the box") {
  Random random(1);
  for (int i = 0; i < generators::tried(500); ++i) {
    const double x = std::abs(random.magnitude(-3, 3));
    const double y = std::abs(random.magnitude(-3, 3));
    const double z = std::abs(random.magnitude(-3, 3));
    const double mass = std::abs(random.magnitude(-20, 20));
    HullShape corners;
    for (int k = 0; k < 8; ++k)
      corners.points.emplace_back((k & 1) != 0 ? x : -x, (k & 2) != 0 ? y : -y,
                                  (k & 4) != 0 ? z : -z);
    const BoxShape box{{x, y, z}};
    const double volume = contact::solid_volume(box);
    // Twelve triangles, each with a few roundings, of moments no larger than the box's own times
    // the longest edge over the shortest, at most 2^7: 12 * 16 u * 2^14 for the products of two.
    const double off = 0x1p22 * u;
    CHECK(std::abs(contact::solid_volume(corners) - volume) <= off * volume);
    const Matrix3<double> wanted = contact::solid_inertia(box, mass);
    const Matrix3<double> got = contact::solid_inertia(corners, mass);
    CHECK((got - wanted).cwiseAbs().maxCoeff() <= off * wanted.maxCoeff());
    // Exactly the same when the mass is twice as large.
    CHECK(contact::solid_inertia(corners, 2 * mass) == Matrix3<double>(2 * got));
  }
}

TEST_CASE("A capsule without a segment is a ball; a long one is nearly a rod") {
  Random random(2);
  for (int i = 0; i < generators::tried(500); ++i) {
    const double r = std::abs(random.magnitude(-10, 10));
    const double mass = std::abs(random.magnitude(-20, 20));
    const double ball = contact::solid_volume(BallShape{r});
    CHECK(std::abs(contact::solid_volume(CapsuleShape{r, 0}) - ball) <= 8 * u * ball);
    const Matrix3<double> a = contact::solid_inertia(BallShape{r}, mass);
    const Matrix3<double> b = contact::solid_inertia(CapsuleShape{r, 0}, mass);
    CHECK((a - b).cwiseAbs().maxCoeff() <= 8 * u * a.maxCoeff());
    // Four balls of volume per 16/3 r of segment: the cylinder of height 16/3 r.
    CHECK(std::abs(contact::solid_volume(CapsuleShape{r, 8 * r / 3}) - 5 * ball) <=
          16 * u * 5 * ball);
  }
}

TEST_CASE("A hull that is flat has neither volume nor inertia") {
  const HullShape flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
  CHECK(contact::solid_volume(flat) == 0);
  CHECK(contact::solid_inertia(flat, 1) == Matrix3<double>::Zero());
  CHECK(contact::solid_volume(HalfSpaceShape{}) == 0);
}

TEST_CASE("Two balls: the gap has the sign that exact arithmetic gives, but for the slack") {
  Random random(3);
  int touching = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const bool grid = random.chance(0.5);
    const auto number = [&] {
      return grid ? static_cast<double>(random.integer(-8, 8)) : random.uniform(-8, 8);
    };
    const auto vector = [&] {
      const double x = number();
      const double y = number();
      return Vector3<double>(x, y, number());
    };
    const Vector3<double> x = vector();
    const Vector3<double> y = vector();
    const double r = std::abs(number()) + 0.5;
    const double s = grid ? std::abs(number()) + 0.5 : std::abs((x - y).norm() - r) + 0.001;
    const SceneBody a = body_of("a", BallShape{r}, x);
    const SceneBody b = body_of("b", BallShape{s}, y);
    const double gap = gap_of(a, b);
    const double slack = contact::touching_slack(a, b);
    const oracle::Vector d = oracle::exact(x) - oracle::exact(y);
    const Rational reach = Rational(r) + Rational(s);
    const Rational beyond = squared(d) - reach * reach;  // its sign is that of the gap
    if (std::abs(gap) > slack) CHECK((gap > 0) == (beyond > 0));
    if (beyond == 0) {
      ++touching;
      CHECK(gap >= -slack);
    }
  }
  CHECK(touching > 0);
}

TEST_CASE("A turned box or hull over a half-space: the deepest corner decides") {
  Random random(4);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const double hx = random.uniform(0.1, 3);
    const double hy = random.uniform(0.1, 3);
    const double hz = random.uniform(0.1, 3);
    HullShape corners;
    for (int k = 0; k < 8; ++k)
      corners.points.emplace_back((k & 1) != 0 ? hx : -hx, (k & 2) != 0 ? hy : -hy,
                                  (k & 4) != 0 ? hz : -hz);
    const double x = random.uniform(-5, 5);
    const double y = random.uniform(-5, 5);
    const Vector3<double> place(x, y, random.uniform(-5, 5));
    SceneBody box = body_of("box", BoxShape{{hx, hy, hz}}, place);
    const double a = random.uniform(-1, 1);
    const double b = random.uniform(-1, 1);
    const double c = random.uniform(-1, 1);
    box.orientation = contact::normalised<double>({random.uniform(0.1, 1), {a, b, c}});
    SceneBody hull = box;
    hull.shape = corners;
    HalfSpaceShape ground;
    const double p = random.uniform(-1, 1);
    const double q = random.uniform(-1, 1);
    ground.normal = Vector3<double>(p, q, random.uniform(0.1, 1)).normalized();
    ground.offset = random.uniform(-2, 2);
    const SceneBody floor = body_of("floor", ground, {0, 0, 0}, false);
    double least = infinity;
    for (const Vector3<double>& corner : corners.points) {
      const Vector3<double> there = place + contact::matrix_of(box.orientation) * corner;
      least = std::min(least, ground.normal.dot(there) - ground.offset);
    }
    CHECK(std::abs(gap_of(box, floor) - least) <= 64 * u * 16);
    CHECK(std::abs(gap_of(hull, floor) - least) <= 64 * u * 16);
    // A ball that holds the box reaches as far or further, and so does no direction's reach.
    CHECK(contact::bounding_radius(box.shape) >=
          ground.normal.dot(place) - ground.offset - least - 64 * u * 16);
  }
}

TEST_CASE("A ball at a box: before a face, an edge and a corner, and inside") {
  const SceneBody box = body_of("box", BoxShape{{1, 2, 3}}, {10, 0, 0});
  const auto gap = [&](double x, double y, double z) {
    return gap_of(body_of("ball", BallShape{0.5}, {x, y, z}), box);
  };
  CHECK(gap(12, 0, 0) == 0.5);
  CHECK(gap(11.5, 0, 0) == 0);
  CHECK(gap(10, 0, -4) == 0.5);
  CHECK(gap(14, 6, 0) == 4.5);       // 3 and 4 beyond an edge
  CHECK(gap(13, -5, 9) == 6.5);      // 2, 3 and 6 beyond a corner: 7
  CHECK(gap(10.5, 0, 0) == -1);      // 0.5 below a face, and the radius
  CHECK(gap(10, 0, 2.75) == -0.75);  // 0.25 below the nearest face
  SceneBody turned = box;            // a quarter turn about z: x and y change places
  turned.orientation = {std::sqrt(0.5), {0, 0, std::sqrt(0.5)}};
  const double got = gap_of(body_of("ball", BallShape{0.5}, {13, 0, 0}), turned);
  CHECK(std::abs(got - 0.5) <= 64 * u);
}

TEST_CASE("A ball at a capsule: beside the segment and beyond its ends") {
  const SceneBody rod = body_of("rod", CapsuleShape{0.25, 2}, {0, 0, 1});
  const auto gap = [&](double x, double y, double z) {
    return gap_of(body_of("ball", BallShape{0.5}, {x, y, z}), rod);
  };
  CHECK(gap(1.75, 0, 2.5) == 1);
  CHECK(gap(0, 0, 4) == 0.25);
  CHECK(gap(3, 0, 7) == 4.25);
  CHECK(gap(0, 0, 0) == -0.75);
}

TEST_CASE("No gap is told of two half-spaces") {
  const SceneBody floor = body_of("floor", HalfSpaceShape{}, {0, 0, 0}, false);
  CHECK_FALSE(contact::starting_gap(floor, floor));
}

TEST_CASE(
    "The gap between tetrahedra: face to face, corner to face, edge to edge, and in each other") {
  const HullShape shape{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  const auto gap = [&](double x, double y, double z) {
    return gap_of(body_of("a", shape, {0, 0, 0}), body_of("b", shape, {x, y, z}));
  };
  // From -2 to 2 along each axis the differences of two points of them reach: a cuboctahedron.
  CHECK(gap(2.5, 0, 0) == 0.5);
  CHECK(gap(2, 0, 0) == 0);
  CHECK(gap(1.75, 0, 0) == -0.25);
  CHECK(std::abs(gap(3, 3, 0) - std::sqrt(2.0)) <= 16 * u);       // beyond the corner (2, 2, 0)
  CHECK(std::abs(gap(2, 2, 2) - 2 / std::sqrt(3.0)) <= 16 * u);   // over x + y + z = 4
  CHECK(std::abs(gap(1, 1, 1) - -1 / std::sqrt(3.0)) <= 16 * u);  // below it
  CHECK(gap(0, 0, 0) == -2);
}

TEST_CASE("A hull of a box's corners is as far from everything as the box") {
  Random random(31);
  int apart = 0;
  for (int i = 0; i < generators::tried(160); ++i) {
    const auto size = [&] { return random.uniform(0.1, 1.0); };
    const auto somewhere = [&](const contact::SceneShape& shape) {
      SceneBody body = body_of("body", shape, {0, 0, 0}, false);
      for (int k = 0; k < 3; ++k) body.position(k) = random.uniform(-1.5, 1.5);
      Rotor<double>& turned = body.orientation;
      turned.w = random.uniform(-1.0, 1.0);
      for (int k = 0; k < 3; ++k) turned.v(k) = random.uniform(-1.0, 1.0);
      const double length = std::sqrt(turned.w * turned.w + turned.v.squaredNorm());
      turned.w /= length;
      turned.v /= length;
      return body;
    };
    Vector3<double> half_lengths;
    for (int k = 0; k < 3; ++k) half_lengths(k) = size();
    const SceneBody box = somewhere(BoxShape{half_lengths});
    SceneBody hull = box;
    HullShape corners;
    for (int k = 0; k < 8; ++k) {
      const Vector3<double> signs((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1,
                                  (k & 4) != 0 ? 1 : -1);
      corners.points.emplace_back(signs.cwiseProduct(half_lengths));
    }
    hull.shape = corners;
    const double width = size();
    const double height = size();
    const double length = size();
    for (const contact::SceneShape& shape : {contact::SceneShape(BallShape{width}),
                                             contact::SceneShape(BoxShape{{width, height, 0.3}}),
                                             contact::SceneShape(CapsuleShape{width, length})}) {
      const SceneBody other = somewhere(shape);
      const double wanted = gap_of(box, other);
      CHECK(std::abs(gap_of(hull, other) - wanted) <= 0x1p-44);
      apart += wanted > 0 ? 1 : 0;
    }
  }
  CHECK(apart > generators::tried(96));
  CHECK(apart < generators::tried(448));
}

TEST_CASE("A hull that begins within another body is a fault") {
  Scene scene = sound();
  SceneBody& hull = scene.bodies[4];
  hull.position = scene.bodies[2].position;
  const auto faults = contact::check_scene(scene);
  INFO(all(faults));
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].path == "bodies[4].position");
}

TEST_CASE("Gaps between boxes and capsules are those of the closed forms, either way round") {
  const SceneBody box = body_of("box", BoxShape{{1, 2, 3}}, {0, 0, 0});
  const SceneBody rod = body_of("rod", CapsuleShape{0.5, 1}, {0, 0, 0});
  const auto told = [](const SceneBody& a, SceneBody b, const Vector3<double>& at) {
    b.position = at;
    const auto one = contact::starting_gap(a, b);
    const auto other = contact::starting_gap(b, a);
    REQUIRE(one.has_value());
    CHECK(one == other);
    return *one;
  };
  CHECK(told(box, box, {2.25, 0, 0}) == 0.25);
  CHECK(told(box, box, {2, 0, 0}) == 0);
  CHECK(told(box, box, {1.75, 0.5, 0.5}) == -0.25);
  CHECK(told(box, rod, {1.75, 0, 0}) == 0.25);
  CHECK(told(box, rod, {0, 0, 4.25}) == -0.25);
  CHECK(told(rod, rod, {1.5, 0, 0.5}) == 0.5);
  CHECK(told(rod, rod, {0.75, 0, 1}) == -0.25);
}

TEST_CASE("Overlaps are found among many: those that looking at every pair finds") {
  Random random(5);
  int found = 0;
  for (int i = 0; i < generators::tried(300); ++i) {
    Scene scene = sound();
    scene.expect.clear();
    scene.bodies.clear();
    const int count = random.integer(2, 30);
    for (int n = 0; n < count; ++n) {
      const double x = random.integer(-6, 6);
      const double y = random.integer(-2, 2);
      const Vector3<double> place(x, y, random.integer(0, 3));
      const std::string name = "b_" + std::to_string(n);
      if (random.chance(0.1)) {
        SceneBody floor = body_of(name, HalfSpaceShape{}, {0, 0, 0}, false);
        scene.bodies.push_back(floor);
      } else if (random.chance(0.3)) {
        const double r = 0.25 * random.integer(1, 6);
        scene.bodies.push_back(body_of(name, BoxShape{{r, 0.5, 0.5}}, place, random.chance(0.5)));
      } else {
        scene.bodies.push_back(
            body_of(name, BallShape{0.25 * random.integer(1, 4)}, place, random.chance(0.8)));
      }
    }
    std::size_t wanted = 0;
    for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
      for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
        const auto gap = contact::starting_gap(scene.bodies[a], scene.bodies[b]);
        const bool moves = scene.bodies[a].moves || scene.bodies[b].moves;
        if (gap && moves && -*gap > contact::touching_slack(scene.bodies[a], scene.bodies[b]))
          ++wanted;
      }
    }
    const auto faults = contact::check_scene(scene);
    INFO(all(faults));
    CHECK(faults.size() == wanted);
    found += static_cast<int>(wanted);
  }
  CHECK(found > generators::tried(1000));
}

TEST_CASE("Balls that touch to the last bit do not overlap; a billionth deeper they do") {
  Scene scene = sound();
  scene.bodies.clear();
  scene.expect.clear();
  const double height = std::sqrt(0.75);  // three balls of radius 1/2 that touch each other
  scene.bodies.push_back(body_of("a", BallShape{0.5}, {0, 0, 0}));
  scene.bodies.push_back(body_of("b", BallShape{0.5}, {1, 0, 0}));
  scene.bodies.push_back(body_of("c", BallShape{0.5}, {0.5, height, 0}));
  CHECK(contact::check_scene(scene).empty());
  scene.bodies[2].position.y() -= 1e-9;
  CHECK(contact::check_scene(scene).size() == 2);
}

TEST_CASE("A number's shortest text gives the same bits back") {
  Random random(6);
  for (int i = 0; i < generators::tried(10000); ++i) {
    const double x = random.magnitude(-1000, 1000);
    CHECK(std::stod(contact::shortest_text(x)) == x);
  }
  CHECK(contact::shortest_text(0.1) == "0.1");
  CHECK(contact::shortest_text(no_number) == "NaN");
  CHECK(contact::shortest_text(-infinity) == "-Infinity");
}

TEST_CASE("The material of a pair: lesser restitution and friction, springs in a row") {
  const contact::SceneMaterial a{"a", 0.5, 0.25, 100.0, 1};
  const contact::SceneMaterial b{"b", 0.25, 0.5, 300.0, 2};
  const contact::SceneMaterial hard{"hard", 1, 1, std::nullopt, 0};
  const auto pair = contact::pair_material(a, b);
  CHECK(pair.restitution == 0.25);
  CHECK(pair.friction == 0.25);
  CHECK(pair.stiffness == 75.0);
  CHECK(pair.damping == 3);
  CHECK(contact::pair_material(hard, a).stiffness == 100.0);
  CHECK(contact::pair_material(a, hard).stiffness == 100.0);
  CHECK_FALSE(contact::pair_material(hard, hard).stiffness);
  Random random(7);
  for (int i = 0; i < generators::tried(2000); ++i) {
    contact::SceneMaterial x{"x", random.uniform(), random.uniform(), std::nullopt, 0};
    contact::SceneMaterial y{"y", random.uniform(), random.uniform(), std::nullopt, 0};
    x.stiffness = std::abs(random.magnitude(-40, 40));
    if (random.chance(0.7)) y.stiffness = std::abs(random.magnitude(-40, 40));
    const auto one = contact::pair_material(x, y);
    const auto other = contact::pair_material(y, x);
    CHECK(one.restitution == other.restitution);
    CHECK(one.friction == other.friction);
    CHECK(one.stiffness == other.stiffness);
    CHECK(*one.stiffness <= *x.stiffness * (1 + 8 * u));  // three roundings
  }
}
