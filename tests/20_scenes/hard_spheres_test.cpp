// Hard balls from event to event: times of contact against exact roots, whole runs against
// fractions, intervals and closed forms, and what never changes. u is the unit roundoff.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/events/earliest_queue.hpp>
#include <contact/events/hard_sphere_times.hpp>
#include <contact/events/hard_spheres.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Column;
using contact::HardBall;
using contact::HardSphereEffects;
using contact::HardSphereEnd;
using contact::HardSphereHit;
using contact::HardSphereObserver;
using contact::HardSpheres;
using contact::HardSphereSetup;
using contact::Vector3;
using generators::Random;
using generators::tried;
using oracle::Interval;
using oracle::Rational;

namespace {

constexpr double u = 0x1p-53;
constexpr HardSphereEffects everything{3, true, true, true, true};
constexpr auto no_limit = std::numeric_limits<std::uint64_t>::max();

/// Writes down who hit whom, and when.
struct Log final : HardSphereObserver {
  std::vector<HardSphereHit> hits;
  bool on_hit(const HardSphereHit& hit) override {
    hits.push_back(hit);
    return true;
  }
};

HardBall ball(const Vector3<double>& x, const Vector3<double>& v, double radius = 0.5,
              double mass = 1) {
  return {x, v, radius, mass, 0, true};
}
HardBall fixed_ball(const Vector3<double>& x, double radius) {
  return {x, Vector3<double>::Zero(), radius, 0, 0, false};
}

Vector3<double> in_cube(Random& random, double half) {
  const double x = random.uniform(-half, half);
  const double y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}

/// A box with corners (0, 0, 0) and (edge, edge, height).
void add_box(HardSphereSetup& setup, double edge, double height) {
  for (int k = 0; k < 3; ++k) {
    setup.walls.push_back({Vector3<double>::Unit(k), 0, 0});
    setup.walls.push_back({-Vector3<double>::Unit(k), k == 2 ? -height : -edge, 0});
  }
}

/// Balls at random places of a box of edge 6, of which no two overlap.
HardSphereSetup random_setup(Random& random, int balls, bool alike, double gravity) {
  HardSphereSetup setup;
  setup.gravity = {0, 0, -gravity};
  add_box(setup, 6, 6);
  while (static_cast<int>(setup.balls.size()) < balls) {
    const double radius = alike ? 0.4 : random.uniform(0.1, 0.6);
    const double mass = alike ? 1.0 : random.uniform(0.2, 5);
    const Vector3<double> x = Vector3<double>(3, 3, 3) + in_cube(random, 3 - radius);
    bool free = true;
    for (const HardBall& other : setup.balls)
      free = free && (x - other.position).norm() > radius + other.radius + 1e-6;
    if (free) setup.balls.push_back(ball(x, in_cube(random, 4), radius, mass));
  }
  return setup;
}

double largest_overlap(const contact::HardSphereRun& run, const HardSphereSetup& setup) {
  double overlap = 0;
  for (std::size_t i = 0; i < setup.balls.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double gap = (run.position(i) - run.position(k)).norm() - setup.balls[i].radius -
                         setup.balls[k].radius;
      overlap = std::max(overlap, -gap);
    }
    for (const auto& wall : setup.walls) {
      overlap = std::max(overlap,
                         -(wall.normal.dot(run.position(i)) - wall.offset - setup.balls[i].radius));
    }
  }
  return overlap;
}

void check_same_bits(const contact::HardSphereRun& a, const contact::HardSphereRun& b,
                     std::size_t balls) {
  REQUIRE(a.now() == b.now());
  for (std::size_t i = 0; i < balls; ++i) {
    for (int k = 0; k < 3; ++k) {
      REQUIRE(a.position(i)(k) == b.position(i)(k));
      REQUIRE(a.velocity(i)(k) == b.velocity(i)(k));
    }
  }
}

void check_same_hits(const Log& a, const Log& b) {
  REQUIRE(a.hits.size() == b.hits.size());
  for (std::size_t i = 0; i < a.hits.size(); ++i) {
    REQUIRE(a.hits[i].time == b.hits[i].time);
    REQUIRE(a.hits[i].ball == b.hits[i].ball);
    REQUIRE(a.hits[i].partner == b.hits[i].partner);
    REQUIRE(a.hits[i].impulse == b.hits[i].impulse);
  }
}

}  // namespace

