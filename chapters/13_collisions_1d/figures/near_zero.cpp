// A body of about e kilograms hits one of 1 kg at rest, and nearly stops: its velocity in single
// precision and without rounding, at growing magnification.
#include <contact/collision_1d.hpp>
#include <contact/figure.hpp>
#include <contact/tolerance.hpp>

struct Input {
  double zoom;      // the window is 2^-zoom wide to either side of m_1 = e
  double position;  // of the mass of the reading, from -1 to 1 in the window
  double e;         // coefficient of restitution
};

struct Output {
  double problem;
  std::array<double, 41> mass;     // m₁ as stored, from -1 to 1 in the window
  std::array<double, 41> exact;    // v₁' in units of 2^-zoom m/s
  std::array<double, 41> rounded;  // as computed in float
  double bound;                    // γ(8) (|v₁| + |v₂|) in the same units
  double m_1;                      // read off, kg
  double v_exact, v_rounded;       // m/s
  double relative;                 // error of v_rounded relative to v_exact; 0 if both are 0
  double absolute;                 // and in units of u (|v₁| + |v₂|)
  double read_x, read_y;           // its position in the picture
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.e >= 0.1) || in.zoom < 2) out.problem = contact::figure::too_small;
  if (in.e > 0.9 || in.zoom > 23 || std::abs(in.position) > 1) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;
  const double width = std::ldexp(1.0, -static_cast<int>(in.zoom));
  const auto e = static_cast<float>(in.e);
  if (!(double{e} > width * 0.5))
    out.problem = contact::figure::too_large;  // a mass would be negative
  if (out.problem != 0) return out;
  const auto resting = contact::line_body(1.0f, 0.0f);
  const auto at = [&](double position, auto&& tell) {
    const auto m = static_cast<float>(double{e} + position * width * 0.5);
    const auto hitting = contact::line_body(m, 1.0f);
    tell(m, double{contact::collide_exactly(hitting, resting, e).first},
         double{contact::collide(hitting, resting, e).first});
  };
  for (std::size_t i = 0; i < out.mass.size(); ++i) {
    at((static_cast<double>(i) - 20) / 20, [&](float m, double exact, double rounded) {
      out.mass[i] = (double{m} - double{e}) / (width * 0.5);
      out.exact[i] = exact / width;
      out.rounded[i] = rounded / width;
    });
  }
  out.bound = double{contact::tolerance::gamma<float>(8)} / width;
  at(in.position, [&](float m, double exact, double rounded) {
    out.m_1 = m;
    out.v_exact = exact;
    out.v_rounded = rounded;
    const double off = std::abs(rounded - exact);
    out.relative = off == 0 ? 0 : off / std::abs(exact);
    out.absolute = off / double{contact::tolerance::unit_roundoff<float>};
    out.read_x = (double{m} - double{e}) / (width * 0.5);
    out.read_y = rounded / width;
  });
  return out;
}

FIGURE(Input, FIELDS(zoom, position, e), Output,
       FIELDS(problem, mass, exact, rounded, bound, m_1, v_exact, v_rounded, relative, absolute,
              read_x, read_y))
