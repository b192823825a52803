#include "run_state.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include "profile.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr const char* run_format = "contact-grade-run/1";
constexpr const char* unit_format = "contact-grade-unit/1";

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unknown machine";
}

std::string flat(const std::string& exercise) {
  const std::size_t slash = exercise.find('/');
  return exercise.substr(0, slash) + "." + exercise.substr(slash + 1);
}

void sync(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

// A folder of results has .grade from its first moment, and .grade the lock.
void require_ours(const RunFolder& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder.results(), error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status))
    throw BookError(folder.results().string() +
                    " is there and is no folder. Give another name for the results");
  if (fs::is_empty(folder.results(), error)) return;
  if (error) throw BookError("cannot read " + folder.results().string() + ": " + error.message());
  if (!fs::is_regular_file(folder.grade() / "lock", error))
    throw BookError(folder.results().string() +
                    " holds files that no grading made. Give a new or an empty folder for the "
                    "results, so that nothing is overwritten");
}

}  // namespace

std::string order_of(const Job& job) {
  return job.submission + "\t" + job.exercise + (job.alone ? "\talone" : "");
}

Job job_from_order(std::string_view line) {
  const std::size_t tab = line.find('\t');
  if (tab == std::string_view::npos)
    throw BookError("'" + std::string(line) + "' is no order: SUBMISSION, a tab, EXERCISE");
  Job job;
  job.submission = line.substr(0, tab);
  std::string_view rest = line.substr(tab + 1);
  constexpr std::string_view alone = "\talone";
  job.alone = rest.ends_with(alone);
  if (job.alone) rest.remove_suffix(alone.size());
  job.exercise = rest;
  return job;
}

std::vector<std::string> differences(const UnitKey& a, const UnitKey& b) {
  std::vector<std::string> result;
  if (a.tests != b.tests) result.emplace_back("tests");
  if (a.seed != b.seed) result.emplace_back("seed");
  if (a.limits != b.limits) result.emplace_back("limits");
  if (a.code != b.code) result.emplace_back("code");
  if (a.grader != b.grader) result.emplace_back("grader");
  return result;
}

nlohmann::json to_json(const UnitKey& key) {
  return {{"code", key.code},
          {"tests", key.tests},
          {"seed", key.seed},
          {"limits", key.limits},
          {"grader", key.grader}};
}

UnitKey key_from_json(const nlohmann::json& json) {
  UnitKey key;
  json.at("code").get_to(key.code);
  json.at("tests").get_to(key.tests);
  json.at("seed").get_to(key.seed);
  json.at("limits").get_to(key.limits);
  json.at("grader").get_to(key.grader);
  return key;
}

nlohmann::json to_json(const Run& run) {
  nlohmann::json keys = nlohmann::json::object();
  for (const auto& [exercise, key] : run.keys) keys[exercise] = to_json(key);
  nlohmann::json submissions = nlohmann::json::array();
  for (const RunSubmission& submission : run.submissions)
    submissions.push_back({{"id", submission.id}, {"folder", submission.folder.string()}});
  return {{"format", run_format},
          {"root", run.root.string()},
          {"book_root", run.book_root.string()},
          {"build", run.build.string()},
          {"results", run.results.string()},
          {"seed", run.seed},
          {"limits", to_json(run.limits)},
          {"accept_weak", run.accept_weak},
          {"min_seconds", run.min_seconds},
          {"test_seconds", run.test_seconds},
          {"unit_seconds", run.unit_seconds},
          {"keys", keys},
          {"private", to_json(run.private_tests)},
          {"exercises", run.exercises},
          {"submissions", submissions}};
}