TEST_CASE("two balls meet when the exact roots say, far from grazing") {
  Random random(1);
  int met = 0;
  for (int n = 0; n < tried(20000); ++n) {
    const Vector3<double> d = in_cube(random, 3);
    const Vector3<double> w = in_cube(random, 5);
    const double reach = random.uniform(0.1, 2);
    const oracle::Vector de = oracle::exact(d);
    const oracle::Vector we = oracle::exact(w);
    const Rational r = oracle::exact(reach);
    const oracle::Quadratic q{we.dot(we), 2 * de.dot(we), de.dot(de) - r * r};
    const double got = contact::meeting<3>(d, w, reach);
    const double depth = oracle::nearest(Rational(q.discriminant() / (q.a * r * r)));
    // The discriminant 4 w² (R² − p²) is off by less than 64 u |d|² w²: nearer to grazing than
    // this nobody can decide in double.
    if (std::abs(depth) < 1e-10) continue;
    if (q.c > 0 && q.b < 0 && depth > 0) {
      const oracle::Surd right = q.roots().front();
      // The error of the root is that of the discriminant, times root / depth.
      const double room = 256 * u * (1 + d.squaredNorm() / (reach * reach * depth)) * got;
      REQUIRE(oracle::error(got, right) <= room);
      ++met;
    } else if (q.c <= 0 && q.b < 0) {
      REQUIRE(got == 0);
    } else {
      REQUIRE(got == contact::never);
    }
    REQUIRE(contact::meeting<3>(-d, -w, reach) == got);
  }
  CHECK(met > tried(500));
}

TEST_CASE("on a line and in a plane meetings are those of space, bit for bit") {
  Random random(2);
  for (int n = 0; n < tried(5000); ++n) {
    const double reach = random.uniform(0.1, 2);
    for (int k = 0; k < 3; ++k) {
      Vector3<double> d = in_cube(random, 5);
      Vector3<double> w = in_cube(random, 5);
      d(k) = w(k) = 0;
      const int a = k == 0 ? 1 : 0;
      const int b = k == 2 ? 1 : 2;
      const double in_space = contact::meeting<3>(d, w, reach);
      REQUIRE(contact::meeting<2>(Column<2>(d(a), d(b)), Column<2>(w(a), w(b)), reach) == in_space);
      d(a) = w(a) = 0;
      REQUIRE(contact::meeting<1>(Column<1>(d(b)), Column<1>(w(b)), reach) ==
              contact::meeting<3>(d, w, reach));
    }
  }
}

TEST_CASE("a plane is reached when the exact roots say, and the speed is that of the energy") {
  Random random(3);
  int reached = 0;
  for (int n = 0; n < tried(20000); ++n) {
    const double gap = random.chance(0.1) ? 0 : random.uniform(0, 10);
    const double v = random.uniform(-10, 10);
    const double a = random.chance(0.2) ? 0 : random.uniform(-10, 10);
    const auto got = contact::arrival_at_plane(gap, v, a);
    const oracle::Quadratic q{oracle::exact(a) / 2, oracle::exact(v), oracle::exact(gap)};
    std::optional<oracle::Surd> right;
    if (gap == 0 && v < 0) {
      REQUIRE(got.after == 0);
      REQUIRE(got.speed == -v);
      continue;
    }
    for (const oracle::Surd& root : q.roots()) {
      // Of the roots, the first at which the gap closes: its rate there, v + a t, is negative.
      const oracle::Surd rate{oracle::exact(v) + oracle::exact(a) * root.a,
                              oracle::exact(a) * root.b, root.d};
      if (!right && oracle::sign(root) >= 0 && oracle::sign(rate) < 0) right = root;
    }
    if (!right) {
      REQUIRE(got.after == contact::never);
      continue;
    }
    ++reached;
    const double energy = v * v - 2 * a * gap;
    const double size = v * v + 2 * std::abs(a) * gap;
    // √ of an energy that is off by 4 u of its size; where it cancels, that much more.
    const double worse = 1 + size / energy;
    REQUIRE(oracle::error(got.after, *right) <= 16 * u * worse * got.after);
    const oracle::Surd speed{
        0, 1, oracle::exact(v) * oracle::exact(v) - 2 * oracle::exact(a) * oracle::exact(gap)};
    REQUIRE(oracle::error(got.speed, speed) <= 8 * u * worse * got.speed);
  }
  CHECK(reached > tried(8000));
  // What leaves with s comes back with s, to the last bit.
  for (int n = 0; n < tried(5000); ++n) {
    const double s = random.uniform(0, 100);
    REQUIRE(contact::arrival_at_plane(0, s, -random.uniform(0.1, 20)).speed == s);
  }
}

