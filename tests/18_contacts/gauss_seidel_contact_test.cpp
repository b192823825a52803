// Right answers come from exact arithmetic on the numbers as they are stored: an iteration divides
// by inverse effective masses only, so one common denominator is enough. The first questions of a
// test each bring one mistake to light that no question before did.
#include "gauss_seidel_contact.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

#include <18_contacts/iteration_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Body;
using exercise::Contact;
using exercise::State;
using iteration_with_mistakes::Way;
using Contacts = std::vector<Contact>;
using Vector = Eigen::Vector2d;

// ---------------------------------------------------------------- what is right

Exact exact_moment(const Body& body, const Contact& contact) {
  const Exact x = Exact(contact.point.x()) - Exact(body.position.x());
  const Exact y = Exact(contact.point.y()) - Exact(body.position.y());
  return x * Exact(contact.normal.y()) - y * Exact(contact.normal.x());
}

Exact exact_inverse_mass(const Body& body, const Contact& contact) {
  const Exact moment = exact_moment(body, contact);
  const Exact normal = Exact(contact.normal.x()) * Exact(contact.normal.x()) +
                       Exact(contact.normal.y()) * Exact(contact.normal.y());
  return Exact(body.inverse_mass) * normal + moment * moment * Exact(body.inverse_inertia);
}

/// Velocities and impulses, all over one denominator that is greater than 0.
struct ExactState {
  struct Motion {
    Exact x, y, turning;
  };
  std::vector<Motion> motions;
  std::vector<Exact> impulses;
  Exact denominator{1.0};

  explicit ExactState(const State& state) {
    for (const Body& body : state.bodies)
      motions.push_back(
          {Exact(body.velocity.x()), Exact(body.velocity.y()), Exact(body.angular_velocity)});
    for (const double impulse : state.impulses) impulses.emplace_back(impulse);
  }

  void multiply(const Exact& factor) {
    for (Motion& motion : motions) {
      motion.x *= factor;
      motion.y *= factor;
      motion.turning *= factor;
    }
    for (Exact& impulse : impulses) impulse *= factor;
    denominator *= factor;
  }
};

Exact along(const ExactState::Motion& motion, const Body& body, const Contact& contact) {
  return motion.x * Exact(contact.normal.x()) + motion.y * Exact(contact.normal.y()) +
         motion.turning * exact_moment(body, contact);
}

void push(ExactState::Motion& motion, const Body& body, const Contact& contact,
          const Exact& impulse) {
  const Exact mass(body.inverse_mass);
  motion.x += Exact(contact.normal.x()) * impulse * mass;
  motion.y += Exact(contact.normal.y()) * impulse * mass;
  motion.turning += exact_moment(body, contact) * impulse * Exact(body.inverse_inertia);
}

double right_velocity(const Body& a, const Body& b, const Contact& contact) {
  const ExactState state({{a, b}, {}});
  return rounded<double>(along(state.motions[0], a, contact) - along(state.motions[1], b, contact));
}

State right_iteration(const State& before, const Contacts& contacts) {
  ExactState now(before);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact& contact = contacts[k];
    const auto i = static_cast<std::size_t>(contact.a), j = static_cast<std::size_t>(contact.b);
    const Body &a = before.bodies[i], &b = before.bodies[j];
    const Exact mass = exact_inverse_mass(a, contact) + exact_inverse_mass(b, contact);
    const Exact excess = along(now.motions[i], a, contact) - along(now.motions[j], b, contact) -
                         Exact(contact.min_velocity) * now.denominator;
    now.multiply(mass);
    Exact change = Exact(0.0) - excess;
    if ((now.impulses[k] + change).sign() < 0) change = Exact(0.0) - now.impulses[k];
    now.impulses[k] += change;
    push(now.motions[i], a, contact, change);
    push(now.motions[j], b, contact, Exact(0.0) - change);
  }
  State after = before;
  const auto value = [&](const Exact& x) { return quotient<double>(x, now.denominator); };
  for (std::size_t i = 0; i < after.bodies.size(); ++i) {
    after.bodies[i].velocity = {value(now.motions[i].x), value(now.motions[i].y)};
    after.bodies[i].angular_velocity = value(now.motions[i].turning);
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) after.impulses[k] = value(now.impulses[k]);
  return after;
}

