#include "build.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../diagnosis/exercise_contract.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

fs::file_time_type modified(const fs::path& file) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(file, error);
  return error ? fs::file_time_type::min() : time;
}

bool is_header(const fs::path& file) { return file.extension() == ".hpp"; }

void newest_in(const fs::path& folder, fs::file_time_type& newest) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (is_header(entry.path())) newest = std::max(newest, modified(entry.path()));
  }
}

// When any file last changed that the compiled tests may be made of. A superset is fine: after a
// build, the stamp says that everything of that time is built.
fs::file_time_type newest_source(const Book& book, const Exercise& exercise) {
  fs::file_time_type newest = modified(exercise.test_source);
  newest_in(exercise.folder, newest);
  for (const char* host : {"exercise.cpp", "runner.cpp"})
    newest = std::max(newest, modified(book.book_root() / "tests" / "support" / host));
  newest_in(exercise.test_source.parent_path(), newest);
  newest_in(book.book_root() / "tests" / "support", newest);
  newest_in(book.book_root() / "grading" / "contact", newest);
  for (const Chapter& chapter : book.chapters()) newest_in(chapter.folder / "contact", newest);
  if (book.base() != nullptr) {
    for (const Chapter& chapter : book.base()->chapters())
      newest_in(chapter.folder / "contact", newest);
  }
  return newest;
}

fs::path stamp_of(const Book& book, const Exercise& exercise) {
  return book.build_dir() / "contact" / exercise.chapter / (exercise.name + ".built");
}

void touch(const fs::path& stamp, fs::file_time_type time) {
  std::error_code ignored;
  fs::create_directories(stamp.parent_path(), ignored);
  { std::ofstream made(stamp); }
  fs::last_write_time(stamp, time, ignored);
}

std::vector<std::string> texts(const nlohmann::json& json, const char* key) {
  return json.contains(key) ? json.at(key).get<std::vector<std::string>>()
                            : std::vector<std::string>{};
}

// What a check needs and no more: the sealed tests, not the solution and the proxy that the whole
// exercise's target also builds. Ninja takes a file for a target.
std::string tests_file(const Exercise& exercise) {
  return "exercises/" + exercise.chapter + "/" + exercise.name + "/tests.o";
}

std::string last_lines(const std::string& text, int count) {
  std::size_t at = text.size();
  while (at > 0 && count >= 0) {
    at = text.rfind('\n', at - 1);
    if (at == std::string::npos) return text;
    --count;
  }
  return text.substr(at == 0 ? 0 : at + 1);
}

// Two builds in one folder spoil each other's work; the script ./contact takes the same lock.
class BuildLock {
 public:
  BuildLock(Loop& loop, const fs::path& file)
      : descriptor_(::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644)) {
    if (descriptor_ < 0) return;
    while (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      loop.poll();
      uv_sleep(20);
    }
  }
  ~BuildLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;

 private:
  int descriptor_;
};

// The student's file as it stands now; one that cannot be read is talked about without its text.
Diagnosis diagnosis_of(const fs::path& file, const Exercise& exercise) {
  std::string text;
  try {
    text = read_text(file);
  } catch (const BookError&) {
  }
  return {file.string(), std::move(text), contract_of(exercise)};
}

Explained compiler_said(const ProcessResult& result, const BuildDescription& build,
                        const Exercise& exercise, const fs::path& file) {
  if (result.succeeded() && result.errors.empty()) return {};
  try {
    return diagnosis_of(file, exercise)
        .of_compile(result.errors, !result.succeeded(), columns_of(build));
  } catch (const std::exception&) {
    return unexplained(result.errors, !result.succeeded(), file.string());
  }
}

Explained linker_said(const ProcessResult& result, const Exercise& exercise, const fs::path& file) {
  if (result.succeeded()) return {};
  try {
    return diagnosis_of(file, exercise).of_link(result.errors);
  } catch (const std::exception&) {
    return unexplained(result.errors, true, file.string());
  }
}

std::vector<std::string> link_with(const BuildDescription& build,
                                   const std::vector<std::string>& flags, const fs::path& object,
                                   const std::string& other, const fs::path& program) {
  std::vector<std::string> command{build.compiler};
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), {object.string(), other});
  command.insert(command.end(), build.support_libs.begin(), build.support_libs.end());
  command.insert(command.end(), {"-o", program.string()});
  return command;
}

}  // namespace

