// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// The question "impulses": the velocities of bodies after simultaneous contacts without friction;
// class (a), the complementarity problem solved in fractions and each coordinate rounded once. A
// method is right if the error of every velocity is at most 2^-30 of the largest initial one. The
// question "points": the number of contact points of two bodies; class (a), by counting corners and
// clipping polygons in fractions. A count is right if it is equal.
#include "support/hard_cases.hpp"

#include <algorithm>
#include <cmath>
#include <contact/closed_proximity.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <vector>

#include "09_separating_planes/shape_oracle.hpp"

using contact::BodyContact;
using contact::RigidBody;
using hard_cases::Case;
using hard_cases::convert;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;
using oracle::Vector;

namespace {

using V = contact::Vector3<double>;
using Box = contact::OrientedBox<double>;

template <class S>
struct Problem {
  std::vector<RigidBody<S>> bodies;
  std::vector<BodyContact<S>> contacts;
};

/// Nine numbers for each body: mass (0: immovable), moment of inertia about any axis, position,
/// velocity, and angular velocity about y. Nine numbers for each contact: A, B, point, normal,
/// least velocity.
template <class S>
Problem<S> problem(const Case& c) {
  Problem<S> p;
  const std::vector<double> b = c.numbers("bodies");
  const auto vector = [](const std::vector<double>& all, std::size_t i) {
    return contact::Vector3<S>(convert<S>(all[i]), convert<S>(all[i + 1]), convert<S>(all[i + 2]));
  };
  for (std::size_t i = 0; i + 8 < b.size(); i += 9) {
    RigidBody<S> body;
    if (b[i] > 0) {
      body.mass = convert<S>(b[i]);
      body.inverse_mass = S(1) / body.mass;
      body.inertia = contact::Matrix3<S>::Identity() * convert<S>(b[i + 1]);
      body.inverse_inertia = contact::Matrix3<S>::Identity() * S(S(1) / convert<S>(b[i + 1]));
    }
    body.position = vector(b, i + 2);
    body.velocity = vector(b, i + 5);
    body.angular_velocity = contact::Vector3<S>(S(0), convert<S>(b[i + 8]), S(0));
    p.bodies.push_back(body);
  }
  const std::vector<double> k = c.numbers("contacts");
  for (std::size_t i = 0; i + 8 < k.size(); i += 9) {
    p.contacts.push_back({static_cast<int>(k[i]), static_cast<int>(k[i + 1]), vector(k, i + 2),
                          vector(k, i + 5), S(0), convert<S>(k[i + 8])});
  }
  return p;
}

bool right(const Case& c, const std::vector<RigidBody<double>>& got, const Json& answer) {
  double most = 0;
  for (const auto& body : problem<double>(c).bodies) {
    most = std::max(
        {most, body.velocity.cwiseAbs().maxCoeff(), body.angular_velocity.cwiseAbs().maxCoeff()});
  }
  std::size_t at = 0;
  for (const auto& body : got) {
    for (const V& v : {body.velocity, body.angular_velocity}) {
      for (int i = 0; i < 3; ++i) {
        const double wanted = unhex(answer.at("motion").at(at++));
        if (!(std::abs(v(i) - wanted) <= std::ldexp(most, -30))) return false;
      }
    }
  }
  return true;
}

/// Each contact as a separate collision, for a number of iterations.
std::vector<RigidBody<double>> one_by_one(Problem<double> p, int rounds) {
  for (int i = 0; i < rounds; ++i) {
    for (const auto& c : p.contacts) {
      auto& a = p.bodies[static_cast<std::size_t>(c.a)];
      auto& b = p.bodies[static_cast<std::size_t>(c.b)];
      const double v = contact::contact_velocity(p.bodies, c);
      const double k = contact::inverse_effective_mass<double>(a, b, c.point, c.normal, c.normal);
      if (!(v < c.min_velocity) || k == 0) continue;
      const V impulse = c.normal * ((c.min_velocity - v) / k);
      a = contact::after_impulse<double>(a, impulse, c.point);
      b = contact::after_impulse<double>(b, V(-impulse), c.point);
    }
  }
  return p.bodies;
}

/// All velocities to their least values simultaneously, pulls included.
std::vector<RigidBody<double>> glued(const Problem<double>& p) {
  std::vector<double> wanted;
  for (const auto& c : p.contacts) {
    wanted.push_back(c.min_velocity - contact::contact_velocity(p.bodies, c));
  }
  const auto x = contact::detail::solve_linear(
      contact::inverse_effective_mass_matrix(p.bodies, p.contacts), wanted);
  return x ? contact::after_normal_impulses(p.bodies, p.contacts, *x) : p.bodies;
}

void add_impulses(hard_cases::Runner& runner) {
  runner.question("impulses", [](const Case& c) {
    const auto p = problem<Rational>(c);
    const auto x = contact::complementary_impulses(p.bodies, p.contacts);
    Json motion = Json::array();
    if (x) {
      for (const auto& body : contact::after_normal_impulses(p.bodies, p.contacts, *x)) {
        for (const Vector& v : {body.velocity, body.angular_velocity}) {
          for (int i = 0; i < 3; ++i) motion.push_back(hard_cases::hex(oracle::nearest(v(i))));
        }
      }
    }
    return Json{{"class", "a"}, {"motion", motion}};
  });
  runner.method("impulses", "one collision after the other", [](const Case& c, const Json& answer) {
    return right(c, one_by_one(problem<double>(c), 1), answer);
  });
  runner.method("impulses", "the same, a hundred rounds", [](const Case& c, const Json& answer) {
    return right(c, one_by_one(problem<double>(c), 100), answer);
  });
  runner.method("impulses", "all at once, pulls allowed", [](const Case& c, const Json& answer) {
    return right(c, glued(problem<double>(c)), answer);
  });
  runner.method("impulses", "ten sweeps", [](const Case& c, const Json& answer) {
    const auto p = problem<double>(c);
    return right(c,
                 contact::solve_contacts<double>(p.bodies, p.contacts, {}, {10, 0.0, 1.0}).bodies,
                 answer);
  });
  runner.method("impulses", "book", [](const Case& c, const Json& answer) {
    const auto p = problem<double>(c);
    return right(
        c, contact::solve_contacts<double>(p.bodies, p.contacts, {}, {200000, 1e-15, 1.0}).bodies,
        answer);
  });
}

Box box(const Case& c, const std::string& name) {
  Box b;
  b.centre = c.vector(name + "_centre");
  b.half_lengths = c.vector(name + "_half");
  if (c.has(name + "_axes")) {
    const std::vector<double> all = c.numbers(name + "_axes");
    for (int i = 0; i < 9; ++i) b.axes(i % 3, i / 3) = all.at(static_cast<std::size_t>(i));
  }
  return b;
}
contact::HalfSpace<double> half_space(const Case& c) {
  return {{c.vector("b_normal"), c.number("b_offset")}};
}

/// In fractions. On a half-space: corners within the margin, at most four. On a box: the part of
/// A's incident face over the face "axis" of B (1 to 3, negative for the lower side), with corners
/// that coincide counted once.
int exact_points(const Case& c) {
  const auto a = shape_oracle::exact(box(c, "a"));
  const Rational margin = oracle::exact(c.number("margin"));
  if (c.has("b_normal")) {
    const auto h = half_space(c);
    int count = 0;
    for (int k = 0; k < 8; ++k) {
      const Rational height =
          oracle::exact(h.boundary.normal).dot(contact::box_corner<Rational>(a, k)) -
          oracle::exact(h.boundary.offset);
      count += height <= margin ? 1 : 0;
    }
    return std::min(count, 4);
  }
  const auto b = shape_oracle::exact(box(c, "b"));
  const int axis = static_cast<int>(std::abs(c.number("axis"))) - 1;
  const Vector up = b.axes.col(axis) * Rational(c.number("axis") > 0 ? 1 : -1);
  const auto face = contact::face_towards<Rational>(a, Vector(-up));
  const auto polygon = contact::polygon_over_face<Rational>(
      std::vector<Vector>(face.corners.begin(), face.corners.end()), b, axis);
  std::vector<Vector> distinct;
  for (const Vector& p : polygon) {
    const Rational height = up.dot(Vector(p - b.centre)) - b.half_lengths(axis);
    if (height > margin) continue;
    bool known = false;
    for (const Vector& q : distinct) known = known || q == p;
    if (!known) distinct.push_back(p);
  }
  return static_cast<int>(distinct.size());
}

void add_points(hard_cases::Runner& runner) {
  runner.question("points", [](const Case& c) {
    return Json{{"class", "a"}, {"points", exact_points(c)}};
  });
  runner.method("points", "the deepest point", [](const Case& c, const Json& answer) {
    const double d = c.has("b_normal")
                         ? contact::signed_distance(box(c, "a"), half_space(c)).distance
                         : contact::signed_distance(box(c, "a"), box(c, "b")).distance;
    return (d <= c.number("margin") ? 1 : 0) == answer.at("points").get<int>();
  });
  runner.method("points", "A's corners inside B", [](const Case& c, const Json& answer) {
    int count = 0;
    for (int k = 0; k < 8; ++k) {
      const V p = contact::box_corner(box(c, "a"), k);
      const double d =
          c.has("b_normal")
              ? contact::signed_distance(contact::Sphere<double>{p, 0}, half_space(c)).distance
              : contact::signed_distance(contact::Sphere<double>{p, 0}, box(c, "b")).distance;
      count += d <= c.number("margin") ? 1 : 0;
    }
    return count == answer.at("points").get<int>();
  });
  runner.method("points", "book", [](const Case& c, const Json& answer) {
    const double margin = c.number("margin");
    const auto manifold = c.has("b_normal")
                              ? contact::contact_manifold(box(c, "a"), half_space(c), margin)
                              : contact::contact_manifold(box(c, "a"), box(c, "b"), margin);
    std::vector<V> distinct;
    for (const auto& p : manifold.points) {
      bool known = false;
      for (const V& q : distinct) known = known || q == p.point;
      if (!known) distinct.push_back(p.point);
    }
    return static_cast<int>(distinct.size()) == answer.at("points").get<int>();
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("18_contacts");
  add_impulses(runner);
  add_points(runner);
  return runner.run(argc, argv);
}
