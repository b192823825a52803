// Inertia tensors: simple shapes, a composite body, a mesh, and a rotated plank.
#include <array>
#include <contact/inertia.hpp>
#include <cstdio>

using V = contact::Vector3<double>;
using M = contact::Matrix3<double>;

void print(const char* what, const M& i) {
  std::printf("%-24s %8.4f %8.4f %8.4f\n", what, i(0, 0), i(1, 1), i(2, 2));
}

int main() {
  std::printf("6 kg each, kg m^2         about x  about y  about z\n");
  print("sphere, r = 0.5", contact::sphere_inertia<double>(6, 0.5));
  print("box, 1 x 2 x 3", contact::box_inertia<double>(6, {1, 2, 3}));
  print("cylinder, r = 0.5, h = 2", contact::cylinder_inertia<double>(6, 0.5, 2));
  print("capsule, r = 0.5, h = 2", contact::capsule_inertia<double>(6, 0.5, 2));

  // A rod about its middle and about its end: four times as much.
  const M rod = contact::box_inertia<double>(3, {2, 0.02, 0.02});
  const M end = rod + contact::parallel_axis<double>(3, V(1, 0, 0));
  std::printf("rod of 3 kg and 2 m: %.4f about its middle, %.4f about its end\n", rod(2, 2),
              end(2, 2));

  // A hammer: a handle, and a head perpendicular to it at its end.
  const contact::MassProperties<double> handle{1, V(0, 0, 0),
                                               contact::box_inertia<double>(1, {1, 0.04, 0.04})};
  const contact::MassProperties<double> head{2, V(0.5, 0, 0),
                                             contact::box_inertia<double>(2, {0.1, 0.3, 0.1})};
  const auto hammer = *contact::combine<double>({handle, head});
  std::printf("hammer: %g kg, centre of mass at %.4f m, %.4f kg m^2 about z\n", hammer.mass,
              hammer.centre.x(), hammer.inertia(2, 2));

  // A tetrahedron as a mesh, at the origin and a thousand kilometres away.
  const std::vector<V> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<contact::VertexIndices> faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const auto near = *contact::mesh_mass<double>(6, corners, faces);
  std::vector<V> moved;
  for (const V& corner : corners) moved.push_back(corner + V(1e6, 1e6, 1e6));
  const auto far = *contact::mesh_mass<double>(6, moved, faces);
  const auto naive = contact::detail::moments_about<double>(V(0, 0, 0), moved, faces);
  const V centre = naive.first / naive.volume;
  const M second = 6 * (naive.second - centre * centre.transpose() * naive.volume);
  std::printf("tetrahedron: %.6f about x (3/40 = %.6f)\n", near.inertia(0, 0), 3.0 / 40);
  std::printf("  a thousand kilometres away: %.6f; summed about the origin: %.1e\n",
              far.inertia(0, 0), second(1, 1) + second(2, 2));

  // A rotated plank: products of inertia appear.
  M turn;
  turn << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  const M plank = contact::rotated<double>(contact::box_inertia<double>(6, {2, 0.2, 0.1}), turn);
  std::printf("plank rotated about z: %.4f %.4f %.4f in its first row\n", plank(0, 0), plank(0, 1),
              plank(0, 2));
  const auto axes = contact::principal_axes<double>(plank);
  std::printf("  its principal moments: %.4f %.4f %.4f\n", axes.moments.x(), axes.moments.y(),
              axes.moments.z());
}
