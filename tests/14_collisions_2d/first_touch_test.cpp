// A right time has one square root: gap, approach and the expression under the root are computed
// without rounding, and the quotient gap / (approach + √depth) of their roundings is off by 4 u.
// Random discs neither nearly graze nor nearly touch, so that the textbook formula, which cancels
// there, keeps 35 bits. Every test asks for at least two different answers, so that
// no constant passes one.
#include "first_touch.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Disc;
using exercise::Touch;
using Discs = std::vector<Disc>;
using Vector = Eigen::Vector2d;
using First = std::optional<Touch>;

struct Terms {
  double gap, approach, depth, speed2;
};

Terms terms(const Disc& a, const Disc& b) {
  const auto difference = [](double x, double y) { return Exact(x) - Exact(y); };
  const Exact dx = difference(a.centre.x(), b.centre.x());
  const Exact dy = difference(a.centre.y(), b.centre.y());
  const Exact wx = difference(a.velocity.x(), b.velocity.x());
  const Exact wy = difference(a.velocity.y(), b.velocity.y());
  const Exact radius_sum = Exact(a.radius) + Exact(b.radius);
  const Exact cross = dx * wy - dy * wx;
  const Exact speed2 = wx * wx + wy * wy;
  return {rounded<double>(dx * dx + dy * dy - radius_sum * radius_sum),
          rounded<double>(-(dx * wx + dy * wy)),
          rounded<double>(radius_sum * radius_sum * speed2 - cross * cross),
          rounded<double>(speed2)};
}

/// The earliest of the times that `when` returns for the pairs.
template <class When>
First earliest(const Discs& discs, const When& when) {
  First first;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      const std::optional<double> time = when(discs[i], discs[j]);
      if (time && (!first || *time < first->time)) {
        first = Touch{static_cast<int>(i), static_cast<int>(j), *time};
      }
    }
  }
  return first;
}

std::optional<double> right_time(const Disc& a, const Disc& b) {
  const Terms t = terms(a, b);
  if (!(t.approach > 0)) return std::nullopt;
  if (t.gap <= 0) return 0;
  if (t.depth < 0) return std::nullopt;
  return t.gap / (t.approach + std::sqrt(t.depth));
}

First sliced(const Discs& discs, double slice) {
  for (int k = 0; k * slice < 20; ++k) {
    for (std::size_t i = 0; i < discs.size(); ++i) {
      for (std::size_t j = i + 1; j < discs.size(); ++j) {
        const Vector w = discs[i].velocity - discs[j].velocity;
        const Vector d = discs[i].centre - discs[j].centre + k * slice * w;
        if (d.norm() <= discs[i].radius + discs[j].radius && d.dot(w) < 0) {
          return Touch{static_cast<int>(i), static_cast<int>(j), k * slice};
        }
      }
    }
  }
  return std::nullopt;
}

void check(const Discs& discs) {
  const First right = earliest(discs, right_time);
  auto answer =
      ask("Which two discs touch first, and at what time?")
          .given("discs", discs)
          .suspect("other-disc-stands",
                   [&] {
                     return earliest(discs, [](const Disc& a, Disc b) {
                       b.velocity = Vector(0, 0);
                       return right_time(a, b);
                     });
                   })
          .suspect("later-root",
                   [&] {
                     return earliest(discs,
                                     [](const Disc& a, const Disc& b) -> std::optional<double> {
                                       const auto time = right_time(a, b);
                                       if (!time || *time == 0) return time;
                                       const Terms t = terms(a, b);
                                       return (t.approach + std::sqrt(t.depth)) / t.speed2;
                                     });
                   })
          .suspect("sphere-as-point",
                   [&] {
                     return earliest(discs,
                                     [](const Disc& a, const Disc& b) -> std::optional<double> {
                                       const auto time = right_time(a, b);
                                       if (!time || *time == 0) return time;
                                       const Terms t = terms(a, b);
                                       return t.approach / t.speed2;
                                     });
                   })
          .suspect("separating-discs-reflected",
                   [&] {
                     return earliest(discs,
                                     [](const Disc& a, const Disc& b) -> std::optional<double> {
                                       if (terms(a, b).gap <= 0) return 0;
                                       return right_time(a, b);
                                     });
                   })
          .suspect("last-pair-kept",
                   [&] {
                     First last;
                     for (std::size_t i = 0; i < discs.size(); ++i) {
                       for (std::size_t j = i + 1; j < discs.size(); ++j) {
                         if (const auto time = right_time(discs[i], discs[j])) {
                           last = Touch{static_cast<int>(i), static_cast<int>(j), *time};
                         }
                       }
                     }
                     return last;
                   })
          .suspect_if("touches-in-the-past", [](const First& got) { return got && got->time < 0; })
          .suspect_if("sliced-time",
                      [&](const First& got) {
                        for (const double slice : {1.0, 0.1, 0.01, 0.001, 1.0 / 60}) {
                          const First by_slices = sliced(discs, slice);
                          if (got && by_slices && got->first == by_slices->first &&
                              got->second == by_slices->second &&
                              std::abs(got->time - by_slices->time) < 1e-9) {
                            return true;
                          }
                        }
                        return false;
                      })
          .answer([&] { return exercise::first_touch(discs); });
  if (!right) return std::move(answer).equals(right);
  std::move(answer).close_to(right, within(First(Touch{0, 0, 0x1p-35 * right->time})));
}

