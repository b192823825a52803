// The cost and the accuracy of sums of products: a sum, a dot product, a coordinate of a cross
// product.
#include <support/ladder.hpp>

#include <contact/products.hpp>

#ifdef CONTACT_HAS_GMP
#include <boost/multiprecision/gmp.hpp>
#endif

namespace {

template <class S>
using Column = Eigen::Matrix<S, Eigen::Dynamic, 1>;

/// The terms of Σ xᵢ yᵢ in float and in double; the conversion is not timed.
struct Input {
  Column<float> x_float, y_float;
  Column<double> x, y;
};

/// A value as the number nearest to it and the remainder, and Σ|xᵢ yᵢ|, relative to which errors
/// are measured.
struct Value {
  double nearest = 0;
  double rest = 0;
  double size = 0;
};

/// The answer of a method, for the floats or for the doubles; the truth has both.
struct Answer {
  bool of_floats = false;
  Value in_float, in_double;
};

Input in_both_types(const std::vector<double>& x, const std::vector<double>& y) {
  Input input;
  const auto count = static_cast<Eigen::Index>(x.size());
  input.x = Eigen::Map<const Column<double>>(x.data(), count);
  input.y = Eigen::Map<const Column<double>>(y.data(), count);
  input.x_float = input.x.cast<float>();
  input.y_float = input.y.cast<float>();
  return input;
}

constexpr int terms = 32;

/// A sum: the other factors are 1.
Input sum(const std::vector<double>& values) {
  return in_both_types(values, std::vector<double>(values.size(), 1.0));
}
Input one_way(generators::Random& random) {
  std::vector<double> values;
  for (int i = 0; i < terms; ++i) values.push_back(random.uniform(0.5, 1));
  return sum(values);
}
/// Large terms and their opposites, and between them small ones.
Input cancelling(generators::Random& random) {
  std::vector<double> values;
  for (int i = 0; i < terms / 4; ++i) {
    const double x = random.magnitude(30, 60);
    values.push_back(x);
    values.push_back(-x);
    values.push_back(random.uniform(-1, 1));
    values.push_back(random.uniform(-1, 1));
  }
  for (std::size_t i = values.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1));
    std::swap(values[i - 1], values[other]);
  }
  return sum(values);
}

Input dot(generators::Random& random) {
  std::vector<double> u, v;
  for (int k = 0; k < 3; ++k) {
    u.push_back(random.uniform(-1, 1));
    v.push_back(random.uniform(-1, 1));
  }
  return in_both_types(u, v);
}
/// v perpendicular to u except for rounding.
Input perpendicular(generators::Random& random) {
  const double a = random.uniform(0.5, 1);
  const double b = random.uniform(-1, 1);
  const double c = random.uniform(-1, 1);
  const double d = random.uniform(-1, 1);
  return in_both_types({a, b, c}, {-(b * d + c) / a, d, 1});
}

/// a b − c d for the edges of a triangle that is not a sliver.
Input corner(generators::Random& random) {
  const double a = random.uniform(0.5, 1);
  const double c = random.uniform(-0.4, 0.4);
  const double d = random.uniform(-1, 1);
  return in_both_types({a, -c}, {random.uniform(0.5, 1), d});
}
/// The same for a sliver: one edge is a multiple of the other, rounded.
Input sliver(generators::Random& random) {
  const double x = random.uniform(0.5, 1);
  const double y = random.uniform(0.5, 1);
  const double factor = random.uniform(0.5, 2);
  return in_both_types({x, -y}, {factor * y, factor * x});
}

template <class S>
Value exact_value(const Column<S>& x, const Column<S>& y) {
  contact::Exact value;
  double size = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    value += contact::Exact(double(x[i])) * contact::Exact(double(y[i]));
    size += std::abs(double(x[i]) * double(y[i]));
  }
  const auto nearest = rounded<double>(value);
  return {nearest, rounded<double>(value - contact::Exact(nearest)), size};
}

Answer truth_of(const Input& input) {
  return {false, exact_value(input.x_float, input.y_float), exact_value(input.x, input.y)};
}

#ifdef CONTACT_HAS_GMP
double by_rationals(const Column<double>& x, const Column<double>& y) {
  using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                                 boost::multiprecision::et_off>;
  Rational value = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) value += Rational(x[i]) * Rational(y[i]);
  return static_cast<double>(value);
}
#endif

int sign(double x) { return (x > 0) - (x < 0); }

