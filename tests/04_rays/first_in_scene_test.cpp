// Signs are decided without rounding. A returned index is only compared, not used. Every test
// expects a hit somewhere.
#include "first_in_scene.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <04_rays/exact_lines.hpp>

namespace {

using namespace contact::testing;
using exact::Interval;
using exercise::Ball;
using exercise::Body;
using exercise::Box;
using exercise::FirstHit;
using Found = std::optional<FirstHit>;
using Scene = std::vector<Body>;
using Vector = Eigen::Vector3d;

/// What an answer takes account of: the right one of all, and a mistaken one not.
struct Method {
  double displacement = -1;  ///< the factor with which it is added to the bullet's
  bool at_the_end = false;   ///< bodies are at the end of their step all the time
  bool balls_as_boxes = false;
  bool beyond_the_step = false;
  bool before_the_start = false;
  bool starts_outside = false;  ///< a body in which the bullet starts is not met
  bool touching = true;
};

std::optional<Interval> common(const std::optional<Interval>& x, const std::optional<Interval>& y) {
  if (!x || !y) return std::nullopt;
  const Interval in{std::max(x->entry, y->entry), std::min(x->exit, y->exit),
                    std::max(x->sign_of_entry, y->sign_of_entry),
                    std::min(x->sign_of_exit, y->sign_of_exit)};
  return in.entry <= in.exit ? std::optional(in) : std::nullopt;
}

/// The t, also before and after the step, at which the bullet is in the body.
std::optional<Interval> times(const Vector& from, const Vector& to, const Body& body,
                              const Method& method) {
  using contact::Exact;
  exact::Vector start = exact::exactly(from);
  const exact::Vector moved = exact::exactly(body.displacement);
  exact::Vector path = exact::exactly(to) - start;
  if (method.at_the_end)
    start = start - moved;
  else if (method.displacement < 0)
    path = path - moved;
  else if (method.displacement > 0)
    path = path + moved;
  if (const Ball* ball = std::get_if<Ball>(&body.shape); ball && !method.balls_as_boxes) {
    const exact::Vector m = start - exact::exactly(ball->centre);
    const Exact r = ball->radius;
    return exact::at_most_zero(exact::dot(path, path), exact::dot(path, m),
                               exact::dot(m, m) - r * r);
  }
  const Box* stored = std::get_if<Box>(&body.shape);
  Box box;
  if (stored) {
    box = *stored;
  } else {
    const Ball& ball = std::get<Ball>(body.shape);
    const Vector half = Vector::Constant(ball.radius);
    box = {ball.centre - half, ball.centre + half};
  }
  std::optional<Interval> in = Interval{};
  for (int k = 0; k < 3; ++k)
    in = common(in, exact::between(start[k], path[k], Exact(box.low[k]), Exact(box.high[k])));
  return in;
}

/// Every hit in the order of the list.
std::vector<FirstHit> hits(const Vector& from, const Vector& to, const Scene& bodies,
                           const Method& method) {
  std::vector<FirstHit> all;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto in = times(from, to, bodies[i], method);
    if (!in) continue;
    if (in->sign_of_exit < 0 && !method.before_the_start) continue;
    const bool inside = in->sign_of_entry < 0 && in->sign_of_exit >= 0;
    if (inside && method.starts_outside) continue;
    const double t = inside ? 0 : in->entry;
    if (t > 1 && !method.beyond_the_step) continue;
    if (!method.touching && (in->entry == in->exit || in->sign_of_exit == 0 || t == 1)) continue;
    all.push_back({static_cast<int>(i), t});
  }
  return all;
}

/// The first hit in the order `before(one, other)`.
template <class Before>
Found least(const std::vector<FirstHit>& all, Before&& before) {
  Found found;
  for (const FirstHit& hit : all) {
    if (!found || before(hit, *found)) found = hit;
  }
  return found;
}

Found first(const std::vector<FirstHit>& all) {
  return least(all, [](const FirstHit& x, const FirstHit& y) { return x.t < y.t; });
}

