// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// The question "cases": whether two bodies separate (1), touch (0) or collide (−1); class (a), by
// fractions of the stored numbers. The question "distance": the distance, or minus the depth; class
// (b), a rational number and one square root. A distance may have an error of 64 u of the
// coordinates' magnitudes.
#include "support/hard_cases.hpp"

#include <algorithm>
#include <cmath>
#include <contact/closed_proximity.hpp>
#include <contact/signed_distance.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "shape_oracle.hpp"

using hard_cases::Case;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;
using oracle::Surd;
using oracle::Vector;

namespace {

using V = contact::Vector3<double>;
template <class S>
using Shape = std::variant<contact::Capsule<S>, contact::OrientedBox<S>, contact::HalfSpace<S>>;

/// A body of the corpus: NAME_centre with NAME_half and NAME_axes (nine numbers, column after
/// column; without them, the world's) is a box, with NAME_radius a sphere; NAME_start and NAME_end
/// with NAME_radius a capsule; NAME_normal and NAME_offset a half-space.
Shape<double> body(const Case& c, const std::string& name) {
  if (c.has(name + "_normal")) {
    return contact::HalfSpace<double>{{c.vector(name + "_normal"), c.number(name + "_offset")}};
  }
  if (c.has(name + "_half")) {
    contact::OrientedBox<double> box;
    box.centre = c.vector(name + "_centre");
    box.half_lengths = c.vector(name + "_half");
    if (c.has(name + "_axes")) {
      const std::vector<double> all = c.numbers(name + "_axes");
      for (int i = 0; i < 9; ++i) box.axes(i % 3, i / 3) = all.at(static_cast<std::size_t>(i));
    }
    return box;
  }
  const double radius = c.number(name + "_radius");
  if (c.has(name + "_centre")) {
    const V centre = c.vector(name + "_centre");
    return contact::Capsule<double>{{centre, centre}, radius};
  }
  return contact::Capsule<double>{{c.vector(name + "_start"), c.vector(name + "_end")}, radius};
}

contact::Capsule<float> narrow(const contact::Capsule<double>& c) {
  return {{c.core.start.cast<float>(), c.core.end.cast<float>()}, static_cast<float>(c.radius)};
}
contact::OrientedBox<float> narrow(const contact::OrientedBox<double>& b) {
  return {b.centre.cast<float>(), b.axes.cast<float>(), b.half_lengths.cast<float>()};
}
contact::HalfSpace<float> narrow(const contact::HalfSpace<double>& h) {
  return {{h.boundary.normal.cast<float>(), static_cast<float>(h.boundary.offset)}};
}

/// Calls f(a, b) with the shapes in their own types; a half-space comes second.
template <class F>
auto with(const Case& c, const F& f) {
  return std::visit(
      [&](const auto& a, const auto& b) {
        using A = std::decay_t<decltype(a)>;
        if constexpr (std::is_same_v<A, contact::HalfSpace<double>>) {
          throw hard_cases::CorpusError(c.name() + ": the first body must not be a half-space");
          return f(contact::Capsule<double>{}, contact::Capsule<double>{});
        } else {
          return f(a, b);
        }
      },
      body(c, "a"), body(c, "b"));
}

/// The exact distance, squared if positive, by the oracle of the bodies.
struct Exactly {
  int sign = 0;
  Surd distance;
};

Exactly beyond(const Rational& squared, const Rational& radii) {
  return {oracle::sign(Rational(squared - radii * radii)), Surd{-radii, 1, squared}};
}
contact::Segment<Rational> core(const contact::Capsule<double>& c) { return oracle::exact(c.core); }

Exactly exactly(const contact::Capsule<double>& a, const contact::Capsule<double>& b) {
  return beyond(shape_oracle::min_squared(
                    difference(shape_oracle::zonotope(core(a)), shape_oracle::zonotope(core(b)))),
                oracle::exact(a.radius) + oracle::exact(b.radius));
}
/// The largest separation of the axes in `all`, as g / √n².
Surd widest(const std::vector<Vector>& all, const shape_oracle::Zonotope& z) {
  std::optional<Surd> best;
  for (const Vector& n : all) {
    if (n.dot(n) == 0) continue;
    Rational room = n.dot(z.origin);
    if (room < 0) room = -room;
    for (const Vector& span : z.spans) {
      const Rational reach = n.dot(span);
      room -= reach < 0 ? Rational(-reach) : reach;
    }
    const Surd distance = oracle::divided_by_root(room, n.dot(n));
    if (!best || oracle::compare(distance, *best) > 0) best = distance;
  }
  return *best;
}
/// The three cases of a zonotope of differences and the origin: every pair of spans gives two of
/// its faces.
Exactly exactly(const shape_oracle::Zonotope& z, const Rational& radius) {
  const Rational squared = shape_oracle::min_squared(z);
  if (squared > 0) return beyond(squared, radius);
  std::vector<Vector> all;
  for (std::size_t i = 0; i < z.spans.size(); ++i) {
    for (std::size_t k = i + 1; k < z.spans.size(); ++k) {
      all.push_back(z.spans[i].cross(z.spans[k]));
    }
  }
  const Surd distance = widest(all, z) + Rational(-radius);
  return {oracle::sign(distance), distance};
}
Exactly exactly(const contact::Capsule<double>& a, const contact::OrientedBox<double>& b) {
  return exactly(
      difference(shape_oracle::zonotope(core(a)), shape_oracle::zonotope(shape_oracle::exact(b))),
      oracle::exact(a.radius));
}
Exactly exactly(const contact::OrientedBox<double>& a, const contact::Capsule<double>& b) {
  return exactly(b, a);
}
Exactly exactly(const contact::OrientedBox<double>& a, const contact::OrientedBox<double>& b) {
  return exactly(difference(shape_oracle::zonotope(shape_oracle::exact(a)),
                            shape_oracle::zonotope(shape_oracle::exact(b))),
                 0);
}
/// All x with n · x ≤ k, for n of any length: (smallest n · x − k) / |n| − radius.
Exactly exactly(const std::vector<Vector>& points, double radius,
                const contact::HalfSpace<double>& h) {
  const Vector n = oracle::exact(h.boundary.normal);
  Rational lowest = n.dot(points[0]);
  for (const Vector& p : points) lowest = std::min<Rational>(lowest, n.dot(p));
  const Surd distance =
      oracle::divided_by_root(Rational(lowest - oracle::exact(h.boundary.offset)), n.dot(n)) +
      Rational(-oracle::exact(radius));
  return {oracle::sign(distance), distance};
}
Exactly exactly(const contact::Capsule<double>& a, const contact::HalfSpace<double>& b) {
  return exactly({oracle::exact(a.core.start), oracle::exact(a.core.end)}, a.radius, b);
}
Exactly exactly(const contact::OrientedBox<double>& a, const contact::HalfSpace<double>& b) {
  std::vector<Vector> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(contact::box_corner<Rational>(shape_oracle::exact(a), k));
  }
  return exactly(corners, 0, b);
}

