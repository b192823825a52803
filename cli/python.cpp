#include "python.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

fs::path python_of(const grading::Book& book) {
  const fs::path python = book.book_root() / "build" / "venv" / "bin" / "python";
  return fs::exists(python) ? python : fs::path("python3");
}

grading::ProcessResult run_python(grading::Loop& loop, const std::vector<std::string>& command) {
  grading::ProcessSpec spec;
  spec.command = command;
  spec.environment = {{"PYTHONDONTWRITEBYTECODE", "1"}};
  spec.time_limit = 60.0;
  return grading::run_process(loop, spec);
}

}  // namespace contact::cli
