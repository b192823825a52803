#include "grow_sphere.hpp"

namespace exercise {

ExtremePair most_distant_extremes(const std::vector<Eigen::Vector3d>& points) {
  //? The best pair so far is one point, and replaced by any pair of two points.
  //? gap: int axis = 0; axis < 3
  std::size_t low_of_all = 0, high_of_all = 0;
  for (int axis = 0; axis < 3; ++axis) {
    //? The search begins with the first point, not with a number. A strict comparison keeps the
    //? first of equal ones.
    //? gap: points[i][axis] < points[low][axis]
    //? gap: points[i][axis] > points[high][axis]
    std::size_t low = 0, high = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i][axis] < points[low][axis]) low = i;
      if (points[i][axis] > points[high][axis]) high = i;
    }
    //? What counts is the distance of the two points in space. Its square is as good, and exact.
    //? gap: (points[high] - points[low]).squaredNorm()
    const double distance = (points[high] - points[low]).squaredNorm();
    //? This pair replaces the best one so far, but not if the distances are equal.
    //? gap: distance > (points[high_of_all] - points[low_of_all]).squaredNorm()
    if (distance > (points[high_of_all] - points[low_of_all]).squaredNorm()) {
      low_of_all = low;
      high_of_all = high;
    }
  }
  //? The pair that remained, by index.
  return {static_cast<int>(low_of_all), static_cast<int>(high_of_all)};
}

contact::Sphere<double> start_sphere(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  //? The two points are the ends of a diameter.
  //? gap: (low + high) / 2
  //? gap: (high - low).norm() / 2
  return {(low + high) / 2, (high - low).norm() / 2};
}

contact::Sphere<double> grown_by(const contact::Sphere<double>& sphere,
                                 const Eigen::Vector3d& point) {
  //? A point inside changes nothing. After this, the distance is not 0.
  //? gap: distance <= sphere.radius
  const double distance = (point - sphere.centre).norm();
  if (distance <= sphere.radius) return sphere;
  //? The new diameter goes from the point through the centre to the far side of the old sphere.
  //? gap: (sphere.radius + distance) / 2
  const double radius = (sphere.radius + distance) / 2;
  //? The far side stays where it is, so the centre moves towards the point by as much as the radius
  //? grows.
  //? gap: (radius - sphere.radius) / distance
  return {sphere.centre + (radius - sphere.radius) / distance * (point - sphere.centre), radius};
}

contact::Sphere<double> grow_sphere(const std::vector<Eigen::Vector3d>& points) {
  //? The start: two points that are certainly far from each other.
  //? gap: most_distant_extremes(points)
  const auto [low, high] = most_distant_extremes(points);
  contact::Sphere<double> sphere =
      start_sphere(points[static_cast<std::size_t>(low)], points[static_cast<std::size_t>(high)]);
  //? Each point in order. The sphere so far stays inside, so that no earlier point is lost.
  //? gap: sphere = grown_by(sphere, point)
  for (const Eigen::Vector3d& point : points) sphere = grown_by(sphere, point);
  //? That holds without rounding. Rounding has moved the centre, so the radius is computed again,
  //? from the centre as it is.
  //? gap: std::max(radius, (point - sphere.centre).norm())
  double radius = 0;
  for (const Eigen::Vector3d& point : points)
    radius = std::max(radius, (point - sphere.centre).norm());
  //? A computed distance may be smaller than the true one, by a factor of at most 1 - 4 u, with u
  //? about 1.1e-16: the differences, the squares, the sums and the root are each rounded once. A
  //? factor of 1 + 9 u makes up for that and for the rounding of this product.
  //? gap: radius * (1 + 1e-15)
  return {sphere.centre, radius * (1 + 1e-15)};
}

}  // namespace exercise