TEST_CASE("where one path bends, the meeting is the first zero at which the gap closes") {
  Random random(4);
  int met = 0;
  for (int n = 0; n < tried(3000); ++n) {
    const Vector3<double> d = in_cube(random, 3);
    const Vector3<double> w = in_cube(random, 5);
    const Vector3<double> a{0, 0, random.uniform(-12, 12)};
    const double reach = random.uniform(0.1, 2);
    if (d.norm() <= reach) continue;
    const double got = contact::bent_meeting<3>(d, w, a, reach, false);
    // In fractions: |d + w t + a t²/2|² − R².
    const auto f = [&](const Rational& t) {
      const oracle::Vector x =
          oracle::ballistic(oracle::exact(d), oracle::exact(w), oracle::exact(a), t);
      return Rational(x.dot(x) - oracle::exact(reach) * oracle::exact(reach));
    };
    const double last = got == contact::never ? 20 : got;
    const double size = d.squaredNorm() + w.squaredNorm() * last * last +
                        a.squaredNorm() * last * last * last * last + reach * reach;
    // No zero is passed over: up to there f is positive, wherever one looks, but for rounding.
    for (int k = 0; k < 40; ++k)
      REQUIRE(oracle::nearest(f(oracle::exact(last) * k / 40)) > -64 * u * size);
    if (got == contact::never) continue;
    ++met;
    REQUIRE(std::abs(oracle::nearest(f(oracle::exact(got)))) <= 64 * u * size);
  }
  CHECK(met > tried(3000) / 30);
  // Thrown straight up beside it, and back onto it: closed form 2 v / g.
  const double back = contact::bent_meeting<3>({0, 0, 1}, {0, 0, 5}, {0, 0, -10}, 1, true);
  CHECK(std::abs(back - 1) <= 4 * u);
}

TEST_CASE("the tournament's winner is the least, whatever changes") {
  Random random(5);
  for (int n = 0; n < tried(60); ++n) {
    const auto slots = static_cast<std::size_t>(random.integer(1, 40));
    std::vector<int> keys(slots, 0);
    const auto before = [&](std::size_t i, std::size_t k) {
      return std::pair(keys[i], i) < std::pair(keys[k], k);
    };
    contact::EarliestQueue queue(slots);
    queue.play_all(before);
    for (int change = 0; change < 300; ++change) {
      const auto slot = static_cast<std::size_t>(random.integer(0, static_cast<int>(slots) - 1));
      keys[slot] = random.integer(-20, 20);
      queue.update(slot, before);
      std::size_t least = 0;
      for (std::size_t i = 1; i < slots; ++i)
        if (before(i, least)) least = i;
      REQUIRE(queue.first() == least);
    }
  }
}

namespace {

/// Balls in a box without gravity, in intervals of many bits: everybody asks everybody, and who is
/// next must be certain.
struct CertainBilliards {
  using V = std::array<Interval, 3>;
  unsigned bits;
  std::vector<V> x, v;
  std::vector<Interval> r, m;
  double edge;

