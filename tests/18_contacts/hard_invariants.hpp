/// @file
/// What must hold whatever the impulses are: contacts without restitution add no energy, a scene
/// that is symmetric about the plane x = 0 stays symmetric to the last bit, and balls of equal mass
/// in a row exchange their velocities.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/contact_energy.hpp>
#include <contact/contact_iterations.hpp>
#include <contact/cradle.hpp>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "hard_problem.hpp"
#include "support/hard_cases.hpp"

namespace hard_invariants {

using hard_problem::as;
using hard_problem::BodyContact;
using hard_problem::Case;
using hard_problem::Json;
using hard_problem::Problem;
using hard_problem::problem;
using hard_problem::Rational;
using hard_problem::RigidBody;
using hard_problem::V;
using hard_problem::Vector;
using hard_problem::vector_at;

// ------------------------------------------------------------------------------------------ energy

/// Thirteen numbers for each body: mass (0: immovable), moments of inertia about x, y and z,
/// position, velocity and angular velocity. Ten for each contact: A, B, point, normal, μ, least
/// velocity. The normal is normalised.
template <class S>
Problem<S> solid_problem(const Case& c) {
  Problem<S> p;
  const std::vector<double> b = c.numbers("bodies");
  for (std::size_t i = 0; i + 12 < b.size(); i += 13) {
    RigidBody<S> body;
    if (b[i] > 0) {
      body.mass = as<S>(b[i]);
      body.inverse_mass = S(1) / body.mass;
      for (int k = 0; k < 3; ++k) {
        const S moment = as<S>(b[i + 1 + static_cast<std::size_t>(k)]);
        body.inertia(k, k) = moment;
        body.inverse_inertia(k, k) = S(1) / moment;
      }
    }
    body.position = vector_at<S>(b, i + 4);
    body.velocity = vector_at<S>(b, i + 7);
    body.angular_velocity = vector_at<S>(b, i + 10);
    p.bodies.push_back(body);
  }
  const std::vector<double> k = c.numbers("contacts");
  for (std::size_t i = 0; i + 9 < k.size(); i += 10) {
    p.contacts.push_back({static_cast<int>(k[i]), static_cast<int>(k[i + 1]),
                          vector_at<S>(k, i + 2), vector_at<S>(k, i + 5), as<S>(k[i + 8]),
                          as<S>(k[i + 9])});
  }
  return p;
}
/// In fractions, of velocities as they are stored.
inline Rational energy_of(const std::vector<RigidBody<Rational>>& exact,
                          const std::vector<RigidBody<double>>& now) {
  Rational sum(0);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Vector v = oracle::exact(now[i].velocity);
    const Vector w = oracle::exact(now[i].angular_velocity);
    sum += exact[i].mass * v.dot(v) + w.dot(Vector(exact[i].inertia * w));
  }
  return sum / 2;
}

