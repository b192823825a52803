// What the box should do is the one motion that meets all conditions of the complementarity problem
// of two contacts. Of these boxes it is known in closed form, or one of four cases.
#include "one_by_one.hpp"
#include "single_pass.hpp"

#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using exercise::Box;
using given::Motion;

bool is_from(double x, double low, double high) { return x >= low && x <= high; }

double inertia_of(const Box& box) { return (box.width * box.width + box.height * box.height) / 12; }

/// The velocity of the point of the box that is x to the right of its centre.
double velocity_at(const Motion& motion, double x) {
  return motion.velocity + motion.angular_velocity * x;
}

double velocity_before(const Box& box, double x) { return box.velocity + box.angular_velocity * x; }

/// The larger of the two speeds of approach; not positive if none approaches.
double approach(const Box& box) {
  return -std::min(velocity_before(box, box.first), velocity_before(box, box.second));
}

/// The change of the velocity of one contact for an impulse of 1 N·s at the other one.
double coupling(const Box& box) { return 1 + box.first * box.second / inertia_of(box); }

/// Whether an impulse at one contact changes the velocity of the other by less than 2 % of what it
/// does to its own.
bool is_uncoupled(const Box& box) {
  const double arm = std::max(std::abs(box.first), std::abs(box.second));
  return std::abs(coupling(box)) < 0.02 * (1 + arm * arm / inertia_of(box));
}

Box exchanged(Box box) {
  std::swap(box.first, box.second);
  return box;
}

/// The impulses x ≥ 0 with w = a x + b ≥ 0 of which, for each contact, one is 0.
Motion right_motion(const Box& box) {
  const double inertia = inertia_of(box);
  const auto excess = [&](double x) {
    const double velocity = velocity_before(box, x);
    return velocity - std::max(-box.restitution * velocity, 0.0);
  };
  const double a = 1 + box.first * box.first / inertia, b = coupling(box);
  const double d = 1 + box.second * box.second / inertia;
  const double one = excess(box.first), two = excess(box.second);
  const auto after = [&](double first, double second) {
    return Motion{box.velocity + first + second,
                  box.angular_velocity + (box.first * first + box.second * second) / inertia};
  };
  if (one >= 0 && two >= 0) return after(0, 0);
  if (one < 0 && two - b * one / a >= 0) return after(-one / a, 0);
  if (two < 0 && one - b * two / d >= 0) return after(0, -two / d);
  const double determinant = a * d - b * b;
  return after((b * two - d * one) / determinant, (b * one - a * two) / determinant);
}

std::string text_of_motion(const Motion& motion) {
  return "velocity " + contact::text_of(motion.velocity, {.digits = 3}) +
         " m/s, angular velocity " + contact::text_of(motion.angular_velocity, {.digits = 3}) +
         " rad/s";
}

BreakIt<Box> boxes(std::string_view question) {
  return break_it<Box>(question)
      .rule("every number is finite", [](const Box& box) { return all_finite(box); })
      .rule("width and height are from 0.1 to 10 m",
            [](const Box& box) {
              return is_from(box.width, 0.1, 10) && is_from(box.height, 0.1, 10);
            })
      .rule("both contacts are on the lower edge",
            [](const Box& box) {
              return std::max(std::abs(box.first), std::abs(box.second)) <= box.width / 2;
            })
      .rule("the contacts are at least 0.1 m apart",
            [](const Box& box) { return std::abs(box.first - box.second) >= 0.1; })
      .rule("the velocity is at most 10 m/s, the angular velocity at most 100 rad/s",
            [](const Box& box) {
              return is_from(box.velocity, -10, 10) && is_from(box.angular_velocity, -100, 100);
            })
      .rule("the restitution is from 0 to 1",
            [](const Box& box) { return is_from(box.restitution, 0, 1); })
      .rule("a contact approaches with 0.1 m/s or more",
            [](const Box& box) { return approach(box) >= 0.1; });
}

bool does_not_rotate(const Box& box) { return box.angular_velocity == 0; }

// ---------------------------------------------------------------- order

