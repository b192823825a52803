#include "fifteen_axes.hpp"

namespace exercise {

namespace {

// How far the box extends from its centre along the direction, times the length of the direction.
double half_extent(const contact::OrientedBox<double>& box, const Eigen::Vector3d& direction) {
  //? One of the corners is farthest along the line. Of each axis and its opposite, the one leads to
  //? it that points along the line.
  //? gap: box.half_lengths[i] * std::abs(direction.dot(box.axes.col(i)))
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += box.half_lengths[i] * std::abs(direction.dot(box.axes.col(i)));
  return sum;
}

}  // namespace

double gap_along(const contact::OrientedBox<double>& first,
                 const contact::OrientedBox<double>& second, const Eigen::Vector3d& direction) {
  //? How far the centres are apart along the line, on whichever side the second box is.
  //? gap: direction.dot(second.centre - first.centre)
  const double between = std::abs(direction.dot(second.centre - first.centre));
  //? Each box takes up its part of this, and overlaps make the rest negative.
  //? gap: between - half_extent(first, direction) - half_extent(second, direction)
  const double gap = between - half_extent(first, direction) - half_extent(second, direction);
  //? All terms have been multiplied by the length of the direction.
  //? gap: gap / direction.norm()
  return gap / direction.norm();
}

LargestGap largest_gap(const contact::OrientedBox<double>& first,
                       const contact::OrientedBox<double>& second) {
  //? The normals of the faces come first.
  //? gap: box.axes.col(i)
  std::vector<Eigen::Vector3d> directions;
  for (const contact::OrientedBox<double>& box : {first, second})
    for (int i = 0; i < 3; ++i) directions.push_back(box.axes.col(i));
  //? Then come the directions that are perpendicular to an edge of each box.
  //? gap: first.axes.col(i).cross(second.axes.col(j))
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) directions.push_back(first.axes.col(i).cross(second.axes.col(j)));
  //? Boxes that overlap have negative gaps only, so the search starts without any.
  std::optional<LargestGap> largest;
  for (int axis = 0; axis < 15; ++axis) {
    const Eigen::Vector3d direction = directions[static_cast<std::size_t>(axis)];
    //? The cross product of parallel edges is zero but for rounding, and has no direction.
    //? gap: direction.isZero(1e-8)
    if (direction.isZero(1e-8)) continue;
    //? Another axis must be better by more than rounding: where edges are parallel, the other cross
    //? products repeat normals of faces.
    //? gap: gap > largest->gap + 1e-9
    const double gap = gap_along(first, second, direction);
    if (!largest || gap > largest->gap + 1e-9) largest = LargestGap{gap, axis};
  }
  return *largest;
}

}  // namespace exercise
