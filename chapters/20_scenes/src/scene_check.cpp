#include <contact/scene/scene_check.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/box_pairs.hpp>
#include <contact/closest_points.hpp>
#include <contact/convex_hull.hpp>
#include <contact/inertia.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_solids.hpp>
#include <contact/signed_distance.hpp>
#include <contact/tree_pairs.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE std::string shortest_text(double x) {
  if (std::isnan(x)) return "NaN";
  if (std::isinf(x)) return x > 0 ? "Infinity" : "-Infinity";
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  return {text.data(), end};
}

namespace detail {

/// Checks a scene from top to bottom and collects its faults.
class SceneChecker {
 public:
  explicit SceneChecker(const Scene& scene) : scene_(scene), placed_(scene.bodies.size(), false) {}

  std::vector<SceneFault> run() {
    name("name", scene_.name);
    text("about", scene_.about);
    vector("gravity", scene_.gravity, "m/s^2");
    materials();
    bodies();
    positive("duration", scene_.duration, "s");
    tolerance();
    not_negative("output.every", scene_.output.every, "s");
    expectations();
    overlaps();
    return std::move(faults_);
  }

 private:
  void fault(std::string path, const std::string& value, std::string allowed) {
    faults_.push_back({std::move(path), shortened(value), std::move(allowed)});
  }
  static std::string quoted(const std::string& word) { return '"' + shortened(word, 100) + '"'; }
  static std::string at(const char* list, std::size_t i) {
    return std::string(list) + '[' + std::to_string(i) + ']';
  }
  static std::string bound(double x) { return shortest_text(x); }

  bool number(const std::string& path, double x, std::string_view unit) {
    if (std::abs(x) <= max_scene_value) return true;
    fault(path, shortest_text(x),
          "must be from " + bound(-max_scene_value) + " to " + bound(max_scene_value) + " " +
              std::string(unit));
    return false;
  }
  bool positive(const std::string& path, double x, std::string_view unit) {
    if (min_scene_value <= x && x <= max_scene_value) return true;
    fault(path, shortest_text(x),
          "must be greater than 0, from " + bound(min_scene_value) + " to " +
              bound(max_scene_value) + " " + std::string(unit));
    return false;
  }
  bool not_negative(const std::string& path, double x, std::string_view unit) {
    if (0 <= x && x <= max_scene_value) return true;
    fault(path, shortest_text(x),
          "must be from 0 to " + bound(max_scene_value) + (unit.empty() ? "" : " ") +
              std::string(unit));
    return false;
  }
  bool vector(const std::string& path, const Vector3<double>& v, std::string_view unit) {
    bool good = true;
    for (int k = 0; k < 3; ++k) {
      good = number(path + '[' + std::to_string(k) + ']', v(k), unit) && good;
    }
    return good;
  }
  void zero(const std::string& path, const Vector3<double>& v, const char* why) {
    if (v != Vector3<double>::Zero()) fault(path, list_text(v), why);
  }
  static std::string list_text(const Vector3<double>& v) {
    return '[' + shortest_text(v.x()) + ", " + shortest_text(v.y()) + ", " + shortest_text(v.z()) +
           ']';
  }
  void text(const std::string& path, const std::string& words) {
    if (words.empty()) fault(path, "\"\"", "must not be empty");
  }
  void name(const std::string& path, const std::string& word) {
    const auto fits = [](char c) {
      return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '_';
    };
    if (word.empty() || word.size() > 64 || !std::all_of(word.begin(), word.end(), fits))
      fault(path, quoted(word), "must be 1 to 64 of the characters a-z, 0-9 and _");
  }

  void materials() {
    if (scene_.materials.empty()) fault("materials", "[]", "must hold at least one");
    std::map<std::string, std::size_t> seen;
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
      const SceneMaterial& material = scene_.materials[i];
      const std::string path = at("materials", i);
      name(path + ".name", material.name);
      if (!seen.emplace(material.name, i).second)
        fault(path + ".name", quoted(material.name),
              "must not be the name of another material too");
      if (!(0 <= material.restitution && material.restitution <= 1))
        fault(path + ".restitution", shortest_text(material.restitution), "must be from 0 to 1");
      not_negative(path + ".friction", material.friction, "");
      if (material.stiffness) positive(path + ".stiffness", *material.stiffness, "N/m");
      if (not_negative(path + ".damping", material.damping, "N s/m") && !material.stiffness &&
          material.damping != 0)
        fault(path + ".damping", shortest_text(material.damping),
              "must be absent where there is no stiffness: a hard contact takes its loss from its "
              "restitution");
    }
  }

