// Scenes as files: the book's own, a table of broken ones, and random scenes there and back.
#include <array>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/rotation.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_check.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_solids.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/generators.hpp"

using contact::Matrix3;
using contact::Rotor;
using contact::Scene;
using contact::SceneBody;
using contact::SceneExpectation;
using contact::SceneMaterial;
using contact::Vector3;
using contact::scenes::FileFault;
using contact::scenes::scene_from_text;
using contact::scenes::SceneFileError;
using contact::scenes::text_of_scene;
using generators::Random;
namespace fs = std::filesystem;

namespace {

constexpr double unit_roundoff = 0x1p-53;
const fs::path root = CONTACT_SOURCE_DIR;
const fs::path folder = root / "chapters" / "20_scenes" / "scenes";

std::string text_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
template <class Derived>
bool same(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!same(a.derived().coeff(i % a.rows(), i / a.rows()),
              b.derived().coeff(i % a.rows(), i / a.rows())))
      return false;
  }
  return true;
}
bool same(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}
bool same(const contact::SceneShape& a, const contact::SceneShape& b) {
  if (a.index() != b.index()) return false;
  if (const auto* ball = std::get_if<contact::BallShape>(&a))
    return same(ball->radius, std::get<contact::BallShape>(b).radius);
  if (const auto* box = std::get_if<contact::BoxShape>(&a))
    return same(box->half_lengths, std::get<contact::BoxShape>(b).half_lengths);
  if (const auto* capsule = std::get_if<contact::CapsuleShape>(&a))
    return same(capsule->radius, std::get<contact::CapsuleShape>(b).radius) &&
           same(capsule->half_length, std::get<contact::CapsuleShape>(b).half_length);
  if (const auto* hull = std::get_if<contact::HullShape>(&a)) {
    const auto& other = std::get<contact::HullShape>(b);
    if (hull->points.size() != other.points.size()) return false;
    for (std::size_t i = 0; i < hull->points.size(); ++i) {
      if (!same(hull->points[i], other.points[i])) return false;
    }
    return true;
  }
  const auto& ground = std::get<contact::HalfSpaceShape>(a);
  const auto& other = std::get<contact::HalfSpaceShape>(b);
  return same(ground.normal, other.normal) && same(ground.offset, other.offset);
}
bool same(const SceneBody& a, const SceneBody& b) {
  return a.name == b.name && same(a.shape, b.shape) && a.material == b.material &&
         a.moves == b.moves && same(a.mass, b.mass) && same(a.inertia, b.inertia) &&
         same(a.position, b.position) && same(a.orientation.w, b.orientation.w) &&
         same(a.orientation.v, b.orientation.v) && same(a.velocity, b.velocity) &&
         same(a.spin, b.spin);
}
bool same(const SceneMaterial& a, const SceneMaterial& b) {
  return a.name == b.name && same(a.restitution, b.restitution) && same(a.friction, b.friction) &&
         same(a.stiffness, b.stiffness) && same(a.damping, b.damping);
}
bool same(const SceneExpectation& a, const SceneExpectation& b) {
  return a.quantity == b.quantity && a.body == b.body && same(a.time, b.time) &&
         same(a.value, b.value) && same(a.within, b.within) && a.why == b.why;
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}
bool same(const Scene& a, const Scene& b) {
  return a.name == b.name && a.about == b.about && same(a.gravity, b.gravity) &&
         same(a.materials, b.materials) && same(a.bodies, b.bodies) &&
         same(a.duration, b.duration) && same(a.tolerance.position, b.tolerance.position) &&
         a.tolerance.event_order == b.tolerance.event_order &&
         same(a.output.every, b.output.every) && a.output.velocities == b.output.velocities &&
         a.output.events == b.output.events && same(a.expect, b.expect);
}

std::vector<FileFault> faults_of(const std::string& text) {
  try {
    scene_from_text(text, "scene.json");
  } catch (const SceneFileError& error) {
    return error.faults();
  }
  return {};
}

/// The specimen with a ball's orientation in other words.
Rotor<double> orientation_of(const nlohmann::json& said) {
  nlohmann::json scene = nlohmann::json::parse(text_in(root / "tests/20_scenes/specimen.json"));
  scene["bodies"][1]["orientation"] = said;
  return scene_from_text(scene.dump(), "scene.json").bodies[1].orientation;
}

Vector3<double> any_vector(Random& random) {
  const double x = random.magnitude(-30, 30);
  const double y = random.magnitude(-30, 30);
  return {x, y, random.magnitude(-30, 30)};
}

