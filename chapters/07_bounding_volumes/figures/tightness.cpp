// A body in space and its bounding volumes: how many times each is as large as the body's hull,
// while the body is turned.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/box_around.hpp>
#include <contact/carried_volumes.hpp>
#include <contact/convex_hull.hpp>
#include <contact/figure.hpp>
#include <contact/grown_sphere.hpp>
#include <contact/principal_axes.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/slab_volumes.hpp>
#include <contact/smallest_box.hpp>
#include <contact/smallest_sphere.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "bodies_in_space.hpp"

using Vector = contact::Vector3<double>;
using Mesh = contact::Mesh<double>;
using Frame = contact::CoordinateFrame<double>;

struct Input {
  Vector nose;   // the direction of the body's x axis, of any length
  double roll;   // the body's turn about it, degrees
  double shape;  // 0 ball, 1 rod, 2 plate, 3 star, 4 knot
  double kind;   // of the volume that is drawn, as below
};

// 0 the lecture's sphere, 1 the smallest one, 2 AABB, 3 the AABB of the object's box, 4 the
// object's box, 5 along principal axes, 6 the smallest box, 7 to 9 the DOPs of 14, 18 and 26, 10
// the hull.
constexpr std::size_t kinds = 11, shapes = 5, turns = 24;
constexpr std::size_t max_vertices = 172, max_triangles = 340, max_lines = 360;

struct Output {
  double problem;
  double vertices, triangles;
  std::array<Vector, max_vertices> vertex;  // of the body as it is turned, m
  std::array<std::array<double, 3>, max_triangles> triangle;
  double hull_share;                          // volume of the body / volume of its hull
  std::array<double, kinds> volume, ratio;    // m³; volume / volume of the hull
  std::array<double, kinds> least, greatest;  // ratio, over random orientations
  double lines;                               // edges of the volume that is drawn
  std::array<std::array<Vector, 2>, max_lines> line;
  Vector centre;                        // of the sphere that is drawn
  double radius;                        // 0: no sphere
  double aabb_is_tight, dop_is_better;  // goals of questions
};

namespace {

/// A body in its own frame, with the volumes that it carries along.
struct Body {
  Mesh mesh;
  std::vector<Vector> outer;  // vertices of the hull
  contact::Hull hull;         // of these
  double volume = 0, hull_volume = 0;
  contact::Sphere<double> grown, smallest;
  contact::Aabb<double> box;
  contact::OrientedBox<double> principal, smallest_box;
  std::array<double, kinds> least{}, greatest{};
};

/// What has to be made again when the body is turned, or is carried along.
struct Turned {
  std::vector<Vector> outer;
  contact::Aabb<double> aabb, aabb_of_box;
  contact::OrientedBox<double> box;
  std::array<contact::Kdop<double>, 3> dops;
};

Turned turned(const Body& body, const Frame& frame) {
  static const std::array<std::vector<Vector>, 3> normals{contact::kdop_normals<double>(14),
                                                          contact::kdop_normals<double>(18),
                                                          contact::kdop_normals<double>(26)};
  Turned result;
  for (const Vector& v : body.outer) result.outer.push_back(position_in_world(frame, v));
  const std::span<const Vector> points(result.outer);
  result.aabb = contact::aabb_of_points(points);
  result.aabb_of_box = contact::aabb_of_carried(body.box, frame);
  result.box = contact::carried(body.box, frame);
  for (std::size_t i = 0; i < 3; ++i) result.dops[i] = contact::kdop_of_points(normals[i], points);
  return result;
}

double volume_of(const contact::Aabb<double>& box) {
  const Vector edges = box.high - box.low;
  return edges.x() * edges.y() * edges.z();
}

double volume_of(const contact::OrientedBox<double>& box) {
  return 8 * box.half_lengths.x() * box.half_lengths.y() * box.half_lengths.z();
}

double volume_of(const contact::Sphere<double>& ball) {
  return 4.1887902047863905 * ball.radius * ball.radius * ball.radius;
}

std::array<double, kinds> volumes(const Body& body, const Turned& now) {
  return {volume_of(body.grown),
          volume_of(body.smallest),
          volume_of(now.aabb),
          volume_of(now.aabb_of_box),
          volume_of(now.box),
          volume_of(body.principal),
          volume_of(body.smallest_box),
          contact::volume(now.dops[0]),
          contact::volume(now.dops[1]),
          contact::volume(now.dops[2]),
          body.hull_volume};
}

/// Some orientations, the same for all bodies: random points of a ball in four dimensions, as
/// quaternions.
std::vector<Frame> orientations() {
  std::uint64_t state = 7;
  const auto next = [&state] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return double(state >> 32U) / 2147483648.0 - 1;
  };
  std::vector<Frame> frames;
  while (frames.size() < turns) {
    const double w = next();
    const double x = next();
    const double y = next();
    const double z = next();
    const double square = w * w + x * x + y * y + z * z;
    if (square > 1 || square < 0.01) continue;
    const double s = 2 / square;
    Frame frame;
    frame.axes << 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),
        s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x), s * (x * z - w * y),
        s * (y * z + w * x), 1 - s * (x * x + y * y);
    frames.push_back(frame);
  }
  return frames;
}

