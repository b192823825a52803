#pragma once

// The command line of contact-box and its parts. It is linked statically and starts in a
// millisecond; every sandbox starts with it.

#include <cstdint>
#include <string>
#include <vector>

#include <sys/types.h>

namespace contact::launcher {

/// What it exits with if the kernel does not start a submission: as box.hpp says.
inline constexpr int not_started = 127;

struct Staged {
  enum class Kind { read, write, temporary } kind = Kind::read;
  std::string host;
  /// Its name under the stage, which is /tmp.
  std::string name;
  std::uint64_t bytes = 0;
  std::uint64_t files = 0;
};

struct Opened {
  std::string path;
  bool write = false;
  bool run = false;
};

struct Settings {
  pid_t parent = 0;
  /// Where it says how the box ended.
  int report = -1;
  /// The same place, for bubblewrap to say how it goes; -1 without it.
  int status = -1;
  /// Descriptors that the box gets besides the standard three.
  std::vector<int> kept;
  std::vector<std::string> groups;
  /// The user to become; -1 stays who it is.
  long user = -1;
  /// The network namespace to enter; -1 leaves that to bubblewrap.
  int network = -1;
  /// Namespaces of its own, with what is staged; without them it confines itself.
  bool namespaces = false;
  std::vector<Staged> staged;
  /// The filter of system calls to load itself; -1 leaves that to bubblewrap.
  int filter = -1;
  /// The kernel keeps it from all files but these (Landlock).
  bool files_closed = false;
  std::vector<Opened> opened;
  /// The descriptor that the program is opened as, so that the filter may refuse every other.
  int program = -1;
  std::string folder;
  std::uint64_t cpu_seconds = 0;
  std::uint64_t memory = 0;
  std::uint64_t file_bytes = 0;
  std::uint64_t descriptors = 0;
  std::uint64_t processes = 0;
  std::vector<char*> command;
};

/// Ends the program: what could not be done, and why, in one line of the report.
[[noreturn]] void fail(const Settings& settings, const std::string& what);

/// A mount namespace whose /tmp holds what is staged.
void stage(const Settings& settings, uid_t user, gid_t group);
/// The files that the settings name, as rules for close_files().
int rules_of_files(const Settings& settings);
/// Leaves the process no other files.
void close_files(const Settings& settings, int rules);
/// Loads the filter, and another that lets it send signals only to itself.
void load_filter(const Settings& settings);

/// `contact-box --probe NAME`: inside a box, tries what should not work there. Returns the exit
/// code: 0 if it was kept from it.
int probe(const char* name, int count, char** values);

}  // namespace contact::launcher