inline void add_energy(hard_cases::Runner& runner) {
  runner.question("energy", [](const Case& c) {
    return Json{
        {"class", "a"},
        {"most", hard_cases::hex(oracle::nearest(energy_of(solid_problem<Rational>(c).bodies,
                                                           solid_problem<double>(c).bodies)))}};
  });
  // It may grow by rounding, by at most 2^-40 of itself.
  const auto method = [&runner](const char* name, auto solve) {
    runner.method("energy", name, [solve](const Case& c, const Json& answer) {
      const auto after = solve(solid_problem<double>(c));
      const Rational most = oracle::exact(hard_cases::unhex(answer, "most"));
      const Rational got = energy_of(solid_problem<Rational>(c).bodies, after);
      return got <= most + most / Rational(std::ldexp(1.0, 40));
    });
  };
  const auto iterated = [](const Problem<double>& p, int iterations) {
    const auto prepared = contact::detail::prepared_contacts(p.bodies, p.contacts);
    std::vector<contact::detail::ImpulseComponents<double>> impulses(prepared.size());
    for (auto& x : impulses) x = {0.0, 0.0, 0.0};
    auto bodies = p.bodies;
    for (int i = 0; i < iterations; ++i)
      contact::detail::gauss_seidel_iteration(bodies, prepared, impulses, 1.0);
    return bodies;
  };
  method("one iteration", [iterated](const Problem<double>& p) { return iterated(p, 1); });
  method("ten iterations as they come",
         [iterated](const Problem<double>& p) { return iterated(p, 10); });
  method("a thousand iterations as they come",
         [iterated](const Problem<double>& p) { return iterated(p, 1000); });
  method("normals first, then friction, as they come", [](const Problem<double>& p) {
    Problem<double> smooth = p;
    for (auto& c : smooth.contacts) c.friction = 0;
    hard_problem::Rule rule{1000};
    rule.accumulate = true;
    std::vector<double> normals;
    smooth.bodies = hard_problem::iterate(smooth, rule, &normals);
    rule.normals = normals;
    rule.friction_only = true;
    return hard_problem::iterate(Problem<double>{smooth.bodies, p.contacts}, rule);
  });
  method("book, ten iterations", [](const Problem<double>& p) {
    return contact::solve_contacts<double>(p.bodies, p.contacts, {}, {10, 0.0, 1.0}).bodies;
  });
  method("book", [](const Problem<double>& p) {
    return contact::solve_contacts<double>(p.bodies, p.contacts, {}, {1000, 1e-14, 1.0}).bodies;
  });
}

// ---------------------------------------------------------------------------------------- symmetry

template <class S>
contact::Vector3<S> reflected(const contact::Vector3<S>& v) {
  return {-v.x(), v.y(), v.z()};
}
/// Whether b is the mirror image of a at the plane x = 0. An angular velocity about y changes sign.
template <class S>
bool images(const RigidBody<S>& a, const RigidBody<S>& b, bool moving) {
  const bool still = a.mass == b.mass && a.inertia == b.inertia &&
                     b.position == reflected(contact::Vector3<S>(a.position));
  return (moving || still) && b.velocity == reflected(contact::Vector3<S>(a.velocity)) &&
         b.angular_velocity.y() == -a.angular_velocity.y() &&
         b.angular_velocity.z() == -a.angular_velocity.z() &&
         b.angular_velocity.x() == a.angular_velocity.x();
}
/// The partner of each body, from the field "mirror".
inline bool symmetric(const Case& c, const std::vector<RigidBody<double>>& bodies, bool moving) {
  const std::vector<double> partner = c.numbers("mirror");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!images(bodies[i], bodies.at(static_cast<std::size_t>(partner.at(i))), moving))
      return false;
  }
  return true;
}
inline bool same_contact(const BodyContact<double>& one, const BodyContact<double>& other,
                         const std::vector<double>& partner) {
  return static_cast<int>(partner.at(static_cast<std::size_t>(one.a))) == other.a &&
         static_cast<int>(partner.at(static_cast<std::size_t>(one.b))) == other.b &&
         other.point == reflected(one.point) && other.normal == reflected(one.normal) &&
         one.friction == other.friction && one.min_velocity == other.min_velocity;
}

