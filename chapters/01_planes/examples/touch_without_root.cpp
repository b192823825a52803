// Spheres that touch exactly: with a rounded unit normal the test fails for some, the squared form
// with whole numbers is exact.
#include <contact/plane.hpp>
#include <contact/sphere_plane.hpp>
#include <cstdio>

int main() {
  using V = contact::Vector3<double>;
  int touching = 0;
  int by_unit_plane = 0;
  int by_squares = 0;
  for (int times = 1; times <= 300; ++times) {
    // (1, 4, 8) is normal to the plane and 9 long, so the centre is exactly 9 · times away.
    const V a(1, 2, 3);
    const V b = a + V(4, -1, 0);
    const V c = a + V(0, 2, -1);
    const contact::Sphere<double> sphere{a + times * V(1, 4, 8), 9.0 * times};
    touching += contact::sphere_meets_plane_exactly(sphere, a, b, c);
    by_unit_plane += contact::sphere_meets_plane(sphere, contact::plane_from_points(a, b, c));
    by_squares += contact::sphere_meets_plane(sphere, contact::raw_plane_from_points(a, b, c));
  }
  std::printf("touching: %d, found with the unit normal: %d, by the squared form: %d\n", touching,
              by_unit_plane, by_squares);
}
