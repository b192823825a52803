// Recomputes the answers of hard_cases.json and reports which method gets which case right.
//
// Whether two balls meet, and whether a plane is reached, is of class (a); the time and the speed
// are of class (b), with one square root, rounded once. They are right if their relative error is
// at most 2^-40; a time of 0 must be 0. Runs on a line are of class (a), in fractions, one hit
// after the other, of several at one instant the one with the lower indices; positions are right if
// they are off by at most 2^-36 of the largest coordinate, and the number of hits is right or
// wrong.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/events/hard_sphere_times.hpp>
#include <contact/events/hard_spheres.hpp>
#include <cstdlib>
#include <optional>
#include <tuple>
#include <vector>

using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;

namespace {

bool same(double got, double right, int bits = 40) {
  return std::isfinite(got) && std::abs(got - right) <= std::ldexp(std::abs(right), -bits);
}
/// A time, or that there is none.
bool same_time(double got, const Json& answer) {
  if (answer.at("after") == "never") return got == contact::never;
  return same(got, unhex(answer, "after"));
}

void add_pairs(hard_cases::Runner& runner) {
  runner.question("pair", [](const Case& c) {
    const oracle::Vector d = oracle::exact(c.vector("d"));
    const oracle::Vector w = oracle::exact(c.vector("w"));
    const Rational radius_sum = oracle::exact(c.number("radius_sum"));
    const oracle::Quadratic q{w.dot(w), 2 * d.dot(w), d.dot(d) - radius_sum * radius_sum};
    if (q.b >= 0 || (q.c > 0 && q.discriminant() < 0))
      return Json{{"class", "a"}, {"after", "never"}};
    if (q.c <= 0) return Json{{"class", "a"}, {"after", hard_cases::hex(0.0)}};
    return Json{{"class", "b"}, {"after", hard_cases::hex(oracle::nearest(q.roots().front()))}};
  });
  const auto method = [&runner](const char* name, auto time) {
    runner.method("pair", name, [time](const Case& c, const Json& answer) {
      return same_time(time(c.vector("d"), c.vector("w"), c.number("radius_sum")), answer);
    });
  };
  using V = Vector3<double>;
  method("textbook root", [](const V& d, const V& w, double radius_sum) {
    const double a = w.dot(w);
    const double b = 2 * d.dot(w);
    const double disc = b * b - 4 * a * (d.dot(d) - radius_sum * radius_sum);
    const double t = (-b - std::sqrt(disc)) / (2 * a);
    return disc >= 0 && t >= 0 ? t : contact::never;
  });
  method("steps of a hundredth", [](const V& d, const V& w, double radius_sum) {
    for (int i = 0; i <= 1000; ++i)
      if (V(d + w * (i * 0.01)).norm() <= radius_sum) return i * 0.01;
    return contact::never;
  });
  method("without the cross product", [](const V& d, const V& w, double radius_sum) {
    const double b = d.dot(w);
    const double gap = d.dot(d) - radius_sum * radius_sum;
    if (!(b < 0)) return contact::never;
    if (gap <= 0) return 0.0;
    const double disc = b * b - w.dot(w) * gap;
    return disc < 0 ? contact::never : gap / (std::sqrt(disc) - b);
  });
  method("book", [](const V& d, const V& w, double radius_sum) {
    return contact::meeting<3>(d, w, radius_sum);
  });
}

void add_walls(hard_cases::Runner& runner) {
  runner.question("wall", [](const Case& c) {
    const Rational gap = oracle::exact(c.number("gap"));
    const Rational v = oracle::exact(c.number("velocity"));
    const Rational a = oracle::exact(c.number("acceleration"));
    if (gap <= 0 && v < 0) {
      return Json{{"class", "a"},
                  {"after", hard_cases::hex(0.0)},
                  {"speed", hard_cases::hex(oracle::nearest(Rational(-v)))}};
    }
    const oracle::Quadratic q{a / 2, v, gap};
    if (a != 0 || v != 0) {
      for (const oracle::Surd& root : q.roots()) {
        const oracle::Surd rate = root * a + v;
        const int closing = -oracle::sign(rate);
        // Coming to rest just there is touching, and counts.
        if (oracle::sign(root) < 0 || closing < 0 || (closing == 0 && v >= 0)) continue;
        return Json{{"class", "b"},
                    {"after", hard_cases::hex(oracle::nearest(root))},
                    {"speed", hard_cases::hex(oracle::nearest(rate * Rational(-1)))}};
      }
    }
    return Json{{"class", "a"}, {"after", "never"}};
  });
  const auto method = [&runner](const char* name, auto arrival) {
    runner.method("wall", name, [arrival](const Case& c, const Json& answer) {
      const contact::Arrival got =
          arrival(c.number("gap"), c.number("velocity"), c.number("acceleration"));
      return same_time(got.after, answer) &&
             (got.after == contact::never || same(got.speed, unhex(answer, "speed")));
    });
  };
  method("textbook root", [](double gap, double v, double a) -> contact::Arrival {
    const double disc = v * v - 2 * a * gap;
    const double t = (-v - std::sqrt(disc)) / a;
    return disc >= 0 && t >= 0 ? contact::Arrival{t, -(v + a * t)} : contact::Arrival{};
  });
  method("steps of a thousandth", [](double gap, double v, double a) -> contact::Arrival {
    for (int i = 0; i <= 20000; ++i) {
      const double t = i * 0.001;
      if (gap + (v + a * t / 2) * t <= 0 && v + a * t < 0) return {t, -(v + a * t)};
    }
    return {};
  });
  method("book", contact::arrival_at_plane);
}

/// The right course of balls on a line without walls, in fractions.
struct Line {
  std::vector<Rational> x, v, m, r;
  int hits = 0;

