#include "archive.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <regex>

#include <archive.h>
#include <archive_entry.h>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr const char* format_name = "contact-submission/1";
constexpr const char* manifest_path = "contact-submission.json";
constexpr const char* progress_path = "work/progress.json";

constexpr std::size_t mebibyte = std::size_t{1} << 20;
constexpr std::size_t most_in_file = 1 * mebibyte;
constexpr std::size_t most_in_all = 20 * mebibyte;
constexpr std::size_t most_packed = 24 * mebibyte;
constexpr std::size_t most_entries = 1000;
constexpr std::size_t longest_path = 120;
constexpr int deepest_json = 32;

// A name out of an archive, fit to be shown: short, on one line, without a terminal's commands.
std::string shown_name(std::string_view name) {
  std::string text = "'";
  for (const char c : name.substr(0, 80)) {
    if (c >= ' ' && c <= '~') {
      text += c;
      continue;
    }
    std::array<char, 8> escaped{};
    std::snprintf(escaped.data(), escaped.size(), "\\x%02x", static_cast<unsigned char>(c));
    text += escaped.data();
  }
  return text + (name.size() > 80 ? "...'" : "'");
}

std::string mebibytes(std::size_t bytes) { return std::to_string(bytes / mebibyte) + " MiB"; }

// Strict, as the page's decoder is: no overlong form, no half of a surrogate pair.
bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = [&](std::size_t i) {
      return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
    };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80                     ? 1
                               : first >= 0xC2 && first <= 0xDF ? 2
                               : first >= 0xE0 && first <= 0xEF ? 3
                               : first >= 0xF0 && first <= 0xF4 ? 4
                                                                : 0;
    if (length == 0) return false;
    for (std::size_t i = 1; i < length; ++i) {
      if ((byte(i) & 0xC0) != 0x80) return false;
    }
    if ((first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
        (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F))
      return false;
    at += length;
  }
  return true;
}

nlohmann::json parsed(const std::string& path, const std::string& text) {
  const auto not_too_deep = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    if (depth > deepest_json)
      throw ArchiveError(path + " is nested more than " + std::to_string(deepest_json) + " deep");
    return true;
  };
  try {
    return nlohmann::json::parse(text, not_too_deep);
  } catch (const nlohmann::json::exception&) {
    throw ArchiveError(path + " is not JSON");
  }
}

std::string text_member(const nlohmann::json& data, const char* name) {
  const auto found = data.find(name);
  return found != data.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void read_manifest(const std::string& text, Submission& submission) {
  const nlohmann::json data = parsed(manifest_path, text);
  const std::string format = data.is_object() ? text_member(data, "format") : "";
  if (format != format_name)
    throw ArchiveError(
        format.starts_with("contact-submission/")
            ? shown_name(format) + " is another format than this version of the book reads (" +
                  format_name + ")"
            : std::string(manifest_path) + " does not say that its format is " + format_name);
  static const std::regex time(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,9})?Z)");
  if (const std::string exported = text_member(data, "exported"); std::regex_match(exported, time))
    submission.exported = exported;
  if (const std::string from = text_member(data, "from"); from == "page" || from == "contact")
    submission.from = from;
}

ProgressRecord read_progress(const std::string& text) {
  try {
    return ProgressRecord(parsed(progress_path, text));
  } catch (const ArchiveError&) {
    throw;
  } catch (const std::exception& error) {
    // Its words may name a part of the file, so they are shown as a name is.
    throw ArchiveError(std::string(progress_path) +
                       " is no record of progress: " + shown_name(error.what()));
  }
}

// --- Reading
// --------------------------------------------------------------------------------------

struct ReaderEnd {
  void operator()(archive* reader) const { archive_read_free(reader); }
};
using Reader = std::unique_ptr<archive, ReaderEnd>;

