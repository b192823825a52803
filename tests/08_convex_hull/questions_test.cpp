#include "support/questions.hpp"

#include <algorithm>
#include <array>
#include <contact/arc.hpp>
#include <contact/convex_hull.hpp>
#include <contact/gift_wrapping.hpp>
#include <contact/hull_2d.hpp>
#include <functional>
#include <set>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace chain {
#include "figures/chain.cpp"
}
namespace horizon {
#include "figures/horizon.cpp"
}

namespace questions_test {

using Flat = contact::Vector2<double>;
using Solid = contact::Vector3<double>;

KEY("turn-area") { return contact::orientation<double>({1, 1}, {4, 2}, {2, 5}); }

KEY("grid-border") {
  std::vector<Flat> grid;
  for (int i = 0; i < 25; ++i) grid.push_back({double(i % 5), double(i / 5)});
  return static_cast<double>(contact::convex_hull_2d(grid).size());
}

KEY("all-quadrilaterals") {
  // The rhombic dodecahedron.
  std::vector<Solid> points;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      points.push_back({x, y, -1});
      points.push_back({x, y, 1});
    }
    points.push_back({2 * x, 0, 0});
    points.push_back({0, 2 * x, 0});
    points.push_back({0, 0, 2 * x});
  }
  const contact::Hull hull = contact::convex_hull(points);
  return hull.vertices.size() == 14 ? static_cast<double>(hull.face_count()) : -1.0;
}

KEY("wrapping-a-sphere") {
  const double n = 1000;
  return (2 * n - 4) * n;
}

KEY("highest-corner") {
  // Points of a top edge and a top face: which rule always finds a vertex?
  std::vector<Solid> points{{1, 1, 5}, {0, 0, 5}, {3, 0, 5}, {0, 3, 5},
                            {3, 3, 5}, {3, 1, 5}, {1, 2, 0}};
  const auto vertex = [&](const Solid& p) {
    for (const int v : contact::convex_hull(points).vertices) {
      if (points[static_cast<std::size_t>(v)] == p) return true;
    }
    return false;
  };
  const bool first = vertex(points[0]);
  Solid best = points[0];
  for (const Solid& p : points) {
    if (std::array{best.z(), best.x(), best.y()} < std::array{p.z(), p.x(), p.y()}) best = p;
  }
  return !first && vertex(best) ? 2 : 1;
}

KEY("what-dies") {
  // A pyramid on its apex; the point is on the line of the diagonal that splits the square.
  const std::vector<Solid> points{{0, 0, 0}, {2, 0, 0},  {2, 2, 0},
                                  {0, 2, 0}, {1, 1, -2}, {4, 4, 0}};
  const int p = 5;
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 2, 3}, {0, 4, 1},
                                                  {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  const contact::ExactSides sides(points);
  const auto breaks = [&](const std::function<bool(int side, std::size_t triangle)>& removed) {
    std::set<std::pair<int, int>> edges;  // of removed triangles
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& [a, b, c] = triangles[i];
      if (!removed(sides.side(sides.plane(a, b, c), a, b, c, p), i)) continue;
      edges.insert({{a, b}, {b, c}, {c, a}});
    }
    return std::any_of(edges.begin(), edges.end(), [&](const std::pair<int, int>& edge) {
      const bool horizon = edges.count({edge.second, edge.first}) == 0;
      const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
      return horizon && (at(edge.second) - at(edge.first)).cross(at(p) - at(edge.first)).isZero(0);
    });
  };
  const std::array<bool, 3> broken{
      breaks([](int side, std::size_t) { return side >= 0; }),
      breaks([](int side, std::size_t) { return side > 0; }),
      breaks([](int side, std::size_t i) { return side > 0 || (side == 0 && i == 0); })};
  return broken == std::array<bool, 3>{false, false, true} ? 2 : -1;
}

