// By how many digits has a small error grown after some hits? A ball flies at 1 m/s among posts and
// flat walls, and a twin begins beside it, or in a slightly different direction. The answer is the
// decimal logarithm of the ratio of their distances. An answer is wrong if it is off by more than
// half a digit.
#include "figures/four_posts.hpp"

#include <support/ladder.hpp>

#include <contact/double_double.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using contact::DoubleDouble;
using four_posts::ball_radius;
using four_posts::posts;

constexpr double half_a_digit = 0.5;

struct Input {
  std::array<double, 2> from{};  // the ball's centre, m
  std::array<double, 2> to{};    // where it is aimed, m
  double post = 0;               // radius of the posts, m; 0: there are none
  int hits = 1;                  // on posts or walls: the run ends with the last of them
  bool rotated = false;          // the twin begins at the same point, in another direction
};

struct Answer {
  double digits = 0;  // log10 of the distance at the end by the one at the start, or by the angle
};

double sum_of_radii(const Input& input) { return input.post + ball_radius; }

// ---------------------------------------------------------------- a billiard in any type

template <class S>
struct Pair {
  S x{}, y{};

  friend Pair operator+(const Pair& a, const Pair& b) { return {a.x + b.x, a.y + b.y}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {a.x - b.x, a.y - b.y}; }
  friend Pair operator*(const S& s, const Pair& a) { return {s * a.x, s * a.y}; }
  friend S dot(const Pair& a, const Pair& b) { return a.x * b.x + a.y * b.y; }
};

template <class S>
struct Ball {
  Pair<S> position, velocity;
};

template <class S>
double as_double(const S& x) {
  if constexpr (std::is_same_v<S, DoubleDouble>)
    return x.high();
  else
    return static_cast<double>(x);
}

template <class S>
S norm(const Pair<S>& a) {
  using std::sqrt;
  const S square = dot(a, a);
  return square > S(0) ? sqrt(square) : S(0);
}

constexpr std::size_t walls = 4;

/// The room for the ball's centre.
template <class S>
struct Room {
  explicit Room(const Input& input)
      : radius(static_cast<S>(sum_of_radii(input))), count(input.post > 0 ? posts.size() : 0) {
    for (std::size_t i = 0; i < count; ++i)
      centres[i] = {static_cast<S>(posts[i][0]), static_cast<S>(posts[i][1])};
  }

  std::array<Pair<S>, posts.size()> centres{};
  S radius;  // of post and ball together
  std::size_t count;
  Pair<S> low{static_cast<S>(ball_radius), static_cast<S>(ball_radius)};
  Pair<S> high{static_cast<S>(four_posts::width - ball_radius),
               static_cast<S>(four_posts::height - ball_radius)};
};

template <class S>
struct Hit {
  S time = S(0);
  std::size_t partner = 0;  // a wall, or the number of walls and of a post
  bool on_post() const { return partner >= walls; }
};

template <class S>
Hit<S> next_hit(const Room<S>& room, const Ball<S>& ball) {
  using std::sqrt;
  Hit<S> first{S(1e9), 0};
  const auto offer = [&first](const S& time, std::size_t partner) {
    if (time < first.time) first = {time > S(0) ? time : S(0), partner};
  };
  const Pair<S>& v = ball.velocity;
  if (v.x < S(0)) offer((room.low.x - ball.position.x) / v.x, 0);
  if (v.x > S(0)) offer((room.high.x - ball.position.x) / v.x, 1);
  if (v.y < S(0)) offer((room.low.y - ball.position.y) / v.y, 2);
  if (v.y > S(0)) offer((room.high.y - ball.position.y) / v.y, 3);
  const S speed = dot(v, v);
  for (std::size_t i = 0; i < room.count; ++i) {
    const Pair<S> d = ball.position - room.centres[i];
    const S closing = -dot(d, v);
    if (!(closing > S(0))) continue;
    const S gap = dot(d, d) - room.radius * room.radius;
    const S root = closing * closing - speed * gap;
    if (root > S(0)) offer(gap / (closing + sqrt(root)), walls + i);
  }
  return first;
}

template <class S>
void fly_straight(Ball<S>& ball, const S& time) {
  ball.position = ball.position + time * ball.velocity;
}