// Only these two, so that no rare reader of libarchive's sees a stranger's bytes: a zip through the
// directory at its end, without which it is cut off, and one layer of gzip around a tar.
Reader open(const std::string& bytes) {
  Reader reader(archive_read_new());
  if (!reader) throw std::bad_alloc();
  if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06")) {
    archive_read_support_format_zip_seekable(reader.get());
  } else if (bytes.starts_with("\x1f\x8b")) {
    archive_read_append_filter(reader.get(), ARCHIVE_FILTER_GZIP);
    archive_read_support_format_tar(reader.get());
  } else {
    throw ArchiveError("it is no zip file");
  }
  if (archive_read_open_memory(reader.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    throw ArchiveError("it is broken, or a part of it is missing");
  return reader;
}

std::string path_of(archive_entry* entry) {
  const char* path = archive_entry_pathname_utf8(entry);
  if (path == nullptr) path = archive_entry_pathname(entry);
  if (path == nullptr)
    throw ArchiveError("an entry whose name is not in plain letters has no place in it");
  return path;
}

bool is_folder_of_work(const std::string& path) {
  static const std::regex folder(R"(work/(\d\d_[a-z][a-z0-9_]*/?)?|work)");
  return path.size() <= longest_path && std::regex_match(path, folder);
}

std::optional<ArchivedCopy> copy_from_path(std::string_view path) {
  if (path.size() > longest_path || !path.starts_with("work/") || !path.ends_with(".cpp"))
    return {};
  return copy_from_id(path.substr(5, path.size() - 9));
}

void require_plain(archive* reader, archive_entry* entry, const std::string& path) {
  if (archive_entry_is_encrypted(entry) != 0)
    throw ArchiveError(shown_name(path) + " is encrypted");
  if (archive_entry_hardlink(entry) != nullptr || archive_entry_symlink(entry) != nullptr ||
      archive_entry_filetype(entry) != AE_IFREG)
    throw ArchiveError(shown_name(path) + " is a link or a device, not a plain file");
  // Other methods may ask for gigabytes to unpack a few bytes.
  if ((archive_format(reader) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_ZIP) {
    const std::string method = archive_format_name(reader);
    if (method.find("(uncompressed)") == std::string::npos &&
        method.find("(deflation)") == std::string::npos)
      throw ArchiveError(shown_name(path) +
                         " is compressed in a way that is not read here: " + method);
  }
}

std::string read_entry(archive* reader, archive_entry* entry, const std::string& path,
                       std::size_t& left) {
  const auto require_room = [&](std::size_t size) {
    if (size > most_in_file)
      throw ArchiveError(shown_name(path) + " is larger than " + mebibytes(most_in_file));
    if (size > left)
      throw ArchiveError("it unpacks to more than " + mebibytes(most_in_all) + ", at " +
                         shown_name(path));
  };
  if (archive_entry_size_is_set(entry) != 0 && archive_entry_size(entry) > 0)
    require_room(static_cast<std::size_t>(archive_entry_size(entry)));
  std::string text;
  std::array<char, 65536> part{};
  while (true) {
    const la_ssize_t count = archive_read_data(reader, part.data(), part.size());
    if (count < 0) throw ArchiveError("it is broken or cut off at " + shown_name(path));
    if (count == 0) break;
    text.append(part.data(), static_cast<std::size_t>(count));
    require_room(text.size());
  }
  left -= text.size();
  if (const std::string problem = problem_of_text(text); !problem.empty())
    throw ArchiveError(shown_name(path) + " " + problem);
  return text;
}

// Every file of the archive by its path, each of which is one that may be there.
std::map<std::string, std::string> read_files(const std::string& bytes) {
  const Reader reader = open(bytes);
  std::map<std::string, std::string> files;
  std::size_t left = most_in_all;
  std::size_t entries = 0;
  std::string last = "its beginning";
  while (true) {
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(reader.get(), &entry);
    if (status == ARCHIVE_EOF) break;
    if (status != ARCHIVE_OK && status != ARCHIVE_WARN)
      throw ArchiveError("it is broken or cut off after " + last);
    if (++entries > most_entries)
      throw ArchiveError("it has more than " + std::to_string(most_entries) + " entries");
    const std::string path = path_of(entry);
    last = shown_name(path);
    if (archive_entry_filetype(entry) == AE_IFDIR && is_folder_of_work(path)) continue;
    // libarchive makes slashes of the backslashes in a name that has no slash; the page does not.
    const bool as_written = bytes.find(path) != std::string::npos || !bytes.starts_with("PK");
    if (!as_written ||
        (path != manifest_path && path != progress_path && !copy_from_path(path).has_value()))
      throw ArchiveError(shown_name(path) +
                         " has no place in it: only contact-submission.json, work/progress.json "
                         "and work/NN_slug/NAME.cpp have");
    require_plain(reader.get(), entry, path);
    if (files.count(path) != 0) throw ArchiveError(shown_name(path) + " is in it twice");
    files[path] = read_entry(reader.get(), entry, path, left);
  }
  return files;
}

std::string packed(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) throw ArchiveError("it is not a file");
  if (fs::file_size(file) > most_packed)
    throw ArchiveError("it is larger than " + mebibytes(most_packed));
  std::string bytes = read_text(file);
  if (bytes.empty()) throw ArchiveError("it is empty");
  return bytes;
}

Submission read(const std::string& bytes) {
  Submission submission;
  std::map<std::string, std::string> files = read_files(bytes);
  const auto manifest = files.find(manifest_path);
  if (manifest == files.end())
    throw ArchiveError(std::string("it has no ") + manifest_path +
                       ", so neither the page nor `contact export` made it");
  read_manifest(manifest->second, submission);
  for (auto& [path, text] : files) {
    if (path == progress_path) submission.progress = read_progress(text);
    if (std::optional<ArchivedCopy> copy = copy_from_path(path)) {
      copy->text = std::move(text);
      submission.copies.push_back(std::move(*copy));
    }
  }
  return submission;
}

// --- Writing
// --------------------------------------------------------------------------------------

struct WriterEnd {
  void operator()(archive* writer) const { archive_write_free(writer); }
};
struct EntryEnd {
  void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};

la_ssize_t append(archive*, void* target, const void* bytes, std::size_t size) {
  static_cast<std::string*>(target)->append(static_cast<const char*>(bytes), size);
  return static_cast<la_ssize_t>(size);
}

void require(archive* writer, bool well) {
  if (!well) {
    const char* why = archive_error_string(writer);
    throw ArchiveError(std::string("the archive cannot be written: ") + (why ? why : "no reason"));
  }
}

std::string zipped(const std::map<std::string, std::string>& files) {
  std::string bytes;
  const std::unique_ptr<archive, WriterEnd> owner(archive_write_new());
  archive* writer = owner.get();
  require(writer, archive_write_set_format_zip(writer) == ARCHIVE_OK &&
                      archive_write_zip_set_compression_deflate(writer) == ARCHIVE_OK &&
                      archive_write_set_bytes_in_last_block(writer, 1) == ARCHIVE_OK &&
                      archive_write_open(writer, &bytes, nullptr, append, nullptr) == ARCHIVE_OK);
  for (const auto& [path, text] : files) {
    const std::unique_ptr<archive_entry, EntryEnd> entry(archive_entry_new());
    archive_entry_set_pathname(entry.get(), path.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(text.size()));
    // Without a date of its own an entry gets the first that a zip file knows, 1980-01-01.
    require(writer, archive_write_header(writer, entry.get()) == ARCHIVE_OK &&
                        archive_write_data(writer, text.data(), text.size()) ==
                            static_cast<la_ssize_t>(text.size()));
  }
  require(writer, archive_write_close(writer) == ARCHIVE_OK);
  return bytes;
}

}  // namespace

