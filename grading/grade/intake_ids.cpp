#include "intake_ids.hpp"

#include <algorithm>
#include <regex>
#include <set>

#include "../archive/archive_entries.hpp"
#include "decomposition.hpp"
#include "sha256.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

// One pass over the text; a field is quoted whole or not at all.
class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& file) : text_(text), file_(file) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  bool next(std::vector<std::string>& record) {
    while (at_ < text_.size() && end_of_line()) {
    }
    if (at_ >= text_.size()) return false;
    record.clear();
    do {
      record.push_back(text_[at_ < text_.size() ? at_ : 0] == '"' && at_ < text_.size() ? quoted()
                                                                                        : plain());
    } while (at_ < text_.size() && text_[at_] == ',' && ++at_ > 0);
    if (at_ < text_.size() && !end_of_line()) fail("there is text after a quoted field");
    return true;
  }

  [[nodiscard]] int line() const { return line_; }
  [[noreturn]] void fail(const std::string& why) const {
    throw BookError(file_ + ":" + std::to_string(line_) + ": " + why);
  }

 private:
  bool end_of_line() {
    if (text_.substr(at_).starts_with("\r\n"))
      at_ += 2;
    else if (text_[at_] == '\n')
      ++at_;
    else
      return false;
    ++line_;
    return true;
  }

  std::string plain() {
    const std::size_t start = at_;
    while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\n' &&
           !text_.substr(at_).starts_with("\r\n")) {
      if (text_[at_] == '"') fail("a quotation mark stands inside a field that is not quoted");
      if (text_[at_] == '\r') fail("a line ends with a carriage return alone");
      ++at_;
    }
    return std::string(text_.substr(start, at_ - start));
  }

  std::string quoted() {
    std::string field;
    const int start = line_;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        ++at_;
        if (at_ >= text_.size() || text_[at_] != '"') return field;
      }
      if (text_[at_] == '\n') ++line_;
      field += text_[at_];
    }
    line_ = start;
    fail("a quoted field has no end");
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

