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

/// A folder that can stand for /usr/include: the files copied, the folders empty, to be shown
/// there.
void copy_headers(const SystemHeaders& headers, const std::filesystem::path& folder);

}  // namespace contact::grading
