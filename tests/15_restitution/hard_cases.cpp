// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// Velocities and signs are rational in the stored numbers (class (a)); times, heights, counts and
// coefficients have one square root in them (class (b)): a time is a + b √(v² + 2 g h), and so is a
// height. Counts and signs must be right. A time or a coefficient is right if it is off by at most
// 2^-40 of itself, a velocity by 2^-40 of the velocity before, a height by 2^-20 of h + v²/(2 g),
// the highest that the ball ever gets.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/fixed_step_bounce.hpp>
#include <contact/restitution.hpp>
#include <cstdlib>
#include <string>

using hard_cases::Case;
using hard_cases::close;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;
using oracle::Surd;
using Vector = contact::Vector3<double>;

namespace {

contact::BouncingBall<double> ball(const Case& c) {
  const double k = c.has("restitution") ? c.number("restitution") : 0;
  return contact::bouncing_ball(c.number("height"), c.number("velocity"), c.number("gravity"), k);
}

struct ExactBall {
  Rational h, v, g, k, d;

  explicit ExactBall(const Case& c)
      : h(oracle::exact(c.number("height"))),
        v(oracle::exact(c.number("velocity"))),
        g(oracle::exact(c.number("gravity"))),
        k(c.has("restitution") ? oracle::exact(c.number("restitution")) : Rational(0)),
        d(v * v + 2 * g * h) {}

