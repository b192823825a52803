#include "private_tests.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include "sha256.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using nlohmann::json;

bool hidden_file(const fs::path& path) { return path.filename().string().starts_with('.'); }

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!hidden_file(entry.path())) entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

// ---- Where the folder is, and who can read it

void check_apart(const fs::path& folder, const fs::path& submissions) {
  if (!fs::is_directory(folder))
    throw BookError("--private " + folder.string() + ": there is no such folder");
  if (submissions.empty() || !fs::exists(submissions)) return;
  const fs::path inside = fs::canonical(folder).lexically_relative(fs::canonical(submissions));
  if (!inside.empty() && *inside.begin() != "..")
    throw BookError("--private " + folder.string() + " is inside " + submissions.string() +
                    ", so it would be graded as a submission: move it out of there");
}

mode_t mode_of(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mode : 0;
}

// Whether somebody who is neither its owner nor of its group gets into the folder.
bool open_to_others(const fs::path& folder) {
  const fs::path whole = fs::canonical(folder);
  if ((mode_of(whole) & (S_IROTH | S_IXOTH)) == 0) return false;
  for (fs::path above = whole.parent_path();; above = above.parent_path()) {
    if ((mode_of(above) & S_IXOTH) == 0) return false;
    if (above == above.root_path()) return true;
  }
}

// Where a box holds only the files that were put into it, or the kernel closes all others to it, a
// submission cannot read these. Else its compiler is another user's process on this very file
// system, and `#include` opens what that user may read.
void check_unreadable(const Machine& machine, const PrivateTestsPlace& place) {
  if (machine.level == Level::full || machine.closed_files || place.accept_weak) return;
  const std::string level(words(machine.level));
  if (!machine.own_user_ids)
    throw BookError("--private " + place.folder.string() + ": at level " + level +
                    " submissions are compiled as the user that you are, who can read these tests. "
                    "Grade as root, or on a machine of which `contact doctor` says \"full\"; "
                    "--accept-weak goes on all the same");
  if (open_to_others(place.folder))
    throw BookError("--private " + place.folder.string() + ": at level " + level +
                    " a submission could read these tests while it is compiled. Close the folder "
                    "first: chmod o-rwx " +
                    place.folder.string());
}

// ---- What is in it

// A folder of tests, and the exercise that they are of.
struct Found {
  const Exercise* exercise;
  fs::path folder;
  std::vector<fs::path> sources;
  std::vector<TestSpec> tests;
};

void check_tests(const Found& found) {
  const fs::path file = found.folder / "tests.toml";
  std::set<std::string> known;
  for (const TestSpec& test : found.exercise->tests) known.insert(test.name);
  for (const TestSpec& test : found.tests) {
    if (test.name.empty()) throw BookError(file.string() + ": a test has no name");
    if (!known.insert(test.name).second)
      throw BookError(file.string() + ": there is more than one test called '" + test.name +
                      "'; the book's count too");
    if (!(test.points > 0.0) || !std::isfinite(test.points))
      throw BookError(file.string() + ": the test '" + test.name +
                      "' needs points, a number above zero");
  }
  for (const TestSpec& test : found.tests) {
    for (const std::string& need : test.needs) {
      if (known.count(need) == 0 || need == test.name)
        throw BookError(file.string() + ": the test '" + test.name +
                        "' requires one that does not exist: '" + need + "'");
    }
  }
}

Found read_exercise_folder(const Exercise& exercise, const fs::path& folder) {
  Found found{&exercise, folder, {}, {}};
  for (const fs::path& file : entries_of(folder)) {
    if (file.filename().string().ends_with("_test.cpp")) {
      found.sources.push_back(file);
    } else if (file.extension() == ".cpp") {
      throw BookError(file.string() + " would not be compiled: call it " + file.stem().string() +
                      "_test.cpp");
    }
  }
  if (!fs::exists(folder / "tests.toml"))
    throw BookError(folder.string() +
                    " has no tests.toml, which lists its tests and their points as "
                    "exercise.toml does");
  if (found.sources.empty())
    throw BookError(folder.string() + " has no " + exercise.name + "_test.cpp");
  found.tests = read_test_list(folder / "tests.toml", true);
  check_tests(found);
  return found;
}