bool is_archive_name(std::string_view name) {
  return name.ends_with(".zip") || name.ends_with(".tar.gz") || name.ends_with(".tgz");
}

std::optional<ArchivedCopy> copy_from_id(std::string_view id) {
  static const std::regex pattern(R"((\d\d_[a-z][a-z0-9_]*)/([a-z][a-z0-9_]*))");
  // "work/" before it and ".cpp" after it count too.
  if (id.size() > longest_path - 9) return {};
  std::match_results<std::string_view::const_iterator> match;
  if (!std::regex_match(id.begin(), id.end(), match, pattern)) return {};
  return ArchivedCopy{match[1].str(), match[2].str(), ""};
}

std::string problem_of_text(std::string_view text) {
  if (text.size() > most_in_file) return "is larger than " + mebibytes(most_in_file);
  if (!is_utf8(text)) return "is not text in UTF-8";
  return text.find('\0') == std::string_view::npos ? "" : "is not text: it has a zero byte";
}

Submission read_submission(const fs::path& file) {
  try {
    return read(packed(file));
  } catch (const ArchiveError& error) {
    throw ArchiveError(file.string() + " cannot be used: " + error.what());
  }
}

std::string submission_bytes(const Submission& submission) {
  std::map<std::string, std::string> files;
  const nlohmann::json manifest = {
      {"format", format_name}, {"exported", submission.exported}, {"from", submission.from}};
  files[manifest_path] = manifest.dump(2) + "\n";
  if (submission.progress) files[progress_path] = submission.progress->document().dump(2) + "\n";
  for (const ArchivedCopy& copy : submission.copies) files[copy.path()] = copy.text;
  std::size_t size = 0;
  for (const auto& [path, text] : files) {
    if (const std::string problem = problem_of_text(text); !problem.empty())
      throw ArchiveError(path + " " + problem + ", so it cannot be exported");
    size += text.size();
  }
  if (size > most_in_all || files.size() > most_entries)
    throw ArchiveError("this is more than an archive may hold: " + mebibytes(most_in_all) +
                       " and " + std::to_string(most_entries) + " files");
  return zipped(files);
}

}  // namespace contact::grading
