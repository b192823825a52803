// Forces and damping ratios are compared in exact arithmetic. What the speed would be if the
// contact ended at zero force is the reference's closed form.
#include "pulling_damper.hpp"
#include "damped_contact.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>
#include <contact/spring_impact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Moment;

bool is_from(double x, double low, double high) { return x >= low && x <= high; }

// ---------------------------------------------------------------- a moment

/// The sign of k d + c ḋ.
int push_or_pull(const Moment& at) {
  return (Exact(at.stiffness) * Exact(at.penetration) + Exact(at.damping) * Exact(at.approach))
      .sign();
}

/// Whether ζ is at most 0.1: c² at most 4 k m / 100.
bool is_weak(const Moment& at) {
  return at.damping >= 0 && (Exact(25.0) * Exact(at.damping) * Exact(at.damping) -
                             Exact(at.stiffness) * Exact(at.mass))
                                    .sign() <= 0;
}

/// Whether ζ is at most 10: c² at most 400 k m. The steps of the given code are then stable.
bool is_at_most_ten_times_critical(const Moment& at) {
  return at.damping >= 0 && (Exact(at.damping) * Exact(at.damping) -
                             Exact(400.0) * Exact(at.stiffness) * Exact(at.mass))
                                    .sign() <= 0;
}

// ---------------------------------------------------------------- an impact

/// The speed after a contact that ends at zero force, over the speed before.
double share_at_zero_force(const Moment& start) {
  const contact::SpringDamper<double> spring{start.stiffness, start.damping};
  return contact::restitution_of_damping(contact::damping_ratio(spring, start.mass),
                                         contact::ContactRelease::at_zero_force);
}

double share_given(const Moment& start) { return given::rebound_speed(start) / start.approach; }

std::string percent(double share) {
  return contact::text_of(100 * share, {.digits = 3}) + " % of its speed";
}

BreakIt<Moment> impacts(std::string_view question) {
  return break_it<Moment>(question)
      .rule("every number is finite", [](const Moment& start) { return all_finite(start); })
      .rule("the stiffness is from 1 to 100,000 N/m",
            [](const Moment& start) { return is_from(start.stiffness, 1, 1e5); })
      .rule("the mass is from 0.01 to 100 kg",
            [](const Moment& start) { return is_from(start.mass, 0.01, 100); })
      .rule("the damping ratio is from 0 to 10", is_at_most_ten_times_critical)
      .rule("the penetration is 0", [](const Moment& start) { return start.penetration == 0; })
      .rule("the approach is from 0.01 to 10 m/s",
            [](const Moment& start) { return is_from(start.approach, 0.01, 10); });
}

Judged judged(const Moment& start, bool wrong) {
  const double given = share_given(start), right = share_at_zero_force(start);
  return {wrong, given > 0 ? "the body leaves with " + percent(given) : "the body does not leave",
          "the body leaves with " + percent(right),
          "The damping ratio is " +
              contact::text_of(
                  contact::damping_ratio(
                      contact::SpringDamper<double>{start.stiffness, start.damping}, start.mass),
                  {.digits = 3}) +
              "."};
}

}  // namespace

TEST_CASE("a weak damper pulls") {
  break_it<Moment>("When does a weak damper pull?")
      .rule("every number is finite", [](const Moment& at) { return all_finite(at); })
      .rule("the stiffness is from 1 to 100,000 N/m",
            [](const Moment& at) { return is_from(at.stiffness, 1, 1e5); })
      .rule("the mass is from 0.01 to 100 kg",
            [](const Moment& at) { return is_from(at.mass, 0.01, 100); })
      .rule("the damping ratio is from 0 to 0.1", is_weak)
      .rule("the overlap is from 0.001 to 1 m",
            [](const Moment& at) { return is_from(at.penetration, 0.001, 1); })
      .rule("the speed is at most 1 m/s",
            [](const Moment& at) { return is_from(at.approach, -1, 1); })
      .suspect_if("break-contact-has-no-damper", [](const Moment& at) { return at.damping == 0; })
      .suspect_if("break-surfaces-do-not-separate",
                  [](const Moment& at) { return at.approach >= 0; })
      .suspect_if("break-spring-outweighs-the-damper",
                  [](const Moment& at) { return push_or_pull(at) >= 0; })
      .input("moment", [] { return exercise::weak_damper_pulls(); })
      .judge([](const Moment& at) {
        const double force =
            given::contact_force(at.penetration, at.approach, at.stiffness, at.damping);
        return Judged{push_or_pull(at) < 0 && force < 0, contact::text_of(force) + " N",
                      push_or_pull(at) < 0 ? "no force" : contact::text_of(force) + " N",
                      "The spring exerts " +
                          contact::text_of(at.stiffness * at.penetration, {.digits = 3}) +
                          " N, and the damper " +
                          contact::text_of(at.damping * at.approach, {.digits = 3}) + " N."};
      });
}

TEST_CASE("a body that is pulled rebounds too slowly") {
  impacts("Which body rebounds too slowly?")
      .suspect_if(
          "break-pull-takes-little",
          [](const Moment& start) { return share_given(start) > share_at_zero_force(start) / 2; })
      .suspect_if("break-body-hardly-rebounds",
                  [](const Moment& start) { return share_given(start) < 0.05; })
      .input("start", [] { return exercise::rebounds_too_slowly(); })
      .judge([](const Moment& start) {
        const double share = share_given(start);
        return judged(start, share >= 0.05 && share <= share_at_zero_force(start) / 2);
      });
}

TEST_CASE("a body that is pulled never leaves") {
  impacts("Which body never leaves?")
      .suspect_if("break-body-leaves", [](const Moment& start) { return share_given(start) > 0; })
      .suspect_if("break-damper-is-too-strong",
                  [](const Moment& start) { return share_at_zero_force(start) < 0.12; })
      .input("start", [] { return exercise::never_lets_go(); })
      .judge([](const Moment& start) {
        return judged(start, share_given(start) == 0 && share_at_zero_force(start) >= 0.12);
      });
}
