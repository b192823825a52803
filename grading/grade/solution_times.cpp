#include "solution_times.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <thread>

#include "calibrate.hpp"
#include "coordinator.hpp"
#include "run_keys.hpp"
#include "unit_time.hpp"
#include "watchdog.hpp"

namespace contact::grading {

namespace {

double min_test_seconds(const Exercise& exercise, const GradeLimits& limits) {
  return limits.test_cpu_seconds > 0.0 ? limits.test_cpu_seconds : exercise.time_limit;
}

// What an earlier run of the same folder found, under the limits of now; nothing if it does not say
// enough.
std::optional<double> kept_seconds(const Run& before, const std::string& exercise, double least) {
  const auto old_least = before.min_seconds.find(exercise);
  const auto old = before.test_seconds.find(exercise);
  if (old_least == before.min_seconds.end() || old == before.test_seconds.end()) return {};
  // The solution's time stood for the limit, or is known to be short enough for a longer one.
  if (old->second > old_least->second) return std::max(least, old->second);
  if (least >= old_least->second) return least;
  return {};
}

// One exercise's solution, and the seconds that a test may take, once they are known.
struct Solution {
  const Exercise* exercise;
  UnitSettings settings;
  std::optional<double> seconds;
};

void settle(const RunKeys& keys, const Solution& solution, Run& run) {
  const std::string id = solution.exercise->id();
  run.test_seconds[id] = *solution.seconds;
  UnitSettings settings = solution.settings;
  settings.test_cpu_seconds = *solution.seconds;
  run.unit_seconds[id] = declared_seconds(*solution.exercise, settings);
  run.keys[id] = keys.of(*solution.exercise, run.private_tests.of(id), run.seed, run.limits,
                         *solution.seconds);
}

// Several at a time, each thread with a loop and a seat of its own.
void measure(const SolutionTimes& with, std::vector<Solution>& solutions) {
  const NotedFolder temporary(with.folder);
  const TemporaryPlace place(temporary.path());
  std::vector<std::exception_ptr> wrong(solutions.size());
  std::atomic<std::size_t> next{0};
  Watchdog watchdog(with.out_of_time);
  const auto work = [&] {
    std::size_t at = next++;
    try {
      Loop loop;
      const Seat seat(with.machine);
      for (; at < solutions.size(); at = next++) {
        Solution& solution = solutions[at];
        const double may_take = calibrating_seconds(*solution.exercise, solution.settings);
        const Watchdog::Watch watch(
            watchdog, may_take,
            "contact: the book's own solution of " + solution.exercise->id() +
                " cannot be graded here, so nothing is: " + out_of_time_words(may_take) + "\n");
        const double measured = calibrate(loop, with.book, with.build, with.machine, seat,
                                          *solution.exercise, solution.settings);
        if (!solution.seconds) solution.seconds = measured;
      }
    } catch (...) {
      if (at < wrong.size()) wrong[at] = std::current_exception();
      next = solutions.size();
    }
  };
  {
    std::vector<std::jthread> threads;
    const auto count =
        std::min<std::size_t>(static_cast<std::size_t>(with.workers), solutions.size());
    for (std::size_t i = 0; i < count; ++i) threads.emplace_back(work);
  }
  for (const std::exception_ptr& one : wrong) {
    if (one) std::rethrow_exception(one);
  }
}

}  // namespace

void set_times(Loop& loop, const SolutionTimes& with, Run& run) {
  const RunKeys keys(loop, with.build);
  std::vector<Solution> solutions;
  for (const Exercise& exercise : with.exercises) {
    const std::string id = exercise.id();
    Solution solution{&exercise, {}, {}};
    solution.settings.seed = run.seed;
    solution.settings.limits = run.limits;
    const PrivateExercise* more = run.private_tests.of(id);
    if (more != nullptr) solution.settings.more_tests.push_back(more->program);
    run.min_seconds[id] = min_test_seconds(exercise, run.limits);
    if (with.before != nullptr)
      solution.seconds = kept_seconds(*with.before, id, run.min_seconds[id]);
    if (solution.seconds) {
      settle(keys, solution, run);
      // Its solution is known to get full marks under all that a unit depends on.
      if (with.before->keys.count(id) != 0 && with.before->keys.at(id) == run.keys[id]) continue;
    }
    solutions.push_back(std::move(solution));
  }
  if (solutions.empty()) return;
  with.measuring();
  measure(with, solutions);
  for (const Solution& solution : solutions) settle(keys, solution, run);
}

}  // namespace contact::grading
