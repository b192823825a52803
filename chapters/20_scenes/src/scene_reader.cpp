// A scene from its file: first the type of every value and all keys, then the scene made of them.

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_solids.hpp>

#include "json_tree.hpp"
#include "scene_body_fields.hpp"
#include "scene_random.hpp"

namespace contact::scenes {

namespace detail {

class Reader : private BodyFieldReader {
 public:
  Reader(const JsonNode& root, std::string file) : BodyFieldReader(root), file_(std::move(file)) {}

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
  // The parts of a scene.

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
          absent(node, path, {"damping"}, "it belongs to a stiffness");
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

  void body(const JsonNode& node, const std::string& path, std::size_t entry) {
    if (!object(node, path,
                {"name", "shape", "material", "moves", "mass", "density", "position", "orientation",
                 "velocity", "angular_velocity", "repeat"}))
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
      absent(
          node, path,
          {"position", "orientation", "mass", "density", "velocity", "angular_velocity", "repeat"},
          "a half-space is placed by its normal and offset, and never moves");
      body.moves = false;
    } else {
      body.position = vector(node, path, "position", true);
      body.orientation = orientation(node, path);
      repeated = repeat(node, path);
      if (body.moves) {
        mass(node, path, body, read.has_value());
        body.velocity = vector(node, path, "velocity", false);
        body.angular_velocity = vector(node, path, "angular_velocity", false);
        if (read && sized(body.shape) && min_scene_value <= body.mass &&
            body.mass <= max_scene_value)
          body.inertia = solid_inertia(body.shape, body.mass);
      } else {
        absent(node, path, {"mass", "density", "velocity", "angular_velocity"},
               "the body does not move");
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
    if (scene_.bodies.size() + total > max_scene_bodies) {
      fault(at("bodies", entry) + ".repeat.count", std::to_string(total) + " bodies",
            "must not make the scene larger than " + std::to_string(max_scene_bodies) + " bodies");
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

  // What check_scene() finds, in the file's terms.

  static bool within(const std::string& substep, const std::string& whole) {
    return substep.compare(0, whole.size(), whole) == 0 &&
           (substep.size() == whole.size() || substep[whole.size()] == '.' ||
            substep[whole.size()] == '[' || whole.empty());
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
          if (!of_repeated.insert(found.path).second) continue;  // one of many equal ones
          which = " (" + scene_.bodies[number].name + ")";
        }
      }
      // Consequences of a fault that has been reported are not reported again.
      const bool told = std::any_of(before.begin(), before.end(), [&](const std::string& path) {
        return within(found.path, path) || within(path, found.path);
      });
      if (told || (!sound && found.allowed.rfind("must not overlap", 0) == 0)) continue;
      fault(found.path, found.value, found.allowed + which);
    }
    forgive_references("materials", "must be the name of a material");
    forgive_references("bodies", "must be the name of a body");
  }

  /// Where a list, or a name in it, could not be read, an unknown name may be that one.
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

  std::string file_;
  Scene scene_;
  std::vector<std::size_t> entries_;  // of each body: index of the file's entry
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
