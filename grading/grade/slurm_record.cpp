#include "slurm_record.hpp"

#include <algorithm>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr const char* record_format = "contact-grade-slurm/1";

std::string name_of_task(int task, const char* ending) { return std::to_string(task) + ending; }

}  // namespace

SlurmRecord::SlurmRecord(const RunFolder& folder) : folder_(folder) {
  std::error_code error;
  if (!fs::exists(file(), error)) return;
  const nlohmann::json json = nlohmann::json::parse(read_text(file()), nullptr, false);
  try {
    if (json.at("format") != record_format) return;
    std::string run = json.at("run");
    std::vector<SlurmArrayRecord> arrays;
    for (const nlohmann::json& entry : json.at("arrays"))
      arrays.push_back({entry.at("name"), entry.at("job")});
    run_ = std::move(run);
    arrays_ = std::move(arrays);
  } catch (const nlohmann::json::exception&) {
    // Written in one rename, so only a stranger's hand breaks it. At worst a unit is graded twice.
  }
}

const SlurmArrayRecord& SlurmRecord::add(const std::vector<std::vector<Job>>& slices) {
  SlurmArrayRecord record{"contact-grade-" + drawn_seed().substr(0, 12), ""};
  const fs::path folder = this->slices(record.name);
  fs::create_directories(folder);
  for (std::size_t task = 0; task < slices.size(); ++task) {
    std::string orders;
    for (const Job& job : slices[task]) orders += order_of(job) + "\n";
    write_text(folder / name_of_task(static_cast<int>(task), ".tsv"), orders);
  }
  arrays_.push_back(std::move(record));
  save();
  return arrays_.back();
}

void SlurmRecord::submitted(const std::string& name, const std::string& job) {
  for (SlurmArrayRecord& array : arrays_) {
    if (array.name == name) array.job = job;
  }
  save();
}

void SlurmRecord::remove(const std::string& name, bool keep_logs) {
  std::erase_if(arrays_, [&](const SlurmArrayRecord& array) { return array.name == name; });
  std::error_code ignored;
  if (!keep_logs) fs::remove_all(slices(name), ignored);
  // Gone only if there is nothing else in it.
  fs::remove(slices(name).parent_path(), ignored);
  if (arrays_.empty())
    fs::remove(file(), ignored);
  else
    save();
}

void SlurmRecord::clear() {
  arrays_.clear();
  std::error_code ignored;
  fs::remove(file(), ignored);
  fs::remove_all(folder_.grade() / "slices", ignored);
}

std::vector<std::vector<Job>> SlurmRecord::jobs_of(const std::string& name) const {
  std::vector<std::vector<Job>> tasks;
  std::error_code error;
  for (int task = 0;; ++task) {
    const fs::path slice = slices(name) / name_of_task(task, ".tsv");
    if (!fs::exists(slice, error)) return tasks;
    tasks.emplace_back();
    const std::string orders = read_text(slice);
    for (std::size_t begin = 0; begin < orders.size();) {
      const std::size_t end = std::min(orders.find('\n', begin), orders.size());
      tasks.back().push_back(job_from_order(std::string_view(orders).substr(begin, end - begin)));
      begin = end + 1;
    }
  }
}

fs::path SlurmRecord::log(const std::string& name, int task) const {
  return slices(name) / name_of_task(task, ".log");
}

void SlurmRecord::save() const {
  nlohmann::json arrays = nlohmann::json::array();
  for (const SlurmArrayRecord& array : arrays_)
    arrays.push_back({{"name", array.name}, {"job", array.job}});
  const nlohmann::json json = {{"format", record_format}, {"run", run_}, {"arrays", arrays}};
  write_durably(file(), json.dump(1) + "\n");
}

}  // namespace contact::grading