contact::SceneShape any_shape(Random& random) {
  const auto size = [&] { return std::abs(random.magnitude(-10, 10)); };
  switch (random.integer(0, 3)) {
    case 0:
      return contact::BallShape{size()};
    case 1: {
      const double x = size();
      const double y = size();
      return contact::BoxShape{{x, y, size()}};
    }
    case 2: {
      const double radius = size();
      return contact::CapsuleShape{radius, random.chance(0.2) ? 0 : size()};
    }
    default: {  // four of the corners of a box, no two on an edge: the middle is that of the box
      const double x = size();
      const double y = size();
      const double z = size();
      return contact::HullShape{{{x, y, z}, {x, -y, -z}, {-x, y, -z}, {-x, -y, z}}};
    }
  }
}

Scene any_scene(Random& random) {
  Scene scene;
  scene.name = "scene_" + std::to_string(random.integer(0, 999));
  scene.about = random.chance(0.5) ? "a \"quoted\" \\ word\n\t\x01"
                                   : "Kugeln \xc3\xbc"
                                     "ber \xe2\x88\x9e";
  scene.gravity = any_vector(random);
  const int materials = random.integer(1, 3);
  for (int i = 0; i < materials; ++i) {
    SceneMaterial material;
    material.name = "material_" + std::to_string(i);
    material.restitution = random.uniform();
    material.friction = std::abs(random.magnitude(-20, 3));
    if (random.chance(0.5)) {
      material.stiffness = std::abs(random.magnitude(-60, 60));
      material.damping = random.chance(0.5) ? 0 : std::abs(random.magnitude(-60, 60));
    }
    scene.materials.push_back(material);
  }
  const int bodies = random.integer(1, 8);
  for (int i = 0; i < bodies; ++i) {
    SceneBody body;
    body.name = "body_" + std::to_string(i);
    body.material = static_cast<std::size_t>(random.integer(0, materials - 1));
    if (random.chance(0.1)) {
      const Vector3<double> normal = any_vector(random);
      body.shape = contact::HalfSpaceShape{normal / normal.norm(), -0x1p50};
      body.moves = false;
      scene.bodies.push_back(body);
      continue;
    }
    body.shape = any_shape(random);
    body.moves = random.chance(0.8);
    // Far from each other, so that none overlaps.
    body.position = Vector3<double>(0x1p40 * i, random.magnitude(-30, 30), -0.0);
    const Vector3<double> turn = any_vector(random);
    body.orientation = contact::exponential<double>(turn / turn.norm() * random.uniform(0, 6));
    if (body.moves) {
      body.mass = std::abs(random.magnitude(-90, 90));
      body.inertia = contact::solid_inertia(body.shape, body.mass);
      body.velocity = any_vector(random);
      body.spin = any_vector(random);
    }
    scene.bodies.push_back(body);
  }
  scene.duration = std::abs(random.magnitude(-30, 30));
  if (random.chance(0.7)) scene.tolerance.position = std::abs(random.magnitude(-60, 0));
  scene.tolerance.event_order = !scene.tolerance.position || random.chance(0.5);
  scene.output.every = random.chance(0.5) ? 0 : random.uniform();
  scene.output.velocities = random.chance(0.5);
  scene.output.events = random.chance(0.5);
  if (random.chance(0.5)) {
    const double value = random.magnitude(-90, 90);
    scene.expect.push_back(
        {"energy", "", random.uniform() * scene.duration, value, random.uniform(), "why"});
    scene.expect.push_back({"speed", "body_0", 0, value, 0, "why"});
  }
  return scene;
}

}  // namespace

