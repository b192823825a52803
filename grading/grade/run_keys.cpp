#include "run_keys.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "profile.hpp"
#include "sha256.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

bool older(const fs::path& file, const fs::path& than) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(file, error);
  if (error) return true;
  const fs::file_time_type other = fs::last_write_time(than, error);
  return !error && time < other;
}

bool is_current(const Book& book, const BuildDescription& build, const Exercise& exercise) {
  if (tests_are_stale(book, build, exercise)) return false;
  const BuildDescription::Bundle& bundle = build.exercises.at(exercise.id());
  return fs::exists(bundle.server) && !older(bundle.asks, bundle.tests) &&
         !older(bundle.asks, bundle.proxy) &&
         std::none_of(build.asks_objects.begin(), build.asks_objects.end(),
                      [&](const std::string& object) { return older(bundle.asks, object); });
}

std::string compiler_version(Loop& loop, const BuildDescription& build) {
  ProcessSpec spec;
  spec.command = {build.compiler, "--version"};
  spec.environment = {{"LC_ALL", "C.UTF-8"}};
  const ProcessResult result = run_process(loop, spec);
  if (!result.succeeded()) throw BookError(build.compiler + " --version does not work");
  return result.output;
}

// Every header that a student's file may include, but the contract and the system's.
void add_headers(Sha256& sum, const BuildDescription& build) {
  for (const std::string& folder : build.include) {
    std::vector<fs::path> headers;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file() && entry.path().extension() == ".hpp")
        headers.push_back(entry.path());
    }
    std::sort(headers.begin(), headers.end());
    for (const fs::path& header : headers)
      sum.add_part(header.lexically_relative(folder).string()).add_part(read_text(header));
  }
}

}  // namespace

BuildDescription current_build(Loop& loop, const Book& book,
                               const std::vector<const Exercise*>& exercises) {
  if (fs::exists(book.build_dir() / "exercises.json")) {
    BuildDescription build = read_build_description(book.build_dir());
    if (fs::exists(own_program().parent_path() / "contact-box") &&
        fs::exists(own_program().parent_path() / "contact-explain") &&
        std::all_of(exercises.begin(), exercises.end(),
                    [&](const Exercise* exercise) { return is_current(book, build, *exercise); }))
      return build;
  }
  std::fprintf(stderr, "Building what is graded with, if it changed ...\n");
  BuildDescription build = ready_to_grade(loop, book, exercises);
  for (const Exercise* exercise : exercises) {
    const auto bundle = build.exercises.find(exercise->id());
    if (bundle == build.exercises.end())
      throw BookError("the build knows nothing of " + exercise->id() +
                      ": its contract, stub, tests and solution must all exist");
    // Also one that had nothing to be built for is as new as what it is made of.
    fs::last_write_time(bundle->second.asks, fs::file_time_type::clock::now());
  }
  return build;
}

fs::path own_program() {
  std::string path = fs::read_symlink("/proc/self/exe").string();
  // So the system calls a file that is no longer there.
  constexpr std::string_view gone = " (deleted)";
  if (path.ends_with(gone)) path.resize(path.size() - gone.size());
  return path;
}

RunKeys::RunKeys(Loop& loop, const BuildDescription& build) : build_(build) {
  Sha256 sum;
  sum.add_part(read_text("/proc/self/exe"));
  for (const char* helper : {"contact-box", "contact-explain"}) {
    if (const fs::path program = own_program().parent_path() / helper; fs::exists(program))
      sum.add_part(read_text(program));
  }
  sum.add_part(compiler_version(loop, build));
  for (const auto* flags : {&build.compile_flags, &build.server_link_flags}) {
    for (const std::string& flag : *flags) sum.add_part(flag);
  }
  add_headers(sum, build);
  grader_ = sum.text();
}

UnitKey RunKeys::of(const Exercise& exercise, const PrivateExercise* private_tests,
                    const std::string& seed, const GradeLimits& limits, double test_seconds) const {
  const BuildDescription::Bundle& bundle = build_.exercises.at(exercise.id());
  UnitKey key;
  Sha256 tests;
  tests.add_part(read_text(exercise.folder / "exercise.toml"))
      .add_part(read_text(exercise.contract))
      .add_part(exercise.given.empty() ? std::string() : read_text(exercise.given))
      .add_part(read_text(bundle.asks));
  if (private_tests != nullptr) tests.add_part(private_tests->fingerprint);
  key.tests = tests.text();
  key.seed = sha256(seed);
  // A unit that outlives its time has no result, so none depends on how long that is.
  GradeLimits of_result = limits;
  of_result.unit_seconds = 0.0;
  key.limits = Sha256()
                   .add_part(to_json(of_result).dump())
                   .add_part(nlohmann::json(test_seconds).dump())
                   .text();
  key.grader = Sha256().add_part(grader_).add_part(read_text(bundle.server)).text();
  return key;
}

}  // namespace contact::grading
