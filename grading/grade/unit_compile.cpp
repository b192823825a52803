#include "unit_compile.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "../build_text.hpp"
#include "unit_time.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

// More than this, and what the compiler says is no longer kept but stopped.
constexpr std::size_t kMessageFlood = 8u << 20;

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// Whole lines, no more than `most` bytes.
std::string first_lines(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  const std::size_t end = text.rfind('\n', most);
  text.resize(end == std::string::npos ? most : end + 1);
  return text;
}

BoxSpec compile_box(const Book& book, const BuildDescription& build, const Exercise& exercise,
                    const fs::path& folder, const GradeLimits& limits) {
  BoxSpec spec;
  spec.kind = BoxKind::compile;
  spec.system = true;
  spec.environment = compiler_environment();
  spec.environment.emplace_back("PATH", "/usr/bin:/bin");
  spec.writable = {folder, "/submission"};
  spec.folder = "/submission";
  // What is the book's has the path that it has outside: messages about the contract are known by
  // it.
  const auto show = [&](const fs::path& path) { spec.read_only.push_back({path, path}); };
  show(fs::path(build.pch).parent_path());
  show(book.root() / "chapters" / "00_vectors" / "contact");
  show(exercise.contract);
  show(build.exercises.at(exercise.id()).server);
  spec.limits.cpu_seconds = limits.compile_cpu_seconds;
  spec.limits.wall_seconds = compile_wall_seconds(limits);
  spec.limits.memory_mb = limits.compile_memory_mb;
  spec.limits.processes = limits.compile_processes;
  spec.limits.output_bytes = kMessageFlood;
  spec.limits.files_mb = limits.object_mb;
  return spec;
}

// What the compiler's parts say of themselves, without messages about the answer and its lines.
std::string said_of_itself(const std::string& errors, const fs::path& answer) {
  std::string said;
  for (const std::string& line : split_lines(errors)) {
    if (!line.starts_with(' ') && !line.starts_with(answer.string() + ":")) said += line + '\n';
  }
  return said;
}

// Why there is no object, if it is not for what the file says.
std::string limit_met(const BoxEnd& end, const fs::path& answer, const GradeLimits& limits) {
  const ProcessResult& process = end.process;
  if (process.ended == Ended::output) return "the compiler's messages did not end";
  if (process.succeeded()) return {};
  const std::string said = said_of_itself(process.errors, answer);
  const auto says = [&](std::initializer_list<std::string_view> parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](std::string_view part) { return contains(said, part); });
  };
  if (process.ended == Ended::time || says({"CPU time limit exceeded"}))
    return "the compiler did not finish within " + points_text(limits.compile_cpu_seconds) +
           " s of processor time";
  if (end.out_of_memory ||
      says({"out of memory", "memory exhausted", "annot allocate memory", "Killed signal"}))
    return "the compiler took more than " + std::to_string(limits.compile_memory_mb) + " MB";
  if (says({"File size limit exceeded", "o space left on device", "File too large"}))
    return "the compiled file would be larger than " + std::to_string(limits.object_mb) + " MB";
  return {};
}

void replace_all(std::string& text, std::string_view part, std::string_view by) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.replace(at, part.size(), by);
}

// What a student reads names the book's files from its root on, and not where they lie here.
class Shortened {
 public:
  explicit Shortened(const Book& book) : prefix_((book.root() / "").string()) {}

  void operator()(std::string& text) const { replace_all(text, prefix_, ""); }
  void operator()(Explained& said) const {
    for (Remark& remark : said.remarks) {
      for (std::string* text : {&remark.file, &remark.message, &remark.words}) (*this)(*text);
    }
    for (std::string& warning : said.warnings) (*this)(warning);
    if (!said.error) return;
    CompileError& error = *said.error;
    for (std::string* text :
         {&error.file, &error.message, &error.excerpt, &error.explanation, &error.full})
      (*this)(*text);
    for (ContractLine& line : error.contract) (*this)(line.file);
  }

 private:
  std::string prefix_;
};

// The linker's complaint about a name that the student's file defines and the C library has too.
// Where libraries are shared, as in a check, the student's goes before it without a word.
bool only_library_twice(const ProcessResult& process) {
  if (process.succeeded()) return false;
  const LinkFaults faults = parse_link_faults(process.errors);
  return faults.missing.empty() && !faults.twice.empty() &&
         std::none_of(faults.twice.begin(), faults.twice.end(), [](const std::string& name) {
           return name == "main" || contains(name, "::");
         });
}

bool is_program(const fs::path& file, const GradeLimits& limits) {
  std::error_code error;
  return fs::symlink_status(file, error).type() == fs::file_type::regular &&
         fs::file_size(file, error) <= (static_cast<std::uintmax_t>(limits.object_mb) << 20);
}

}  // namespace

CompiledUnit compile_unit(Loop& loop, const Book& book, const BuildDescription& build,
                          const Machine& machine, const Seat& seat, const Exercise& exercise,
                          const Answer& answer, const fs::path& folder, const GradeLimits& limits) {
  CompiledUnit unit;
  const Shortened shorten(book);
  const fs::path object = exercise.name + ".o";
  const auto run = [&](std::vector<std::string> command, double& seconds) {
    BoxSpec spec = compile_box(book, build, exercise, folder, limits);
    spec.command = std::move(command);
    BoxEnd end = run_box(loop, machine, seat, std::move(spec));
    seconds += end.process.seconds;
    end.process.errors = first_lines(std::move(end.process.errors), limits.diagnostics_bytes);
    const std::string limit = limit_met(end, answer.file, limits);
    unit.near_limit = unit.near_limit || !limit.empty() || end.process.ended != Ended::by_itself ||
                      end.cpu_seconds > limits.compile_cpu_seconds / 2;
    if (!limit.empty()) {
      unit.said.error = CompileError{};
      unit.said.error->message = limit;
      unit.said.error->file = answer.file.string();
      unit.said.error->full = end.process.errors;
    }
    return end.process;
  };

  const ProcessResult compiled =
      run(compile_command(build, exercise, answer.file, object), unit.seconds.compile);
  if (!unit.said.error) unit.said = compiler_said(compiled, build, exercise, answer);
  if (!unit.said.error) {
    std::vector<std::string> command = server_link_command(build, exercise, object, exercise.name);
    ProcessResult linked = run(command, unit.seconds.link);
    if (only_library_twice(linked)) {
      command.emplace_back("-Wl,-z,muldefs");
      linked = run(command, unit.seconds.link);
    }
    if (!unit.said.error) {
      Explained said = linker_said(linked, exercise, answer);
      unit.said.error = std::move(said.error);
      unit.said.remarks.insert(unit.said.remarks.begin(), said.remarks.begin(), said.remarks.end());
    }
  }
  shorten(unit.said);
  if (unit.said.error) return unit;
  unit.program = folder / exercise.name;
  if (!is_program(unit.program, limits)) {
    unit.said.error = CompileError{};
    unit.said.error->message = "the linker made no program of it";
    unit.said.error->file = answer.file.string();
  }
  return unit;
}

}  // namespace contact::grading
