// Cuts concave bodies into convex pieces, exactly, and writes the bodies for other programs. usage:
//   mesh_pieces FOLDER [runs]
// Into FOLDER it writes for each body NAME.vertices.f64 and NAME.triangles.i32, and bodies.tsv:
// name, triangles, notches, pieces, milliseconds (median, least, most), whether the volumes of the
// pieces add up to that of the body to the last digit, and that volume.
#include "questions.hpp"

#include <algorithm>
#include <contact/convex_pieces.hpp>
#include <contact/mesh_edges.hpp>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

namespace {

using contact::Mesh;
using Point = contact::Vector3<double>;
using P = contact::Vector2<double>;

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Teeth side by side on a bar.
Mesh<double> comb(int teeth) {
  contact::Polygon<double> outline{P(0, 0), P(2 * teeth - 1, 0)};
  for (int i = teeth - 1; i >= 0; --i) {
    outline.insert(outline.end(), {P(2 * i + 1, 3), P(2 * i, 3)});
    if (i > 0) outline.insert(outline.end(), {P(2 * i, 1), P(2 * i - 1, 1)});
  }
  return contact::prism_mesh(outline, 0, 1);
}

/// A star in the plane, extruded: each second vertex is a notch.
Mesh<double> star(int spikes) {
  contact::Polygon<double> outline;
  for (int i = 0; i < 2 * spikes; ++i) {
    // Around the unit square's boundary, by the share of a turn: no sine and cosine.
    const double along = 4.0 * i / (2 * spikes);
    const int side = static_cast<int>(along);
    const double across = 2 * (along - side) - 1;
    const P on_square = side == 0   ? P(1, across)
                        : side == 1 ? P(-across, 1)
                        : side == 2 ? P(-1, -across)
                                    : P(across, -1);
    const double radius = i % 2 == 0 ? 1 : 0.4;
    outline.push_back(P(radius * on_square / std::sqrt(on_square.dot(on_square))));
  }
  return contact::prism_mesh(outline, 0, 0.5);
}

struct Named {
  const char* name;
  Mesh<double> mesh;
};

std::vector<Named> bodies() {
  generators::Random random(1);
  return {
      {"L", contact::prism_mesh({P(0, 0), P(2, 0), P(2, 1), P(1, 1), P(1, 2), P(0, 2)}, 0, 1)},
      {"comb of 6 teeth", comb(6)},
      {"star of 5 spikes", star(5)},
      {"star of 12 spikes", star(12)},
      {"torus, 8 by 6", contact::torus_mesh(0.7, 0.3, 8, 6)},
      {"stellated ball", contact::star_mesh(0.5, 1, 0)},
      {"bumpy ball", mesh_families::bumpy(random)},
  };
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: mesh_pieces FOLDER [runs]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
  std::filesystem::create_directories(folder);
  std::ofstream list(folder / "bodies.tsv");
  for (const auto& [name, mesh] : bodies()) {
    questions::write_numbers(folder / (std::string(name) + ".vertices.f64"), mesh.vertices);
    questions::write_numbers(folder / (std::string(name) + ".triangles.i32"), mesh.triangles);
    std::vector<double> times;
    std::vector<contact::ConvexPiece> pieces;
    for (int run = 0; run < runs; ++run) {
      const double start = processor_ms();
      pieces = contact::convex_pieces(mesh);
      times.push_back(processor_ms() - start);
    }
    std::sort(times.begin(), times.end());
    const bool same = contact::volume_of_pieces(pieces) == contact::mesh_volume_exactly(mesh);
    char line[200];
    std::snprintf(line, sizeof line, "%s\t%zu\t%zu\t%zu\t%.3f\t%.3f\t%.3f\t%s\t%.17g\n", name,
                  mesh.triangles.size(), contact::notches(mesh).size(), pieces.size(),
                  times[times.size() / 2], times.front(), times.back(), same ? "exact" : "differs",
                  contact::mesh_volume(mesh).value);
    list << line;
  }
  return list.flush() ? 0 : 1;
}
