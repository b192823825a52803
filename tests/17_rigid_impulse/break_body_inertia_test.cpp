// The right value rotates the torque into the axes of the body. Its error is some roundings, and
// the given code must be wrong by a tenth.
#include "break_body_inertia.hpp"
#include "effective_mass.hpp"

#include <numbers>
#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using exercise::Contact;
using Vector = Eigen::Vector3d;

Vector torque_in_world(const Contact& at) { return at.lever_arm.cross(at.normal); }

double right_value(const Contact& at) {
  const double angle = at.degrees * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  const Vector world = torque_in_world(at);
  const Vector body(c * world.x() + s * world.y(), c * world.y() - s * world.x(), world.z());
  return 1 + body.dot(body.cwiseQuotient(at.moments));
}

Judged judged(const Contact& at, double share) {
  const double given = given::inverse_effective_mass(at.moments, at.lever_arm, at.normal);
  const double right = right_value(at), off = std::abs(given - right) / right;
  return {off > share, contact::text_of(given), contact::text_of(right),
          "The relative error is " + contact::text_of(off, {.digits = 2}) + "."};
}

bool is_body(const Vector& moments) {
  return moments.minCoeff() >= 0.01 && moments.maxCoeff() <= 10 &&
         2 * moments.maxCoeff() <= moments.sum() * (1 + 1e-12);
}

bool along_an_axis(const Vector& normal) { return all_whole(normal) && normal.squaredNorm() == 1; }

BreakIt<Contact> question(std::string_view text) {
  return break_it<Contact>(text)
      .rule("every number is finite", all_finite<Contact>)
      .rule("the moments are from 0.01 to 10, and each is at most the sum of the other two",
            [](const Contact& at) { return is_body(at.moments); })
      .rule("no component of the lever arm is larger than 1 m",
            [](const Contact& at) { return all_within(at.lever_arm, 1); })
      .rule("the normal is a unit vector along an axis of the world",
            [](const Contact& at) { return along_an_axis(at.normal); })
      .rule("the rotation is at most 360 degrees",
            [](const Contact& at) { return std::abs(at.degrees) <= 360; })
      .suspect_if("break-no-torque",
                  [](const Contact& at) {
                    const Vector torque = torque_in_world(at);
                    return torque.x() == 0 && torque.y() == 0;
                  })
      .suspect_if("break-equal-moments",
                  [](const Contact& at) { return at.moments.x() == at.moments.y(); });
}

}  // namespace

TEST_CASE("the value is wrong by more than a half") {
  question("Which contact is wrong by more than a half?")
      .input("contact", [] { return exercise::wrong_by_half(); })
      .judge([](const Contact& at) { return judged(at, 0.5); });
}

TEST_CASE("it is wrong after a small rotation") {
  question("Which contact is wrong by 10 %, although the body is hardly rotated?")
      .rule("the rotation is at most 10 degrees",
            [](const Contact& at) { return std::abs(at.degrees) <= 10; })
      .input("contact", [] { return exercise::small_rotation(); })
      .judge([](const Contact& at) { return judged(at, 0.1); });
}

TEST_CASE("it is wrong for similar moments") {
  question("Which contact is wrong by 10 %, although the moments are similar?")
      .rule("the largest moment is at most twice the smallest",
            [](const Contact& at) { return at.moments.maxCoeff() <= 2 * at.moments.minCoeff(); })
      .input("contact", [] { return exercise::similar_moments(); })
      .judge([](const Contact& at) { return judged(at, 0.1); });
}
