#include "three_steps.hpp"

namespace exercise {

using Triangle = contact::Triangle<double>;

Plane plane_of(const Triangle& triangle) {
  //? Two edges span the plane. In this order their product points to the front.
  //? gap: (triangle.b - triangle.a).cross(triangle.c - triangle.a)
  const Eigen::Vector3d normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  //? With this offset the equation holds for a.
  //? gap: -normal.dot(triangle.a)
  return {normal, -normal.dot(triangle.a)};
}

Eigen::Vector3d distances(const Triangle& triangle, const Plane& plane) {
  //? The left side of the plane's equation, for each vertex.
  //? gap: plane.normal.dot(x) + plane.offset
  const auto distance = [&](const Eigen::Vector3d& x) {
    return plane.normal.dot(x) + plane.offset;
  };
  return {distance(triangle.a), distance(triangle.b), distance(triangle.c)};
}

bool rejects(const Eigen::Vector3d& distances) {
  //? All in front, or all behind. A zero is neither.
  //? gap: distances.minCoeff() > 0
  //? gap: distances.maxCoeff() < 0
  return distances.minCoeff() > 0 || distances.maxCoeff() < 0;
}

namespace {

// Whether the point at / over of the triangle's plane is in the triangle; `over` is positive.
bool is_in(const Eigen::Vector3d& at, double over, const Triangle& triangle) {
  const Eigen::Vector3d normal = plane_of(triangle).normal;
  //? On the inner side of an edge, or on it. The denominator is positive, so no sign changes.
  //? gap: at - over * from
  //? gap: >= 0
  const auto is_inner = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return normal.dot((to - from).cross(at - over * from)) >= 0;
  };
  //? All three edges, in one direction around the triangle.
  //? gap: is_inner(triangle.c, triangle.a)
  return is_inner(triangle.a, triangle.b) && is_inner(triangle.b, triangle.c) &&
         is_inner(triangle.c, triangle.a);
}

// Whether the border of `first` meets `second`.
bool border_meets(const Triangle& first, const Triangle& second) {
  //? The vertices of the one, each with its distance from the plane of the other.
  //? gap: plane_of(second)
  const Eigen::Vector3d d = distances(first, plane_of(second));
  const Eigen::Matrix3d u = (Eigen::Matrix3d() << first.a, first.b, first.c).finished();
  for (int i = 0; i < 3; ++i) {
    //? The edge from one vertex to the next, the last one back to the first.
    //? gap: (i + 1) % 3
    const int j = (i + 1) % 3;
    //? An edge with both ends on one side does not meet the plane. Of one in the plane, both ends
    //? are on other edges that meet it.
    //? gap: d[i] * d[j] > 0
    //? gap: d[i] == 0 && d[j] == 0
    if (d[i] * d[j] > 0 || (d[i] == 0 && d[j] == 0)) continue;
    //? The nearer an end is to the plane, the more it weighs: with the other end's distance.
    //? gap: std::abs(d[j])
    const double of_i = std::abs(d[j]);
    const double of_j = std::abs(d[i]);
    //? The point is the weighted mean, here without the division.
    //? gap: of_i * u.col(i) + of_j * u.col(j)
    //? gap: of_i + of_j
    if (is_in(of_i * u.col(i) + of_j * u.col(j), of_i + of_j, second)) return true;
  }
  return false;
}

}  // namespace

bool triangles_meet(const Triangle& first, const Triangle& second) {
  //? Step 2, for the vertices of each and the plane of the other.
  //? gap: rejects(distances(first, plane_of(second)))
  if (rejects(distances(first, plane_of(second))) || rejects(distances(second, plane_of(first))))
    return false;
  //? Either p or q is in the second triangle, or pq crosses an edge of the second triangle, which
  //? meets the plane of the first one there.
  //? gap: border_meets(second, first)
  return border_meets(first, second) || border_meets(second, first);
}

}  // namespace exercise
