#include "archive_entries.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <archive.h>
#include <archive_entry.h>

namespace fs = std::filesystem;

namespace contact::grading {

std::string mebibytes(std::size_t bytes) { return std::to_string(bytes / mebibyte) + " MiB"; }

std::string problem_of_text(std::string_view text) {
  if (text.size() > max_in_file) return "is larger than " + mebibytes(max_in_file);
  if (!is_utf8(text)) return "is not text in UTF-8";
  return text.find('\0') == std::string_view::npos ? "" : "is not text: it has a zero byte";
}

bool is_archive_name(std::string_view name) {
  return name.ends_with(".zip") || name.ends_with(".tar.gz") || name.ends_with(".tgz");
}

std::string packed(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) throw ArchiveError("it is not a file");
  if (fs::file_size(file) > max_packed)
    throw ArchiveError("it is larger than " + mebibytes(max_packed));
  std::string bytes = read_text(file);
  if (bytes.empty()) throw ArchiveError("it is empty");
  return bytes;
}

struct ArchiveEntries::State {
  struct End {
    void operator()(archive* reader) const { archive_read_free(reader); }
  };
  std::unique_ptr<archive, End> reader{archive_read_new()};
  archive_entry* entry = nullptr;
  std::optional<ZipNames> names;
};

namespace {

ArchiveError too_many_entries() {
  return ArchiveError("it has more than " + std::to_string(max_entries) + " entries");
}

}  // namespace

// Only these two, so that no rare reader of libarchive's sees a stranger's bytes: a zip through the
// directory at its end, without which it is cut off, and one layer of gzip around a tar.
ArchiveEntries::ArchiveEntries(const std::string& bytes) : state_(std::make_unique<State>()) {
  archive* reader = state_->reader.get();
  if (reader == nullptr) throw std::bad_alloc();
  if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06")) {
    archive_read_support_format_zip_seekable(reader);
    if (state_->names.emplace(bytes).size() > max_entries) throw too_many_entries();
  } else if (bytes.starts_with("\x1f\x8b")) {
    archive_read_append_filter(reader, ARCHIVE_FILTER_GZIP);
    archive_read_support_format_tar(reader);
  } else {
    throw ArchiveError("it is no zip file");
  }
  if (archive_read_open_memory(reader, bytes.data(), bytes.size()) != ARCHIVE_OK)
    throw ArchiveError("it is broken, or a part of it is missing");
}

ArchiveEntries::~ArchiveEntries() = default;

bool ArchiveEntries::next() {
  const int status = archive_read_next_header(state_->reader.get(), &state_->entry);
  if (status == ARCHIVE_EOF) return false;
  if (status != ARCHIVE_OK && status != ARCHIVE_WARN)
    throw ArchiveError("it is broken or cut off after " + last_);
  if (++entries_ > max_entries) throw too_many_entries();
  const char* raw = archive_entry_pathname(state_->entry);
  ZipName name;
  if (state_->names) {
    // libarchive has read the entry's header and stands at its data.
    const la_int64_t position = archive_filter_bytes(state_->reader.get(), 0);
    name = state_->names->before(static_cast<std::size_t>(std::max<la_int64_t>(position, 0)));
  } else {
    name.as_written = true;
  }
  as_written_ = name.as_written;
  readings_ = std::move(name.readings);
  if (raw != nullptr && std::find(readings_.begin(), readings_.end(), raw) == readings_.end())
    readings_.emplace_back(raw);
  if (readings_.empty()) throw ArchiveError("the entry after " + last_ + " has no name");
  last_ = shown_name(path());
  return true;
}

bool ArchiveEntries::is_folder() const {
  // libarchive does not see the slash at the end of a name that it cannot convert.
  return archive_entry_filetype(state_->entry) == AE_IFDIR ||
         (state_->names && path().ends_with('/'));
}

void ArchiveEntries::require_plain() const {
  if (archive_entry_is_encrypted(state_->entry) != 0)
    throw ArchiveError(shown_name(path()) + " is encrypted");
  if (archive_entry_hardlink(state_->entry) != nullptr ||
      archive_entry_symlink(state_->entry) != nullptr ||
      archive_entry_filetype(state_->entry) != AE_IFREG)
    throw ArchiveError(shown_name(path()) + " is a link or a device, not a plain file");
  archive* reader = state_->reader.get();
  if ((archive_format(reader) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_ZIP) {
    const std::string method = archive_format_name(reader);
    if (method.find("(uncompressed)") == std::string::npos &&
        method.find("(deflation)") == std::string::npos)
      throw ArchiveError(shown_name(path()) +
                         " is compressed in a way that is not read here: " + method);
  }
}

void ArchiveEntries::require_room(std::size_t size, bool in_file) const {
  if (in_file && size > max_in_file)
    throw ArchiveError(shown_name(path()) + " is larger than " + mebibytes(max_in_file));
  if (size > left_)
    throw ArchiveError("it unpacks to more than " + mebibytes(max_in_all) + ", at " +
                       shown_name(path()));
}

std::size_t ArchiveEntries::size() const {
  if (archive_entry_size_is_set(state_->entry) == 0) return 0;
  return static_cast<std::size_t>(std::max<la_int64_t>(archive_entry_size(state_->entry), 0));
}

void ArchiveEntries::pass() {
  // Before the bytes themselves are passed over: in a tar they are unpacked to be skipped.
  require_room(size(), false);
  left_ -= size();
}

std::string ArchiveEntries::read() {
  require_room(size(), true);
  std::string text;
  std::array<char, 65536> part{};
  while (true) {
    const la_ssize_t count = archive_read_data(state_->reader.get(), part.data(), part.size());
    if (count < 0) throw ArchiveError("it is broken or cut off at " + last_);
    if (count == 0) break;
    text.append(part.data(), static_cast<std::size_t>(count));
    require_room(text.size(), true);
  }
  left_ -= text.size();
  return text;
}

}  // namespace contact::grading
