// Recomputes the answers of hard_cases.json and reports which method gets which case right.
//
// All answers are of class (a), in fractions; squares are compared, so no root is needed.
//
// Three questions ask whether a plan may claim something. The exact answer is "true", "barely true"
// (the two sides differ by at most 2^-40 of themselves) or "false". A method is wrong if it claims
// what is false, and also if it does not claim what is true: an effect is then on for nothing. What
// is barely true need not be claimed, because outward rounding may cost that much.
//
// Two questions ask for a bound on a speed. It is right if it is at least the exact speed that a
// body reaches, and at most the bound that energy allows, also computed in fractions, by 2^-40 and
// 10^-60 m/s: in the longest duration of a scene, that is its smallest length.
#include "support/hard_cases.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/scene/scene_check.hpp>
#include <contact/scene/scene_solids.hpp>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using contact::PlanInput;
using contact::Scene;
using contact::SceneBody;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using oracle::exact;
using oracle::Rational;

namespace {

/// 1 + 2^-40, in squares of speeds 1 + 2^-39 + 2^-80.
Rational with_room() { return 1 + exact(std::ldexp(1.0, -40)); }

/// Whether left ≤ right, and if so whether by little.
Json judged(const Rational& left, const Rational& right, const Rational& room = with_room()) {
  const char* word = left > right ? "false" : (left * room >= right ? "barely true" : "true");
  return {{"class", "a"}, {"claim", word}};
}
bool is_right(bool claims, const Json& answer) {
  return answer.at("claim") != (claims ? "false" : "true");
}

Scene empty_scene() {
  Scene scene;
  scene.name = "hard_case";
  scene.about = "A hard case.";
  scene.materials.push_back({"stuff", 1, 0, {}, 0});
  scene.duration = 1;
  scene.tolerance.event_order = true;
  return scene;
}
SceneBody& add(Scene& scene, contact::SceneShape shape, double mass,
               const Vector3<double>& position,
               const Vector3<double>& velocity = Vector3<double>::Zero()) {
  SceneBody body;
  body.name = "body_" + std::to_string(scene.bodies.size());
  body.shape = std::move(shape);
  body.moves = mass > 0;
  body.mass = mass;
  if (mass > 0) body.inertia = contact::solid_inertia(body.shape, mass);
  body.position = position;
  body.velocity = velocity;
  scene.bodies.push_back(std::move(body));
  return scene.bodies.back();
}
/// The planner's input, of a scene that the reader accepts.
PlanInput planned(const Scene& scene) {
  if (!contact::check_scene(scene).empty())
    throw hard_cases::CorpusError(contact::check_scene(scene).front().path + " " +
                                  contact::check_scene(scene).front().allowed);
  return contact::plan_input(scene);
}

/// A ball that approaches a fixed plate, or a second ball, along x.
struct Approach {
  double radius, thickness, mass, speed, other_mass, other_speed, step;

  explicit Approach(const Case& c)
      : radius(c.number("radius")),
        thickness(c.number("thickness")),
        mass(c.number("mass")),
        speed(c.number("speed")),
        other_mass(c.number("other_mass")),
        other_speed(c.number("other_speed")),
        step(c.number("step")) {}