Run read_run(const fs::path& file) {
  const std::string text = read_text(file);
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    if (json.at("format") != run_format)
      throw BookError(file.string() + " is not " + run_format +
                      ": another version of the program made it. Grade into a new folder");
    Run run;
    run.root = json.at("root").get<std::string>();
    // An earlier version knew no packs.
    run.book_root = json.value("book_root", run.root.string());
    run.build = json.at("build").get<std::string>();
    run.results = json.at("results").get<std::string>();
    json.at("seed").get_to(run.seed);
    run.limits = limits_from_json(json.at("limits"));
    json.at("accept_weak").get_to(run.accept_weak);
    json.at("min_seconds").get_to(run.min_seconds);
    json.at("test_seconds").get_to(run.test_seconds);
    // A folder written by an earlier version has none; it is computed before it is used.
    if (json.contains("unit_seconds")) json.at("unit_seconds").get_to(run.unit_seconds);
    for (const auto& [exercise, key] : json.at("keys").items())
      run.keys[exercise] = key_from_json(key);
    run.private_tests = private_tests_from_json(json.at("private"));
    json.at("exercises").get_to(run.exercises);
    for (const nlohmann::json& entry : json.at("submissions"))
      run.submissions.push_back(
          {entry.at("id").get<std::string>(), entry.at("folder").get<std::string>()});
    return run;
  } catch (const nlohmann::json::exception& error) {
    throw BookError(file.string() + " is not understood (" + error.what() +
                    "). Grade into a new folder");
  }
}

fs::path RunFolder::text_file(const Job& job) const {
  return submission(job.submission) / (job.exercise + ".cpp");
}

fs::path RunFolder::unit_file(const Job& job) const {
  return grade() / "units" / job.submission / (flat(job.exercise) + ".json");
}

