#include "slurm_log.hpp"

#include <fstream>

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace contact::grading {

std::map<Job, SlurmTrouble> troubles_in(const fs::path& log) {
  std::map<Job, SlurmTrouble> troubles;
  std::ifstream stream(log);
  for (std::string line; std::getline(stream, line);) {
    const nlohmann::json said = nlohmann::json::parse(line, nullptr, false);
    if (said.is_object() && said.value("event", "") == "trouble")
      troubles[{said.value("submission", ""), said.value("exercise", "")}] = {
          said.value("what", "it does not say why"), said.value("out_of_time", false)};
  }
  return troubles;
}

std::string last_words(const fs::path& log) {
  constexpr std::size_t most = 300;
  std::ifstream stream(log);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && !nlohmann::json::accept(line)) last = std::move(line);
  }
  if (last.size() > most) last = "..." + last.substr(last.size() - most);
  return last;
}

}  // namespace contact::grading
