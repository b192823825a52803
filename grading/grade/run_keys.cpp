#include "run_keys.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "profile.hpp"
#include "sha256.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

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

RunKeys::RunKeys(Loop& loop, const BuildDescription& build, const fs::path& program)
    : build_(build) {
  Sha256 sum;
  sum.add_part(read_text(program));
  if (const fs::path launcher = program.parent_path() / "contact-box"; fs::exists(launcher))
    sum.add_part(read_text(launcher));
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
      .add_part(read_text(bundle.asks));
  if (private_tests != nullptr) tests.add_part(private_tests->fingerprint);
  key.tests = tests.text();
  key.seed = sha256(seed);
  key.limits = Sha256()
                   .add_part(to_json(limits).dump())
                   .add_part(nlohmann::json(test_seconds).dump())
                   .text();
  key.grader = Sha256().add_part(grader_).add_part(read_text(bundle.server)).text();
  return key;
}

}  // namespace contact::grading
