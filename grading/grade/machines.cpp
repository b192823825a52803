#include "machines.hpp"

#include <algorithm>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

int rank(const nlohmann::json& machine) {
  const std::string level = machine.at("level").get<std::string>();
  return level == "full" ? 2 : level == "reduced" ? 1 : 0;
}

}  // namespace

nlohmann::json weakest_machine(const Machine& here, const RunFolder& folder) {
  nlohmann::json weakest = to_json(here);
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder.grade() / "machines", error))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const nlohmann::json other = nlohmann::json::parse(read_text(file), nullptr, false);
    if (!other.is_object()) continue;
    if (rank(other) < rank(weakest)) weakest["level"] = other.at("level");
    for (const nlohmann::json& measure : other.at("measures")) {
      for (nlohmann::json& own : weakest["measures"]) {
        if (own.at("what") == measure.at("what") && !measure.at("enforced").get<bool>())
          own = measure;
      }
    }
  }
  return weakest;
}

}  // namespace contact::grading