double size_of(const contact::Capsule<double>& c) {
  return c.core.start.cwiseAbs().sum() + c.core.end.cwiseAbs().sum() + c.radius;
}
double size_of(const contact::OrientedBox<double>& b) {
  return b.centre.cwiseAbs().sum() + b.half_lengths.sum();
}
double size_of(const contact::HalfSpace<double>& h) { return std::abs(h.boundary.offset); }

int sign_of(contact::Proximity p) {
  if (p == contact::Proximity::touching) return 0;
  return p == contact::Proximity::disjoint ? 1 : -1;
}
int sign(double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

// ---------------------------------------------------------------- the methods to compare with

/// The closest points of two segments as in most textbooks: a 2 × 2 system, with an epsilon for
/// parallel lines, and two clamps in sequence.
double textbook_distance(const contact::Capsule<double>& a, const contact::Capsule<double>& b) {
  const V d = a.core.end - a.core.start;
  const V e = b.core.end - b.core.start;
  const V w = a.core.start - b.core.start;
  const double dd = d.dot(d), ee = e.dot(e), f = e.dot(w);
  double s = 0, t = 0;
  const double epsilon = 1e-12;
  if (dd <= epsilon && ee <= epsilon) {
  } else if (dd <= epsilon) {
    t = std::clamp(f / ee, 0.0, 1.0);
  } else if (ee <= epsilon) {
    s = std::clamp(-d.dot(w) / dd, 0.0, 1.0);
  } else {
    const double c = d.dot(w), de = d.dot(e), det = dd * ee - de * de;
    s = det > epsilon ? std::clamp((de * f - c * ee) / det, 0.0, 1.0) : 0.0;
    t = (de * s + f) / ee;
    if (t < 0) {
      t = 0;
      s = std::clamp(-c / dd, 0.0, 1.0);
    } else if (t > 1) {
      t = 1;
      s = std::clamp((de - c) / dd, 0.0, 1.0);
    }
  }
  const V between = (a.core.start + d * s) - (b.core.start + e * t);
  return between.norm() - a.radius - b.radius;
}

/// The separation of two boxes along normalised axes; cross products are normalised however short
/// they are, and left out only if they are exactly 0.
double textbook_room(const contact::OrientedBox<double>& a, const contact::OrientedBox<double>& b,
                     double skip_below) {
  double most = -INFINITY;
  for (int k = 0; k < contact::box_axis_count; ++k) {
    const V n = contact::box_axis(a, b, k);
    const double length = n.norm();
    if (!(length > skip_below)) continue;
    most = std::max(most, contact::separation_along<double>(a, b, V(n / length)));
  }
  return most;
}

template <class F>
auto on_capsules(const F& f) {
  return [f](const Case& c, const Json& answer) {
    const auto a = std::get<contact::Capsule<double>>(body(c, "a"));
    return f(c, a, std::get<contact::Capsule<double>>(body(c, "b")), answer);
  };
}
bool are_capsules(const Case& c) {
  return std::holds_alternative<contact::Capsule<double>>(body(c, "a")) &&
         std::holds_alternative<contact::Capsule<double>>(body(c, "b"));
}
bool are_boxes(const Case& c) {
  return std::holds_alternative<contact::OrientedBox<double>>(body(c, "a")) &&
         std::holds_alternative<contact::OrientedBox<double>>(body(c, "b"));
}
double room_of(const Case& c) {
  return with(c, [](const auto& a, const auto& b) { return (size_of(a) + size_of(b)) * 0x1p-47; });
}
bool close(double got, const Case& c, const Json& answer) {
  return std::abs(got - unhex(answer.at("distance"))) <= room_of(c);
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("09_separating_planes");
  runner.question("cases", [](const Case& c) {
    const int s = with(c, [](const auto& a, const auto& b) { return exactly(a, b).sign; });
    return Json{{"class", "a"}, {"case", s}};
  });
  runner.method("cases", "float", [](const Case& c, const Json& answer) {
    const double d = with(c, [](const auto& a, const auto& b) {
      return double(contact::signed_distance(narrow(a), narrow(b)).distance);
    });
    return sign(d) == answer.at("case").get<int>();
  });
  runner.method("cases", "double", [](const Case& c, const Json& answer) {
    const double d = with(
        c, [](const auto& a, const auto& b) { return contact::signed_distance(a, b).distance; });
    return sign(d) == answer.at("case").get<int>();
  });
  runner.method("cases", "double, touching within 1e-9", [](const Case& c, const Json& answer) {
    const double d = with(
        c, [](const auto& a, const auto& b) { return contact::signed_distance(a, b).distance; });
    return (std::abs(d) <= 1e-9 ? 0 : sign(d)) == answer.at("case").get<int>();
  });
  runner.method("cases", "face normals only", are_boxes, [](const Case& c, const Json& answer) {
    const auto a = std::get<contact::OrientedBox<double>>(body(c, "a"));
    const auto b = std::get<contact::OrientedBox<double>>(body(c, "b"));
    double most = -INFINITY;
    for (int k = 0; k < 6; ++k) {
      most = std::max(most, contact::separation_along<double>(a, b, contact::box_axis(a, b, k)));
    }
    return sign(most) == answer.at("case").get<int>();
  });
  runner.method("cases", "book", [](const Case& c, const Json& answer) {
    const contact::Proximity s =
        with(c, [](const auto& a, const auto& b) { return contact::proximity(a, b); });
    return sign_of(s) == answer.at("case").get<int>();
  });
  runner.question("distance", [](const Case& c) {
    const Surd d = with(c, [](const auto& a, const auto& b) { return exactly(a, b).distance; });
    return Json{{"class", "b"}, {"distance", hard_cases::hex(oracle::nearest(d))}};
  });
  runner.method("distance", "textbook segments", are_capsules,
                on_capsules([](const Case& c, const auto& a, const auto& b, const Json& answer) {
                  return close(textbook_distance(a, b), c, answer);
                }));
  runner.method("distance", "textbook axes", are_boxes, [](const Case& c, const Json& answer) {
    return close(textbook_room(std::get<contact::OrientedBox<double>>(body(c, "a")),
                               std::get<contact::OrientedBox<double>>(body(c, "b")), 0),
                 c, answer);
  });
  runner.method(
      "distance", "axes longer than 1e-6", are_boxes, [](const Case& c, const Json& answer) {
        return close(textbook_room(std::get<contact::OrientedBox<double>>(body(c, "a")),
                                   std::get<contact::OrientedBox<double>>(body(c, "b")), 1e-6),
                     c, answer);
      });
  runner.method("distance", "book", [](const Case& c, const Json& answer) {
    return close(with(c, [](const auto& a,
                            const auto& b) { return contact::signed_distance(a, b).distance; }),
                 c, answer);
  });
  return runner.run(argc, argv);
}