std::optional<Unit> RunFolder::unit(const Job& job) const {
  const fs::path file = unit_file(job);
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  try {
    nlohmann::json json = nlohmann::json::parse(read_text(file));
    Unit unit;
    if (json.at("format") != unit_format || json.at("submission") != job.submission ||
        json.at("exercise") != job.exercise)
      return {};
    unit.submission = job.submission;
    unit.exercise = job.exercise;
    unit.key = key_from_json(json.at("key"));
    json.at("gradable").get_to(unit.gradable);
    json.at("near_limit").get_to(unit.near_limit);
    json.at("reruns").get_to(unit.reruns);
    json.at("seconds").get_to(unit.seconds);
    unit.verdict = std::move(json.at("verdict"));
    return unit;
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

void RunFolder::write_unit(const Unit& unit) const {
  const nlohmann::json json = {{"format", unit_format},
                               {"submission", unit.submission},
                               {"exercise", unit.exercise},
                               {"key", to_json(unit.key)},
                               {"status", "graded"},
                               {"gradable", unit.gradable},
                               {"near_limit", unit.near_limit},
                               {"reruns", unit.reruns},
                               {"seconds", unit.seconds},
                               {"verdict", unit.verdict}};
  const fs::path file = unit_file({unit.submission, unit.exercise});
  fs::create_directories(file.parent_path());
  // Not pressed to the disk: a unit that a power cut takes away or cuts off is only graded again.
  write_text(file, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void RunFolder::log(const std::string& what, const Job& job) const {
  const std::string line =
      what + "\t" + order_of(job) + "\t" + host_name() + ":" + std::to_string(::getpid()) + "\n";
  const int descriptor =
      ::open((grade() / "log").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (descriptor < 0) return;
  // One write, so that lines of several workers do not mix.
  if (::write(descriptor, line.data(), line.size()) < 0) {
    // A log that cannot be written to is no reason to lose a unit's result.
  }
  ::close(descriptor);
}

RunLock::RunLock(const RunFolder& folder) {
  require_ours(folder);
  // Only for the instructor: it holds the work of many.
  const ::mode_t mask = ::umask(0077);
  std::error_code error;
  fs::create_directories(folder.grade(), error);
  const fs::path file = folder.grade() / "lock";
  descriptor_ = error ? -1 : ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  ::umask(mask);
  if (descriptor_ < 0)
    throw BookError("cannot write to " + folder.results().string() + ": " +
                    (error ? error.message() : std::strerror(errno)));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    std::array<char, 512> holder{};
    const ssize_t count = ::read(descriptor_, holder.data(), holder.size() - 1);
    ::close(descriptor_);
    throw BookError(folder.results().string() + " is being graded into already" +
                    (count > 0 ? ", by " + std::string(holder.data()) : "") +
                    ". Wait until that has ended, or end it");
  }
  const std::string who = "process " + std::to_string(::getpid()) + " on " + host_name();
  if (::ftruncate(descriptor_, 0) != 0 ||
      ::write(descriptor_, who.data(), who.size()) != static_cast<ssize_t>(who.size())) {
    ::close(descriptor_);
    throw BookError("cannot write to " + file.string() + " (is the disk full?)");
  }
}

RunLock::~RunLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

nlohmann::json machine_for_workers(const Machine& machine) {
  // A member that is added to Machine and not here stops the compiler.
  const auto& [level, measures, own_user_ids, namespaces, own_process_count, filter, closed_files,
               groups, group_pids, group_memory, bubblewrap, launcher, max_workers] = machine;
  nlohmann::json told = nlohmann::json::array();
  for (const Measure& measure : measures)
    told.push_back({{"what", measure.what}, {"enforced", measure.enforced}, {"how", measure.how}});
  return {{"level", static_cast<int>(level)},
          {"measures", told},
          {"own_user_ids", own_user_ids},
          {"namespaces", namespaces},
          {"own_process_count", own_process_count},
          {"system_call_filter", filter},
          {"closed_files", closed_files},
          {"control_groups", static_cast<int>(groups)},
          {"group_pids", group_pids},
          {"group_memory", group_memory},
          {"bubblewrap", bubblewrap},
          {"launcher", launcher},
          {"max_workers", max_workers}};
}

Machine machine_from_coordinator(const nlohmann::json& json) {
  Machine machine;
  machine.level = static_cast<Level>(json.at("level").get<int>());
  for (const nlohmann::json& measure : json.at("measures"))
    machine.measures.push_back({measure.at("what").get<std::string>(),
                                measure.at("enforced").get<bool>(),
                                measure.at("how").get<std::string>()});
  json.at("own_user_ids").get_to(machine.own_user_ids);
  json.at("namespaces").get_to(machine.namespaces);
  json.at("own_process_count").get_to(machine.own_process_count);
  json.at("system_call_filter").get_to(machine.system_call_filter);
  json.at("closed_files").get_to(machine.closed_files);
  machine.control_groups = static_cast<ControlGroups>(json.at("control_groups").get<int>());
  json.at("group_pids").get_to(machine.group_pids);
  json.at("group_memory").get_to(machine.group_memory);
  json.at("bubblewrap").get_to(machine.bubblewrap);
  json.at("launcher").get_to(machine.launcher);
  json.at("max_workers").get_to(machine.max_workers);
  return machine;
}

void write_durably(const fs::path& file, std::string_view text) {
  const fs::path partial = file.parent_path() / ("." + file.filename().string() + ".new");
  write_text(partial, text);
  sync(partial);
  std::error_code error;
  fs::rename(partial, file, error);
  if (error) throw BookError("cannot write " + file.string() + ": " + error.message());
  sync(file.parent_path());
}

nlohmann::json verdict_without_times(nlohmann::json verdict) {
  nlohmann::json times = verdict.at("seconds");
  verdict.erase("seconds");
  times["tests"] = nlohmann::json::array();
  for (nlohmann::json& test : verdict.at("tests")) {
    times["tests"].push_back(test.at("seconds"));
    test.erase("seconds");
  }
  verdict["times"] = std::move(times);
  return verdict;
}

std::string drawn_seed() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw BookError("the system gives no random numbers: choose a seed with --seed");
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : bytes) {
    text += digits[byte >> 4];
    text += digits[byte & 0xf];
  }
  return text;
}

}  // namespace contact::grading
