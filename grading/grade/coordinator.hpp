#pragma once

// Workers on this machine: each a process of its own, given one unit at a time.

#include "../run_process.hpp"
#include "engine.hpp"
#include "run_state.hpp"

namespace contact::grading {

class LocalEngine : public Engine {
 public:
  LocalEngine(Loop& loop, const RunFolder& folder, int workers)
      : loop_(loop), folder_(folder), workers_(workers) {}

  [[nodiscard]] std::string name() const override { return "local"; }
  [[nodiscard]] int workers() const override { return workers_; }
  std::vector<JobTrouble> run(const std::vector<Job>& jobs,
                              const std::function<void(const Job&)>& finished) override;

 private:
  Loop& loop_;
  const RunFolder& folder_;
  int workers_;
};

/// Removes the temporary folders of a run on this machine whose coordinator and workers were all
/// killed.
void remove_left_behind(const RunFolder& folder);

}  // namespace contact::grading
