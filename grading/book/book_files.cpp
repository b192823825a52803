// What only a program with a disk of its own does with the book's folders; the page's judge does
// without this file.

#include <cstdlib>
#include <fstream>

#include <unistd.h>

#include "book.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

fs::path find_root() {
  const auto is_root = [](const fs::path& folder) {
    return fs::is_directory(folder / "chapters") && fs::is_directory(folder / "exercises") &&
           !fs::exists(folder / "pack.toml");
  };
  if (const char* given = std::getenv("CONTACT_ROOT"); given != nullptr && *given != '\0') {
    fs::path root = fs::absolute(given).lexically_normal();
    if (!is_root(root))
      throw BookError("CONTACT_ROOT is " + root.string() +
                      ", which holds no chapters/ and exercises/");
    return root;
  }
  for (fs::path folder = fs::current_path();; folder = folder.parent_path()) {
    if (is_root(folder)) return folder;
    if (folder == folder.parent_path()) break;
  }
  throw BookError(
      "this is not inside the book: no folder from here upwards holds chapters/ and exercises/");
}

fs::path find_work(const fs::path& root) {
  if (const char* given = std::getenv("CONTACT_WORK"); given != nullptr && *given != '\0')
    return fs::absolute(given).lexically_normal();
  return root / "work";
}

void write_text(const fs::path& file, std::string_view text) {
  const fs::path partial =
      file.parent_path() / ("." + file.filename().string() + "." + std::to_string(::getpid()));
  {
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.flush();
    if (!stream) {
      std::error_code ignored;
      fs::remove(partial, ignored);
      throw BookError("cannot write " + file.string() +
                      " (is the disk full, or the folder read-only?)");
    }
  }
  std::error_code error;
  fs::rename(partial, file, error);
  if (error) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw BookError("cannot write " + file.string() + ": " + error.message());
  }
}

}  // namespace contact::grading