  [[nodiscard]] Scene scene() const {
    Scene scene = empty_scene();
    scene.duration = contact::max_scene_value;
    add(scene, contact::BallShape{radius}, mass, {-4 * (radius + thickness), 0, 0}, {speed, 0, 0});
    if (other_mass > 0)
      add(scene, contact::BallShape{thickness}, other_mass, Vector3<double>::Zero(),
          {-other_speed, 0, 0});
    else
      add(scene, contact::BoxShape{{thickness, 4 * thickness, 4 * thickness}}, 0,
          Vector3<double>::Zero());
    return scene;
  }
  /// Whether the approach in a step is at most twice the sum of both thicknesses, in S.
  template <class S>
  [[nodiscard]] bool in_type() const {
    const auto s = [](double x) { return static_cast<S>(x); };
    const S twice_kinetic =
        s(mass) * s(speed) * s(speed) + s(other_mass) * s(other_speed) * s(other_speed);
    const S w = 1 / s(mass) + (other_mass > 0 ? 1 / s(other_mass) : S(0));
    return std::sqrt(twice_kinetic * w) * s(step) <= 2 * (s(radius) + s(thickness));
  }
};

void add_passing(hard_cases::Runner& runner) {
  runner.question("nothing_passes", [](const Case& c) {
    const Approach a(c);
    const Rational twice_kinetic =
        exact(a.mass) * exact(a.speed) * exact(a.speed) +
        exact(a.other_mass) * exact(a.other_speed) * exact(a.other_speed);
    const Rational w =
        1 / exact(a.mass) + (a.other_mass > 0 ? Rational(1 / exact(a.other_mass)) : Rational(0));
    const Rational thick = 2 * (exact(a.radius) + exact(a.thickness));
    return judged(twice_kinetic * w * exact(a.step) * exact(a.step), thick * thick,
                  with_room() * with_room());
  });
  const auto method = [&runner](const char* name, auto claims) {
    runner.method("nothing_passes", name, [claims](const Case& c, const Json& answer) {
      return is_right(claims(Approach(c)), answer);
    });
  };
  method("wall alone", [](const Approach& a) { return a.speed * a.step < 2 * a.thickness; });
  method("float", [](const Approach& a) { return a.in_type<float>(); });
  method("double", [](const Approach& a) { return a.in_type<double>(); });
  method("book", [](const Approach& a) {
    const Scene scene = a.scene();
    const PlanInput q = planned(scene);
    if (q.pairs.size() != 1) throw hard_cases::CorpusError("the pair must be able to meet");
    return contact::holds(contact::tunnelling_conditions(q, a.step).front());
  });
}

/// Balls in a row along x, at their heights; the first flies towards the others. Perhaps a wall on
/// the right, or a fixed box.
struct Row {
  std::vector<double> heights, rises;
  double pull;
  std::optional<Vector3<double>> normal;
  std::optional<std::vector<double>> box;  ///< height of its centre, half its height

  explicit Row(const Case& c)
      : heights(c.numbers("heights")), rises(c.numbers("rises")), pull(c.number("pull")) {
    if (c.has("normal")) normal = c.vector("normal");
    if (c.has("box")) box = c.numbers("box");
  }

  [[nodiscard]] Scene scene() const {
    Scene scene = empty_scene();
    scene.duration = 100;
    scene.gravity = {0, 0, pull};
    for (std::size_t i = 0; i < heights.size(); ++i)
      add(scene, contact::BallShape{0.5}, 1, {2.0 * static_cast<double>(i), 0, heights[i]},
          {i == 0 ? 1.0 : 0.0, 0, rises[i]});
    const double right = 2 * static_cast<double>(heights.size());
    if (normal) add(scene, contact::HalfSpaceShape{*normal, -right}, 0, Vector3<double>::Zero());
    if (box) add(scene, contact::BoxShape{{0.5, 1, box->at(1)}}, 0, {right, 0, box->at(0)});
    return scene;
  }
  /// All numbers that must be 0. Beside a box that spans a ball's height the two may differ.
  template <class S>
  [[nodiscard]] std::vector<S> residuals() const {
    const auto s = [](double x) { return hard_cases::convert<S>(x); };
    std::vector<S> all{s(pull), s(normal ? normal->z() : 0.0)};
    for (const double rise : rises) all.push_back(s(rise));
    for (const double height : heights) all.push_back(s(height) - s(heights[0]));
    for (const double height : heights) {
      if (!box) break;
      const S beside = s(height) - s(box->at(0));
      const S half = s(box->at(1));
      all.push_back(-half <= beside && beside <= half ? S(0) : beside);
    }
    return all;
  }
};

void add_mirror(hard_cases::Runner& runner) {
  runner.question("its_own_mirror_image", [](const Case& c) {
    const std::vector<Rational> all = Row(c).residuals<Rational>();
    const bool mirrored =
        std::all_of(all.begin(), all.end(), [](const Rational& x) { return x == 0; });
    return Json{{"class", "a"}, {"claim", mirrored ? "true" : "false"}};
  });
  const auto method = [&runner](const char* name, auto claims) {
    runner.method("its_own_mirror_image", name, [claims](const Case& c, const Json& answer) {
      return is_right(claims(Row(c)), answer);
    });
  };
  method("within 1e-9", [](const Row& row) {
    const std::vector<double> all = row.residuals<double>();
    return std::all_of(all.begin(), all.end(), [](double x) { return std::abs(x) <= 1e-9; });
  });
  method("sums", [](const Row& row) {
    double offset = row.pull;
    for (const double height : row.heights) offset += height - row.heights[0];
    return offset == 0 && (!row.normal || row.normal->z() == 0) &&
           std::accumulate(row.rises.begin(), row.rises.end(), 0.0) == 0;
  });
  method("bits", [](const Row& row) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    bool same = bits(row.pull) == 0 && (!row.normal || bits(row.normal->z()) == 0);
    for (const double height : row.heights) same = same && bits(height) == bits(row.heights[0]);
    for (const double rise : row.rises) same = same && bits(rise) == 0;
    return same && (!row.box || bits(row.box->at(0)) == bits(row.heights[0]));
  });
  method("book", [](const Row& row) {
    const Scene scene = row.scene();
    const PlanInput q = planned(scene);
    if (q.pairs.size() < row.heights.size() - 1) throw hard_cases::CorpusError("the row must meet");
    return contact::is_proven(contact::plane_motion(q, 2));
  });
}