// ---------------------------------------------------------------- questions

double largest(const State& state) {
  double size = 1;
  for (const Body& body : state.bodies)
    size = std::max({size, body.velocity.cwiseAbs().maxCoeff(), std::abs(body.angular_velocity)});
  for (const double impulse : state.impulses) size = std::max(size, impulse);
  return size;
}

void check_velocity(const Body& a, const Body& b, const Contact& contact) {
  std::vector<Suspect<double>> suspects;
  const auto suspect = [&](std::string_view id, Way way) {
    suspects.push_back(
        {id, [&, way] { return iteration_with_mistakes::normal_velocity(a, b, contact, way); }});
  };
  suspect("contact-velocity-without-rotation", Way::no_rotation);
  suspect("contact-velocity-reversed", Way::from_b_to_a);
  suspect("contact-velocities-added", Way::added);
  suspect("angular-velocity-clockwise", Way::clockwise);
  suspect("lever-arm-from-the-origin", Way::from_origin);
  suspect("second-body-left-out", Way::a_alone);
  const auto size = [&](const Body& body) {
    const double arm = (contact.point - body.position).norm();
    return body.velocity.norm() + std::abs(body.angular_velocity) * arm;
  };
  ask("What is the normal velocity of the contact?")
      .given("a", a)
      .given("b", b)
      .given("contact", contact)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::normal_velocity(a, b, contact); })
      // Less than 16 roundings of numbers of this size.
      .close_to(right_velocity(a, b, contact), within(32 * 0x1p-53 * (size(a) + size(b))));
}

void check_mass(const Body& a, const Body& b, const Contact& contact) {
  std::vector<Suspect<double>> suspects;
  const auto suspect = [&](std::string_view id, Way way) {
    suspects.push_back(
        {id,
         [&, way] { return iteration_with_mistakes::inverse_effective_mass(a, b, contact, way); }});
  };
  suspect("effective-mass-without-rotation", Way::masses_alone);
  suspect("moment-of-the-normal-not-squared", Way::moment_once);
  suspect("lever-arm-for-the-moment", Way::whole_arm);
  suspect("effective-mass-of-one-body", Way::mass_of_a);
  suspect("inverse-masses-subtracted", Way::subtracted);
  suspect("effective-mass-not-inverted", Way::effective_mass);
  const double right =
      rounded<double>(exact_inverse_mass(a, contact) + exact_inverse_mass(b, contact));
  const auto size = [&](const Body& body) {
    const double arm = (contact.point - body.position).squaredNorm();
    return body.inverse_mass + arm * body.inverse_inertia;
  };
  ask("What is the inverse effective mass of the contact?")
      .given("a", a)
      .given("b", b)
      .given("contact", contact)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::inverse_effective_mass(a, b, contact); })
      .close_to(right, within(32 * 0x1p-53 * (size(a) + size(b))));
}

