// What pack.toml says, and whether this version of the book is one that the pack needs.

#include "pack.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <regex>

#include <toml++/toml.h>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

/// One file with keys, each of which must be there and of its type.
class Keys {
 public:
  Keys(fs::path file, const toml::table& table, std::vector<PackFault>& faults)
      : file_(std::move(file)), table_(table), faults_(faults) {}

  std::string text(std::string_view key) {
    const toml::node* node = needed(key);
    if (node == nullptr) return {};
    std::string value = node->value_or(std::string());
    if (!node->is_string() || value.empty())
      fault(*node, std::string(key) + " must be a text that is not empty");
    return value;
  }

  std::vector<std::string> texts(std::string_view key) {
    const toml::node* node = needed(key);
    if (node == nullptr) return {};
    std::vector<std::string> values;
    const toml::array* list = node->as_array();
    if (list != nullptr) {
      for (const toml::node& one : *list) values.push_back(one.value_or(std::string()));
    }
    if (values.empty() || std::find(values.begin(), values.end(), "") != values.end())
      fault(*node, std::string(key) + " must be a list of texts, such as [\"A. Name\"]");
    return values;
  }

  void no_others() {
    for (const auto& [key, node] : table_) {
      if (std::find(asked_.begin(), asked_.end(), key.str()) == asked_.end())
        fault(node, "unknown key '" + std::string(key.str()) +
                        "'; there are name, title, book and authors");
    }
  }

  void fault(const toml::node& node, std::string what) {
    faults_.push_back({file_, line_of(node), std::move(what)});
  }

  [[nodiscard]] const toml::node* node(std::string_view key) const { return table_.get(key); }

 private:
  const toml::node* needed(std::string_view key) {
    asked_.emplace_back(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr)
      faults_.push_back({file_, 1, "the key '" + std::string(key) + "' is missing"});
    return node;
  }

  fs::path file_;
  const toml::table& table_;
  std::vector<PackFault>& faults_;
  std::vector<std::string> asked_;
};

void check_name(Keys& keys, const std::string& name) {
  static const std::regex pattern("[a-z][a-z0-9-]*");
  if (!name.empty() && !std::regex_match(name, pattern))
    keys.fault(
        *keys.node("name"),
        "name is a word of lower-case letters, digits and hyphens, such as my-course; not '" +
            name + "'");
}

void check_version(Keys& keys, const std::string& wanted, std::string_view version) {
  if (wanted.empty()) return;
  const std::optional<VersionRange> range = VersionRange::from(wanted);
  if (!range) {
    keys.fault(*keys.node("book"),
               "book is a range of versions such as \">=0.9,<0.10\", or the lowest version; not '" +
                   wanted + "'");
    return;
  }
  const std::optional<Version> here = version_from(version);
  if (!here) throw BookError("the book's own version is no version: " + std::string(version));
  if (!range->holds(*here))
    keys.fault(*keys.node("book"),
               "this pack needs version " + wanted + " of the book, and this book is version " +
                   std::string(version) +
                   ". Use it with such a book, or change 'book' and run `dev check`");
}

}  // namespace

std::optional<Version> version_from(std::string_view text) {
  Version version{};
  for (std::size_t part = 0; part < version.size(); ++part) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, version.at(part));
    if (error != std::errc() || version.at(part) < 0) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
    if (text.empty()) return version;
    if (text.front() != '.') return std::nullopt;
    text.remove_prefix(1);
  }
  return std::nullopt;
}

std::optional<VersionRange> VersionRange::from(std::string_view text) {
  VersionRange range;
  while (true) {
    const std::size_t comma = text.find(',');
    std::string_view part = trimmed(text.substr(0, comma));
    Bound bound{">=", {}};
    for (const std::string_view sign : {">=", "<=", "==", ">", "<"}) {
      if (!part.starts_with(sign)) continue;
      bound.sign = sign;
      part = trimmed(part.substr(sign.size()));
      break;
    }
    const std::optional<Version> version = version_from(part);
    if (!version) return std::nullopt;
    bound.version = *version;
    range.bounds_.push_back(std::move(bound));
    if (comma == std::string_view::npos) return range;
    text.remove_prefix(comma + 1);
  }
}

bool VersionRange::holds(const Version& version) const {
  return std::all_of(bounds_.begin(), bounds_.end(), [&](const Bound& bound) {
    if (bound.sign == ">=") return version >= bound.version;
    if (bound.sign == "<=") return version <= bound.version;
    if (bound.sign == ">") return version > bound.version;
    if (bound.sign == "<") return version < bound.version;
    return version == bound.version;
  });
}

std::string range_from(std::string_view version) {
  const std::optional<Version> from = version_from(version);
  if (!from) throw BookError("the book's own version is no version: " + std::string(version));
  const std::string below =
      (*from)[0] > 0 ? std::to_string((*from)[0] + 1) : "0." + std::to_string((*from)[1] + 1);
  return ">=" + std::string(version) + ",<" + below;
}

Pack read_pack(const fs::path& folder, std::string_view version, std::vector<PackFault>& faults) {
  const fs::path file = folder / "pack.toml";
  if (!fs::is_directory(folder))
    throw BookError("there is no folder " + folder.string() +
                    "; `./contact new pack FOLDER` makes a pack");
  if (!fs::exists(file)) {
    faults.push_back({file, 1,
                      "this file is missing, so the folder is no pack; `./contact new pack FOLDER` "
                      "makes one"});
    return {};
  }
  try {
    const std::string text = read_text(file);
    const toml::table table = toml::parse(std::string_view(text), file.string());
    Keys keys(file, table, faults);
    Pack pack{keys.text("name"), keys.text("title"), keys.text("book"), keys.texts("authors")};
    keys.no_others();
    check_name(keys, pack.name);
    check_version(keys, pack.book, version);
    return pack;
  } catch (const toml::parse_error& error) {
    faults.push_back(
        {file, static_cast<int>(error.source().begin.line), std::string(error.description())});
    return {};
  }
}

std::unique_ptr<Book> open_pack(const fs::path& folder, std::shared_ptr<const Book> book,
                                std::string_view version) {
  std::vector<PackFault> faults;
  (void)read_pack(folder, version, faults);
  std::unique_ptr<Book> pack;
  // With another version of the book, what is said of the other files may be wrong.
  if (faults.empty()) {
    pack = std::make_unique<Book>(folder, find_work(folder), std::move(book));
    faults = faults_of_files(*pack);
  }
  if (faults.empty()) return pack;
  std::string text = "this pack cannot be used:";
  for (const PackFault& fault : faults)
    text += "\n  " + fault.file.string() + ":" + std::to_string(fault.line) + ": " + fault.what;
  throw BookError(text);
}

fs::path find_pack() {
  const char* given = std::getenv("CONTACT_PACK");
  if (given == nullptr || *given == '\0') return {};
  fs::path folder = fs::absolute(given).lexically_normal();
  // Without the slash that a shell's completion leaves.
  return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace contact::grading