TEST_CASE("Every scene of the book is read, is named as its file and comes back bit for bit") {
  const auto files = contact::scenes::scenes_in(folder);
  REQUIRE(files.size() >= 20);
  for (const fs::path& file : files) {
    INFO(file);
    const Scene scene = contact::scenes::read_scene(file);
    CHECK(contact::check_scene(scene).empty());
    CHECK(scene.name == file.stem().string());
    CHECK_FALSE(scene.expect.empty());
    CHECK(fs::file_size(file) < 10'000);
    const std::string text = text_of_scene(scene);
    CHECK(same(scene, scene_from_text(text, "written")));
    CHECK(text_of_scene(contact::scenes::read_scene(file)) == text);
  }
}

TEST_CASE("Between them the book's scenes have every shape") {
  std::set<std::size_t> shapes;
  for (const fs::path& file : contact::scenes::scenes_in(folder)) {
    for (const SceneBody& body : contact::scenes::read_scene(file).bodies)
      shapes.insert(body.shape.index());
  }
  CHECK(shapes.size() == std::variant_size_v<contact::SceneShape>);
}

TEST_CASE("Where nothing is lost, a scene expects the energy that it begins with") {
  int asked = 0;
  for (const fs::path& file : contact::scenes::scenes_in(folder)) {
    const Scene scene = contact::scenes::read_scene(file);
    bool elastic = true;
    for (const SceneMaterial& material : scene.materials)
      elastic =
          elastic && material.restitution == 1 && material.friction == 0 && material.damping == 0;
    for (const SceneExpectation& wanted : scene.expect) {
      if (!elastic || wanted.quantity != "energy" || !wanted.body.empty()) continue;
      double energy = 0;
      double size = 0;
      for (const SceneBody& body : scene.bodies) {
        if (!body.moves) continue;
        const Vector3<double> turned = contact::matrix_of(body.orientation).transpose() * body.spin;
        const double kinetic =
            body.mass * body.velocity.squaredNorm() / 2 + turned.dot(body.inertia * turned) / 2;
        const double height = -body.mass * scene.gravity.dot(body.position);
        energy += kinetic + height;
        size += kinetic + std::abs(height);
      }
      INFO(scene.name);
      // n numbers are added, each off by a few u.
      CHECK(std::abs(energy - wanted.value) <=
            (static_cast<double>(scene.bodies.size()) + 8) * unit_roundoff * size);
      ++asked;
    }
  }
  CHECK(asked >= 8);
}

TEST_CASE("Every fault of the table is told with its path, its line and what is allowed") {
  const std::string specimen = text_in(root / "tests/20_scenes/specimen.json");
  const auto table = nlohmann::json::parse(text_in(root / "tests/20_scenes/scene_faults.json"));
  REQUIRE(faults_of(specimen).empty());
  REQUIRE(table["faults"].size() >= 100);
  for (const auto& entry : table["faults"]) {
    std::string text = specimen;
    if (entry.contains("patch")) {
      text = nlohmann::json::parse(specimen).patch(entry["patch"]).dump(1);
    } else {
      const auto from = entry["text"][0].get<std::string>();
      const std::size_t at = text.find(from);
      REQUIRE(at != std::string::npos);
      text.replace(at, from.size(), entry["text"][1].get<std::string>());
    }
    const std::vector<FileFault> faults = faults_of(text);
    INFO(entry.dump());
    REQUIRE_FALSE(faults.empty());
    const auto path = entry["path"].get<std::string>();
    const auto says = entry["says"].get<std::string>();
    bool found = false;
    std::string all;
    for (const FileFault& fault : faults) {
      all += "\n" + contact::fault_text(fault.fault);
      found = found ||
              (fault.fault.path == path && fault.fault.allowed.find(says) != std::string::npos);
      CHECK(fault.line >= 1);
    }
    INFO(all);
    CHECK(found);
    CHECK(faults.size() == 1);  // one mistake, one fault
  }
}

TEST_CASE("A value that is no number is told as it stands in the file") {
  const std::string specimen = text_in(root / "tests/20_scenes/specimen.json");
  const std::string mass = "\"mass\": 2";
  for (const std::string written :
       {"NaN", "nan", "-Infinity", "+1", ".5", "1e-400", "-0.01E-399"}) {
    std::string text = specimen;
    text.replace(text.find(mass), mass.size(), "\"mass\": " + written);
    const std::vector<FileFault> faults = faults_of(text);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].fault.path == "bodies[1].mass");
    CHECK(faults[0].fault.value == written);
  }
}