BuildDescription read_build_description(const fs::path& build_dir) {
  const fs::path file = build_dir / "exercises.json";
  if (!fs::exists(file))
    throw BookError("the exercises are not built yet (" + file.string() +
                    " is missing): run ./contact setup");
  try {
    const nlohmann::json json = nlohmann::json::parse(read_text(file));
    BuildDescription build;
    build.compiler = json.at("compiler").get<std::string>();
    build.compile_flags = texts(json, "compile_flags");
    build.include = texts(json, "include");
    build.pch = json.value("pch", "");
    build.link_flags = texts(json, "link_flags");
    build.server_link_flags = texts(json, "server_link_flags");
    build.support_libs = texts(json, "support_libs");
    build.asks_objects = texts(json, "asks_objects");
    for (const auto& [id, entry] : json.at("exercises").items())
      build.exercises[id] = {entry.at("test_object").get<std::string>(),
                             entry.at("target").get<std::string>(),
                             texts(entry, "include"),
                             entry.at("server_object").get<std::string>(),
                             entry.at("asks").get<std::string>(),
                             entry.at("proxy_object").get<std::string>()};
    return build;
  } catch (const nlohmann::json::exception& error) {
    throw BookError(file.string() + " is not understood: " + error.what());
  }
}

bool tests_are_stale(const Book& book, const BuildDescription& build, const Exercise& exercise) {
  const auto bundle = build.exercises.find(exercise.id());
  if (bundle == build.exercises.end() || !fs::exists(bundle->second.tests)) return true;
  if (!build.pch.empty() && !fs::exists(build.pch + ".gch")) return true;
  for (const std::string& library : build.support_libs) {
    if (!fs::exists(library)) return true;
  }
  const fs::file_time_type built =
      std::max(modified(bundle->second.tests), modified(stamp_of(book, exercise)));
  return newest_source(book, exercise) > built;
}

namespace {

// What a pack's build was set up for: another book, or the same pack elsewhere, needs another.
std::string set_up_for(const Book& pack) {
  return pack.book_root().string() + "\n" + pack.root().string() + "\n";
}

bool is_set_up(const Book& pack) {
  const fs::path stamp = pack.build_dir() / "pack.txt";
  return fs::exists(pack.build_dir() / "build.ninja") && fs::exists(stamp) &&
         read_text(stamp) == set_up_for(pack);
}

// A pack has a build of its own, in which the book's CMake builds the pack's exercises.
void set_up_pack(Loop& loop, const Book& pack) {
  if (pack.base() == nullptr || is_set_up(pack)) return;
  std::fprintf(stderr, "Setting up the build of the pack (once) ...\n");
  fs::create_directories(pack.build_dir());
  const BuildLock lock(loop, pack.root() / "build" / "lock");
  ProcessSpec spec;
  spec.command = {"cmake",
                  "--fresh",
                  "-S",
                  pack.book_root().string(),
                  "--preset",
                  "dev",
                  "-B",
                  pack.build_dir().string(),
                  "-DCONTACT_PACK=" + pack.root().string()};
  spec.folder = pack.book_root();
  const ProcessResult result = run_process(loop, spec);
  if (!result.succeeded())
    throw BookError("the build of the pack cannot be set up:\n" +
                    last_lines(result.output + result.errors, 25));
  write_text(pack.build_dir() / "pack.txt", set_up_for(pack));
}

void require_set_up(Loop& loop, const Book& book) {
  set_up_pack(loop, book);
  if (!fs::exists(book.build_dir() / "build.ninja") && !fs::exists(book.build_dir() / "Makefile"))
    throw BookError("nothing is built yet in " + book.build_dir().string() +
                    ": run ./contact setup");
}

}  // namespace

void build_target(Loop& loop, const Book& book, const std::vector<std::string>& targets) {
  set_up_pack(loop, book);
  const BuildLock lock(loop, book.root() / "build" / "lock");
  ProcessSpec spec;
  spec.command = {"cmake", "--build", book.build_dir().string(), "--target"};
  spec.command.insert(spec.command.end(), targets.begin(), targets.end());
  const ProcessResult result = run_process(loop, spec);
  if (result.succeeded()) return;
  std::string names;
  for (const std::string& target : targets) names += (names.empty() ? "" : ", ") + target;
  throw BookError(names + (targets.size() == 1 ? " does" : " do") + " not build:\n" +
                  last_lines(result.output + result.errors, 25));
}

void build_tests(Loop& loop, const Book& book, const std::vector<const Exercise*>& exercises) {
  std::vector<std::string> targets{"contact_prelude"};
  std::vector<fs::file_time_type> times;
  for (const Exercise* exercise : exercises) {
    targets.push_back(tests_file(*exercise));
    times.push_back(newest_source(book, *exercise));
  }
  const std::string what = exercises.size() == 1 ? exercises.front()->id()
                                                 : std::to_string(exercises.size()) + " exercises";
  std::fprintf(stderr, "Building the tests of %s (once; they changed or are new) ...\n",
               what.c_str());
  build_target(loop, book, targets);
  for (std::size_t i = 0; i < exercises.size(); ++i) touch(stamp_of(book, *exercises[i]), times[i]);
}

