// A scene from its file: first every value's kind and every key, then the scene that comes of it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_solids.hpp>

#include "json_tree.hpp"
#include "scene_random.hpp"

namespace contact::scenes {

namespace detail {

using Keys = std::vector<std::string_view>;

CONTACT_SCENES_INLINE std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t k = 0; k <= b.size(); ++k) row[k] = k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t changed = diagonal + (a[i - 1] == b[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, changed});
    }
  }
  return row.back();
}

CONTACT_SCENES_INLINE std::string joined(const Keys& words) {
  std::string all;
  for (const std::string_view word : words) all += (all.empty() ? "" : ", ") + std::string(word);
  return all;
}

/// The nearest of some words, if it is near: at most a third of its letters differ, or one.
CONTACT_SCENES_INLINE std::string hint(std::string_view word, const Keys& words) {
  if (word.size() > 64) return "";
  std::string_view best;
  std::size_t least = 0;
  for (const std::string_view candidate : words) {
    const std::size_t far = distance(word, candidate);
    if (best.empty() || far < least) {
      best = candidate;
      least = far;
    }
  }
  if (best.empty() || least > std::max<std::size_t>(1, best.size() / 3)) return "";
  return "did you mean \"" + std::string(best) + "\"? ";
}

const char* const kind_names[] = {"null",   "true or false", "a number",
                                  "a text", "an array",      "an object"};

/// cos and sin of half an angle in degrees; multiples of 90° come out exactly.
CONTACT_SCENES_INLINE SineCosine<double> half_of_degrees(double degrees) {
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
  std::size_t limit = scene_most_bodies;

  [[nodiscard]] std::size_t total() const {
    return std::min(limit, count[0] * count[1] * count[2]);
  }
};

class Reader {
 public:
  Reader(const JsonNode& root, std::string file) : root_(root), file_(std::move(file)) {}

  Scene read() {
    if (root_.kind != JsonKind::object) {
      unfit("", root_, "a scene must be an object, {...}");
    } else if (object(root_, "",
                      {"format", "units", "name", "about", "gravity", "materials", "bodies",
                       "duration", "tolerance", "output", "expect"})) {
      fixed("format", "contact-scene/1");
      fixed("units", "SI");
      scene_.name = text(root_, "", "name");
      scene_.about = text(root_, "", "about");
      scene_.gravity = vector(root_, "", "gravity", true);
      materials();
      bodies();
      scene_.duration = number(root_, "", "duration", "s").value_or(0);
      tolerance();
      output();
      expectations();
    }
    check();
    if (!faults_.empty()) {
      std::stable_sort(faults_.begin(), faults_.end(),
                       [](const FileFault& a, const FileFault& b) { return a.line < b.line; });
      throw SceneFileError(file_, std::move(faults_));
    }
    return std::move(scene_);
  }

 private:
  // What is wrong, and where.

