#include "first_any_all.hpp"

namespace exercise {
namespace {

// Where the segment meets triangle i of the mesh, edges and vertices included: the method of Möller
// and Trumbore. You may use it.
[[maybe_unused]] std::optional<double> meet(const contact::Segment<double>& segment,
                                            const contact::Mesh<double>& mesh, std::size_t i) {
  const contact::Triangle<double> triangle = contact::triangle_of(mesh, i);
  const Eigen::Vector3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
  const Eigen::Vector3d d = segment.end - segment.start, p = d.cross(e2);
  const double det = e1.dot(p);
  if (det == 0) return std::nullopt;
  const Eigen::Vector3d s = segment.start - triangle.a, q = s.cross(e1);
  const double beta = s.dot(p) / det, gamma = d.dot(q) / det, t = e2.dot(q) / det;
  if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  return t;
}

}  // namespace

std::optional<Hit> first_hit(const contact::Segment<double>& /*segment*/,
                             const contact::Mesh<double>& /*mesh*/) {
  contact::todo();
}

bool any_hit(const contact::Segment<double>& /*segment*/, const contact::Mesh<double>& /*mesh*/) {
  contact::todo();
}

std::vector<Hit> all_hits(const contact::Segment<double>& /*segment*/,
                          const contact::Mesh<double>& /*mesh*/) {
  contact::todo();
}

}  // namespace exercise
