// Points in a tiny square on the line y = x: on which side of it does each way of computing put
// them?
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/products.hpp>

inline constexpr int cells = 17;

struct Input {
  double zoom;    // from point to point it is 2^-zoom
  double method;  // 0: products of the coordinates; 1: differences first; 2: without rounding
};

struct Output {
  double problem;
  std::array<double, cells * cells> side;  // row by row from below, as the method says: -1, 0, 1
  std::array<double, cells * cells> wrong;
  double spacing;  // of the points
  double wrong_expanded, wrong_by_differences, wrong_exactly;  // of 289
};

using Point = contact::Vector2<double>;

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

Output compute(const Input& in) {
  Output out{};
  if (in.zoom > 53) out.problem = contact::figure::too_small;
  if (in.zoom < 0) out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  const Point a(12, 12);
  const Point b(24, 24);
  const double step = std::ldexp(1.0, -static_cast<int>(in.zoom));
  out.spacing = step;
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      // Exact: from 1/2 to 1 the doubles are 2^-53 apart.
      const Point p(0.5 + column * step, 0.5 + row * step);
      const double truth = contact::line_side_exactly(a, b, p);
      const std::array said{sign(contact::line_side_expanded(a, b, p)),
                            sign(contact::line_side_by_differences(a, b, p)), truth};
      out.wrong_expanded += said[0] != truth;
      out.wrong_by_differences += said[1] != truth;
      const double chosen = in.method < 0.5 ? said[0] : in.method < 1.5 ? said[1] : said[2];
      const auto i = static_cast<std::size_t>(row * cells + column);
      out.side[i] = chosen;
      out.wrong[i] = chosen != truth ? 1 : 0;
    }
  }
  return out;
}

FIGURE(Input, FIELDS(zoom, method), Output,
       FIELDS(problem, side, wrong, spacing, wrong_expanded, wrong_by_differences, wrong_exactly))
