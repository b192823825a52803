// Balls on a line, compared with fractions: each hit at its time, each position and each velocity
// after it. Where all numbers are dyadic and no step of the arithmetic leaves them, every bit is
// the same; with other fractions, within a bound that grows with the number of hits. Step by step
// the same scenes keep the tolerance of their plan.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_runs.hpp>
#include <optional>
#include <tuple>
#include <vector>

#include "plan_scenes.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Effect;
using contact::PlanOptions;
using contact::Scene;
using generators::Random;
using generators::tried;
using oracle::exact;
using oracle::Rational;
using plan_scenes::Point;

namespace {

/// One body of a line: a ball, or a post, which is a fixed ball.
struct OnLine {
  Rational place;
  Rational velocity;
  Rational radius;
  Rational mass;         ///< 0: fixed
  Rational restitution;  ///< of a pair the smaller one counts
};

/// A hit of two bodies, or of a body and a wall: n at 0, n + 1 at the length.
struct LineHit {
  Rational time;
  std::size_t first = 0;
  std::size_t second = 0;
  Rational closing;  ///< at this speed they came
};

double size_of(const Rational& x) { return std::abs(oracle::nearest(x)); }

// [error]
/// Balls between walls at 0 and `length`, in fractions, and a bound on the error of a run that
/// rounds.
///
/// Let δ be the position error of a computed path, and ε its velocity error, both for each ball.
/// From hit to hit ε is constant and δ grows by ε a second. At a hit the exact velocities change by
/// a linear map M, which conserves momentum and multiplies the closing velocity by −e. A computed
/// hit does the same to the computed velocities, so ε becomes M ε. Two displaced paths cross late
/// by τ = (δ′ − δ)/w, with the closing speed w = V − V′; each changes velocity that much too late,
/// and δ becomes δ + τ (V − M V), which is M δ. M never increases Σ m ε², as it never increases
/// energy. So a hit adds to √(Σ m δ²) and √(Σ m ε²) only its roundings: errors on a line add up.
///
/// *Roundings.* All positions, and all flights of a ball from one hit to its next, are at most the
/// length L. A hit's time is computed from positions at the last hit of both (3 roundings each, of
/// L), squares of a distance and of the radii (4 of L), roots and a quotient (8 of a flight of at
/// most L); then both fly there (3), and u of the time T is u s T of flight, at a speed s. That is
/// at most 24 u (L + s T), of which twice is taken, plus what c = (1 + e) m′/(m + m′) ≤ 2 makes of
/// it in δ. A change of velocity c w goes through 14 roundings, with those of the stored data; |c
/// w| is at most 4 s.
class ExactLine {
 public:
  ExactLine(std::vector<OnLine> bodies, Rational length)
      : bodies_(std::move(bodies)), length_(std::move(length)) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) along_.push_back(i);
    std::sort(along_.begin(), along_.end(),
              [&](std::size_t a, std::size_t b) { return bodies_[a].place < bodies_[b].place; });
    for (const OnLine& body : bodies_) {  // stored data are rounded
      const double root = std::sqrt(size_of(body.mass));
      placed_ += root * u * size_of(length_);
      moving_ += root * u * size_of(body.velocity);
    }
  }

  /// Advances to the next hit, in the order of time and then of names, if it comes before `until`.
  std::optional<LineHit> step(const Rational& until) {
    using When = std::tuple<Rational, std::size_t, std::size_t>;
    std::optional<When> next;
    const auto offer = [&](const Rational& gap, const Rational& closing, std::size_t a,
                           std::size_t b) {
      if (!(closing > 0)) return;
      const When when{gap / closing, std::min(a, b), std::max(a, b)};
      if (!next || when < *next) next = when;
    };
    const std::size_t n = bodies_.size();
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const OnLine& left = bodies_[along_[k]];
      const OnLine& right = bodies_[along_[k + 1]];
      offer(right.place - right.radius - left.place - left.radius, left.velocity - right.velocity,
            along_[k], along_[k + 1]);
    }
    const OnLine& first = bodies_[along_.front()];
    const OnLine& last = bodies_[along_.back()];
    offer(first.place - first.radius, -first.velocity, along_.front(), n);
    offer(length_ - last.radius - last.place, last.velocity, along_.back(), n + 1);
    if (!next || now_ + std::get<0>(*next) > until) return std::nullopt;
    const auto [after, a, b] = *next;
    fly(now_ + after);
    return hit(a, b);
  }

  void fly(const Rational& until) {
    for (OnLine& body : bodies_) body.place += body.velocity * (until - now_);
    placed_ += moving_ * size_of(until - now_) * (1 + 1e-12);
    now_ = until;
  }

  const OnLine& body(std::size_t i) const { return bodies_[i]; }
  /// Where a body's path, as it is now, is at a time, be it past.
  Rational place_at(std::size_t i, const Rational& time) const {
    return bodies_[i].place + bodies_[i].velocity * (time - now_);
  }

  /// How far a hit's time may be off that has just been, s.
  double off_in_time() const { return late_; }
  /// Bounds on the errors of a ball's position and velocity.
  double off_in_place(std::size_t i) const {
    return (placed_ + moving_ * late_) / std::sqrt(size_of(bodies_[i].mass)) +
           4 * u * size_of(length_);
  }
  double off_in_velocity(std::size_t i) const {
    return moving_ / std::sqrt(size_of(bodies_[i].mass));
  }

 private:
  static constexpr double u = 0x1p-53;

  LineHit hit(std::size_t a, std::size_t b) {
    const bool at_wall = b >= bodies_.size();
    OnLine& one = bodies_[a];
    OnLine still{0, 0, 0, 0, 1};
    OnLine& other = at_wall ? still : bodies_[b];
    const Rational w = one.velocity - other.velocity;
    const double fast = std::max(size_of(one.velocity), size_of(other.velocity)) + size_of(w);
    const double rounded = 48 * u * (size_of(length_) + fast * size_of(now_));
    // Of both balls, each with its own mass; a fixed one has no error.
    const double roots = std::sqrt(size_of(one.mass)) + std::sqrt(size_of(other.mass));
    double apart = rounded;
    double slower = 0;
    for (const OnLine* body : {&one, &other}) {
      if (body->mass == 0) continue;
      apart += placed_ / std::sqrt(size_of(body->mass));
      slower += moving_ / std::sqrt(size_of(body->mass));
    }
    REQUIRE(slower < size_of(w) / 2);
    late_ = apart / (size_of(w) - slower) + 2 * u * size_of(now_);
    placed_ += roots * 3 * rounded + 2 * moving_ * late_;
    moving_ += roots * 64 * u * fast;

    const Rational both = 1 + std::min(one.restitution, other.restitution);
    if (one.mass == 0) {
      other.velocity += both * w;
    } else if (other.mass == 0) {
      one.velocity -= both * w;
    } else {
      const Rational push = both * w / (one.mass + other.mass);
      one.velocity -= push * other.mass;
      other.velocity += push * one.mass;
    }
    return {now_, a, b, abs(w)};
  }

  std::vector<OnLine> bodies_;
  std::vector<std::size_t> along_;  // from left to right
  Rational length_;
  Rational now_ = 0;
  double placed_ = 0;  // √(Σ m δ²) at most, m √kg
  double moving_ = 0;  // √(Σ m ε²) at most, m/s √kg
  double late_ = 0;    // τ of the last hit at most, s
};
// [/error]