  /// 1 + k + … with m terms and k^m, by doubling: k = 1 and millions of terms are possible.
  std::pair<Rational, Rational> series(long long m) const {
    if (k == 1) return {Rational(m), Rational(1)};
    Rational sum = 0;
    Rational power = 1;
    Rational block = 1;
    Rational step = k;
    for (; m > 0; m /= 2) {
      if (m % 2 != 0) {
        sum += power * block;
        power *= step;
      }
      block += step * block;
      step *= step;
    }
    return {sum, power};
  }
  Surd impact(long long n) const { return {v / g, (1 + 2 * k * series(n - 1).first) / g, d}; }
  bool endless(const Rational& t) const {
    return k < 1 && oracle::compare({t, 0, 0}, {v / g, (1 + k) / (1 - k) / g, d}) >= 0;
  }
  /// The number of impacts by the time t, which is before the end.
  long long count(const Rational& t) const {
    const auto by = [&](long long n) { return oracle::compare(impact(n), {t, 0, 0}) <= 0; };
    if (!by(1)) return 0;
    long long low = 1;
    long long high = 2;
    while (by(high)) {
      low = high;
      high *= 2;
    }
    while (high - low > 1) {
      const long long middle = low + (high - low) / 2;
      (by(middle) ? low : high) = middle;
    }
    return low;
  }
  Surd height(const Rational& t, long long n) const {
    if (n == 0) return {h + v * t - g * t * t / 2, 0, 0};
    const Rational p = t - v / g;
    const Rational q = (1 + 2 * k * series(n - 1).first) / g;
    const Rational power = series(n).second;
    return {-power * q * d - g * (p * p + q * q * d) / 2, power * p + g * p * q, d};
  }
};

bool same(double got, const Json& answer, const char* field) {
  const double right = unhex(answer, field);
  return close(got, right, std::ldexp(std::abs(right), -40));
}

std::string count_text(double count) {
  return std::isinf(count) ? "endless" : std::to_string(static_cast<long long>(count));
}

void add_bounces(hard_cases::Runner& runner) {
  runner.question("bounces", [](const Case& c) {
    const ExactBall exact(c);
    const Rational t = oracle::exact(c.number("time"));
    std::string count = "endless";
    if (exact.k == 0) {
      count = std::to_string(oracle::compare(exact.impact(1), {t, 0, 0}) <= 0 ? 1 : 0);
    } else if (!exact.endless(t)) {
      count = std::to_string(exact.count(t));
    }
    return Json{{"class", "b"}, {"impacts", count}};
  });
  const auto method = [&runner](const char* name, auto count) {
    runner.method("bounces", name, [count](const Case& c, const Json& answer) {
      return count_text(count(ball(c), c.number("time"))) == answer.at("impacts");
    });
  };
  const auto followed = [](const auto& b, auto t, decltype(t) rest_speed = 0) {
    const auto state = contact::follow_bounces(b, t, rest_speed);
    // An event-driven simulation cannot tell infinitely many from very many: if the time no longer
    // grows, count it as infinite.
    const bool endless = state.resting && b.restitution > 0;
    return endless ? std::numeric_limits<double>::infinity() : static_cast<double>(state.bounces);
  };
  method("float, flight by flight", [followed](const contact::BouncingBall<double>& b, double t) {
    const contact::BouncingBall<float> narrow{
        static_cast<float>(b.height), static_cast<float>(b.velocity), static_cast<float>(b.gravity),
        static_cast<float>(b.restitution)};
    return followed(narrow, static_cast<float>(t));
  });
  method("double, flight by flight",
         [followed](const contact::BouncingBall<double>& b, double t) { return followed(b, t); });
  method("rests below 1 mm", [followed](const contact::BouncingBall<double>& b, double t) {
    return followed(b, t, contact::rest_speed(0.001, b.gravity));
  });
  method("by a logarithm", [](const contact::BouncingBall<double>& b, double t) {
    const double w = std::sqrt(b.velocity * b.velocity + 2 * b.gravity * b.height);
    const double first = (b.velocity + w) / b.gravity;
    if (t < first) return 0.0;
    const double left = b.restitution - (t - first) * b.gravity / (2 * w) * (1 - b.restitution);
    if (left <= 0) return b.restitution > 0 ? std::numeric_limits<double>::infinity() : 1.0;
    return std::floor(std::log(left) / std::log(b.restitution));
  });
  method("book", [](const contact::BouncingBall<double>& b, double t) {
    return contact::bounces_by(b, t);
  });
}

void add_reflected(hard_cases::Runner& runner) {
  runner.question("reflected", [](const Case& c) {
    const oracle::Vector v = oracle::exact(c.vector("velocity"));
    const oracle::Vector d = oracle::exact(c.vector("direction"));
    oracle::Vector right = v;
    if (v.dot(d) < 0) {
      const Rational share = (1 + oracle::exact(c.number("restitution"))) * v.dot(d) / d.dot(d);
      right = v - d * share;
    }
    return Json{{"class", "a"}, {"velocity", hard_cases::hex(oracle::nearest(right))}};
  });
  const auto method = [&runner](const char* name, auto bounce) {
    runner.method("reflected", name, [bounce](const Case& c, const Json& answer) {
      const Vector v = c.vector("velocity");
      const Vector got = bounce(v, c.vector("direction"), c.number("restitution"));
      for (int i = 0; i < 3; ++i) {
        const double right = std::strtod(
            answer.at("velocity").at(static_cast<std::size_t>(i)).get<std::string>().c_str(),
            nullptr);
        if (!close(got(i), right, std::ldexp(v.cwiseAbs().maxCoeff(), -40))) return false;
      }
      return true;
    });
  };
  method("−k v", [](const Vector& v, const Vector&, double k) { return Vector(-k * v); });
  method("no test for approach", [](const Vector& v, const Vector& d, double k) {
    return Vector(v - (1 + k) * v.dot(d) / d.dot(d) * d);
  });
  method("d for N", [](const Vector& v, const Vector& d, double k) {
    return v.dot(d) < 0 ? Vector(v - (1 + k) * v.dot(d) * d) : v;
  });
  method("plain formula", [](const Vector& v, const Vector& d, double k) {
    return v.dot(d) < 0 ? Vector(v - (1 + k) * v.dot(d) / d.dot(d) * d) : v;
  });
  method("book", [](const Vector& v, const Vector& d, double k) {
    return contact::after_bounce_along(v, d, k);
  });
}

void add_approaching(hard_cases::Runner& runner) {
  runner.question("approaching", [](const Case& c) {
    return Json{{"class", "a"},
                {"approaches",
                 oracle::exact(c.vector("velocity")).dot(oracle::exact(c.vector("normal"))) < 0}};
  });
  const auto method = [&runner](const char* name, auto approaches) {
    runner.method("approaching", name, [approaches](const Case& c, const Json& answer) {
      return approaches(c.vector("velocity"), c.vector("normal")) ==
             answer.at("approaches").get<bool>();
    });
  };
  method("float",
         [](const Vector& v, const Vector& n) { return v.cast<float>().dot(n.cast<float>()) < 0; });
  method("double", [](const Vector& v, const Vector& n) { return v.dot(n) < 0; });
  method("below −10⁻⁹", [](const Vector& v, const Vector& n) { return v.dot(n) < -1e-9; });
  method("book", [](const Vector& v, const Vector& n) { return contact::approaches(v, n); });
}

void add_coefficient(hard_cases::Runner& runner) {
  runner.question("coefficient", [](const Case& c) {
    const Rational ratio = oracle::exact(c.number("rebound")) / oracle::exact(c.number("drop"));
    return Json{{"class", "b"}, {"k", hard_cases::hex(oracle::nearest(Surd{0, 1, ratio}))}};
  });
  const auto method = [&runner](const char* name, auto coefficient) {
    runner.method("coefficient", name, [coefficient](const Case& c, const Json& answer) {
      return same(coefficient(c.number("drop"), c.number("rebound")), answer, "k");
    });
  };
  method("h′/h", [](double drop, double rebound) { return rebound / drop; });
  method("√(h′/h)", [](double drop, double rebound) { return std::sqrt(rebound / drop); });
  method("book", [](double drop, double rebound) {
    return contact::restitution_from_heights(drop, rebound);
  });
}

void add_fall(hard_cases::Runner& runner) {
  runner.question("fall", [](const Case& c) {
    const ExactBall exact(c);
    return Json{{"class", "b"}, {"t", hard_cases::hex(oracle::nearest(exact.impact(1)))}};
  });
  const auto method = [&runner](const char* name, auto time) {
    runner.method("fall", name, [time](const Case& c, const Json& answer) {
      return same(time(ball(c)), answer, "t");
    });
  };
  method("(v + w)/g", [](const contact::BouncingBall<double>& b) {
    return (b.velocity + std::sqrt(b.velocity * b.velocity + 2 * b.gravity * b.height)) / b.gravity;
  });
  method("2h/(w − v)", [](const contact::BouncingBall<double>& b) {
    return 2 * b.height /
           (std::sqrt(b.velocity * b.velocity + 2 * b.gravity * b.height) - b.velocity);
  });
  method("book",
         [](const contact::BouncingBall<double>& b) { return contact::first_impact_time(b); });
}

void add_height(hard_cases::Runner& runner) {
  runner.question("height", [](const Case& c) {
    const ExactBall exact(c);
    const Rational t = oracle::exact(c.number("time"));
    const double height = exact.endless(t) ? 0 : oracle::nearest(exact.height(t, exact.count(t)));
    return Json{{"class", "b"}, {"height", hard_cases::hex(height)}};
  });
  const auto method = [&runner](const char* name, auto height) {
    runner.method("height", name, [height](const Case& c, const Json& answer) {
      const auto b = ball(c);
      const double most = b.height + b.velocity * b.velocity / (2 * b.gravity);
      return close(height(b, c.number("time")), unhex(answer, "height"), std::ldexp(most, -20));
    });
  };
  const auto in_steps = [](contact::StepRule rule, double rate) {
    return [rule, rate](const contact::BouncingBall<double>& b, double t) {
      const auto steps = static_cast<long long>(std::ceil(t * rate));
      return contact::bounce_in_steps(b, t / static_cast<double>(steps), steps, rule).height;
    };
  };
  method("1/60 s, flip below", in_steps(contact::StepRule::flip_below, 60));
  method("1/60 s, on the floor", in_steps(contact::StepRule::clamp, 60));
  method("1/60 s, the lecture's loop", in_steps(contact::StepRule::new_velocity, 60));
  method("1/60 s, step's end", in_steps(contact::StepRule::end_velocity, 60));
  method("1/60 s, at the impact", in_steps(contact::StepRule::impact_velocity, 60));
  method("flight by flight", [](const contact::BouncingBall<double>& b, double t) {
    return contact::follow_bounces(b, t, 0.0).height;
  });
  method("book", [](const contact::BouncingBall<double>& b, double t) {
    return contact::bounce_at(b, t).height;
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("15_restitution");
  add_bounces(runner);
  add_reflected(runner);
  add_approaching(runner);
  add_coefficient(runner);
  add_fall(runner);
  add_height(runner);
  return runner.run(argc, argv);
}
