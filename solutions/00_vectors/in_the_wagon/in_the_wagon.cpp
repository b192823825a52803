#include "in_the_wagon.hpp"

namespace exercise {

Eigen::Vector2d position_in_wagon(const Wagon& wagon, const Eigen::Vector2d& position) {
  //? A position counts from the wagon's origin; what remains is a vector, and changes its frame
  //? like a velocity.
  //? gap: position - wagon.position
  return velocity_in_wagon(wagon, position - wagon.position);
}

Eigen::Vector2d velocity_in_wagon(const Wagon& wagon, const Eigen::Vector2d& velocity) {
  //? The wagon's second axis is its first, rotated by 90° counterclockwise: (x, y) becomes (−y, x).
  //? gap: -wagon.forward.y(), wagon.forward.x()
  const Eigen::Vector2d left(-wagon.forward.y(), wagon.forward.x());
  //? The axes have length 1 and are orthogonal, so each coordinate is one dot product.
  //? gap: left.dot(velocity)
  return {wagon.forward.dot(velocity), left.dot(velocity)};
}

Eigen::Vector2d position_in_world(const Wagon& wagon, const Eigen::Vector2d& position_in_wagon) {
  //? The way back needs the same two axes.
  const Eigen::Vector2d left(-wagon.forward.y(), wagon.forward.x());
  //? The coordinates say how far to go along each axis, from the origin of the wagon.
  //? gap: position_in_wagon.x() * wagon.forward
  return wagon.position + position_in_wagon.x() * wagon.forward + position_in_wagon.y() * left;
}

}  // namespace exercise
