// Seven bodies, seen along z: what a ray meets, in order, and what a bullet meets that is sampled
// once a frame, or whose path is asked.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/ball_box.hpp>
#include <contact/figure.hpp>
#include <contact/first_in_scene.hpp>
#include <vector>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;

struct Input {
  Point origin;      // o, start of the ray and of the bullet, m
  Point through;     // q, to which t = 1 of the ray belongs, m
  Point ball;        // centre of the ball, m
  Point box;         // centre of the rotated box, m
  double thickness;  // of the wall, m
  double speed;      // of the bullet, m a frame
  double radius;     // of the bullet, m
  double test;       // 0 the ray, 1 the bullet by samples, 2 the bullet by segments
};

constexpr int bodies = 7;  // wall, ball, box, cylinder, capsule, cone, triangle
constexpr int max_frames = 60;
constexpr double path_length = 11, min_speed = 0.2;

struct Output {
  double problem;
  // What is drawn of each body: where the plane z = 0 cuts it.
  std::array<Point, 4> wall, box_outline;
  double ball_radius;
  Point cylinder;
  double cylinder_radius;
  std::array<Point, 2> capsule;
  double capsule_radius;
  std::array<Point, 3> cone;
  std::array<Point, 2> triangle;
  // The ray.
  double hits;                      // how many bodies it meets
  std::array<double, bodies> body;  // which, in order
  std::array<double, bodies> t;
  std::array<Point, bodies> at, normal;
  double inside;  // 1 if it starts in the first of them
  // The bullet, by samples and by segments.
  double frames;
  std::array<Point, max_frames> sample;
  Point path_end;
  std::array<double, 2> met;       // 1 if it meets a body
  std::array<double, 2> met_body;  // which
  std::array<double, 2> met_frame;
  std::array<Point, 2> met_at;
  double skipped;  // 1 if the path meets a body first in which no sample is
  // The bullet as a ball with its radius, against the wall alone.
  double line_meets_wall, ball_meets_wall, enlarged_meets_wall;
  Point ball_at;            // its centre, where it touches first
  double through_the_wall;  // goals of questions: the wall is met first, and no sample is in it
  double grazes;            // the line passes beside the wall, and the ball touches it
};