/// The scene of a line: its bodies in their order, fixed ones last, and the walls.
Scene scene_on_line(const std::vector<OnLine>& bodies, const Rational& length, double duration) {
  Scene scene = plan_scenes::empty(1, 0, duration, 1e-6);
  for (const OnLine& body : bodies) {
    plan_scenes::ball(scene, oracle::nearest(body.radius), oracle::nearest(body.mass),
                      {oracle::nearest(body.place), 0, 0}, {oracle::nearest(body.velocity), 0, 0});
    scene.materials.push_back({"other", oracle::nearest(body.restitution), 0, {}, 0});
    scene.bodies.back().material = scene.materials.size() - 1;
  }
  plan_scenes::wall(scene, Point::UnitX(), 0);
  plan_scenes::wall(scene, -Point::UnitX(), -oracle::nearest(length));
  return scene;
}

/// Writes down the hits of a run.
struct HitsOnLine final : contact::SceneObserver {
  std::vector<contact::SceneHit> hits;
  bool on_hit(const contact::SceneHit& hit) override {
    hits.push_back(hit);
    return true;
  }
};

/// The bodies that take part, the smaller index first.
std::pair<std::size_t, std::size_t> who(std::size_t a, std::size_t b) { return std::minmax(a, b); }

/// From event to event, though something may be lost in hits.
std::unique_ptr<contact::SceneRun> by_events(const Scene& scene) {
  PlanOptions options;
  options.overrides.with = {Effect::event_driven};
  auto run = contact::scenes::make_run(scene, contact::plan_scene(scene, options));
  REQUIRE(run->event_driven());
  return run;
}