  Interval number(const Rational& q) const { return Interval(q, bits); }
  Interval dot(const V& a, const V& b) const { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static V minus(const V& a, const V& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

  /// Time to the next hit, and who; nothing if two cannot be told apart.
  std::optional<std::tuple<Interval, std::size_t, std::size_t>> step() {
    const std::size_t n = x.size();
    std::optional<std::tuple<Interval, std::size_t, std::size_t>> first;
    bool certain = true;
    const auto offer = [&](const Interval& t, std::size_t a, std::size_t b) {
      if (!first) {
        first = {t, a, b};
        return;
      }
      const auto sign = (t - std::get<0>(*first)).sign();
      if (!sign) certain = false;
      if (sign && *sign < 0) first = {t, a, b};
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto sign = v[i][k].sign();
        if (!sign) return std::nullopt;
        const Interval wall = number(*sign < 0 ? Rational(0) : oracle::exact(edge));
        const Interval way = *sign < 0 ? x[i][k] - r[i] - wall : wall - r[i] - x[i][k];
        const Interval speed = *sign < 0 ? -v[i][k] : v[i][k];
        offer(way / speed, i, n + 2 * k + (*sign < 0 ? 0 : 1));
      }
      for (std::size_t k = i + 1; k < n; ++k) {
        const V d = minus(x[k], x[i]);
        const V w = minus(v[k], v[i]);
        const Interval approach = dot(d, w);
        const auto closing = approach.sign();
        if (!closing) return std::nullopt;
        if (*closing > 0) continue;
        const Interval reach = r[i] + r[k];
        const Interval c = dot(d, d) - reach * reach;
        const Interval depth = approach * approach - dot(w, w) * c;
        const auto meets = depth.sign();
        if (!meets) return std::nullopt;
        if (*meets < 0) continue;
        offer(c / (sqrt(depth) - approach), i, k);
      }
    }
    if (!certain) return std::nullopt;
    const auto [t, a, b] = *first;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < 3; ++k) x[i][k] = x[i][k] + v[i][k] * t;
    if (b >= n) {
      v[a][(b - n) / 2] = -v[a][(b - n) / 2];
    } else {
      const V d = minus(x[b], x[a]);
      const Interval push = number(2) * dot(d, minus(v[b], v[a])) / dot(d, d) / (m[a] + m[b]);
      for (std::size_t k = 0; k < 3; ++k) {
        v[a][k] = v[a][k] + d[k] * push * m[b];
        v[b][k] = v[b][k] - d[k] * push * m[a];
      }
    }
    return first;
  }
};

/// @param moved by how much coordinates are moved, each by another multiple from −4 to 4
CertainBilliards certain(const HardSphereSetup& setup, unsigned bits, const Rational& moved) {
  CertainBilliards all{bits, {}, {}, {}, {}, 6};
  int turn = 0;
  for (const HardBall& b : setup.balls) {
    const auto three = [&](const Vector3<double>& v) {
      CertainBilliards::V made;
      for (int k = 0; k < 3; ++k) {
        turn = (turn + 4) % 9;
        made[static_cast<std::size_t>(k)] =
            Interval(Rational(oracle::exact(v(k)) + moved * (turn - 4)), bits);
      }
      return made;
    };
    all.x.push_back(three(b.position));
    all.v.push_back(three(b.velocity));
    all.r.emplace_back(oracle::exact(b.radius), bits);
    all.m.emplace_back(oracle::exact(b.mass), bits);
  }
  return all;
}

}  // namespace

TEST_CASE("billiards follow the intervals, hit for hit, until rounding has grown to 1e-6") {
  Random random(8);
  int followed = 0;
  for (int n = 0; n < tried(16); ++n) {
    const HardSphereSetup setup = random_setup(random, random.integer(3, 6), n % 2 == 0, 0);
    HardSpheres<HardSphereEffects{3, false, true, false, true}> run(setup);
    Log log;
    run.advance(1000, 120, &log);
    // Beside the truth, the truth of a start that is moved by 2^-50: how far those two are apart
    // is how much an ulp has grown.
    CertainBilliards truth = certain(setup, 1024, 0);
    CertainBilliards moved = certain(setup, 1024, Rational(1) / Rational(oracle::Integer(1) << 50));
    Rational now = 0;
    Rational now_moved = 0;
    for (const HardSphereHit& hit : log.hits) {
      const auto right = truth.step();
      const auto beside = moved.step();
      if (!right || !beside || std::get<1>(*right) != std::get<1>(*beside) ||
          std::get<2>(*right) != std::get<2>(*beside))
        break;
      now += std::get<0>(*right).low();
      now_moved += std::get<0>(*beside).low();
      const double grown = std::max(0x1p-46, std::abs(oracle::nearest(Rational(now - now_moved))));
      double spread = grown;
      for (std::size_t i = 0; i < truth.x.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          spread = std::max(
              spread,
              std::abs(oracle::nearest(Rational(truth.x[i][k].low() - moved.x[i][k].low()))));
        }
      }
      if (spread > 1e-6) break;
      // An event adds a few u of all coordinates; the one difference that was put in grows like
      // the largest of them. 4,096 is for how many there are, and for directions.
      REQUIRE(std::minmax(std::get<1>(*right), std::get<2>(*right)) ==
              std::minmax(hit.ball, hit.partner));
      REQUIRE(oracle::error(hit.time, now) <= 4096 * spread);
      ++followed;
    }
  }
  CHECK(followed > tried(16) * 15);
}

