#include "unit_compile.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "../diagnosis/exercise_contract.hpp"
#include "../diagnosis/message_text.hpp"
#include "explain_box.hpp"
#include "unit_time.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

// More than this, and what the compiler says is no longer kept but stopped.
constexpr std::size_t kMessageFlood = 8u << 20;

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
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
  show(book.book_root() / "chapters" / "00_vectors" / "contact");
  show(exercise.contract);
  if (!exercise.given.empty()) show(exercise.given);
  show(build.exercises.at(exercise.id()).server);
  spec.limits.cpu_seconds = limits.compile_cpu_seconds;
  spec.limits.wall_seconds = compile_wall_seconds(limits);
  spec.limits.idle_seconds = limits.compile_idle_seconds;
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
  if (process.ended == Ended::idle)
    return "the compiler waited for " + points_text(limits.compile_idle_seconds) +
           " s in all and did nothing: does the file include what is no file?";
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

CompileError error_without_place(const fs::path& file, std::string message, std::string full) {
  CompileError error;
  error.file = file.string();
  error.message = std::move(message);
  error.full = std::move(full);
  return error;
}

bool is_program(const fs::path& file, const GradeLimits& limits) {
  std::error_code error;
  return fs::symlink_status(file, error).type() == fs::file_type::regular &&
         fs::file_size(file, error) <= (static_cast<std::uintmax_t>(limits.object_mb) << 20);
}

}  // namespace

CompiledUnit compile_unit(Loop& loop, const Book& book, const BuildDescription& build,
                          const Machine& machine, const Seat& seat, const Exercise& exercise,
                          const fs::path& file, std::string_view text, const fs::path& folder,
                          const GradeLimits& limits) {
  CompiledUnit unit;
  const std::string root = (book.root() / "").string();
  const std::string book_root = (book.book_root() / "").string();
  const fs::path object = exercise.name + ".o";
  const auto run = [&](std::vector<std::string> command, double& seconds) {
    BoxSpec spec = compile_box(book, build, exercise, folder, limits);
    spec.command = std::move(command);
    BoxEnd end = run_box(loop, machine, seat, std::move(spec));
    seconds += end.process.seconds;
    end.process.errors = std::string(first_lines(end.process.errors, limits.diagnostics_bytes));
    const std::string limit = limit_met(end, file, limits);
    unit.near_limit = unit.near_limit || !limit.empty() || end.process.ended != Ended::by_itself ||
                      end.cpu_seconds > limits.compile_cpu_seconds / 2;
    if (!limit.empty()) unit.said.error = error_without_place(file, limit, end.process.errors);
    return end.process;
  };
  const auto explained = [&](ExplainRequest::Step step, const ProcessResult& process) {
    ExplainRequest request;
    request.step = step;
    request.failed = !process.succeeded();
    request.columns = columns_of(build);
    request.file = file.string();
    request.source = text;
    request.log = process.errors;
    request.headers = headers_of(exercise);
    request.root = root;
    Explained said = explain_in_box(loop, machine, seat, request);
    if (book.base() != nullptr) shorten(said, book_root);
    return said;
  };

  const ProcessResult compiled =
      run(compile_command(build, exercise, file, object), unit.seconds.compile);
  if (!unit.said.error && !(compiled.succeeded() && compiled.errors.empty()))
    unit.said = explained(ExplainRequest::Step::compile, compiled);
  if (!unit.said.error) {
    std::vector<std::string> command = server_link_command(build, exercise, object, exercise.name);
    ProcessResult linked = run(command, unit.seconds.link);
    std::optional<Explained> said;
    const auto explain_link = [&] {
      said.reset();
      if (!unit.said.error && !linked.succeeded())
        said = explained(ExplainRequest::Step::link, linked);
    };
    explain_link();
    if (said && said->only_library_twice) {
      command.emplace_back("-Wl,-z,muldefs");
      linked = run(command, unit.seconds.link);
      explain_link();
    }
    if (said) {
      unit.said.error = std::move(said->error);
      unit.said.remarks.insert(unit.said.remarks.begin(), said->remarks.begin(),
                               said->remarks.end());
    }
  }
  if (unit.said.error) {
    for (const std::string& folder : {root, book_root})
      replace_all(unit.said.error->full, folder, "");
    return unit;
  }
  unit.program = folder / exercise.name;
  if (!is_program(unit.program, limits))
    unit.said.error = error_without_place(file, "the linker made no program of it", "");
  return unit;
}

}  // namespace contact::grading
