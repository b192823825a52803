#include "elsewhere.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <unistd.h>
#include <uv.h>

namespace contact::cli {

const std::vector<Elsewhere>& commands_elsewhere() {
  static const std::vector<Elsewhere> commands{
#ifdef CONTACT_GRADE
      grade_command,  grade_worker_command,
#endif
      ladder_command, scene_command,        plan_command,   simulate_command,
      new_command,    where_command,        doctor_command, dev_command};
  return commands;
}

namespace {

std::filesystem::path folder_of_programs() {
  std::string path(4096, '\0');
  std::size_t size = path.size();
  if (const int error = ::uv_exepath(path.data(), &size); error != 0)
    throw std::runtime_error(std::string("the program's own folder is not known: ") +
                             ::uv_strerror(error));
  path.resize(size);
  return std::filesystem::path(path).parent_path();
}

}  // namespace

void go_elsewhere(int argc, char** argv) {
  if (argc < 2) return;
  for (const Elsewhere& command : commands_elsewhere()) {
    if (std::strcmp(argv[1], command.name) != 0) continue;
    const std::filesystem::path program = folder_of_programs() / command.program;
    ::execv(program.c_str(), argv);
    throw std::runtime_error(program.string() + " cannot be started (" + std::strerror(errno) +
                             "): cmake --build build/dev --target " + command.program);
  }
}

}  // namespace contact::cli
