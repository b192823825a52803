#include "private_build.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include <nlohmann/json.hpp>

#include "sha256.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using nlohmann::json;

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
  Builder(Loop& loop, const Book& book, const BuildDescription& build, const PrivateFolder& found,
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
  const PrivateFolder& found_;
  fs::path folder_;
  std::vector<std::string> compiler_;
  std::vector<std::string> linked_;
};

}  // namespace

PrivateExercise private_exercise(Loop& loop, const Book& book, const BuildDescription& build,
                                 const PrivateFolder& folder, const fs::path& cache) {
  return Builder(loop, book, build, folder, cache).made();
}

}  // namespace contact::grading
