// Coal: GJK and EPA with its closed forms, for all kinds; a lozenge is a flat box with a radius.
#include <coal/collision.h>
#include <coal/distance.h>
#include <coal/shape/convex.h>
#include <coal/shape/geometric_shapes.h>

#include <algorithm>

#include <exception>

#include "peers.hpp"

namespace {

using peers::Kind;
using peers::Shape;

coal::Vec3s vector(const peers::Numbers& p) { return {p[0], p[1], p[2]}; }

struct Placed {
  std::shared_ptr<coal::ShapeBase> shape;
  coal::Transform3s pose;
};

std::shared_ptr<coal::ShapeBase> shape_of(const Shape& from) {
  const peers::Numbers& h = from.half_lengths;
  switch (from.kind) {
    case Kind::sphere:
      return std::make_shared<coal::Sphere>(from.radius);
    case Kind::capsule:
      return std::make_shared<coal::Capsule>(from.radius, 2 * h[2]);
    case Kind::lozenge: {
      auto made = std::make_shared<coal::Box>(2 * h[0], 2 * h[1], 0);
      made->setSweptSphereRadius(from.radius);
      return made;
    }
    case Kind::box:
      return std::make_shared<coal::Box>(2 * h[0], 2 * h[1], 2 * h[2]);
    case Kind::triangle:
      return std::make_shared<coal::TriangleP>(vector(from.points[0]), vector(from.points[1]),
                                               vector(from.points[2]));
    case Kind::hull: {
      auto points = std::make_shared<std::vector<coal::Vec3s>>();
      for (const auto& p : from.points) points->push_back(vector(p));
      std::shared_ptr<coal::ShapeBase> made(
          coal::ConvexBase::convexHull(points, static_cast<unsigned>(points->size()), true));
      made->setSweptSphereRadius(from.radius);
      return made;
    }
    case Kind::cylinder:
      return std::make_shared<coal::Cylinder>(from.radius, 2 * h[2]);
    default:
      return std::make_shared<coal::Ellipsoid>(h[0], h[1], h[2]);
  }
}

Placed placed(const Shape& from) {
  coal::Matrix3s turn;
  for (Eigen::Index i = 0; i < 3; ++i) {
    turn.col(i) = vector(from.axes[static_cast<std::size_t>(i)]);
  }
  return {shape_of(from), coal::Transform3s(turn, vector(from.centre))};
}

bool meet(const Placed& a, const Placed& b) {
  const coal::CollisionRequest request(coal::NO_REQUEST, 1);
  coal::CollisionResult result;
  return coal::collide(a.shape.get(), a.pose, b.shape.get(), b.pose, request, result) > 0;
}

peers::Witness measure(const Placed& a, const Placed& b) try {
  const coal::DistanceRequest request(true, true);
  coal::DistanceResult result;
  const double distance =
      coal::distance(a.shape.get(), a.pose, b.shape.get(), b.pose, request, result);
  const coal::Vec3s n = -result.normal;
  return {n.allFinite(), distance, {n[0], n[1], n[2]}};
} catch (const std::exception&) {
  return {};
}

}  // namespace

std::vector<peers::PairTest> peers::coal_pairs() {
  return {pair_test(
      "Coal", [](Kind, Kind) { return true; }, placed, meet, measure)};
}
