#include "fit_box.hpp"

namespace exercise {

contact::OrientedBox<double> fit_box(const Eigen::Matrix3d& axes,
                                     const std::vector<Eigen::Vector3d>& vertices) {
  //? The coordinate of a vertex along an axis is the dot product with it. The rows of the transpose
  //? are the axes. The search begins with the first vertex.
  //? gap: axes.transpose() * vertices[0]
  Eigen::Vector3d low = axes.transpose() * vertices[0], high = low;
  //? In these coordinates the box is axis-aligned: the smallest and the largest coordinate along
  //? each axis.
  //? gap: axes.transpose() * vertex
  //? gap: high.cwiseMax(along)
  for (const Eigen::Vector3d& vertex : vertices) {
    const Eigen::Vector3d along = axes.transpose() * vertex;
    low = low.cwiseMin(along);
    high = high.cwiseMax(along);
  }
  //? The centre is in the middle, back in the world.
  //? gap: axes * (low + high) / 2
  const Eigen::Vector3d centre = axes * (low + high) / 2;
  //? The centre is rounded. Around it as it is, the farthest vertex along each axis counts.
  //? gap: axes.transpose() * (vertex - centre)
  Eigen::Vector3d half_lengths = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : vertices) {
    const Eigen::Vector3d along = axes.transpose() * (vertex - centre);
    half_lengths = half_lengths.cwiseMax(along.cwiseAbs());
  }
  //? A difference of coordinates is at most 4000, so it is rounded by less than 3e-13. Three of
  //? them, three products and two sums change a coordinate along an axis by less than 5e-12.
  //? gap: half_lengths.array() + 1e-11
  half_lengths = half_lengths.array() + 1e-11;
  return {centre, axes, half_lengths};
}

std::array<contact::Plane<double>, 6> face_planes(const contact::OrientedBox<double>& box) {
  //? Two faces for each axis.
  //? gap: box.axes.col(axis)
  std::array<contact::Plane<double>, 6> planes;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d normal = box.axes.col(axis);
    const double half_length = box.half_lengths[axis];
    //? An offset is the dot product of the normal with a point of the face, as centre + half length
    //? times normal is one.
    //? gap: normal.dot(box.centre) + half_length
    const auto first = static_cast<std::size_t>(2 * axis);
    planes[first] = {normal, normal.dot(box.centre) + half_length};
    //? The normal of the opposite face is reversed, and the half length is again on its side.
    //? gap: -normal.dot(box.centre) + half_length
    planes[first + 1] = {-normal, -normal.dot(box.centre) + half_length};
  }
  //? In the order of the axes.
  return planes;
}

bool is_inside(const contact::OrientedBox<double>& box, const Eigen::Vector3d& point) {
  //? Inside of a box is behind each of its faces or on it.
  //? gap: plane.normal.dot(point) > plane.offset
  for (const contact::Plane<double>& plane : face_planes(box))
    if (plane.normal.dot(point) > plane.offset) return false;
  //? No face has the point in front of it.
  return true;
}

}  // namespace exercise
