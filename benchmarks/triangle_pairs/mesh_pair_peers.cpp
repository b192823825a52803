// Compares the book's pairs of triangles of two meshes with those of CGAL, FCL and Coal: what it
// takes to build what is needed, to know whether any two triangles meet, and to find all pairs that
// do, and how many pairs are missed and invented. Times are those of the processor, and each is
// also given as a share of it that the book takes: the median and the range over runs in which all
// take turns. usage:
//   mesh_pair_peers [runs]
//   mesh_pair_peers --write FOLDER     the meshes and right answers, for three_peer.mjs and
//                                      igl_peer.py, which ask `--ask FOLDER/meshes/SCENE` in turn
//   mesh_pair_peers --ask FOLDER WHAT  prints what the book takes to `build`, for `any` or `all`,
//   ms
#include <contact/mesh_pairs.hpp>
#include <contact/mesh_tree.hpp>
#include <optional>
#include <string_view>

#include "../comparison.hpp"
#include "mesh_scenes.hpp"
#include "peers.hpp"

namespace {

using comparison::compare;
using comparison::Fault;
using contact::Mesh;
using contact::MeshTree;
using mesh_scenes::Scene;
using peers::Found;

constexpr double us = 1e3, ms = 1e6;

Found plain(const std::vector<contact::TrianglePair>& pairs) {
  Found found;
  for (const contact::TrianglePair& pair : pairs) {
    found.emplace_back(pair.of_first, pair.of_second);
  }
  return found;
}

/// Pairs of `from` that are not in `in`.
std::size_t lacking(const Found& from, const Found& in) {
  Found rest;
  std::set_difference(from.begin(), from.end(), in.begin(), in.end(), std::back_inserter(rest));
  return rest.size();
}
Found sorted(Found found) {
  std::sort(found.begin(), found.end());
  return found;
}

/// The book's trees and the peers'.
struct Compared {
  const Scene& scene;
  std::optional<MeshTree<double>> first, second;
  std::vector<peers::MeshTest> peers;

  void build() {
    first.emplace(scene.first);
    second.emplace(scene.second);
  }
  explicit Compared(const Scene& of) : scene(of) {
    build();
    const auto add = [this](std::vector<peers::MeshTest> tests) {
      for (peers::MeshTest& test : tests) {
        if (test.build) test.build();
        peers.push_back(std::move(test));
      }
    };
#ifdef CONTACT_HAS_CGAL
    add(peers::cgal_meshes(scene.plain_first, scene.plain_second));
#endif
#ifdef CONTACT_HAS_FCL
    add(peers::fcl_meshes(scene.plain_first, scene.plain_second));
#endif
#ifdef CONTACT_HAS_COAL
    add(peers::coal_meshes(scene.plain_first, scene.plain_second));
#endif
  }
};

std::string titled(const Scene& scene, const char* what) {
  return scene.title + ", 2 x " + std::to_string(scene.first.triangles.size()) + " triangles, " +
         std::to_string(scene.right.size()) + " pairs meet: " + what;
}

void compare_building(Compared& of, int runs) {
  using Method = comparison::Method<int>;
  std::vector<Method> methods{{"Contact Hours", [&of](int&) { of.build(); }}};
  for (const peers::MeshTest& test : of.peers) {
    if (test.build) methods.push_back({test.name, [&test](int&) { test.build(); }});
  }
  compare<int>(titled(of.scene, "building"), "ms", ms, methods, {}, runs);
}

void compare_any(Compared& of, int runs) {
  using Method = comparison::Method<bool>;
  std::vector<Method> methods{
      {"Contact Hours, two trees",
       [&of](bool& found) { found = contact::any_meeting(*of.first, *of.second); }},
      {"Contact Hours, with building", [&of](bool& found) {
         of.build();
         found = contact::any_meeting(*of.first, *of.second);
       }}};
  for (const peers::MeshTest& test : of.peers) {
    methods.push_back({test.name, [&test](bool& found) { found = test.any(); }});
  }
  const std::vector<Fault<bool>> faults{{"wrong", [&of](const bool& found) -> std::size_t {
                                           return found == of.scene.right.empty() ? 1 : 0;
                                         }}};
  compare<bool>(titled(of.scene, "whether any two meet"), "us", us, methods, faults, runs);
}

void compare_all(Compared& of, int runs) {
  using Method = comparison::Method<Found>;
  std::vector<Method> methods{
      {"Contact Hours, two trees",
       [&of](Found& found) { found = plain(contact::meeting_triangles(*of.first, *of.second)); }},
      {"Contact Hours, with building", [&of](Found& found) {
         of.build();
         found = plain(contact::meeting_triangles(*of.first, *of.second));
       }}};
  for (const peers::MeshTest& test : of.peers) methods.push_back({test.name, test.all});
  const Found& right = of.scene.right;
  const std::vector<Fault<Found>> faults{
      {"missed", [&right](const Found& found) { return lacking(right, sorted(found)); }},
      {"invented", [&right](const Found& found) { return lacking(sorted(found), right); }}};
  compare<Found>(titled(of.scene, "all pairs that meet"), "ms", ms, methods, faults, runs);
}

/// Both meshes as one; neither crosses itself.
void compare_self(const Scene& scene, int runs) {
  using Method = comparison::Method<Found>;
  Mesh<double> mesh = scene.first;
  const int from = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), scene.second.vertices.begin(),
                       scene.second.vertices.end());
  const int after = static_cast<int>(mesh.triangles.size());
  for (const auto& [a, b, c] : scene.second.triangles) {
    mesh.triangles.push_back({from + a, from + b, from + c});
  }
  Found right;
  for (const auto& [i, j] : scene.right) right.emplace_back(i, after + j);
  const auto in_order = [](Found found) {
    for (auto& [i, j] : found) {
      if (i > j) std::swap(i, j);
    }
    return sorted(std::move(found));
  };
  std::vector<Method> methods{{"Contact Hours", [&mesh](Found& found) {
                                 found = plain(contact::self_meeting_triangles(mesh));
                               }}};
