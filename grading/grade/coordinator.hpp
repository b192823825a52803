#pragma once

// Workers on this machine: each a process of its own, given one unit at a time.

#include <optional>
#include <utility>

#include "../process/run_process.hpp"
#include "engine.hpp"
#include "run_state.hpp"

namespace contact::grading {

class LocalEngine : public Engine {
 public:
  LocalEngine(Loop& loop, const RunFolder& folder, const Machine& machine, int workers,
              TimeOfJob time)
      : loop_(loop),
        folder_(folder),
        machine_(machine),
        workers_(workers),
        time_(std::move(time)) {}

  [[nodiscard]] std::string name() const override { return "local"; }
  [[nodiscard]] int workers() const override { return workers_; }
  std::vector<JobTrouble> run(const std::vector<Job>& jobs,
                              const std::function<void(const Job&)>& finished) override;

 private:
  Loop& loop_;
  const RunFolder& folder_;
  const Machine& machine_;
  int workers_;
  TimeOfJob time_;
};

/// A temporary folder whose name is kept in the run's folder, so that it is removed even if every
/// process of the run is killed.
class NotedFolder {
 public:
  explicit NotedFolder(const RunFolder& folder);
  ~NotedFolder();
  NotedFolder(const NotedFolder&) = delete;
  NotedFolder& operator=(const NotedFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::filesystem::path note_;
};

/// Makes all temporary folders in this one, for a while.
class TemporaryPlace {
 public:
  explicit TemporaryPlace(const std::filesystem::path& path);
  ~TemporaryPlace();
  TemporaryPlace(const TemporaryPlace&) = delete;
  TemporaryPlace& operator=(const TemporaryPlace&) = delete;

 private:
  std::optional<std::string> before_;
};

/// Removes the temporary folders of a run on this machine whose coordinator and workers were all
/// killed.
void remove_left_behind(const RunFolder& folder);

}  // namespace contact::grading