/// Rooms in a row, with posts between them. In each all velocities stay powers of two times a
/// speed, and so do all closing speeds: a ball that loses half of its speed, or two; equal balls; a
/// light one and one three times as heavy, which go from (s, −s) to (−2 s, 0) and, after a wall,
/// from (2 s, 0) to (−s, s). Radii of two that meet add up to 1 or 2.
std::vector<OnLine> dyadic_rooms(Random& random, Rational& length) {
  std::vector<OnLine> balls;
  std::vector<OnLine> posts;
  const int rooms = random.integer(1, 4);
  Rational at = 0;
  const auto gap = [&] { return Rational(random.integer(1, 40)) / 8; };
  for (int room = 0; room < rooms; ++room) {
    const int kind = random.integer(0, 3);
    const bool lossy = kind <= 1;
    const int count = kind == 2 ? random.integer(2, 4) : (kind == 0 ? 1 : 2);
    const Rational speed = Rational(random.integer(1, 2)) / random.integer(1, 2);
    const bool heavy_first = random.chance(0.5);
    for (int k = 0; k < count; ++k) {
      const bool heavy = kind == 3 && (k == 0) == heavy_first;
      const Rational radius = heavy ? Rational(3) / 2 : Rational(1) / 2;
      at += gap() + radius;
      const bool towards = kind == 2 ? random.chance(0.5) : k == 0;
      balls.push_back({at, towards ? speed : -speed, radius, heavy ? 3 : 1,
                       lossy ? Rational(1) / 2 : Rational(1)});
      at += radius;
    }
    at += gap();
    if (room + 1 == rooms) break;
    at += Rational(1) / 2;
    posts.push_back({at, 0, Rational(1) / 2, 0, 1});
    at += Rational(1) / 2;
  }
  length = at;
  balls.insert(balls.end(), posts.begin(), posts.end());
  return balls;
}

/// Balls with masses, positions, speeds and sizes that are fractions of small numbers, most of them
/// not doubles; and posts among them.
std::vector<OnLine> rooms_of_fractions(Random& random, Rational& length) {
  std::vector<OnLine> balls;
  std::vector<OnLine> posts;
  const auto fraction = [&](int low, int high) {
    const int below = random.integer(2, 11);
    return Rational(random.integer(low * below + 1, high * below - 1)) / below;
  };
  constexpr std::array<int, 4> tenths{10, 9, 8, 7};
  const Rational restitution =
      random.chance(0.5) ? Rational(1)
                         : Rational(tenths[static_cast<std::size_t>(random.integer(1, 3))]) / 10;
  const int count = random.integer(2, 6);
  Rational at = 0;
  for (int k = 0; k < count; ++k) {
    const Rational radius = fraction(0, 1) / 2;
    at += fraction(0, 3) + radius;
    const bool stands = k > 0 && random.chance(0.2);
    const Rational mass = stands ? Rational(0) : fraction(0, 4);
    const Rational velocity = stands ? Rational(0) : fraction(-3, 3);
    (stands ? posts : balls).push_back({at, velocity, radius, mass, restitution});
    at += radius;
  }
  length = at + fraction(0, 3);
  balls.insert(balls.end(), posts.begin(), posts.end());
  return balls;
}

}  // namespace

