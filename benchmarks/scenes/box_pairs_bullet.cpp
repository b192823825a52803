// Bullet's convex casts, each on two box shapes as Bullet makes them, with its own margins.
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <btBulletCollisionCommon.h>

#include "box_pairs.hpp"

struct box_pairs::Bullet::Pairs {
  std::vector<std::unique_ptr<btBoxShape>> shapes;
  std::vector<btTransform> from;
  std::vector<btTransform> to;
};

box_pairs::Bullet::Bullet(const std::vector<MovingBox>& boxes) : pairs_(std::make_unique<Pairs>()) {
  for (const MovingBox& box : boxes) {
    const double* x = box.axes;
    const btMatrix3x3 turn(x[0], x[3], x[6], x[1], x[4], x[7], x[2], x[5], x[8]);
    const btVector3 centre(box.centre[0], box.centre[1], box.centre[2]);
    const btVector3 way(box.displacement[0], box.displacement[1], box.displacement[2]);
    pairs_->shapes.push_back(std::make_unique<btBoxShape>(
        btVector3(box.half_lengths[0], box.half_lengths[1], box.half_lengths[2])));
    pairs_->from.emplace_back(turn, centre);
    pairs_->to.emplace_back(turn, centre + way);
  }
}

box_pairs::Bullet::~Bullet() = default;

std::vector<std::optional<double>> box_pairs::Bullet::times(Cast cast) const {
  std::vector<std::optional<double>> found;
  found.reserve(pairs_->shapes.size() / 2);
  for (std::size_t k = 0; k + 1 < pairs_->shapes.size(); k += 2) {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btConvexCast::CastResult result;
    const btBoxShape* a = pairs_->shapes[k].get();
    const btBoxShape* b = pairs_->shapes[k + 1].get();
    const auto ask = [&](btConvexCast& caster) {
      return caster.calcTimeOfImpact(pairs_->from[k], pairs_->to[k], pairs_->from[k + 1],
                                     pairs_->to[k + 1], result);
    };
    bool hit = false;
    if (cast == Cast::continuous) {
      btContinuousConvexCollision caster(a, b, &simplex, &depth);
      hit = ask(caster);
    } else if (cast == Cast::gjk) {
      btGjkConvexCast caster(a, b, &simplex);
      hit = ask(caster);
    } else {
      btSubsimplexConvexCast caster(a, b, &simplex);
      hit = ask(caster);
    }
    found.push_back(hit ? std::optional<double>(result.m_fraction) : std::nullopt);
  }
  return found;
}
