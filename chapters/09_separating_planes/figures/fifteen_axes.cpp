// Two boxes and their separations along fifteen axes: by the book's code, and by three tests that
// treat short cross products as many programs do.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/box_axes.hpp>
#include <contact/closed_proximity.hpp>
#include <contact/figure.hpp>
#include <contact/oriented_box.hpp>
#include <contact/sine_cosine.hpp>
#include <cstddef>
#include <limits>

using Vector = contact::Vector3<double>;
using Matrix = contact::Matrix3<double>;
using Box = contact::OrientedBox<double>;

struct Input {
  Vector b;               // centre of B; that of A is the origin
  Vector nose_a, nose_b;  // the direction of each box's x axis, of any length
  double roll_a, roll_b;  // rotation about it, degrees
  Vector half_a, half_b;  // half lengths
  double size;            // all lengths are multiplied by it, m
  double method;          // 0 exact, 1 rounded cosines, 2 short cross products skipped, 3 padded
  double epsilon;         // of methods 2, m⁴, and 3
};

constexpr std::size_t axes = 15, methods = 4, corners = 8;

struct Output {
  double problem;
  std::array<Vector, corners> corner_a, corner_b;  // as drawn: not multiplied by the size
  // By the chosen method, along each axis in the order of box_axis(); an axis is skipped if it is 0
  // or the method leaves it out.
  std::array<double, axes> separation;  // m
  std::array<double, axes> skipped;     // 1 or 0
  double skipped_count;
  double largest;     // m
  double axis;        // that has it
  Vector normal, on;  // the plane perpendicular to it halfway between the boxes, as drawn
  std::array<double, axes> length;  // of the cross product of unit vectors: the sine of the angle
  double shortest;                  // of those of edges
  double state;                     // 0 disjoint, 1 touching, 2 overlapping: exact
  std::array<double, methods> apart, wrong;  // what each method says, and 1 if that is false
  double exact_largest;  // the largest separation along an axis that is not 0, m
  double exact_axis;     // that has it
  // For a reader's function: the axes of the boxes; the largest separation, and the first axis that
  // has it up to 1e-9 m; 1 if half lengths are whole numbers up to 1000, the centre is a multiple
  // of 2^-30, and no cross product of edges is between 1e-12 and 1e-2.
  Vector x_a, y_a, z_a, x_b, y_b, z_b;
  double gap, gap_axis, asked;
  // Goals of questions.
  double edges_only;      // disjoint, and along each face normal they overlap by at least 0.25 m
  double skipping_wrong;  // the boxes are disjoint, and method 2 does not say so
  double padding_wrong;   // the boxes are disjoint, and method 3 does not say so
  double rounding_wrong;  // method 1 is wrong
};

