/// @file
/// The hard cases of moving meshes, notches and convex pieces: questions and methods.
#pragma once

#include <05_meshes/hard_mesh.hpp>
#include <05_meshes/moving_truth.hpp>
#include <05_meshes/solid_truth.hpp>
#include <cmath>
#include <contact/convex_pieces.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/moving_mesh_certified.hpp>
#include <optional>
#include <string>
#include <support/hard_cases.hpp>
#include <vector>

namespace hard_moving {

using contact::CoordinateFrame;
using contact::Mesh;
using contact::MotionVerdict;
using contact::RigidMotion;
using contact::Segment;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_mesh::mesh_in;
using hard_mesh::mesh_of;
using oracle::Rational;

// ---------------------------------------------------------------- input

/// The pose at the start (axes column by column, if there are any), and the motion during the step.
inline RigidMotion<double> motion_of(const Case& c) {
  RigidMotion<double> motion;
  motion.start.origin = c.vector("origin");
  if (c.has("axes")) {
    const std::vector<double> axes = c.numbers("axes");
    for (int i = 0; i < 9; ++i) motion.start.axes(i % 3, i / 3) = axes.at(std::size_t(i));
  }
  motion.displacement = c.vector("displacement");
  motion.rotation = c.vector("rotation");
  return motion;
}
template <class S>
CoordinateFrame<S> rounded_frame(const CoordinateFrame<double>& frame) {
  return {generators::rounded<S>(frame.origin), frame.axes.template cast<S>()};
}

// ---------------------------------------------------------------- methods as they are often
// written

/// The delta matrix, and the mesh where it is in the end.
template <class S>
bool hit_by_delta(const Case& c) {
  const RigidMotion<double> motion = motion_of(c);
  const auto pose0 = rounded_frame<S>(motion.start);
  const auto pose1 = rounded_frame<S>(contact::frame_at(motion, 1.0));
  const auto delta = contact::delta_matrix<S>(contact::homogeneous_matrix(pose0),
                                              contact::homogeneous_matrix(pose1));
  const Mesh<S> mesh = mesh_in<S>(c);
  return contact::segment_against_mesh_by_delta<S>(generators::rounded<S>(c.segment("path")),
                                                   contact::transformed(mesh, pose1), delta)
      .has_value();
}

/// The lecture's order of factors, which is for rows, with columns.
inline bool hit_by_delta_of_rows(const Case& c) {
  const RigidMotion<double> motion = motion_of(c);
  const auto pose1 = contact::frame_at(motion, 1.0);
  const contact::Matrix4<double> delta =
      contact::inverse_of_frame_matrix<double>(contact::homogeneous_matrix(motion.start)) *
      contact::homogeneous_matrix(pose1);
  return contact::segment_against_mesh_by_delta<double>(
             c.segment("path"), contact::transformed(mesh_of(c), pose1), delta)
      .has_value();
}

/// The poses at both ends only: motion_between, and its chord.
inline bool hit_by_chord(const Case& c) {
  const RigidMotion<double> motion = motion_of(c);
  return contact::segment_against_moving_mesh<double>(c.segment("path"), mesh_of(c), motion.start,
                                                      contact::frame_at(motion, 1.0))
      .has_value();
}

/// Edges at which the angle of the rounded unit normals says that the solid is concave by more than
/// a tolerance.
template <class S>
int notches_by_normals(const Mesh<double>& mesh, S tolerance) {
  const Mesh<S> rounded = contact::rounded_mesh<S>(mesh);
  const auto normal = [&rounded](std::size_t i) {
    const auto t = contact::triangle_of(rounded, i);
    const Vector3<S> n = (t.b - t.a).cross(t.c - t.a);
    return Vector3<S>(n / std::sqrt(n.dot(n)));
  };
  int count = 0;
  for (std::size_t i = 0; i < rounded.triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < rounded.triangles.size(); ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
          const auto& v = rounded.triangles[i];
          const auto& w = rounded.triangles[j];
          if (v[k] != w[(l + 1) % 3] || v[(k + 1) % 3] != w[l]) continue;
          const auto at = [&rounded](int x) { return rounded.vertices[std::size_t(x)]; };
          const Vector3<S> along = at(v[(k + 1) % 3]) - at(v[k]);
          const S sine = normal(i).cross(normal(j)).dot(along) / std::sqrt(along.dot(along));
          count += sine < -tolerance ? 1 : 0;
        }
      }
    }
  }
  return count;
}

/// The volume of the tetrahedra over the mean of the vertices, each counted as positive.
inline double volume_of_cones(const Mesh<double>& mesh) {
  Vector3<double> middle(0, 0, 0);
  for (const Vector3<double>& v : mesh.vertices) middle += v / double(mesh.vertices.size());
  double volume = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto t = contact::triangle_of(mesh, i);
    volume += std::abs(contact::signed_volume<double>(middle, t.a, t.b, t.c)) / 6;
  }
  return volume;
}
/// The signed tetrahedra over the origin, rounded.
inline double volume_of_signed_cones(const Mesh<double>& mesh) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto t = contact::triangle_of(mesh, i);
    volume += t.a.dot(t.b.cross(t.c)) / 6;
  }
  return volume;
}

// ---------------------------------------------------------------- answers

inline Rational volume_exactly(const Mesh<double>& mesh) {
  Rational sixfold(0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto t = oracle::exact(contact::triangle_of(mesh, i));
    sixfold += t.a.dot(oracle::Vector(t.b.cross(t.c)));
  }
  return sixfold / 6;
}