  bool shape(const std::string& path, const SceneShape& s) {
    if (const auto* ball = std::get_if<BallShape>(&s))
      return positive(path + ".radius", ball->radius, "m");
    if (const auto* box = std::get_if<BoxShape>(&s)) {
      bool good = true;
      for (int k = 0; k < 3; ++k) {
        good = positive(path + ".half_lengths[" + std::to_string(k) + ']', box->half_lengths(k),
                        "m") &&
               good;
      }
      return good;
    }
    if (const auto* capsule = std::get_if<CapsuleShape>(&s)) {
      const bool good = positive(path + ".radius", capsule->radius, "m");
      return not_negative(path + ".half_length", capsule->half_length, "m") && good;
    }
    if (const auto* hull = std::get_if<HullShape>(&s)) return hull_shape(path + ".points", *hull);
    const auto& ground = std::get<HalfSpaceShape>(s);
    bool good = vector(path + ".normal", ground.normal, "(no unit)");
    if (good && !(std::abs(ground.normal.squaredNorm() - 1) <= scene_unit_slack)) {
      const double length = ground.normal.norm();
      std::string allowed = "must have length 1 (to 12 digits), and has " + shortest_text(length);
      if (length > 0)
        allowed +=
            "; " + list_text(Vector3<double>(ground.normal / length)) + " points the same way";
      fault(path + ".normal", list_text(ground.normal), allowed);
      good = false;
    }
    return number(path + ".offset", ground.offset, "m") && good;
  }

  bool hull_shape(const std::string& path, const HullShape& hull) {
    bool good = true;
    double size = 0;
    for (std::size_t i = 0; i < hull.points.size(); ++i) {
      good = vector(path + '[' + std::to_string(i) + ']', hull.points[i], "m") && good;
      size = std::max(size, hull.points[i].cwiseAbs().maxCoeff());
    }
    if (!good) return false;
    const auto matter = hull_matter(hull.points);
    const std::string count = std::to_string(hull.points.size()) + " points";
    if (!matter) {
      fault(path, count, "must have at least 4 that do not lie in a plane");
      return false;
    }
    if (!(matter->centre.cwiseAbs().maxCoeff() <= 1e-9 * size)) {
      fault(path, count,
            "must have their hull's centre of mass at the body's origin, and have it at " +
                list_text(matter->centre) + ": subtract that from each and add it to the position");
      return false;
    }
    return true;
  }

