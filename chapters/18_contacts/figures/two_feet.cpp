// A box in the plane that falls onto level ground with two of its corners, and what three methods
// make of it in time steps: one contact after the other, only the lower one, and both at once.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/contact_solver.hpp>
#include <contact/figure.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/two_contacts.hpp>
#include <cstddef>
#include <vector>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;

constexpr std::size_t methods = 3, corners = 4, feet = 2;
constexpr double mass = 1, width = 1.2, height = 0.6;  // kg, m
constexpr double gravity = 9.8125, speed = 3;          // m/s²; at the impact, m/s
constexpr double step = 0x1p-8, last_time = 1.25;      // s
constexpr double rest_speed = 0.2, reach = 0.05;       // m/s, m
constexpr double radians_in_degree = 0.017453292519943295;

struct Input {
  double restitution;  // e of both contacts
  double friction;     // μ
  double tilt;         // of the box before the impact, degrees, counter-clockwise
  double sideways;     // velocity to the right before the impact, m/s
  double right_first;  // 1: the right corner is the first of the list
  double time;         // since the impact, s
};

struct Output {
  double problem;
  double mass, inertia, width, height, velocity;  // the box before the impact
  // The two lower corners at the impact: lever arms to the right of the centre, m; velocities less
  // the least that they may have afterwards, m/s; impulses of both at once without friction, N·s.
  Point lever_arms, b, impulses;
  Point before;  // upward velocities of the left and the right corner, m/s
  // By method (one after the other, the lower one only, both at once): after the impact the upward
  // velocities of the corners, [2 m] and [2 m + 1], the angular velocity and the kinetic energy
  // over that before.
  std::array<double, methods * feet> after;
  std::array<double, methods> angular_velocity, energy;
  std::array<Point, methods * corners> box;  // at the time, from the lower left corner
  std::array<double, methods> angle, sunk;   // then: degrees, and the deepest corner so far, m
  // Goals of questions.
  double turns;   // one after the other starts a rotation that both at once does not
  double closes;  // one after the other leaves a corner that approaches with more than 1.6 m/s
  double alike;   // all three do the same, at an impact of one corner or of two
};

