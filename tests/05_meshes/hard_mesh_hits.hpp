/// @file
/// The hard cases of lines and meshes: which triangle is first, and in how many points a line meets
/// the mesh.
#pragma once

#include <02_triangles/truth.hpp>
#include <05_meshes/hard_mesh.hpp>
#include <algorithm>
#include <contact/mesh_hits.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/ray_box.hpp>
#include <contact/watertight.hpp>
#include <optional>
#include <string>
#include <support/generators.hpp>
#include <support/hard_cases.hpp>
#include <vector>

namespace hard_mesh_hits {

using contact::Mesh;
using contact::MeshFeature;
using contact::MeshHit;
using contact::Ray;
using contact::Segment;
using contact::Triangle;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_mesh::mesh_in;

// ---------------------------------------------------------------- input

/// Asks with the ray or the segment of a case.
template <class S, class Ask>
auto with_line(const Case& c, const Ask& ask) {
  return c.has("segment") ? ask(generators::rounded<S>(c.segment("segment")))
                          : ask(generators::rounded<S>(c.ray("ray")));
}

// ---------------------------------------------------------------- answers

inline std::string name_of(MeshFeature feature) {
  return feature == MeshFeature::face ? "face" : (feature == MeshFeature::edge ? "edge" : "vertex");
}

/// By whole numbers: all crossings, of which those with the same t are one.
inline Json mesh_line_answer(const Case& c) {
  const Mesh<double> mesh = mesh_in<double>(c);
  std::vector<truth::Hit> hits;
  int first = -1;
  truth::Hit least;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto hit = with_line<double>(
        c, [&](const auto& line) { return truth::meet(line, contact::triangle_of(mesh, i)); });
    if (!hit) continue;
    if (first < 0 || hit->t < least.t) {
      first = int(i);
      least = *hit;
    }
    const bool known = std::any_of(hits.begin(), hits.end(),
                                   [&](const truth::Hit& other) { return other.t == hit->t; });
    if (!known) hits.push_back(*hit);
  }
  Json answer{{"class", "a"}, {"hits", hits.size()}};
  if (first < 0) return answer;
  const auto zeros = std::count(least.weights.begin(), least.weights.end(), 0);
  answer["triangle"] = first;
  answer["feature"] = zeros == 0 ? "face" : (zeros == 1 ? "edge" : "vertex");
  answer["t"] = hard_cases::hex(oracle::nearest(least.t));
  return answer;
}

/// Right if the number of hits is, the first triangle, and its t to 2^-20 of itself.
template <class S>
bool right(const std::vector<MeshHit<S>>& hits, const Json& answer) {
  if (hits.size() != answer.at("hits").get<std::size_t>()) return false;
  if (hits.empty()) return true;
  if (hits[0].triangle != answer.at("triangle")) return false;
  const double t = hard_cases::unhex(answer, "t");
  return hard_cases::close(double(hits[0].hit.t), t, 0x1p-20 * std::abs(t));
}

// ---------------------------------------------------------------- methods as they are often
// written

/// With the published test for a ray parallel to the triangle: a determinant below 1e-6 is 0.
template <class Line>
std::optional<contact::TriangleHit<double>> with_epsilon(const Line& line,
                                                         const Triangle<double>& t) {
  const Vector3<double> n = (t.b - t.a).cross(t.c - t.a);
  if (std::abs(n.dot(contact::ray_of(line).direction)) < 1e-6) return std::nullopt;
  return contact::intersect_moller_trumbore(line, t);
}

/// Hits that are next to each other count once.
template <class S>
std::vector<MeshHit<S>> merged(std::vector<MeshHit<S>> hits, S room) {
  const auto last = std::unique(
      hits.begin(), hits.end(),
      [room](const MeshHit<S>& x, const MeshHit<S>& y) { return y.hit.t - x.hit.t <= room; });
  hits.erase(last, hits.end());
  return hits;
}

