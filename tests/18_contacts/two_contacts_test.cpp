// Right answers come from exact arithmetic on the numbers as they are stored. The first questions
// of a test each bring one mistake to light that no question before did.
#include "two_contacts.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

#include <18_contacts/two_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using two_with_mistakes::MatrixWay;
using two_with_mistakes::Way;
using Matrix = Eigen::Matrix2d;
using Vector = Eigen::Vector2d;

// ---------------------------------------------------------------- what is right

/// x₀ and x₁ over one denominator.
struct Impulses {
  Exact first, second, denominator;
};

/// The only one of the four cases that meets all conditions.
Impulses right_impulses(const Matrix& a, const Vector& b) {
  const Exact a00(a(0, 0)), a01(a(0, 1)), a11(a(1, 1)), b0(b(0)), b1(b(1));
  if (b0.sign() >= 0 && b1.sign() >= 0) return {Exact(0.0), Exact(0.0), Exact(1.0)};
  if (b0.sign() <= 0 && (a00 * b1 - a01 * b0).sign() >= 0) return {-b0, Exact(0.0), a00};
  if (b1.sign() <= 0 && (a11 * b0 - a01 * b1).sign() >= 0) return {Exact(0.0), -b1, a11};
  return {a01 * b1 - a11 * b0, a01 * b0 - a00 * b1, a00 * a11 - a01 * a01};
}

// ---------------------------------------------------------------- questions

void check_matrix(double mass, double inertia, const Vector& lever_arms) {
  std::vector<Suspect<Matrix>> suspects;
  // A hint must be true of the answer in hand: these are asked only where it is.
  const auto suspect = [&](std::string_view id, MatrixWay way, bool where = true) {
    if (!where) return;
    suspects.push_back({id, [&, way] {
                          return two_with_mistakes::inverse_effective_masses(mass, inertia,
                                                                             lever_arms, way);
                        }});
  };
  suspect("contacts-without-rotation", MatrixWay::no_rotation);
  suspect("contacts-not-coupled", MatrixWay::not_coupled);
  suspect("arms-without-their-sides", MatrixWay::no_sign, lever_arms(0) * lever_arms(1) < 0);
  suspect("coupling-by-rotation-reversed", MatrixWay::subtracted);
  suspect("coupling-without-rotation", MatrixWay::own_arm_only);
  suspect("distance-between-the-contacts", MatrixWay::between);
  suspect("rotation-times-the-inertia", MatrixWay::inertia_above);
  suspect("mass-for-its-inverse", MatrixWay::mass);
  suspect("effective-masses-for-inverses", MatrixWay::inverted);
  Matrix right, bound;
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2; ++k) {
      const Exact product = Exact(lever_arms(i)) * Exact(lever_arms(k));
      right(i, k) =
          quotient<double>(Exact(inertia) + Exact(mass) * product, Exact(mass) * Exact(inertia));
      // Two quotients, a product and a sum.
      bound(i, k) = 8 * 0x1p-53 * (1 / mass + std::abs(lever_arms(i) * lever_arms(k)) / inertia);
    }
  }
  ask("How do the velocities of the contacts change with the impulses?")
      .given("mass", mass)
      .given("inertia", inertia)
      .given("lever_arms", lever_arms)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::inverse_effective_masses(mass, inertia, lever_arms); })
      .close_to(right, within(bound));
}

void check_impulses(const Matrix& a, const Vector& b) {
  const Impulses exact = right_impulses(a, b);
  const Vector right{quotient<double>(exact.first, exact.denominator),
                     quotient<double>(exact.second, exact.denominator)};
  std::vector<Suspect<Vector>> suspects;
  const auto suspect = [&](std::string_view id, Way way, bool where = true) {
    if (!where) return;
    suspects.push_back({id, [&, way] { return two_with_mistakes::impulses(a, b, way); }});
  };
  const bool closing = b(0) < 0 || b(1) < 0;
  const bool both = right(0) > 0 && right(1) > 0;
  suspect("each-contact-as-if-alone", Way::alone, closing);
  suspect("one-contact-after-the-other", Way::second_after, closing);
  suspect("one-contact-after-the-other", Way::first_after, closing);
  suspect("impulse-shared-by-the-contacts", Way::shared, closing);
  suspect("one-contact-for-both", Way::fastest, closing);
  suspect("mean-of-the-contacts", Way::mean, b.sum() < 0);
  suspect("second-contact-pulls", Way::pulls, !both);
  suspect("negative-impulse-set-to-zero", Way::cut, !both);
  suspect("separating-contact-left-out", Way::separating_left, closing);
  suspect("other-contact-not-verified", Way::not_verified, closing);
  suspect("coupling-with-the-wrong-sign", Way::coupling_sign, both);
  suspect("determinant-as-a-sum", Way::determinant_sum, both);
  suspect("impulses-for-separation", Way::plus_b);
  suspect("impulse-times-the-inverse-mass", Way::multiplied, closing);
  // Each term of Cramer's rule is off by 2 u of the products, and the determinant by as much; where
  // a rounded sign leads to another case, its numbers are as near to these.
  const double products = a(0, 0) * a(1, 1) + a(0, 1) * a(0, 1);
  const double determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
  const double condition = products / determinant;
  const double worst = (a.cwiseAbs().maxCoeff() * b.cwiseAbs().sum()) / determinant;
  ask("What are the impulses of the two contacts?")
      .given("a", a)
      .given("b", b)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::impulses(a, b); })
      .close_to(right, within(64 * 0x1p-53 * condition * worst));
}