#ifdef CONTACT_HAS_CGAL
  for (const peers::SelfTest& test : peers::cgal_self(mesh_scenes::plain(mesh))) {
    methods.push_back({test.name, test.all});
  }
#endif
  const std::vector<Fault<Found>> faults{
      {"missed", [&](const Found& found) { return lacking(right, in_order(found)); }},
      {"invented", [&](const Found& found) { return lacking(in_order(found), right); }}};
  compare<Found>(scene.title + ", as one mesh of " + std::to_string(mesh.triangles.size()) +
                     " triangles: all pairs that meet besides shared vertices",
                 "ms", ms, methods, faults, runs);
}

/// The book's time for one scene of a folder, in the process that waits for it.
int ask(const std::string& folder, std::string_view what) {
  const Mesh<double> first = mesh_scenes::read_mesh(folder, "first");
  const Mesh<double> second = mesh_scenes::read_mesh(folder, "second");
  std::optional<MeshTree<double>> trees[2];
  volatile std::size_t kept = 0;
  const auto build = [&] {
    trees[0].emplace(first);
    trees[1].emplace(second);
  };
  build();
  const auto answer = [&] {
    if (what == "build") build();
    if (what == "any") kept = contact::any_meeting(*trees[0], *trees[1]);
    if (what == "all") kept = contact::meeting_triangles(*trees[0], *trees[1]).size();
  };
  answer();
  const double start = comparison::processor_time();
  answer();
  std::printf("%.6f\n", (comparison::processor_time() - start) / ms);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view option = argc > 2 ? argv[1] : "";
  if (option == "--write") comparison::leave(mesh_scenes::write(argv[2]) ? 0 : 1);
  if (option == "--ask" && argc > 3) comparison::leave(ask(argv[2], argv[3]));
  const int runs = static_cast<int>(comparison::number(argc, argv, 1, 9));
  mesh_scenes::each_scene([runs](const Scene& scene) {
    Compared compared(scene);
    compare_building(compared, runs);
    compare_any(compared, runs);
    compare_all(compared, runs);
    if (scene.name == "tori") compare_self(scene, runs);
  });
  comparison::leave(0);
}
