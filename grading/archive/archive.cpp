#include "archive.hpp"

#include <algorithm>
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

constexpr std::size_t longest_path = 120;
constexpr int deepest_json = 32;

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

bool is_folder_of_work(const std::string& path) {
  static const std::regex folder(R"(work/(\d\d_[a-z][a-z0-9_]*/?)?|work)");
  return path.size() <= longest_path && std::regex_match(path, folder);
}

std::optional<ArchivedCopy> copy_from_path(std::string_view path) {
  if (path.size() > longest_path || !path.starts_with("work/") || !path.ends_with(".cpp"))
    return {};
  return copy_from_id(path.substr(5, path.size() - 9));
}

// Every file of the archive by its path, each of which is one that may be there.
std::map<std::string, std::string> read_files(const std::string& bytes) {
  ArchiveEntries entries(bytes);
  std::map<std::string, std::string> files;
  while (entries.next()) {
    const std::string& path = entries.path();
    if (entries.is_folder() && is_folder_of_work(path)) continue;
    if (!entries.as_written() ||
        (path != manifest_path && path != progress_path && !copy_from_path(path).has_value()))
      throw ArchiveError(shown_name(path) +
                         " has no place in it: only contact-submission.json, work/progress.json "
                         "and work/NN_slug/NAME.cpp have");
    entries.require_plain();
    if (files.count(path) != 0) throw ArchiveError(shown_name(path) + " is in it twice");
    std::string text = entries.read();
    if (const std::string problem = problem_of_text(text); !problem.empty())
      throw ArchiveError(shown_name(path) + " " + problem);
    files[path] = std::move(text);
  }
  return files;
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

std::optional<ArchivedCopy> copy_from_id(std::string_view id) {
  static const std::regex pattern(R"((\d\d_[a-z][a-z0-9_]*)/([a-z][a-z0-9_]*))");
  // "work/" before it and ".cpp" after it count too.
  if (id.size() > longest_path - 9) return {};
  std::match_results<std::string_view::const_iterator> match;
  if (!std::regex_match(id.begin(), id.end(), match, pattern)) return {};
  return ArchivedCopy{match[1].str(), match[2].str(), ""};
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
  if (size > max_in_all || files.size() > max_entries)
    throw ArchiveError("this is more than an archive may hold: " + mebibytes(max_in_all) + " and " +
                       std::to_string(max_entries) + " files");
  return zipped(files);
}

}  // namespace contact::grading
