#pragma once

// The output of a run: trajectories, hits, and the checkpoint from which it goes on.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>

namespace contact::cli {

/// A file to which a run appends. A resumed run cuts off what came after its checkpoint.
class GrowingFile {
 public:
  /// @param keep how many bytes of an existing file stay; empty: begin anew
  GrowingFile(std::filesystem::path path, std::optional<std::uintmax_t> keep);
  /// @throws std::runtime_error if it cannot be written, as when a disk is full
  void add(const std::string& text);
  void flush();
  [[nodiscard]] std::uintmax_t size() const { return size_; }

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
  std::uintmax_t size_ = 0;
};

/// The present state of a run of a scene.
struct RunView {
  const Scene& scene;
  const SceneRun& run;
};

/// Whether a trajectory's name ends in .xyz or .csv.
bool is_trajectory_name(const std::filesystem::path& path);
/// The beginning of a trajectory: a CSV file has a line of headings, an extended XYZ file nothing.
std::string trajectory_heading(const std::filesystem::path& path, const Scene& scene);
/// All bodies but half-spaces, now. Orientations are written where not all of them are balls.
std::string trajectory_frame(const std::filesystem::path& path, const RunView& view);

/// The headings of a file of hits.
std::string hits_heading();
/// A hit, at its time.
std::string hit_line(const Scene& scene, const SceneHit& hit);

/// The position of a run, and the length of its files then.
struct RunCheckpoint {
  SceneCheckpoint state;
  std::string scene;               ///< a hash of the scene
  std::string plan;                ///< which effects were on, and the step
  std::uint64_t frames = 0;        ///< number of frames written so far
  std::uintmax_t output_size = 0;  ///< bytes
  std::uintmax_t events_size = 0;  ///< bytes
};

/// A hash of a scene without its expectations: scenes with the same hash move alike.
std::string scene_number(const Scene& scene);
void write_checkpoint(const std::filesystem::path& file, const RunCheckpoint& checkpoint);
/// @throws std::runtime_error if it is not a checkpoint
RunCheckpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace contact::cli
