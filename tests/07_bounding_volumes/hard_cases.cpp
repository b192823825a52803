// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
#include <07_bounding_volumes/hard_common.hpp>

int main(int argc, char** argv) {
  hard_cases::Runner runner("07_bounding_volumes");
  hard_common::add_questions(runner);
  return runner.run(argc, argv);
}