  explicit Line(const Case& c) {
    for (const double value : c.numbers("positions")) x.push_back(oracle::exact(value));
    for (const double value : c.numbers("velocities")) v.push_back(oracle::exact(value));
    for (const double value : c.numbers("masses")) m.push_back(oracle::exact(value));
    for (const double value : c.numbers("radii")) r.push_back(oracle::exact(value));
  }

  void run(const Rational& end, const Rational& e) {
    Rational now = 0;
    for (;;) {
      std::optional<std::tuple<Rational, std::size_t>> first;
      for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        if (!(v[i] > v[i + 1])) continue;
        const std::tuple<Rational, std::size_t> hit{
            (x[i + 1] - r[i + 1] - x[i] - r[i]) / (v[i] - v[i + 1]), i};
        if (!first || hit < *first) first = hit;
      }
      const bool more = first && now + std::get<0>(*first) <= end;
      const Rational step = more ? std::get<0>(*first) : Rational(end - now);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * step;
      now += step;
      if (!more) return;
      const std::size_t i = std::get<1>(*first);
      const Rational push = (1 + e) * (v[i] - v[i + 1]) / (m[i] + m[i + 1]);
      v[i] -= push * m[i + 1];
      v[i + 1] += push * m[i];
      ++hits;
    }
  }
};

contact::HardSphereSetup line_setup(const Case& c) {
  contact::HardSphereSetup setup;
  setup.restitution = {c.number("restitution")};
  for (std::size_t i = 0; i < c.numbers("positions").size(); ++i) {
    setup.balls.push_back({{c.numbers("positions")[i], 0, 0},
                           {c.numbers("velocities")[i], 0, 0},
                           c.numbers("radii")[i],
                           c.numbers("masses")[i],
                           0,
                           true});
  }
  return setup;
}

void add_lines(hard_cases::Runner& runner) {
  runner.question("line", [](const Case& c) {
    Line line(c);
    line.run(oracle::exact(c.number("until")), oracle::exact(c.number("restitution")));
    Json places = Json::array();
    for (const Rational& x : line.x) places.push_back(hard_cases::hex(oracle::nearest(x)));
    return Json{{"class", "a"}, {"hits", line.hits}, {"places", places}};
  });
  const auto right_places = [](const std::vector<double>& got, const Json& answer) {
    double size = 0;
    for (const auto& place : answer.at("places"))
      size = std::max(size, std::abs(std::strtod(place.get<std::string>().c_str(), nullptr)));
    for (std::size_t i = 0; i < got.size(); ++i) {
      const double right = std::strtod(answer.at("places")[i].get<std::string>().c_str(), nullptr);
      if (!(std::abs(got[i] - right) <= std::ldexp(size, -36))) return false;
    }
    return true;
  };
  runner.method("line", "steps of a sixtieth", [right_places](const Case& c, const Json& answer) {
    std::vector<double> x = c.numbers("positions");
    std::vector<double> v = c.numbers("velocities");
    const std::vector<double> m = c.numbers("masses");
    const std::vector<double> r = c.numbers("radii");
    const auto steps = static_cast<int>(c.number("until") * 60 + 0.5);
    int hits = 0;
    for (int step = 0; step < steps; ++step) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] / 60;
      for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        if (x[i + 1] - x[i] > r[i] + r[i + 1] || !(v[i] > v[i + 1])) continue;
        const double push = (1 + c.number("restitution")) * (v[i] - v[i + 1]) / (m[i] + m[i + 1]);
        v[i] -= push * m[i + 1];
        v[i + 1] += push * m[i];
        ++hits;
      }
    }
    return hits == answer.at("hits").get<int>() && right_places(x, answer);
  });
  const auto book = [right_places](const Case& c, const Json& answer, auto& run) {
    run.advance(c.number("until"));
    std::vector<double> x;
    for (std::size_t i = 0; i < run.moving(); ++i) x.push_back(run.position(i).x());
    return static_cast<int>(run.counts().hits) == answer.at("hits").get<int>() &&
           right_places(x, answer);
  };
  runner.method("line", "book, all effects", [book](const Case& c, const Json& answer) {
    contact::HardSpheres<contact::HardSphereEffects{3, true, true, true, true}> run(line_setup(c));
    return book(c, answer, run);
  });
  runner.method("line", "book", [book](const Case& c, const Json& answer) {
    contact::HardSpheres<contact::HardSphereEffects{1, false, true, true, false}> run(
        line_setup(c));
    return book(c, answer, run);
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("21_events");
  add_pairs(runner);
  add_walls(runner);
  add_lines(runner);
  return runner.run(argc, argv);
}
