// FCL's continuous collision: by tests at the ends of slices, which is its default, and by
// conservative advancement with libccd's GJK.
#include <fcl/fcl.h>

#include "peers.hpp"

namespace {

using peers::Box;

fcl::Vector3d vector(const peers::Numbers& v) { return {v[0], v[1], v[2]}; }

struct Moving {
  std::shared_ptr<fcl::ShapeBased> shape;
  fcl::Transform3d from, to;
};

fcl::Transform3d pose(const peers::Numbers& centre, const std::array<peers::Numbers, 3>& axes) {
  fcl::Transform3d made = fcl::Transform3d::Identity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    made.linear().col(i) = vector(axes[static_cast<std::size_t>(i)]);
  }
  made.translation() = vector(centre);
  return made;
}
Moving moving(const Box& box) {
  const peers::Numbers& h = box.half_lengths;
  peers::Numbers end = box.centre;
  for (std::size_t k = 0; k < 3; ++k) end[k] += box.displacement[k];
  return {std::make_shared<fcl::Boxd>(2 * h[0], 2 * h[1], 2 * h[2]), pose(box.centre, box.axes),
          pose(end, box.end_axes)};
}

Moving moving_body(const peers::Body& body) {
  const peers::Numbers& h = body.half_lengths;
  std::shared_ptr<fcl::ShapeBased> shape;
  switch (body.kind) {
    case peers::Kind::sphere:
      shape = std::make_shared<fcl::Sphered>(body.radius);
      break;
    case peers::Kind::capsule:
      shape = std::make_shared<fcl::Capsuled>(body.radius, 2 * h[2]);
      break;
    case peers::Kind::box:
      shape = std::make_shared<fcl::Boxd>(2 * h[0], 2 * h[1], 2 * h[2]);
      break;
    default:  // it has no collision of a triangle with a box, and its hulls need faces
      return {};
  }
  peers::Numbers end = body.centre;
  for (std::size_t k = 0; k < 3; ++k) end[k] += body.displacement[k];
  return {shape, pose(body.centre, body.axes), pose(end, body.axes)};
}

auto by(fcl::CCDSolverType solver, fcl::CCDMotionType motion) {
  return [solver, motion](const Moving& a, const Moving& b) {
    // Slices or advances, and the error of the time: those of the class are 10 and 1e-4.
    const fcl::ContinuousCollisionRequestd request(10, 1e-4, motion, fcl::GST_LIBCCD, solver);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(a.shape.get(), a.from, a.to, b.shape.get(), b.from, b.to, request,
                           result);
    return peers::Answer{result.is_collide, result.time_of_contact, false};
  };
}

}  // namespace

std::vector<peers::Caster> peers::fcl_casters() {
  const auto caster = [](const char* name, fcl::CCDSolverType solver, fcl::CCDMotionType motion,
                         bool turns) {
    return Caster{name, turns, false, Motion::constant_rate, asking(moving, by(solver, motion))};
  };
  return {caster("FCL, advancement, translation", fcl::CCDC_CONSERVATIVE_ADVANCEMENT,
                 fcl::CCDM_TRANS, false),
          caster("FCL, advancement", fcl::CCDC_CONSERVATIVE_ADVANCEMENT, fcl::CCDM_LINEAR, true),
          caster("FCL, ten slices, its default", fcl::CCDC_NAIVE, fcl::CCDM_LINEAR, true)};
}

std::vector<peers::BodyCaster> peers::fcl_body_casters() {
  const auto known = [](Kind kind) { return kind != Kind::triangle && kind != Kind::hull; };
  return {{"FCL, advancement, translation", known,
           asking(moving_body, by(fcl::CCDC_CONSERVATIVE_ADVANCEMENT, fcl::CCDM_TRANS))},
          {"FCL, ten slices, its default", known,
           asking(moving_body, by(fcl::CCDC_NAIVE, fcl::CCDM_TRANS))}};
}
