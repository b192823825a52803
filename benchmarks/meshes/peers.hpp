/// @file
/// Other programs' meshes: rays and segments at them, points in them, each behind one function.
/// Their headers stay in their own files.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace peers {

using Floats = std::array<float, 3>;

struct MeshOfFloats {
  std::vector<Floats> vertices;
  std::vector<std::array<int, 3>> triangles;
};
/// Rays from x, y, z in directions that need not be unit vectors, and the ends of segments along
/// them. origin + direction is exact in double.
struct RaysOfFloats {
  std::vector<Floats> origins, directions, ends;
};

/// The triangle that is hit, or −1; 1 or 0 where no triangle is named; −1, 0 or 1 for a point
/// outside, on the surface or inside.
using Answers = std::vector<int>;
using Ask = std::function<void(const RaysOfFloats&, Answers&)>;
using Locate = std::function<void(const std::vector<Floats>&, Answers&)>;

/// Another program's mesh. Its tree is made by build(), whose time is taken, too.
struct Tree {
  std::function<void()> build;
  Ask first;      ///< the first triangle that a ray meets, and where
  Ask any;        ///< whether a ray meets a triangle
  Ask segment;    ///< whether a segment meets a triangle
  Locate locate;  ///< where a point is
  /// Left out of rays from far away: FCL 0.7's solver does not end for some of these segments.
  bool near_only = false;
};

/// rtcIntersect1 and rtcOccluded1. Embree is float.
/// @param device the device's configuration
Tree embree(const MeshOfFloats& mesh, const char* device, bool robust);
/// AABB_tree and Side_of_triangle_mesh with exact predicates.
Tree cgal(const MeshOfFloats& mesh);
/// A capsule of radius 0 against a tree of oriented boxes, since neither has rays.
Tree fcl(const MeshOfFloats& mesh);
Tree coal(const MeshOfFloats& mesh);

/// Calls ask(i) for each, and keeps the answers.
template <class Call>
void in_turn(std::size_t count, Answers& answers, const Call& ask) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = static_cast<int>(ask(i));
}

}  // namespace peers
