// A scene as its file.

#include <fstream>
#include <stdexcept>

#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_file.hpp>
#include <nlohmann/json.hpp>

namespace contact::scenes {

namespace detail {

using Json = nlohmann::ordered_json;

CONTACT_SCENES_INLINE Json list(const Vector3<double>& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

CONTACT_SCENES_INLINE Json shape_json(const SceneShape& shape) {
  if (const auto* ball = std::get_if<BallShape>(&shape))
    return {{"type", "sphere"}, {"radius", ball->radius}};
  if (const auto* box = std::get_if<BoxShape>(&shape))
    return {{"type", "box"}, {"half_lengths", list(box->half_lengths)}};
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    return {
        {"type", "capsule"}, {"radius", capsule->radius}, {"half_length", capsule->half_length}};
  if (const auto* hull = std::get_if<HullShape>(&shape)) {
    Json points = Json::array();
    for (const Vector3<double>& point : hull->points) points.push_back(list(point));
    return {{"type", "hull"}, {"points", points}};
  }
  const auto& ground = std::get<HalfSpaceShape>(shape);
  return {{"type", "half_space"}, {"normal", list(ground.normal)}, {"offset", ground.offset}};
}

CONTACT_SCENES_INLINE Json material_json(const SceneMaterial& material) {
  Json json{{"name", material.name},
            {"restitution", material.restitution},
            {"friction", material.friction}};
  if (material.stiffness) {
    json["stiffness"] = *material.stiffness;
    json["damping"] = material.damping;
  }
  return json;
}

CONTACT_SCENES_INLINE Json body_json(const Scene& scene, const SceneBody& body) {
  Json json{{"name", body.name},
            {"shape", shape_json(body.shape)},
            {"material", scene.materials[body.material].name}};
  if (std::holds_alternative<HalfSpaceShape>(body.shape)) return json;
  if (body.moves) {
    json["mass"] = body.mass;
  } else {
    json["moves"] = false;
  }
  json["position"] = list(body.position);
  const Quaternion<double>& q = body.orientation;
  json["orientation"]["quaternion"] = Json::array({q.w, q.v.x(), q.v.y(), q.v.z()});
  if (body.moves) {
    json["velocity"] = list(body.velocity);
    json["angular_velocity"] = list(body.angular_velocity);
  }
  return json;
}

CONTACT_SCENES_INLINE Json expectation_json(const SceneExpectation& wanted) {
  Json json = Json::object();
  json["quantity"] = wanted.quantity;
  if (!wanted.body.empty()) json["body"] = wanted.body;
  json["time"] = wanted.time;
  json["value"] = wanted.value;
  json["within"] = wanted.within;
  json["why"] = wanted.why;
  return json;
}

CONTACT_SCENES_INLINE Json scene_json(const Scene& scene) {
  Json json{{"format", "contact-scene/1"},
            {"units", "SI"},
            {"name", scene.name},
            {"about", scene.about},
            {"gravity", list(scene.gravity)},
            {"materials", Json::array()},
            {"bodies", Json::array()},
            {"duration", scene.duration},
            {"tolerance", Json::object()},
            {"output",
             {{"every", scene.output.every},
              {"velocities", scene.output.velocities},
              {"events", scene.output.events}}},
            {"expect", Json::array()}};
  for (const SceneMaterial& material : scene.materials)
    json["materials"].push_back(material_json(material));
  for (const SceneBody& body : scene.bodies) json["bodies"].push_back(body_json(scene, body));
  if (scene.tolerance.position) json["tolerance"]["position"] = *scene.tolerance.position;
  json["tolerance"]["event_order"] = scene.tolerance.event_order;
  for (const SceneExpectation& wanted : scene.expect)
    json["expect"].push_back(expectation_json(wanted));
  return json;
}

/// An array or object that contains no other, or is short, is written on one line.
CONTACT_SCENES_INLINE void print(const Json& json, std::size_t indent, std::string& text) {
  const std::string flat = json.dump();
  if (!json.is_structured() || flat.size() + indent <= 90) {
    text += flat;
    return;
  }
  const bool object = json.is_object();
  text += object ? "{" : "[";
  bool first = true;
  for (const auto& item : json.items()) {
    text += first ? "\n" : ",\n";
    text.append(indent + 2, ' ');
    if (object) text += Json(item.key()).dump() + ": ";
    print(item.value(), indent + 2, text);
    first = false;
  }
  text += '\n';
  text.append(indent, ' ');
  text += object ? "}" : "]";
}

}  // namespace detail

CONTACT_SCENES_INLINE std::string text_of_scene(const Scene& scene) {
  std::vector<FileFault> faults;
  for (SceneFault& fault : check_scene(scene)) faults.push_back({0, std::move(fault)});
  if (!faults.empty()) throw SceneFileError(scene.name, std::move(faults));
  std::string text;
  detail::print(detail::scene_json(scene), 0, text);
  return text + '\n';
}

CONTACT_SCENES_INLINE void write_scene(const std::filesystem::path& file, const Scene& scene) {
  const std::string text = text_of_scene(scene);
  std::ofstream stream(file, std::ios::binary);
  stream << text << std::flush;
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace contact::scenes
