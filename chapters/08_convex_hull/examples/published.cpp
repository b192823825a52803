// Published reports of wrong hulls, recomputed: each in the types in which its numbers may be read.
#include <contact/convex_hull.hpp>
#include <contact/hull_2d.hpp>
#include <cstdio>
#include <vector>

template <class S>
void bullet_262(const char* type) {
  const S diagonal = static_cast<S>(1.414213562373095);
  const std::vector<contact::Vector3<S>> stored{
      {2, static_cast<S>(3.535533905932738), static_cast<S>(3.535533905932737)},
      {4, 2, 0},
      {0, 2, 0},
      {1, 0, 0},
      {4, diagonal, diagonal},
      {0, diagonal, diagonal},
      {3, 0, 0},
      {2, 5, 0}};
  std::vector<contact::Vector3<double>> points;
  for (const auto& p : stored) points.push_back(p.template cast<double>());
  const contact::Hull hull = contact::convex_hull(points);
  std::printf("Bullet 262, as %s: %zu vertices, %zu triangles, %d faces\n", type,
              hull.vertices.size(), contact::triangles(hull).size(), hull.face_count());
}

template <class S>
void box2d_296(const char* type) {
  const std::vector<contact::Vector2<S>> stored{
      {static_cast<S>(-1.70082211), static_cast<S>(-1.43221712)},
      {static_cast<S>(0.5), static_cast<S>(-0.5)},
      {static_cast<S>(0.104992867), static_cast<S>(0.97400856)},
      {static_cast<S>(-0.658002853), static_cast<S>(0.926608086)},
      {static_cast<S>(-0.994554818), static_cast<S>(0.165337861)}};
  std::vector<contact::Vector2<double>> points;
  for (const auto& p : stored) points.push_back(p.template cast<double>());
  const double orientation = contact::orientation(points[3], points[4], points[0]);
  std::printf("Box2D 296, as %s: cross product %.1e, %zu vertices\n", type, orientation,
              contact::convex_hull_2d(points).size());
}

int main() {
  bullet_262<float>("float");
  bullet_262<double>("double");
  box2d_296<float>("float");
  box2d_296<double>("double");
}