namespace {

/// Its x axis points along the nose, its y axis is level before the rotation about the nose.
Matrix rotation(const Vector& nose, double degrees) {
  const auto unit = [](const Vector& v) -> Vector { return v / std::sqrt(v.squaredNorm()); };
  const Vector x = unit(nose / nose.cwiseAbs().maxCoeff());
  const bool vertical = std::abs(x.z()) > 0.999999;
  const Vector y = unit((vertical ? Vector(0, 1, 0) : Vector(-x.y(), x.x(), 0)));
  const Vector side = vertical ? Vector(unit(y - x * x.dot(y))) : y, up = x.cross(side);
  const auto [sine, cosine] = contact::sine_cosine(degrees * 0.017453292519943295);
  Matrix result;
  result.col(0) = x;
  result.col(1) = side * cosine + up * sine;
  result.col(2) = up * cosine - side * sine;
  return result;
}

/// What a method finds along each axis.
struct Found {
  std::array<double, axes> separation{}, skipped{};
  double largest = -std::numeric_limits<double>::infinity();
  std::size_t axis = 0;
  void add(std::size_t k, double separated) {
    separation[k] = separated;
    if (separated > largest) {
      largest = separated;
      axis = k;
    }
  }
};

// [along-all-axes]
/// The book's separations, each divided by the length of its axis.
Found along_all_axes(const Box& a, const Box& b) {
  Found found;
  for (int k = 0; k < contact::box_axis_count; ++k) {
    const Vector n = contact::box_axis<double>(a, b, k);
    const double length = std::sqrt(n.squaredNorm());
    if (length > 0)
      found.add(std::size_t(k), contact::separation_along<double>(a, b, n) / length);
    else
      found.skipped[std::size_t(k)] = 1;
  }
  return found;
}
// [/along-all-axes]

// WRONG: the axes of edges that are nearly parallel are left out, even if one of them is the only
// one that separates the boxes. The cross product is that of half edges, so it is short for small
// boxes whatever the angle.
Found skipping(const Box& a, const Box& b, double shortest) {
  Found found = along_all_axes(a, b), kept;
  for (std::size_t k = 0; k < axes; ++k) {
    bool skipped = found.skipped[k] != 0;
    if (k >= 6) {
      const auto i = static_cast<int>(k - 6) / 3, j = static_cast<int>(k - 6) % 3;
      const Vector u = a.axes.col(i) * a.half_lengths(i), v = b.axes.col(j) * b.half_lengths(j);
      skipped = skipped || u.cross(v).squaredNorm() < shortest;
    }
    if (skipped)
      kept.skipped[k] = 1;
    else
      kept.add(k, found.separation[k]);
  }
  return kept;
}

// WRONG: the cosines of the angles between the axes are rounded. Along the cross product of nearly
// parallel edges all terms are a few u, and what is left of them need not be the separation along
// any direction. A padding of the cosines that exceeds their error covers that, but then disjoint
// boxes are said to meet.
Found by_cosines(const Box& a, const Box& b, double padding) {
  const Matrix cosine = a.axes.transpose() * b.axes;
  const Matrix padded = (cosine.cwiseAbs().array() + padding).matrix();
  const Vector between = b.centre - a.centre;
  const Vector in_a = a.axes.transpose() * between, in_b = b.axes.transpose() * between;
  const Vector &h = a.half_lengths, &g = b.half_lengths;
  Found found;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    found.add(at, std::abs(in_a(i)) - h(i) - padded.row(i).dot(g));
    found.add(at + 3, std::abs(in_b(i)) - g(i) - padded.col(i).dot(h));
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
      const double sine = std::sqrt(cosine(k, j) * cosine(k, j) + cosine(l, j) * cosine(l, j));
      const double distance = std::abs(in_a(l) * cosine(k, j) - in_a(k) * cosine(l, j));
      const double reach =
          h(k) * padded(l, j) + h(l) * padded(k, j) + g(m) * padded(i, n) + g(n) * padded(i, m);
      const auto at = static_cast<std::size_t>(6 + 3 * i + j);
      if (sine > 0)
        found.add(at, (distance - reach) / sine);
      else
        found.skipped[at] = 1;
    }
  }
  return found;
}

/// Whether a reader's function is asked about the boxes, see Output.
bool is_asked(const Input& in, const Output& out) {
  const auto whole = [](const Vector& v) { return v == v.array().round().matrix(); };
  const bool short_or_long = std::all_of(out.length.begin() + 6, out.length.end(),
                                         [](double x) { return x < 1e-12 || x > 1e-2; });
  return in.size == 1 && whole(in.half_a) && whole(in.half_b) && whole(in.b * 0x1p30) &&
         std::max(in.half_a.maxCoeff(), in.half_b.maxCoeff()) <= 1000 &&
         in.b.cwiseAbs().maxCoeff() <= 1000 && short_or_long;
}

/// Answers as a reader's function is to: short cross products are no axes.
void answer_for_reader(const Input& in, const Box& a, const Box& b, const Found& found,
                       Output& out) {
  out.x_a = a.axes.col(0);
  out.y_a = a.axes.col(1);
  out.z_a = a.axes.col(2);
  out.x_b = b.axes.col(0);
  out.y_b = b.axes.col(1);
  out.z_b = b.axes.col(2);
  out.asked = is_asked(in, out) ? 1 : 0;
  out.gap = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < axes; ++k) {
    if (k >= 6 && out.length[k] < 1e-8) continue;
    if (found.separation[k] > out.gap + 1e-9) out.gap_axis = double(k);
    out.gap = std::max(out.gap, found.separation[k]);
  }
}