TEST_CASE("elastic runs keep their energy, and nothing overlaps but for rounding") {
  Random random(9);
  for (int n = 0; n < tried(40); ++n) {
    const bool alike = n % 2 == 0;
    const double gravity = n % 4 < 2 ? 0 : 10;
    const HardSphereSetup setup = random_setup(random, random.integer(2, 30), alike, gravity);
    HardSpheres<HardSphereEffects{3, true, true, false, true}> run(setup);
    const double before = run.energy();
    for (int frame = 1; frame <= 20; ++frame) {
      REQUIRE(run.advance(frame * 0.1) == HardSphereEnd::reached);
      // Places are off by some u of 6 m each.
      REQUIRE(largest_overlap(run, setup) <= 1e-13);
    }
    REQUIRE(std::abs(run.energy() - before) <= 1e-13 * before);
    REQUIRE(run.counts().largest_overlap <= 1e-13);
    REQUIRE(run.counts().hits > 3);
  }
}

TEST_CASE("without walls momentum and the centre's path stay, whatever the restitution") {
  Random random(10);
  for (int n = 0; n < tried(40); ++n) {
    HardSphereSetup setup = random_setup(random, 20, false, 0);
    setup.walls.clear();
    setup.gravity = {1, -2, -9};
    setup.restitution = {random.uniform(0.3, 1)};
    // Towards the middle, so that they meet.
    for (HardBall& b : setup.balls) b.velocity = Vector3<double>(3, 3, 3) - b.position;
    HardSpheres<everything> run(setup);
    REQUIRE(run.advance(3) == HardSphereEnd::reached);
    REQUIRE(run.counts().hits > 10);
    Vector3<double> momentum = Vector3<double>::Zero();
    Vector3<double> expected = Vector3<double>::Zero();
    double mass = 0;
    for (std::size_t i = 0; i < setup.balls.size(); ++i) {
      momentum += run.velocity(i) * setup.balls[i].mass;
      expected += (setup.balls[i].velocity + setup.gravity * 3) * setup.balls[i].mass;
      mass += setup.balls[i].mass;
    }
    // Each of some hundred roundings is off by u of 30 m/s.
    REQUIRE((momentum - expected).norm() <= 1e-12 * mass);
  }
}

TEST_CASE("a composition without an effect that does nothing gives the same bits as all effects") {
  Random random(11);
  for (int n = 0; n < tried(12); ++n) {
    const HardSphereSetup setup = random_setup(random, 24, true, n % 2 == 0 ? 10 : 0);
    HardSpheres<everything> full(setup);
    HardSpheres<HardSphereEffects{3, true, true, true, false}> all_pairs(setup);
    HardSpheres<HardSphereEffects{3, true, false, false, true}> least(setup);
    Log of_full;
    Log of_pairs;
    Log of_least;
    full.advance(3, no_limit, &of_full);
    all_pairs.advance(3, no_limit, &of_pairs);
    least.advance(3, no_limit, &of_least);
    REQUIRE(of_full.hits.size() > 100);
    check_same_hits(of_full, of_pairs);
    check_same_hits(of_full, of_least);
    check_same_bits(full, all_pairs, setup.balls.size());
    check_same_bits(full, least, setup.balls.size());
    if (n % 2 == 1) {
      HardSpheres<HardSphereEffects{3, false, false, false, true}> floating(setup);
      floating.advance(3);
      check_same_bits(full, floating, setup.balls.size());
    }
  }
}

TEST_CASE("a motion in a plane, or on a line, is the same without the other coordinates") {
  Random random(12);
  for (int n = 0; n < tried(12); ++n) {
    const int flat = n % 3;
    HardSphereSetup setup;
    for (int i = 0; i < 16; ++i) {
      Vector3<double> x{1.3 * (i % 4) + 1, 1.3 * (i / 4) + 1, 0};
      Vector3<double> v{random.uniform(-3, 3), random.uniform(-3, 3), 0};
      std::swap(x(2), x(flat));
      std::swap(v(2), v(flat));
      x(flat) = 0.7;
      setup.balls.push_back(ball(x, v));
    }
    for (int k = 0; k < 3; ++k) {
      setup.walls.push_back({Vector3<double>::Unit(k), 0, 0});
      setup.walls.push_back({-Vector3<double>::Unit(k), -6, 0});
    }
    const std::array<int, 3> axes{flat == 0 ? 1 : 0, flat == 2 ? 1 : 2, flat};
    setup.gravity(axes[0]) = -10;
    HardSpheres<HardSphereEffects{3, true, false, false, true}> space(setup);
    HardSpheres<HardSphereEffects{2, true, false, false, true}> plane(setup, axes);
    space.advance(4);
    plane.advance(4);
    REQUIRE(space.counts().hits > 100);
    check_same_bits(space, plane, setup.balls.size());
    REQUIRE(plane.bytes_per_state() < space.bytes_per_state());
  }
}

