// The hull of eight points in the plane by the monotone chain, step by step.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/arc.hpp>
#include <contact/exact.hpp>
#include <contact/figure.hpp>
#include <contact/hull_2d.hpp>
#include <vector>

using Point = contact::Vector2<double>;

struct Input {
  Point p0, p1, p2, p3, p4, p5, p6, p7;
  double step;    // how many orientation tests are shown
  double method;  // 0 exact, 1 float, 2 double, 3 double with an epsilon of 1e-6, 4 sorted by
                  // angle, with exact orientation
  double flat;    // k: flattened to 10^-k of their heights, onto a sloping line; 0: as they are
};

constexpr int count = 8;

struct Output {
  double problem;
  double steps;                            // orientation tests in all
  double corners;                          // of the finished chain
  std::array<double, 2 * count> hull;      // their indices, then -1
  double length;                           // of the chain after `step` tests
  std::array<double, 2 * count> chain;     // its indices, then -1
  std::array<double, 3> asked;             // the three points of the last test, or -1
  double orientation;                      // its sign
  double all_vertices;                     // goal of a question: every point is a vertex
  double true_vertices;                    // of the exact hull
  std::array<double, count> true_hull;     // their indices, then -1
  double found;                            // vertices of the exact hull that the method has
  std::array<double, count> lost;          // 1 for those that it lacks
  double wrong_turns;                      // tests whose sign differs from the exact one
  std::array<double, 2 * count> position;  // positions as stored, with the heights stretched back
};

