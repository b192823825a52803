#include "report_writer.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

fs::path python_of(const Book& book) {
  const fs::path own = book.book_root() / "build" / "venv" / "bin" / "python";
  std::error_code error;
  const bool there = fs::exists(own, error);
  if (error)
    throw BookError("the Python that writes the reports cannot be reached (" + own.string() + ": " +
                    error.message() +
                    "): grade as a user who may, or run ./contact setup as the one who grades");
  if (!there)
    throw BookError("the Python that writes the reports is not there (" + own.string() +
                    "): run ./contact setup");
  return own;
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t start = text.rfind('\n');
  text = start == std::string::npos ? text : text.substr(start + 1);
  const std::size_t error = text.find("error: ");
  return error == std::string::npos ? text : text.substr(error + 7);
}

}  // namespace

ProcessSpec report_module(const Book& book, const std::string& module) {
  ProcessSpec spec;
  spec.command = {python_of(book).string(), "-m", module};
  spec.folder = book.book_root();
  spec.environment = {{"PYTHONPATH", (book.book_root() / "grading").string()},
                      {"PYTHONDONTWRITEBYTECODE", "1"}};
  return spec;
}

ProcessResult ReportWriter::run(Loop& loop, const fs::path& results,
                                const std::optional<std::string>& again) const {
  ProcessSpec spec = report_module(book_, "reports");
  spec.command.push_back(results.string());
  if (!options_.formats.empty()) {
    std::string list;
    for (const std::string& format : options_.formats) list += (list.empty() ? "" : ",") + format;
    spec.command.insert(spec.command.end(), {"--formats", list});
  }
  if (!options_.due.empty()) spec.command.insert(spec.command.end(), {"--due", options_.due});
  if (again) spec.command.push_back("--again=" + *again);
  return run_process(loop, spec);
}

void ReportWriter::require() const {
  Loop loop;
  const TemporaryFolder empty;
  const ProcessResult result = run(loop, empty.path(), {});
  constexpr int not_understood = 2;
  constexpr int no_results = 3;
  if (result.exit_code == not_understood) throw UnknownName(last_line(result.errors));
  if (result.exit_code != no_results)
    throw BookError("the Python that writes the reports, " + python_of(book_).string() +
                    ", does not do so (" +
                    (result.errors.empty() ? "it says nothing" : last_line(result.errors)) +
                    "): run ./contact setup");
}

void ReportWriter::write(Loop& loop, const RunFolder& folder,
                         const std::optional<std::string>& again) const {
  const ProcessResult result = run(loop, folder.results(), again);
  if (!result.succeeded())
    throw BookError("the marks are in " + (folder.results() / "results.json").string() +
                    ", but the reports could not be written: " + result.errors);
}

}  // namespace contact::grading