/// Two vectors are shown with their products; the coordinate of a cross product as that of vectors
/// in the plane.
template <class S>
ladder::Example shown(const Column<S>& x, const Column<S>& y, const Value& said,
                      const Value& truth) {
  ladder::Example example;
  example.facts = {ladder::numbers("x", x), ladder::numbers("y", y),
                   ladder::number("Σ xᵢ yᵢ by this method", said.nearest),
                   ladder::number("exact, then rounded", truth.nearest)};
  const auto at = [](const Column<S>& v, Eigen::Index i) { return static_cast<double>(v[i]); };
  if (x.size() == 3) {
    example.figure = "products";
    example.fields = {ladder::field("u", x), ladder::field("v", y)};
    example.note = "The sum is u · v.";
  } else if (x.size() == 2) {
    example.figure = "products";
    example.fields = {{"u", {at(x, 0), -at(x, 1), 0}}, {"v", {at(y, 1), at(y, 0), 0}}};
    example.note = "The sum is the z coordinate of u × v.";
  } else {
    example.note = "No figure of this chapter shows a sum of 32 terms.";
  }
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  const auto judge = [](const Answer& got, const Answer& right) {
    ladder::Verdict verdict;
    const Value& told = got.of_floats ? got.in_float : got.in_double;
    const Value& truth = got.of_floats ? right.in_float : right.in_double;
    verdict.wrong = sign(told.nearest) != sign(truth.nearest);
    verdict.error = std::abs((told.nearest - truth.nearest) - truth.rest) / truth.size;
    return verdict;
  };
  ladder::Ladder<Input, Answer> ladder("What are the value and the sign of a sum of products?",
                                       truth_of, judge);

  ladder.family("one-way", "a sum of 32 terms of one sign", one_way);
  ladder.family("cancelling", "a sum of 32 terms, the large ones cancel", cancelling);
  ladder.family("dot", "a dot product of two vectors", dot);
  ladder.family("perpendicular", "a dot product of perpendicular vectors", perpendicular);
  ladder.family("corner", "a cross product of two edges", corner);
  ladder.family("sliver", "a cross product of the edges of a sliver", sliver);

  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(
        {.id = std::string(id) + "-float", .title = title, .scalar = "float", .exact = false},
        [method](const Input& input) {
          return Answer{true, {double(method(input.x_float, input.y_float)), 0, 0}, {}};
        });
    ladder.method(
        {.id = std::string(id) + "-double", .title = title, .scalar = "double", .exact = false},
        [method](const Input& input) {
          return Answer{false, {}, {method(input.x, input.y), 0, 0}};
        });
  };
  in_both("order", "recursive summation",
          [](const auto& x, const auto& y) { return contact::dot_recursive(x, y); });
  ladder.method(
      {.id = "widened", .title = "floats, in double", .scalar = "float in double", .exact = false},
      [](const Input& input) {
        double value = 0;
        for (Eigen::Index i = 0; i < input.x_float.size(); ++i) {
          value += double(input.x_float[i]) * double(input.y_float[i]);
        }
        return Answer{true, {value, 0, 0}, {}};
      });
  in_both("compensated", "compensated",
          [](const auto& x, const auto& y) { return contact::dot_compensated(x, y); });

  const auto exact = [&ladder](const char* id, const char* title, const char* scalar, auto method) {
    ladder.method({.id = id, .title = title, .scalar = scalar, .exact = true},
                  [method](const Input& input) {
                    return Answer{false, {}, {method(input.x, input.y), 0, 0}};
                  });
  };
  using Doubles = Column<double>;
  exact("filtered", "the book's: compensated, else exact", "double, then exact",
        [](const Doubles& x, const Doubles& y) { return contact::dot_accurately(x, y); });
  exact("exact", "exact", "exact",
        [](const Doubles& x, const Doubles& y) { return contact::dot_exactly(x, y); });
#ifdef CONTACT_HAS_GMP
  exact("rational", "rational numbers (GMP)", "rational", by_rationals);
#endif
  ladder.recommend("filtered");
  ladder.show(
      [](const Input& input, const Answer& got, const Answer& right, const ladder::Method&) {
        return got.of_floats ? shown(input.x_float, input.y_float, got.in_float, right.in_float)
                             : shown(input.x, input.y, got.in_double, right.in_double);
      });
  return ladder;
}

}  // namespace

LADDER(experiment)