TEST_CASE("a run that is stopped, kept and resumed gives the bits of one that is not") {
  Random random(13);
  for (int n = 0; n < tried(12); ++n) {
    HardSphereSetup setup = random_setup(random, 16, n % 2 == 0, 10);
    setup.restitution = {n % 3 == 0 ? 1 : 0.9};
    HardSpheres<everything> whole(setup);
    HardSpheres<everything> first(setup);
    REQUIRE(whole.advance(1.5) == HardSphereEnd::reached);
    REQUIRE(first.advance(1.5, 37, nullptr) == HardSphereEnd::out_of_events);
    const auto kept = first.checkpoint();
    HardSpheres<everything> second(setup);
    second.restore(kept);
    REQUIRE(second.advance(1.5) == HardSphereEnd::reached);
    check_same_bits(whole, second, setup.balls.size());
    REQUIRE(whole.counts().hits == second.counts().hits);
    // Asked a little at a time, watched, and with a budget of one hit each.
    HardSpheres<everything> asked(setup);
    Log log;
    while (asked.advance(std::min(1.5, asked.now() + 0.01), 1, &log) != HardSphereEnd::reached ||
           asked.now() < 1.5) {
    }
    check_same_bits(whole, asked, setup.balls.size());
    REQUIRE(log.hits.size() == whole.counts().hits);
  }
}

TEST_CASE("a ball dropped from 10 m comes back to 10 m after a minute, to the last bits") {
  HardSphereSetup setup;
  setup.gravity = {0, 0, -10};
  setup.cutoff = 0x1p-30;
  setup.walls = {{Vector3<double>(0, 0, 1), 0, 0}};
  setup.balls = {ball({0, 0, 10.5}, {0, 0, 0})};
  HardSpheres<HardSphereEffects{1, true, false, false, false}> run(setup, {2, 0, 1});
  REQUIRE(run.advance(60) == HardSphereEnd::reached);
  CHECK(run.counts().hits == 21);
  const double z = run.position(0).z() - 0.5;
  const double v = run.velocity(0).z();
  // Height and v² / 2 g round a few times each.
  CHECK(std::abs(z + v * v / 20 - 10) <= 64 * u * 10);
  // After an hour of it a hit still sends it up as fast as the first one did.
  struct Rebounds final : HardSphereObserver {
    explicit Rebounds(const contact::HardSphereRun& watched) : run(watched) {}
    const contact::HardSphereRun& run;
    std::vector<double> speeds;
    bool on_hit(const HardSphereHit&) override {
      speeds.push_back(run.velocity(0).z());
      return true;
    }
  } rebounds(run);
  run.advance(3600, no_limit, &rebounds);
  REQUIRE(rebounds.speeds.size() > 1000);
  for (const double speed : rebounds.speeds) REQUIRE(speed == std::sqrt(200.0));
}

TEST_CASE("two balls: the closed form of an oblique hit") {
  // Unit balls, one at rest; the other comes along x with an offset of 1.2: sin = 0.6 at contact.
  HardSphereSetup setup;
  setup.balls = {ball({0, 0, 0}, {0, 0, 0}, 1), ball({-5, 1.2, 0}, {1, 0, 0}, 1)};
  HardSpheres<HardSphereEffects{2, false, false, false, false}> run(setup);
  Log log;
  run.advance(10, no_limit, &log);
  REQUIRE(log.hits.size() == 1);
  CHECK(std::abs(log.hits[0].time - 3.4) <= 64 * u);
  CHECK((run.velocity(0) - Vector3<double>(0.64, -0.48, 0)).norm() <= 64 * u);
  CHECK((run.velocity(1) - Vector3<double>(0.36, 0.48, 0)).norm() <= 64 * u);
}

