// The cost of deciding whether two discs push each other, and of their velocities afterwards.
#include <support/ladder.hpp>

#include <contact/disc_collision.hpp>

#ifdef CONTACT_HAS_GMP
#include <boost/multiprecision/gmp.hpp>
#endif

namespace {

template <class S>
using Vector = contact::Vector2<S>;

template <class S>
struct Pair {
  contact::Disc<S> a, b;
};

/// The same two discs in float and in double; the conversion is not timed.
struct Input {
  Pair<float> in_float;
  Pair<double> in_double;
};

/// Whether there is an impulse, and the velocities afterwards; the input in float is not that in
/// double.
struct Said {
  bool hit = false;
  Vector<double> a = Vector<double>::Zero();
  Vector<double> b = Vector<double>::Zero();
  double size = 0;  // |v_A| + |v_B|, to which errors are relative
};
struct Answer {
  bool of_floats = false;
  Said in_float, in_double;
};

constexpr double restitution = 1;

template <class S>
contact::Disc<S> as(const contact::Disc<double>& d) {
  return {static_cast<S>(d.mass), static_cast<S>(d.radius),
          Vector<S>{static_cast<S>(d.centre.x()), static_cast<S>(d.centre.y())},
          Vector<S>{static_cast<S>(d.velocity.x()), static_cast<S>(d.velocity.y())}};
}
Input in_both_types(const contact::Disc<double>& a, const contact::Disc<double>& b) {
  return {{as<float>(a), as<float>(b)}, {a, b}};
}

Vector<double> vector_of(generators::Random& random, double size) {
  return Vector<double>{random.uniform(-size, size), random.uniform(-size, size)};
}

/// A touching pair.
std::array<contact::Disc<double>, 2> touching(generators::Random& random) {
  contact::Disc<double> a{random.uniform(0.2, 5), 0.5, vector_of(random, 2), vector_of(random, 3)};
  contact::Disc<double> b{random.uniform(0.2, 5), 0.5, vector_of(random, 2), vector_of(random, 3)};
  Vector<double> way = vector_of(random, 1);
  while (!(way.squaredNorm() > 0.01)) way = vector_of(random, 1);
  a.centre = b.centre + *contact::line_of_centres<double>(way, Vector<double>(0, 0));
  return {a, b};
}

Input anyhow(generators::Random& random) {
  const auto [a, b] = touching(random);
  return in_both_types(a, b);
}

/// Two discs just after a collision.
Input just_collided(generators::Random& random) {
  auto [a, b] = touching(random);
  const auto after = contact::collide_discs(a, b, restitution);
  a.velocity = after.velocity_a;
  b.velocity = after.velocity_b;
  return in_both_types(a, b);
}

/// The relative velocity is along the rims, to rounding.
Input grazing(generators::Random& random) {
  auto [a, b] = touching(random);
  const Vector<double> d = a.centre - b.centre;
  a.velocity = b.velocity + random.uniform(0.5, 2) * Vector<double>{-d.y(), d.x()};
  return in_both_types(a, b);
}

/// 2^24 m from the origin.
Input far_out(generators::Random& random) {
  auto [a, b] = touching(random);
  const Vector<double> there = vector_of(random, 0x1p+24);
  a.centre += there;
  b.centre += there;
  return in_both_types(a, b);
}

/// Discs so small that squares underflow, in either type.
Input tiny(generators::Random& random) {
  auto [a, b] = touching(random);
  a.centre = (a.centre - b.centre) * 0x1p-120;
  b.centre = Vector<double>{0, 0};
  Input input = in_both_types(a, b);
  input.in_double.a.centre *= 0x1p-480;
  return input;
}

/// In a field: no root is needed, since d (d·w)/(d·d) has none.
template <class T, class Divide>
Said without_root(const Pair<double>& p, const Divide& divide) {
  const Vector<double>& va = p.a.velocity;
  const Vector<double>& vb = p.b.velocity;
  Said said{false, va, vb, va.norm() + vb.norm()};
  const T dx = T(p.a.centre.x()) - T(p.b.centre.x());
  const T dy = T(p.a.centre.y()) - T(p.b.centre.y());
  const T wx = T(va.x()) - T(vb.x());
  const T wy = T(va.y()) - T(vb.y());
  const T approach = -(dx * wx + dy * wy);
  if (!(T(0.0) < approach)) return said;
  said.hit = true;
  const T ma(p.a.mass);
  const T mb(p.b.mass);
  const T below = (ma + mb) * (dx * dx + dy * dy);
  const T push = (T(1.0) + T(restitution)) * approach;
  for (int k = 0; k < 2; ++k) {
    const T d = k == 0 ? dx : dy;
    said.a(k) = divide(T(va(k)) * below + push * d * mb, below);
    said.b(k) = divide(T(vb(k)) * below - push * d * ma, below);
  }
  return said;
}

Said exactly(const Pair<double>& p) {
  return without_root<contact::Exact>(
      p, [](const contact::Exact& n, const contact::Exact& d) { return quotient<double>(n, d); });
}

Answer truth_of(const Input& input) {
  const Pair<double> floats{as<double>({input.in_float.a.mass, input.in_float.a.radius,
                                        input.in_float.a.centre.cast<double>(),
                                        input.in_float.a.velocity.cast<double>()}),
                            as<double>({input.in_float.b.mass, input.in_float.b.radius,
                                        input.in_float.b.centre.cast<double>(),
                                        input.in_float.b.velocity.cast<double>()})};
  return {false, exactly(floats), exactly(input.in_double)};
}

/// The lecture's steps a to d, with or without a test for approach.
template <class S>
Said steps(const Pair<S>& p, bool ask) {
  const auto& [a, b] = p;
  const Vector<S> d = a.centre - b.centre;
  const Vector<S> n = d / std::sqrt(d.x() * d.x() + d.y() * d.y());
  const S ua = n.dot(a.velocity);
  const S ub = n.dot(b.velocity);
  Said said{true, a.velocity.template cast<double>(), b.velocity.template cast<double>(), 0};
  if (ask && !(ua - ub < S(0))) {
    said.hit = false;
    return said;
  }
  const S m = a.mass + b.mass;
  const S both = a.mass * ua + b.mass * ub;
  const S e(restitution);
  const Vector<S> va = (a.velocity - n * ua) + n * ((both - e * (ua - ub) * b.mass) / m);
  const Vector<S> vb = (b.velocity - n * ub) + n * ((both - e * (ub - ua) * a.mass) / m);
  said.a = va.template cast<double>();
  said.b = vb.template cast<double>();
  return said;
}

template <class S>
Said by_quotient(const Pair<S>& p) {
  const auto& [a, b] = p;
  const Vector<S> d = a.centre - b.centre;
  const Vector<S> w = a.velocity - b.velocity;
  const S along = d.dot(w);
  Said said{false, a.velocity.template cast<double>(), b.velocity.template cast<double>(), 0};
  if (!(along < S(0))) return said;
  said.hit = true;
  const S push = (S(1) + S(restitution)) * along / (d.dot(d) * (a.mass + b.mass));
  const Vector<S> va = a.velocity - d * S(push * b.mass);
  const Vector<S> vb = b.velocity + d * S(push * a.mass);
  said.a = va.template cast<double>();
  said.b = vb.template cast<double>();
  return said;
}

template <class S>
Said by_the_book(const Pair<S>& p) {
  const auto after = contact::collide_discs(p.a, p.b, S(restitution));
  return {after.hit, after.velocity_a.template cast<double>(),
          after.velocity_b.template cast<double>(), 0};
}

#ifdef CONTACT_HAS_GMP
Said by_rationals(const Pair<double>& p) {
  using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                                 boost::multiprecision::et_off>;
  return without_root<Rational>(
      p, [](const Rational& n, const Rational& d) { return static_cast<double>(Rational(n / d)); });
}
#endif

template <class S>
ladder::Example shown(const Pair<S>& p, const Said& told, const Said& truth, bool as_the_lecture) {
  const auto verdict = [](const Said& said) { return said.hit ? "yes" : "no"; };
  ladder::Example example;
  for (const auto& [name, disc] : {std::pair{"A", &p.a}, std::pair{"B", &p.b}}) {
    const std::string of = std::string(" of ") + name;
    example.facts.push_back(ladder::numbers("centre" + of + ", m", disc->centre));
    example.facts.push_back(ladder::numbers("velocity" + of + ", m/s", disc->velocity));
    example.facts.push_back(ladder::number("mass" + of + ", kg", disc->mass));
  }
  example.facts.push_back({"impulse by this method", verdict(told)});
  example.facts.push_back(ladder::numbers("velocity of A afterwards, m/s", told.a));
  example.facts.push_back({"impulse, exact", verdict(truth)});
  example.facts.push_back(ladder::numbers("velocity of A afterwards, exact, m/s", truth.a));
  const double size = static_cast<double>(p.a.centre.cwiseAbs().maxCoeff());
  const double distance = static_cast<double>((p.a.centre - p.b.centre).cwiseAbs().maxCoeff());
  if (size > 100) {
    example.note = "These discs are thousands of kilometres outside the figure.";
  } else if (distance < 0x1p-10) {
    example.note = "These discs are too small to be seen, and enlarged no square would underflow.";
  } else {
    example.figure = "two_discs";
    example.fields = {ladder::field("centre_a", p.a.centre),
                      ladder::field("centre_b", p.b.centre),
                      ladder::field("velocity_a", p.a.velocity),
                      ladder::field("velocity_b", p.b.velocity),
                      {"mass_a", {static_cast<double>(p.a.mass)}},
                      {"mass_b", {static_cast<double>(p.b.mass)}},
                      {"restitution", {restitution}},
                      {"way", {as_the_lecture ? 1.0 : 0.0}}};
    if (!as_the_lecture) example.note = "The figure shows the book's answer.";
  }
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  const auto judge = [](const Answer& got, const Answer& right) {
    const Said& told = got.of_floats ? got.in_float : got.in_double;
    const Said& truth = got.of_floats ? right.in_float : right.in_double;
    ladder::Verdict verdict;
    verdict.wrong = told.hit != truth.hit;
    const double off = std::max((told.a - truth.a).cwiseAbs().maxCoeff(),
                                (told.b - truth.b).cwiseAbs().maxCoeff());
    // NaN counts as the largest error.
    verdict.error = std::isfinite(off) ? off / truth.size : 1;
    return verdict;
  };
  ladder::Ladder<Input, Answer> ladder("Do two discs push each other, and how do they leave?",
                                       truth_of, judge);

  ladder.family("touching", "touching, at random", anyhow);
  ladder.family("just-collided", "just collided", just_collided);
  ladder.family("grazing", "grazing", grazing);
  ladder.family("far", "far from the origin", far_out);
  ladder.family("tiny", "so small that squares underflow", tiny);

  const auto in_float = [&ladder](const char* id, const char* title, auto method) {
    ladder.method({.id = id, .title = title, .scalar = "float", .exact = false},
                  [method](const Input& input) {
                    return Answer{true, method(input.in_float), {}};
                  });
  };
  const auto in_double = [&ladder](const char* id, const char* title, const char* scalar,
                                   bool exact, auto method) {
    ladder.method({.id = id, .title = title, .scalar = scalar, .exact = exact},
                  [method](const Input& input) {
                    return Answer{false, {}, method(input.in_double)};
                  });
  };
  in_float("steps-float", "steps a to d", [](const auto& p) { return steps(p, false); });
  in_double("steps-double", "steps a to d", "double", false,
            [](const auto& p) { return steps(p, false); });
  in_float("asked-float", "steps, if n·w < 0", [](const auto& p) { return steps(p, true); });
  in_double("asked-double", "steps, if n·w < 0", "double", false,
            [](const auto& p) { return steps(p, true); });
  in_float("quotient-float", "without a root, if d·w < 0",
           [](const auto& p) { return by_quotient(p); });
  in_double("quotient-double", "without a root, if d·w < 0", "double", false,
            [](const auto& p) { return by_quotient(p); });
  in_double("book", "the book's: sign exact, axis scaled", "double, then exact", true,
            [](const auto& p) { return by_the_book(p); });
  in_double("exact", "exact", "exact", true, [](const auto& p) { return exactly(p); });
#ifdef CONTACT_HAS_GMP
  in_double("rational", "in fractions (GMP)", "rational", true,
            [](const auto& p) { return by_rationals(p); });
#endif
  ladder.recommend("book");
  ladder.show([](const Input& input, const Answer& got, const Answer& right,
                 const ladder::Method& method) {
    const bool as_the_lecture = method.id.starts_with("steps-");
    return got.of_floats ? shown(input.in_float, got.in_float, right.in_float, as_the_lecture)
                         : shown(input.in_double, got.in_double, right.in_double, as_the_lecture);
  });
  return ladder;
}

}  // namespace

LADDER(experiment)
