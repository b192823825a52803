// How long each lesson takes. The rule is in Python, because the book's pages promise by it.

#include <nlohmann/json.hpp>

#include "../python.hpp"
#include "dev_check.hpp"

namespace contact::cli {

std::vector<DevResult> check_lessons(grading::Loop& loop, const grading::Book& book) {
  const std::string program = (book.book_root() / "grading/book/lesson_minutes.py").string();
  const grading::ProcessResult done = run_python(
      loop, {python_of(book).string(), program, "--root", book.root().string(), "--json"});
  std::vector<DevResult> results;
  try {
    for (const nlohmann::json& lesson : nlohmann::json::parse(done.output))
      results.push_back({"lesson", lesson.at("chapter"), lesson.at("problems"), lesson.at("said")});
  } catch (const nlohmann::json::exception&) {
    return {{"lesson", "all", {"lesson_minutes.py failed: " + done.errors + done.output}}};
  }
  return results;
}

}  // namespace contact::cli
