#include "program.hpp"

#include <csignal>
#include <exception>

#include "../grading/book/pack.hpp"
#include "terminal/terminal.hpp"

namespace contact::cli {

const grading::Book& Context::book() {
  if (!book_) reread_book();
  return *book_;
}

void Context::reread_book() {
  const std::filesystem::path root = grading::find_root();
  book_ = std::make_unique<grading::Book>(root, grading::find_work(root));
  if (const std::filesystem::path pack = grading::find_pack(); !pack.empty())
    book_ = grading::open_pack(pack, std::move(book_), program_version());
}

grading::Loop& Context::loop() {
  if (!loop_) loop_ = std::make_unique<grading::Loop>();
  return *loop_;
}

namespace {

constexpr const char* footer =
    "Handled by the script ./contact before this program is called:\n"
    "  serve                       Build the book, serve it and print its address\n"
    "  test                        Run every test there is\n"
    "  setup                       Install what is missing\n"
    "\n"
    "Exit codes:\n"
    "  0    success: every test passed\n"
    "  1    a test failed, was not attempted, or the file does not compile\n"
    "  2    the command line was not understood\n"
    "  3    the set-up, the book's own files or an archive must be corrected first\n"
    "  130  Ctrl-C\n"
    "\n"
    "CONTACT_PACK is the folder of a pack, as ./contact --pack DIR sets it; CONTACT_WORK is the\n"
    "folder of your copies (work/ if unset); CONTACT_MEMORY_MB limits your program's memory\n"
    "(1024 if unset); NO_COLOR turns colour off.";

}  // namespace

std::string program_as_typed() {
  const std::filesystem::path pack = grading::find_pack();
  return pack.empty() ? "./contact" : "./contact --pack " + quoted_for_shell(pack.string());
}

const char* program_version() { return CONTACT_VERSION; }

int run_program(int argc, char** argv, const std::vector<void (*)(Command, Action&)>& commands) {
  // A reader that closes the pipe (`contact list | head`) is an error of a write, not the end of
  // the program.
  std::signal(SIGPIPE, SIG_IGN);
  const CommandLine line(
      "Contact Hours: exercises in collision detection and response, checked as you save.",
      "contact", program_version(), footer);
  Action action;
  for (const auto& add : commands) add(line.top(), action);
  int exit_code = exit_passed;
  if (!line.parse(argc, argv, exit_code)) return exit_code;
  Context context;
  const Style style(stderr);
  try {
    return action(context);
  } catch (const grading::Interrupted&) {
    return exit_interrupted;
  } catch (const grading::UnknownName& error) {
    note(style.bad("contact: ") + error.what());
    return exit_usage;
  } catch (const std::exception& error) {
    note(style.bad("contact: ") + error.what());
    return exit_trouble;
  }
}

}  // namespace contact::cli