namespace {

using Body = contact::Primitive<double>;

constexpr double wall_left = 2.4, wall_low = -2.2, wall_high = 0.75, height = 1;

Vector space(const Point& p, double z = 0) { return {p.x(), p.y(), z}; }
Point plane(const Vector& v) { return v.head<2>(); }

std::vector<Body> scene_of(const Input& in, Output& out) {
  const contact::Aabb<double> wall{{wall_left, wall_low, -height},
                                   {wall_left + in.thickness, wall_high, height}};
  contact::OrientedBox<double> box;
  box.centre = space(in.box);
  box.axes << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
  box.half_lengths = {0.75, 0.4, height};
  out.ball_radius = 0.5;
  out.cylinder = {0.5, -2};
  out.cylinder_radius = 0.5;
  out.capsule = {Point(-3.1, 1.5), Point(-2, 2.2)};
  out.capsule_radius = 0.3;
  const contact::Cone<double> cone{{-1.5, -1.2, 0}, {-2.3, -2.4, 0}, 0.6};
  const contact::Triangle<double> triangle{{1, 0.75, -1}, {1.5, 2.25, -1}, {1.25, 1.5, 1}};

  out.wall = {plane(wall.low), Point(wall.high.x(), wall.low.y()), plane(wall.high),
              Point(wall.low.x(), wall.high.y())};
  const Vector x = box.axes.col(0) * box.half_lengths.x();
  const Vector y = box.axes.col(1) * box.half_lengths.y();
  out.box_outline = {plane(box.centre - x - y), plane(box.centre + x - y),
                     plane(box.centre + x + y), plane(box.centre - x + y)};
  const Point axis = plane(cone.base - cone.apex);
  const Point rim = Point(-axis.y(), axis.x()) * (cone.radius / std::sqrt(axis.squaredNorm()));
  out.cone = {plane(cone.apex), Point(plane(cone.base) + rim), Point(plane(cone.base) - rim)};
  // Its vertices are one metre below and above z = 0.
  out.triangle = {plane(triangle.a + triangle.c) / 2, plane(triangle.b + triangle.c) / 2};

  return {
      wall,
      contact::Sphere<double>{space(in.ball), out.ball_radius},
      box,
      contact::Cylinder<double>{{space(out.cylinder, -height), space(out.cylinder, height)},
                                out.cylinder_radius},
      contact::Capsule<double>{{space(out.capsule[0]), space(out.capsule[1])}, out.capsule_radius},
      cone,
      triangle};
}

void shoot(const Input& in, const std::vector<Body>& scene, Output& out) {
  const Point ahead = in.through - in.origin;
  const double speed = std::max(in.speed, min_speed);
  const Point displacement = ahead * (speed / std::sqrt(ahead.squaredNorm()));
  const Vector start = space(in.origin), step = space(displacement);
  const int frames = std::min(max_frames, static_cast<int>(std::ceil(path_length / speed)));
  out.frames = frames;
  for (int k = 0; k < frames; ++k)
    out.sample[static_cast<std::size_t>(k)] = plane(start + step * double(k + 1));
  out.path_end = out.sample[static_cast<std::size_t>(frames - 1)];

  const std::array found{contact::bullet_by_samples<double>(start, step, frames, scene),
                         contact::bullet_by_segments<double>(start, step, frames, scene)};
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    out.met[i] = 1;
    out.met_body[i] = double(found[i]->index);
    out.met_frame[i] = found[i]->step + 1;
    out.met_at[i] = plane(found[i]->hit.point);
  }
  if (found[1]) {
    const Body& body = scene[found[1]->index];
    out.skipped = 1;
    for (int k = 0; k < frames; ++k) {
      const Vector sample = space(out.sample[static_cast<std::size_t>(k)]);
      if (contact::first_hit(contact::Ray<double>{sample, Vector::Zero()}, body)) out.skipped = 0;
    }
    out.through_the_wall = out.skipped != 0 && found[1]->index == 0 ? 1 : 0;
  }

  const contact::Segment<double> path{start, space(out.path_end)};
  const auto& wall = std::get<contact::Aabb<double>>(scene[0]);
  out.line_meets_wall = contact::hits_box(path, wall) ? 1 : 0;
  if (const auto hit = contact::ball_first_hit(path, in.radius, wall)) {
    out.ball_meets_wall = 1;
    out.ball_at = plane(hit->point);
  }
  out.enlarged_meets_wall = contact::ball_hits_enlarged_box(path, in.radius, wall) ? 1 : 0;
  out.grazes = out.line_meets_wall == 0 && out.ball_meets_wall != 0 ? 1 : 0;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.origin, &in.through, &in.ball, &in.box}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  if (in.radius > 1e3 || in.thickness > 1e3) out.problem = contact::figure::too_large;
  if (!(in.thickness > 0) || !(in.speed > 0) || in.radius < 0)
    out.problem = contact::figure::not_positive;
  if (!((in.through - in.origin).cwiseAbs().maxCoeff() > 1e-6))
    out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;

  const std::vector<Body> scene = scene_of(in, out);
  const contact::Ray<double> ray{space(in.origin), space(in.through - in.origin)};
  for (const auto& met : contact::all_in_scene<double>(ray, scene)) {
    const auto k = static_cast<std::size_t>(out.hits);
    ++out.hits;
    out.body[k] = double(met.index);
    out.t[k] = met.hit.t;
    out.at[k] = plane(met.hit.point);
    out.normal[k] = plane(met.hit.normal);
    if (k == 0) out.inside = met.hit.inside ? 1 : 0;
  }
  shoot(in, scene, out);
  return out;
}

FIGURE(Input, FIELDS(origin, through, ball, box, thickness, speed, radius, test), Output,
       FIELDS(problem, wall, box_outline, ball_radius, cylinder, cylinder_radius, capsule,
              capsule_radius, cone, triangle, hits, body, t, at, normal, inside, frames, sample,
              path_end, met, met_body, met_frame, met_at, skipped, line_meets_wall, ball_meets_wall,
              enlarged_meets_wall, ball_at, through_the_wall, grazes))
