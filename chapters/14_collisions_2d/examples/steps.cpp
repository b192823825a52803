// The lecture's steps a to d on discs that collide, and on the same discs a moment later, when they
// separate.
#include <cmath>
#include <contact/disc_collision.hpp>
#include <cstdio>

using Vector = contact::Vector2<double>;
using Disc = contact::Disc<double>;

// [steps]
/// Steps a to d as on the slide, without a test for approach.
void steps(Disc& a, Disc& b) {
  const Vector x_axis = (b.centre - a.centre).normalized();  // a
  const Vector u1x = x_axis * x_axis.dot(a.velocity);        // b
  const Vector u1y = a.velocity - u1x;
  const Vector u2x = -x_axis * (-x_axis).dot(b.velocity);
  const Vector u2y = b.velocity - u2x;
  const double m1 = a.mass;
  const double m2 = b.mass;
  const Vector v1x = (u1x * m1 + u2x * m2 - (u1x - u2x) * m2) / (m1 + m2);  // c
  const Vector v2x = (u1x * m1 + u2x * m2 - (u2x - u1x) * m1) / (m1 + m2);
  a.velocity = v1x + u1y;  // d
  b.velocity = v2x + u2y;
}
// [/steps]

void book(Disc& a, Disc& b) {
  const auto after = contact::collide_discs(a, b, 1.0);
  a.velocity = after.velocity_a;
  b.velocity = after.velocity_b;
}

int main() {
  const auto print = [](const char* name, const Disc& a, const Disc& b) {
    // Rounded to hundredths, so that 1e-16 does not print as −0.00.
    const auto tidy = [](double x) { return std::round(x * 100) / 100 + 0.0; };
    std::printf("%s A (%.2f, %.2f)  B (%.2f, %.2f)\n", name, tidy(a.velocity.x()),
                tidy(a.velocity.y()), tidy(b.velocity.x()), tidy(b.velocity.y()));
  };
  const auto a = contact::disc<double>(1, 0.5, {0, 0}, {5, 0});
  const auto b = contact::disc<double>(2, 0.5, {0.6, 0.8}, {0, 0});
  Disc a1 = a;
  Disc b1 = b;
  Disc a2 = a;
  Disc b2 = b;
  print("before:            ", a, b);
  steps(a1, b1);
  print("steps a to d:      ", a1, b1);
  steps(a1, b1);
  print("applied twice:     ", a1, b1);
  book(a2, b2);
  print("the book's:        ", a2, b2);
  book(a2, b2);
  print("applied twice:     ", a2, b2);
}
