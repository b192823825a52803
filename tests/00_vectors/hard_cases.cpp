// Recomputes the answers of hard_cases.json and checks which method is right in which case.
//
// Sums, dot products and cross products are of class (a): rational in the stored numbers, rounded
// once. A value is right if its relative error is at most 2^-40, and exactly 0 where it is 0. A
// side is a sign and has no tolerance. Angles are of class (c): intervals at growing precision; one
// is right if its relative error is at most 2^-40.
#include "support/hard_cases.hpp"

#include <algorithm>
#include <cmath>
#include <contact/angle.hpp>
#include <contact/orientation.hpp>
#include <contact/products.hpp>
#include <vector>

using contact::Vector2;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::hex;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Interval;
using oracle::Rational;

namespace {

using Numbers = std::vector<double>;
using Vector = Vector3<double>;

bool close(double got, double right) {
  if (std::isinf(right)) return got == right;
  return std::isfinite(got) && std::abs(got - right) <= std::ldexp(std::abs(right), -40);
}

// ---------------------------------------------------------------- sums

Rational sum_of(const Numbers& terms) {
  Rational sum = 0;
  for (const double x : terms) sum += oracle::exact(x);
  return sum;
}

double in_order(const Numbers& terms) {
  double sum = 0;
  for (const double x : terms) sum += x;
  return sum;
}

double largest_last(Numbers terms) {
  std::stable_sort(terms.begin(), terms.end(),
                   [](double x, double y) { return std::abs(x) < std::abs(y); });
  return in_order(terms);
}

Eigen::VectorXd column(const Numbers& terms) {
  return Eigen::Map<const Eigen::VectorXd>(terms.data(), static_cast<Eigen::Index>(terms.size()));
}

void add_sum(hard_cases::Runner& runner) {
  runner.question("sum", [](const Case& c) {
    return Json{{"class", "a"}, {"sum", hex(sum_of(c.numbers("terms")))}};
  });
  const auto method = [&runner](const char* name, auto sum) {
    runner.method("sum", name, [sum](const Case& c, const Json& answer) {
      return close(sum(c.numbers("terms")), unhex(answer.at("sum")));
    });
  };
  method("recursive summation", in_order);
  method("smallest first", largest_last);
  method("compensated", [](const Numbers& terms) {
    const Eigen::VectorXd x = column(terms);
    return contact::dot_compensated<double, Eigen::Dynamic>(x, Eigen::VectorXd::Ones(x.size()));
  });
  method("book", [](const Numbers& terms) {
    const Eigen::VectorXd x = column(terms);
    return contact::dot_accurately<double, Eigen::Dynamic>(x, Eigen::VectorXd::Ones(x.size()));
  });
}

// ---------------------------------------------------------------- dot products

void add_dot(hard_cases::Runner& runner) {
  runner.question("dot", [](const Case& c) {
    return Json{{"class", "a"},
                {"dot", hex(oracle::exact(c.vector("u")).dot(oracle::exact(c.vector("v"))))}};
  });
  const auto method = [&runner](const char* name, auto dot) {
    runner.method("dot", name, [dot](const Case& c, const Json& answer) {
      return close(dot(c.vector("u"), c.vector("v")), unhex(answer.at("dot")));
    });
  };
  method("recursive summation",
         [](const Vector& u, const Vector& v) { return contact::dot_recursive(u, v); });
  method("|u||v| cos θ, by way of |u − v|", [](const Vector& u, const Vector& v) {
    return (u.squaredNorm() + v.squaredNorm() - Vector(u - v).squaredNorm()) / 2;
  });
  method("compensated",
         [](const Vector& u, const Vector& v) { return contact::dot_compensated(u, v); });
  method("book", [](const Vector& u, const Vector& v) { return contact::dot_accurately(u, v); });
}

// ---------------------------------------------------------------- cross products

Vector fused_once(const Vector& u, const Vector& v) {
  return {std::fma(u.y(), v.z(), -(u.z() * v.y())), std::fma(u.z(), v.x(), -(u.x() * v.z())),
          std::fma(u.x(), v.y(), -(u.y() * v.x()))};
}
Vector kahan(const Vector& u, const Vector& v) {
  using contact::difference_of_products;
  return {difference_of_products(u.y(), v.z(), u.z(), v.y()),
          difference_of_products(u.z(), v.x(), u.x(), v.z()),
          difference_of_products(u.x(), v.y(), u.y(), v.x())};
}

void add_cross(hard_cases::Runner& runner) {
  runner.question("cross", [](const Case& c) {
    const oracle::Vector n = oracle::exact(c.vector("u")).cross(oracle::exact(c.vector("v")));
    return Json{{"class", "a"}, {"cross", {hex(n.x()), hex(n.y()), hex(n.z())}}};
  });
  const auto method = [&runner](const char* name, auto cross) {
    runner.method("cross", name, [cross](const Case& c, const Json& answer) {
      const Vector got = cross(c.vector("u"), c.vector("v"));
      for (int k = 0; k < 3; ++k) {
        if (!close(got[k], unhex(answer.at("cross").at(static_cast<std::size_t>(k))))) return false;
      }
      return true;
    });
  };
  method("as defined", [](const Vector& u, const Vector& v) { return contact::cross_plain(u, v); });
  method("fused once", fused_once);
  method("Kahan", kahan);
  method("book", [](const Vector& u, const Vector& v) { return contact::cross_accurately(u, v); });
}

// ---------------------------------------------------------------- sides

Vector2<double> point(const Case& c, const char* field) {
  const Numbers numbers = c.numbers(field);
  return {numbers.at(0), numbers.at(1)};
}
int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

void add_side(hard_cases::Runner& runner) {
  runner.question("side", [](const Case& c) {
    const auto exact = [&c](const char* field) {
      const Vector2<double> p = point(c, field);
      return contact::Vector2<Rational>(oracle::exact(p.x()), oracle::exact(p.y()));
    };
    return Json{{"class", "a"},
                {"side", oracle::sign(contact::orientation(exact("a"), exact("b"), exact("p")))}};
  });
  const auto method = [&runner](const char* name, auto side) {
    runner.method("side", name, [side](const Case& c, const Json& answer) {
      return side(point(c, "a"), point(c, "b"), point(c, "p")) == answer.at("side").get<int>();
    });
  };
  using Point = Vector2<double>;
  method("products first", [](const Point& a, const Point& b, const Point& p) {
    return sign(contact::orientation_expanded(a, b, p));
  });
  method("differences first", [](const Point& a, const Point& b, const Point& p) {
    return sign(contact::orientation(a, b, p));
  });
  method("differences first, zero below 1e-9", [](const Point& a, const Point& b, const Point& p) {
    const double left = contact::orientation(a, b, p);
    return std::abs(left) < 1e-9 ? 0 : sign(left);
  });
  method("book", [](const Point& a, const Point& b, const Point& p) {
    return contact::orient_2d_exactly(a, b, p);
  });
}

// ---------------------------------------------------------------- angles

void add_angle(hard_cases::Runner& runner) {
  runner.question("angle", [](const Case& c) {
    const oracle::Vector u = oracle::exact(c.vector("u"));
    const oracle::Vector v = oracle::exact(c.vector("v"));
    const oracle::Vector n = u.cross(v);
    const Rational sine_squared = n.dot(n);
    const Rational cosine = u.dot(v);
    // atan cannot tell an exact 0 or right angle by refining, so these are settled by algebra.
    if (sine_squared == 0 && cosine > 0) {
      return Json{{"class", "c"}, {"angle", hex(0.0)}};
    }
    const auto angle = oracle::nearest_value([&](unsigned bits) {
      const Interval half = Interval::pi(bits) * Interval(Rational(1) / 2, bits);
      if (cosine == 0) return half;
      if (sine_squared == 0) return Interval::pi(bits);
      const Interval acute = atan(sqrt(Interval(sine_squared, bits)) / Interval(abs(cosine), bits));
      return cosine > 0 ? acute : Interval::pi(bits) - acute;
    });
    return Json{{"class", "c"}, {"angle", hex(angle.value())}};
  });
  const auto method = [&runner](const char* name, auto angle) {
    runner.method("angle", name, [angle](const Case& c, const Json& answer) {
      return close(angle(c.vector("u"), c.vector("v")), unhex(answer.at("angle")));
    });
  };
  method("acos", [](const Vector& u, const Vector& v) {
    return std::acos(u.dot(v) / (u.norm() * v.norm()));
  });
  method("asin", [](const Vector& u, const Vector& v) {
    return std::asin(u.cross(v).norm() / (u.norm() * v.norm()));
  });
  method("atan2, products as defined",
         [](const Vector& u, const Vector& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); });
  method("book", [](const Vector& u, const Vector& v) { return *contact::angle_between(u, v); });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("00_vectors");
  add_sum(runner);
  add_dot(runner);
  add_cross(runner);
  add_side(runner);
  add_angle(runner);
  return runner.run(argc, argv);
}