std::vector<Found> read_folder(const Book& book, const fs::path& folder) {
  std::vector<std::string> ids;
  for (const Exercise& exercise : book.exercises()) ids.push_back(exercise.id());
  std::vector<Found> all;
  for (const fs::path& chapter : entries_of(folder)) {
    if (!fs::is_directory(chapter)) continue;
    for (const fs::path& inner : entries_of(chapter)) {
      if (!fs::is_directory(inner)) continue;
      const std::string id = chapter.filename().string() + "/" + inner.filename().string();
      const auto exercise =
          std::find_if(book.exercises().begin(), book.exercises().end(),
                       [&](const Exercise& candidate) { return candidate.id() == id; });
      if (exercise == book.exercises().end()) {
        const std::vector<std::string> near = nearest(id, ids);
        throw BookError(inner.string() + ": there is no exercise " + id +
                        (near.empty() ? "" : "; did you mean " + near.front() + "?"));
      }
      all.push_back(read_exercise_folder(*exercise, inner));
    }
  }
  if (all.empty())
    throw BookError("--private " + folder.string() +
                    " holds no tests: they lie in NN_slug/NAME/, as exercises do in the book");
  return all;
}

// ---- From sources to a program

// As CMake's generators quote a command: words between blanks, quotes and backslashes.
std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words;
  std::string word;
  bool inside = false;
  char quote = 0;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    if (c == '\\' && quote != '\'' && i + 1 < command.size()) {
      word += command[++i];
      inside = true;
    } else if (quote != 0) {
      if (c == quote)
        quote = 0;
      else
        word += c;
    } else if (c == '"' || c == '\'') {
      quote = c;
      inside = true;
    } else if (c == ' ') {
      if (inside) words.push_back(std::move(word));
      word.clear();
      inside = false;
    } else {
      word += c;
      inside = true;
    }
  }
  if (inside) words.push_back(std::move(word));
  return words;
}

// The very command that compiled the book's tests of an exercise, without its source and object.
std::vector<std::string> test_command(const Book& book, const Exercise& exercise) {
  const fs::path file = book.build_dir() / "compile_commands.json";
  try {
    for (const json& entry : json::parse(read_text(file))) {
      if (entry.at("file").get<std::string>() != exercise.test_source.string()) continue;
      std::vector<std::string> command = words_of(entry.at("command").get<std::string>());
      for (const char* option : {"-o", "-c"}) {
        const auto at = std::find(command.begin(), command.end(), option);
        if (at != command.end() && at + 1 != command.end()) command.erase(at, at + 2);
      }
      return command;
    }
  } catch (const json::exception& error) {
    throw BookError(file.string() + " is not understood: " + error.what());
  }
  throw BookError(file.string() + " does not say how the tests of " + exercise.id() +
                  " are compiled: run ./contact setup");
}

std::string cut(const std::string& text) {
  constexpr std::size_t most = 6000;
  return text.size() <= most ? text : text.substr(0, most) + "\n(and more)";
}

// A compiler's messages, each once: a macro as Catch2's CHECK holds what it is given more than
// once, and so does what the compiler says of it. A message ends where the next line is not
// indented.
std::string each_once(const std::string& text) {
  std::set<std::string> said;
  std::string result;
  for (std::size_t start = 0; start < text.size();) {
    std::size_t end = std::min(text.find('\n', start), text.size() - 1) + 1;
    const std::string first = text.substr(start, end - start);
    while (end < text.size() && text[end] == ' ')
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
    const std::string message = text.substr(start, end - start);
    const bool diagnostic = first.find(": error: ") != std::string::npos ||
                            first.find(": warning: ") != std::string::npos ||
                            first.find(": note: ") != std::string::npos;
    if (!diagnostic || said.insert(message).second) result += message;
    start = end;
  }
  return result;
}

// What a file that a program was made from was like. Large ones (libraries, precompiled headers)
// are known by size and time.
std::string stamp_of(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return "missing";
  if (size <= (4u << 20)) return sha256_of_file(file);
  return std::to_string(size) + " bytes, time " +
         std::to_string(fs::last_write_time(file, error).time_since_epoch().count());
}

// The files that a compiler's list of dependencies names: TARGET: FILE FILE \ ...
std::vector<std::string> dependencies(const fs::path& list) {
  std::string text = read_text(list);
  text.erase(0, text.find(": ") + 2);
  for (std::size_t at = 0; (at = text.find("\\\n", at)) != std::string::npos;)
    text.replace(at, 2, " ");
  std::erase(text, '\n');
  return words_of(text);
}

class Builder {
 public:
  Builder(Loop& loop, const Book& book, const BuildDescription& build, const Found& found,
          const fs::path& cache)
      : loop_(loop),
        book_(book),
        build_(build),
        found_(found),
        folder_(cache / (found.exercise->chapter + "." + found.exercise->name)) {}