/// How long the bullet stays in the body that it meets first, in steps.
double stay(const Vector& from, const Vector& to, const Scene& bodies, const FirstHit& hit) {
  const auto in = times(from, to, bodies[static_cast<std::size_t>(hit.index)], {});
  return in->exit - in->entry;
}

void check(const Vector& from, const Vector& to, const Scene& bodies) {
  const auto all = hits(from, to, bodies, {});
  const Found right = first(all);
  const auto by = [&](const Method& method) { return first(hits(from, to, bodies, method)); };
  ask("Which body does the bullet meet first?")
      .given("from", from)
      .given("to", to)
      .given("bodies", bodies)
      .suspect("first-in-list", [&] { return all.empty() ? Found{} : Found{all.front()}; })
      .suspect("last-hit-kept", [&] { return all.empty() ? Found{} : Found{all.back()}; })
      .suspect("farthest-hit",
               [&] {
                 return least(all, [](const FirstHit& x, const FirstHit& y) { return x.t > y.t; });
               })
      .suspect("counts-from-one",
               [&] {
                 return right ? Found{FirstHit{right->index + 1, right->t}} : right;
               })
      .suspect("later-of-equals",
               [&] {
                 return least(all, [](const FirstHit& x, const FirstHit& y) { return x.t <= y.t; });
               })
      .suspect("ball-as-its-box", [&] { return by({.balls_as_boxes = true}); })
      .suspect("bodies-held-still", [&] { return by({.displacement = 0}); })
      .suspect("displacement-added", [&] { return by({.displacement = 1}); })
      .suspect("bodies-at-their-end", [&] { return by({.at_the_end = true}); })
      .suspect("beyond-the-step", [&] { return by({.beyond_the_step = true}); })
      .suspect("hits-behind-origin", [&] { return by({.before_the_start = true}); })
      .suspect("start-inside-missed", [&] { return by({.starts_outside = true}); })
      .suspect_if("exit-for-entry",
                  [&](const Found& got) {
                    if (!got || got->index < 0 || got->index >= static_cast<int>(bodies.size()))
                      return false;
                    const auto in =
                        times(from, to, bodies[static_cast<std::size_t>(got->index)], {});
                    return in && in->sign_of_entry < 0 && in->exit > 1e-6 &&
                           std::abs(got->t - in->exit) < 1e-9;
                  })
      .suspect_if("sampled-path",
                  [&](const Found& got) {
                    return right && right->t > 0 && (!got || got->t > right->t) &&
                           stay(from, to, bodies, *right) > 0 &&
                           stay(from, to, bodies, *right) < 0.05;
                  })
      .suspect("touching-rejected", [&] { return by({.touching = false}); })
      .answer([&] { return exercise::first_in_scene(from, to, bodies); })
      .close_to(right, within(1e-9));
}

Body ball(const Vector& centre, double radius, const Vector& displacement = Vector::Zero()) {
  return {Ball{centre, radius}, displacement};
}
Body box(const Vector& low, const Vector& high, const Vector& displacement = Vector::Zero()) {
  return {Box{low, high}, displacement};
}
/// 2 m thick and perpendicular to the x axis.
Body wall_at(double x) { return box({x - 1, -4, -4}, {x + 1, 4, 4}); }

}  // namespace

TEST_CASE("a bullet meets a ball or a box at rest") {
  check({0, 0, 0}, {16, 0, 0}, {ball({8, 1, 0}, 2)});
  check({0, 0, 0}, {16, 4, 8}, {box({8, 0, 1}, {14, 5, 9})});
  check({20, 5, 2}, {-2, 4, 1}, {box({2, 0, 0}, {6, 7, 3})});
  check({0, 0, 0}, {16, -0.0, 0}, {wall_at(8)});
  check({0, 0, 0}, {16, 1, 0}, {box({8, 0.25, -1}, {10, 0.75, 1})});
  // Through the corner of the ball's box.
  check({0, 0, 0}, {16, 0, 0}, {ball({8, 3, 3}, 4)});
  check({0, 1.75, 1.75}, {16, 1.75, 1.75}, {ball({6, 0, 0}, 2), wall_at(12)});
  check({0, 0, 0}, {16, 0, 0}, {ball({8, 9, 0}, 2), box({3, 5, 0}, {9, 6, 7}), wall_at(8)});
  check({0, 0, 0}, {16, 0, 0}, {});
}

