/// @file
/// The hard cases of a triangle and a box: question and methods.
#pragma once

#include <06_triangle_pairs/hard_pairs.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <array>
#include <concepts>
#include <contact/aabb.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/triangle_box.hpp>
#include <string>
#include <support/generators.hpp>
#include <support/hard_cases.hpp>

namespace hard_boxes {

using contact::Aabb;
using contact::Segment;
using contact::Triangle;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;

template <std::floating_point S>
Aabb<S> box_of(const Case& c) {
  return {generators::rounded<S>(c.vector("low")), generators::rounded<S>(c.vector("high"))};
}
template <std::floating_point S>
Triangle<S> triangle_of(const Case& c) {
  return generators::rounded<S>(c.triangle("triangle"));
}

/// The corner of a box with the bits 0, 1 and 2 for the upper side along x, y and z.
template <std::floating_point S>
Vector3<S> corner(const Aabb<S>& box, unsigned bits) {
  return {(bits & 1U) != 0 ? box.high.x() : box.low.x(),
          (bits & 2U) != 0 ? box.high.y() : box.low.y(),
          (bits & 4U) != 0 ? box.high.z() : box.low.z()};
}
template <std::floating_point S>
bool contains(const Aabb<S>& box, const Vector3<S>& p) {
  for (int k = 0; k < 3; ++k) {
    if (p[k] < box.low[k] || box.high[k] < p[k]) return false;
  }
  return true;
}
/// Two triangles for each face.
template <std::floating_point S>
std::array<Triangle<S>, 12> surface(const Aabb<S>& box) {
  constexpr std::array<std::array<unsigned, 4>, 6> faces{
      {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
  std::array<Triangle<S>, 12> triangles;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto at = [&](std::size_t k) { return corner(box, faces[i][k]); };
    triangles[2 * i] = {at(0), at(1), at(2)};
    triangles[2 * i + 1] = {at(0), at(2), at(3)};
  }
  return triangles;
}

// ---------------------------------------------------------------- methods as they are often
// written

inline bool a_vertex_inside(const Triangle<double>& t, const Aabb<double>& box) {
  return contains(box, t.a) || contains(box, t.b) || contains(box, t.c);
}
/// Or an edge of the triangle meets a face: the box may still pierce the triangle.
inline bool an_edge_meets_a_face(const Triangle<double>& t, const Aabb<double>& box) {
  if (a_vertex_inside(t, box)) return true;
  for (const auto& edge : {Segment<double>{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
    for (const Triangle<double>& face : surface(box)) {
      if (contact::intersect_moller_trumbore(edge, face)) return true;
    }
  }
  return false;
}
/// The box of the triangle, which is too large.
inline bool boxes_touch(const Triangle<double>& t, const Aabb<double>& box) {
  const std::array<Vector3<double>, 3> vertices{t.a, t.b, t.c};
  return contact::boxes_touch(contact::aabb_of_points<double>(vertices), box);
}
/// And the plane of the triangle, but none of the nine cross products.
inline bool four_axes(const Triangle<double>& t, const Aabb<double>& box) {
  if (!boxes_touch(t, box)) return false;
  int front = 0, behind = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const int side = contact::orient_3d(t.a, t.b, t.c, corner(box, i));
    front += side > 0;
    behind += side < 0;
  }
  return front < 8 && behind < 8;
}

// ---------------------------------------------------------------- question

template <std::floating_point S, class Meet>
void add_box_method(hard_cases::Runner& runner, const std::string& name, const Meet& meet) {
  runner.method("triangle_box", name, hard_pairs::applies<S>,
                [meet](const Case& c, const Json& answer) {
                  return meet(triangle_of<S>(c), box_of<S>(c)) == answer.at("meet").get<bool>();
                });
}

/// Adds it to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  runner.question("triangle_box", [](const Case& c) -> Json {
    const Triangle<double> t = triangle_of<double>(c);
    const Aabb<double> box = box_of<double>(c);
    bool meet = contains(box, t.a);
    for (const Triangle<double>& face : surface(box)) {
      meet = meet || pair_truth::meet_exactly(t, face);
    }
    return {{"class", "a"}, {"meet", meet}};
  });
  add_box_method<double>(runner, "a vertex inside", a_vertex_inside);
  add_box_method<double>(runner, "edges and faces, double", an_edge_meets_a_face);
  add_box_method<double>(runner, "boxes alone", boxes_touch);
  add_box_method<double>(runner, "four axes, exact", four_axes);
  add_box_method<float>(runner, "thirteen axes, float", [](const auto& t, const auto& box) {
    return contact::triangle_meets_box_rounded(t, box);
  });
  add_box_method<double>(runner, "thirteen axes, double", [](const auto& t, const auto& box) {
    return contact::triangle_meets_box_rounded(t, box);
  });
  runner.method("triangle_box", "the book, exact", [](const Case& c, const Json& answer) {
    const bool meet = answer.at("meet").get<bool>();
    return contact::triangle_meets_box(triangle_of<double>(c), box_of<double>(c)) == meet &&
           (c.type() == "double" ||
            contact::triangle_meets_box(triangle_of<float>(c), box_of<float>(c)) == meet);
  });
}

}  // namespace hard_boxes
