#pragma once

// What the tasks of a job array are given: the units of each, and the script that starts a worker.

#include <map>
#include <vector>

#include "engine.hpp"
#include "slurm_commands.hpp"

namespace contact::grading {

/// The units of a task follow each other in one worker. The script is the same for every run; what
/// it needs comes as arguments, so that no path is ever read by a shell.
extern const char* const slurm_task_script;

/// The units of each task. A job at which a task ended goes by itself, so that it takes no other
/// with it again.
/// @param failures how often a task ended at a job
/// @param max_tasks that the cluster allows in an array
std::vector<std::vector<Job>> cut_into_slices(const std::vector<Job>& jobs,
                                              const std::map<Job, int>& failures, int max_tasks,
                                              const SlurmOptions& options);

}  // namespace contact::grading