/// The plane perpendicular to an axis, halfway between the supports of the boxes, in the line from
/// centre to centre if it crosses that.
void draw_plane(const Box& a, const Box& b, int axis, double size, Output& out) {
  const Vector n = contact::box_axis<double>(a, b, axis);
  const double squared = n.squaredNorm();
  if (!(squared > 0)) return;
  const double across = n.dot(b.centre), sign = across < 0 ? -1 : 1;
  const double of_a = contact::projected_radius<double>(a, n),
               of_b = contact::projected_radius<double>(b, n);
  const double offset = (sign * (of_a - of_b) + across) / 2;
  out.normal = n / std::sqrt(squared);
  out.on = n * (offset / squared) / size;
  if (std::abs(across) > std::abs(offset)) out.on = b.centre * (offset / across) / size;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const Vector* v : {&in.b, &in.nose_a, &in.nose_b, &in.half_a, &in.half_b}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  for (const Vector* nose : {&in.nose_a, &in.nose_b}) {
    if (!(nose->cwiseAbs().maxCoeff() > 1e-100)) out.problem = contact::figure::zero_direction;
  }
  for (const Vector* half : {&in.half_a, &in.half_b}) {
    if (!(half->minCoeff() >= 1e-6)) out.problem = contact::figure::not_positive;
  }
  if (!(in.size >= 1e-6)) out.problem = contact::figure::not_positive;
  if (std::max({in.size, std::abs(in.roll_a), std::abs(in.roll_b)}) > 1e6)
    out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;

  const Box drawn_a{Vector::Zero(), rotation(in.nose_a, in.roll_a), in.half_a};
  const Box drawn_b{in.b, rotation(in.nose_b, in.roll_b), in.half_b};
  for (std::size_t k = 0; k < corners; ++k) {
    out.corner_a[k] = contact::box_corner(drawn_a, int(k));
    out.corner_b[k] = contact::box_corner(drawn_b, int(k));
  }
  const Box a{drawn_a.centre, drawn_a.axes, drawn_a.half_lengths * in.size};
  const Box b{drawn_b.centre * in.size, drawn_b.axes, drawn_b.half_lengths * in.size};

  const double epsilon = std::max(in.epsilon, 0.0);
  const std::array<Found, methods> found{along_all_axes(a, b), by_cosines(a, b, 0),
                                         skipping(a, b, epsilon), by_cosines(a, b, epsilon)};
  const contact::Proximity state = contact::proximity(a, b);
  const bool disjoint = state == contact::Proximity::disjoint;
  out.state = disjoint ? 0 : (state == contact::Proximity::touching ? 1 : 2);
  for (std::size_t m = 0; m < methods; ++m) {
    const bool apart = m == 0 ? disjoint : found[m].largest > 0;
    out.apart[m] = apart ? 1 : 0;
    out.wrong[m] = apart != disjoint ? 1 : 0;
  }

  const Found& chosen = found[in.method >= 1 && in.method < methods ? std::size_t(in.method) : 0];
  out.separation = chosen.separation;
  out.skipped = chosen.skipped;
  for (const double skipped : chosen.skipped) out.skipped_count += skipped;
  out.largest = chosen.largest;
  out.axis = double(chosen.axis);
  draw_plane(a, b, int(chosen.axis), in.size, out);
  out.exact_largest = found[0].largest;
  out.exact_axis = double(found[0].axis);
  out.shortest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < axes; ++k) {
    out.length[k] = std::sqrt(contact::box_axis<double>(a, b, int(k)).squaredNorm());
    if (k >= 6) out.shortest = std::min(out.shortest, out.length[k]);
  }

  answer_for_reader(in, a, b, found[0], out);

  const auto& along = found[0].separation;
  const bool faces_overlap =
      std::all_of(along.begin(), along.begin() + 6, [](double x) { return x <= -0.25; });
  out.edges_only = disjoint && faces_overlap ? 1 : 0;
  out.skipping_wrong = disjoint ? out.wrong[2] : 0;
  out.padding_wrong = disjoint ? out.wrong[3] : 0;
  out.rounding_wrong = out.wrong[1];
  return out;
}

FIGURE(Input, FIELDS(b, nose_a, nose_b, roll_a, roll_b, half_a, half_b, size, method, epsilon),
       Output,
       FIELDS(problem, corner_a, corner_b, separation, skipped, skipped_count, largest, axis,
              normal, on, length, shortest, state, apart, wrong, exact_largest, exact_axis, x_a,
              y_a, z_a, x_b, y_b, z_b, gap, gap_axis, asked, edges_only, skipping_wrong,
              padding_wrong, rounding_wrong))
