// Compares the book's bounding volumes with those of CGAL, Bullet and Coal: the smallest sphere, a
// small oriented box, and the tests of two volumes. Times are those of the processor, and each is
// also given as a share of it that the book takes: the median and the range over runs in which all
// take turns. usage:
//   volume_peers [N] [runs]               N points of each family and size, and a tenth as many
//   pairs volume_peers --write FOLDER [N]       the points and right answers, for miniball_peer.py
//   volume_peers --ask FOLDER/spheres NAME  prints what the book takes for the spheres of a file,
//   ns
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "../comparison.hpp"
#include "../number_files.hpp"
#include "compare_fits.hpp"
#include "compare_pairs.hpp"
#include "peers.hpp"
#include "volume_scenes.hpp"

namespace {

using volume_scenes::Family;
using volume_scenes::Points;
using volume_scenes::Scene;

/// Calls with the sets of each family and size.
void each_scene(std::size_t total, const auto& call) {
  for (const std::size_t size : {10U, 100U, 1000U, 10000U, 100000U}) {
    for (const Family family : volume_families::all) {
      if (volume_scenes::has(family, size)) call(volume_scenes::scene(family, size, total));
    }
  }
}

/// Writes FOLDER/spheres: of each family and size NAME its NAME.f64 (points, one set after the
/// other), NAME.counts.i32 (how many points each set has) and NAME.right.f64 (the smallest
/// radius, and what a radius may be off), and scenes.tsv with names and titles.
int write(const std::filesystem::path& folder, std::size_t total) {
  const std::filesystem::path to = folder / "spheres";
  std::filesystem::create_directories(to);
  std::ofstream list(to / "scenes.tsv");
  each_scene(total, [&](const Scene& scene) {
    std::vector<peers::Numbers> points;
    std::vector<int> counts;
    std::vector<double> right = compare_fits::right_radii(scene), all;
    for (std::size_t i = 0; i < scene.sets.size(); ++i) {
      points.insert(points.end(), scene.plain[i].begin(), scene.plain[i].end());
      counts.push_back(static_cast<int>(scene.sets[i].size()));
      all.insert(all.end(), {right[i], volume_scenes::tolerated(right[i], scene.sets[i])});
    }
    write_numbers(to / (scene.name + ".f64"), points);
    write_numbers(to / (scene.name + ".counts.i32"), counts);
    write_numbers(to / (scene.name + ".right.f64"), all);
    list << scene.name << "\t" << volume_scenes::title_of(scene) << "\n";
  });
  return list.flush().good() ? 0 : 1;
}

/// The book's time for one set of a folder's family, in the process that waits for it.
int ask(const std::filesystem::path& folder, const std::string& name) {
  Scene scene{name, name, {}, {}};
  const auto points = read_numbers<peers::Numbers>(folder / (name + ".f64"));
  auto next = points.begin();
  for (const int count : read_numbers<int>(folder / (name + ".counts.i32"))) {
    Points set;
    for (int i = 0; i < count; ++i, ++next) set.emplace_back((*next)[0], (*next)[1], (*next)[2]);
    volume_scenes::add(scene, set);
  }
  const auto method = compare_fits::smallest(scene);
  compare_fits::Balls balls(scene.sets.size());
  method.ask(balls);
  const double start = comparison::processor_time();
  method.ask(balls);
  const double elapsed = comparison::processor_time() - start;
  std::printf("%.3f\n", elapsed / static_cast<double>(scene.sets.size()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::size_t usual = 20000;
  const std::string_view option = argc > 2 ? argv[1] : "";
  if (option == "--write") {
    comparison::leave(write(argv[2], comparison::number(argc, argv, 3, usual)));
  }
  if (option == "--ask" && argc > 3) comparison::leave(ask(argv[2], argv[3]));
  const std::size_t total = comparison::number(argc, argv, 1, usual);
  const int runs = static_cast<int>(comparison::number(argc, argv, 2, 9));
  compare_fits::SphereGoal spheres;
  each_scene(total,
             [&](const Scene& scene) { compare_fits::compare_spheres(scene, runs, spheres); });
  compare_fits::BoxGoal boxes;
  for (const Scene& scene : volume_scenes::box_scenes(total / 20)) {
    compare_fits::compare_boxes(scene, runs, boxes);
  }
  compare_pairs::compare_spheres(total / 10, runs);
  compare_pairs::compare_limits(total / 10, runs);
  compare_pairs::compare_boxes(total / 10, runs);
  compare_pairs::compare_slabs(total / 10, runs);
  std::printf(
      "the smallest sphere: at most %.3f of CGAL's exact time (%s), %zu wrong\n"
      "a small box: at most %.5f of CGAL's volume (%s), at most %.3f of its time (%s)\n",
      spheres.largest, spheres.where.c_str(), spheres.wrong, boxes.volume,
      boxes.volume_where.c_str(), boxes.time, boxes.time_where.c_str());
  comparison::leave(0);
}
