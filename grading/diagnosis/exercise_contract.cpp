#include "exercise_contract.hpp"

#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

HeaderText header(const fs::path& file) {
  try {
    return {file.string(), read_text(file)};
  } catch (const BookError&) {
    return {file.string(), ""};
  }
}

}  // namespace

std::vector<HeaderText> headers_of(const Exercise& exercise) {
  std::vector<HeaderText> headers{header(exercise.contract)};
  const fs::path root = exercise.folder.parent_path().parent_path().parent_path();
  std::error_code error;
  for (const fs::directory_entry& chapter : fs::directory_iterator(root / "chapters", error)) {
    const fs::path shapes = chapter.path() / "contact" / "shapes.hpp";
    if (fs::exists(shapes, error)) headers.push_back(header(shapes));
  }
  return headers;
}

ContractText contract_of(const Exercise& exercise) {
  std::vector<HeaderText> headers = headers_of(exercise);
  HeaderText contract = std::move(headers.front());
  headers.erase(headers.begin());
  return {std::move(contract), std::move(headers)};
}

}  // namespace contact::grading
