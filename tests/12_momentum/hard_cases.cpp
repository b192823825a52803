// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
//
// All answers are of class (a): rational in the stored numbers, rounded once. A sum or a mean is
// right if its error is at most 2^-40 of itself (2^-18 for a method in float), and exactly 0 where
// it is 0. A velocity that is computed as a difference is right if its error is at most 2^-40 of
// the velocities that it is computed from.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/impulse.hpp>
#include <contact/impulse_sum.hpp>
#include <contact/momentum.hpp>
#include <contact/momentum_balance.hpp>
#include <contact/variable_mass.hpp>
#include <vector>

using hard_cases::Case;
using hard_cases::close;
using hard_cases::hex;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;

namespace {

using Numbers = std::vector<double>;

Rational sum_of(const Numbers& numbers) {
  Rational sum = 0;
  for (const double x : numbers) sum += oracle::exact(x);
  return sum;
}

bool same(double got, const Json& answer, const char* field, int bits = 40) {
  const double right = unhex(answer, field);
  return close(got, right, std::ldexp(std::abs(right), -bits));
}

template <class S>
S plain(const std::vector<S>& terms) {
  S sum(0);
  for (const S x : terms) sum += x;
  return sum;
}

void add_total(hard_cases::Runner& runner) {
  runner.question("total", [](const Case& c) {
    return Json{{"class", "a"}, {"sum", hex(sum_of(c.numbers("impulses")))}};
  });
  const auto in_double = [&runner](const char* name, auto total) {
    runner.method("total", name, [total](const Case& c, const Json& answer) {
      return same(total(c.numbers("impulses")), answer, "sum");
    });
  };
  in_double("double, recursive", [](const Numbers& terms) { return plain(terms); });
  in_double("pairwise", [](const Numbers& terms) { return contact::total_pairwise(terms); });
  in_double("Kahan", [](const Numbers& terms) { return contact::total_kahan(terms); });
  in_double("compensated", [](const Numbers& terms) { return contact::total_compensated(terms); });
  in_double("book", [](const Numbers& terms) { return contact::total_impulse(terms); });
}

void add_total_of_floats(hard_cases::Runner& runner) {
  runner.question("total_of_floats", [](const Case& c) {
    return Json{{"class", "a"}, {"sum", hex(sum_of(c.numbers("impulses")))}};
  });
  const auto in_float = [&runner](const char* name, auto total) {
    runner.method("total_of_floats", name, [total](const Case& c, const Json& answer) {
      const Numbers terms = c.numbers("impulses");
      const std::vector<float> floats(terms.begin(), terms.end());
      return same(static_cast<double>(total(floats)), answer, "sum", 18);
    });
  };
  in_float("float, recursive", [](const auto& terms) { return plain(terms); });
  in_float("float, pairwise", [](const auto& terms) { return contact::total_pairwise(terms); });
  in_float("float, compensated",
           [](const auto& terms) { return contact::total_compensated(terms); });
  in_float("float, book", [](const auto& terms) { return contact::total_impulse(terms); });
}

std::vector<contact::PointMass<double>> bodies(const Case& c) {
  const Numbers masses = c.numbers("masses");
  const Numbers velocities = c.numbers("velocities");
  std::vector<contact::PointMass<double>> all;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    all.push_back(contact::point_mass<double>(masses[i], {0, 0, 0}, {velocities[i], 0, 0}));
  }
  return all;
}

void add_together(hard_cases::Runner& runner) {
  runner.question("together", [](const Case& c) {
    Rational momentum = 0;
    Rational mass = 0;
    for (const auto& body : bodies(c)) {
      momentum += oracle::exact(body.mass) * oracle::exact(body.velocity.x());
      mass += oracle::exact(body.mass);
    }
    return Json{{"class", "a"}, {"velocity", hex(momentum / mass)}};
  });
  runner.method("together", "mean of the velocities", [](const Case& c, const Json& answer) {
    const Numbers velocities = c.numbers("velocities");
    return same(plain(velocities) / static_cast<double>(velocities.size()), answer, "velocity");
  });
  runner.method("together", "naive formula", [](const Case& c, const Json& answer) {
    double momentum = 0;
    double mass = 0;
    for (const auto& body : bodies(c)) {
      momentum += body.mass * body.velocity.x();
      mass += body.mass;
    }
    return same(momentum / mass, answer, "velocity");
  });
  runner.method("together", "book", [](const Case& c, const Json& answer) {
    return same(contact::centre_velocity(bodies(c))->x(), answer, "velocity");
  });
}