  void bodies() {
    if (scene_.bodies.empty()) fault("bodies", "[]", "must hold at least one");
    if (scene_.bodies.size() > max_scene_bodies)
      fault("bodies", std::to_string(scene_.bodies.size()) + " bodies",
            "must hold at most " + std::to_string(max_scene_bodies));
    std::map<std::string, std::size_t> seen;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      const std::string path = at("bodies", i);
      const SceneBody& body = scene_.bodies[i];
      name(path + ".name", body.name);
      if (!seen.emplace(body.name, i).second)
        fault(path + ".name", quoted(body.name), "must not be the name of another body too");
      placed_[i] = one_body(path, body);
    }
  }

  /// Returns whether the body has a shape and a position.
  bool one_body(const std::string& path, const SceneBody& body) {
    const bool shaped = shape(path + ".shape", body.shape);
    if (body.material >= scene_.materials.size())
      fault(path + ".material", std::to_string(body.material), "must be one of the materials");
    bool placed = vector(path + ".position", body.position, "m");
    const double w = body.orientation.w;
    const Vector3<double>& v = body.orientation.v;
    if (!(std::abs(w * w + v.dot(v) - 1) <= scene_unit_slack)) {
      fault(path + ".orientation.quaternion",
            '[' + shortest_text(w) + ", " + list_text(v).substr(1),
            "must have length 1 (to 12 digits), and has " +
                shortest_text(std::sqrt(w * w + v.dot(v))));
      placed = false;
    }
    vector(path + ".velocity", body.velocity, "m/s");
    vector(path + ".angular_velocity", body.angular_velocity, "rad/s");
    if (std::holds_alternative<HalfSpaceShape>(body.shape)) {
      const char* why = "must be absent: a half-space is placed by its normal and offset";
      if (placed) zero(path + ".position", body.position, why);
      if (placed && v != Vector3<double>::Zero())
        fault(path + ".orientation.quaternion",
              '[' + shortest_text(w) + ", " + list_text(v).substr(1), why);
      if (body.moves) {
        fault(path + ".moves", "true", "must be false: a half-space never moves");
        placed = false;
      }
    }
    if (body.moves) {
      moving(path, body, shaped);
    } else {
      still(path, body);
    }
    return shaped && placed;
  }

  void moving(const std::string& path, const SceneBody& body, bool shaped) {
    if (!positive(path + ".mass", body.mass, "kg")) return;
    if (!shaped || std::holds_alternative<HalfSpaceShape>(body.shape)) return;
    if (body.inertia != solid_inertia(body.shape, body.mass))
      fault(path + ".inertia", "tr " + shortest_text(body.inertia.trace()),
            "must be solid_inertia() of shape and mass");
  }

  void still(const std::string& path, const SceneBody& body) {
    const char* why = "must be absent: the body does not move";
    if (body.mass != 0) fault(path + ".mass", shortest_text(body.mass), why);
    if (body.inertia != Matrix3<double>::Zero())
      fault(path + ".inertia", "tr " + shortest_text(body.inertia.trace()), why);
    zero(path + ".velocity", body.velocity, why);
    zero(path + ".angular_velocity", body.angular_velocity, why);
  }

  void tolerance() {
    const SceneTolerance& t = scene_.tolerance;
    if (t.position) positive("tolerance.position", *t.position, "m");
    if (!t.position && !t.event_order)
      fault("tolerance", "", "must have a position, or event_order true, or both");
  }

  void expectations() {
    const bool timed = min_scene_value <= scene_.duration && scene_.duration <= max_scene_value;
    for (std::size_t i = 0; i < scene_.expect.size(); ++i) {
      const SceneExpectation& wanted = scene_.expect[i];
      const std::string path = at("expect", i);
      const SceneQuantity* known = nullptr;
      for (const SceneQuantity& quantity : scene_quantities) {
        if (quantity.name == wanted.quantity) known = &quantity;
      }
      if (known == nullptr) {
        std::string names;
        for (const SceneQuantity& quantity : scene_quantities)
          names += (names.empty() ? "" : ", ") + std::string(quantity.name);
        fault(path + ".quantity", quoted(wanted.quantity), "must be one of " + names);
      } else if (known->of == QuantityOf::body && wanted.body.empty()) {
        fault(path + ".body", "", "is missing: " + wanted.quantity + " belongs to one body");
      } else if (known->of == QuantityOf::scene && !wanted.body.empty()) {
        fault(path + ".body", quoted(wanted.body),
              "must be absent: " + wanted.quantity + " belongs to the whole scene");
      }
      if (!wanted.body.empty() &&
          std::none_of(scene_.bodies.begin(), scene_.bodies.end(),
                       [&](const SceneBody& body) { return body.name == wanted.body; }))
        fault(path + ".body", quoted(wanted.body), "must be the name of a body");
      if (timed && 0 <= wanted.time && !(wanted.time <= scene_.duration)) {
        fault(path + ".time", shortest_text(wanted.time),
              "must be from 0 to the duration, " + shortest_text(scene_.duration) + " s");
      } else {
        not_negative(path + ".time", wanted.time, "s");
      }
      number(path + ".value", wanted.value, "(SI)");
      not_negative(path + ".within", wanted.within, "(SI)");
      text(path + ".why", wanted.why);
    }
  }

  void pair_of(std::size_t i, std::size_t k) {
    const SceneBody& a = scene_.bodies[i];
    const SceneBody& b = scene_.bodies[k];
    if (!a.moves && !b.moves) return;
    const auto gap = starting_gap(a, b);
    if (!gap || -*gap <= touching_slack(a, b)) return;
    const bool first = !b.moves;  // the moving one, or the later one
    const SceneBody& here = first ? a : b;
    fault(at("bodies", first ? i : k) + ".position", list_text(here.position),
          "must not overlap " + quoted((first ? b : a).name) + ", which it penetrates by " +
              shortest_text(-*gap) + " m; touching is allowed");
  }

  /// Only bodies whose bounding boxes touch are compared, and each with every half-space.
  void overlaps() {
    std::vector<std::size_t> bounded;
    std::vector<std::size_t> grounds;
    std::vector<Aabb<double>> boxes;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      if (!placed_[i]) continue;
      const SceneBody& body = scene_.bodies[i];
      const double radius = bounding_radius(body.shape);
      (std::isinf(radius) ? grounds : bounded).push_back(i);
      if (std::isinf(radius)) continue;
      const Vector3<double> half = Vector3<double>::Constant(radius);
      boxes.push_back({body.position - half, body.position + half});
    }
    std::vector<std::array<std::size_t, 2>> near;
    for (const std::size_t i : bounded) {
      for (const std::size_t ground : grounds)
        near.push_back({std::min(i, ground), std::max(i, ground)});
    }
    for (const BoxPair& pair : tree_pairs<double>(boxes).pairs)
      near.push_back({bounded[pair.a], bounded[pair.b]});
    std::sort(near.begin(), near.end());
    for (const auto& [i, k] : near) pair_of(i, k);
  }

  const Scene& scene_;
  std::vector<bool> placed_;
  std::vector<SceneFault> faults_;
};

}  // namespace detail

// [check-scene]
CONTACT_SCENES_INLINE std::vector<SceneFault> check_scene(const Scene& scene) {
  return detail::SceneChecker(scene).run();
}
// [/check-scene]

}  // namespace contact