BuildDescription ready_build(Loop& loop, const Book& book,
                             const std::vector<const Exercise*>& exercises) {
  set_up_pack(loop, book);
  std::optional<BuildDescription> build;
  if (fs::exists(book.build_dir() / "exercises.json"))
    build = read_build_description(book.build_dir());
  std::vector<const Exercise*> stale;
  for (const Exercise* exercise : exercises) {
    if (!build || tests_are_stale(book, *build, *exercise)) stale.push_back(exercise);
  }
  if (stale.empty() && build) return *build;
  require_set_up(loop, book);
  if (!stale.empty()) build_tests(loop, book, stale);
  build = read_build_description(book.build_dir());
  for (const Exercise* exercise : exercises) {
    if (build->exercises.count(exercise->id()) == 0)
      throw BookError("the build knows nothing of " + exercise->id() +
                      ": its contract, stub, tests and solution must all exist");
  }
  return *build;
}

BuildDescription ready_to_grade(Loop& loop, const Book& book,
                                const std::vector<const Exercise*>& exercises) {
  require_set_up(loop, book);
  // A pack is graded by the book's programs.
  std::vector<std::string> targets{"contact_prelude"};
  const std::vector<std::string> programs{"contact-box", "contact-explain"};
  if (book.base() == nullptr)
    targets.insert(targets.end(), programs.begin(), programs.end());
  else
    build_target(loop, *book.base(), programs);
  std::vector<fs::file_time_type> times;
  for (const Exercise* exercise : exercises) {
    targets.push_back("exercise_" + exercise->chapter + "_" + exercise->name);
    times.push_back(newest_source(book, *exercise));
  }
  build_target(loop, book, targets);
  for (std::size_t i = 0; i < exercises.size(); ++i) touch(stamp_of(book, *exercises[i]), times[i]);
  return read_build_description(book.build_dir());
}

std::vector<std::string> compile_command(const BuildDescription& build, const Exercise& exercise,
                                         const fs::path& source, const fs::path& object) {
  std::vector<std::string> command{build.compiler};
  command.insert(command.end(), build.compile_flags.begin(), build.compile_flags.end());
  // Nothing may come before the prelude, or the compiler cannot use its precompiled form.
  if (!build.pch.empty()) command.insert(command.end(), {"-include", build.pch});
  for (const std::string& folder : build.include) command.push_back("-I" + folder);
  for (const std::string& folder : build.exercises.at(exercise.id()).include)
    command.push_back("-I" + folder);
  command.insert(command.end(),
                 {"-fdiagnostics-color=never", "-c", source.string(), "-o", object.string()});
  return command;
}

CompiledFile compile(Loop& loop, const Book& book, const BuildDescription& build,
                     const Exercise& exercise, const fs::path& source, const fs::path& folder,
                     const std::vector<std::string>& more_include) {
  CompiledFile compiled;
  compiled.object = folder / (exercise.name + ".o");
  ProcessSpec spec;
  spec.command = compile_command(build, exercise, source, compiled.object);
  for (const std::string& include : more_include) spec.command.push_back("-I" + include);
  spec.folder = book.root();
  spec.environment = compiler_environment();
  spec.time_limit = 60.0;
  spec.output_limit = 8u << 20;
  const ProcessResult result = run_process(loop, spec);
  compiled.seconds = result.seconds;
  if (result.ended == Ended::time) {
    compiled.said.error = CompileError{};
    compiled.said.error->message = "the compiler did not finish within 60 s";
    compiled.said.error->full = result.errors;
  } else {
    compiled.said = compiler_said(result, build, exercise, source);
  }
  return compiled;
}

// g++ counts columns as a terminal shows them, clang++ in bytes.
Columns columns_of(const BuildDescription& build) {
  return build.compiler.find("clang") == std::string::npos ? Columns::displayed : Columns::bytes;
}

std::vector<std::pair<std::string, std::string>> compiler_environment() {
  return {{"LC_ALL", "C.UTF-8"}, {"COLUMNS", "0"}};
}

std::vector<std::string> link_command(const BuildDescription& build, const Exercise& exercise,
                                      const fs::path& object, const fs::path& program) {
  return link_with(build, build.link_flags, object, build.exercises.at(exercise.id()).tests,
                   program);
}

std::vector<std::string> server_link_command(const BuildDescription& build,
                                             const Exercise& exercise, const fs::path& object,
                                             const fs::path& program) {
  return link_with(build, build.server_link_flags, object, build.exercises.at(exercise.id()).server,
                   program);
}

LinkedProgram link(Loop& loop, const Book& book, const BuildDescription& build,
                   const Exercise& exercise, const fs::path& source, const fs::path& object,
                   const fs::path& folder) {
  LinkedProgram linked;
  linked.program = folder / exercise.name;
  ProcessSpec spec;
  spec.command = link_command(build, exercise, object, linked.program);
  spec.folder = book.root();
  spec.environment = compiler_environment();
  spec.time_limit = 60.0;
  spec.output_limit = 8u << 20;
  const ProcessResult result = run_process(loop, spec);
  linked.seconds = result.seconds;
  linked.said = linker_said(result, exercise, source);
  return linked;
}

}  // namespace contact::grading
