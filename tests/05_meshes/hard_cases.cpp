// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
#include <05_meshes/hard_mesh_checks.hpp>
#include <05_meshes/hard_mesh_hits.hpp>
#include <05_meshes/hard_moving.hpp>
#include <05_meshes/hard_polyhedra.hpp>

int main(int argc, char** argv) {
  hard_cases::Runner runner("05_meshes");
  hard_mesh_checks::add_questions(runner);
  hard_mesh_hits::add_questions(runner);
  hard_polyhedra::add_questions(runner);
  hard_moving::add_questions(runner);
  return runner.run(argc, argv);
}