  void fault(const std::string& path, const std::string& value, const std::string& allowed) {
    fault_at(deepest(root_, path).line, path, value, allowed);
  }
  void fault_at(int line, const std::string& path, const std::string& value,
                const std::string& allowed) {
    faults_.push_back({line, {path, value, allowed}});
    wrong_.insert(path);
  }
  void unfit(const std::string& path, const JsonNode& node, const std::string& allowed) {
    fault_at(node.line, path, node.shown(), allowed);
  }
  static std::string below(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + '.' + key;
  }
  static std::string at(const std::string& path, std::size_t i) {
    return path + '[' + std::to_string(i) + ']';
  }
  bool kind(const JsonNode& node, const std::string& path, JsonKind wanted,
            const std::string& more = "") {
    if (node.kind == wanted) return true;
    unfit(path, node,
          "must be " + std::string(kind_names[static_cast<std::size_t>(wanted)]) + more);
    return false;
  }
  bool object(const JsonNode& node, const std::string& path, const Keys& keys) {
    if (!kind(node, path, JsonKind::object)) return false;
    std::set<std::string> seen;
    for (const auto& [key, value] : node.members) {
      std::string where = path + path_step(key);
      if (where.front() == '.') where.erase(where.begin());
      if (!seen.insert(key).second) {
        unfit(where, value, "stands twice; a key may stand once");
      } else if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        unfit(where, value, "is an unknown key; " + hint(key, keys) + "known are " + joined(keys));
      }
    }
    return true;
  }

  // Members of an object, each read as what it must be.

  const JsonNode* member(const JsonNode& from, const std::string& path, const std::string& key,
                         const std::string& wanted) {
    const JsonNode* node = from.find(key);
    if (!node) fault(below(path, key), "", "is missing; must be " + wanted);
    return node;
  }
  std::optional<double> number(const JsonNode& from, const std::string& path,
                               const std::string& key, const std::string& unit) {
    const JsonNode* node = member(from, path, key, "a number, " + unit);
    if (!node || !kind(*node, below(path, key), JsonKind::number, ", " + unit)) return std::nullopt;
    return node->number;
  }
  std::optional<double> number_if_there(const JsonNode& from, const std::string& path,
                                        const std::string& key, const std::string& unit) {
    return from.find(key) ? number(from, path, key, unit) : std::nullopt;
  }
  bool truth(const JsonNode& from, const std::string& path, const std::string& key,
             bool otherwise) {
    const JsonNode* node = from.find(key);
    if (!node || !kind(*node, below(path, key), JsonKind::boolean)) return otherwise;
    return node->truth;
  }
  std::string text(const JsonNode& from, const std::string& path, const std::string& key) {
    const JsonNode* node = member(from, path, key, "a text");
    if (!node || !kind(*node, below(path, key), JsonKind::text)) return "";
    return node->text;
  }
  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(const JsonNode& node, const std::string& path) {
    const std::string wanted = " of " + std::to_string(N) + " numbers";
    if (!kind(node, path, JsonKind::array, wanted)) return std::nullopt;
    if (node.items.size() != N) {
      unfit(path, node, "must be an array" + wanted);
      return std::nullopt;
    }
    std::array<double, N> values{};
    bool good = true;
    for (std::size_t i = 0; i < N; ++i) {
      good = kind(node.items[i], at(path, i), JsonKind::number) && good;
      values[i] = node.items[i].number;
    }
    if (!good) return std::nullopt;
    return values;
  }
  Vector3<double> vector(const JsonNode& from, const std::string& path, const std::string& key,
                         bool needed) {
    const JsonNode* node =
        needed ? member(from, path, key, "an array of 3 numbers") : from.find(key);
    if (!node) return Vector3<double>::Zero();
    const auto values = numbers<3>(*node, below(path, key));
    if (!values) return Vector3<double>::Zero();
    return {(*values)[0], (*values)[1], (*values)[2]};
  }
  void absent(const JsonNode& from, const std::string& path,
              std::initializer_list<const char*> keys, const std::string& why) {
    for (const char* key : keys) {
      if (const JsonNode* node = from.find(key)) {
        unfit(below(path, key), *node, "must be absent: " + why);
      }
    }
  }
  void fixed(const std::string& key, const std::string& wanted) {
    const JsonNode* node = member(root_, "", key, '"' + wanted + '"');
    if (node && (node->kind != JsonKind::text || node->text != wanted))
      unfit(key, *node, "must be \"" + wanted + '"');
  }

  // The parts of a scene.

  const JsonNode* list(const std::string& key, bool needed) {
    const JsonNode* node = needed ? member(root_, "", key, "an array of objects") : root_.find(key);
    if (!node || !kind(*node, key, JsonKind::array, " of objects")) return nullptr;
    return node;
  }

  void materials() {
    const JsonNode* all = list("materials", true);
    if (!all) return;
    for (std::size_t i = 0; i < all->items.size(); ++i) {
      const JsonNode& node = all->items[i];
      const std::string path = at("materials", i);
      SceneMaterial material;
      if (object(node, path, {"name", "restitution", "friction", "stiffness", "damping"})) {
        material.name = text(node, path, "name");
        material.restitution = number(node, path, "restitution", "from 0 to 1").value_or(0);
        material.friction = number(node, path, "friction", "0 or more").value_or(0);
        material.stiffness = number_if_there(node, path, "stiffness", "N/m");
        if (node.find("stiffness")) {
          material.damping = number_if_there(node, path, "damping", "N s/m").value_or(0);
        } else {
          absent(node, path, {"damping"}, "it goes with a stiffness");
        }
      }
      scene_.materials.push_back(std::move(material));
    }
  }

  void bodies() {
    const JsonNode* all = list("bodies", true);
    if (!all) return;
    for (std::size_t i = 0; i < all->items.size(); ++i) body(all->items[i], at("bodies", i), i);
  }

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

  Rotor<double> orientation(const JsonNode& from, const std::string& body_path) {
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
    if (!(scene_least <= largest && largest <= scene_most)) {
      unfit(path + ".axis", *node->find("axis"),
            "must be a direction: not zero, its largest coordinate from 1e-30 to 1e+30");
      return {};
    }
    if (!angle) return {};
    const Vector3<double> share = axis / largest;
    const double length = std::sqrt(share.dot(share));
    const auto [sine, cosine] = degrees ? half_of_degrees(*angle) : sine_cosine<double>(*angle / 2);
    return {cosine, share * (sine / length)};
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
    if (0 <= value && value <= scene_most) return value;
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
        const auto most = static_cast<double>(scene_most_bodies);
        if (!(1 <= value && value <= most && value == std::floor(value))) {
          unfit(at(path + ".count", k), count->items[k],
                "must be a whole number from 1 to " + std::to_string(scene_most_bodies));
        } else {
          repeat.count[k] = static_cast<std::size_t>(value);
          product *= value;
        }
      }
      if (product > static_cast<double>(scene_most_bodies)) {
        unfit(path + ".count", *count,
              "must not make more than " + std::to_string(scene_most_bodies) + " bodies");
        repeat.count = {1, 1, 1};
      }
    }
    repeat.spacing = vector(*node, path, "spacing", true);
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(repeat.spacing(k)) <= scene_most)) {
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
          whole(*node, path, "limit", 1, static_cast<double>(scene_most_bodies)).value_or(1));
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
    wrong_.insert(path + ".mass");  // said of the density, if anything
    const auto value = number(node, path, "density", "kg/m^3");
    if (!value) return;
    if (!(scene_least <= *value && *value <= scene_most)) {
      fault(path + ".density", shortest_text(*value),
            "must be greater than 0, from 1e-30 to 1e+30 kg/m^3");
      return;
    }
    if (!shaped || !sized(body.shape)) return;
    body.mass = *value * solid_volume(body.shape);
    if (!(scene_least <= body.mass && body.mass <= scene_most))
      fault(path + ".density", shortest_text(*value),
            "must give a mass from 1e-30 to 1e+30 kg, and gives " + shortest_text(body.mass));
  }

  /// Whether volume and inertia can be asked of a shape.
  static bool sized(const SceneShape& shape) {
    const auto good = [](double x) { return scene_least <= x && x <= scene_most; };
    if (const auto* ball = std::get_if<BallShape>(&shape)) return good(ball->radius);
    if (const auto* box = std::get_if<BoxShape>(&shape))
      return good(box->half_lengths.x()) && good(box->half_lengths.y()) &&
             good(box->half_lengths.z());
    if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
      return good(capsule->radius) && 0 <= capsule->half_length &&
             capsule->half_length <= scene_most;
    if (const auto* hull = std::get_if<HullShape>(&shape))
      return std::all_of(
                 hull->points.begin(), hull->points.end(),
                 [](const auto& point) { return point.cwiseAbs().maxCoeff() <= scene_most; }) &&
             solid_volume(shape) > 0;
    return false;
  }

  void body(const JsonNode& node, const std::string& path, std::size_t entry) {
    if (!object(node, path,
                {"name", "shape", "material", "moves", "mass", "density", "position", "orientation",
                 "velocity", "spin", "repeat"}))
      return;
    SceneBody body;
    body.name = text(node, path, "name");
    const auto read = shape(node, path);
    body.shape = read.value_or(BallShape{});
    const bool ground = read && std::holds_alternative<HalfSpaceShape>(body.shape);
    material(node, path, body);
    body.moves = truth(node, path, "moves", !ground);
    std::optional<Repeat> repeated;
    if (ground) {
      if (body.moves) fault(path + ".moves", "true", "must be false: a half-space never moves");
      absent(node, path,
             {"position", "orientation", "mass", "density", "velocity", "spin", "repeat"},
             "a half-space lies where its normal and offset say, and never moves");
      body.moves = false;
    } else {
      body.position = vector(node, path, "position", true);
      body.orientation = orientation(node, path);
      repeated = repeat(node, path);
      if (body.moves) {
        mass(node, path, body, read.has_value());
        body.velocity = vector(node, path, "velocity", false);
        body.spin = vector(node, path, "spin", false);
        if (read && sized(body.shape) && scene_least <= body.mass && body.mass <= scene_most)
          body.inertia = solid_inertia(body.shape, body.mass);
      } else {
        absent(node, path, {"mass", "density", "velocity", "spin"}, "the body does not move");
        if (repeated && repeated->speed != 0) {
          fault(path + ".repeat.speed", shortest_text(repeated->speed),
                "must be 0 or absent: the body does not move");
          repeated->speed = 0;
        }
      }
    }
    if (!read) wrong_.insert(path + ".shape");
    place(body, repeated, entry);
  }

  void material(const JsonNode& node, const std::string& path, SceneBody& body) {
    const std::string wanted = text(node, path, "material");
    const auto found =
        std::find_if(scene_.materials.begin(), scene_.materials.end(),
                     [&](const SceneMaterial& material) { return material.name == wanted; });
    if (found != scene_.materials.end()) {
      body.material = static_cast<std::size_t>(found - scene_.materials.begin());
      return;
    }
    if (is_wrong(path + ".material")) return;
    Keys names;
    for (const SceneMaterial& known : scene_.materials) names.emplace_back(known.name);
    fault(path + ".material", node.find("material")->shown(),
          hint(wanted, names) + "must be the name of a material: " + joined(names));
  }

  void place(const SceneBody& body, const std::optional<Repeat>& repeated, std::size_t entry) {
    if (!repeated) {
      entries_.push_back(entry);
      scene_.bodies.push_back(body);
      return;
    }
    repeated_.insert(entry);
    const std::size_t total = repeated->total();
    if (scene_.bodies.size() + total > scene_most_bodies) {
      fault(at("bodies", entry) + ".repeat.count", std::to_string(total) + " bodies",
            "must not make the scene larger than " + std::to_string(scene_most_bodies) + " bodies");
      return;
    }
    SceneRandom random(repeated->seed);
    for (std::size_t n = 0; n < total; ++n) {
      SceneBody copy = body;
      copy.name += '_' + std::to_string(n);
      const std::size_t i = n % repeated->count[0];
      const std::size_t k = n / repeated->count[0] % repeated->count[1];
      const std::size_t l = n / repeated->count[0] / repeated->count[1];
      const Vector3<double> steps(static_cast<double>(i), static_cast<double>(k),
                                  static_cast<double>(l));
      copy.position += steps.cwiseProduct(repeated->spacing);
      if (repeated->jitter != 0) copy.position += repeated->jitter * random.in_cube();
      if (repeated->speed != 0) copy.velocity += repeated->speed * random.in_ball();
      entries_.push_back(entry);
      scene_.bodies.push_back(std::move(copy));
    }
  }

  void tolerance() {
    const JsonNode* node = member(root_, "", "tolerance", "an object");
    if (!node || !object(*node, "tolerance", {"position", "event_order"})) return;
    scene_.tolerance.position = number_if_there(*node, "tolerance", "position", "m");
    scene_.tolerance.event_order = truth(*node, "tolerance", "event_order", false);
  }

  void output() {
    const JsonNode* node = root_.find("output");
    if (!node || !object(*node, "output", {"every", "velocities", "events"})) return;
    scene_.output.every = number_if_there(*node, "output", "every", "s").value_or(0);
    scene_.output.velocities = truth(*node, "output", "velocities", false);
    scene_.output.events = truth(*node, "output", "events", false);
  }

  void expectations() {
    if (!root_.find("expect")) return;
    const JsonNode* all = list("expect", false);
    if (!all) return;
    for (std::size_t i = 0; i < all->items.size(); ++i) {
      const JsonNode& node = all->items[i];
      const std::string path = at("expect", i);
      SceneExpectation wanted;
      if (object(node, path, {"quantity", "body", "time", "value", "within", "why"})) {
        wanted.quantity = text(node, path, "quantity");
        if (node.find("body")) {
          wanted.body = text(node, path, "body");
          if (wanted.body.empty() && !is_wrong(path + ".body"))
            fault(path + ".body", "\"\"", "must be the name of a body");
        }
        wanted.time = number(node, path, "time", "s").value_or(0);
        wanted.value = number(node, path, "value", "in the quantity's SI unit").value_or(0);
        wanted.within = number(node, path, "within", "in the quantity's SI unit").value_or(0);
        wanted.why = text(node, path, "why");
      }
      scene_.expect.push_back(std::move(wanted));
    }
  }

  // What check_scene() finds, told in the file's words.

  bool is_wrong(const std::string& path) const { return wrong_.count(path) != 0; }

  static bool within(const std::string& part, const std::string& whole) {
    return part.compare(0, whole.size(), whole) == 0 &&
           (part.size() == whole.size() || part[whole.size()] == '.' || part[whole.size()] == '[' ||
            whole.empty());
  }

  void check() {
    const bool sound = faults_.empty();
    const std::set<std::string> before = wrong_;
    std::set<std::string> of_repeated;
    for (SceneFault& found : check_scene(scene_)) {
      std::string which;
      if (found.path.rfind("bodies[", 0) == 0) {
        const std::size_t end = found.path.find(']');
        const std::size_t number = std::stoul(found.path.substr(7, end - 7));
        found.path = at("bodies", entries_[number]) + found.path.substr(end + 1);
        if (repeated_.count(entries_[number]) != 0) {
          if (!of_repeated.insert(found.path).second) continue;  // one of many alike
          which = " (" + scene_.bodies[number].name + ")";
        }
      }
      // What follows from a fault that has been told is not told again.
      const bool told = std::any_of(before.begin(), before.end(), [&](const std::string& path) {
        return within(found.path, path) || within(path, found.path);
      });
      if (told || (!sound && found.allowed.rfind("must not overlap", 0) == 0)) continue;
      fault(found.path, found.value, found.allowed + which);
    }
    forgive_references("materials", "must be the name of a material");
    forgive_references("bodies", "must be the name of a body");
  }

  /// Where a list, or a name in it, could not be read, a name that is not found may be that one.
  void forgive_references(const std::string& list, const std::string& words) {
    const bool torn = std::any_of(faults_.begin(), faults_.end(), [&](const FileFault& found) {
      const std::string& path = found.fault.path;
      if (!within(path, list)) return false;
      const std::size_t end = path.find(']');
      return end == std::string::npos || end + 1 == path.size() || path.substr(end + 1) == ".name";
    });
    if (!torn) return;
    std::erase_if(faults_, [&](const FileFault& found) {
      return found.fault.allowed.find(words) != std::string::npos;
    });
  }

  const JsonNode& root_;
  std::string file_;
  Scene scene_;
  std::vector<FileFault> faults_;
  std::set<std::string> wrong_;
  std::vector<std::size_t> entries_;  // of each body: which of the file's
  std::set<std::size_t> repeated_;
};

