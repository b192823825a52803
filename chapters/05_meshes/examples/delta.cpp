// A body that moves and turns a quarter of a turn: the delta matrix for columns and for rows, a
// plate that the chord hits and the path does not, and what substeps and the certified answer say.
#include <cmath>
#include <contact/mesh_shapes.hpp>
#include <contact/moving_mesh_certified.hpp>
#include <cstdio>

using namespace contact;

void print(const char* name, const Vector3<double>& v) {
  std::printf("%-22s (%g, %g, %g)\n", name, v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

int main() {
  // [delta]
  CoordinateFrame<double> pose0, pose1;
  pose0.origin = {1, 0, 0};
  pose1.origin = {2, 1, 0};
  pose1.axes << 0, -1, 0,  //
      1, 0, 0,             //
      0, 0, 1;
  const Matrix4<double> m0 = homogeneous_matrix(pose0), m1 = homogeneous_matrix(pose1);
  const Vector3<double> a(2, 0, 0);  // one metre from the body's origin, on its x axis

  print("columns, M1 M0^-1", carried_column<double>(delta_matrix<double>(m0, m1), a));
  print("rows, M0^-1 M1",
        carried_row<double>(a, delta_matrix_rows<double>(m0.transpose(), m1.transpose())));
  print("in the body's frame", carried_in_body<double>(pose0, pose1, a));
  print("columns, M0^-1 M1", carried_column<double>(inverse_of_frame_matrix<double>(m0) * m1, a));
  // [/delta]

  // A quarter turn about the z axis, a point at rest two metres from it, and a plate half-way.
  RigidMotion<double> motion;
  motion.rotation = {0, 0, 1.5707963267948966};
  const Segment<double> point{{2, 0, 0}, {2, 0, 0}};
  const CoordinateFrame<double> half_way = frame_at(motion, -0.5);
  const auto plate = [&half_way](double from, double to) {
    return transformed(box_mesh({from, -0.1, -0.1}, {to, 0.1, 0.1}), half_way);
  };
  const Mesh<double> inner = plate(1.2, 1.6), outer = plate(1.9, 2.1);

  std::printf("\nchords  bound (m)  off by (m)  inner plate  outer plate\n");
  for (const int n : {1, 2, 4, 8, 16}) {
    const Vector3<double> from = path_in_body(motion, point, 0.0);
    const Vector3<double> to = path_in_body(motion, point, 1.0 / n);
    const Vector3<double> off = path_in_body(motion, point, 0.5 / n) - (from + to) / 2;
    std::printf("%6d  %9.5f  %10.5f  %-11s  %s\n", n, chord_bound(motion, point, n),
                std::sqrt(off.dot(off)), moving_by_substeps(point, inner, motion, n) ? "hit" : "no",
                moving_by_substeps(point, outer, motion, n) ? "hit" : "no");
  }

  // [certified]
  for (const Mesh<double>* mesh : {&inner, &outer}) {
    const MotionAnswer answer = certified_moving_hit(point, *mesh, motion);
    std::printf("%s plate: ", mesh == &inner ? "inner" : "outer");
    switch (answer.verdict) {
      case MotionVerdict::free:
        std::printf("no contact, proved with %d chords\n", answer.chords);
        break;
      case MotionVerdict::hit:
        std::printf("first contact between %.7f and %.7f of the step, proved with %d chords\n",
                    answer.from, answer.to, answer.chords);
        break;
      case MotionVerdict::undecided:
        std::printf("undecided after %d chords\n", answer.chords);
    }
  }
  // [/certified]
}