/// A ball alone, and the errors that the plan has already accepted.
struct Fall {
  double gravity, duration, tolerance;
  std::vector<double> accepted;

  explicit Fall(const Case& c)
      : gravity(c.number("gravity")),
        duration(c.number("duration")),
        tolerance(c.number("tolerance")),
        accepted(c.numbers("accepted")) {}

  template <class S>
  [[nodiscard]] bool in_type() const {
    S sum = 0;
    for (const double error : accepted) sum += static_cast<S>(error);
    const auto t = static_cast<S>(duration);
    return sum + static_cast<S>(gravity) * t * t / 2 <= static_cast<S>(tolerance);
  }
};

void add_falls(hard_cases::Runner& runner) {
  runner.question("the_fall_may_be_left_out", [](const Case& c) {
    const Fall f(c);
    Rational sum = exact(f.gravity) * exact(f.duration) * exact(f.duration) / 2;
    // Without gravity nothing is left out.
    if (sum == 0) return Json{{"class", "a"}, {"claim", "true"}};
    for (const double error : f.accepted) sum += exact(error);
    return judged(sum, exact(f.tolerance));
  });
  const auto method = [&runner](const char* name, auto claims) {
    runner.method("the_fall_may_be_left_out", name, [claims](const Case& c, const Json& answer) {
      return is_right(claims(Fall(c)), answer);
    });
  };
  method("each alone",
         [](const Fall& f) { return f.gravity * f.duration * f.duration / 2 <= f.tolerance; });
  method("float", [](const Fall& f) { return f.in_type<float>(); });
  method("double", [](const Fall& f) { return f.in_type<double>(); });
  method("book", [](const Fall& f) {
    Scene scene = empty_scene();
    scene.duration = f.duration;
    scene.gravity = {0, 0, -f.gravity};
    if (f.tolerance > 0) {
      scene.tolerance.event_order = false;
      scene.tolerance.position = f.tolerance;
    }
    add(scene, contact::BallShape{0.5}, 1, Vector3<double>::Zero());
    PlanInput q = planned(scene);
    for (const double error : f.accepted) {
      contact::Decision earlier;
      earlier.error = error;
      contact::spend_tolerance(q, earlier);
    }
    return contact::plan_gravity(q).proven;
  });
}

/// Elastic balls of radius 1/2 on the x axis, at most one in gravity along x.
struct Line {
  std::vector<double> positions, velocities, masses;
  double gravity, duration;

  explicit Line(const Case& c)
      : positions(c.numbers("positions")),
        velocities(c.numbers("velocities")),
        masses(c.numbers("masses")),
        gravity(c.number("gravity")),
        duration(c.number("duration")) {
    if (gravity > 0 && masses.size() > 1)
      throw hard_cases::CorpusError("only a ball alone may fall");
  }

  [[nodiscard]] Scene scene() const {
    Scene scene = empty_scene();
    scene.duration = duration;
    scene.gravity = {gravity, 0, 0};
    for (std::size_t i = 0; i < masses.size(); ++i)
      add(scene, contact::BallShape{0.5}, masses[i], {positions[i], 0, 0}, {velocities[i], 0, 0});
    return scene;
  }