CONTACT_SCENES_INLINE std::string all_lines(const std::string& file,
                                            const std::vector<FileFault>& faults) {
  constexpr std::size_t most = 100;
  std::string lines;
  for (std::size_t i = 0; i < faults.size() && i < most; ++i) {
    if (i > 0) lines += '\n';
    lines += file;
    if (faults[i].line > 0) lines += ':' + std::to_string(faults[i].line);
    lines += ": ";
    const SceneFault& fault = faults[i].fault;
    if (!fault.path.empty()) {
      lines += fault_text(fault);
    } else {
      lines += (fault.value.empty() ? "" : fault.value + ": ") + fault.allowed;
    }
  }
  if (faults.size() > most) lines += "\nand " + std::to_string(faults.size() - most) + " more";
  return lines;
}

}  // namespace detail

CONTACT_SCENES_INLINE SceneFileError::SceneFileError(const std::string& file,
                                                     std::vector<FileFault> faults)
    : std::runtime_error(detail::all_lines(file, faults)), faults_(std::move(faults)) {}

CONTACT_SCENES_INLINE Scene scene_from_text(std::string_view text, const std::string& file) {
  const JsonNode root = parse_json(text, file);
  return detail::Reader(root, file).read();
}

CONTACT_SCENES_INLINE Scene read_scene(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!std::filesystem::is_directory(file)) text << stream.rdbuf();
  if (!stream || std::filesystem::is_directory(file))
    throw std::runtime_error(file.string() + ": cannot be read");
  return scene_from_text(text.str(), file.string());
}

CONTACT_SCENES_INLINE std::vector<std::filesystem::path> scenes_in(
    const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace contact::scenes