/// @return the cosine of the angle between the path and the normal
template <class S>
S reflect(const Room<S>& room, Ball<S>& ball, const Hit<S>& hit) {
  Pair<S>& v = ball.velocity;
  if (!hit.on_post()) {
    S& normal = hit.partner < 2 ? v.x : v.y;
    normal = -normal;
    return normal > S(0) ? normal : -normal;
  }
  const Pair<S> d = ball.position - room.centres[hit.partner - walls];
  const S along = dot(d, v);
  v = v - (S(2) * along / dot(d, d)) * d;
  return -along / norm(d);
}

/// Flies for a time, with all hits on the way.
template <class S>
void fly(const Room<S>& room, Ball<S>& ball, S time) {
  constexpr int enough = 100;  // between two hits of the other ball
  for (int hits = 0; hits < enough; ++hits) {
    const Hit<S> hit = next_hit(room, ball);
    if (hit.time > time) break;
    fly_straight(ball, hit.time);
    reflect(room, ball, hit);
    time = time - hit.time;
  }
  fly_straight(ball, time);
}

template <class S>
Ball<S> start(const Input& input) {
  Ball<S> ball;
  ball.position = {static_cast<S>(input.from[0]), static_cast<S>(input.from[1])};
  const Pair<S> to{static_cast<S>(input.to[0]), static_cast<S>(input.to[1])};
  const Pair<S> aim = to - ball.position;
  ball.velocity = (S(1) / norm(aim)) * aim;
  return ball;
}

/// The twin, displaced perpendicular to the path, m, or rotated, rad.
template <class S>
Ball<S> twin_of(const Input& input, const Ball<S>& ball, const S& error) {
  Ball<S> twin = ball;
  const Pair<S> left{-ball.velocity.y, ball.velocity.x};
  Pair<S>& changed = input.rotated ? twin.velocity : twin.position;
  changed = changed + error * left;
  return twin;
}

// ---------------------------------------------------------------- two runs

/// Both fly until the last hit of the first. They begin as far apart as rounding has left them.
template <class S>
Answer two_runs(const Input& input, Ball<S> ball, Ball<S> twin) {
  const Room<S> room(input);
  const S before =
      norm(input.rotated ? ball.velocity - twin.velocity : ball.position - twin.position);
  for (int i = 0; i < input.hits; ++i) {
    const Hit<S> hit = next_hit(room, ball);
    fly_straight(ball, hit.time);
    reflect(room, ball, hit);
    fly(room, twin, hit.time);
  }
  return {std::log10(as_double(norm(ball.position - twin.position) / before))};
}

template <class S>
Answer two_runs(const Input& input, double error) {
  const auto ball = start<S>(input);
  return two_runs(input, ball, twin_of(input, ball, static_cast<S>(error)));
}

/// The truth: rounding errors of 2⁻¹⁰⁴, and a twin that is 2⁻⁸⁶ away, so that up to 20 digits of
/// growth leave the distance small, and known to five digits.
Answer in_double_double(const Input& input) { return two_runs<DoubleDouble>(input, 0x1p-86); }

/// As in the chapter's example: one coordinate is the next number, here the one that is more
/// perpendicular to the path.
Answer an_ulp_apart(const Input& input) {
  const auto ball = start<double>(input);
  Ball<double> twin = ball;
  const bool sideways = std::abs(ball.velocity.x) < std::abs(ball.velocity.y);
  Pair<double>& changed = input.rotated ? twin.velocity : twin.position;
  double& moved = sideways ? changed.x : changed.y;
  moved = std::nextafter(moved, 1e9);
  return two_runs(input, ball, twin);
}

/// Halfway to each hit the twin's differences are multiplied by a number, so that it is again as
/// near as at the start; the answer adds up the logarithms.
Answer brought_back(const Input& input, double error) {
  const Room<double> room(input);
  auto ball = start<double>(input);
  auto twin = twin_of(input, ball, error);
  double digits = 0;
  const auto distance = [&ball, &twin] { return norm(twin.position - ball.position); };
  for (int i = 0; i < input.hits; ++i) {
    const Hit<double> hit = next_hit(room, ball);
    const double half = hit.time / 2;
    fly_straight(ball, half);
    fly(room, twin, half);
    const double back = error / distance();
    twin.position = ball.position + back * (twin.position - ball.position);
    twin.velocity = ball.velocity + back * (twin.velocity - ball.velocity);
    digits -= std::log10(back);
    fly_straight(ball, half);
    reflect(room, ball, hit);
    fly(room, twin, half);
  }
  return {digits + std::log10(distance() / error)};
}

// ---------------------------------------------------------------- formulas

