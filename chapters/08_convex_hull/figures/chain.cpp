// The hull of eight points in the plane, by a chain that is built step by step.
#include <algorithm>
#include <array>
#include <contact/figure.hpp>
#include <contact/hull_2d.hpp>
#include <vector>

using Point = contact::Vector2<double>;

struct Input {
  Point p0, p1, p2, p3, p4, p5, p6, p7;
  double step;  // how many of the turns that are asked have been asked
};

constexpr int count = 8;

struct Output {
  double problem;
  double steps;                         // turns asked in all
  double corners;                       // of the finished hull
  std::array<double, count> hull;       // their indices, then -1
  double length;                        // of the chain after `step` turns
  std::array<double, 2 * count> chain;  // its indices, then -1
  std::array<double, 3> asked;          // the three points of the last turn, or -1
  double turn;                          // its sign
  double all_corners;                   // goal of a question: every point is a corner
};

Output compute(const Input& in) {
  Output out{};
  const std::vector<Point> points{in.p0, in.p1, in.p2, in.p3, in.p4, in.p5, in.p6, in.p7};
  out.hull.fill(-1);
  out.chain.fill(-1);
  out.asked.fill(-1);
  for (const Point& p : points) {
    if (p.cwiseAbs().maxCoeff() > 1e100) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;

  // The chain as it stands is what has been asked about and not been taken off: it is told by
  // following the questions.
  std::vector<std::array<int, 3>> questions;
  const std::vector<int> hull = contact::monotone_chain(points, [&](int i, int j, int k) {
    questions.push_back({i, j, k});
    const auto at = [&points](int index) { return points[static_cast<std::size_t>(index)]; };
    return contact::side_of_line(at(i), at(j), at(k));
  });
  out.steps = static_cast<double>(questions.size());
  out.corners = static_cast<double>(hull.size());
  for (std::size_t i = 0; i < hull.size(); ++i) out.hull[i] = hull[i];

  const auto shown = static_cast<std::size_t>(std::clamp(in.step, 0.0, out.steps));
  std::vector<int> lower, chain;
  bool back = false;
  for (std::size_t q = 0; q < shown; ++q) {
    const auto [i, j, k] = questions[q];
    const Point& second = points[static_cast<std::size_t>(j)];
    const Point& third = points[static_cast<std::size_t>(k)];
    const bool leftwards =
        third.x() < second.x() || (third.x() == second.x() && third.y() < second.y());
    if (leftwards && !back) lower.swap(chain);  // the way back is a chain of its own
    back = leftwards;
    // The question is about the last two of the chain, so cut it back to these.
    while (!chain.empty() && chain.back() != j) chain.pop_back();
    if (chain.size() < 2 || chain[chain.size() - 2] != i) {
      if (!chain.empty()) chain.pop_back();
      if (chain.empty() || chain.back() != i) chain.push_back(i);
      chain.push_back(j);
    }
    const auto at = [&points](int index) { return points[static_cast<std::size_t>(index)]; };
    const int turn = contact::side_of_line(at(i), at(j), at(k));
    if (turn <= 0) chain.pop_back();
    if (turn > 0 || q + 1 == questions.size() || questions[q + 1][2] != k) chain.push_back(k);
    out.asked = {double(i), double(j), double(k)};
    out.turn = turn;
  }
  if (!chain.empty() && !lower.empty() && lower.back() == chain.front()) lower.pop_back();
  chain.insert(chain.begin(), lower.begin(), lower.end());
  if (shown == questions.size() && !questions.empty()) {
    chain = hull;
    chain.push_back(hull[0]);
  }
  out.length = static_cast<double>(std::min<std::size_t>(chain.size(), out.chain.size()));
  for (std::size_t i = 0; i < chain.size() && i < out.chain.size(); ++i) out.chain[i] = chain[i];

  out.all_corners = hull.size() == count ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(p0, p1, p2, p3, p4, p5, p6, p7, step), Output,
       FIELDS(problem, steps, corners, hull, length, chain, asked, turn, all_corners))
