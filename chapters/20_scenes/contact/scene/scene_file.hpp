/// @file
/// Scenes as JSON files: chapters/20_scenes/scene.schema.json is the format, contact-scene/1. The
/// sources need nlohmann's json.hpp.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <contact/scene/scene.hpp>
#include <contact/scene/scene_check.hpp>

namespace contact::scenes {

/// A fault of a file, and its line.
struct FileFault {
  int line = 0;      ///< counted from 1; 0 if it belongs to no line
  SceneFault fault;  ///< what is wrong there
};

/// Why a file is not a scene: all of its faults. what() has one line for each, "FILE:12:
/// bodies[3].mass = -1: must be ...", at most a hundred.
class SceneFileError : public std::runtime_error {
 public:
  /// @param file what to call it
  /// @param faults in the order of the file
  SceneFileError(const std::string& file, std::vector<FileFault> faults);
  /// In the order of the file.
  [[nodiscard]] const std::vector<FileFault>& faults() const { return faults_; }

 private:
  std::vector<FileFault> faults_;
};

/// The scene in a JSON text. It has no fault that check_scene() finds, and is the same on every
/// machine.
/// @param file what to call the text in an error
/// @throws SceneFileError
Scene scene_from_text(std::string_view text, const std::string& file);

/// The scene in a file.
/// @throws SceneFileError if it is not valid; std::runtime_error if it cannot be read
Scene read_scene(const std::filesystem::path& file);

/// A scene as JSON, from which scene_from_text() makes the same scene, bit for bit. Repeated bodies
/// are written one by one.
/// @throws SceneFileError if check_scene() finds a fault: JSON has no NaN
std::string text_of_scene(const Scene& scene);

/// Writes a scene's text into a file.
/// @throws SceneFileError as text_of_scene(); std::runtime_error if it cannot be written
void write_scene(const std::filesystem::path& file, const Scene& scene);

/// The scenes of a folder, in the order of their names: every file that ends in .json.
std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder);

}  // namespace contact::scenes

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/json_tree.cpp"
#include "../../src/scene_reader.cpp"
#include "../../src/scene_writer.cpp"
#endif