  PrivateExercise made() {
    const auto bundle = build_.exercises.find(found_.exercise->id());
    if (bundle == build_.exercises.end() || build_.asks_objects.empty())
      throw BookError("the build knows nothing of " + found_.exercise->id() +
                      ": run ./contact setup");
    compiler_ = test_command(book_, *found_.exercise);
    linked_ = build_.asks_objects;
    linked_.insert(linked_.begin(), bundle->second.proxy);
    json made_of = read_made_of();
    if (!current(made_of)) {
      std::fprintf(stderr, "Compiling the private tests of %s ...\n",
                   found_.exercise->id().c_str());
      made_of = build();
    }
    return {found_.exercise->id(), folder_ / "asks", found_.tests, fingerprint(made_of)};
  }

 private:
  [[nodiscard]] json sources() const {
    json names = json::array();
    for (const fs::path& source : found_.sources) names.push_back(source.string());
    return names;
  }

  [[nodiscard]] json read_made_of() const {
    const fs::path file = folder_ / "made_of.json";
    if (!fs::exists(file)) return {};
    return json::parse(read_text(file), nullptr, false);
  }

  [[nodiscard]] bool current(const json& made_of) const {
    if (!made_of.is_object() || !fs::exists(folder_ / "asks")) return false;
    if (made_of.value("compiler", json()) != json(compiler_) ||
        made_of.value("sources", json()) != sources() ||
        made_of.value("names", json()) != json(names()))
      return false;
    const json files = made_of.value("files", json::object());
    return !files.empty() && std::all_of(files.items().begin(), files.items().end(), [](auto item) {
      return item.value() == stamp_of(item.key());
    });
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const TestSpec& test : found_.tests) names.push_back(test.name);
    return names;
  }

  ProcessResult run(const std::vector<std::string>& command) {
    ProcessSpec spec;
    spec.command = command;
    spec.folder = book_.build_dir();
    spec.environment = {{"LC_ALL", "C.UTF-8"}};
    spec.time_limit = 600.0;
    return run_process(loop_, spec);
  }

  // Compiles and links apart and moves the result into place, so that a program is whole or not
  // there.
  json build() {
    const TemporaryFolder work;
    json files = json::object();
    std::vector<std::string> link{build_.compiler};
    link.insert(link.end(), build_.server_link_flags.begin(), build_.server_link_flags.end());
    for (std::size_t i = 0; i < found_.sources.size(); ++i) {
      const fs::path object = work.path() / (std::to_string(i) + ".o");
      const fs::path list = work.path() / (std::to_string(i) + ".d");
      std::vector<std::string> command = compiler_;
      command.insert(command.end(), {"-MMD", "-MF", list.string(), "-fdiagnostics-color=never",
                                     "-c", found_.sources[i].string(), "-o", object.string()});
      const ProcessResult result = run(command);
      if (!result.succeeded())
        throw BookError("the private test " + found_.sources[i].string() + " does not compile:\n" +
                        cut(each_once(result.errors)));
      // A path in the list is as the compiler was given it: from the build's folder.
      for (const std::string& file : dependencies(list)) {
        const fs::path whole = (book_.build_dir() / file).lexically_normal();
        files[whole.string()] = stamp_of(whole);
      }
      link.push_back(object.string());
    }
    for (const std::string& file : linked_) files[file] = stamp_of(file);
    // The compiler's list does not go into a precompiled header.
    for (const std::string& word : compiler_) {
      if (fs::exists(word + ".gch")) files[word + ".gch"] = stamp_of(word + ".gch");
    }
    const fs::path program = work.path() / "asks";
    link.insert(link.end(), linked_.begin(), linked_.end());
    link.insert(link.end(), {"-o", program.string()});
    const ProcessResult result = run(link);
    if (!result.succeeded())
      throw BookError("the private tests in " + found_.folder.string() + " do not link:\n" +
                      cut(result.errors));
    check_compiled(program);
    json made_of = {{"format", "contact-private-tests/1"},
                    {"compiler", compiler_},
                    {"sources", sources()},
                    {"names", names()},
                    {"files", std::move(files)}};
    install(program, made_of);
    return made_of;
  }

  void check_compiled(const fs::path& program) {
    const ProcessResult result = run({program.string(), "--list-tests", "-v", "quiet"});
    if (!result.succeeded())
      throw BookError("the private tests in " + found_.folder.string() +
                      " cannot be listed: " + cut(result.errors));
    const std::string file = (found_.folder / "tests.toml").string();
    std::vector<std::string> listed = names();
    std::size_t at = 0;
    while (at < result.output.size()) {
      const std::size_t end = std::min(result.output.find('\n', at), result.output.size());
      const std::string name = result.output.substr(at, end - at);
      at = end + 1;
      if (!name.empty() && std::erase(listed, name) == 0)
        throw BookError(file + " does not list the test '" + name +
                        "', which is in its sources: give it points");
    }
    if (!listed.empty())
      throw BookError(file + " lists the test '" + listed.front() +
                      "', which no *_test.cpp beside it defines");
  }

  // Others may run the program (a box's user does), but not read it.
  void install(const fs::path& program, const json& made_of) {
    fs::create_directories(folder_);
    fs::remove(folder_ / "made_of.json");
    const fs::path beside = folder_ / "asks.new";
    fs::copy_file(program, beside, fs::copy_options::overwrite_existing);
    fs::permissions(beside, fs::perms(0711));
    fs::rename(beside, folder_ / "asks");
    write_text(folder_ / "made_of.json", made_of.dump(1));
  }

  // Folders may move between two runs; what stands in the files decides.
  [[nodiscard]] std::string fingerprint(const json& made_of) const {
    std::vector<std::string> parts;
    for (const auto& [file, stamp] : made_of.at("files").items()) {
      const std::string text = stamp.get<std::string>();
      if (text.find(' ') == std::string::npos)
        parts.push_back(fs::path(file).filename().string() + " " + text);
    }
    std::sort(parts.begin(), parts.end());
    Sha256 sum;
    sum.add_part(read_text(found_.folder / "tests.toml"));
    for (const std::string& part : parts) sum.add_part(part);
    return sum.text();
  }

  Loop& loop_;
  const Book& book_;
  const BuildDescription& build_;
  const Found& found_;
  fs::path folder_;
  std::vector<std::string> compiler_;
  std::vector<std::string> linked_;
};

}  // namespace

