#include "grade_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../../grading/book/book.hpp"
#include "../../grading/text/shown_text.hpp"

namespace contact::cli {

namespace {

std::string count_of(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string two_places(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

std::string time_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 90) return std::to_string(whole) + " s";
  if (whole < 5400) return std::to_string((whole + 59) / 60) + " min";
  return two_places(seconds / 3600.0) + " h";
}

std::string text_of(const nlohmann::json& json, const char* name) {
  return printable(json.at(name).get<std::string>());
}

// The id, and the name too if the id is made of one that cannot be read in it.
std::string shown_id(const nlohmann::json& submission) {
  const std::string id = text_of(submission, "id");
  const std::string name = submission.value("name", "");
  if (name.empty() || id.find('~') == std::string::npos) return id;
  return id + " (" + grading::escaped(name) + ")";
}

}  // namespace

GradeProgress::GradeProgress(std::size_t total, int workers)
    : total_(total), terminal_(Style(stderr).on() || ::isatty(STDERR_FILENO) == 1) {
  if (total_ == 0) return;
  note("Grading " + count_of(static_cast<int>(total_), "unit", "units") +
       (workers > 0 ? " with " + count_of(workers, "worker", "workers") : "") + " ...");
}

GradeProgress::~GradeProgress() { clear(); }

std::string GradeProgress::rest() const {
  const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
  if (done_ == 0 || done_ >= total_ || passed < 5.0) return "";
  return ", about " +
         time_text(passed / static_cast<double>(done_) * static_cast<double>(total_ - done_)) +
         " to go";
}

void GradeProgress::finished(const grading::Job& job) {
  ++done_;
  const std::string far = std::to_string(done_) + " of " + std::to_string(total_) + rest();
  if (terminal_) {
    draw(far + ": " + job.submission + ", " + job.exercise);
    return;
  }
  constexpr std::chrono::seconds between{10};
  if (done_ != total_ && Clock::now() - said_ < between) return;
  said_ = Clock::now();
  note(far);
}

void GradeProgress::say_beside(const std::string& text) {
  clear();
  note(text);
}

void GradeProgress::draw(const std::string& text) {
  constexpr std::size_t widest = 78;
  const std::string shown = text.substr(0, widest);
  const std::string line = "\r" + padded(shown, drawn_);
  drawn_ = display_width(shown);
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

void GradeProgress::clear() {
  if (drawn_ == 0) return;
  draw("");
  std::fputc('\r', stderr);
  drawn_ = 0;
}

std::string command_again(const std::filesystem::path& root) {
  std::string all = grading::read_text("/proc/self/cmdline");
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\0', begin), all.size());
    words.push_back(all.substr(begin, end - begin));
    begin = end + 1;
  }
  std::error_code error;
  const std::filesystem::path script = root / "contact";
  std::string text;
  if (std::filesystem::equivalent(words.front(), root / "build" / "dev" / "bin" / "contact",
                                  error) &&
      std::filesystem::exists(script, error)) {
    const bool here = std::filesystem::equivalent(root, ".", error);
    text = here ? "./contact" : quoted_for_shell(script.string());
    if (const char* pack = std::getenv("CONTACT_PACK")) text += " --pack " + quoted_for_shell(pack);
  } else {
    if (const char* given = std::getenv("CONTACT_ROOT"))
      text = "CONTACT_ROOT=" + quoted_for_shell(given) + " ";
    if (const char* pack = std::getenv("CONTACT_PACK"))
      text += "CONTACT_PACK=" + quoted_for_shell(pack) + " ";
    text += quoted_for_shell(words.front());
  }
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] == "--recalibrate" || words[i].starts_with("--seed=")) continue;
    if (words[i] == "--seed")
      ++i;
    else
      text += " " + quoted_for_shell(words[i]);
  }
  return text;
}

std::string refusals(const nlohmann::json& results) {
  std::string text;
  for (const nlohmann::json& submission : results.at("submissions")) {
    const std::string id = shown_id(submission);
    if (submission.contains("problem"))
      text += "  " + id + ": " + text_of(submission, "problem") + "\n";
    for (const nlohmann::json& unit : submission.at("exercises")) {
      if (unit.at("status") == "refused")
        text += "  " + id + ", " + text_of(unit, "id") + ": " + text_of(unit, "problem") + "\n";
    }
  }
  if (!text.empty()) text.pop_back();
  return text;
}

std::string grade_summary(const nlohmann::json& results, const grading::Summary& summary,
                          const Style& style) {
  std::string text =
      count_of(summary.graded, "submission", "submissions") + " graded" +
      (summary.refused > 0 ? ", " + style.bad(std::to_string(summary.refused) + " refused") : "") +
      (summary.refused_files > 0
           ? ", " + style.bad(count_of(summary.refused_files, "file", "files") + " refused")
           : "") +
      (summary.not_graded > 0 ? ", " + style.bad(count_of(summary.not_graded, "unit", "units") +
                                                 " could not be graded")
                              : "") +
      ".";
  if (summary.in_mean > 0)
    text += " Mean" +
            (summary.in_mean < summary.graded
                 ? " of the " + std::to_string(summary.in_mean) + " with a whole mark"
                 : std::string()) +
            ": " + two_places(summary.mean) + " of " + grading::points_text(summary.max_points) +
            " points.";
  std::string missing;
  for (const nlohmann::json& measure : results.at("machine").at("measures")) {
    if (!measure.at("enforced").get<bool>())
      missing += "\n  " + text_of(measure, "what") + " (" + text_of(measure, "how") + ")";
  }
  if (!missing.empty()) text += "\n" + style.warn("Not enforced on this machine:") + missing;
  return text;
}

std::string changes_table(const nlohmann::json& changes, const Style& style) {
  const nlohmann::json& all = changes.at("changes");
  if (all.empty()) return "No mark moved.";
  std::vector<std::array<std::string, 5>> rows{
      {"submission", "exercise", "before", "after", "because of"}};
  for (const nlohmann::json& change : all) {
    std::string why;
    for (const nlohmann::json& reason : change.at("why"))
      why += (why.empty() ? "" : ", ") + reason.get<std::string>();
    const auto points = [&](const char* when) {
      const nlohmann::json& mark = change.at(when);
      return mark.is_null() ? std::string("none") : grading::points_text(mark.get<double>());
    };
    rows.push_back({text_of(change, "submission"), text_of(change, "exercise"), points("before"),
                    points("after"), why});
  }
  std::array<std::size_t, 5> widths{};
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], display_width(row[i]));
  }
  std::string text = count_of(static_cast<int>(all.size()), "mark moved:", "marks moved:");
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line = "\n ";
    for (std::size_t i = 0; i < rows[r].size(); ++i)
      line += " " + (i + 1 < rows[r].size() ? padded(rows[r][i], widths[i] + 1) : rows[r][i]);
    text += r == 0 ? style.dim(line) : line;
  }
  return text;
}

}  // namespace contact::cli
