// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
#include <07_bounding_volumes/hard_boxes.hpp>
#include <07_bounding_volumes/hard_common.hpp>
#include <07_bounding_volumes/hard_moving.hpp>
#include <07_bounding_volumes/hard_oriented.hpp>
#include <07_bounding_volumes/hard_rectangles.hpp>
#include <07_bounding_volumes/hard_slabs.hpp>
#include <07_bounding_volumes/hard_spheres.hpp>

int main(int argc, char** argv) {
  hard_cases::Runner runner("07_bounding_volumes");
  hard_common::add_questions(runner);
  hard_moving::add_questions(runner);
  hard_oriented::add_questions(runner);
  hard_boxes::add_questions(runner);
  hard_rectangles::add_questions(runner);
  hard_slabs::add_questions(runner);
  hard_spheres::add_questions(runner);
  return runner.run(argc, argv);
}
