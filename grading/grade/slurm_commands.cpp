#include "slurm_commands.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "../book/book.hpp"

namespace contact::grading {

namespace {

// Slurm's commands wait for a controller that does not answer, and give up by themselves.
constexpr double command_seconds = 300.0;

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin));
}

std::string joined(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) result += (result.empty() ? "" : ",") + text;
  return result;
}

std::vector<std::string_view> parts(std::string_view text, char separator) {
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t end = text.find(separator);
    result.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return result;
    text.remove_prefix(end + 1);
  }
}

std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

// Lines "JOB_TASK|STATE|REASON", as squeue and sacct are asked for. sacct adds the cancelling user
// to a state and gives no reason.
SlurmQueue read_queue(std::string_view text) {
  SlurmQueue queue;
  for (const std::string_view line : parts(text, '\n')) {
    const std::vector<std::string_view> columns = parts(line, '|');
    const std::size_t underscore = columns[0].find('_');
    if (columns.size() < 2 || underscore == std::string_view::npos) continue;
    const std::optional<int> task = number(columns[0].substr(underscore + 1));
    if (!task) continue;
    const std::string_view state = columns[1];
    queue[{std::string(columns[0].substr(0, underscore)), *task}] = {
        std::string(state.substr(0, state.find(' '))),
        columns.size() > 2 ? std::string(columns[2]) : std::string()};
  }
  return queue;
}

bool says_memory(const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return word.starts_with("--mem"); });
}

}  // namespace

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  bool inside = false;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool space = c == ' ' || c == '\t' || c == '\n';
    if (quote == 0 && space) {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (quote == 0 && (c == '\'' || c == '"'))
      quote = c;
    else if (c == quote)
      quote = 0;
    else if (c == '\\' && quote != '\'' && i + 1 < text.size())
      words.back() += text[++i];
    else
      words.back() += c;
  }
  if (quote != 0) throw BookError("a quote is opened and not closed in " + std::string(text));
  return words;
}

bool SlurmTask::live() const {
  // The states in which a job has ended; whatever else there is, or will be, may still go on.
  constexpr std::array<std::string_view, 11> ended{
      "BOOT_FAIL", "CANCELLED", "COMPLETED", "DEADLINE",      "FAILED",       "NODE_FAIL",
      "PREEMPTED", "REVOKED",   "TIMEOUT",   "OUT_OF_MEMORY", "LAUNCH_FAILED"};
  return std::find(ended.begin(), ended.end(), state) == ended.end();
}

std::string SlurmCommands::run(const std::vector<std::string>& command) {
  const std::string& name = command.front();
  ProcessSpec spec;
  spec.command = command;
  spec.time_limit = command_seconds;
  ProcessResult result;
  try {
    result = run_process(loop_, spec);
  } catch (const std::runtime_error& error) {
    throw SlurmError(std::string(error.what()) +
                     ". --engine slurm needs Slurm's commands on this machine and in PATH (Debian: "
                     "slurm-client); --engine local needs no cluster");
  }
  if (result.succeeded()) return result.output;
  if (result.ended == Ended::time)
    throw SlurmError("Slurm's command " + name + " did not answer for " +
                     std::to_string(static_cast<int>(command_seconds)) + " seconds");
  std::string said = trimmed(result.errors.empty() ? result.output : result.errors);
  std::replace(said.begin(), said.end(), '\n', ' ');
  throw SlurmError(
      "Slurm's command " + name + " failed and said: " +
      (said.empty() ? "nothing (exit code " + std::to_string(result.exit_code) + ")" : said));
}

void SlurmCommands::require() {
  // These two only say their version; but they must be there before anything is submitted.
  for (const char* name : {"sbatch", "scancel"}) run({name, "--version"});
  run({"squeue", "--noheader", "--name=contact-grade"});
}

int SlurmCommands::max_tasks() {
  // "MaxArraySize            = 1001": one more than the largest number of a task.
  constexpr std::string_view key = "MaxArraySize";
  const std::string said = run({"scontrol", "show", "config"});
  for (const std::string_view line : parts(said, '\n')) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos || trimmed(line.substr(0, equals)) != key) continue;
    const std::optional<int> size = number(trimmed(line.substr(equals + 1)));
    // 0 forbids arrays; sbatch then says so.
    if (size) return std::max(*size, 1);
  }
  throw SlurmError("Slurm's command scontrol names no MaxArraySize among the cluster's settings");
}

std::string SlurmCommands::submit(const SlurmArray& array) {
  const std::vector<std::string> more = split_words(options_.more);
  std::vector<std::string> command{"sbatch", "--ntasks=1", "--cpus-per-task=1"};
  if (!options_.partition.empty()) command.push_back("--partition=" + options_.partition);
  if (!options_.account.empty()) command.push_back("--account=" + options_.account);
  if (!options_.time.empty()) command.push_back("--time=" + options_.time);
  if (!says_memory(more)) command.push_back("--mem=" + std::to_string(array.memory_mb) + "M");
  command.insert(command.end(), more.begin(), more.end());
  // The last word on an option counts, so nothing above can change what follows. A task's folder
  // and output are set here because a path in them would be read for %-patterns; a lost task is
  // submitted again, which is faster than Slurm's own requeueing and takes only the remaining
  // units.
  std::string range = "--array=0-" + std::to_string(array.tasks - 1);
  if (options_.tasks_at_a_time > 0) range += "%" + std::to_string(options_.tasks_at_a_time);
  for (std::string word :
       {std::string("--parsable"), "--job-name=" + array.name, range, std::string("--no-requeue"),
        std::string("--export=ALL"), std::string("--chdir=/"), std::string("--input=/dev/null"),
        std::string("--output=/dev/null"), std::string("--error=/dev/null")})
    command.push_back(std::move(word));
  if (array.exclusive) command.emplace_back("--exclusive");
  command.insert(command.end(), array.command.begin(), array.command.end());

  const std::string said = run(command);
  // "ID" or "ID;CLUSTER".
  const std::string id = trimmed(said.substr(0, said.find(';')));
  if (!number(id)) throw SlurmError("Slurm's command sbatch gave no job's number but: " + said);
  return id;
}

SlurmQueue SlurmCommands::queue(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return {};
  try {
    return read_queue(run({"squeue", "--noheader", "--array", "--states=all",
                           "--jobs=" + joined(jobs), "--format=%F_%K|%T|%r"}));
  } catch (const SlurmError& error) {
    // So it calls a job that ended long ago, if it is asked for that one alone.
    if (std::string_view(error.what()).find("Invalid job id") != std::string_view::npos) return {};
    throw;
  }
}

std::optional<std::string> SlurmCommands::find(const std::string& name) {
  const std::string said =
      trimmed(run({"squeue", "--noheader", "--states=all", "--name=" + name, "--format=%F"}));
  const std::string id = said.substr(0, said.find('\n'));
  if (id.empty()) return {};
  return id;
}

std::optional<SlurmTask> SlurmCommands::accounted(const std::string& job, int task) {
  try {
    const SlurmQueue queue =
        read_queue(run({"sacct", "--noheader", "--parsable2", "--allocations",
                        "--format=JobID,State", "--jobs=" + job + "_" + std::to_string(task)}));
    const auto found = queue.find({job, task});
    if (found != queue.end()) return found->second;
  } catch (const SlurmError&) {
    // Many clusters keep no accounts. How it ended is only told; what it did is in the results.
  }
  return {};
}

void SlurmCommands::cancel(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return;
  std::vector<std::string> command{"scancel", "--quiet"};
  command.insert(command.end(), jobs.begin(), jobs.end());
  run(command);
}

}  // namespace contact::grading
