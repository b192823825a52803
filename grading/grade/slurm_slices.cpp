#include "slurm_slices.hpp"

#include <algorithm>

namespace contact::grading {

namespace {

// Without a limit on tasks at a time, units are cut as if for so many.
constexpr std::size_t assumed_tasks = 32;
constexpr std::size_t max_units_a_task = 64;

}  // namespace

const char* const slurm_task_script = R"(#!/bin/sh
# A task of a job array of `contact grade`: SLICES WORKER... grades the units of its slice.
slice=$1/$SLURM_ARRAY_TASK_ID.tsv
log=$1/$SLURM_ARRAY_TASK_ID.log
shift
# A shared folder may show the slice here later than where it was written.
tries=0
until [ -r "$slice" ] || [ "$tries" -ge 30 ]; do
  tries=$((tries + 1))
  sleep 1
done
exec > "$log" 2>&1
# Folders of tasks that were killed with all that belonged to them.
folders=${TMPDIR:-/tmp}/contact-grade-slurm
for old in "$folders"-*; do
  pid=${old#"$folders"-}
  kill -0 "${pid%%-*}" 2> /dev/null || rm -rf "$old"
done
# The worker removes its folder itself, unless it is killed. When the task is to end, it is told so
# too, and waited for.
temporary=$(mktemp -d "$folders-$$-XXXXXX") || exit 1
# Where boxes have no view of files of their own, their users must get through.
chmod 711 "$temporary"
trap 'rm -rf "$temporary"' EXIT
trap : HUP INT TERM
"$@" --temporary "$temporary" --parent "$$" < "$slice"
)";

std::vector<std::vector<Job>> cut_into_slices(const std::vector<Job>& jobs,
                                              const std::map<Job, int>& failures, int max_tasks,
                                              const SlurmOptions& options) {
  std::vector<std::vector<Job>> slices;
  std::vector<Job> rest;
  for (const Job& job : jobs) {
    const auto found = failures.find(job);
    if (found != failures.end() && found->second > 0 &&
        slices.size() + 1 < static_cast<std::size_t>(max_tasks))
      slices.push_back({job});
    else
      rest.push_back(job);
  }
  if (rest.empty()) return slices;
  const std::size_t places = static_cast<std::size_t>(max_tasks) - slices.size();
  std::size_t size = static_cast<std::size_t>(options.units_a_task);
  if (size == 0) {
    const std::size_t tasks = options.tasks_at_a_time > 0
                                  ? static_cast<std::size_t>(options.tasks_at_a_time)
                                  : assumed_tasks;
    // Some four a task at a time, so that the last ones end together.
    size =
        std::clamp((rest.size() + 4 * tasks - 1) / (4 * tasks), std::size_t{1}, max_units_a_task);
  }
  size = std::max(size, (rest.size() + places - 1) / places);
  for (std::size_t begin = 0; begin < rest.size(); begin += size) {
    const std::size_t end = std::min(begin + size, rest.size());
    slices.emplace_back(rest.begin() + static_cast<std::ptrdiff_t>(begin),
                        rest.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return slices;
}

}  // namespace contact::grading