bool is_body(double mass, double inertia, const Vector& lever_arms) {
  const double size = lever_arms.cwiseAbs().maxCoeff();
  return mass > 0 && inertia > 0 && std::max({mass, inertia, size}) <= 100;
}

/// Whether the matrix is symmetric and far from singular.
bool is_clear(const Matrix& a, const Vector& b) {
  if (a(0, 1) != a(1, 0) || !(a(0, 0) > 0.01) || !(a(1, 1) > 0.01)) return false;
  if (std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) > 100) return false;
  return a(0, 1) * a(0, 1) <= 0.95 * a(0, 0) * a(1, 1);
}

Matrix symmetric(double first, double beside, double second) {
  Matrix a;
  a << first, beside, beside, second;
  return a;
}

}  // namespace

TEST_CASE("contacts on one side of the centre") {
  check_matrix(2, 4, {1, 3});
  check_matrix(4, 0.5, {-3, -0.25});
  check_matrix(1, 1, {0, 2});
}

TEST_CASE("contacts on opposite sides of the centre") {
  check_matrix(2, 4, {-1, 3});
  check_matrix(0.5, 2, {2, -1});
  check_matrix(1, 1, {-1, 1});
}

TEST_CASE("one contact approaches") {
  check_impulses(symmetric(4, 1, 2), {-5, 3});
  check_impulses(symmetric(4, 1, 2), {3, -5});
  check_impulses(symmetric(4, -1, 2), {-8, 3});
  check_impulses(symmetric(4, 1, 2), {-3, 5});
  check_impulses(symmetric(4, 1, 2), {5, -3});
  check_impulses(symmetric(4, 1, 2), {3, 5});
  check_impulses(symmetric(4, 1, 2), {0, 0});
}

TEST_CASE("both contacts are pushed") {
  check_impulses(symmetric(4, 1, 2), {-3, -5});
  check_impulses(symmetric(4, -1, 2), {-3, -5});
  check_impulses(symmetric(1, 0, 4), {-2, -1});
}

TEST_CASE("one impulse is enough for both") {
  check_impulses(symmetric(4, 3, 5), {-8, -2});
  check_impulses(symmetric(4, 3, 5), {-2, -8});
  check_impulses(symmetric(4, 2, 5), {-4, -2});
}

TEST_CASE("a contact that separates is pushed too") {
  check_impulses(symmetric(4, -3, 5), {-8, 2});
  check_impulses(symmetric(4, -3, 5), {2, -8});
  check_impulses(symmetric(4, -3, 5), {-8, 0});
  check_impulses(symmetric(4, -3, 5), {0.5, -0.5});
}

TEST_CASE("random bodies agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300;) {
    const double mass = random.uniform(0.5, 4), inertia = random.uniform(0.1, 4);
    const Vector lever_arms{random.uniform(-2, 2), random.uniform(-2, 2)};
    const double beside = 1 / mass + lever_arms(0) * lever_arms(1) / inertia;
    const Matrix a = symmetric(1 / mass + lever_arms(0) * lever_arms(0) / inertia, beside,
                               1 / mass + lever_arms(1) * lever_arms(1) / inertia);
    const Vector b{random.uniform(-3, 2), random.uniform(-3, 2)};
    if (!is_clear(a, b)) continue;
    ++asked;
    shrinkable(check_matrix, is_body, mass, inertia, lever_arms);
    shrinkable(check_impulses, is_clear, a, b);
  }
}