/// Tells of each hit of the ball: the flight before it, whether it is on a post, and the cosine.
template <class S, class Tell>
void for_each_hit(const Input& input, Tell tell) {
  const Room<S> room(input);
  auto ball = start<S>(input);
  for (int i = 0; i < input.hits; ++i) {
    const Hit<S> hit = next_hit(room, ball);
    fly_straight(ball, hit.time);
    const S cosine = reflect(room, ball, hit);
    tell(hit.time, hit.on_post(), cosine);
  }
}

/// To first order, and without approximation: the distance grows by angle · ℓ in each flight, and
/// the angle by 2 distance/(r cos θ) at each hit on a post. Flat walls change neither.
template <class S>
Answer linear_map(const Input& input) {
  const S radius(static_cast<S>(sum_of_radii(input)));
  S distance(input.rotated ? 0 : 1);
  S angle(input.rotated ? 1 : 0);
  for_each_hit<S>(input, [&](const S& flight, bool on_post, const S& cosine) {
    distance = distance + angle * flight;
    if (on_post) angle = angle + S(2) * distance / (radius * cosine);
  });
  return {std::log10(as_double(distance))};
}

/// A factor of 1 + 2ℓ/r from each post to the next, or 1 + 2ℓ/(r cos θ).
template <bool oblique>
Answer lens_formula(const Input& input) {
  double factor = 1;
  double way = 0;  // from the last post
  double radius = std::numeric_limits<double>::infinity();
  for_each_hit<double>(input, [&](double flight, bool on_post, double cosine) {
    way += flight;
    if (!on_post) return;
    factor *= 1 + 2 * way / radius;
    way = 0;
    radius = sum_of_radii(input) * (oblique ? cosine : 1);
  });
  return {std::log10(factor * (1 + 2 * way / radius))};
}

/// Before the run: the mean flight between posts and the share of the posts among all hits are
/// those of a billiard whose paths fill the room evenly.
/// @param spread 2, or 4 as the planner has it
Answer with_mean_flight(const Input& input, double spread) {
  if (!(input.post > 0)) return {0};
  const double radius = sum_of_radii(input);
  const double across = four_posts::width - 2 * ball_radius;
  const double up = four_posts::height - 2 * ball_radius;
  const double round = 2 * std::numbers::pi * radius * posts.size();
  const double area = across * up - round * radius / 2;
  const double flight = std::numbers::pi * area / round;
  const double on_posts = input.hits * round / (round + 2 * (across + up));
  return {on_posts * std::log10(1 + spread * flight / radius)};
}

// ---------------------------------------------------------------- inputs

/// Rounded to a 65,536th, so that a float holds it.
double short_number(double x) { return std::nearbyint(x * 0x1p16) * 0x1p-16; }

double distance_of(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return norm(Pair<double>{a[0] - b[0], a[1] - b[1]});
}

/// A ball that overlaps no post, aimed at any point of the room.
Input billiard(generators::Random& random, double post, int hits) {
  Input input{{}, {}, post, hits, false};
  const auto any_point = [&random] {
    const double x = random.uniform(0.15, four_posts::width - 0.15);
    const double y = random.uniform(0.15, four_posts::height - 0.15);
    return std::array<double, 2>{short_number(x), short_number(y)};
  };
  const auto overlaps = [&input] {
    if (!(input.post > 0)) return false;
    return std::any_of(posts.begin(), posts.end(), [&input](const std::array<double, 2>& each) {
      return distance_of(input.from, each) < 1.05 * sum_of_radii(input);
    });
  };
  do {
    input.from = any_point();
  } while (overlaps());
  do {
    input.to = any_point();
  } while (distance_of(input.from, input.to) < 0.5);
  return input;
}

/// A whole number of centimetres.
double any_post(generators::Random& random) { return random.integer(5, 40) / 100.0; }

