// A chapter's tests and its hard cases in one program: `--hard-cases`, as the first argument, asks
// the hard cases, and Catch2 gets every other call.
#include <catch2/catch_session.hpp>
#include <string_view>

#include "support/hard_cases.hpp"

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--hard-cases")
    return hard_cases::program(argc - 1, argv + 1);
  return Catch::Session().run(argc, argv);
}
