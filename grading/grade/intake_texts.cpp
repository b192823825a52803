#include "intake_texts.hpp"

#include "sha256.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

// Nothing if it cannot be read, which does not prevent grading.
std::optional<std::string> readable_text(const fs::path& file) {
  try {
    return read_text(file);
  } catch (const BookError&) {
    return {};
  }
}

}  // namespace

void keep_texts(const Entrant& entrant, const std::vector<const Exercise*>& exercises,
                const RunFolder& folder, Earlier& earlier, Class& all) {
  for (const Exercise* exercise : exercises) {
    const Job job{entrant.id, exercise->id()};
    const fs::path file = folder.text_file(job);
    const auto found = entrant.files.find(job.exercise);
    const bool taken = found != entrant.files.end() && found->second.problem.empty();
    const bool there = fs::exists(file);
    const std::optional<std::string> before = there ? readable_text(file) : std::nullopt;
    const bool same = taken && before && *before == found->second.text;
    if (there && !same) {
      const fs::path as = fs::path("submissions") / job.submission / (job.exercise + ".cpp");
      if (before)
        earlier.keep(file, as);
      else
        earlier.put_away(file, as);
      if (!taken) fs::remove(file);
    }
    if (found == entrant.files.end()) continue;
    if (!taken) {
      all.standings[job] = Standing::refused;
      continue;
    }
    const std::string& text = found->second.text;
    const bool untouched = text == read_text(exercise->stub);
    all.standings[job] = untouched ? Standing::untouched : Standing::handed_in;
    all.codes[job] = sha256(text);
    if (same) continue;
    fs::create_directories(file.parent_path());
    write_text(file, text);
  }
}

}  // namespace contact::grading