inline void add_symmetry(hard_cases::Runner& runner) {
  runner.question("symmetry", [](const Case& c) {
    const auto p = problem<double>(c);
    const std::vector<double> partner = c.numbers("mirror");
    bool all = symmetric(c, p.bodies, false);
    for (const auto& one : p.contacts) {
      all = all && std::any_of(p.contacts.begin(), p.contacts.end(), [&](const auto& other) {
              return same_contact(one, other, partner);
            });
    }
    if (!all) throw std::invalid_argument(c.name() + ": the input is not symmetric");
    return Json{{"class", "a"}, {"symmetric", true}};
  });
  const auto method = [&runner](const char* name, auto solve) {
    runner.method("symmetry", name, [solve](const Case& c, const Json& answer) {
      return symmetric(c, solve(problem<double>(c)), true) == answer.at("symmetric").get<bool>();
    });
  };
  const auto solve = [](const Problem<double>& p, int iterations, bool jacobi) {
    return contact::solve_contacts<double>(p.bodies, p.contacts, {},
                                           {iterations, 1e-15, 1.0, jacobi})
        .bodies;
  };
  method("one contact after the other",
         [](const Problem<double>& p) { return hard_problem::iterate(p, {}); });
  method("ten iterations", [solve](const Problem<double>& p) { return solve(p, 10, false); });
  method("Gauss–Seidel, a thousand iterations",
         [solve](const Problem<double>& p) { return solve(p, 1000, false); });
  method("book, Jacobi, ten iterations",
         [solve](const Problem<double>& p) { return solve(p, 10, true); });
  method("book", [solve](const Problem<double>& p) { return solve(p, 1000, true); });
}

// --------------------------------------------------------------------------------------------- row

/// Velocities of touching balls of equal mass with e = 1. Each pair that approaches exchanges its
/// velocities, in whatever order: in the end they are sorted.
inline void add_row(hard_cases::Runner& runner) {
  runner.question("row", [](const Case& c) {
    std::vector<double> v = c.numbers("velocities");
    std::sort(v.begin(), v.end());
    Json sorted = Json::array();
    for (const double x : v) sorted.push_back(hard_cases::hex(x));
    return Json{{"class", "a"}, {"velocities", sorted}};
  });
  const auto method = [&runner](const char* name, auto solve) {
    runner.method("row", name, [solve](const Case& c, const Json& answer) {
      const std::vector<double> start = c.numbers("velocities");
      const std::vector<double> got = solve(start);
      double most = 0;
      for (const double v : start) most = std::max(most, std::abs(v));
      for (std::size_t i = 0; i < got.size(); ++i) {
        const double wanted = hard_cases::unhex(answer.at("velocities").at(i));
        if (!(std::abs(got[i] - wanted) <= std::ldexp(most, -30))) return false;
      }
      return true;
    });
  };
  const auto passes = [](std::vector<double> v, bool reversed) {
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
      const std::size_t k = reversed ? v.size() - 2 - i : i;
      if (v[k] > v[k + 1]) std::swap(v[k], v[k + 1]);
    }
    return v;
  };
  method("the pairs once, from the left",
         [passes](const std::vector<double>& v) { return passes(v, false); });
  method("the pairs once, from the right",
         [passes](const std::vector<double>& v) { return passes(v, true); });
  method("Newton's restitution at all contacts simultaneously", [](const std::vector<double>& v) {
    Problem<double> p;
    for (std::size_t i = 0; i < v.size(); ++i) {
      RigidBody<double> ball;
      ball.mass = ball.inverse_mass = 1;
      ball.position = V(static_cast<double>(i), 0, 0);
      ball.velocity = V(v[i], 0, 0);
      p.bodies.push_back(ball);
      if (i == 0) continue;
      const int k = static_cast<int>(i);
      p.contacts.push_back({k, k - 1, V(static_cast<double>(i) - 0.5, 0, 0), V(1, 0, 0), 0.0,
                            std::max(0.0, v[i - 1] - v[i])});
    }
    std::vector<double> after;
    for (const auto& body : hard_problem::by_book(p, 100000)) after.push_back(body.velocity.x());
    return after;
  });
  method("book", [](const std::vector<double>& v) {
    std::vector<contact::LineBody<double>> row;
    for (const double x : v) row.push_back(contact::line_body(1.0, x));
    return contact::collide_row(row, 1.0, contact::PairOrder::fastest_first, 10000).velocities;
  });
}

inline void add(hard_cases::Runner& runner) {
  add_energy(runner);
  add_symmetry(runner);
  add_row(runner);
}

}  // namespace hard_invariants