/// The first hit is a graze, with a cosine from 2⁻²⁰ to 2⁻³.
Input grazing(generators::Random& random, int hits) {
  for (;;) {
    Input input = billiard(random, any_post(random), hits);
    const auto which = static_cast<std::size_t>(random.integer(0, 3));
    const double cosine = std::abs(random.magnitude(-20, -4));
    const double far = distance_of(input.from, posts[which]);
    const double offset = sum_of_radii(input) * std::sqrt(1 - cosine * cosine);
    const double along = std::sqrt(far * far - offset * offset);
    // To the point of the path that is nearest to the post's centre.
    const double x = (posts[which][0] - input.from[0]) / far;
    const double y = (posts[which][1] - input.from[1]) / far;
    input.to = {input.from[0] + along * (x * along - y * offset) / far,
                input.from[1] + along * (y * along + x * offset) / far};
    const Room<double> room(input);
    if (next_hit(room, start<double>(input)).partner == walls + which) return input;
  }
}

ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  const double error = std::abs(got.digits - right.digits);
  verdict.wrong = !(error <= half_a_digit);
  if (std::isfinite(error)) verdict.error = error;
  return verdict;
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  ladder::Example example;
  example.facts = {
      ladder::numbers("the ball's centre, m", input.from), ladder::numbers("aimed at, m", input.to),
      ladder::number("radius of the posts, m", input.post), ladder::number("hits", input.hits)};
  int on_posts = 0;
  double least = 1;
  for_each_hit<double>(input, [&](double, bool on_post, double cosine) {
    if (!on_post) return;
    ++on_posts;
    least = std::min(least, cosine);
  });
  example.facts.push_back(ladder::number("on posts", on_posts));
  if (on_posts > 0) example.facts.push_back(ladder::number("least cosine there", least));
  if (std::isfinite(got.digits))
    example.facts.push_back(ladder::number("digits by this method", got.digits));
  else
    example.facts.push_back({"digits by this method", "none: both are at the same point"});
  example.facts.push_back(ladder::number("digits, exact", right.digits));
  if (!(input.post > 0)) {
    example.note = "No figure: its room always has posts.";
    return example;
  }
  const double digits = method.id == "twin-far" ? 6 : method.id == "twin-float" ? 7 : 15;
  example.figure = "divergence";
  example.fields = {ladder::field("from", input.from),
                    ladder::field("to", input.to),
                    {"digits", {digits}},
                    {"post", {input.post}},
                    {"shown", {static_cast<double>(input.hits)}}};
  example.note =
      "The figure moves the twin to the right, not perpendicular to the path, and computes in "
      "double.";
  return example;
}

std::vector<Input> fewer_hits(const Input& input) {
  if (input.hits == 1) return {};
  Input simpler = input;
  --simpler.hits;
  return {simpler};
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("By how many digits has a small error grown?",
                                       in_double_double, judge);
  ladder.family("posts-10", "ball among posts, 10 hits: digits",
                [](generators::Random& random) { return billiard(random, any_post(random), 10); });
  ladder.family("posts-30", "ball among posts, 30 hits: digits",
                [](generators::Random& random) { return billiard(random, any_post(random), 30); });
  ladder.family("grazing", "the first of 10 hits grazes a post: digits",
                [](generators::Random& random) { return grazing(random, 10); });
  ladder.family("walls", "flat walls alone, direction in error, 30 hits: digits",
                [](generators::Random& random) {
                  Input input = billiard(random, 0, 30);
                  input.rotated = true;
                  return input;
                });

  const auto inexact = [&ladder](const char* id, const char* title, const char* scalar, auto call) {
    ladder.method({.id = id, .title = title, .scalar = scalar, .exact = false}, call);
  };
  inexact("mean-2", "1 + 2ℓ/r with the mean flight, before the run", "double",
          [](const Input& input) { return with_mean_flight(input, 2); });
  inexact("mean-4", "1 + 4ℓ/r with the mean flight, before the run", "double",
          [](const Input& input) { return with_mean_flight(input, 4); });
  inexact("lens", "1 + 2ℓ/r with each flight", "double", lens_formula<false>);
  inexact("oblique", "1 + 2ℓ/(r cos θ) with each flight", "double", lens_formula<true>);
  inexact("map", "distance and angle from hit to hit", "double", linear_map<double>);
  ladder.method({.id = "map-wide",
                 .title = "distance and angle from hit to hit",
                 .scalar = "double-double",
                 .exact = true},
                linear_map<DoubleDouble>);
  inexact("twin-float", "a twin 10⁻⁶ away", "float",
          [](const Input& input) { return two_runs<float>(input, 1e-6); });
  inexact("twin-far", "a twin 10⁻⁶ away", "double",
          [](const Input& input) { return two_runs<double>(input, 1e-6); });
  inexact("twin-ulp", "a twin one ulp away", "double", an_ulp_apart);
  inexact("twin-back", "a twin 10⁻⁸ away, brought back before each hit", "double",
          [](const Input& input) { return brought_back(input, 1e-8); });
  ladder.recommend("map");
  ladder.show(shown);
  ladder.simplify(fewer_hits);
  return ladder;
}

}  // namespace

LADDER(experiment)
