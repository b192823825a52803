// Bullet: GJK with EPA, and for two boxes also its test of axes. Margins are 0, except where a body
// has a radius.
#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <btBulletCollisionCommon.h>

#include "peers.hpp"

namespace {

using peers::Kind;
using peers::Shape;

btVector3 vector(const peers::Numbers& p) { return {p[0], p[1], p[2]}; }

struct Placed {
  std::shared_ptr<btConvexShape> shape;
  btTransform pose;
};

std::shared_ptr<btConvexShape> hull(const peers::Points& points, double radius) {
  auto made = std::make_shared<btConvexHullShape>();
  for (const auto& p : points) made->addPoint(vector(p), false);
  made->setMargin(radius);
  made->recalcLocalAabb();
  return made;
}

std::shared_ptr<btConvexShape> shape_of(const Shape& from) {
  const peers::Numbers& h = from.half_lengths;
  std::shared_ptr<btConvexShape> made;
  switch (from.kind) {
    case Kind::sphere:
      return std::make_shared<btSphereShape>(from.radius);
    case Kind::capsule:
      return std::make_shared<btCapsuleShapeZ>(from.radius, 2 * h[2]);
    case Kind::lozenge:
      return hull({{-h[0], -h[1], 0}, {h[0], -h[1], 0}, {h[0], h[1], 0}, {-h[0], h[1], 0}},
                  from.radius);
    case Kind::box:
      made = std::make_shared<btBoxShape>(btVector3(h[0], h[1], h[2]));
      break;
    case Kind::triangle:
      made = std::make_shared<btTriangleShape>(vector(from.points[0]), vector(from.points[1]),
                                               vector(from.points[2]));
      break;
    case Kind::hull:
      return hull(from.points, from.radius);
    default:
      made = std::make_shared<btCylinderShapeZ>(btVector3(from.radius, from.radius, h[2]));
  }
  made->setMargin(0);
  return made;
}

Placed placed(const Shape& from) {
  const auto& x = from.axes;
  const btMatrix3x3 turn(x[0][0], x[1][0], x[2][0], x[0][1], x[1][1], x[2][1], x[0][2], x[1][2],
                         x[2][2]);
  return {shape_of(from), btTransform(turn, vector(from.centre))};
}

peers::Witness measure(const Placed& a, const Placed& b) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(a.shape.get(), b.shape.get(), &simplex, &depth);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = a.pose;
  input.m_transformB = b.pose;
  btPointCollector result;
  detector.getClosestPoints(input, result, nullptr);
  const btVector3& n = result.m_normalOnBInWorld;
  return {result.m_hasResult, result.m_distance, {n.x(), n.y(), n.z()}};
}
bool meet(const Placed& a, const Placed& b) {
  const peers::Witness found = measure(a, b);
  return found.found && found.distance <= 0;
}

struct AnyContact : btDiscreteCollisionDetectorInterface::Result {
  bool found = false;
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3&, const btVector3&, btScalar) override { found = true; }
};

bool boxes_meet(const Placed& a, const Placed& b) {
  btBoxBoxDetector detector(static_cast<const btBoxShape*>(a.shape.get()),
                            static_cast<const btBoxShape*>(b.shape.get()));
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = a.pose;
  input.m_transformB = b.pose;
  AnyContact result;
  detector.getClosestPoints(input, result, nullptr);
  return result.found;
}

}  // namespace

std::vector<peers::PairTest> peers::bullet_pairs() {
  const auto boxes = [](Kind a, Kind b) { return a == Kind::box && b == Kind::box; };
  const auto known = [](Kind a, Kind b) { return a != Kind::ellipsoid && b != Kind::ellipsoid; };
  return {pair_test("Bullet, axes of boxes", boxes, placed, boxes_meet),
          pair_test("Bullet, GJK", known, placed, meet, measure)};
}
