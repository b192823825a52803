// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// Decisions and velocities are of class (a), rational in the stored numbers: an impulse along the
// line of centres needs no root. Times are of class (b), with one square root. A decision is right
// or wrong. A velocity is right if it is off by at most 2^-40 of the velocities that went in; a
// time, and a share of a momentum, if by at most 2^-40 of itself.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/billiard_table.hpp>
#include <contact/disc_collision.hpp>
#include <contact/disc_events.hpp>
#include <contact/momentum_triangle.hpp>
#include <vector>

using hard_cases::Case;
using hard_cases::hex;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;

namespace {

using Disc = contact::Disc<double>;
using Vector = contact::Vector2<double>;

/// A disc of the corpus: centre, velocity, radius, mass.
Disc read_disc(const Case& c, const char* field) {
  const std::vector<double> n = c.numbers(field);
  return contact::disc<double>(n.at(5), n.at(4), {n.at(0), n.at(1)}, {n.at(2), n.at(3)});
}

/// Differences of two discs, exactly.
struct Pair {
  Rational dx, dy, wx, wy, radius_sum;
  Rational gap() const { return dx * dx + dy * dy - radius_sum * radius_sum; }
  Rational approach() const { return -(dx * wx + dy * wy); }
  Rational depth() const {
    const Rational cross = dx * wy - dy * wx;
    return radius_sum * radius_sum * (wx * wx + wy * wy) - cross * cross;
  }
};
Pair exact_pair(const Disc& a, const Disc& b) {
  using oracle::exact;
  return {exact(a.centre.x()) - exact(b.centre.x()), exact(a.centre.y()) - exact(b.centre.y()),
          exact(a.velocity.x()) - exact(b.velocity.x()),
          exact(a.velocity.y()) - exact(b.velocity.y()), exact(a.radius) + exact(b.radius)};
}
Pair exact_pair(const Case& c) { return exact_pair(read_disc(c, "a"), read_disc(c, "b")); }

int sign_of(double x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

/// The axis by the plain formula; not a number for coincident centres.
Vector plain_axis(const Disc& a, const Disc& b) {
  const Vector d = a.centre - b.centre;
  return d / std::sqrt(d.x() * d.x() + d.y() * d.y());
}

void add_approach(hard_cases::Runner& runner) {
  runner.question("approach", [](const Case& c) {
    return Json{{"class", "a"}, {"sign", -oracle::sign(exact_pair(c).approach())}};
  });
  const auto method = [&runner](const char* name, auto sign) {
    runner.method("approach", name, [sign](const Case& c, const Json& answer) {
      return sign(read_disc(c, "a"), read_disc(c, "b")) == answer.at("sign").get<int>();
    });
  };
  method("projections compared", [](const Disc& a, const Disc& b) {
    const Vector n = plain_axis(a, b);
    const double difference = n.dot(a.velocity) - n.dot(b.velocity);
    return std::isnan(difference) ? 7 : sign_of(difference);
  });
  method("d·w, rounded", [](const Disc& a, const Disc& b) {
    return sign_of((a.centre - b.centre).dot(a.velocity - b.velocity));
  });
  method("book", [](const Disc& a, const Disc& b) { return contact::closing_sign(a, b); });
}

bool ever_meet(const Pair& p) { return p.approach() > 0 && (p.gap() <= 0 || p.depth() >= 0); }

/// Whether the discs touch or overlap at t, for the method with time steps.
bool overlap_at(const Disc& a, const Disc& b, double t) {
  const Vector d = (a.centre + a.velocity * t) - (b.centre + b.velocity * t);
  const double radius_sum = a.radius + b.radius;
  return d.dot(d) <= radius_sum * radius_sum;
}

void add_meets(hard_cases::Runner& runner) {
  runner.question("meets", [](const Case& c) {
    return Json{{"class", "a"}, {"meets", ever_meet(exact_pair(c))}};
  });
  const auto method = [&runner](const char* name, auto meets) {
    runner.method("meets", name, [meets](const Case& c, const Json& answer) {
      return meets(read_disc(c, "a"), read_disc(c, "b")) == answer.at("meets").get<bool>();
    });
  };
  method("steps of 0.1 s", [](const Disc& a, const Disc& b) {
    for (int k = 0; k <= 200; ++k) {
      if (overlap_at(a, b, 0.1 * k)) return true;
    }
    return false;
  });
  method("b² − 4ac", [](const Disc& a, const Disc& b) {
    const Vector d = a.centre - b.centre;
    const Vector w = a.velocity - b.velocity;
    const double radius_sum = a.radius + b.radius;
    const double half = d.dot(w);
    const double gap = d.dot(d) - radius_sum * radius_sum;
    return half < 0 && half * half - w.dot(w) * gap >= 0;
  });
  method("R²w² − (d×w)²", [](const Disc& a, const Disc& b) {
    const auto t = contact::detail::touch_terms<double>(
        a.centre - b.centre, a.velocity - b.velocity, a.radius + b.radius);
    return t.approach > 0 && (t.gap <= 0 || t.depth >= 0);
  });
  method("book",
         [](const Disc& a, const Disc& b) { return contact::time_to_touch(a, b).has_value(); });
}

void add_when(hard_cases::Runner& runner) {
  runner.question("when", [](const Case& c) {
    const Pair p = exact_pair(c);
    const Rational square = p.wx * p.wx + p.wy * p.wy;
    // (approach − √depth) / w²
    const oracle::Surd time{p.approach() / square, Rational(-1) / square, p.depth()};
    return Json{{"class", "b"}, {"time", hex(oracle::nearest(time))}};
  });
  const auto method = [&runner](const char* name, auto when) {
    runner.method("when", name, [when](const Case& c, const Json& answer) {
      const double right = unhex(answer.at("time"));
      const double got = when(read_disc(c, "a"), read_disc(c, "b"));
      return std::isfinite(got) && std::abs(got - right) <= std::ldexp(right, -40);
    });
  };
  method("textbook formula", [](const Disc& a, const Disc& b) {
    const Vector d = a.centre - b.centre;
    const Vector w = a.velocity - b.velocity;
    const double radius_sum = a.radius + b.radius;
    const double half = d.dot(w);
    const double gap = d.dot(d) - radius_sum * radius_sum;
    return (-half - std::sqrt(half * half - w.dot(w) * gap)) / w.dot(w);
  });
  method("without cancelling roots", [](const Disc& a, const Disc& b) {
    const auto t = contact::detail::touch_terms<double>(
        a.centre - b.centre, a.velocity - b.velocity, a.radius + b.radius);
    return t.gap / (t.approach + std::sqrt(t.depth));
  });
  method("book",
         [](const Disc& a, const Disc& b) { return contact::time_to_touch(a, b).value_or(-1); });
}

struct Velocities {
  Vector a, b;
};

void add_after(hard_cases::Runner& runner) {
  runner.question("after", [](const Case& c) {
    const Disc a = read_disc(c, "a");
    const Disc b = read_disc(c, "b");
    const Pair p = exact_pair(a, b);
    Rational vax = oracle::exact(a.velocity.x());
    Rational vay = oracle::exact(a.velocity.y());
    Rational vbx = oracle::exact(b.velocity.x());
    Rational vby = oracle::exact(b.velocity.y());
    if (p.approach() > 0) {
      const Rational ma = oracle::exact(a.mass);
      const Rational mb = oracle::exact(b.mass);
      const Rational e = oracle::exact(c.number("e"));
      // The impulse in units of d: (1 + e) (−d·w)/(d·d), times the reduced mass.
      const Rational push = (1 + e) * p.approach() / (p.dx * p.dx + p.dy * p.dy);
      vax += push * p.dx * mb / (ma + mb);
      vay += push * p.dy * mb / (ma + mb);
      vbx -= push * p.dx * ma / (ma + mb);
      vby -= push * p.dy * ma / (ma + mb);
    }
    return Json{{"class", "a"},
                {"a", Json::array({hex(vax), hex(vay)})},
                {"b", Json::array({hex(vbx), hex(vby)})}};
  });
  const auto method = [&runner](const char* name, auto after) {
    runner.method("after", name, [after](const Case& c, const Json& answer) {
      const Disc a = read_disc(c, "a");
      const Disc b = read_disc(c, "b");
      const Velocities got = after(a, b, c.number("e"));
      const double room = std::ldexp(
          std::max(a.velocity.cwiseAbs().maxCoeff(), b.velocity.cwiseAbs().maxCoeff()), -40);
      bool right = true;
      for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<std::size_t>(k);
        right = right && std::abs(got.a(k) - unhex(answer.at("a").at(at))) <= room;
        right = right && std::abs(got.b(k) - unhex(answer.at("b").at(at))) <= room;
      }
      return right;
    });
  };
  const auto steps_with_axis = [](const Disc& a, const Disc& b, double e, const Vector& n) {
    const double ua = n.dot(a.velocity);
    const double ub = n.dot(b.velocity);
    const double m = a.mass + b.mass;
    const double p = a.mass * ua + b.mass * ub;
    const Vector va = a.velocity + n * ((p - e * (ua - ub) * b.mass) / m - ua);
    const Vector vb = b.velocity + n * ((p - e * (ub - ua) * a.mass) / m - ub);
    return Velocities{va, vb};
  };
  method("whole velocities reversed", [](const Disc& a, const Disc& b, double e) {
    return Velocities{-e * a.velocity, -e * b.velocity};
  });
  method("axis not normalised", [steps_with_axis](const Disc& a, const Disc& b, double e) {
    return steps_with_axis(a, b, e, a.centre - b.centre);
  });
  method("steps a to d", [steps_with_axis](const Disc& a, const Disc& b, double e) {
    return steps_with_axis(a, b, e, plain_axis(a, b));
  });
  method("steps, if n·w < 0", [steps_with_axis](const Disc& a, const Disc& b, double e) {
    const Vector n = plain_axis(a, b);
    if (!(n.dot(a.velocity - b.velocity) < 0)) return Velocities{a.velocity, b.velocity};
    return steps_with_axis(a, b, e, n);
  });
  method("book", [](const Disc& a, const Disc& b, double e) {
    const auto after = contact::collide_discs(a, b, e);
    return Velocities{after.velocity_a, after.velocity_b};
  });
}

void add_share(hard_cases::Runner& runner) {
  const auto vector = [](const Case& c, const char* field) {
    const auto n = c.numbers(field);
    return Vector(n.at(0), n.at(1));
  };
  runner.question("share", [vector](const Case& c) {
    using oracle::exact;
    const Vector p = vector(c, "total");
    const Vector a = vector(c, "direction_a");
    const Vector b = vector(c, "direction_b");
    const auto cross = [](const Vector& x, const Vector& y) {
      return Rational(exact(x.x()) * exact(y.y()) - exact(x.y()) * exact(y.x()));
    };
    const Rational sine = cross(a, b);
    if (sine == 0) return Json{{"class", "a"}, {"shares", "none"}};
    const Rational share_a = cross(p, b) / sine;
    const Rational share_b = cross(a, p) / sine;
    return Json{{"class", "a"},
                {"a", Json::array({hex(share_a * exact(a.x())), hex(share_a * exact(a.y()))})},
                {"b", Json::array({hex(share_b * exact(b.x())), hex(share_b * exact(b.y()))})}};
  });
  const auto judge = [](const std::optional<contact::MomentumShares<double>>& got,
                        const Json& answer) {
    if (answer.contains("shares")) return !got;
    if (!got) return false;
    bool right = true;
    for (int k = 0; k < 2; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double a = unhex(answer.at("a").at(at));
      const double b = unhex(answer.at("b").at(at));
      right = right && std::abs(got->a(k) - a) <= std::ldexp(std::abs(a), -40);
      right = right && std::abs(got->b(k) - b) <= std::ldexp(std::abs(b), -40);
    }
    return right;
  };
  using Shares = contact::MomentumShares<double>;
  runner.method("share", "two equations, by elimination",
                [vector, judge](const Case& c, const Json& answer) {
                  // p_x = s a_x + t b_x and p_y = s a_y + t b_y, without a test of the pivot.
                  const Vector p = vector(c, "total");
                  const Vector a = vector(c, "direction_a");
                  const Vector b = vector(c, "direction_b");
                  const double factor = a.y() / a.x();
                  const double t = (p.y() - factor * p.x()) / (b.y() - factor * b.x());
                  const double s = (p.x() - t * b.x()) / a.x();
                  if (!std::isfinite(s) || !std::isfinite(t)) return judge(std::nullopt, answer);
                  return judge(Shares{s * a, t * b}, answer);
                });
  runner.method("share", "cross products, rounded",
                [vector, judge](const Case& c, const Json& answer) {
                  const Vector p = vector(c, "total");
                  const Vector a = vector(c, "direction_a");
                  const Vector b = vector(c, "direction_b");
                  const auto cross = [](const Vector& x, const Vector& y) {
                    return x.x() * y.y() - x.y() * y.x();
                  };
                  const double sine = cross(a, b);
                  if (sine == 0) return judge(std::nullopt, answer);
                  return judge(Shares{cross(p, b) / sine * a, cross(a, p) / sine * b}, answer);
                });
  runner.method("share", "book", [vector, judge](const Case& c, const Json& answer) {
    return judge(contact::share_momentum<double>(vector(c, "total"), vector(c, "direction_a"),
                                                 vector(c, "direction_b")),
                 answer);
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("14_collisions_2d");
  add_approach(runner);
  add_meets(runner);
  add_when(runner);
  add_after(runner);
  add_share(runner);
  return runner.run(argc, argv);
}