TEST_CASE("a bouncing ball with e < 1 follows the closed form and then lies still") {
  Random random(14);
  for (int n = 0; n < tried(50); ++n) {
    const double height = random.uniform(0.5, 5);
    const double e = random.uniform(0.1, 0.9);
    HardSphereSetup setup;
    setup.gravity = {0, 0, -9.81};
    setup.restitution = {e};
    setup.walls = {{Vector3<double>(0, 0, 1), 0, 0}};
    setup.balls = {ball({0, 0, height + 0.5}, {1, 0, 0})};
    HardSpheres<HardSphereEffects{3, true, false, true, false}> run(setup);
    const contact::BouncingBall<double> law{height, 0, 9.81, e};
    for (int k = 1; k <= 60; ++k) {
      const double t = k * 0.15;
      REQUIRE(run.advance(t) == HardSphereEnd::reached);
      const auto right = contact::bounce_at(law, t);
      const double room = run.counts().rest_error + 1e-11;
      REQUIRE(std::abs(run.position(0).z() - 0.5 - right.height) <= room);
      REQUIRE(std::abs(run.position(0).x() - t) <= 1e-13);
      // The documented error of lying down.
      REQUIRE(run.counts().rest_error <= 9.81 * setup.cutoff * setup.cutoff / 8);
    }
    REQUIRE(run.advance(1000) == HardSphereEnd::reached);
    CHECK(run.lies_on(0) == 0);
    CHECK(run.velocity(0) == Vector3<double>(1, 0, 0));
    CHECK(run.position(0).z() == 0.5);
  }
}

TEST_CASE("a ball that lies is hit, flies, and lies again") {
  HardSphereSetup setup;
  setup.gravity = {0, 0, -10};
  setup.restitution = {0.5};
  setup.walls = {{Vector3<double>(0, 0, 1), 0, 0}};
  setup.balls = {ball({0, 0, 0.5}, {0, 0, 0}), ball({-3, 0, 0.75}, {4, 0, 2})};
  HardSpheres<everything> run(setup);
  REQUIRE(run.advance(0.1) == HardSphereEnd::reached);
  CHECK(run.lies_on(0) == 0);
  CHECK(run.lies_on(1) == -1);
  Log log;
  REQUIRE(run.advance(20, no_limit, &log) == HardSphereEnd::reached);
  bool met = false;
  for (const auto& hit : log.hits) met = met || std::max(hit.ball, hit.partner) == 1;
  CHECK(met);
  CHECK(run.lies_on(0) == 0);
  CHECK(run.lies_on(1) == 0);
  CHECK(run.velocity(0).z() == 0);
  CHECK(largest_overlap(run, setup) <= 1e-12);
}

TEST_CASE("on a slope a ball slides down with g sin, without friction") {
  HardSphereSetup setup;
  setup.gravity = {0, 0, -10};
  setup.restitution = {0.0};
  const Vector3<double> normal(0.6, 0, 0.8);
  setup.walls = {{normal, 0, 0}};
  setup.balls = {ball(normal * 0.5, {0, 0, 0})};
  HardSpheres<everything> run(setup);
  REQUIRE(run.advance(2) == HardSphereEnd::reached);
  // Down the slope: (0.8, 0, −0.6) 10 · 0.6 t²/2.
  const Vector3<double> right = normal * 0.5 + Vector3<double>(0.8, 0, -0.6) * 12;
  CHECK((run.position(0) - right).norm() <= 1e-13);
}

TEST_CASE("balls that never move push back, with gravity and without") {
  Random random(15);
  for (int n = 0; n < tried(20); ++n) {
    HardSphereSetup setup = random_setup(random, 8, n % 2 == 0, n % 3 == 0 ? 0 : 10);
    const Vector3<double> peg{3, 3, 3};
    std::erase_if(setup.balls,
                  [&](const HardBall& b) { return (b.position - peg).norm() < b.radius + 1.001; });
    if (setup.balls.empty()) continue;
    setup.balls.push_back(fixed_ball(peg, 1));
    HardSpheres<HardSphereEffects{3, true, true, false, true}> run(setup);
    HardSpheres<HardSphereEffects{3, true, true, false, false}> pairs(setup);
    const double before = run.energy();
    Log log;
    REQUIRE(run.advance(4, no_limit, &log) == HardSphereEnd::reached);
    pairs.advance(4);
    check_same_bits(run, pairs, setup.balls.size());
    CHECK(run.position(setup.balls.size() - 1) == peg);
    CHECK(std::abs(run.energy() - before) <= 1e-12 * before);
    CHECK(largest_overlap(run, setup) <= 1e-12);
  }
}