// What a table may call an entry, composed as it is there.
std::vector<std::string> names_of(const std::string& entry) {
  const std::string name = as_utf8(entry);
  return {name, without_suffix(name)};
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::string ascii_lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

std::vector<std::vector<std::string>> parse_csv(std::string_view text, const std::string& file) {
  std::vector<std::vector<std::string>> records;
  CsvReader reader(text, file);
  std::vector<std::string> record;
  while (reader.next(record)) {
    if (!records.empty() && record.size() != records.front().size())
      throw BookError(file + ", record " + std::to_string(records.size() + 1) + ": it has " +
                      std::to_string(record.size()) + " fields and the first line has " +
                      std::to_string(records.front().size()));
    records.push_back(record);
  }
  return records;
}

IdTable::IdTable(const fs::path& file) : file_(file) {
  const std::string text = read_text(file);
  const std::string name = file.string();
  if (text.size() > max_in_all) throw BookError(name + " is larger than " + mebibytes(max_in_all));
  if (!is_utf8(text)) throw BookError(name + " is not text in UTF-8: save it as \"CSV UTF-8\"");
  const std::vector<std::vector<std::string>> records = parse_csv(text, name);
  if (records.empty()) throw BookError(name + " is empty: its first line must be entry,id,name");
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t entry_column = none;
  std::size_t id_column = none;
  std::size_t name_column = none;
  for (std::size_t i = 0; i < records.front().size(); ++i) {
    const std::string column = ascii_lower(trimmed(records.front()[i]));
    std::size_t* place = column == "entry"  ? &entry_column
                         : column == "id"   ? &id_column
                         : column == "name" ? &name_column
                                            : nullptr;
    if (place == nullptr) continue;
    if (*place != none) throw BookError(name + ":1: the column " + column + " is there twice");
    *place = i;
  }
  if (entry_column == none || id_column == none)
    throw BookError(name + ":1: the first line must name the columns entry and id" +
                    (records.front().front().find(';') != std::string::npos
                         ? "; columns are separated by commas, not by semicolons"
                         : ""));
  for (std::size_t i = 1; i < records.size(); ++i) {
    const std::vector<std::string>& record = records[i];
    const std::string where = name + ", record " + std::to_string(i + 1) + ": ";
    const std::string entry = trimmed(record[entry_column]);
    Identity identity{trimmed(record[id_column]),
                      name_column == none ? "" : trimmed(record[name_column])};
    if (entry.empty()) throw BookError(where + "the entry is empty");
    if (identity.id.empty()) throw BookError(where + "the id of '" + entry + "' is empty");
    if (!entries_.emplace(entry, std::move(identity)).second)
      throw BookError(where + "the entry '" + entry + "' is there twice");
    by_form_.emplace(decomposed(entry), entry);
  }
}

const Identity* IdTable::find(const std::string& entry) const {
  const std::vector<std::string> names = names_of(entry);
  for (const std::string& name : names) {
    if (const auto found = entries_.find(name); found != entries_.end()) return &found->second;
  }
  for (const std::string& name : names) {
    if (const auto found = by_form_.find(decomposed(name)); found != by_form_.end())
      return &entries_.at(found->second);
  }
  return nullptr;
}

std::vector<std::string> IdTable::missing_in(const std::vector<std::string>& entries) const {
  std::set<std::string> there;
  for (const std::string& entry : entries) {
    for (const std::string& name : names_of(entry)) there.insert(decomposed(name));
  }
  std::vector<std::string> missing;
  for (const auto& line : entries_) {
    if (there.count(decomposed(line.first)) == 0) missing.push_back(line.first);
  }
  return missing;
}

std::string without_suffix(const std::string& entry) {
  for (const std::string_view suffix : {".zip", ".tar.gz", ".tgz", ".cpp"}) {
    if (entry.size() > suffix.size() && ascii_lower(entry).ends_with(suffix))
      return entry.substr(0, entry.size() - suffix.size());
  }
  return entry;
}

EntryName read_entry_name(const std::string& entry, bool is_folder,
                          const std::vector<std::string>& exercises) {
  // A name may hold any letters, so only what comes after it is matched.
  // The file's name is the student's own and may look like another's entry: the first match counts.
  static const std::regex moodle(R"(([^/]+?)_(\d{1,20})_assignsubmission_[a-z]+(?:_(.*))?)");
  static const std::regex canvas(R"(([^/_]+)_(?:LATE_)?(\d{3,20})_(\d{3,20})_(.+))");
  EntryName result;
  std::smatch match;
  constexpr std::size_t longest = 255;
  if (entry.size() <= longest && std::regex_match(entry, match, moodle)) {
    result = {{match[2].str(), match[1].str()}, match[3].str(), true};
    return result;
  }
  if (!is_folder && entry.size() <= longest && std::regex_match(entry, match, canvas)) {
    result = {{match[2].str(), match[1].str()}, match[4].str(), true};
    // What is handed in again gets a number: "work-1.zip".
    static const std::regex again(R"((.+?)-\d{1,4}(\.[a-z.]+))");
    const std::string file = result.file;
    if (std::regex_match(file, match, again)) result.file = match[1].str() + match[2].str();
    return result;
  }
  result.identity.id = without_suffix(entry);
  if (is_folder || !entry.ends_with(".cpp")) return result;
  const std::string& stem = result.identity.id;
  std::size_t longest_name = 0;
  for (const std::string& name : exercises) {
    if (!stem.ends_with(name) || name.size() <= longest_name) continue;
    const std::string before = stem.substr(0, stem.size() - name.size());
    if (!before.empty() && std::string_view("_- ").find(before.back()) == std::string_view::npos)
      continue;
    longest_name = name.size();
    result.file = name + ".cpp";
  }
  if (longest_name == 0) return result;
  const std::size_t end = stem.size() - longest_name;
  result.identity.id = end == 0 ? "" : stem.substr(0, end - 1);
  result.one_of_several = true;
  return result;
}

std::string safe_id(const std::string& id) {
  constexpr std::size_t longest = 100;
  std::string result;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const char c = id[i];
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    const bool inside = c == '.' || c == '-' || c == '@' || c == '+';
    if (plain || (inside && i > 0 && (c != '.' || i + 1 < id.size()))) {
      result += c;
      continue;
    }
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    result += '~';
    result += digits[byte >> 4];
    result += digits[byte & 0xf];
  }
  // A name may be longer than a file system takes.
  if (result.size() > longest)
    result = result.substr(0, longest - 18) + "~~" + sha256(id).substr(0, 16);
  return result;
}

}  // namespace contact::grading
