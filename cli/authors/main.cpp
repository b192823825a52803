// The program `contact-authors`: the commands for authors and maintainers of the book.

#include "../program.hpp"

int main(int argc, char** argv) {
  using namespace contact::cli;
  return run_program(argc, argv, {add_ladder, add_new, add_where, add_doctor, add_dev});
}
