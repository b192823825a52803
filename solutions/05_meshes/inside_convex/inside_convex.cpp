#include "inside_convex.hpp"

namespace exercise {

Eigen::Vector3d outward_normal(const contact::Triangle<double>& face) {
  //? Two edges from one vertex span the plane. In this order their product points to where the
  //? vertices are counter-clockwise.
  //? gap: face.b - face.a
  //? gap: face.c - face.a
  return (face.b - face.a).cross(face.c - face.a);
}

double ahead(const Eigen::Vector3d& point, const contact::Triangle<double>& face) {
  //? From any point of the plane to the point.
  //? gap: point - face.a
  return outward_normal(face).dot(point - face.a);
}

Where inside_convex(const contact::Mesh<double>& mesh, const Eigen::Vector3d& point) {
  //? Whether the point is in the plane of a face.
  bool in_a_plane = false;
  //? All faces must be asked.
  //? gap: i < mesh.triangles.size()
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const contact::Triangle<double> face = contact::triangle_of(mesh, i);
    //? A triangle without area has no plane.
    //? gap: outward_normal(face).isZero(0)
    if (outward_normal(face).isZero(0)) continue;
    //? In front of one face is outside, whatever the others say.
    //? gap: product > 0
    const double product = ahead(point, face);
    if (product > 0) return Where::outside;
    //? In a plane, but perhaps beside the face.
    //? gap: product == 0
    if (product == 0) in_a_plane = true;
  }
  //? Only here it is known that the point is in front of no face. In the plane of one, it is on it.
  //? gap: in_a_plane ? Where::on : Where::inside
  return in_a_plane ? Where::on : Where::inside;
}

}  // namespace exercise