void check_iteration(const State& before, const Contacts& contacts) {
  const State right = right_iteration(before, contacts);
  std::vector<Suspect<State>> suspects;
  const auto suspect = [&](std::string_view id, Way way) {
    suspects.push_back(
        {id, [&, way] { return iteration_with_mistakes::after_iteration(before, contacts, way); }});
  };
  suspect("impulse-change-clamped", Way::change_clamped);
  suspect("velocities-of-before-the-iteration", Way::jacobi);
  suspect("whole-sum-applied-again", Way::sum_applied);
  suspect("sums-forgotten", Way::forgets);
  suspect("least-velocity-left-out", Way::no_least);
  suspect("least-velocity-with-the-wrong-sign", Way::min_added);
  suspect("second-body-not-pushed", Way::pushes_a_alone);
  suspect("both-bodies-pushed-alike", Way::same_direction);
  suspect("impulse-does-not-rotate", Way::no_turn);
  suspect("contacts-visited-backwards", Way::backwards);
  suspect("iteration-ends-at-separation", Way::ends_at_separation);
  suspect("sums-may-pull", Way::pulls);
  suspect("sums-not-kept", Way::not_kept);
  suspect("velocity-times-inverse-mass", Way::multiplied);
  // At most four visits of some 30 roundings. With lever arms up to 3 m and an inverse effective
  // mass k of at least 0.2/kg, a visit makes the errors of velocities at most 16 times as large:
  // the error of an impulse is 8/k times theirs, and turns a body by m i / (0.2 + m² i) < 1.6 of
  // that.
  ask("What is the state after one iteration?")
      .given("before", before)
      .given("contacts", contacts)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::after_iteration(before, contacts); })
      .close_to(right, within(0x1p-32 * std::max(largest(before), largest(right))));
}

bool is_body(const Body& body) {
  return body.inverse_mass >= 0 && body.inverse_inertia >= 0 && body.inverse_mass <= 2 &&
         body.inverse_inertia <= 2 && body.position.cwiseAbs().maxCoeff() <= 1 &&
         body.velocity.cwiseAbs().maxCoeff() <= 2 && std::abs(body.angular_velocity) <= 2;
}

bool is_pair(const Body& a, const Body& b, const Contact& contact) {
  return is_body(a) && is_body(b) && a.inverse_mass + b.inverse_mass >= 0.2 &&
         std::abs(contact.normal.norm() - 1) <= 1e-15 && contact.point.cwiseAbs().maxCoeff() <= 1 &&
         std::abs(contact.min_velocity) <= 1;
}

bool is_state(const State& before, const Contacts& contacts) {
  if (before.impulses.size() != contacts.size() || before.bodies.empty()) return false;
  const auto count = static_cast<int>(before.bodies.size());
  const auto small = [](double x) { return x >= 0 && x <= 1; };
  return std::all_of(before.bodies.begin(), before.bodies.end(), is_body) &&
         std::all_of(before.impulses.begin(), before.impulses.end(), small) &&
         std::all_of(contacts.begin(), contacts.end(), [&](const Contact& one) {
           if (one.a < 0 || one.b < 0 || one.a >= count || one.b >= count || one.a == one.b)
             return false;
           return is_pair(before.bodies[static_cast<std::size_t>(one.a)],
                          before.bodies[static_cast<std::size_t>(one.b)], one);
         });
}

// ---------------------------------------------------------------- scenes

const Body kFloor{0, 0, {0, 0}, {0, 0}, 0};
// A box of 2 m by 1 m that lies on the floor, y = 0.
const Body kBox{1, 2, {0, 0.5}, {0.5, -1}, 0};

Contact foot(double x, double min_velocity = 0) { return {1, 0, {x, 0}, {0, 1}, min_velocity}; }

/// A ball of a row along x, without rotation.
Body ball(double x, double inverse_mass, double velocity) {
  return {inverse_mass, 0, {x, 0}, {velocity, 0}, 0};
}

/// The contact of ball k with the next one.
Contact touch(int k) { return {k + 1, k, {k + 0.5, 0}, {1, 0}, 0}; }

}  // namespace

TEST_CASE("the normal velocity of points on both bodies") {
  check_velocity({1, 2, {1, 2}, {3, -1}, 2}, {2, 1, {5, 0}, {2, 2}, -3},
                 {0, 1, {2, 1}, {0.6, 0.8}, 0});
  check_velocity(kBox, kFloor, foot(1));
  check_velocity({1, 1, {0, 2}, {1, 1}, 4}, {1, 1, {0, 0}, {1, 1}, -4}, {0, 1, {0, 1}, {1, 0}, 1});
}

