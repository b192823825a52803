// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
#include <06_triangle_pairs/hard_boxes.hpp>
#include <06_triangle_pairs/hard_common.hpp>
#include <06_triangle_pairs/hard_pair_meshes.hpp>
#include <06_triangle_pairs/hard_pairs.hpp>
#include <06_triangle_pairs/hard_self_pairs.hpp>

int main(int argc, char** argv) {
  hard_cases::Runner runner("06_triangle_pairs");
  hard_pairs::add_questions(runner);
  hard_common::add_questions(runner);
  hard_boxes::add_questions(runner);
  hard_pair_meshes::add_questions(runner);
  hard_self_pairs::add_questions(runner);
  return runner.run(argc, argv);
}
