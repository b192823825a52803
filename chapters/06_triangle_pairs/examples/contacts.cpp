// What some pairs of triangles have in common, and which features are in contact when a body that
// moves first touches another: random bodies, and bodies on a grid.
#include <algorithm>
#include <contact/feature_contacts.hpp>
#include <cstdio>
#include <random>
#include <string>

using namespace contact;

std::string name(const Feature& feature) {
  if (feature.kind == FeatureKind::face) return "face";
  const char* kind = feature.kind == FeatureKind::edge ? "edge " : "vertex ";
  return kind + std::to_string(feature.index);
}

void print(const char* what, const Triangle<double>& first, const Triangle<double>& second) {
  // [common-points]
  const TriangleIntersection<double> common = intersect_triangles(first, second);
  for (int i = 0; i < common.count; ++i) {
    const CommonPoint<double>& point = common.points[static_cast<std::size_t>(i)];
    const Vector3<double>& x = point.position;
    std::printf("%-15s  (%5.3f, %5.3f, %5.3f)  %6.1g  %-8s  %s\n", i == 0 ? what : "", x.x(), x.y(),
                x.z(), common.bound, name(point.of_first).c_str(), name(point.of_second).c_str());
  }
  // [/common-points]
}

Mesh<double> tetrahedron(const Vector3<double>& at, auto& coordinate) {
  Mesh<double> mesh;
  for (int i = 0; i < 4; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    mesh.vertices.push_back(at + Vector3<double>(x, y, z));
  }
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

struct Counts {
  int kinds[6] = {};
  int point_face_or_edge_edge = 0;
};

// Counts the kinds of contact of 10,000 first contacts of two tetrahedra.
Counts count(auto coordinate) {
  Counts counts;
  for (int n = 0; n < 10000;) {
    const Mesh<double> moving = tetrahedron({-6, 0, 0}, coordinate);
    const Mesh<double> resting = tetrahedron({0, 0, 0}, coordinate);
    // [first]
    const auto first = first_contact(moving, {12, 0, 0}, resting);
    if (!first) continue;  // it moves past
    ++n;
    for (int kind = 0; kind < 6; ++kind) {
      counts.kinds[kind] += std::any_of(first->contacts.begin(), first->contacts.end(),
                                        [&](auto& c) { return static_cast<int>(c.kind) == kind; });
    }
    // An edge with its ends, a face with its border.
    if (!first->realised_by.empty()) ++counts.point_face_or_edge_edge;
    // [/first]
  }
  return counts;
}

int main() {
  std::printf("%-15s  %-21s  %6s  %-8s  %s\n", "", "position (m)", "bound", "first", "second");
  const Triangle<double> floor{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  print("crossing", floor, {{1, 1, -1}, {1, 1, 2}, {5, 1, 1}});
  print("touching", floor, {{2, 1, 0}, {2, 1, 2}, {5, 1, 1}});
  print("coplanar", floor, {{2, 2, 0}, {-1, 2, 0}, {2, -1, 0}});
  // Six points of one plane, rounded.
  const auto in_plane = [](double x, double y) { return Vector3<double>(x, y, 0.3 * x + 0.5 * y); };
  print("nearly coplanar", {in_plane(0, 0), in_plane(0.9, 0.2), in_plane(0.3, 0.8)},
        {in_plane(0.2, 0.1), in_plane(0.8, 0.7), in_plane(0.1, 0.6)});

  std::mt19937_64 bits(1);
  const Counts random = count([&bits] { return static_cast<double>(bits() >> 11) * 0x1p-51 - 2; });
  const Counts grid = count([&bits] { return static_cast<double>(bits() % 5) - 2; });
  std::printf("\n10,000 first contacts: in how many occurs  random bodies  on a grid\n");
  const char* names[] = {"point-point", "point-edge", "point-face",
                         "edge-edge",   "edge-face",  "face-face"};
  for (int i = 0; i < 6; ++i) {
    std::printf("%-41s  %13d  %9d\n", names[i], random.kinds[i], grid.kinds[i]);
  }
  std::printf("%-41s  %13d  %9d\n", "point-face or edge-edge, with borders",
              random.point_face_or_edge_edge, grid.point_face_or_edge_edge);
}