TEST_CASE("the first body on the path counts, wherever it is in the list") {
  check({0, 0, 0}, {16, 0, 0}, {wall_at(8), wall_at(4), wall_at(14), ball({10, 0, 0}, 1)});
  check({0, 0, 0}, {16, 0, 0}, {wall_at(4), ball({12, 0, 0}, 1), wall_at(8)});
  check({0, 0, 0}, {16, 0, 0}, {wall_at(14), ball({12, 0, 0}, 1), ball({9, 1, 0}, 2)});
  check({16, 0, 0}, {0, 0, 0}, {wall_at(8), wall_at(4), wall_at(14), ball({10, 0, 0}, 1)});
}

TEST_CASE("a body that moves is met where it is then") {
  // Towards the bullet, away from it, and into its path from the side.
  check({0, 0, 0}, {12, 0, 0}, {ball({10, 1, 0}, 2, {-2, 0, 0})});
  check({0, 0, 0}, {12, 0, 0}, {box({4, -2, -2}, {6, 2, 2}, {3, 0, 0})});
  check({0, 0, 0}, {16, 0, 0}, {ball({8, 6, 0}, 2, {0, -12, 0})});
  check({0, 0, 0}, {16, 0, 0}, {box({7, -2, -9}, {9, 2, -3}, {0, 0, 12})});
  check({0, 0, 0}, {16, 0, 0}, {ball({8, 0, 0}, 2, {0, 12, 0})});
  check({0, 0, 0}, {16, 0, 0}, {ball({8, 6, 0}, 2, {0, -12, 0}), wall_at(14)});
  // A bullet at rest.
  check({1, 2, 3}, {1, 2, 3}, {ball({9, 2, 3}, 2, {-8, 0, 0})});
  check({1, 2, 3}, {1, 2, 3}, {box({-9, 0, 0}, {-7, 4, 4}, {16, 0, 2})});
}

TEST_CASE("a body behind the bullet or beyond the end of the step is not met") {
  check({0, 0, 0}, {16, 0, 0}, {wall_at(-4), wall_at(8)});
  check({0, 0, 0}, {16, 0, 0}, {ball({-4, 0, 0}, 1), ball({20, 0, 0}, 2)});
  check({1.5, 0, 0}, {1.75, 0, 0}, {ball({0, 0, 0}, 1), box({1.625, -1, -1}, {2, 1, 1})});
  check({0, 0, 0}, {16, 0, 0}, {wall_at(20)});
  check({0, 0, 0}, {16, 0, 0}, {ball({12, 0, 0}, 2, {8, 0, 0}), ball({20, 0, 0}, 2)});
  check({0, 0, 0}, {16, 0, 0}, {ball({-4, 0, 0}, 2, {8, 0, 0}), box({9, -1, -1}, {10, 1, 1})});
  check({0, 0, 0}, {16, 0, 0}, {ball({-4, 0, 0}, 2, {24, 0, 0}), ball({40, 0, 0}, 2)});
}

TEST_CASE("a bullet that starts in a body meets it at once") {
  check({0, 0, 0}, {16, 0, 0}, {wall_at(8), ball({-1, 0, 0}, 2)});
  check({0, 0, 0}, {16, 0, 0}, {wall_at(8), wall_at(0.5)});
  check({0, 0, 0}, {2, 0, 0}, {box({-8, -1, -1}, {8, 1, 1})});
  check({0, 0, 0}, {2, 0, 0}, {ball({0, 1, 0}, 8, {1, 1, 1})});
  // Bullet and body move together.
  check({0, 0, 0}, {2, 3, 4}, {wall_at(8), ball({1, 0, 0}, 2, {2, 3, 4})});
  check({0, 0, 0}, {2, 3, 4}, {box({-1, -1, -1}, {1, 1, 1}, {2, 3, 4})});
  check({0, 0, 0}, {2, 3, 4}, {ball({3, 0, 0}, 2, {2, 3, 4}), box({1, 0, 0}, {2, 3, 4})});
}

