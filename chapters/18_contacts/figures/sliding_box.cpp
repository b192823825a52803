// A box that slides to rest on level ground, as seen from above: with the friction cone, and with
// the pyramid along the first and the second tangent.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/contact_solver.hpp>
#include <contact/figure.hpp>
#include <contact/friction_pyramid.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <vector>

#include "blocks.hpp"

using Point = contact::Vector2<double>;

constexpr std::size_t samples = 61, directions = 31;
constexpr double last_time = 1.2;  // s
constexpr double radians_in_degree = 0.017453292519943295;
constexpr double at_rest = 1e-9;      // m/s
constexpr double max_steps = 20'000;  // until the box is at rest

struct Input {
  double speed;      // at the start, m/s
  double direction;  // of the velocity from the first tangent, degrees
  double friction;   // μ
  double rate;       // steps per second
  double mean;       // 1: moved by the mean of the velocities before and after each step, otherwise
                     // by the velocity after it
  double time;       // of what is drawn, s
};

/// Vectors have their components along the first and the second tangent.
struct Output {
  double problem;
  Point ahead;                         // the direction, 1 long
  double formula, duration;            // v² / (2 μ g), m, and v / (μ g), s
  std::array<double, samples> moment;  // s
  // With the cone and with the pyramid: positions and speeds at these moments.
  std::array<Point, samples> cone_path, pyramid_path;     // m
  std::array<double, samples> cone_speed, pyramid_speed;  // m/s
  Point cone_position, pyramid_position;                  // at the time, m
  Point cone_velocity, pyramid_velocity;                  // at the time, m/s
  Point cone_friction, pyramid_friction;                  // at the time, over the normal impulse
  Point cone_stop, pyramid_stop;                          // where the box comes to rest, m
  double cone_distance, pyramid_distance;                 // from the start to there, m
  double pyramid_aside;                                   // of the line ahead, to its left, m
  // Where boxes stop that start in each direction of the quadrant, by formula, m.
  std::array<Point, directions> cone_stops, pyramid_stops;
};

namespace {

using contact::FrictionBound;

/// What is drawn of a box that slides with one of the bounds.
struct Slide {
  std::array<Point, samples> path{};
  std::array<double, samples> speed{};
  Point position = Point::Zero(), velocity = Point::Zero(), friction = Point::Zero();
  Point stop = Point::Zero();
};

Slide slide(const Input& in, const Point& ahead, FrictionBound bound) {
  const double h = 1 / in.rate;
  std::vector<blocks::Body> bodies{
      blocks::ground(),
      blocks::block(blocks::mass, blocks::Vector::Zero(),
                    blocks::Vector(ahead.x() * in.speed, ahead.y() * in.speed, 0))};
  blocks::Body& box = bodies[1];
  blocks::Settings settings;
  settings.friction_bound = bound;
  const double time = std::clamp(in.time, 0.0, last_time);
  Slide result;
  std::size_t sample = 0;
  bool rests = false, is_shown = false;
  for (int s = 0; !rests || !is_shown || sample < samples; ++s) {
    const double now = s * h;
    const Point from = box.position.head<2>(), before = box.velocity.head<2>();
    // [slide-step]
    blocks::fall(bodies, h);
    const blocks::Contacts contacts{{1, 0, box.position, blocks::up(), in.friction, 0}};
    const auto solved = contact::solve_contacts(bodies, contacts, {}, settings);
    const Point after = solved.bodies[1].velocity.head<2>();
    const Point moved = in.mean < 0.5 ? Point(after * h) : Point((before + after) * (h / 2));
    // [/slide-step]
    box.velocity = blocks::Vector(after.x(), after.y(), 0);
    box.position += blocks::Vector(moved.x(), moved.y(), 0);
    const auto share = [&](double t) { return std::clamp((t - now) / h, 0.0, 1.0); };
    for (; sample < samples; ++sample) {
      const double t = last_time * double(sample) / double(samples - 1);
      if (t > now + h) break;
      result.path[sample] = from + moved * share(t);
      const Point velocity = before + (after - before) * share(t);
      result.speed[sample] = std::sqrt(velocity.dot(velocity));
    }
    if (!is_shown && time <= now + h) {
      is_shown = true;
      result.position = from + moved * share(time);
      result.velocity = before + (after - before) * share(time);
      const auto& impulse = solved.impulses[0];
      result.friction = impulse.tangential.head<2>() / impulse.normal;
    }
    if (!rests && std::sqrt(after.dot(after)) <= at_rest) {
      rests = true;
      result.stop = from + moved;
    }
  }
  return result;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.speed > 0) || !(in.friction > 0) || !(in.rate > 0))
    out.problem = contact::figure::not_positive;
  if (in.speed > 100 || in.friction > 10 || in.rate > 1000 || std::abs(in.direction) > 360)
    out.problem = contact::figure::too_large;
  if (out.problem == 0 && (in.speed < 1e-3 || in.friction < 1e-3 || in.rate < 1))
    out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;
  const double deceleration = in.friction * blocks::gravity;
  out.formula = in.speed * in.speed / (2 * deceleration);
  out.duration = in.speed / deceleration;
  if (out.duration * in.rate > max_steps) out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  const auto unit = [](double degrees) {
    const auto turn = contact::sine_cosine(degrees * radians_in_degree);
    return Point(turn.cosine, turn.sine);
  };
  out.ahead = unit(in.direction);
  for (std::size_t i = 0; i < samples; ++i)
    out.moment[i] = last_time * double(i) / double(samples - 1);
  const Slide cone = slide(in, out.ahead, FrictionBound::cone);
  const Slide pyramid = slide(in, out.ahead, FrictionBound::pyramid);
  out.cone_path = cone.path;
  out.cone_speed = cone.speed;
  out.cone_position = cone.position;
  out.cone_velocity = cone.velocity;
  out.cone_friction = cone.friction;
  out.cone_stop = cone.stop;
  out.pyramid_path = pyramid.path;
  out.pyramid_speed = pyramid.speed;
  out.pyramid_position = pyramid.position;
  out.pyramid_velocity = pyramid.velocity;
  out.pyramid_friction = pyramid.friction;
  out.pyramid_stop = pyramid.stop;
  out.cone_distance = std::sqrt(cone.stop.dot(cone.stop));
  out.pyramid_distance = std::sqrt(pyramid.stop.dot(pyramid.stop));
  out.pyramid_aside = out.ahead.x() * pyramid.stop.y() - out.ahead.y() * pyramid.stop.x();
  for (std::size_t i = 0; i < directions; ++i) {
    const Point towards = unit(90 * double(i) / double(directions - 1));
    out.cone_stops[i] = towards * out.formula;
    // Each component of the velocity decreases as if it were alone.
    out.pyramid_stops[i] = towards.cwiseProduct(towards) * out.formula;
  }
  return out;
}

FIGURE(Input, FIELDS(speed, direction, friction, rate, mean, time), Output,
       FIELDS(problem, ahead, formula, duration, moment, cone_path, pyramid_path, cone_speed,
              pyramid_speed, cone_position, pyramid_position, cone_velocity, pyramid_velocity,
              cone_friction, pyramid_friction, cone_stop, pyramid_stop, cone_distance,
              pyramid_distance, pyramid_aside, cone_stops, pyramid_stops))
