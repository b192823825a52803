// Hard balls from event to event: whole runs against interval arithmetic, and invariants.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/events/hard_spheres.hpp>
#include <optional>
#include <tuple>
#include <vector>

#include "hard_setups.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::HardBall;
using contact::HardSphereEffects;
using contact::HardSphereEnd;
using contact::HardSphereHit;
using contact::HardSpheres;
using contact::HardSphereSetup;
using contact::Vector3;
using generators::Random;
using generators::tried;
using hard_setups::ball;
using hard_setups::everything;
using hard_setups::largest_overlap;
using hard_setups::Log;
using hard_setups::random_setup;
using oracle::Interval;
using oracle::Rational;

namespace {

/// Balls in a box without gravity, in intervals of many bits: all pairs are tested, and which hit
/// is next must be certain.
struct CertainBilliards {
  using V = std::array<Interval, 3>;
  unsigned bits;
  std::vector<V> x, v;
  std::vector<Interval> r, m;
  double edge;

  Interval number(const Rational& q) const { return Interval(q, bits); }
  Interval dot(const V& a, const V& b) const { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static V minus(const V& a, const V& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

  /// Time to the next hit, and its bodies; empty if two hits cannot be distinguished.
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

TEST_CASE("elastic runs conserve energy, and overlaps are rounding errors only") {
  Random random(9);
  for (int n = 0; n < tried(40); ++n) {
    const bool alike = n % 2 == 0;
    const double gravity = n % 4 < 2 ? 0 : 10;
    const HardSphereSetup setup = random_setup(random, random.integer(2, 30), alike, gravity);
    HardSpheres<HardSphereEffects{3, true, true, false, true}> run(setup);
    const double before = run.energy();
    for (int frame = 1; frame <= 20; ++frame) {
      REQUIRE(run.advance(frame * 0.1) == HardSphereEnd::reached);
      // Positions are off by some u of 6 m each.
      REQUIRE(largest_overlap(run, setup) <= 1e-13);
    }
    REQUIRE(std::abs(run.energy() - before) <= 1e-13 * before);
    REQUIRE(run.counts().largest_overlap <= 1e-13);
    REQUIRE(run.counts().hits > 3);
  }
}

TEST_CASE(
    "without walls momentum and the path of the centre of mass are conserved, whatever the "
    "restitution") {
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