KEY("adding-a-point") {
  // The steps that must come before each step.
  const std::vector<std::set<int>> needs{{4}, {}, {0}, {1}, {3}};
  std::vector<int> order;
  std::set<int> done;
  while (order.size() < needs.size()) {
    std::vector<int> possible;
    for (int i = 0; i < static_cast<int>(needs.size()); ++i) {
      const auto& before = needs[static_cast<std::size_t>(i)];
      if (done.count(i) == 0 &&
          std::includes(done.begin(), done.end(), before.begin(), before.end())) {
        possible.push_back(i);
      }
    }
    if (possible.size() != 1) return std::vector<int>{};
    order.push_back(possible.front());
    done.insert(possible.front());
  }
  return order;
}

KEY("epsilon-chain") {
  // An arch of a hundred points: each is near the line of its neighbours, and the middle is far
  // from the chord.
  double sag_of_neighbours = 0;
  const double n = 100, height = 0.5;
  const auto arch = [&](double i) { return height * (1 - (2 * i / n - 1) * (2 * i / n - 1)); };
  sag_of_neighbours = arch(50) - (arch(49) + arch(51)) / 2;
  return height > 10 * sag_of_neighbours ? 2 : 0;
}

KEY("all-corners") {
  chain::Input state{{-4, 0}, {-3, -2}, {0, -3}, {3, -2}, {4, 0}, {3, 2}, {0, 3}, {-3, 2}, 0, 0, 0};
  const double winning = chain::compute(state).all_vertices;
  state.p1 = {-2, -1.5};  // on the segment between its neighbours
  return questions::Construct{winning, chain::compute(state).all_vertices};
}

KEY("sees-eight") {
  horizon::Input state{{3.5, -2, 2.5}, 0};
  const double winning = horizon::compute(state).sees_many;
  state.p = {0.9, 0.4, 0.4};
  return questions::Construct{winning, horizon::compute(state).sees_many};
}

KEY("count-by-euler") {
  // Points of the curve (t, t², t³): each is a vertex, and no four are coplanar.
  std::vector<Solid> points;
  for (int i = 0; i < 100; ++i) {
    const double t = (i - 49.5) / 50;
    points.push_back({t, t * t, t * t * t});
  }
  const contact::Hull hull = contact::convex_hull(points);
  const double faces = static_cast<double>(hull.face_count());
  const double edges = static_cast<double>(hull.vertices.size()) + faces - 2;
  return questions::Gaps{{"edges-per-face", edges / faces}, {"faces", faces}, {"edges", edges}};
}

KEY("why-epsilon-fails") {
  // The middle of an arch of n points against a line: far from the chord of the ends, near that of
  // its neighbours.
  const auto arch = [](double i, double n) {
    return 0.5 * (1 - (2 * i / n - 1) * (2 * i / n - 1));
  };
  const auto far_from_chord = [&](double n) {
    const double near = arch(n / 2, n) - arch(n / 2 - 1, n);
    return arch(n / 2, n) - arch(0, n) > 10 * near;
  };
  return questions::Claim{far_from_chord(100), far_from_chord(2)};
}

TEST_CASE("the chain loses vertices where the figure's caption says so") {
  chain::Input state{{-4, -1}, {-3, 2}, {-2, -2.5}, {-1, 0.5}, {1, -1}, {2, 3},
                     {3, -2},  {4, 1},  24,         0,         0};
  enum Method { exact, in_float, in_double, epsilon, angles };
  const auto lost = [&state](Method method, double flat) {
    state.method = method;
    state.flat = flat;
    const auto out = chain::compute(state);
    CHECK(out.problem == 0);
    return out.true_vertices - out.found;
  };
  for (int k = 0; k <= 16; ++k) {
    CHECK(lost(exact, k) == 0);
    CHECK((lost(in_float, k) > 0) == (k >= 7));
    CHECK((lost(epsilon, k) > 0) == (k >= 7));
    CHECK((lost(in_double, k) > 0) == (k == 16));
  }
  CHECK(lost(angles, 0) == 0);
  state.p6 = {3, -2.5};
  state.p7 = {0.5, -2.5};
  for (const Method method : {exact, in_float, in_double, epsilon}) CHECK(lost(method, 0) == 0);
  CHECK(lost(angles, 0) == 1);
  const auto out = chain::compute(state);
  CHECK(out.lost[6] == 1);
  CHECK(out.wrong_turns == 0);
}

}  // namespace questions_test
