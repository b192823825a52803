#pragma once

// The members of an entry of `bodies` that concern one body: shape, orientation, mass, and its
// repetition.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <contact/quaternion.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_solids.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/vector.hpp>

#include "json_tree.hpp"
#include "scene_fields.hpp"

namespace contact::scenes::detail {

/// cos and sin of half an angle in degrees; exact for multiples of 90°.
inline SineCosine<double> half_of_degrees(double degrees) {
  constexpr double pi = 3.141592653589793;
  const double half = std::fmod(degrees, 720.0) / 2;
  const double quarters = std::nearbyint(half / 90);
  const double rest = half - 90 * quarters;
  const auto [sine, cosine] = sine_cosine<double>(rest * pi / 180);
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

/// How an entry of `bodies` is repeated.
struct Repeat {
  std::array<std::size_t, 3> count{1, 1, 1};
  Vector3<double> spacing = Vector3<double>::Zero();
  double jitter = 0;
  double speed = 0;
  std::uint64_t seed = 0;
  std::size_t limit = max_scene_bodies;

  [[nodiscard]] std::size_t total() const {
    return std::min(limit, count[0] * count[1] * count[2]);
  }
};

/// Reads it.
class BodyFieldReader : protected FieldReader {
 protected:
  using FieldReader::FieldReader;

  std::optional<SceneShape> shape(const JsonNode& from, const std::string& body_path) {
    const std::string path = body_path + ".shape";
    const JsonNode* node = member(from, body_path, "shape", "an object with a type");
    if (!node || !kind(*node, path, JsonKind::object)) return std::nullopt;
    const Keys types{"sphere", "box", "capsule", "hull", "half_space"};
    const JsonNode* type = member(*node, path, "type", "one of " + joined(types));
    if (!type || !kind(*type, path + ".type", JsonKind::text)) return std::nullopt;
    if (type->text == "sphere") {
      object(*node, path, {"type", "radius"});
      return BallShape{number(*node, path, "radius", "m").value_or(0)};
    }
    if (type->text == "box") {
      object(*node, path, {"type", "half_lengths"});
      return BoxShape{vector(*node, path, "half_lengths", true)};
    }
    if (type->text == "capsule") {
      object(*node, path, {"type", "radius", "half_length"});
      CapsuleShape capsule;
      capsule.radius = number(*node, path, "radius", "m").value_or(0);
      capsule.half_length = number(*node, path, "half_length", "m").value_or(0);
      return capsule;
    }
    if (type->text == "hull") {
      object(*node, path, {"type", "points"});
      return hull(*node, path);
    }
    if (type->text == "half_space") {
      object(*node, path, {"type", "normal", "offset"});
      HalfSpaceShape ground;
      ground.normal = vector(*node, path, "normal", true);
      ground.offset = number(*node, path, "offset", "m").value_or(0);
      return ground;
    }
    unfit(path + ".type", *type, hint(type->text, types) + "must be one of " + joined(types));
    return std::nullopt;
  }

  std::optional<SceneShape> hull(const JsonNode& node, const std::string& path) {
    const JsonNode* points = member(node, path, "points", "an array of points, each of 3 numbers");
    if (!points || !kind(*points, path + ".points", JsonKind::array, " of points"))
      return std::nullopt;
    if (points->items.size() < 4) {
      unfit(path + ".points", *points, "must be at least 4 points");
      return std::nullopt;
    }
    HullShape shape;
    bool good = true;
    for (std::size_t i = 0; i < points->items.size(); ++i) {
      const auto values = numbers<3>(points->items[i], at(path + ".points", i));
      good = good && values;
      if (good) shape.points.emplace_back((*values)[0], (*values)[1], (*values)[2]);
    }
    if (!good) return std::nullopt;
    return shape;
  }

  Quaternion<double> orientation(const JsonNode& from, const std::string& body_path) {
    const JsonNode* node = from.find("orientation");
    const std::string path = body_path + ".orientation";
    if (!node) return {};
    if (!object(*node, path, {"quaternion", "axis", "degrees", "radians"})) return {};
    const JsonNode* quaternion = node->find("quaternion");
    if (quaternion) {
      absent(*node, path, {"axis", "degrees", "radians"}, "there is a quaternion");
      const auto q = numbers<4>(*quaternion, path + ".quaternion");
      if (!q) return {};
      return {(*q)[0], {(*q)[1], (*q)[2], (*q)[3]}};
    }
    const Vector3<double> axis = vector(*node, path, "axis", true);
    std::optional<double> angle;
    const bool degrees = node->find("degrees") != nullptr;
    if (degrees) {
      absent(*node, path, {"radians"}, "there are degrees");
      angle = number(*node, path, "degrees", "degrees");
    } else if (node->find("radians")) {
      angle = number(*node, path, "radians", "rad");
    } else {
      fault(path, "{...}", "must have a quaternion, or an axis and degrees or radians");
    }
    const double most = degrees ? 36000 : 628;
    if (angle && !(std::abs(*angle) <= most)) {
      fault(path + (degrees ? ".degrees" : ".radians"), shortest_text(*angle),
            "must be from -" + shortest_text(most) + " to " + shortest_text(most));
      angle.reset();
    }
    if (is_wrong(path + ".axis")) return {};
    const double largest = axis.cwiseAbs().maxCoeff();
    if (!(min_scene_value <= largest && largest <= max_scene_value)) {
      unfit(path + ".axis", *node->find("axis"),
            "must be a direction: not zero, its largest coordinate from 1e-30 to 1e+30");
      return {};
    }
    if (!angle) return {};
    return degrees ? from_axis_half_angle(axis, half_of_degrees(*angle))
                   : from_axis_angle(axis, *angle);
  }

  std::optional<std::uint64_t> whole(const JsonNode& from, const std::string& path,
                                     const std::string& key, double least, double most) {
    const auto value = number(from, path, key, "a whole one");
    if (!value) return std::nullopt;
    if (!(least <= *value && *value <= most && *value == std::floor(*value))) {
      fault(below(path, key), from.find(key)->shown(),
            "must be a whole number from " + shortest_text(least) + " to " + shortest_text(most));
      return std::nullopt;
    }
    return static_cast<std::uint64_t>(*value);
  }

  double range(const JsonNode& from, const std::string& path, const std::string& key,
               const std::string& unit) {
    const double value = number_if_there(from, path, key, unit).value_or(0);
    if (0 <= value && value <= max_scene_value) return value;
    fault(below(path, key), shortest_text(value), "must be from 0 to 1e+30 " + unit);
    return 0;
  }

  std::optional<Repeat> repeat(const JsonNode& from, const std::string& body_path) {
    const JsonNode* node = from.find("repeat");
    if (!node) return std::nullopt;
    const std::string path = body_path + ".repeat";
    Repeat repeat;
    if (!object(*node, path, {"count", "spacing", "jitter", "speed", "seed", "limit"}))
      return repeat;
    if (const JsonNode* count = member(*node, path, "count", "an array of 3 whole numbers")) {
      const auto values = numbers<3>(*count, path + ".count");
      double product = 1;
      for (std::size_t k = 0; values && k < 3; ++k) {
        const double value = (*values)[k];
        const auto most = static_cast<double>(max_scene_bodies);
        if (!(1 <= value && value <= most && value == std::floor(value))) {
          unfit(at(path + ".count", k), count->items[k],
                "must be a whole number from 1 to " + std::to_string(max_scene_bodies));
        } else {
          repeat.count[k] = static_cast<std::size_t>(value);
          product *= value;
        }
      }
      if (product > static_cast<double>(max_scene_bodies)) {
        unfit(path + ".count", *count,
              "must not make more than " + std::to_string(max_scene_bodies) + " bodies");
        repeat.count = {1, 1, 1};
      }
    }
    repeat.spacing = vector(*node, path, "spacing", true);
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(repeat.spacing(k)) <= max_scene_value)) {
        fault(at(path + ".spacing", static_cast<std::size_t>(k)), shortest_text(repeat.spacing(k)),
              "must be from -1e+30 to 1e+30 m");
        repeat.spacing(k) = 0;
      }
    }
    repeat.jitter = range(*node, path, "jitter", "m");
    repeat.speed = range(*node, path, "speed", "m/s");
    if (node->find("seed")) {
      repeat.seed = whole(*node, path, "seed", 0, 9007199254740991).value_or(0);
    } else if (node->find("jitter") || node->find("speed")) {
      fault(path + ".seed", "",
            "is missing; must be a whole number: jitter and speed draw from its sequence");
    }
    if (node->find("limit"))
      repeat.limit = static_cast<std::size_t>(
          whole(*node, path, "limit", 1, static_cast<double>(max_scene_bodies)).value_or(1));
    return repeat;
  }

  void mass(const JsonNode& node, const std::string& path, SceneBody& body, bool shaped) {
    const JsonNode* density = node.find("density");
    if (density && node.find("mass")) absent(node, path, {"density"}, "there is a mass");
    if (!density || node.find("mass")) {
      if (!density && !node.find("mass")) {
        fault(path + ".mass", "",
              "is missing; must be a number, kg (or there is a density, kg/m^3)");
        return;
      }
      body.mass = number(node, path, "mass", "kg").value_or(0);
      return;
    }
    wrong_.insert(path + ".mass");  // reported for the density, if at all
    const auto value = number(node, path, "density", "kg/m^3");
    if (!value) return;
    if (!(min_scene_value <= *value && *value <= max_scene_value)) {
      fault(path + ".density", shortest_text(*value),
            "must be greater than 0, from 1e-30 to 1e+30 kg/m^3");
      return;
    }
    if (!shaped || !sized(body.shape)) return;
    body.mass = *value * solid_volume(body.shape);
    if (!(min_scene_value <= body.mass && body.mass <= max_scene_value))
      fault(path + ".density", shortest_text(*value),
            "must give a mass from 1e-30 to 1e+30 kg, and gives " + shortest_text(body.mass));
  }

  /// Whether volume and inertia of a shape can be computed.
  static bool sized(const SceneShape& shape) {
    const auto good = [](double x) { return min_scene_value <= x && x <= max_scene_value; };
    if (const auto* ball = std::get_if<BallShape>(&shape)) return good(ball->radius);
    if (const auto* box = std::get_if<BoxShape>(&shape))
      return good(box->half_lengths.x()) && good(box->half_lengths.y()) &&
             good(box->half_lengths.z());
    if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
      return good(capsule->radius) && 0 <= capsule->half_length &&
             capsule->half_length <= max_scene_value;
    if (const auto* hull = std::get_if<HullShape>(&shape))
      return std::all_of(hull->points.begin(), hull->points.end(),
                         [](const auto& point) {
                           return point.cwiseAbs().maxCoeff() <= max_scene_value;
                         }) &&
             solid_volume(shape) > 0;
    return false;
  }
};

}  // namespace contact::scenes::detail