Body made(const Mesh& mesh) {
  Body body;
  body.mesh = mesh;
  body.volume = bodies_in_space::volume_of(mesh.vertices, mesh.triangles);
  for (const int i : contact::convex_hull(mesh.vertices).vertices)
    body.outer.push_back(mesh.vertices[static_cast<std::size_t>(i)]);
  body.hull = contact::convex_hull(body.outer);
  body.hull_volume = bodies_in_space::volume_of(body.outer, contact::triangles(body.hull));
  const std::span<const Vector> outer(body.outer);
  body.grown = contact::grown_sphere(outer);
  body.smallest = contact::smallest_sphere(outer).sphere;
  body.box = contact::aabb_of_points(outer);
  // All vertices, as a program does that has no hull.
  body.principal = contact::principal_box(std::span<const Vector>(mesh.vertices));
  body.smallest_box = contact::smallest_box(outer);
  body.least.fill(std::numeric_limits<double>::infinity());
  for (const Frame& frame : orientations()) {
    const auto each = volumes(body, turned(body, frame));
    for (std::size_t k = 0; k < kinds; ++k) {
      body.least[k] = std::min(body.least[k], each[k] / body.hull_volume);
      body.greatest[k] = std::max(body.greatest[k], each[k] / body.hull_volume);
    }
  }
  return body;
}

const Body& body(double number) {
  static std::array<std::vector<Body>, shapes> bodies;  // each is made when it is first shown
  const std::size_t i = number >= 1 && number < double(shapes) ? std::size_t(number) : 0;
  if (bodies[i].empty()) {
    bodies[i].push_back(made(i == 0   ? bodies_in_space::ball()
                             : i == 1 ? bodies_in_space::rod()
                             : i == 2 ? bodies_in_space::plate()
                             : i == 3 ? bodies_in_space::star()
                                      : bodies_in_space::knot()));
  }
  return bodies[i].front();
}

/// The body's x axis along the nose, and its y axis level, before it rolls.
Frame frame_of(const Vector& nose, double roll) {
  const Vector x = nose / std::sqrt(nose.squaredNorm());
  const double flat = std::sqrt(x.x() * x.x() + x.y() * x.y());
  const Vector y = flat > 1e-9 ? Vector(-x.y() / flat, x.x() / flat, 0) : Vector(0, 1, 0);
  const Vector z = x.cross(y);
  const auto [sine, cosine] = contact::sine_cosine(roll / 360 * bodies_in_space::turn);
  Frame frame;
  frame.axes.col(0) = x;
  frame.axes.col(1) = cosine * y + sine * z;
  frame.axes.col(2) = cosine * z - sine * y;
  return frame;
}

void add_line(const Vector& from, const Vector& to, Output& out) {
  if (out.lines >= double(max_lines)) return;
  out.line[static_cast<std::size_t>(out.lines++)] = {from, to};
}

void draw_box(const contact::OrientedBox<double>& box, Output& out) {
  for (int k = 0; k < 12; ++k) {
    const auto edge = contact::box_edge(box, k);
    add_line(edge.start, edge.end, out);
  }
}

void draw_box(const contact::Aabb<double>& box, Output& out) {
  draw_box(
      contact::OrientedBox<double>{(box.low + box.high) / 2, contact::Matrix3<double>::Identity(),
                                   (box.high - box.low) / 2},
      out);
}

/// Each edge of a k-DOP once: of the two facets that have it, one has it from the smaller end.
void draw_dop(const contact::Kdop<double>& dop, Output& out) {
  for (const auto& facet : contact::kdop_facets(dop)) {
    for (std::size_t i = 0; i < facet.size(); ++i) {
      const Vector &p = facet[i], &q = facet[(i + 1) % facet.size()];
      if (std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3))
        add_line(p, q, out);
    }
  }
}

void draw(const Body& body, const Turned& now, const Frame& frame, double kind, Output& out) {
  if (kind == 0 || kind == 1) {
    const auto ball = contact::carried(kind == 0 ? body.grown : body.smallest, frame);
    out.centre = ball.centre;
    out.radius = ball.radius;
  } else if (kind == 2 || kind == 3) {
    draw_box(kind == 2 ? now.aabb : now.aabb_of_box, out);
  } else if (kind == 4) {
    draw_box(now.box, out);
  } else if (kind == 5 || kind == 6) {
    draw_box(contact::carried(kind == 5 ? body.principal : body.smallest_box, frame), out);
  } else if (kind >= 7 && kind < 10) {
    draw_dop(now.dops[static_cast<std::size_t>(kind) - 7], out);
  } else {
    for (int f = 0; f < body.hull.face_count(); ++f) {
      const auto face = body.hull.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const auto p = static_cast<std::size_t>(face[i]);
        const auto q = static_cast<std::size_t>(face[(i + 1) % face.size()]);
        if (p < q) add_line(now.outer[p], now.outer[q], out);
      }
    }
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (in.nose.cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  if (!(in.nose.cwiseAbs().maxCoeff() > 1e-100)) out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;
  const Body& shown = body(in.shape);
  const Frame frame = frame_of(in.nose, in.roll);
  out.vertices = double(shown.mesh.vertices.size());
  out.triangles = double(shown.mesh.triangles.size());
  for (std::size_t i = 0; i < shown.mesh.vertices.size(); ++i)
    out.vertex[i] = position_in_world(frame, shown.mesh.vertices[i]);
  for (std::size_t i = 0; i < shown.mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) out.triangle[i][k] = shown.mesh.triangles[i][k];
  }
  const Turned now = turned(shown, frame);
  out.hull_share = shown.volume / shown.hull_volume;
  out.volume = volumes(shown, now);
  for (std::size_t k = 0; k < kinds; ++k) out.ratio[k] = out.volume[k] / shown.hull_volume;
  out.least = shown.least;
  out.greatest = shown.greatest;
  draw(shown, now, frame, in.kind, out);
  out.aabb_is_tight = out.ratio[2] <= 1.5 ? 1 : 0;
  out.dop_is_better = out.ratio[9] < out.ratio[4] ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(nose, roll, shape, kind), Output,
       FIELDS(problem, vertices, triangles, vertex, triangle, hull_share, volume, ratio, least,
              greatest, lines, line, centre, radius, aabb_is_tight, dop_is_better))