double change_by_order(const Box& box) {
  return std::abs(given::one_by_one(box).angular_velocity -
                  given::one_by_one(exchanged(box)).angular_velocity);
}

// ---------------------------------------------------------------- closing

/// How fast the first contact still approaches.
double closing(const Box& box) { return -velocity_at(given::one_by_one(box), box.first); }

bool closes(const Box& box) { return closing(box) >= approach(box) / 4; }

/// Whether the first impulse leaves the second contact separating or at rest.
bool second_gets_nothing(const Box& box) {
  const Motion before{box.velocity, box.angular_velocity};
  const Motion between = given::after_contact(before, box.first, inertia_of(box), box.restitution);
  return velocity_at(between, box.second) >= 0;
}

/// Whether the box would do if it did not bounce.
bool closes_without_restitution(Box box) {
  box.restitution = 0;
  return closes(box);
}

// ---------------------------------------------------------------- energy

/// The part of the kinetic energy after the pass that is in the rotation.
double share_of_rotation(const Box& box) {
  const Motion after = given::one_by_one(box);
  const double rotation = inertia_of(box) * after.angular_velocity * after.angular_velocity;
  return rotation / (rotation + after.velocity * after.velocity);
}

}  // namespace

TEST_CASE("the order of the contacts decides") {
  boxes("For which box does the order decide?")
      .rule("the box does not rotate before the impact", does_not_rotate)
      .suspect_if("break-contacts-are-not-coupled", is_uncoupled)
      .suspect_if(
          "break-order-changes-little",
          [](const Box& box) { return change_by_order(box) < 0.1 * -box.velocity / box.width; })
      .input("box", [] { return exercise::order_decides(); })
      .judge([](const Box& box) {
        const Motion other = given::one_by_one(exchanged(box));
        return Judged{change_by_order(box) >= 0.1 * -box.velocity / box.width,
                      text_of_motion(given::one_by_one(box)), text_of_motion(right_motion(box)),
                      "With first and second exchanged, the given code returns " +
                          text_of_motion(other) + "."};
      });
}

TEST_CASE("a contact still approaches after the pass") {
  boxes("Of which box does a contact still approach?")
      .suspect_if("break-second-push-lifts-the-first",
                  [](const Box& box) { return coupling(box) >= 0; })
      .suspect_if("break-second-contact-gets-nothing", second_gets_nothing)
      .suspect_if("break-first-contact-has-bounced", closes_without_restitution)
      .suspect_if("break-closes-too-slowly", [](const Box& box) { return !closes(box); })
      .input("box", [] { return exercise::keeps_closing(); })
      .judge([](const Box& box) {
        const Motion after = given::one_by_one(box);
        const auto speed = [](double x) { return contact::text_of(x, {.digits = 3}) + " m/s"; };
        return Judged{closes(box), text_of_motion(after), text_of_motion(right_motion(box)),
                      "The larger speed of approach is " + speed(approach(box)) +
                          " before the pass. After it the velocities of the contacts are " +
                          speed(velocity_at(after, box.first)) + " and " +
                          speed(velocity_at(after, box.second)) + "."};
      });
}

TEST_CASE("the energy is right and the motion is not") {
  boxes("Which box rotates although its energy is right?")
      .rule("the box does not rotate before the impact", does_not_rotate)
      .rule("the restitution is 1", [](const Box& box) { return box.restitution == 1; })
      .rule("the contacts are equally far to the left and to the right",
            [](const Box& box) { return box.first == -box.second; })
      .suspect_if("break-contacts-are-not-coupled", is_uncoupled)
      .suspect_if("break-rotation-takes-little",
                  [](const Box& box) { return share_of_rotation(box) < 0.5; })
      .input("box", [] { return exercise::energy_is_right(); })
      .judge([](const Box& box) {
        return Judged{share_of_rotation(box) >= 0.5, text_of_motion(given::one_by_one(box)),
                      text_of_motion({-box.velocity, 0}),
                      "After the pass, " +
                          contact::text_of(100 * share_of_rotation(box), {.digits = 3}) +
                          " % of the kinetic energy is in the rotation."};
      });
}
