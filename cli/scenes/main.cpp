// The program `contact-scenes`: the commands of scenes.

#include "../program.hpp"

int main(int argc, char** argv) {
  using namespace contact::cli;
  return run_program(argc, argv, {add_scene, add_plan, add_simulate});
}