contact::ForceCurve<double> curve(const Case& c) {
  std::vector<contact::Vector3<double>> force;
  for (const double f : c.numbers("forces")) force.push_back({f, 0, 0});
  return contact::force_curve<double>(c.numbers("times"), force);
}

/// The total momentum after elastic collisions of all pairs in turn. Internal impulses do not
/// change it, so the right answer is the initial one.
void add_balance(hard_cases::Runner& runner) {
  runner.question("balance", [](const Case& c) {
    Rational sum = 0;
    for (const auto& body : bodies(c)) {
      sum += oracle::exact(body.mass) * oracle::exact(body.velocity.x());
    }
    return Json{{"class", "a"}, {"momentum", hex(sum)}};
  });
  const auto method = [&runner](const char* name, contact::MomentumUpdate update) {
    runner.method("balance", name, [update](const Case& c, const Json& answer) {
      const double unit = 0x1p-40;  // N·s
      std::vector<contact::MomentumBody<double>> all;
      for (const auto& body : bodies(c)) {
        const double v = body.velocity.x();
        all.push_back({body.mass, v, contact::on_grid(body.mass * v, unit)});
      }
      const std::size_t n = all.size();
      const auto collisions = static_cast<std::size_t>(c.number("collisions"));
      for (std::size_t k = 0; k < collisions; ++k) {
        const std::size_t a = k % n;
        const std::size_t b = (a + 1 + k / n % (n - 1)) % n;
        contact::collide_with_update(all[a], all[b], update, unit);
      }
      Rational sum = 0;
      for (const auto& body : all) {
        sum += update == contact::MomentumUpdate::grid
                   ? oracle::exact(body.momentum)
                   : oracle::exact(body.mass) * oracle::exact(body.velocity);
      }
      return same(oracle::nearest(sum), answer, "momentum");
    });
  };
  method("formulas", contact::MomentumUpdate::formulas);
  method("impulses", contact::MomentumUpdate::impulses);
  method("on a grid", contact::MomentumUpdate::grid);
}

void add_curve(hard_cases::Runner& runner) {
  runner.question("curve", [](const Case& c) {
    const Numbers times = c.numbers("times");
    const Numbers forces = c.numbers("forces");
    Rational area = 0;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      area += (oracle::exact(times[i + 1]) - oracle::exact(times[i])) *
              (oracle::exact(forces[i]) + oracle::exact(forces[i + 1])) / 2;
    }
    return Json{{"class", "a"}, {"impulse", hex(area)}};
  });
  runner.method("curve", "largest force × time", [](const Case& c, const Json& answer) {
    double largest = 0;
    for (const double f : c.numbers("forces")) {
      if (std::abs(f) > std::abs(largest)) largest = f;
    }
    return same(largest * (c.numbers("times").back() - c.numbers("times").front()), answer,
                "impulse");
  });
  runner.method("curve", "mean of samples × time", [](const Case& c, const Json& answer) {
    const Numbers forces = c.numbers("forces");
    return same(plain(forces) / static_cast<double>(forces.size()) *
                    (c.numbers("times").back() - c.numbers("times").front()),
                answer, "impulse");
  });
  runner.method("curve", "trapezoids, recursive sum", [](const Case& c, const Json& answer) {
    const Numbers times = c.numbers("times");
    const Numbers forces = c.numbers("forces");
    double area = 0;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      area += (times[i + 1] - times[i]) * (forces[i] + forces[i + 1]) / 2;
    }
    return same(area, answer, "impulse");
  });
  runner.method("curve", "book, compensated", [](const Case& c, const Json& answer) {
    return same(contact::impulse(curve(c)).x(), answer, "impulse");
  });
  runner.method("curve", "book, exact", [](const Case& c, const Json& answer) {
    return same(contact::impulse_exactly(curve(c)).x(), answer, "impulse");
  });
}