TEST_CASE("What is no scene at all is told without a path") {
  const auto said = [](const std::string& text) -> std::string {
    try {
      contact::scenes::scene_from_text(text, "file");
    } catch (const contact::scenes::SceneFileError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(said("[1]") == "file:1: [1]: a scene must be an object, {...}");
  CHECK(said(" \n") == "file:2: is no JSON: the file is empty");
  const std::string bytes =
      "file:1: is no JSON: must be a text in UTF-8, and holds bytes that are none";
  CHECK(said(std::string("\0\0", 2)) == bytes);
  CHECK(said("{\"name\": \"\xff\"}") == bytes);
}

TEST_CASE(
    "All faults of a file are told at once, in the order of its lines, the file's name first") {
  const std::string text =
      "{\n"
      "  \"format\": \"contact-scene/1\", \"units\": \"SI\", \"name\": \"broken\", \"about\": "
      "\"x\",\n"
      "  \"gravity\": [0, 0,\n"
      "    \"down\"],\n"
      "  \"materials\": [{\"name\": \"m\", \"restitution\": 2, \"friction\": 0}],\n"
      "  \"bodies\": [\n"
      "    {\"name\": \"a\", \"shape\": {\"type\": \"sphere\", \"radius\": 1}, \"material\": "
      "\"m\",\n"
      "     \"mass\": 0\n"
      "     , \"position\": [0, 0, 0]},\n"
      "    {\"name\": \"b\", \"shape\": {\"type\": \"cube\"}, \"material\": \"m\", \"mass\": 1,\n"
      "     \"position\": [0, 0, 0], \"colour\": \"red\"}],\n"
      "  \"duration\": -1,\n"
      "  \"tolerance\": {\"position\": 1e-3}\n"
      "}\n";
  try {
    scene_from_text(text, "folder/broken.json");
    FAIL("it was read");
  } catch (const SceneFileError& error) {
    const std::string told = error.what();
    INFO(told);
    std::istringstream lines(told);
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    REQUIRE(all.size() == 6);
    CHECK(all[0] == "folder/broken.json:4: gravity[2] = \"down\": must be a number");
    CHECK(all[1] == "folder/broken.json:5: materials[0].restitution = 2: must be from 0 to 1");
    CHECK(all[2].rfind("folder/broken.json:8: bodies[0].mass = 0: must be greater than 0", 0) == 0);
    CHECK(all[3].rfind("folder/broken.json:10: bodies[1].shape.type = \"cube\": must be one of",
                       0) == 0);
    CHECK(all[4].rfind("folder/broken.json:11: bodies[1].colour = \"red\": is an unknown key", 0) ==
          0);
    CHECK(all[5].rfind("folder/broken.json:12: duration = -1: must be greater than 0", 0) == 0);
  }
}

TEST_CASE("A text cut off anywhere is no scene, and says so without a crash") {
  const std::string specimen = text_in(root / "tests/20_scenes/specimen.json");
  for (std::size_t length = 0; length + 2 < specimen.size(); length += 7) {
    INFO(length);
    CHECK(faults_of(specimen.substr(0, length)).size() == 1);
  }
}

TEST_CASE("Any scene comes back from its text bit for bit") {
  Random random(20);
  for (int i = 0; i < generators::tried(800); ++i) {
    const Scene scene = any_scene(random);
    INFO(i);
    const auto faults = contact::check_scene(scene);
    INFO((faults.empty() ? "" : contact::fault_text(faults.front())));
    REQUIRE(faults.empty());
    const std::string text = text_of_scene(scene);
    REQUIRE(same(scene, scene_from_text(text, "written")));
  }
}

TEST_CASE("What is no scene is not written") {
  Random random(21);
  Scene scene = any_scene(random);
  scene.duration = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(text_of_scene(scene), SceneFileError);
}

TEST_CASE("A scene is written into a file and read from there; what is no file says so") {
  Random random(22);
  const Scene scene = any_scene(random);
  const fs::path file = fs::temp_directory_path() / "contact_scene_file_test.json";
  contact::scenes::write_scene(file, scene);
  CHECK(same(scene, contact::scenes::read_scene(file)));
  fs::remove(file);
  CHECK_THROWS_AS(contact::scenes::read_scene(file), std::runtime_error);
  CHECK_THROWS_AS(contact::scenes::read_scene(folder), std::runtime_error);
  CHECK_THROWS_AS(contact::scenes::write_scene(folder / "no" / "folder.json", scene),
                  std::runtime_error);
}

TEST_CASE("Axis and angle: multiples of 90 degrees exactly, others as sine and cosine say") {
  // Twice the half turn: the sign of a quaternion does not matter.
  const double r = std::sqrt(0.5);
  const std::array<std::array<double, 2>, 9> turns{
      {{0, 1}, {90, r}, {180, 0}, {270, -r}, {360, -1}, {-90, r}, {-180, 0}, {720, 1}, {-540, 0}}};
  for (const auto& [degrees, cosine] : turns) {
    const Rotor<double> q = orientation_of({{"axis", {0, 0, 5}}, {"degrees", degrees}});
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
    const Vector3<double> axis = any_vector(random);
    const nlohmann::json list{axis.x(), axis.y(), axis.z()};
    const Rotor<double> q = orientation_of({{"axis", list}, {"radians", angle}});
    const Rotor<double> d =
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