namespace {

constexpr double slope = 0.8;

double power_of_ten(double k) {
  double power = 1;
  for (; k > 0; --k) power *= 10;
  return power;
}

/// The height of a stored point above the sloping line, times the power.
double drawn_up(const Point& p, double power) {
  using contact::Exact;
  return quotient<double>((Exact(p.y()) - Exact(slope) * Exact(p.x())) * Exact(power), Exact(1.0));
}

/// The points as a method reads them, its vertices, and its orientation tests.
struct Chain {
  std::vector<Point> read;
  std::vector<int> corners;
  std::vector<std::array<int, 3>> questions;
  std::vector<int> answers;
};

template <class Orientation>
Chain chain_by(const std::vector<Point>& read, const Orientation& orientation) {
  Chain chain{read, {}, {}, {}};
  chain.corners = contact::monotone_chain(read, [&](int i, int j, int k) {
    const auto at = [&read](int index) { return read[static_cast<std::size_t>(index)]; };
    chain.questions.push_back({i, j, k});
    chain.answers.push_back(orientation(at(i), at(j), at(k)));
    return chain.answers.back();
  });
  return chain;
}

/// With points and orientation rounded to S.
template <class S>
Chain rounded_chain(const std::vector<Point>& points, double epsilon) {
  std::vector<Point> read;
  for (const Point& p : points) read.push_back(p.cast<S>().template cast<double>());
  return chain_by(read, [epsilon](const Point& a, const Point& b, const Point& c) {
    const double area = contact::orientation<S>(a.cast<S>(), b.cast<S>(), c.cast<S>());
    return area > epsilon ? 1 : (area < -epsilon ? -1 : 0);
  });
}

// WRONG: different directions may get the same rounded angle, and points collinear with the lowest
// point have the same angle exactly. Their order is then arbitrary, and a vertex may be removed by
// a point that should come before it, although every orientation is exact.
Chain chain_by_angles(const std::vector<Point>& points) {
  Chain chain{points, {}, {}, {}};
  const auto at = [&points](int i) { return points[static_cast<std::size_t>(i)]; };
  int lowest = 0;
  for (int i = 1; i < count; ++i) {
    const Point step = at(i) - at(lowest);
    if (at(i).y() < at(lowest).y() || (step.y() == 0 && step.x() < 0)) lowest = i;
  }
  std::array<double, count> angle{};
  std::vector<int> order{lowest};
  for (int i = 0; i < count; ++i) {
    const Point from = at(i) - at(lowest);
    angle[static_cast<std::size_t>(i)] = contact::portable_angle(from.y(), from.x());
    if (i != lowest) order.push_back(i);
  }
  std::stable_sort(order.begin() + 1, order.end(), [&angle](int i, int j) {
    return angle[static_cast<std::size_t>(i)] < angle[static_cast<std::size_t>(j)];
  });
  std::vector<int>& hull = chain.corners;
  for (const int k : order) {
    while (hull.size() >= 2) {
      const int i = hull[hull.size() - 2], j = hull.back();
      chain.questions.push_back({i, j, k});
      chain.answers.push_back(contact::orient_2d(at(i), at(j), at(k)));
      if (chain.answers.back() > 0) break;
      hull.pop_back();
    }
    hull.push_back(k);
  }
  return chain;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  std::vector<Point> points{in.p0, in.p1, in.p2, in.p3, in.p4, in.p5, in.p6, in.p7};
  out.hull.fill(-1);
  out.true_hull.fill(-1);
  out.chain.fill(-1);
  out.asked.fill(-1);
  for (const Point& p : points) {
    if (p.cwiseAbs().maxCoeff() > 1e100) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;

  const double flat = in.flat > 0 ? std::min(std::round(in.flat), 16.0) : 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point& p = points[i];
    Point drawn = p;
    if (flat > 0) {
      p.y() = slope * p.x() + p.y() / power_of_ten(flat);
      drawn.y() = drawn_up(p, power_of_ten(flat));
    }
    out.position[2 * i] = drawn.x();
    out.position[2 * i + 1] = drawn.y();
  }

  const std::vector<int> exact = contact::convex_hull_2d(points);
  const Chain asked = in.method == 1   ? rounded_chain<float>(points, 0)
                      : in.method == 2 ? rounded_chain<double>(points, 0)
                      : in.method == 3 ? rounded_chain<double>(points, 1e-6)
                      : in.method == 4 ? chain_by_angles(points)
                                       : chain_by(points, contact::orient_2d);
  const std::vector<int>& hull = asked.corners;
  const auto& questions = asked.questions;
  out.steps = static_cast<double>(questions.size());
  out.corners = static_cast<double>(hull.size());
  for (std::size_t i = 0; i < hull.size() && i < out.hull.size(); ++i) out.hull[i] = hull[i];
  out.true_vertices = static_cast<double>(exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    out.true_hull[i] = exact[i];
    const bool has = std::find(hull.begin(), hull.end(), exact[i]) != hull.end();
    (has ? out.found : out.lost[static_cast<std::size_t>(exact[i])]) += 1;
  }
  for (std::size_t q = 0; q < questions.size(); ++q) {
    const auto at = [&](std::size_t k) {
      return points[static_cast<std::size_t>(questions[q][k])];
    };
    out.wrong_turns += contact::orient_2d(at(0), at(1), at(2)) != asked.answers[q];
  }

  // The chain after `step` tests consists of the points tested and not removed: replay the tests.
  const auto shown = static_cast<std::size_t>(std::clamp(in.step, 0.0, out.steps));
  std::vector<int> lower, chain;
  bool back = false;
  for (std::size_t q = 0; q < shown; ++q) {
    const auto [i, j, k] = questions[q];
    const Point& second = asked.read[static_cast<std::size_t>(j)];
    const Point& third = asked.read[static_cast<std::size_t>(k)];
    const bool leftwards =
        third.x() < second.x() || (third.x() == second.x() && third.y() < second.y());
    // The pass from right to left is a chain of its own; sorted by angle there is one pass.
    if (leftwards && !back && in.method != 4) lower.swap(chain);
    back = leftwards;
    // A test is about the last two points of the chain, so cut it back to these.
    while (!chain.empty() && chain.back() != j) chain.pop_back();
    if (chain.size() < 2 || chain[chain.size() - 2] != i) {
      if (!chain.empty()) chain.pop_back();
      if (chain.empty() || chain.back() != i) chain.push_back(i);
      chain.push_back(j);
    }
    const int orientation = asked.answers[q];
    if (orientation <= 0) chain.pop_back();
    if (orientation > 0 || q + 1 == questions.size() || questions[q + 1][2] != k)
      chain.push_back(k);
    out.asked = {double(i), double(j), double(k)};
    out.orientation = orientation;
  }
  if (!chain.empty() && !lower.empty() && lower.back() == chain.front()) lower.pop_back();
  chain.insert(chain.begin(), lower.begin(), lower.end());
  if (shown == questions.size() && !questions.empty()) {
    chain = hull;
    chain.push_back(hull[0]);
  }
  out.length = static_cast<double>(std::min<std::size_t>(chain.size(), out.chain.size()));
  for (std::size_t i = 0; i < chain.size() && i < out.chain.size(); ++i) out.chain[i] = chain[i];

  out.all_vertices = exact.size() == count ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(p0, p1, p2, p3, p4, p5, p6, p7, step, method, flat), Output,
       FIELDS(problem, steps, corners, hull, length, chain, asked, orientation, all_vertices,
              true_vertices, true_hull, found, lost, wrong_turns, position))