TEST_CASE("inverse masses and moments add up") {
  check_mass({1, 2, {1, 2}, {3, -1}, 2}, {2, 1, {5, 0}, {2, 2}, -3}, {0, 1, {2, 1}, {0.6, 0.8}, 0});
  check_mass(kBox, kFloor, foot(1));
  check_mass(kFloor, kBox, {0, 1, {-0.5, 0}, {0, -1}, 0});
}

TEST_CASE("one contact reaches its least velocity") {
  check_iteration({{kFloor, kBox}, {0.25}}, {foot(1)});
  check_iteration({{{0.5, 1, {0, 0}, {1, -1}, 2}, {1, 3, {2, 0}, {-2, 0.5}, 1}}, {0}},
                  {{1, 0, {0.75, 0.5}, {0.8, 0.6}, 0}});
  check_iteration({{kFloor, kBox}, {0}}, {foot(1, 0.5)});
  check_iteration({{kFloor, kBox}, {0}}, {});
}

TEST_CASE("a visit sees what the visits before it did") {
  check_iteration({{kFloor, kBox}, {0, 0}}, {foot(-1), foot(1)});
  check_iteration({{ball(0, 1, 4), ball(1, 1, 0), ball(2, 0.25, 0)}, {0, 0}}, {touch(0), touch(1)});
  check_iteration({{ball(0, 1, 4), ball(1, 1, 0), ball(2, 0.25, 0)}, {0, 0}}, {touch(1), touch(0)});
  check_iteration({{kFloor, ball(1, 1, -2)}, {0}}, {touch(0)});
}

TEST_CASE("a sum of impulses may become smaller, but not negative") {
  check_iteration({{kFloor, {1, 2, {0, 0.5}, {0, 0.25}, -1}}, {1, 1}}, {foot(-1), foot(0.5)});
  check_iteration({{kFloor, {1, 2, {0, 0.5}, {0, 3}, 0}}, {0.5, 0.25}}, {foot(-1), foot(1)});
  check_iteration({{kFloor, {1, 2, {0, 0.5}, {0, -1}, 2}}, {0, 0}}, {foot(1), foot(-1)});
}

TEST_CASE("the least velocity may be a bounce or the closing of a gap") {
  check_iteration({{kFloor, kBox}, {0, 0.5}}, {foot(-1, 1), foot(1, -0.25)});
  check_iteration({{kFloor, kBox}, {0, 0}}, {foot(-1, -2), foot(1, -2)});
}

TEST_CASE("random iterations agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size)};
  };
  const auto body = [&](bool fixed) {
    const double mass = random.uniform(0.2, 2), inertia = random.uniform(0.2, 2);
    const Vector position = vector(1), velocity = vector(2);
    const double turning = random.uniform(-2, 2);
    if (fixed) return Body{0, 0, position, {0, 0}, 0};
    return Body{mass, inertia, position, velocity, turning};
  };
  for (int asked = 0; asked < 100; ++asked) {
    State before{{body(random.chance(0.5)), body(false), body(false)}, {}};
    Contacts contacts;
    for (int count = random.integer(1, 4); count > 0; --count) {
      const int a = random.integer(0, 2), b = (a + random.integer(1, 2)) % 3;
      const Vector point = vector(1);
      Vector normal = vector(1);
      if (normal.norm() < 0.1) normal = {1, 0};
      contacts.push_back({a, b, point, normal.normalized(), random.uniform(-1, 1)});
      before.impulses.push_back(random.chance(0.3) ? 0 : random.uniform(0, 1));
    }
    const Contact& one = contacts[0];
    const Body& a = before.bodies[static_cast<std::size_t>(one.a)];
    const Body& b = before.bodies[static_cast<std::size_t>(one.b)];
    shrinkable(check_velocity, is_pair, a, b, one);
    shrinkable(check_mass, is_pair, a, b, one);
    shrinkable(check_iteration, is_state, before, contacts);
  }
}