TEST_CASE("a thin wall is met") {
  check({0, 0, 0}, {160, 0, 0}, {box({8, -4, -4}, {8.5, 4, 4})});
  check({0, 0, 0}, {160, 0, 0}, {ball({77, 0, 0}, 1), wall_at(120)});
  check({-31, 2, 1}, {333, 2, 1}, {box({8, 0, 0}, {8.0625, 4, 4}, {2, 0, 0})});
}

TEST_CASE("touching counts, and of bodies met together the first in the list") {
  check({0, 0, 0}, {16, 0, 0}, {ball({8, 2, 0}, 2)});
  check({0, 0, 0}, {16, 0, 0}, {wall_at(12), box({4, 0, -1}, {6, 2, 1})});
  check({0, 0, 0}, {16, 0, 0}, {wall_at(12), box({4, -2, -1}, {6, 0, 1})});
  check({0, 0, 0}, {16, 0, 0}, {wall_at(17)});
  check({0, 0, 0}, {16, 0, 0}, {ball({18, 0, 0}, 2)});
  check({0, 0, 0}, {16, 0, 0}, {wall_at(12), ball({-2, 0, 0}, 2)});
  check({0, 0, 0}, {16, 0, 0}, {box({8, -4, -4}, {8, 4, 4})});
  check({0, 0, 0}, {16, 0, 0}, {ball({8, 2, 0}, 2, {0, 0, 0}), wall_at(12)});
  // The same t for all of them, in every program.
  check({0, 0, 0}, {16, 0, 0}, {wall_at(12), wall_at(9), wall_at(9), ball({10, 0, 0}, 2)});
  check({0, 0, 0}, {16, 0, 0}, {ball({1, 0, 0}, 2), wall_at(0), ball({0, 1, 0}, 3)});
}

TEST_CASE("random scenes agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  // Every body is met or missed clearly, and no two at nearly the same t.
  const auto beyond_doubt = [](const Vector& from, const Vector& to, const Scene& bodies) {
    std::vector<double> all{0, 1};
    for (const Body& body : bodies) {
      const Vector path = to - from - body.displacement;
      if (!(path.cwiseAbs().minCoeff() > 1e-3)) return false;
      if (const Ball* one = std::get_if<Ball>(&body.shape)) {
        const double apart = path.cross(from - one->centre).norm() / path.norm();
        if (!(one->radius > 0.01 && std::abs(apart - one->radius) > 0.01 * one->radius))
          return false;
      } else {
        const Box& other = std::get<Box>(body.shape);
        if (!((other.high - other.low).minCoeff() > 0.01)) return false;
        std::vector<double> planes;
        for (int k = 0; k < 3; ++k) {
          planes.push_back((other.low[k] - from[k]) / path[k]);
          planes.push_back((other.high[k] - from[k]) / path[k]);
        }
        std::sort(planes.begin(), planes.end());
        for (std::size_t i = 1; i < planes.size(); ++i) {
          if (!(planes[i] - planes[i - 1] > 1e-6)) return false;
        }
      }
      if (const auto in = times(from, to, body, {})) {
        all.push_back(in->entry);
        all.push_back(in->exit);
      }
    }
    std::sort(all.begin(), all.end());
    const auto close = [](double x, double y) { return y - x < 1e-5; };
    return std::adjacent_find(all.begin(), all.end(), close) == all.end();
  };
  for (int asked = 0; asked < 200;) {
    const Vector from = vector(4), to = from + vector(16);
    Scene bodies;
    const int count = random.integer(1, 8);
    for (int i = 0; i < count; ++i) {
      const Vector displacement = vector(8), half = vector(3).cwiseAbs();
      // Near the bullet at some moment.
      const double t = random.uniform(-0.3, 1.3);
      const Vector centre = from + t * (to - from - displacement) + vector(3);
      bodies.push_back(random.chance(0.5) ? ball(centre, random.uniform(0.3, 3), displacement)
                                          : box(centre - half, centre + half, displacement));
    }
    if (!beyond_doubt(from, to, bodies)) continue;
    ++asked;
    shrinkable(check, beyond_doubt, from, to, bodies);
  }
}