const PrivateExercise* PrivateTests::of(const std::string& exercise) const {
  const auto found = std::find_if(exercises.begin(), exercises.end(),
                                  [&](const PrivateExercise& p) { return p.exercise == exercise; });
  return found == exercises.end() ? nullptr : &*found;
}

PrivateTests load_private_tests(Loop& loop, const Book& book, const BuildDescription& build,
                                const Machine& machine, const PrivateTestsPlace& place) {
  try {
    check_apart(place.folder, place.submissions);
    check_unreadable(machine, place);
    const std::vector<Found> all = read_folder(book, fs::canonical(place.folder));
    PrivateTests tests;
    for (const Found& found : all)
      tests.exercises.push_back(Builder(loop, book, build, found, place.cache).made());
    return tests;
  } catch (const fs::filesystem_error& error) {
    throw BookError(std::string("private tests: ") + error.what());
  }
}

Exercise with_private_tests(const Exercise& exercise, const PrivateTests& tests) {
  Exercise whole = exercise;
  if (const PrivateExercise* more = tests.of(exercise.id()))
    whole.tests.insert(whole.tests.end(), more->tests.begin(), more->tests.end());
  return whole;
}

json to_json(const PrivateTests& tests) {
  json list = json::array();
  for (const PrivateExercise& exercise : tests.exercises) {
    json specs = json::array();
    for (const TestSpec& test : exercise.tests)
      specs.push_back({{"name", test.name},
                       {"points", test.points},
                       {"requires", test.needs},
                       {"visibility", key(test.visibility)}});
    list.push_back({{"exercise", exercise.exercise},
                    {"program", exercise.program.string()},
                    {"fingerprint", exercise.fingerprint},
                    {"tests", std::move(specs)}});
  }
  return list;
}

PrivateTests private_tests_from_json(const json& list) {
  PrivateTests tests;
  for (const json& entry : list) {
    PrivateExercise exercise;
    exercise.exercise = entry.at("exercise").get<std::string>();
    exercise.program = entry.at("program").get<std::string>();
    exercise.fingerprint = entry.at("fingerprint").get<std::string>();
    for (const json& spec : entry.at("tests")) {
      TestSpec test{spec.at("name").get<std::string>(), spec.at("points").get<double>(),
                    spec.at("requires").get<std::vector<std::string>>(), Visibility::hidden, true};
      if (const auto seen = visibility_from_key(spec.at("visibility").get<std::string>()))
        test.visibility = *seen;
      exercise.tests.push_back(std::move(test));
    }
    tests.exercises.push_back(std::move(exercise));
  }
  return tests;
}

}  // namespace contact::grading
