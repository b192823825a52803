#include "intake.hpp"

#include <algorithm>
#include <set>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

enum class Kind { folder, archive, file, other_file, link, special };

struct Entry {
  std::string name;
  Kind kind = Kind::special;
  EntryName said;
  Identity identity;
  std::string problem;
};

Kind kind_of(const fs::directory_entry& entry) {
  const fs::file_status status = entry.symlink_status();
  if (fs::is_symlink(status)) return Kind::link;
  if (fs::is_directory(status)) return Kind::folder;
  if (!fs::is_regular_file(status)) return Kind::special;
  const std::string name = ascii_lower(entry.path().filename().string());
  if (is_archive_name(name)) return Kind::archive;
  return name.ends_with(".cpp") ? Kind::file : Kind::other_file;
}

// A file that was handed in, but not in a form that is read here.
bool is_handed_in(const std::string& name) {
  static const std::set<std::string> endings{".7z",  ".rar", ".tar", ".gz",  ".bz2", ".xz",
                                             ".zst", ".c",   ".cc",  ".cxx", ".h",   ".hpp"};
  const std::string ending = ascii_lower(fs::path(name).extension().string());
  return endings.count(ending) != 0;
}

std::string shown_file(const fs::path& file) { return escaped(file.filename().string()); }

std::string listed(const std::vector<const Entry*>& entries) {
  std::string text;
  for (std::size_t i = 0; i < entries.size(); ++i)
    text += (i == 0 ? "" : i + 1 == entries.size() ? " and " : ", ") + shown_name(entries[i]->name);
  return text;
}

void identify(Entry& entry, const IdTable* ids, const Exercise* only) {
  const std::string name = shown_name(entry.name);
  entry.identity = entry.said.identity;
  if (ids != nullptr) {
    if (const Identity* found = ids->find(entry.name))
      entry.identity = *found;
    else if (entry.problem.empty())
      entry.problem = name + " is not in " + shown_file(ids->file()) + ": add a line for it";
  }
  if (entry.problem.empty() && entry.kind == Kind::file && entry.said.file.empty() &&
      only == nullptr)
    entry.problem =
        "the name " + name +
        " does not say for which exercise it is: call it STUDENT_EXERCISE.cpp, or grade "
        "one exercise only, with --exercises";
  if (entry.identity.id.empty()) {
    entry.identity.id = without_suffix(entry.name);
    if (entry.problem.empty())
      entry.problem = "the name " + name +
                      " does not say whose it is: call it STUDENT_EXERCISE.cpp, or give --ids";
  }
  if (!entry.problem.empty()) return;
  if (entry.kind == Kind::link)
    entry.problem = name + " is a link: put the folder or the file itself there";
  if (entry.kind == Kind::special) entry.problem = name + " is neither a folder nor a plain file";
  if (entry.kind == Kind::other_file)
    entry.problem = name + " is nothing that is read here: a folder, .zip, .tar.gz, .tgz or .cpp";
}