TEST_CASE("what has no bound on its hits is refused, and never hangs") {
  // Three balls on a line with e below 7 − 4√3: hits pile up before a finite time.
  HardSphereSetup line;
  line.restitution = {0.01};
  line.balls = {ball({0, 0, 0}, {1, 0, 0}), ball({1.5, 0, 0}, {0, 0, 0}),
                ball({3, 0, 0}, {-1, 0, 0})};
  HardSpheres<HardSphereEffects{1, false, false, true, false}> collapse(line);
  CHECK(collapse.advance(10) == HardSphereEnd::endless_hits);
  CHECK(collapse.counts().endless_ball == 1);
  // A ball that would lie on another.
  HardSphereSetup stack;
  stack.gravity = {0, 0, -10};
  stack.restitution = {0.5};
  stack.walls = {{Vector3<double>(0, 0, 1), 0, 0}};
  stack.balls = {ball({0, 0, 0.5}, {0, 0, 0}), ball({0, 0, 2}, {0, 0, 0})};
  HardSpheres<everything> pile(stack);
  CHECK(pile.advance(10) == HardSphereEnd::endless_hits);
  CHECK(pile.now() < 3);
  // In a groove one ball touches two walls.
  HardSphereSetup groove;
  groove.gravity = {0, 0, -10};
  groove.restitution = {0.5};
  groove.walls = {{Vector3<double>(0.6, 0, 0.8), 0, 0}, {Vector3<double>(-0.6, 0, 0.8), 0, 0}};
  groove.balls = {ball({0.1, 0, 2}, {0, 0, 0})};
  HardSpheres<everything> wedge(groove);
  CHECK(wedge.advance(10) == HardSphereEnd::endless_hits);
}

TEST_CASE("what no effect needs is not kept") {
  using D3 = HardSpheres<HardSphereEffects{3, false, false, false, true}>;
  using G3 = HardSpheres<HardSphereEffects{3, true, false, false, true}>;
  using F3 = HardSpheres<everything>;
  using D1 = HardSpheres<HardSphereEffects{1, false, false, false, false}>;
  HardSphereSetup setup;
  setup.balls = {ball({0, 0, 0}, {0, 0, 0})};
  // Place, velocity, time and the last partner; lying down takes what alignment left over.
  CHECK(D1(setup).bytes_per_state() == 2 * 8 + 8 + 8);
  CHECK(D3(setup).bytes_per_state() == 6 * 8 + 8 + 8);
  CHECK(G3(setup).bytes_per_state() == 6 * 8 + 8 + 8);
  CHECK(F3(setup).bytes_per_state() == 6 * 8 + 8 + 16 + 16);
  const HardSphereSetup gas = contact::dilute_gas(1000, 1);
  const HardSphereSetup more = contact::dilute_gas(8000, 1);
  const double growth =
      static_cast<double>(D3(more).bytes()) / static_cast<double>(D3(gas).bytes());
  CHECK(growth <= std::pow(8, 1.1));
}

TEST_CASE("a setup that is none is refused with what is wrong") {
  const auto refusal = [](auto change) -> std::string {
    HardSphereSetup setup;
    setup.balls = {ball({0, 0, 0}, {0, 0, 0}), ball({2, 0, 0}, {0, 0, 0})};
    setup.walls = {{Vector3<double>(0, 0, 1), -9, 0}};
    change(setup);
    try {
      contact::require_hard_sphere_setup(setup);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  CHECK(refusal([](HardSphereSetup&) {}).empty());
  CHECK(has(refusal([](auto& s) { s.balls[1].mass = -1; }), "balls[1].mass = -1"));
  CHECK(has(refusal([](auto& s) { s.balls[0].radius = 0; }), "balls[0].radius = 0"));
  CHECK(has(refusal([](auto& s) { s.balls[0].position.x() = std::nan(""); }), "balls[0].position"));
  CHECK(has(refusal([](auto& s) { s.restitution = {1.5}; }), "restitution = 1.5"));
  CHECK(has(refusal([](auto& s) { s.restitution = {1, 1}; }), "2 entries"));
  CHECK(has(refusal([](auto& s) { s.restitution = {1, 0.5, 0.25, 1}; }), "either order"));
  CHECK(has(refusal([](auto& s) { s.walls[0].normal *= 2; }), "walls[0].normal"));
  CHECK(has(refusal([](auto& s) { s.walls[0].material = 3; }), "walls[0].material = 3"));
  CHECK(has(refusal([](auto& s) { s.cutoff = -1; }), "cutoff = -1"));
  CHECK(has(refusal([](auto& s) { s.balls[0].moves = false; }), "at least one must move"));
  HardSphereSetup heavy;
  heavy.gravity = {0, 0, -1};
  heavy.balls = {ball({0, 0, 0}, {0, 0, 0})};
  CHECK_THROWS_AS((HardSpheres<HardSphereEffects{3, false, true, true, true}>(heavy)),
                  std::invalid_argument);
}
