// A square of points a millimetre apart, far from the origin: on which side of a line does each
// method put them?
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/orientation.hpp>

inline constexpr int cells = 17;

struct Input {
  double far;     // the square is about 2^far metres from the origin
  double method;  // 0: products first; 1: differences first; 2: differences first, stored in float
};

struct Output {
  double problem;
  std::array<double, cells * cells> side;  // row by row from below, by the method: -1, 0, 1
  std::array<double, cells * cells> wrong;
  double distance;                                              // m
  double wrong_expanded, wrong_by_differences, wrong_in_float;  // of 289
};

using Point = contact::Vector2<double>;

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

Output compute(const Input& in) {
  Output out{};
  if (in.far > 42.4) out.problem = contact::figure::too_large;
  if (in.far < 0) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;
  // All coordinates are whole multiples of 2^-10 m below 2^43 m: a double holds them.
  const double step = std::ldexp(1.0, -10);
  const double x = std::ldexp(1.0, static_cast<int>(std::round(in.far)));
  const double y = step * std::floor(0.6 * x / step);
  out.distance = x;
  const Point a(x, y);
  const Point b(x + 4, y + 4);
  const auto narrow = [](const Point& p) { return contact::Vector2<float>(p.cast<float>()); };
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const Point p(x + 1 + column * step, y + 1 + row * step);
      const double truth = contact::orient_2d_exactly(a, b, p);
      const std::array said{sign(contact::orientation_expanded(a, b, p)),
                            sign(contact::orientation(a, b, p)),
                            sign(double(contact::orientation(narrow(a), narrow(b), narrow(p))))};
      out.wrong_expanded += said[0] != truth;
      out.wrong_by_differences += said[1] != truth;
      out.wrong_in_float += said[2] != truth;
      const double chosen = in.method < 0.5 ? said[0] : in.method < 1.5 ? said[1] : said[2];
      const auto i = static_cast<std::size_t>(row * cells + column);
      out.side[i] = chosen;
      out.wrong[i] = chosen != truth ? 1 : 0;
    }
  }
  return out;
}

FIGURE(Input, FIELDS(far, method), Output,
       FIELDS(problem, side, wrong, distance, wrong_expanded, wrong_by_differences, wrong_in_float))
