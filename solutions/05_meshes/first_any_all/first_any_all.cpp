#include "first_any_all.hpp"

namespace exercise {
namespace {

// Where the segment meets triangle i of the mesh, edges and vertices included: the method of Möller
// and Trumbore.
std::optional<double> meet(const contact::Segment<double>& segment,
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

std::optional<Hit> first_hit(const contact::Segment<double>& segment,
                             const contact::Mesh<double>& mesh) {
  //? The nearest so far. Of equals the earlier one stays, which is the one with the lowest index.
  //? gap: !first || *t < first->t
  std::optional<Hit> first;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::optional<double> t = meet(segment, mesh, i);
    if (t && (!first || *t < first->t)) first = Hit{static_cast<int>(i), *t};
  }
  return first;
}

bool any_hit(const contact::Segment<double>& segment, const contact::Mesh<double>& mesh) {
  //? One triangle is enough, whichever it is: the others need not be asked.
  //? gap: meet(segment, mesh, i)
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (meet(segment, mesh, i)) return true;
  }
  return false;
}

std::vector<Hit> all_hits(const contact::Segment<double>& segment,
                          const contact::Mesh<double>& mesh) {
  //? Each triangle that the segment meets, in the order of the list.
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (const auto t = meet(segment, mesh, i)) hits.push_back({static_cast<int>(i), *t});
  }
  //? In the order along the segment. A stable sort leaves equals in the order of their triangles.
  //? gap: x.t < y.t
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& x, const Hit& y) { return x.t < y.t; });
  //? The same t is the same point, on an edge or at a vertex. Equals are neighbours now, and the
  //? first of them stays.
  //? gap: x.t == y.t
  const auto last =
      std::unique(hits.begin(), hits.end(), [](const Hit& x, const Hit& y) { return x.t == y.t; });
  hits.erase(last, hits.end());
  return hits;
}

}  // namespace exercise