void add_exchange(hard_cases::Runner& runner) {
  runner.question("exchange", [](const Case& c) {
    const Rational m = oracle::exact(c.number("mass"));
    const Rational change = oracle::exact(c.number("change"));
    const Rational after =
        (m * oracle::exact(c.number("velocity")) + change * oracle::exact(c.number("matter"))) /
        (m + change);
    return Json{{"class", "a"}, {"velocity", hex(after)}};
  });
  // The attainable error is relative to |v| + |w − v| |Δm| / (m + Δm).
  const auto judge = [](const Case& c, double got, const Json& answer) {
    const Rational m = oracle::exact(c.number("mass"));
    const Rational change = oracle::exact(c.number("change"));
    const Rational v = oracle::exact(c.number("velocity"));
    const Rational size =
        abs(v) + abs(oracle::exact(c.number("matter")) - v) * abs(change) / (m + change);
    return close(got, unhex(answer, "velocity"), oracle::nearest(size / 0x1p40));
  };
  runner.method("exchange", "momentum of the body alone",
                [judge](const Case& c, const Json& answer) {
                  const double m = c.number("mass");
                  return judge(c, m * c.number("velocity") / (m + c.number("change")), answer);
                });
  runner.method("exchange", "momenta, then divide", [judge](const Case& c, const Json& answer) {
    const double m = c.number("mass");
    const double change = c.number("change");
    return judge(c, (m * c.number("velocity") + change * c.number("matter")) / (m + change),
                 answer);
  });
  runner.method("exchange", "book", [judge](const Case& c, const Json& answer) {
    const auto after =
        contact::velocity_after_exchange<double>(c.number("mass"), {c.number("velocity"), 0, 0},
                                                 c.number("change"), {c.number("matter"), 0, 0});
    return after && judge(c, after->x(), answer);
  });
}

void add_push_off(hard_cases::Runner& runner) {
  runner.question("push_off", [](const Case& c) {
    const Rational m1 = oracle::exact(c.number("first"));
    const Rational m2 = oracle::exact(c.number("second"));
    const Rational u = oracle::exact(c.number("apart"));
    const Rational v = oracle::exact(c.number("together"));
    return Json{{"class", "a"},
                {"first", hex(v - u * m2 / (m1 + m2))},
                {"second", hex(v + u * m1 / (m1 + m2))}};
  });
  const auto judge = [](const Case& c, double first, double second, const Json& answer) {
    const double room =
        std::ldexp(std::abs(c.number("together")) + std::abs(c.number("apart")), -40);
    // From rest the small recoil of a heavy body is a product, with all its digits right.
    const bool from_rest = c.number("together") == 0;
    return (from_rest ? same(first, answer, "first")
                      : close(first, unhex(answer, "first"), room)) &&
           close(second, unhex(answer, "second"), room);
  };
  runner.method("push_off", "velocity over the ground", [judge](const Case& c, const Json& answer) {
    const double ground = c.number("together") + c.number("apart");
    return judge(c,
                 c.number("together") - c.number("apart") * c.number("second") / c.number("first"),
                 ground, answer);
  });
  runner.method("push_off", "naive formula", [judge](const Case& c, const Json& answer) {
    const double m1 = c.number("first");
    const double m2 = c.number("second");
    const double u = c.number("apart");
    const double first = ((m1 + m2) * c.number("together") - m2 * u) / (m1 + m2);
    return judge(c, first, first + u, answer);
  });
  runner.method("push_off", "book", [judge](const Case& c, const Json& answer) {
    const auto after =
        contact::push_off<double>(c.number("first"), c.number("second"),
                                  {c.number("together"), 0, 0}, {c.number("apart"), 0, 0});
    return judge(c, after.first.x(), after.second.x(), answer);
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("12_momentum");
  add_total(runner);
  add_total_of_floats(runner);
  add_together(runner);
  add_balance(runner);
  add_curve(runner);
  add_exchange(runner);
  add_push_off(runner);
  return runner.run(argc, argv);
}
