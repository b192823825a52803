/// @file
/// Bodies and contacts of a hard case, and solvers as they are often written.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "hard_scale.hpp"
#include "support/hard_cases.hpp"

namespace hard_problem {

using contact::BodyContact;
using contact::RigidBody;
using hard_cases::Case;
using hard_cases::Json;
using hard_cases::unhex;
using hard_scale::unit_of_length;
using oracle::Rational;
using oracle::Vector;

using V = contact::Vector3<double>;

template <class S>
S as(double x) {
  if constexpr (std::is_floating_point_v<S>) {
    return static_cast<S>(x);
  } else {
    return oracle::exact(x);
  }
}
template <class S>
contact::Vector3<S> vector_at(const std::vector<double>& all, std::size_t i) {
  return {as<S>(all[i]), as<S>(all[i + 1]), as<S>(all[i + 2])};
}

template <class S>
struct Problem {
  std::vector<RigidBody<S>> bodies;
  std::vector<BodyContact<S>> contacts;
};

/// Nine numbers for each body: mass (0: immovable), moment of inertia about any axis, position,
/// velocity, and angular velocity about y. Nine numbers for each contact: A, B, point, normal,
/// least velocity. "friction", if the case has it: one μ for each contact.
template <class S>
Problem<S> problem(const Case& c) {
  Problem<S> p;
  const std::vector<double> b = c.numbers("bodies");
  for (std::size_t i = 0; i + 8 < b.size(); i += 9) {
    RigidBody<S> body;
    if (b[i] > 0) {
      body.mass = as<S>(b[i]);
      body.inverse_mass = S(1) / body.mass;
      body.inertia = contact::Matrix3<S>::Identity() * as<S>(b[i + 1]);
      body.inverse_inertia = contact::Matrix3<S>::Identity() * S(S(1) / as<S>(b[i + 1]));
    }
    body.position = vector_at<S>(b, i + 2);
    body.velocity = vector_at<S>(b, i + 5);
    body.angular_velocity = contact::Vector3<S>(S(0), as<S>(b[i + 8]), S(0));
    p.bodies.push_back(body);
  }
  const std::vector<double> k = c.numbers("contacts");
  const std::vector<double> friction =
      c.has("friction") ? c.numbers("friction") : std::vector<double>(k.size() / 9, 0.0);
  for (std::size_t i = 0; i + 8 < k.size(); i += 9) {
    p.contacts.push_back({static_cast<int>(k[i]), static_cast<int>(k[i + 1]),
                          vector_at<S>(k, i + 2), vector_at<S>(k, i + 5), as<S>(friction.at(i / 9)),
                          as<S>(k[i + 8])});
  }
  return p;
}

/// The velocities of all bodies as the corpus writes them, each coordinate rounded once.
inline Json motion_of(const std::vector<RigidBody<Rational>>& bodies) {
  Json motion = Json::array();
  for (const auto& body : bodies) {
    for (const Vector& v : {body.velocity, body.angular_velocity}) {
      for (int i = 0; i < 3; ++i) motion.push_back(hard_cases::hex(oracle::nearest(v(i))));
    }
  }
  return motion;
}

/// The largest coordinate of a velocity, or of an angular velocity times the unit of length.
inline double largest_velocity(const std::vector<RigidBody<double>>& bodies, double length) {
  double most = 0;
  for (const auto& body : bodies) {
    most = std::max({most, body.velocity.cwiseAbs().maxCoeff(),
                     body.angular_velocity.cwiseAbs().maxCoeff() * length});
  }
  return most;
}
/// Every coordinate may be off by 2^-30 of the largest initial one; angular velocities count times
/// the unit of length.
template <class S>
bool right(const Case& c, const std::vector<RigidBody<S>>& got, const Json& answer) {
  const double length = unit_of_length(c);
  const double room = std::ldexp(largest_velocity(problem<double>(c).bodies, length), -30);
  std::size_t at = 0;
  for (const auto& body : got) {
    for (const bool turns : {false, true}) {
      const contact::Vector3<S>& v = turns ? body.angular_velocity : body.velocity;
      for (int i = 0; i < 3; ++i) {
        const double off = static_cast<double>(v(i)) - unhex(answer.at("motion").at(at++));
        if (!(std::abs(off) * (turns ? length : 1) <= room)) return false;
      }
    }
  }
  return true;
}

/// How a solver of one contact after the other is written. The default: each contact is a
/// collision of its own, once.
struct Rule {
  int iterations = 1;
  bool reversed = false;             ///< the list from its end
  bool accumulate = false;           ///< clamps the sum of a contact's impulses, not each change
  bool pyramid = false;              ///< clamps friction along two axes separately
  bool by_mass = false;              ///< without the rotation in the effective mass
  bool shared = false;               ///< divides each impulse by the number of contacts
  std::vector<double> normals = {};  ///< limits friction by μ times these, not by the sums so far
  bool friction_only = false;        ///< leaves the normal velocities as they are
};

/// The bodies after the iterations. Friction acts after the normal impulse of its contact.
template <class S>
std::vector<RigidBody<S>> iterate(Problem<S> p, const Rule& rule,
                                  std::vector<S>* normal_impulses = nullptr) {
  std::vector<S> normal(p.contacts.size(), S(0));
  std::vector<contact::Vector3<S>> friction(p.contacts.size(), contact::Vector3<S>::Zero());
  const auto effective = [&](const BodyContact<S>& c, const contact::Vector3<S>& n) {
    const auto& a = p.bodies[static_cast<std::size_t>(c.a)];
    const auto& b = p.bodies[static_cast<std::size_t>(c.b)];
    if (rule.by_mass) return S(a.inverse_mass + b.inverse_mass);
    return contact::inverse_effective_mass<S>(a, b, c.point, n, n);
  };
  const auto apply = [&](const BodyContact<S>& c, const contact::Vector3<S>& impulse) {
    auto& a = p.bodies[static_cast<std::size_t>(c.a)];
    auto& b = p.bodies[static_cast<std::size_t>(c.b)];
    a = contact::after_impulse<S>(a, impulse, c.point);
    b = contact::after_impulse<S>(b, contact::Vector3<S>(-impulse), c.point);
  };
  const S share = rule.shared ? static_cast<S>(p.contacts.size()) : S(1);
  const auto visit = [&](std::size_t i) {
    const BodyContact<S>& c = p.contacts[i];
    const S k = effective(c, c.normal);
    if (!(k > S(0))) return;
    S limit = normal[i];
    if (!rule.friction_only) {
      S change = (c.min_velocity - contact::contact_velocity(p.bodies, c)) / k / share;
      change = rule.accumulate ? std::max(S(-normal[i]), change) : std::max(S(0), change);
      normal[i] += change;
      apply(c, contact::Vector3<S>(c.normal * change));
      limit = rule.accumulate ? normal[i] : change;
    }
    if (!rule.normals.empty()) limit = static_cast<S>(rule.normals.at(i));
    limit *= c.friction;
    if (!(c.friction > S(0))) return;
    const contact::Vector3<S> relative =
        contact::velocity_at(p.bodies[static_cast<std::size_t>(c.a)], c.point) -
        contact::velocity_at(p.bodies[static_cast<std::size_t>(c.b)], c.point);
    const contact::Vector3<S> slip = relative - c.normal * c.normal.dot(relative);
    const contact::Vector3<S> before =
        rule.accumulate ? friction[i] : contact::Vector3<S>(contact::Vector3<S>::Zero());
    contact::Vector3<S> next = before;
    if (rule.pyramid) {
      next.setZero();
      const contact::Vector3<S> two = c.normal.cross(contact::Vector3<S>::UnitX()).normalized();
      for (const contact::Vector3<S>& t : {contact::Vector3<S>(two.cross(c.normal)), two}) {
        const S wanted = before.dot(t) - slip.dot(t) / effective(c, t) / share;
        next += t * std::clamp(wanted, S(-limit), limit);
      }
    } else {
      const S speed = slip.norm();
      if (speed > S(0)) {
        const S mass = effective(c, contact::Vector3<S>(slip / speed));
        next -= slip / mass / share;
      }
      const S length = next.norm();
      if (length > limit) next *= limit / length;
    }
    friction[i] = next;
    apply(c, contact::Vector3<S>(next - before));
  };
  for (int round = 0; round < rule.iterations; ++round) {
    for (std::size_t i = 0; i < p.contacts.size(); ++i)
      visit(rule.reversed ? p.contacts.size() - 1 - i : i);
  }
  if (normal_impulses != nullptr) *normal_impulses = normal;
  return p.bodies;
}

/// All contacts of two bodies replaced by one, at the mean of their points, with the mean of their
/// normals.
template <class S>
Problem<S> with_mean_points(Problem<S> p) {
  std::vector<BodyContact<S>> means;
  std::vector<int> counts;
  for (const BodyContact<S>& c : p.contacts) {
    std::size_t i = 0;
    while (i < means.size() && (means[i].a != c.a || means[i].b != c.b)) ++i;
    if (i == means.size()) {
      means.push_back(c);
      counts.push_back(1);
    } else {
      means[i].point += c.point;
      means[i].normal += c.normal;
      means[i].min_velocity = std::max(means[i].min_velocity, c.min_velocity);
      ++counts[i];
    }
  }
  for (std::size_t i = 0; i < means.size(); ++i) {
    means[i].point /= static_cast<S>(counts[i]);
    means[i].normal.normalize();
  }
  p.contacts = means;
  return p;
}

/// The book's solver. Its tolerance is a fraction of the fastest contact, because velocities may be
/// of any size.
inline std::vector<RigidBody<double>> by_book(const Problem<double>& p, int iterations) {
  double fastest = 0;
  for (const auto& c : p.contacts) {
    fastest = std::max({fastest, std::abs(contact::contact_velocity(p.bodies, c)), c.min_velocity});
  }
  return contact::solve_contacts<double>(p.bodies, p.contacts, {},
                                         {iterations, 1e-15 * fastest, 1.0})
      .bodies;
}

}  // namespace hard_problem