namespace {

using Body = contact::RigidBody<double>;
using Contacts = std::vector<contact::BodyContact<double>>;

enum class Method { one_by_one, one_point, at_once };

/// The box with its angle; body 0 of a list whose body 1 is the ground.
struct Box {
  std::vector<Body> bodies;
  double angle = 0;
};

std::array<Vector, corners> corners_of(const Box& box) {
  const auto turn = contact::sine_cosine(box.angle);
  std::array<Vector, corners> found;
  for (std::size_t i = 0; i < corners; ++i) {
    const double x = i == 0 || i == 3 ? -width / 2 : width / 2;
    const double y = i < 2 ? -height / 2 : height / 2;
    found[i] = box.bodies[0].position +
               Vector(turn.cosine * x - turn.sine * y, turn.sine * x + turn.cosine * y, 0);
  }
  return found;
}

/// The box at the impact: the lowest corner is on the ground.
Box at_impact(const Input& in) {
  const double inertia = mass * (width * width + height * height) / 12;
  Box box;
  box.bodies = {contact::rigid_body_from_axes<double>(
                    mass, Vector(inertia, inertia, inertia), contact::Matrix3<double>::Identity(),
                    Vector::Zero(), Vector(in.sideways, -speed, 0), Vector::Zero()),
                contact::immovable<double>(Vector::Zero(), Vector::Zero(), Vector::Zero())};
  box.angle = in.tilt * radians_in_degree;
  double lowest = 0;
  for (const Vector& p : corners_of(box)) lowest = std::min(lowest, p.y());
  box.bodies[0].position.y() = -lowest;
  return box;
}

/// A contact of a corner with the ground: it bounces if it arrives within a step and is fast, and
/// otherwise it may close its distance but no more.
contact::BodyContact<double> contact_at(const Box& box, const Vector& corner, const Input& in) {
  contact::BodyContact<double> c{0, 1, corner, Vector(0, 1, 0), in.friction, 0};
  const double velocity = contact::contact_velocity(box.bodies, c);
  const double room = -std::max(corner.y(), 0.0) / step;
  const bool bounces = velocity < room && velocity < -rest_speed;
  c.min_velocity = bounces ? -in.restitution * velocity : room;
  return c;
}

/// The corners within reach of the ground, in the order of the list.
std::vector<Vector> near_ground(const Box& box, const Input& in) {
  std::vector<Vector> found;
  for (const Vector& p : corners_of(box))
    if (p.y() <= reach) found.push_back(p);
  if (in.right_first == 1) std::reverse(found.begin(), found.end());
  return found;
}

void solve(Method method, Box& box, const Input& in) {
  // [methods]
  const std::vector<Vector> points = near_ground(box, in);
  if (points.empty()) return;
  if (method == Method::one_by_one) {
    for (const Vector& p : points)
      box.bodies = contact::solve_contacts(box.bodies, {contact_at(box, p, in)}).bodies;
  } else if (method == Method::one_point) {
    const auto lower = [](const Vector& p, const Vector& q) { return p.y() < q.y(); };
    const Vector& lowest = *std::min_element(points.begin(), points.end(), lower);
    box.bodies = contact::solve_contacts(box.bodies, {contact_at(box, lowest, in)}).bodies;
  } else {
    Contacts all;
    for (const Vector& p : points) all.push_back(contact_at(box, p, in));
    contact::SolverSettings<double> symmetric;
    symmetric.jacobi = true;
    symmetric.iterations = 400;
    symmetric.tolerance = 1e-10;
    box.bodies = contact::solve_contacts(box.bodies, all, {}, symmetric).bodies;
  }
  // [/methods]
}

void move(Box& box, double time) {
  box.bodies[0].position += box.bodies[0].velocity * time;
  box.angle += box.bodies[0].angular_velocity.z() * time;
}

double lowest_corner(const Box& box) {
  double lowest = 0;
  for (const Vector& p : corners_of(box)) lowest = std::min(lowest, p.y());
  return lowest;
}

double kinetic_energy(const Body& body) {
  return (mass * body.velocity.dot(body.velocity) +
          body.inertia(2, 2) * body.angular_velocity.dot(body.angular_velocity)) /
         2;
}

/// The box before the impact at a time, in free fall; without rotation.
Box falling(Box box, double time) {
  Body& body = box.bodies[0];
  body.position += body.velocity * time + Vector(0, -gravity * time * time / 2, 0);
  return box;
}

void follow(Method method, const Input& in, Output& out) {
  const auto m = static_cast<std::size_t>(method);
  Box box = at_impact(in);
  const auto at_start = corners_of(box);
  const double before = kinetic_energy(box.bodies[0]);
  solve(method, box, in);
  const Body& body = box.bodies[0];
  for (std::size_t i = 0; i < feet; ++i)
    out.after[feet * m + i] = contact::velocity_at(body, at_start[i]).y();
  out.angular_velocity[m] = body.angular_velocity.z();
  out.energy[m] = kinetic_energy(body) / before;
  double left = std::clamp(in.time, 0.0, last_time);
  for (bool first = true; left > 0; first = false) {
    if (!first) {
      box.bodies[0].velocity.y() -= gravity * step;
      solve(method, box, in);
    }
    move(box, std::min(step, left));
    left -= step;
    out.sunk[m] = std::max(out.sunk[m], -lowest_corner(box));
  }
  if (in.time < 0) box = falling(at_impact(in), std::max(in.time, -last_time));
  const auto now = corners_of(box);
  for (std::size_t i = 0; i < corners; ++i) out.box[corners * m + i] = now[i].head<2>();
  out.angle[m] = box.angle / radians_in_degree;
}

/// The impact of both lower corners without friction, as a complementarity problem.
void both_feet(const Input& in, Output& out) {
  const Box box = at_impact(in);
  const auto at = corners_of(box);
  Contacts contacts;
  for (std::size_t i = 0; i < feet; ++i) {
    const auto c = contact_at(box, at[i], in);
    const auto k = static_cast<Eigen::Index>(i);
    contacts.push_back(c);
    out.before[k] = contact::contact_velocity(box.bodies, c);
    out.lever_arms[k] = at[i].x() - box.bodies[0].position.x();
    out.b[k] = out.before[k] - c.min_velocity;
  }
  const auto matrix = contact::inverse_effective_mass_matrix(box.bodies, contacts);
  const auto x = contact::solve_two_contacts<double>({matrix[0][0], matrix[0][1], matrix[1][1]},
                                                     out.b[0], out.b[1]);
  if (x) out.impulses = {x->first, x->second};
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (in.restitution < 0 || in.friction < 0) out.problem = contact::figure::too_small;
  if (in.restitution > 1 || in.friction > 100 || std::abs(in.tilt) > 45 ||
      std::abs(in.sideways) > 100) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;
  const Box box = at_impact(in);
  out.mass = mass;
  out.inertia = box.bodies[0].inertia(2, 2);
  out.width = width;
  out.height = height;
  out.velocity = box.bodies[0].velocity.y();
  both_feet(in, out);
  for (const Method method : {Method::one_by_one, Method::one_point, Method::at_once})
    follow(method, in, out);
  const auto differ = [](double x, double y, double much) { return std::abs(x - y) > much; };
  const auto& turning = out.angular_velocity;
  out.turns = std::abs(turning[2]) < 1e-9 && std::abs(turning[0]) > 0.1 ? 1 : 0;
  out.closes = std::min(out.after[0], out.after[1]) < -1.6 ? 1 : 0;
  bool alike = true;
  for (std::size_t i = 0; i < feet; ++i) {
    for (std::size_t m = 0; m < methods - 1; ++m)
      alike = alike && !differ(out.after[feet * m + i], out.after[feet * 2 + i], 1e-9);
  }
  out.alike = alike ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(restitution, friction, tilt, sideways, right_first, time), Output,
       FIELDS(problem, mass, inertia, width, height, velocity, lever_arms, b, impulses, before,
              after, angular_velocity, energy, box, angle, sunk, turns, closes, alike))
