// The meaning of a body's entry in a file: an orientation, a lattice of bodies, a density.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_file.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "scene_texts.hpp"
#include "support/generators.hpp"

using contact::Quaternion;
using contact::Scene;
using contact::SceneBody;
using contact::Vector3;
using contact::scenes::scene_from_text;
using generators::Random;
using scene_texts::root;
using scene_texts::same;
using scene_texts::text_in;
using scene_texts::unit_roundoff;
using scene_texts::vector_of_any;

namespace {

/// The specimen with a ball's orientation in other words.
Quaternion<double> orientation_of(const nlohmann::json& said) {
  nlohmann::json scene = nlohmann::json::parse(text_in(root / "tests/20_scenes/specimen.json"));
  scene["bodies"][1]["orientation"] = said;
  return scene_from_text(scene.dump(), "scene.json").bodies[1].orientation;
}

}  // namespace

TEST_CASE("Axis and angle: multiples of 90 degrees exactly, others as sine and cosine say") {
  // Twice half a revolution: the sign of a quaternion does not matter.
  const double r = std::sqrt(0.5);
  const std::array<std::array<double, 2>, 9> turns{
      {{0, 1}, {90, r}, {180, 0}, {270, -r}, {360, -1}, {-90, r}, {-180, 0}, {720, 1}, {-540, 0}}};
  for (const auto& [degrees, cosine] : turns) {
    const Quaternion<double> q = orientation_of({{"axis", {0, 0, 5}}, {"degrees", degrees}});
    INFO(degrees);
    CHECK(std::abs(q.w - cosine) <= 2 * unit_roundoff);
    if (cosine == 0) CHECK(std::abs(q.v.z()) == 1);
    if (std::abs(cosine) == 1) CHECK(q.v == Vector3<double>::Zero());
    CHECK(q.v.x() == 0);
    CHECK(q.v.y() == 0);
  }
  Random random(23);
  for (int i = 0; i < generators::tried(100); ++i) {
    const double angle = random.uniform(-600, 600);
    const Vector3<double> axis = vector_of_any(random);
    const nlohmann::json list{axis.x(), axis.y(), axis.z()};
    const Quaternion<double> q = orientation_of({{"axis", list}, {"radians", angle}});
    const Quaternion<double> d =
        orientation_of({{"axis", list}, {"degrees", angle * 180 / 3.141592653589793}});
    const Vector3<double> wanted = axis / axis.norm() * std::sin(angle / 2);
    // The angle is known to u of itself, half of it counts, and a few more roundings follow.
    const double off = unit_roundoff * (std::abs(angle) + 16);
    CHECK(std::abs(q.w - std::cos(angle / 2)) <= off);
    CHECK((q.v - wanted).cwiseAbs().maxCoeff() <= off);
    CHECK(std::abs(d.w - q.w) <= 2 * off);
    CHECK((d.v - q.v).cwiseAbs().maxCoeff() <= 2 * off);
  }
}

TEST_CASE(
    "A repeated body stands on its lattice, and is drawn from its seed in the order that the "
    "schema says") {
  nlohmann::json json = nlohmann::json::parse(text_in(root / "tests/20_scenes/specimen.json"));
  const Scene scene = scene_from_text(json.dump(), "scene.json");
  REQUIRE(scene.bodies.size() == 6 + 11);
  Random random(5);
  const auto unit = [&] { return 2 * random.uniform() - 1; };
  for (std::size_t n = 0; n < 11; ++n) {
    const SceneBody& body = scene.bodies[6 + n];
    CHECK(body.name == "gas_" + std::to_string(n));
    const Vector3<double> place(10 + static_cast<double>(n % 3),
                                10 + static_cast<double>(n / 3 % 2),
                                10 + static_cast<double>(n / 6));
    const double x = unit();
    const double y = unit();
    const double z = unit();
    CHECK(same(body.position, Vector3<double>(place + 0.125 * Vector3<double>(x, y, z))));
    Vector3<double> way;
    do {
      const double a = unit();
      const double b = unit();
      way = {a, b, unit()};
    } while (way.squaredNorm() > 1);
    CHECK(same(body.velocity, Vector3<double>(Vector3<double>::Zero() + 2.0 * way)));
    CHECK(same(body.mass, 0.1));
  }
  json["bodies"][6]["repeat"]["seed"] = 6;
  const Scene other = scene_from_text(json.dump(), "scene.json");
  CHECK_FALSE(same(scene.bodies[6].position, other.bodies[6].position));
  json["bodies"][6]["repeat"] = {{"count", {2, 1, 1}}, {"spacing", {0.5, 0, 0}}};
  const Scene plain = scene_from_text(json.dump(), "scene.json");
  CHECK(plain.bodies[7].position == Vector3<double>(10.5, 10, 10));
  CHECK(plain.bodies[7].velocity == Vector3<double>::Zero());
}

TEST_CASE("A density gives the mass of the volume") {
  const Scene scene = contact::scenes::read_scene(root / "tests/20_scenes/specimen.json");
  CHECK(scene.bodies[2].mass == 7800.0);  // 1 m by 0.5 m by 2 m
  // A third of the cube with edges of 2 m; the hull's volume is off by a few u.
  CHECK(std::abs(scene.bodies[4].mass - 2700 * 8.0 / 3) <= 64 * unit_roundoff * 7200);
  CHECK(same(scene.bodies[2].inertia,
             contact::box_inertia<double>(7800, Vector3<double>(1, 0.5, 2))));
}
