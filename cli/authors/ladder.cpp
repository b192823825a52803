// contact ladder: measure a chapter's accuracy against time on this machine, and keep the result.

#include <array>
#include <fstream>
#include <map>

#include <sys/utsname.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../../grading/build/build.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

struct Options {
  std::string chapter;
  long size = 0;
  long repeats = 0;
  std::string output;
  bool json = false;
};

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  utsname names{};
  return ::uname(&names) == 0 ? names.machine : "unknown";
}

std::string system_name() {
  std::ifstream release("/etc/os-release");
  for (std::string line; std::getline(release, line);) {
    if (!line.starts_with("PRETTY_NAME=")) continue;
    std::string name = line.substr(12);
    std::erase(name, '"');
    return name;
  }
  utsname names{};
  return ::uname(&names) == 0 ? std::string(names.sysname) + " " + names.release : "unknown";
}

nlohmann::json machine() {
  return {
      {"cpu", processor_name()}, {"cores", ::sysconf(_SC_NPROCESSORS_ONLN)}, {"os", system_name()}};
}

// What kind of machine it is, never whose: the processor's name and the number of cores.
std::string machine_id(const nlohmann::json& machine) {
  std::string id;
  for (const char c : machine["cpu"].get<std::string>()) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!id.empty() && id.back() != '-')
      id += '-';
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id + "-" + std::to_string(machine["cores"].get<long>()) + "-cores";
}

std::string number(const nlohmann::json& value, const char* format) {
  if (!value.is_number()) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value.get<double>());
  return text.data();
}

std::string right_aligned(const std::string& text, std::size_t width) {
  const std::size_t size = display_width(text);
  return size < width ? std::string(width - size, ' ') + text : text;
}

void print_table(const nlohmann::json& ladder) {
  const Style style(stdout);
  std::map<std::string, std::string> method_titles;
  std::size_t width = 0;
  for (const nlohmann::json& method : ladder.at("methods")) {
    const std::string title =
        method.at("title").get<std::string>() + " (" + method.value("scalar", "") + ")";
    method_titles[method.at("id").get<std::string>()] = title;
    width = std::max(width, display_width(title));
  }
  say(style.bold(ladder.value("question", "")));
  for (const nlohmann::json& family : ladder.at("families")) {
    say("\n" + style.bold(family.value("title", "")));
    say(style.dim("  " + padded("method", width) + right_aligned("ns", 10) +
                  right_aligned("quartiles", 18) + right_aligned("wrong", 10) +
                  right_aligned("undecided", 11) + right_aligned("of", 10) +
                  right_aligned("largest error", 15)));
    for (const nlohmann::json& result : ladder.at("results")) {
      if (result.at("family") != family.at("id")) continue;
      const std::string quartiles =
          number(result["ns_q1"], "%.1f") + " - " + number(result["ns_q3"], "%.1f");
      say("  " + padded(method_titles[result.at("method").get<std::string>()], width) +
          right_aligned(number(result["ns_median"], "%.1f"), 10) + right_aligned(quartiles, 18) +
          right_aligned(number(result["wrong"], "%.0f"), 10) +
          right_aligned(number(result["undecided"], "%.0f"), 11) +
          right_aligned(number(result["n"], "%.0f"), 10) +
          right_aligned(number(result["error_max"], "%.2g"), 15));
    }
  }
}

int run(Context& context, const Options& options) {
  const grading::Book& book = context.book();
  const grading::Chapter* chapter = book.find_chapter(options.chapter);
  if (chapter == nullptr)
    throw grading::UnknownName("there is no chapter called '" + options.chapter +
                               "'; `contact list` shows them");
  if (!fs::exists(chapter->folder / "ladder.cpp"))
    throw grading::BookError(chapter->slug + " has no ladder.cpp");

  const std::string target = "ladder_" + chapter->slug;
  note("Building " + target + " ...");
  grading::build_target(context.loop(), book, {target});

  const grading::TemporaryFolder folder;
  const fs::path raw = folder.path() / "ladder.json";
  grading::ProcessSpec spec;
  spec.command = {(book.build_dir() / "bin" / target).string(), "--json", raw.string()};
  if (options.size > 0)
    spec.command.insert(spec.command.end(), {"--size", std::to_string(options.size)});
  if (options.repeats > 0)
    spec.command.insert(spec.command.end(), {"--repeats", std::to_string(options.repeats)});
  spec.folder = book.root();
  note("Measuring; do not use the machine meanwhile ...");
  const grading::ProcessResult result = grading::run_process(context.loop(), spec);
  if (!result.succeeded())
    throw grading::BookError(target + " failed (exit code " + std::to_string(result.exit_code) +
                             "):\n" + result.output + result.errors);

  nlohmann::json ladder;
  try {
    ladder = nlohmann::json::parse(grading::read_text(raw));
    ladder["machine"] = machine();
    const fs::path output =
        options.output.empty() ? book.root() / "benchmarks" / "results" /
                                     (chapter->slug + "." + machine_id(ladder["machine"]) + ".json")
                               : fs::absolute(options.output);
    fs::create_directories(output.parent_path());
    grading::write_text(output, ladder.dump(1) + "\n");
    if (options.json)
      say(ladder.dump(1));
    else
      print_table(ladder);
    note("Kept in " + shown(output));
  } catch (const nlohmann::json::exception& error) {
    throw grading::BookError(target +
                             " wrote something that is not a ladder's result: " + error.what());
  }
  return exit_passed;
}

}  // namespace

void add_ladder(Command app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command = app.add_subcommand(ladder_command);
  command.add_option("chapter", options->chapter, "The chapter: 02_triangles, triangles or 2")
      .required();
  command.add_option("--size", options->size, "Inputs in each family").positive();
  command.add_option("--repeats", options->repeats, "Timed runs of each method").positive();
  command.add_option("--output", options->output,
                     "Where to write (default: benchmarks/results/CHAPTER.MACHINE.json)");
  command.add_flag("--json", options->json, "Print the JSON instead of a table");
  command.callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
