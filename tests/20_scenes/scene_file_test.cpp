// Scenes as files: the book's own, a table of broken ones, and random scenes there and back.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/quaternion.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_check.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_solids.hpp>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "scene_texts.hpp"
#include "support/generators.hpp"

namespace fs = std::filesystem;
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
using scene_texts::root;
using scene_texts::same;
using scene_texts::text_in;
using scene_texts::unit_roundoff;
using scene_texts::vector_of_any;

namespace {

const fs::path folder = root / "chapters" / "20_scenes" / "scenes";

std::vector<FileFault> faults_of(const std::string& text) {
  try {
    scene_from_text(text, "scene.json");
  } catch (const SceneFileError& error) {
    return error.faults();
  }
  return {};
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
    default: {  // four corners of a box, no two on an edge: the centre is that of the box
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
  scene.gravity = vector_of_any(random);
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
      const Vector3<double> normal = vector_of_any(random);
      body.shape = contact::HalfSpaceShape{normal / normal.norm(), -0x1p50};
      body.moves = false;
      scene.bodies.push_back(body);
      continue;
    }
    body.shape = any_shape(random);
    body.moves = random.chance(0.8);
    // Far from each other, so that none overlaps.
    body.position = Vector3<double>(0x1p40 * i, random.magnitude(-30, 30), -0.0);
    const Vector3<double> turn = vector_of_any(random);
    body.orientation = contact::exponential<double>(turn / turn.norm() * random.uniform(0, 6));
    if (body.moves) {
      body.mass = std::abs(random.magnitude(-90, 90));
      body.inertia = contact::solid_inertia(body.shape, body.mass);
      body.velocity = vector_of_any(random);
      body.angular_velocity = vector_of_any(random);
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

TEST_CASE("Every scene of the book is read, is named like its file and is reproduced bit for bit") {
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

TEST_CASE("Where nothing is lost, a scene expects its initial energy") {
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
        const Vector3<double> turned =
            contact::matrix_of(body.orientation).transpose() * body.angular_velocity;
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

TEST_CASE("Every fault of the table is reported with its path, its line and what is allowed") {
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

TEST_CASE("A value that is not a number is reported as it is written in the file") {
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

TEST_CASE("A comma without a value beside it is called a stray comma, in its line") {
  const std::string specimen = text_in(root / "tests/20_scenes/specimen.json");
  const auto said = [&](const std::string& from, const std::string& to) {
    std::string text = specimen;
    text.replace(text.find(from), from.size(), to);
    const std::vector<FileFault> faults = faults_of(text);
    REQUIRE(faults.size() == 1);
    return std::to_string(faults[0].line) + ": " + faults[0].fault.allowed;
  };
  const std::string of = "is not JSON: a stray comma ";
  CHECK(said("[0, 0, -9.81]", "[0, 0, -9.81,]") == "6: " + of + "before ]; take it out");
  CHECK(said("[0, 0, -9.81]", "[0, 0, -9.81 , \n ]") == "7: " + of + "before ]; take it out");
  CHECK(said("[0, 0, -9.81]", "[0,, 0, -9.81]") == "6: " + of + "after a comma; take it out");
  CHECK(said("[0, 0, -9.81]", "[, 0, 0, -9.81]") == "6: " + of + "after [; take it out");
  CHECK(said("\"mass\": 2", "\"mass\": 2, }").ends_with(of + "before }; take it out"));
  // A comma in a text is none of them.
  CHECK(said("[0, 0, -9.81]", "[0, 0, \",]\" 1]").find("comma") == std::string::npos);
}

TEST_CASE("An error shows at most 200 characters of a value, and whole ones") {
  const std::string specimen = text_in(root / "tests/20_scenes/specimen.json");
  const std::string longer = [] {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "é";
    return text;
  }();
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = specimen;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  for (const std::string& text :
       {replaced("\"steel\"", "\"" + longer + "\""), replaced("\"SI\"", "\"" + longer + "\""),
        replaced("\"gravity\"", "\"" + longer + "\""),
        replaced("[0, 0, -9.81]", "[\"" + longer + "\", \"" + longer + "\", \"" + longer +
                                      "\", \"" + longer + "\"]"),
        replaced("\"mass\": 2", "\"mass\": " + std::string(5000, '7')),
        replaced("\"mass\": 2", "\"mass\": " + std::string(5000, 'x'))}) {
    const std::vector<FileFault> faults = faults_of(text);
    REQUIRE_FALSE(faults.empty());
    for (const FileFault& fault : faults) {
      INFO(contact::fault_text(fault.fault));
      CHECK(fault.fault.value.size() <= 200);
      CHECK(fault.fault.path.size() <= 200);
      CHECK(contact::fault_text(fault.fault).size() <= 800);
      CHECK_NOTHROW(nlohmann::json(contact::fault_text(fault.fault)).dump());  // UTF-8
    }
  }
  CHECK(contact::shortened(std::string(200, 'x')) == std::string(200, 'x'));
  CHECK(contact::shortened(std::string(201, 'x')) == std::string(197, 'x') + "...");
  CHECK(contact::shortened("ééé", 5) == "é...");
}

TEST_CASE("A text that is not a scene at all is reported without a path") {
  const auto said = [](const std::string& text) -> std::string {
    try {
      contact::scenes::scene_from_text(text, "file");
    } catch (const contact::scenes::SceneFileError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(said("[1]") == "file:1: [1]: a scene must be an object, {...}");
  CHECK(said(" \n") == "file:2: is not JSON: the file is empty");
  const std::string bytes =
      "file:1: is not JSON: must be a text in UTF-8, and has bytes that are not";
  CHECK(said(std::string("\0\0", 2)) == bytes);
  CHECK(said("{\"name\": \"\xff\"}") == bytes);
}

TEST_CASE(
    "All faults of a file are reported at once, in the order of its lines, the file's name first") {
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

TEST_CASE("A text cut off anywhere is rejected without a crash") {
  const std::string specimen = text_in(root / "tests/20_scenes/specimen.json");
  for (std::size_t length = 0; length + 2 < specimen.size(); length += 7) {
    INFO(length);
    CHECK(faults_of(specimen.substr(0, length)).size() == 1);
  }
}

TEST_CASE("Any scene is reproduced from its text bit for bit") {
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

TEST_CASE("An invalid scene is not written") {
  Random random(21);
  Scene scene = any_scene(random);
  scene.duration = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(text_of_scene(scene), SceneFileError);
}

TEST_CASE("A scene is written into a file and read from it; a missing file is reported") {
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
