// Bullet's convex casts, each on two shapes as Bullet makes them, with its own margins. Those of a
// triangle and of a hull are set to 0, or to the hull's radius, because they would make it larger.
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <btBulletCollisionCommon.h>

#include "peers.hpp"

namespace {

using peers::Box;

btVector3 vector(const peers::Numbers& p) { return {p[0], p[1], p[2]}; }

struct Moving {
  std::shared_ptr<btConvexShape> shape;
  btTransform from, to;
};

btTransform pose(const btVector3& centre, const std::array<peers::Numbers, 3>& x) {
  const btMatrix3x3 turn(x[0][0], x[1][0], x[2][0], x[0][1], x[1][1], x[2][1], x[0][2], x[1][2],
                         x[2][2]);
  return btTransform(turn, centre);
}
Moving moving(const Box& box) {
  const btVector3 centre = vector(box.centre);
  return {std::make_shared<btBoxShape>(vector(box.half_lengths)), pose(centre, box.axes),
          pose(centre + vector(box.displacement), box.end_axes)};
}

std::shared_ptr<btConvexShape> shape_of(const peers::Body& body) {
  const peers::Numbers& h = body.half_lengths;
  switch (body.kind) {
    case peers::Kind::sphere:
      return std::make_shared<btSphereShape>(body.radius);
    case peers::Kind::capsule:
      return std::make_shared<btCapsuleShapeZ>(body.radius, 2 * h[2]);
    case peers::Kind::box:
      return std::make_shared<btBoxShape>(vector(h));
    case peers::Kind::triangle: {
      auto made = std::make_shared<btTriangleShape>(vector(body.points[0]), vector(body.points[1]),
                                                    vector(body.points[2]));
      made->setMargin(0);
      return made;
    }
    default: {
      auto made = std::make_shared<btConvexHullShape>();
      for (const auto& p : body.points) made->addPoint(vector(p), false);
      made->setMargin(body.radius);
      made->recalcLocalAabb();
      return made;
    }
  }
}
Moving moving_body(const peers::Body& body) {
  const btVector3 centre = vector(body.centre);
  return {shape_of(body), pose(centre, body.axes),
          pose(centre + vector(body.displacement), body.axes)};
}

template <class Ask>
peers::Answer answer_of(const Moving& a, const Moving& b, Ask ask) {
  btConvexCast::CastResult result;
  const auto cast = [&](btConvexCast& caster) {
    return caster.calcTimeOfImpact(a.from, a.to, b.from, b.to, result);
  };
  const bool hit = ask(cast);
  return {hit, result.m_fraction, false};
}
peers::Answer continuous(const Moving& a, const Moving& b) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btContinuousConvexCollision caster(a.shape.get(), b.shape.get(), &simplex, &depth);
  return answer_of(a, b, [&](const auto& cast) { return cast(caster); });
}
peers::Answer gjk(const Moving& a, const Moving& b) {
  btVoronoiSimplexSolver simplex;
  btGjkConvexCast caster(a.shape.get(), b.shape.get(), &simplex);
  return answer_of(a, b, [&](const auto& cast) { return cast(caster); });
}
peers::Answer subsimplex(const Moving& a, const Moving& b) {
  btVoronoiSimplexSolver simplex;
  btSubsimplexConvexCast caster(a.shape.get(), b.shape.get(), &simplex);
  return answer_of(a, b, [&](const auto& cast) { return cast(caster); });
}

}  // namespace

std::vector<peers::Caster> peers::bullet_casters() {
  return {{"Bullet, btContinuousConvexCollision", true, false, Motion::constant_rate,
           asking(moving, continuous)},
          {"Bullet, btGjkConvexCast", false, false, Motion::constant_rate, asking(moving, gjk)},
          {"Bullet, btSubsimplexConvexCast", false, false, Motion::constant_rate,
           asking(moving, subsimplex)}};
}

std::vector<peers::BodyCaster> peers::bullet_body_casters() {
  const auto all = [](Kind) { return true; };
  return {{"Bullet, btContinuousConvexCollision", all, asking(moving_body, continuous)},
          {"Bullet, btGjkConvexCast", all, asking(moving_body, gjk)},
          {"Bullet, btSubsimplexConvexCast", all, asking(moving_body, subsimplex)}};
}
