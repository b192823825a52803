// The program `contact`: the commands of a student for exercises. For any other command it replaces
// itself by the program that has it, in the same folder.

#include <exception>
#include <string_view>

#include "../elsewhere.hpp"
#include "../program.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

namespace {

void add_elsewhere(Command app, Action& /*action*/) {
  for (const Elsewhere& command : commands_elsewhere()) {
    const Command shown = app.add_subcommand(command.name, command.what);
    if (std::string_view(command.name) == grade_worker_command.name) shown.hide();
  }
}

}  // namespace

}  // namespace contact::cli

int main(int argc, char** argv) {
  using namespace contact::cli;
  try {
    go_elsewhere(argc, argv);
  } catch (const std::exception& error) {
    note(Style(stderr).bad("contact: ") + error.what());
    return exit_trouble;
  }
  return run_program(argc, argv,
                     {add_list, add_start, add_watch, add_check, add_hint, add_solution, add_reset,
                      add_ask, add_progress, add_export, add_import, add_elsewhere});
}
