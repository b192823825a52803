// Bullet: box and sphere of a convex hull shape, and its test of two boxes.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <LinearMath/btAabbUtil2.h>

#include "peers.hpp"

namespace {

btVector3 vector(const peers::Numbers& p) { return {p[0], p[1], p[2]}; }
peers::Numbers numbers(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// Making the shape is what takes the time: it bounds the points once.
btConvexHullShape shape_of(const peers::Points& points) {
  btConvexHullShape shape(points.front().data(), static_cast<int>(points.size()),
                          static_cast<int>(sizeof(peers::Numbers)));
  shape.setMargin(0);
  shape.recalcLocalAabb();
  return shape;
}

peers::Limits limits_of(const peers::Points& points) {
  const btConvexHullShape shape = shape_of(points);
  btVector3 low, high;
  shape.getAabb(btTransform::getIdentity(), low, high);
  return {numbers(low), numbers(high)};
}

peers::Ball ball_of(const peers::Points& points) {
  const btConvexHullShape shape = shape_of(points);
  btVector3 centre;
  btScalar radius = 0;
  shape.getBoundingSphere(centre, radius);
  return {numbers(centre), radius};
}

peers::Points same(const peers::Points& points) { return points; }

}  // namespace

std::vector<peers::Fit<peers::Ball>> peers::bullet_balls() {
  return {fit<Ball>("Bullet, getBoundingSphere", same, ball_of)};
}
std::vector<peers::Fit<peers::Limits>> peers::bullet_limits() {
  return {fit<Limits>("Bullet, getAabb", same, limits_of)};
}
std::vector<peers::PairTest<peers::Limits>> peers::bullet_limits_pairs() {
  return {pair_test<Limits>(
      "Bullet, TestAabbAgainstAabb2",
      [](const Limits& limits) {
        return std::array{vector(limits.low), vector(limits.high)};
      },
      [](const auto& first, const auto& second) {
        return TestAabbAgainstAabb2(first[0], first[1], second[0], second[1]);
      })};
}