/// The exact test, but only of triangles whose boxes of floats the branchless slabs enter, as in a
/// tree with boxes rounded to the nearest float.
template <class Line>
std::vector<MeshHit<double>> behind_float_boxes(const Line& line, const Mesh<double>& mesh) {
  Mesh<double> entered;
  entered.vertices = mesh.vertices;
  std::vector<int> indices;
  const Ray<double> ray = contact::ray_of(line);
  const Ray<float> in_float{generators::rounded<float>(ray.origin),
                            generators::rounded<float>(ray.direction)};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<double> t = contact::triangle_of(mesh, i);
    const contact::Aabb<float> box{
        generators::rounded<float>(Vector3<double>(t.a.cwiseMin(t.b).cwiseMin(t.c))),
        generators::rounded<float>(Vector3<double>(t.a.cwiseMax(t.b).cwiseMax(t.c)))};
    const auto passage = contact::passage_by_branchless_slabs(in_float, box);
    if (!passage || passage->exit < 0) continue;
    entered.triangles.push_back(mesh.triangles[i]);
    indices.push_back(static_cast<int>(i));
  }
  auto hits = contact::all_mesh_hits(line, entered);
  for (auto& hit : hits) hit.triangle = indices[static_cast<std::size_t>(hit.triangle)];
  return hits;
}

template <class S, class Method>
void add_method(hard_cases::Runner& runner, const std::string& name, Method method) {
  runner.method("mesh_line", name, [method](const Case& c, const Json& answer) {
    return with_line<S>(
        c, [&](const auto& line) { return right<S>(method(line, mesh_in<S>(c)), answer); });
  });
}

/// Adds the question and its methods.
inline void add_questions(hard_cases::Runner& runner) {
  runner.question("mesh_line", mesh_line_answer);
  const auto plain = [](const auto& line, const auto& triangle) {
    return contact::intersect_moller_trumbore(line, triangle);
  };
  const auto watertight = [](const auto& line, const auto& triangle) {
    return contact::intersect_watertight(line, triangle);
  };
  add_method<float>(runner, "each triangle, float", [plain](const auto& line, const auto& mesh) {
    return contact::all_hits_by_triangles(line, mesh, plain);
  });
  add_method<double>(runner, "each triangle, double", [plain](const auto& line, const auto& mesh) {
    return contact::all_hits_by_triangles(line, mesh, plain);
  });
  add_method<double>(runner, "determinant above 1e-6", [](const auto& line, const auto& mesh) {
    return merged(contact::all_hits_by_triangles(
                      line, mesh, [](const auto& l, const auto& t) { return with_epsilon(l, t); }),
                  0.0);
  });
  add_method<double>(runner, "t merged within 1e-6", [plain](const auto& line, const auto& mesh) {
    return merged(contact::all_hits_by_triangles(line, mesh, plain), 1e-6);
  });
  add_method<double>(runner, "watertight, equal t merged",
                     [watertight](const auto& line, const auto& mesh) {
                       return merged(contact::all_hits_by_triangles(line, mesh, watertight), 0.0);
                     });
  add_method<double>(runner, "behind float boxes", [](const auto& line, const auto& mesh) {
    return behind_float_boxes(line, mesh);
  });
  runner.method("mesh_line", "the book, exact", [](const Case& c, const Json& answer) {
    return with_line<double>(c, [&](const auto& line) {
      const Mesh<double> mesh = mesh_in<double>(c);
      const contact::MeshTree<double> tree(mesh);
      const auto all = contact::all_mesh_hits(line, mesh);
      const auto first = tree.first(line);
      if (!right<double>(all, answer) || !right<double>(tree.all(line), answer)) return false;
      if (first.has_value() != !all.empty() || tree.any(line) != !all.empty()) return false;
      return !first ||
             (first->triangle == answer.at("triangle") && all[0].triangle == first->triangle &&
              name_of(first->feature) == answer.at("feature"));
    });
  });
}

}  // namespace hard_mesh_hits
