/// @file
/// The hard cases of two meshes, their pairs of triangles and their contacts: questions and
/// methods.
#pragma once

#include <05_meshes/hard_mesh.hpp>
#include <06_triangle_pairs/hard_common.hpp>
#include <06_triangle_pairs/mesh_contacts_truth.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <algorithm>
#include <concepts>
#include <contact/aabb.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_contacts.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/pair_methods.hpp>
#include <contact/pair_orientations.hpp>
#include <string>
#include <support/hard_cases.hpp>
#include <vector>

namespace hard_pair_meshes {

using contact::Mesh;
using contact::MeshTree;
using contact::Triangle;
using contact::TrianglePair;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_mesh::mesh_of;

using Pairs = std::vector<TrianglePair>;

/// Two meshes: of a case of doubles, or of floats.
template <std::floating_point S>
Mesh<S> mesh_in(const Case& c, const std::string& suffix) {
  return contact::rounded_mesh<S>(mesh_of(c, suffix));
}

/// Each triangle against each.
template <std::floating_point S, class Meet>
Pairs all_pairs(const Mesh<S>& a, const Mesh<S>& b, const Meet& meet) {
  Pairs pairs;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      if (!meet(triangle_of(a, i), triangle_of(b, j))) continue;
      pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
    }
  }
  return pairs;
}
inline Pairs true_pairs(const Case& c) {
  return all_pairs(mesh_of(c, "_first"), mesh_of(c, "_second"),
                   [](const Triangle<double>& t, const Triangle<double>& u) {
                     return pair_truth::meet_exactly(t, u);
                   });
}

template <std::floating_point S>
contact::Aabb<S> box_of(const Triangle<S>& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

// ---------------------------------------------------------------- contacts

/// The points of all pairs, one after the other.
inline std::vector<Vector3<double>> points_of_pairs(const Case& c) {
  std::vector<Vector3<double>> points;
  for (const auto& contact :
       contact::contacts_of_pairs(mesh_of(c, "_first"), mesh_of(c, "_second"))) {
    points.push_back(contact.position);
  }
  return points;
}
inline std::vector<oracle::Vector> true_contacts(const Case& c) {
  using mesh_contacts_truth::features_of;
  return mesh_contacts_truth::contacts(features_of(mesh_of(c, "_first")),
                                       features_of(mesh_of(c, "_second")));
}

template <std::floating_point S>
bool book_finds_contacts(const Case& c, const std::vector<oracle::Vector>& exact) {
  const Mesh<S> a = mesh_in<S>(c, "_first"), b = mesh_in<S>(c, "_second");
  hard_common::Points<S> points;
  S bound(0);
  for (const auto& found : contact::mesh_contacts(a, b)) {
    points.push_back(found.position);
    bound = std::max(bound, found.bound);
  }
  return contact::mesh_contacts(b, a).size() == exact.size() &&
         hard_common::same_points<S>(points, exact, oracle::exact(bound));
}
template <std::floating_point S>
bool book_finds_pairs(const Case& c, const Pairs& pairs) {
  const Mesh<S> a = mesh_in<S>(c, "_first"), b = mesh_in<S>(c, "_second");
  const MeshTree<S> of_a(a), of_b(b);
  return contact::meeting_triangles(a, b) == pairs &&
         contact::meeting_triangles(of_a, of_b) == pairs &&
         contact::any_meeting(a, b) == !pairs.empty() &&
         contact::any_meeting(of_b, of_a) == !pairs.empty();
}

// ---------------------------------------------------------------- questions

template <std::floating_point S, class Meet>
void add_pair_method(hard_cases::Runner& runner, const std::string& name, const Meet& meet) {
  runner.method("mesh_pairs", name, hard_pairs::applies<S>, [meet](const Case& c, const Json&) {
    return all_pairs(mesh_in<S>(c, "_first"), mesh_in<S>(c, "_second"), meet) == true_pairs(c);
  });
}
template <std::floating_point S>
void add_rounded_pair_methods(hard_cases::Runner& runner, const std::string& type) {
  using T = Triangle<S>;
  add_pair_method<S>(runner, "steps, " + type,
                     [](const T& t, const T& u) { return contact::meet_by_steps(t, u).meet; });
  add_pair_method<S>(runner, "edges, " + type,
                     [](const T& t, const T& u) { return contact::meet_by_edges(t, u); });
  add_pair_method<S>(runner, "axes, " + type,
                     [](const T& t, const T& u) { return contact::meet_by_axes(t, u); });
  add_pair_method<S>(runner, "orientations, " + type,
                     [](const T& t, const T& u) { return contact::meet_by_orientations(t, u); });
}

inline void add_mesh_pairs(hard_cases::Runner& runner) {
  runner.question("mesh_pairs", [](const Case& c) -> Json {
    return {{"class", "a"}, {"pairs", true_pairs(c).size()}};
  });
  add_pair_method<double>(runner, "boxes alone", [](const auto& t, const auto& u) {
    return contact::boxes_touch(box_of<double>(t), box_of<double>(u));
  });
  add_rounded_pair_methods<float>(runner, "float");
  add_rounded_pair_methods<double>(runner, "double");
  runner.method("mesh_pairs", "the book, exact", [](const Case& c, const Json&) {
    const Pairs pairs = true_pairs(c);
    return book_finds_pairs<double>(c, pairs) &&
           (c.type() == "double" || book_finds_pairs<float>(c, pairs));
  });
}

inline void add_contacts(hard_cases::Runner& runner) {
  runner.question("contacts", [](const Case& c) -> Json {
    return {{"class", "a"}, {"contacts", true_contacts(c).size()}};
  });
  const auto add = [&runner](const char* name, const auto& count) {
    runner.method("contacts", name, [count](const Case& c, const Json& answer) {
      return count(points_of_pairs(c)) == answer.at("contacts").get<std::size_t>();
    });
  };
  using hard_common::merged;
  add("one for each pair", [](const auto& points) { return points.size(); });
  add("equal positions once", [](const auto& points) { return merged<double>(points, 0).size(); });
  add("positions within 1e-6 once",
      [](const auto& points) { return merged<double>(points, 1e-6).size(); });
  runner.method("contacts", "the book, exact", [](const Case& c, const Json&) {
    const std::vector<oracle::Vector> exact = true_contacts(c);
    return book_finds_contacts<double>(c, exact) &&
           (c.type() == "double" || book_finds_contacts<float>(c, exact));
  });
}

/// Adds them to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  add_mesh_pairs(runner);
  add_contacts(runner);
}

}  // namespace hard_pair_meshes
