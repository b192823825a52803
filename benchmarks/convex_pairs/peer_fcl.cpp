// FCL: its closed forms, and libccd's GJK for the rest.
#include <fcl/fcl.h>

#include <exception>

#include "peers.hpp"

namespace {

using peers::Kind;
using peers::Shape;

fcl::Vector3d vector(const peers::Numbers& v) { return {v[0], v[1], v[2]}; }

struct Placed {
  std::shared_ptr<fcl::ShapeBased> shape;
  fcl::Transform3d pose;
};

std::shared_ptr<fcl::ShapeBased> shape_of(const Shape& from) {
  const peers::Numbers& h = from.half_lengths;
  switch (from.kind) {
    case Kind::sphere:
      return std::make_shared<fcl::Sphered>(from.radius);
    case Kind::capsule:
      return std::make_shared<fcl::Capsuled>(from.radius, 2 * h[2]);
    case Kind::box:
      return std::make_shared<fcl::Boxd>(2 * h[0], 2 * h[1], 2 * h[2]);
    case Kind::triangle:
      return std::make_shared<fcl::TrianglePd>(vector(from.points[0]), vector(from.points[1]),
                                               vector(from.points[2]));
    case Kind::cylinder:
      return std::make_shared<fcl::Cylinderd>(from.radius, 2 * h[2]);
    default:
      return std::make_shared<fcl::Ellipsoidd>(h[0], h[1], h[2]);
  }
}

Placed placed(const Shape& from) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    pose.linear().col(i) = vector(from.axes[static_cast<std::size_t>(i)]);
  }
  pose.translation() = vector(from.centre);
  return {shape_of(from), pose};
}

bool meet(const Placed& a, const Placed& b) {
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  return fcl::collide(a.shape.get(), a.pose, b.shape.get(), b.pose, request, result) > 0;
}

peers::Witness measure(const Placed& a, const Placed& b) try {
  fcl::DistanceRequestd request(true, true);
  fcl::DistanceResultd result;
  const double distance =
      fcl::distance(a.shape.get(), a.pose, b.shape.get(), b.pose, request, result);
  const fcl::Vector3d between = result.nearest_points[0] - result.nearest_points[1];
  const double length = distance < 0 ? -between.norm() : between.norm();
  const fcl::Vector3d n = between / length;
  return {n.allFinite(), distance, {n[0], n[1], n[2]}};
} catch (const std::exception&) {
  return {};
}

/// It has no lozenges, and its hulls need faces of more than triangles.
bool takes(Kind a, Kind b) {
  const auto known = [](Kind k) { return k != Kind::lozenge && k != Kind::hull; };
  return known(a) && known(b);
}

}  // namespace

std::vector<peers::PairTest> peers::fcl_pairs() {
  return {pair_test("FCL", takes, placed, meet, measure)};
}
