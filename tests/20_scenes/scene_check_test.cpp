// check_scene() on scenes that a program makes, and the matter of shapes against closed forms.
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

#include "sound_scene.hpp"
#include "support/generators.hpp"

using contact::BallShape;
using contact::BoxShape;
using contact::CapsuleShape;
using contact::HalfSpaceShape;
using contact::HullShape;
using contact::Matrix3;
using contact::Scene;
using contact::SceneBody;
using contact::SceneFault;
using contact::Vector3;
using generators::Random;
using sound_scene::body_of;
using sound_scene::infinity;
using sound_scene::u;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

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
    list.push_back({"bodies[1].angular_velocity" + end,
                    [k](Scene& s) -> double& { return s.bodies[1].angular_velocity(k); }});
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

}  // namespace

TEST_CASE("A scene without a fault has none") {
  const auto faults = contact::check_scene(sound());
  INFO(all(faults));
  CHECK(faults.empty());
}

TEST_CASE("Every number of a scene is rejected where it is not finite, by its path") {
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

TEST_CASE("Faults that a file cannot have are checked too") {
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
  scene.bodies[5].angular_velocity.x() = 1;
  only(scene, "bodies[5].angular_velocity", "does not move");
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

TEST_CASE("The hull of a box's vertices has the volume and the inertia of the box") {
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

TEST_CASE("A hull that starts within another body is a fault") {
  Scene scene = sound();
  SceneBody& hull = scene.bodies[4];
  hull.position = scene.bodies[2].position;
  const auto faults = contact::check_scene(scene);
  INFO(all(faults));
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].path == "bodies[4].position");
}

TEST_CASE("Overlaps are found among many: the same as by testing every pair") {
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

TEST_CASE("The material of a pair: smaller restitution and friction, springs in series") {
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
