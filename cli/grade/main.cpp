// The program `contact-grade`: a class is graded, and each of its workers.

#include "../program.hpp"

int main(int argc, char** argv) {
  using namespace contact::cli;
  return run_program(argc, argv, {add_grade, add_grade_worker});
}