inline int notches_exactly(const Mesh<double>& mesh) {
  int count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto t = oracle::exact(contact::triangle_of(mesh, i));
    const oracle::Vector n = oracle::Vector(t.b - t.a).cross(oracle::Vector(t.c - t.a));
    for (std::size_t j = 0; j < mesh.triangles.size(); ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
          const auto& v = mesh.triangles[i];
          const auto& w = mesh.triangles[j];
          if (v[k] != w[(l + 1) % 3] || v[(k + 1) % 3] != w[l] || v[k] > v[(k + 1) % 3]) continue;
          const oracle::Vector apex =
              oracle::exact(mesh.vertices[std::size_t(w[(l + 2) % 3])]) - t.a;
          count += oracle::sign(n.dot(apex)) > 0 ? 1 : 0;
        }
      }
    }
  }
  return count;
}

/// A volume that is right to 30 bits, relative to itself.
inline bool right_volume(double got, const Json& answer) {
  const double exact = hard_cases::unhex(answer, "volume");
  return hard_cases::close(got, exact, 0x1p-30 * std::abs(exact));
}

/// Whether each piece is behind all of its planes.
inline bool all_convex(const std::vector<contact::ConvexPiece>& pieces) {
  for (const contact::ConvexPiece& piece : pieces) {
    for (const contact::ExactPlane& plane : piece.planes) {
      for (const contact::HomogeneousPoint& vertex : piece.vertices) {
        if (contact::side_of_plane(plane, vertex) > 0) return false;
      }
    }
  }
  return true;
}

// ---------------------------------------------------------------- questions

inline void add_moving(hard_cases::Runner& runner) {
  runner.question("moving", [](const Case& c) -> Json {
    const RigidMotion<double> motion = motion_of(c);
    const std::optional<bool> hit = moving_truth::hit(motion, c.segment("path"), mesh_of(c));
    const bool turns = motion.rotation != Vector3<double>::Zero();
    Json answer{{"class", turns ? "c" : "a"}};
    if (hit) {
      answer["hit"] = *hit;
    } else {
      answer["undecided"] = true;
    }
    return answer;
  });
  const auto add = [&runner](const std::string& name, auto method) {
    runner.method("moving", name, [method](const Case& c, const Json& answer) {
      return answer.contains("hit") && answer.at("hit") == bool(method(c));
    });
  };
  add("present pose, double", [](const Case& c) {
    return contact::segment_against_present_mesh<double>(c.segment("path"), mesh_of(c),
                                                         contact::frame_at(motion_of(c), 1.0))
        .has_value();
  });
  add("M₀⁻¹M₁ with columns, double", hit_by_delta_of_rows);
  add("delta matrix, float", hit_by_delta<float>);
  add("delta matrix, double", hit_by_delta<double>);
  add("chord in the body, double", hit_by_chord);
  add("8 substeps, double", [](const Case& c) {
    return contact::moving_by_substeps<double>(c.segment("path"), mesh_of(c), motion_of(c), 8)
        .has_value();
  });
  runner.method("moving", "the book, certified", [](const Case& c, const Json& answer) {
    const MotionVerdict verdict =
        contact::certified_moving_hit(c.segment("path"), mesh_of(c), motion_of(c)).verdict;
    if (!answer.contains("hit")) return verdict == MotionVerdict::undecided;
    return verdict == (answer.at("hit").get<bool>() ? MotionVerdict::hit : MotionVerdict::free);
  });
}

inline void add_pieces(hard_cases::Runner& runner) {
  runner.question("notches", [](const Case& c) -> Json {
    return {{"class", "a"}, {"notches", notches_exactly(mesh_of(c))}};
  });
  runner.method("notches", "rounded normals, float", [](const Case& c, const Json& answer) {
    return answer.at("notches") == notches_by_normals<float>(mesh_of(c), 0);
  });
  runner.method("notches", "rounded normals, double", [](const Case& c, const Json& answer) {
    return answer.at("notches") == notches_by_normals<double>(mesh_of(c), 0);
  });
  runner.method("notches", "tolerance 1e-9, double", [](const Case& c, const Json& answer) {
    return answer.at("notches") == notches_by_normals<double>(mesh_of(c), 1e-9);
  });
  runner.method("notches", "the book, exact", [](const Case& c, const Json& answer) {
    return answer.at("notches") == int(contact::notches(mesh_of(c)).size());
  });

  runner.question("pieces", [](const Case& c) -> Json {
    return {{"class", "a"}, {"volume", hard_cases::hex(volume_exactly(mesh_of(c)))}};
  });
  runner.method("pieces", "cones from the middle, double", [](const Case& c, const Json& answer) {
    return right_volume(volume_of_cones(mesh_of(c)), answer);
  });
  runner.method("pieces", "signed cones, double", [](const Case& c, const Json& answer) {
    return right_volume(volume_of_signed_cones(mesh_of(c)), answer);
  });
  runner.method("pieces", "the book, exact", [](const Case& c, const Json&) {
    const Mesh<double> mesh = mesh_of(c);
    const std::vector<contact::ConvexPiece> pieces = contact::convex_pieces(mesh);
    return all_convex(pieces) &&
           contact::volume_of_pieces(pieces) == contact::mesh_volume_exactly(mesh);
  });
}

inline void add_questions(hard_cases::Runner& runner) {
  add_moving(runner);
  add_pieces(runner);
}

}  // namespace hard_moving