const Disc kStanding{{0, 0}, {0, 0}, 0.5};

}  // namespace

TEST_CASE("one disc meets one at rest") {
  check({{{-3.3, 0}, {1, 0}, 0.5}, kStanding});
  check({{{-3, 0.6}, {1, 0}, 0.5}, kStanding});
  check({kStanding, {{1, 7}, {-0.25, -2}, 0.75}});
}

TEST_CASE("both discs move") {
  check({{{-3, 0}, {1, 0}, 0.5}, {{4, 0.25}, {-2, 0}, 0.5}});
  check({{{-3, 0}, {1, 1}, 0.5}, {{-3, 5}, {1, 0.5}, 0.25}});
  check({{{0, 0}, {1, 0}, 0.5}, {{3, 0}, {0.75, 0}, 0.5}});
}

TEST_CASE("discs that miss each other or separate do not touch") {
  check({{{-3, 2}, {1, 0}, 0.5}, kStanding});
  check({{{-3, 0}, {-1, 0}, 0.5}, kStanding});
  check({{{-3, 0}, {1, 1}, 0.5}, {{3, 0}, {1, 1}, 0.5}});
  check({{{-3, 0}, {1, 0}, 0.5}, kStanding});
  check({kStanding});
}

TEST_CASE("discs in contact touch only if they approach") {
  check({{{-1, 0}, {1, 0.5}, 0.5}, kStanding});
  check({{{-1, 0}, {-1, 0.5}, 0.5}, kStanding});
  check({{{-0.75, 0}, {-1, 0.5}, 0.5}, kStanding, {{5, 0}, {-1, 0}, 0.5}});
  check({{{-0.75, 0}, {1, 0.5}, 0.5}, kStanding});
}

TEST_CASE("the earliest of several pairs") {
  check({{{-3, 0}, {1, 0}, 0.5}, kStanding, {{0, 9}, {0, -1}, 0.5}});
  check({{{-3, 0}, {1, 0}, 0.5}, kStanding, {{0, 9}, {0, -8}, 0.5}});
  check({{{-9, 0}, {1, 0}, 0.5}, kStanding, {{8, 8}, {0, -1}, 0.5}, {{8, 5}, {0, 0}, 0.5}});
}

TEST_CASE("a fast disc does not tunnel through a slow one") {
  check({{{-51.3, 0}, {1000, 0}, 0.1}, {{0, 0}, {0, 0}, 0.1}});
  check({{{0, -77.7}, {0, 3000}, 0.1}, {{0.05, 0}, {0, 0}, 0.1}});
}

TEST_CASE("random tables agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 100;) {
    Discs discs;
    for (int n = random.integer(2, 6); n > 0; --n) {
      const Vector centre{random.uniform(-9, 9), random.uniform(-9, 9)};
      const Vector velocity{random.uniform(-3, 3), random.uniform(-3, 3)};
      discs.push_back({centre, velocity, random.uniform(0.2, 0.8)});
    }
    bool clear = true;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      for (std::size_t j = i + 1; j < discs.size(); ++j) {
        const Terms t = terms(discs[i], discs[j]);
        const double radius_sum = discs[i].radius + discs[j].radius;
        clear =
            clear && t.gap > 0.01 && std::abs(t.depth) > 0.01 * radius_sum * radius_sum * t.speed2;
      }
    }
    if (!clear) continue;
    check(discs);
    ++asked;
  }
}