  /// Runs from hit to hit, in fractions. Calls `seen` with the velocities after each.
  template <class Seen>
  void run(const Seen& seen) const {
    std::vector<Rational> x, v, m;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      x.push_back(exact(positions[i]));
      v.push_back(exact(velocities[i]));
      m.push_back(exact(masses[i]));
    }
    Rational rest = exact(duration);
    for (;;) {
      seen(v);
      std::optional<std::pair<Rational, std::size_t>> first;
      for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        if (!(v[i] > v[i + 1])) continue;
        const std::pair<Rational, std::size_t> hit{(x[i + 1] - x[i] - 1) / (v[i] - v[i + 1]), i};
        if (!first || hit < *first) first = hit;
      }
      if (!first || first->first > rest) break;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * first->first;
      rest -= first->first;
      const std::size_t i = first->second;
      const Rational push = 2 * (v[i] - v[i + 1]) / (m[i] + m[i + 1]);
      v[i] -= push * m[i + 1];
      v[i + 1] += push * m[i];
    }
    for (Rational& rate : v) rate += exact(gravity) * exact(duration);
    seen(v);
  }
  /// The largest speed of the last ball.
  [[nodiscard]] Rational speed() const {
    Rational most = 0;
    run([&most](const auto& v) { most = std::max(most, Rational(abs(v.back()))); });
    return most;
  }
  /// The largest speed with which the last two approach each other.
  [[nodiscard]] Rational closing() const {
    Rational most = 0;
    run([&most](const auto& v) { most = std::max(most, Rational(v[v.size() - 2] - v.back())); });
    return most;
  }

  /// √(2 K w) + |g| T, in S; w of the last ball, or of the last two.
  template <class S>
  [[nodiscard]] S by_energy(std::size_t balls) const {
    S twice_kinetic = 0;
    S w = 0;
    for (std::size_t i = 0; i < masses.size(); ++i)
      twice_kinetic +=
          static_cast<S>(masses[i]) * static_cast<S>(velocities[i]) * static_cast<S>(velocities[i]);
    for (std::size_t i = masses.size() - balls; i < masses.size(); ++i)
      w += 1 / static_cast<S>(masses[i]);
    return std::sqrt(twice_kinetic * w) + static_cast<S>(gravity) * static_cast<S>(duration);
  }
  /// Whether a bound is at least what is reached, and at most what energy allows.
  [[nodiscard]] bool fits(double bound, const Rational& reached, std::size_t balls) const {
    if (!std::isfinite(bound) || exact(bound) < reached) return false;
    Rational twice_kinetic = 0;
    Rational w = 0;
    for (std::size_t i = 0; i < masses.size(); ++i)
      twice_kinetic += exact(masses[i]) * exact(velocities[i]) * exact(velocities[i]);
    for (std::size_t i = masses.size() - balls; i < masses.size(); ++i) w += 1 / exact(masses[i]);
    const Rational least = exact(contact::min_scene_value) / exact(contact::max_scene_value);
    const Rational without_fall =
        exact(bound) / with_room() - exact(gravity) * exact(duration) - least;
    return without_fall <= 0 || without_fall * without_fall <= twice_kinetic * w;
  }
};

void add_speeds(hard_cases::Runner& runner) {
  runner.question("no_faster_than", [](const Case& c) {
    return Json{{"class", "a"}, {"reached", hard_cases::hex(oracle::nearest(Line(c).speed()))}};
  });
  runner.question("closing_at_most", [](const Case& c) {
    return Json{{"class", "a"}, {"reached", hard_cases::hex(oracle::nearest(Line(c).closing()))}};
  });
  const auto method = [&runner](const char* name, std::size_t balls, auto bound) {
    runner.method(balls == 1 ? "no_faster_than" : "closing_at_most", name,
                  [balls, bound](const Case& c, const Json&) {
                    const Line line(c);
                    return line.fits(bound(line), balls == 1 ? line.speed() : line.closing(),
                                     balls);
                  });
  };
  method("fastest now", 1, [](const Line& line) {
    double most = 0;
    for (const double v : line.velocities) most = std::max(most, std::abs(v));
    return most;
  });
  method("fastest now", 2, [](const Line& line) {
    return std::abs(line.velocities[line.velocities.size() - 2]) + std::abs(line.velocities.back());
  });
  method("sum of bounds", 2, [](const Line& line) {
    Line other = line;
    std::swap(other.masses.back(), other.masses[other.masses.size() - 2]);
    std::swap(other.velocities.back(), other.velocities[other.masses.size() - 2]);
    return contact::detail::rounded_up(line.by_energy<double>(1) + other.by_energy<double>(1));
  });
  for (const std::size_t balls : {1, 2}) {
    method("float", balls,
           [balls](const Line& line) { return double{line.by_energy<float>(balls)}; });
    method("double", balls, [balls](const Line& line) { return line.by_energy<double>(balls); });
  }
  method("book", 1, [](const Line& line) {
    const Scene scene = line.scene();
    return planned(scene).bounds.bodies.back().speed;
  });
  method("book", 2, [](const Line& line) {
    const Scene scene = line.scene();
    for (const contact::PairBound& pair : planned(scene).bounds.pairs) {
      if (pair.a + 2 == scene.bodies.size() && pair.b + 1 == scene.bodies.size())
        return pair.closing;
    }
    throw hard_cases::CorpusError("the last two must be able to meet");
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("20_scenes");
  add_passing(runner);
  add_mirror(runner);
  add_falls(runner);
  add_speeds(runner);
  return runner.run(argc, argv);
}