TEST_CASE("on a line of dyadic numbers each hit is exact to the last bit") {
  Random random(6);
  std::size_t hits = 0;
  for (int n = 0; n < tried(40); ++n) {
    Rational length;
    const std::vector<OnLine> bodies = dyadic_rooms(random, length);
    const Scene scene = scene_on_line(bodies, length, 256);
    const auto run = by_events(scene);
    ExactLine line(bodies, length);
    CAPTURE(n);
    const auto same = [&](double now) {
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        REQUIRE(exact(run->position(i).x()) == line.place_at(i, exact(now)));
        REQUIRE(exact(run->velocity(i).x()) == line.body(i).velocity);
      }
    };
    while (const auto hit = line.step(256)) {
      HitsOnLine log;
      run->advance(256, 1, &log);
      REQUIRE(log.hits.size() == 1);
      REQUIRE(who(log.hits[0].first, log.hits[0].second) == who(hit->first, hit->second));
      REQUIRE(exact(log.hits[0].time) == hit->time);
      same(run->now());
      ++hits;
    }
    line.fly(256);
    REQUIRE(run->advance(256, 1, nullptr) == contact::SceneRunEnd::reached);
    same(256);
    CHECK(run->counts().largest_overlap == 0);
  }
  CHECK(hits > tried(1000));
}

TEST_CASE(
    "on a line of fractions the errors of each hit, position and velocity are the sum over hits") {
  Random random(7);
  std::size_t hits = 0;
  double worst = 0;
  for (int n = 0; n < tried(60); ++n) {
    Rational length;
    const std::vector<OnLine> bodies = rooms_of_fractions(random, length);
    const Scene scene = scene_on_line(bodies, length, 1000);
    const auto run = by_events(scene);
    ExactLine line(bodies, length);
    CAPTURE(n);
    for (int k = 0; k < 60; ++k) {
      const auto hit = line.step(1000);
      if (!hit) break;
      HitsOnLine log;
      run->advance(1000, 1, &log);
      REQUIRE(log.hits.size() == 1);
      REQUIRE(who(log.hits[0].first, log.hits[0].second) == who(hit->first, hit->second));
      REQUIRE(oracle::error(log.hits[0].time, hit->time) <= line.off_in_time());
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].mass == 0) continue;
        REQUIRE(oracle::error(run->position(i).x(), line.place_at(i, exact(run->now()))) <=
                line.off_in_place(i));
        REQUIRE(oracle::error(run->velocity(i).x(), line.body(i).velocity) <=
                line.off_in_velocity(i));
        worst = std::max(worst, line.off_in_place(i));
      }
      ++hits;
    }
  }
  CHECK(hits > tried(2000));
  CHECK(worst < 1e-8);  // the bound is meaningful
}

TEST_CASE("on a line of fractions steps end at the exact positions, after as many hits") {
  Random random(8);
  std::uint64_t hits = 0;
  for (int n = 0; n < tried(60); ++n) {
    Rational length;
    const bool dyadic = random.chance(0.3);
    const std::vector<OnLine> bodies =
        dyadic ? dyadic_rooms(random, length) : rooms_of_fractions(random, length);
    const Scene scene = scene_on_line(bodies, length, 6);
    PlanOptions options;
    options.step = std::array<double, 3>{1.0 / 7, 1.0 / 60, 1.0 / 240}[n % 3];
    options.overrides.with = {Effect::continuous_detection};
    const contact::Plan plan = contact::plan_scene(scene, options);
    CAPTURE(n, dyadic);
    REQUIRE(plan.error <= *scene.tolerance.position);
    // Of different masses the plan cannot prove that no two hits are at one instant: its horizon is
    // then a time before which none can be. Here none is.
    const contact::Decision& horizon = contact::decision_on(plan, Effect::horizon);
    REQUIRE((!horizon.on || horizon.value));
    const auto run = contact::scenes::make_run(scene, plan);
    REQUIRE_FALSE(run->event_driven());
    ExactLine line(bodies, length);
    std::uint64_t right = 0;
    while (line.step(6)) ++right;
    line.fly(6);
    run->advance(6);
    CHECK(run->counts().hits == right);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      REQUIRE(oracle::error(run->position(i).x(), line.body(i).place) <= *scene.tolerance.position);
    hits += right;
  }
  CHECK(hits > tried(500));
}
