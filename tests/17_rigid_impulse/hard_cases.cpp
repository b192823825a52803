// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// Answers of class (a) are rational in the stored numbers, and rounded once: which of the three
// cases of closing, the motion after a frictionless collision or an impact by Newton's or Poisson's
// law, the moments of a mesh. Those of class (b) hold the square root of Stronge's law; those of
// class (c) the sine of an angle. A decision is right if it is the same; a velocity or an angular
// velocity if it is off by at most 2^-36 of those that went in and came out. Whether bodies
// separate afterwards is the sign of v_n, computed without rounding.
#include "support/hard_cases.hpp"

#include <algorithm>
#include <cmath>
#include <contact/impact_friction.hpp>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/rotation.hpp>
#include <vector>

#include "hard_bodies.hpp"

using hard_bodies::body;
using hard_bodies::contact_of;
using hard_bodies::planar;
using hard_cases::Case;
using hard_cases::close;
using hard_cases::hex;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;

namespace {

using hard_bodies::V;
using M = contact::Matrix3<double>;
using Body = contact::RigidBody<double>;
using Exactly = contact::RigidBody<Rational>;

int sign_of(double x) { return (x > 0) - (x < 0); }

void add_closing(hard_cases::Runner& runner) {
  runner.question("closing", [](const Case& c) {
    const Rational v = contact::normal_velocity(body<Rational>(c, "a"), body<Rational>(c, "b"),
                                                contact_of<Rational>(c));
    return Json{{"class", "a"}, {"sign", oracle::sign(v)}};
  });
  const auto method = [&runner](const char* name, auto sign) {
    runner.method("closing", name, [sign](const Case& c, const Json& answer) {
      return sign(body<double>(c, "a"), body<double>(c, "b"), contact_of<double>(c)) ==
             answer.at("sign").get<int>();
    });
  };
  method("velocities of the centres", [](const Body& a, const Body& b, const auto& at) {
    return sign_of(at.normal.dot(a.velocity - b.velocity));
  });
  method("ω × r reversed", [](const Body& a, const Body& b, const auto& at) {
    const V va = a.velocity - V(a.angular_velocity.cross(V(at.point - a.position)));
    const V vb = b.velocity - V(b.angular_velocity.cross(V(at.point - b.position)));
    return sign_of(at.normal.dot(va - vb));
  });
  method("float", [](const Body& a, const Body& b, const auto& at) {
    const auto speed = [&](const Body& x) {
      const Eigen::Vector3f r = at.point.template cast<float>() - x.position.cast<float>();
      return Eigen::Vector3f(x.velocity.cast<float>() + x.angular_velocity.cast<float>().cross(r));
    };
    return sign_of(at.normal.template cast<float>().dot(speed(a) - speed(b)));
  });
  method("double", [](const Body& a, const Body& b, const auto& at) {
    return sign_of(
        at.normal.dot(contact::velocity_at(a, at.point) - contact::velocity_at(b, at.point)));
  });
  method("book", [](const Body& a, const Body& b, const auto& at) {
    return sign_of(contact::normal_velocity(a, b, at));
  });
}

/// Collisions of stout bodies, and of slender rotated ones: the same question, and other ways to
/// fail.
void add_collision(hard_cases::Runner& runner, const std::string& question) {
  runner.question(question, [](const Case& c) {
    const Rational j =
        contact::collision_impulse<Rational>(body<Rational>(c, "a"), body<Rational>(c, "b"),
                                             contact_of<Rational>(c), oracle::exact(c.number("e")));
    return Json{{"class", "a"}, {"impulse", hex(j)}};
  });
  // The motion that the exact impulse gives, coordinate by coordinate.
  const auto judge = [](const Body& before, const Body& after, const Exactly& right) {
    const V velocity = oracle::nearest(right.velocity);
    const V angular_velocity = oracle::nearest(right.angular_velocity);
    const double v = before.velocity.norm() + velocity.norm();
    const double w = before.angular_velocity.norm() + angular_velocity.norm();
    for (int k = 0; k < 3; ++k) {
      if (!close(after.velocity(k), velocity(k), std::ldexp(v, -36))) return false;
      if (!close(after.angular_velocity(k), angular_velocity(k), std::ldexp(w, -36))) return false;
    }
    return true;
  };
  const auto method = [&runner, &question, judge](const char* name, auto collide) {
    runner.method(question, name, [judge, collide](const Case& c, const Json&) {
      const Body a = body<double>(c, "a");
      const Body b = body<double>(c, "b");
      const auto right =
          contact::collide<Rational>(body<Rational>(c, "a"), body<Rational>(c, "b"),
                                     contact_of<Rational>(c), oracle::exact(c.number("e")));
      const auto [a2, b2] = collide(a, b, contact_of<double>(c), c.number("e"), c);
      return judge(a, a2, right.a) && judge(b, b2, right.b);
    });
  };
  using Pair = std::pair<Body, Body>;
  const auto push = [](const Body& a, const Body& b, const auto& at, double j) -> Pair {
    return {contact::after_impulse<double>(a, V(at.normal * j), at.point),
            contact::after_impulse<double>(b, V(at.normal * -j), at.point)};
  };
  if (question == "collision") {
    method("no rotation",
           [push](const Body& a, const Body& b, const auto& at, double e, const Case&) -> Pair {
             return push(a, b, at, contact::impulse_without_rotation(a, b, at, e));
           });
    method("no test",
           [push](const Body& a, const Body& b, const auto& at, double e, const Case&) -> Pair {
             const double k =
                 contact::inverse_effective_mass<double>(a, b, at.point, at.normal, at.normal);
             return push(a, b, at, -(1 + e) * contact::normal_velocity(a, b, at) / k);
           });
    method("mass product",
           [push](const Body& a, const Body& b, const auto& at, double e, const Case&) -> Pair {
             // Multiplied through by m_A m_B. An immovable body has mass 0 here: no impulse.
             const double v = contact::normal_velocity(a, b, at);
             if (!(v < 0)) return {a, b};
             Body alone_a = a;
             Body alone_b = b;
             alone_a.inverse_mass = alone_b.inverse_mass = 0;
             const double turn = contact::inverse_effective_mass<double>(alone_a, alone_b, at.point,
                                                                         at.normal, at.normal);
             const double product = a.mass * b.mass;
             return push(a, b, at, -(1 + e) * v * product / (a.mass + b.mass + product * turn));
           });
  } else {
    method("full tensor",
           [push](const Body& a, const Body& b, const auto& at, double e, const Case&) -> Pair {
             const auto full = [](Body x) {
               if (x.mass > 0) {
                 const auto inverse = contact::inverse_of_symmetric<double>(x.inertia);
                 x.inverse_inertia = inverse ? *inverse : M::Constant(std::nan(""));
               }
               return x;
             };
             const Body a2 = full(a);
             const Body b2 = full(b);
             return push(a2, b2, at, contact::collision_impulse<double>(a2, b2, at, e));
           });
    method("body axes",
           [push](const Body& a, const Body& b, const auto& at, double e, const Case& c) -> Pair {
             const auto unturned = [&](Body x, const char* moments) {
               if (x.mass > 0) x.inverse_inertia = V(c.vector(moments).cwiseInverse()).asDiagonal();
               return x;
             };
             const Body a2 = unturned(a, "a_moments");
             const Body b2 = unturned(b, "b_moments");
             return push(a2, b2, at, contact::collision_impulse<double>(a2, b2, at, e));
           });
    method("scalar inertia",
           [push](const Body& a, const Body& b, const auto& at, double e, const Case& c) -> Pair {
             // One number in place of the tensor, the mean of the moments.
             const auto round = [&](Body x, const char* moments) {
               if (x.mass > 0) x.inverse_inertia = 3 / c.vector(moments).sum() * M::Identity();
               return x;
             };
             const Body a2 = round(a, "a_moments");
             const Body b2 = round(b, "b_moments");
             return push(a2, b2, at, contact::collision_impulse<double>(a2, b2, at, e));
           });
    method("by vectors",
           [](const Body& a, const Body& b, const auto& at, double e, const Case& c) -> Pair {
             // R (I⁻¹ (Rᵀ x)): no tensor is formed, so nothing cancels in one.
             M turn = M::Identity();
             if (c.has("turn")) {
               const V t = c.vector("turn");
               turn << t.x(), -t.y(), 0, t.y(), t.x(), 0, 0, 0, 1;
             }
             const auto turned = [&](const Body& x, const char* moments) -> V {
               if (x.mass == 0) return V::Zero();
               const V moment = V(at.point - x.position).cross(at.normal);
               return contact::free_angular_velocity<double>(moment, c.vector(moments), turn);
             };
             const double v = contact::normal_velocity(a, b, at);
             if (!(v < 0)) return {a, b};
             const V by_a = turned(a, "a_moments");
             const V by_b = turned(b, "b_moments");
             const double k = a.inverse_mass + b.inverse_mass +
                              V(V(at.point - a.position).cross(at.normal)).dot(by_a) +
                              V(V(at.point - b.position).cross(at.normal)).dot(by_b);
             const double j = -(1 + e) * v / k;
             Body a2 = a;
             Body b2 = b;
             a2.velocity += at.normal * (j * a.inverse_mass);
             a2.angular_velocity += by_a * j;
             b2.velocity -= at.normal * (j * b.inverse_mass);
             b2.angular_velocity -= by_b * j;
             return {a2, b2};
           });
  }
  method("book", [](const Body& a, const Body& b, const auto& at, double e, const Case&) -> Pair {
    const auto after = contact::collide<double>(a, b, at, e);
    return {after.a, after.b};
  });
}

/// Bodies that close slowly: afterwards they must not close, v_n' ≥ 0, without rounding, for the
/// motion as stored. Their separation speed is not tested: the velocities have no digits for it.
void add_parting(hard_cases::Runner& runner) {
  runner.question("parting", [](const Case& c) {
    const Rational v = contact::normal_velocity(body<Rational>(c, "a"), body<Rational>(c, "b"),
                                                contact_of<Rational>(c));
    return Json{
        {"class", "a"}, {"before", hex(v)}, {"after", hex(-oracle::exact(c.number("e")) * v)}};
  });
  using Pair = std::pair<Body, Body>;
  const auto method = [&runner](const char* name, auto collide) {
    runner.method("parting", name, [collide](const Case& c, const Json&) {
      const auto [a2, b2] =
          collide(body<double>(c, "a"), body<double>(c, "b"), contact_of<double>(c), c.number("e"));
      return contact::closing_case(a2, b2, contact_of<double>(c)) != contact::Closing::approaching;
    });
  };
  const auto push = [](const Body& a, const Body& b, const auto& at, double e) -> Pair {
    const V impulse = at.normal * contact::collision_impulse<double>(a, b, at, e);
    return {contact::after_impulse<double>(a, impulse, at.point),
            contact::after_impulse<double>(b, V(-impulse), at.point)};
  };
  method("impulse as computed", push);
  method("applied twice", [push](const Body& a, const Body& b, const auto& at, double e) -> Pair {
    const auto [a2, b2] = push(a, b, at, e);
    return push(a2, b2, at, 0);
  });
  method("book", [](const Body& a, const Body& b, const auto& at, double e) -> Pair {
    const auto after = contact::collide<double>(a, b, at, e);
    return {after.a, after.b};
  });
}

/// Velocities afterwards, by the law of the question.
void add_friction(hard_cases::Runner& runner, const char* question, auto exactly, auto book) {
  runner.question(question, [exactly](const Case& c) { return exactly(c); });
  const auto judge = [](const Case& c, double slip, double normal, const Json& answer) {
    const double size = std::abs(c.number("slip")) + std::abs(c.number("closing")) +
                        std::abs(unhex(answer.at("slip"))) + std::abs(unhex(answer.at("normal")));
    const double room = std::ldexp(size, -36);
    return close(slip, unhex(answer.at("slip")), room) &&
           close(normal, unhex(answer.at("normal")), room);
  };
  const auto method = [&](const char* name, auto impact) {
    runner.method(question, name, [judge, impact](const Case& c, const Json& answer) {
      const auto got = impact(c);
      return judge(c, got.first, got.second, answer);
    });
  };
  using Pair = std::pair<double, double>;
  method("clamped after the normal impulse", [](const Case& c) -> Pair {
    const auto end =
        contact::clamped_impact(planar<double>(c), c.number("e"), c.number("friction")).end();
    return {end.slip, end.normal};
  });
  method("slip that never stops", [](const Case& c) -> Pair {
    const auto k = planar<double>(c);
    const double pull = k.slip > 0 ? -c.number("friction") : c.number("friction");
    const double n = -(1 + c.number("e")) * k.normal / (k.k_nn + k.k_tn * pull);
    return {k.slip + (k.k_tt * pull + k.k_tn) * n, k.normal + (k.k_nn + k.k_tn * pull) * n};
  });
  method("book", [book](const Case& c) -> Pair {
    const auto end = book(planar<double>(c), c.number("e"), c.number("friction")).end();
    return {end.slip, end.normal};
  });
}

Json answer_of(const contact::Impact<Rational>& impact) {
  return {{"class", "a"}, {"slip", hex(impact.end().slip)}, {"normal", hex(impact.end().normal)}};
}

/// Stronge's end from the path of Poisson's with e = 1 (greatest compression, and where the slip
/// stops after it), with one square root.
Json stronge_answer(const Case& c) {
  const auto k = planar<Rational>(c);
  const Rational e = oracle::exact(c.number("e"));
  const auto path = contact::newton_impact<Rational>(
      k, 0, oracle::exact(c.number("friction")));  // to greatest compression
  const auto& turn = path.end();
  const std::size_t last = path.count - 1;
  const Rational all = -e * e * contact::detail::normal_work(path, 0, last);
  // After greatest compression the slip may stop again; Newton's law with a large e goes past that.
  const auto on = contact::newton_impact<Rational>(k, 64, oracle::exact(c.number("friction")));
  std::size_t from = 0;
  while (on.path[from].impulse < turn.impulse) ++from;
  Rational left = all;
  for (;; ++from) {
    const auto& p = on.path[from];
    const auto& q = on.path[from + 1];
    const Rational work = (p.normal + q.normal) * (q.impulse - p.impulse) / 2;
    if (work < left && from + 2 < on.count) {
      left -= work;
      continue;
    }
    // On this segment u_n² grows by 2 · rate for each unit of work, and the slip linearly with u_n.
    const Rational rate = (q.normal - p.normal) / (q.impulse - p.impulse);
    const Rational slope = (q.slip - p.slip) / (q.normal - p.normal);
    const oracle::Surd normal{0, 1, p.normal * p.normal + 2 * rate * left};
    const oracle::Surd slip{p.slip - slope * p.normal, slope, normal.d};
    return {{"class", "b"},
            {"slip", hex(oracle::nearest(slip))},
            {"normal", hex(oracle::nearest(normal))}};
  }
}

/// Whether a law gains energy: right if it does not.
void add_energy(hard_cases::Runner& runner) {
  runner.question("energy", [](const Case& c) {
    const auto impact = contact::newton_impact<Rational>(
        planar<Rational>(c), oracle::exact(c.number("e")), oracle::exact(c.number("friction")));
    return Json{{"class", "a"}, {"newton_gain", hex(contact::energy_change(impact))}};
  });
  // A law that gains energy is off by the gain itself, far above rounding: 2^-40 of the magnitudes.
  const auto method = [&runner](const char* name, auto law) {
    runner.method("energy", name, [law](const Case& c, const Json&) {
      const auto k = planar<double>(c);
      const auto impact = law(k, c.number("e"), c.number("friction"));
      const double size = (std::abs(k.slip) + std::abs(k.normal)) *
                          (std::abs(k.slip) + std::abs(k.normal)) / std::min(k.k_nn, k.k_tt);
      return contact::energy_change(impact) <= std::ldexp(size, -40);
    });
  };
  using K = contact::PlanarContact<double>;
  method("joint law", [](const K& k, double e, double mu) {
    const auto impact = contact::joint_impact(k, e, mu);
    return impact ? *impact : contact::Impact<double>{{}, 1};
  });
  method("Newton's law",
         [](const K& k, double e, double mu) { return contact::newton_impact(k, e, mu); });
  method("Poisson's law",
         [](const K& k, double e, double mu) { return contact::poisson_impact(k, e, mu); });
  method("Stronge's law",
         [](const K& k, double e, double mu) { return contact::stronge_impact(k, e, mu); });
}

const std::vector<contact::VertexIndices> tetrahedron{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::vector<V> corners(const Case& c) {
  return {c.vector("p"), c.vector("q"), c.vector("r"), c.vector("s")};
}

void add_mesh(hard_cases::Runner& runner) {
  runner.question("mesh", [](const Case& c) {
    std::vector<oracle::Vector> exact;
    for (const V& corner : corners(c)) exact.push_back(oracle::exact(corner));
    const auto right = *contact::mesh_mass<Rational>(1, exact, tetrahedron);
    return Json{{"class", "a"},
                {"xx", hex(right.inertia(0, 0))},
                {"yy", hex(right.inertia(1, 1))},
                {"xy", hex(right.inertia(0, 1))}};
  });
  const auto judge = [](const M& got, const Json& answer) {
    const double xx = unhex(answer.at("xx"));
    const double yy = unhex(answer.at("yy"));
    const double room = std::ldexp(std::max(xx, yy), -36);
    return close(got(0, 0), xx, room) && close(got(1, 1), yy, room) &&
           close(got(0, 1), unhex(answer.at("xy")), room);
  };
  runner.method("mesh", "about the origin, then moved", [judge](const Case& c, const Json& answer) {
    const auto m = contact::detail::moments_about<double>(V(0, 0, 0), corners(c), tetrahedron);
    const M about = V::Constant(m.second.trace()).asDiagonal();
    const V centre = m.first / m.volume;
    return judge(M(about - m.second - contact::parallel_axis<double>(m.volume, centre)), answer);
  });
  runner.method("mesh", "book", [judge](const Case& c, const Json& answer) {
    const auto got = contact::mesh_mass<double>(1, corners(c), tetrahedron);
    return got && judge(got->inertia, answer);
  });
}

void add_spin(hard_cases::Runner& runner) {
  runner.question("angular_velocity", [](const Case& c) {
    const auto part = [&](auto f) {
      return hex(*oracle::nearest_value([&](unsigned bits) {
        return f(oracle::Interval(
            oracle::exact(c.number("angular_velocity")) * oracle::exact(c.number("h")), bits));
      }));
    };
    return Json{{"class", "c"},
                {"cosine", part([](const auto& x) { return cos(x); })},
                {"sine", part([](const auto& x) { return sin(x); })}};
  });
  // The angle itself is rounded: u of it, and 2^-40 for all else.
  const auto method = [&runner](const char* name, auto step) {
    runner.method("angular_velocity", name, [step](const Case& c, const Json& answer) {
      const double w = c.number("angular_velocity");
      const double h = c.number("h");
      const M r = step(V(0, 0, w), h);
      const double room = 0x1p-40 + 8 * 0x1p-53 * std::abs(w * h);
      return close(r(0, 0), unhex(answer.at("cosine")), room) &&
             close(r(1, 0), unhex(answer.at("sine")), room);
    });
  };
  method("Euler's matrix",
         [](const V& w, double h) { return contact::matrix_step<double>(M::Identity(), w, h); });
  method("Euler's matrix, orthonormalised", [](const V& w, double h) {
    return contact::orthonormalised<double>(contact::matrix_step<double>(M::Identity(), w, h));
  });
  method("quaternion", [](const V& w, double h) {
    return contact::matrix_of(contact::quaternion_step<double>({}, w, h));
  });
  method("exponential map", [](const V& w, double h) {
    return contact::matrix_of(contact::exponential_step<double>({}, w, h));
  });
}

/// The axis of a free symmetric top, which pointed along z: it precesses about the angular
/// momentum. A method takes 64 steps; it is right within a thousandth.
void add_top(hard_cases::Runner& runner) {
  runner.question("top", [](const Case& c) {
    const auto part = [&](auto f) {
      return hex(*oracle::nearest_value([&](unsigned bits) {
        const auto number = [&](const char* name) {
          return oracle::Interval(oracle::exact(c.number(name)), bits);
        };
        const auto x = number("transverse") * number("spin_across");
        const auto z = number("along") * number("spin_along");
        const auto size = sqrt(x * x + z * z);
        return f(x / size, z / size, size * number("t") / number("transverse"));
      }));
    };
    return Json{{"class", "c"},
                {"x", part([](auto x, auto z, auto angle) { return x * z - x * z * cos(angle); })},
                {"y", part([](auto x, auto /*z*/, auto angle) { return -(x * sin(angle)); })},
                {"z", part([](auto x, auto z, auto angle) { return z * z + x * x * cos(angle); })}};
  });
  const auto method = [&runner](const char* name, auto turned) {
    runner.method("top", name, [turned](const Case& c, const Json& answer) {
      const double transverse = c.number("transverse");
      const double along = c.number("along");
      const V momentum(transverse * c.number("spin_across"), 0, along * c.number("spin_along"));
      const V axis =
          contact::matrix_of<double>(turned(momentum, transverse, along, c.number("t"))).col(2);
      const double room = 1e-3;
      return close(axis.x(), unhex(answer.at("x")), room) &&
             close(axis.y(), unhex(answer.at("y")), room) &&
             close(axis.z(), unhex(answer.at("z")), room);
    });
  };
  using Q = contact::Quaternion<double>;
  const auto in_steps = [](auto step) {
    return [step](const V& momentum, double transverse, double along, double t) {
      Q q;
      for (int i = 0; i < 64; ++i) q = step(q, momentum, V(transverse, transverse, along), t / 64);
      return q;
    };
  };
  const auto with_spin_of_start = [](auto step) {
    return [step](const Q& q, const V& momentum, const V& moments, double h) {
      const M turned = contact::matrix_of(q);
      return step(q, contact::free_angular_velocity<double>(momentum, moments, turned), h);
    };
  };
  method("quaternion", in_steps(with_spin_of_start([](const Q& q, const V& w, double h) {
           return contact::quaternion_step<double>(q, w, h);
         })));
  method("exponential map", in_steps(with_spin_of_start([](const Q& q, const V& w, double h) {
           return contact::exponential_step<double>(q, w, h);
         })));
  method("midpoint", in_steps([](const Q& q, const V& momentum, const V& moments, double h) {
           return contact::midpoint_step<double>(q, momentum, moments, h);
         }));
  method("book", [](const V& momentum, double transverse, double along, double t) {
    return contact::free_top<double>({}, momentum, transverse, along, t);
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("17_rigid_impulse");
  add_closing(runner);
  add_collision(runner, "collision");
  add_collision(runner, "slender");
  add_parting(runner);
  add_friction(
      runner, "poisson",
      [](const Case& c) {
        return answer_of(contact::poisson_impact<Rational>(planar<Rational>(c),
                                                           oracle::exact(c.number("e")),
                                                           oracle::exact(c.number("friction"))));
      },
      [](const auto& k, double e, double mu) { return contact::poisson_impact(k, e, mu); });
  add_friction(runner, "stronge", stronge_answer, [](const auto& k, double e, double mu) {
    return contact::stronge_impact(k, e, mu);
  });
  add_energy(runner);
  add_mesh(runner);
  add_spin(runner);
  add_top(runner);
  return runner.run(argc, argv);
}
