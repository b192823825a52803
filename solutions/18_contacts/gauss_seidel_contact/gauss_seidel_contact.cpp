#include "gauss_seidel_contact.hpp"

namespace exercise {

namespace {

// Moment of the normal about the centre of mass of a body.
double moment(const Body& body, const Contact& contact) {
  const Eigen::Vector2d arm = contact.point - body.position;
  return arm.x() * contact.normal.y() - arm.y() * contact.normal.x();
}

// The velocity of the point of contact on a body, along the normal.
double velocity_along(const Body& body, const Contact& contact) {
  return contact.normal.dot(body.velocity) + body.angular_velocity * moment(body, contact);
}

// An impulse along the normal at the point of contact.
void push(Body& body, const Contact& contact, double impulse) {
  body.velocity += contact.normal * (impulse * body.inverse_mass);
  body.angular_velocity += moment(body, contact) * impulse * body.inverse_inertia;
}

void visit(State& now, std::size_t k, const Contact& contact) {
  Body& a = now.bodies[static_cast<std::size_t>(contact.a)];
  Body& b = now.bodies[static_cast<std::size_t>(contact.b)];
  //? The velocity that the contact has now, after the visits before it.
  //? gap: normal_velocity(a, b, contact) - contact.min_velocity
  const double too_fast = normal_velocity(a, b, contact) - contact.min_velocity;
  //? The sum so far is clamped, and not what this visit adds.
  //? gap: now.impulses[k] - too_fast / inverse_effective_mass(a, b, contact)
  //? gap: std::max(sum, 0.0)
  const double sum = now.impulses[k] - too_fast / inverse_effective_mass(a, b, contact);
  const double clamped = std::max(sum, 0.0);
  //? The bodies have got the old sum already, and get the change at once.
  //? gap: clamped - now.impulses[k]
  const double change = clamped - now.impulses[k];
  push(a, contact, change);
  push(b, contact, -change);
  //? The next iteration needs the sum.
  now.impulses[k] = clamped;
}

}  // namespace

double normal_velocity(const Body& a, const Body& b, const Contact& contact) {
  //? Both bodies move and rotate.
  //? gap: velocity_along(a, contact) - velocity_along(b, contact)
  return velocity_along(a, contact) - velocity_along(b, contact);
}

double inverse_effective_mass(const Body& a, const Body& b, const Contact& contact) {
  //? The impulse accelerates both bodies apart, and so it does with the points of contact.
  //? gap: a.inverse_mass + b.inverse_mass
  const double moved = a.inverse_mass + b.inverse_mass;
  //? The moment of the normal counts twice: in the angular velocity, and in what that does to the
  //? point.
  //? gap: moment_a * moment_a * a.inverse_inertia
  //? gap: moment_b * moment_b * b.inverse_inertia
  const double moment_a = moment(a, contact);
  const double moment_b = moment(b, contact);
  return moved + moment_a * moment_a * a.inverse_inertia + moment_b * moment_b * b.inverse_inertia;
}

State after_iteration(const State& before, const std::vector<Contact>& contacts) {
  //? The contacts in the order of the list: each sees what the visits before it have done.
  //? gap: visit(now, k, contacts[k])
  State now = before;
  for (std::size_t k = 0; k < contacts.size(); ++k) visit(now, k, contacts[k]);
  return now;
}

}  // namespace exercise
