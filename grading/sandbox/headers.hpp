#pragma once

// The headers of the system that a submission may include: the standard libraries and Eigen, and
// none of what else happens to be installed.

#include <filesystem>
#include <vector>

namespace contact::grading {

struct SystemHeaders {
  /// Single files, right under /usr/include or the folder of an architecture in it.
  std::vector<std::filesystem::path> files;
  /// Folders that are there whole.
  std::vector<std::filesystem::path> folders;
};

SystemHeaders system_headers();

/// Where g++ searches for headers of the system, whole, and what links in there lead to: for a box
/// that can hide no file. A header that is seen and cannot be read would not compile even where it
/// is only used if it is there, as the standard library does with others.
std::vector<std::filesystem::path> searched_folders();

/// A folder that can stand for /usr/include: the files copied, the folders empty, to be shown
/// there.
void copy_headers(const SystemHeaders& headers, const std::filesystem::path& folder);

}  // namespace contact::grading
