#include "delta_matrix.hpp"

namespace exercise {
namespace {

// The inverse of a rigid matrix: that of x' = R x + t is x = Rᵀ x' − Rᵀ t.
Eigen::Matrix4d inverse(const Eigen::Matrix4d& pose) {
  const Eigen::Matrix3d back = pose.topLeftCorner<3, 3>().transpose();
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.topLeftCorner<3, 3>() = back;
  result.topRightCorner<3, 1>() = -back * pose.topRightCorner<3, 1>();
  return result;
}

// The angle of the rotation between the two orientations: from sine and cosine, so that small
// angles are accurate.
double angle(const Motion& body) {
  const Eigen::Matrix3d r =
      body.after.topLeftCorner<3, 3>() * body.before.topLeftCorner<3, 3>().transpose();
  const Eigen::Vector3d twice_sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  return std::atan2(twice_sine.norm(), r.trace() - 1);
}

}  // namespace

Eigen::Matrix4d delta_matrix(const Motion& body) { return body.after * inverse(body.before); }

contact::Segment<double> segment_seen(const Motion& a, const Motion& b,
                                      const Eigen::Vector3d& vertex) {
  const Eigen::Vector4d point = vertex.homogeneous();
  const Eigen::Vector4d start = inverse(b.before) * (a.before * point);
  const Eigen::Vector4d end = inverse(b.after) * (a.after * point);
  return {start.head<3>(), end.head<3>()};
}

double chord_bound(const Motion& a, const Motion& b, const Eigen::Vector3d& vertex) {
  const double alpha = angle(a), beta = angle(b);
  const Eigen::Vector4d origins =
      (a.after - a.before).rightCols<1>() - (b.after - b.before).rightCols<1>();
  const double own = alpha * alpha * vertex.norm();
  const double speed = origins.norm() + alpha * vertex.norm();
  // A rigid matrix keeps distances: that from B's origin can be taken in B's frame.
  const contact::Segment<double> seen = segment_seen(a, b, vertex);
  const double distance = std::max(seen.start.norm(), seen.end.norm()) + own / 8;
  return (own + 2 * beta * speed + beta * beta * distance) / 8;
}

}  // namespace exercise