std::vector<Entry> entries_in(const Book& book, const fs::path& submissions, const IdTable* ids,
                              const Exercise* only, Intake& intake) {
  const std::vector<std::string> names = unique_names(book);
  std::vector<Entry> entries;
  std::error_code error;
  fs::directory_iterator folder(submissions, error);
  if (error)
    throw BookError("cannot read the folder of submissions, " + submissions.string() + ": " +
                    error.message());
  for (const fs::directory_entry& found : folder) {
    Entry entry;
    entry.name = found.path().filename().string();
    entry.kind = kind_of(found);
    const bool known = ids != nullptr && ids->find(entry.name) != nullptr;
    if (!known && is_junk(entry.name)) continue;
    if (entry.kind == Kind::other_file && !known && !is_handed_in(entry.name)) {
      intake.passed_over.push_back(as_utf8(entry.name));
      continue;
    }
    entry.said = read_entry_name(entry.name, entry.kind == Kind::folder, names);
    identify(entry, ids, only);
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
  std::sort(intake.passed_over.begin(), intake.passed_over.end());
  return entries;
}

// Whether all are files that one student handed in, each exported by itself.
bool of_one_student(const std::vector<const Entry*>& entries) {
  return std::all_of(entries.begin(), entries.end(), [&](const Entry* entry) {
    return entry->said.one_of_several && entry->identity.id == entries.front()->identity.id &&
           entry->said.identity.id == entries.front()->said.identity.id &&
           entry->said.identity.name == entries.front()->said.identity.name;
  });
}

Entrant entrant_of(const std::vector<const Entry*>& entries) {
  Entrant entrant;
  const Identity& identity = entries.front()->identity;
  entrant.id = safe_id(identity.id);
  entrant.name = as_utf8(!identity.name.empty()      ? identity.name
                         : entrant.id != identity.id ? identity.id
                                                     : "");
  for (const Entry* entry : entries) {
    entrant.entry += (entrant.entry.empty() ? "" : ", ") + as_utf8(entry->name);
    if (entrant.problem.empty()) entrant.problem = entry->problem;
  }
  return entrant;
}

void read_files(const Book& book, const fs::path& submissions,
                const std::vector<const Entry*>& entries, const Exercise* only, Entrant& entrant) {
  SubmissionFiles files(book);
  std::vector<std::string> ignored;
  for (const Entry* entry : entries) {
    const fs::path path = submissions / entry->name;
    try {
      if (entry->kind == Kind::folder) files.add_folder(path);
      if (entry->kind == Kind::archive) files.add_archive(path);
      if (entry->kind == Kind::file &&
          !files.add_file(path, entry->said.file.empty() ? entry->name : entry->said.file, only))
        ignored.push_back(as_utf8(entry->name));
    } catch (const ArchiveError& error) {
      entrant.problem = shown_name(entry->name) + " cannot be used: " + error.what();
      return;
    }
  }
  entrant.files = files.taken();
  entrant.ignored = files.ignored();
  entrant.ignored.insert(entrant.ignored.end(), ignored.begin(), ignored.end());
  const auto packed_again = std::find_if(
      entrant.ignored.begin(), entrant.ignored.end(),
      [](const std::string& path) { return is_archive_name(path) || is_handed_in(path); });
  if (entrant.files.empty() && packed_again != entrant.ignored.end() &&
      !fs::path(*packed_again).extension().string().starts_with(".h"))
    entrant.problem = escaped(entrant.entry) + " holds no answer, but " +
                      shown_name(*packed_again) + ", which is not opened: unpack it";
}

}  // namespace

Intake take_in(const Book& book, const fs::path& submissions, const IdTable* ids,
               const Exercise* only, const std::function<void(const Entrant&)>& keep) {
  Intake intake;
  const std::vector<Entry> entries = entries_in(book, submissions, ids, only, intake);
  std::map<std::string, std::vector<const Entry*>> students;
  for (const Entry& entry : entries)
    students[ascii_lower(safe_id(entry.identity.id))].push_back(&entry);

  for (const auto& [student, theirs] : students) {
    if (theirs.size() == 1 || of_one_student(theirs)) {
      Entrant entrant = entrant_of(theirs);
      entrant.opened = entrant.problem.empty();
      if (entrant.opened) read_files(book, submissions, theirs, only, entrant);
      keep(entrant);
      for (auto& [exercise, file] : entrant.files) file.text = std::string();
      intake.entrants.push_back(std::move(entrant));
      continue;
    }
    int number = 0;
    for (const Entry* entry : theirs) {
      Entrant entrant = entrant_of({entry});
      // No id that is made of a name has two of these.
      entrant.id += "~~" + std::to_string(++number);
      entrant.problem = listed(theirs) + " are of one student, " + shown_name(entry->identity.id) +
                        ": put away those that do not count, or give --ids";
      keep(entrant);
      intake.entrants.push_back(std::move(entrant));
    }
  }
  std::sort(intake.entrants.begin(), intake.entrants.end(),
            [](const Entrant& a, const Entrant& b) { return a.id < b.id; });
  if (ids != nullptr) {
    std::vector<std::string> names;
    for (const Entry& entry : entries) names.push_back(entry.name);
    intake.absent = ids->missing_in(names);
  }
  return intake;
}

std::string mistaken_for_submissions(const Intake& intake, const fs::path& submissions) {
  const std::vector<Entrant>& all = intake.entrants;
  if (all.empty() || (all.size() == 1 && all.front().opened)) return {};
  if (std::any_of(all.begin(), all.end(),
                  [](const Entrant& entrant) { return entrant.problem.empty(); }))
    return {};
  constexpr std::size_t most = 3;
  std::string text = "every submission was refused: ";
  for (std::size_t i = 0; i < all.size() && i < most; ++i)
    text += (i == 0 ? "" : "; ") + all[i].problem;
  if (all.size() > most) text += "; and " + std::to_string(all.size() - most) + " more";
  return text + ". Is " + submissions.string() +
         " a folder of submissions, with an entry for each student? Nothing is graded";
}

}  // namespace contact::grading
