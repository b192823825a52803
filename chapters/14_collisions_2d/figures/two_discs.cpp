// Two smooth discs at the moment of contact: the axis, the components of the velocities, and the
// results of four methods.
#include <contact/disc_collision.hpp>
#include <contact/figure.hpp>

struct Input {
  contact::Vector2<double> centre_a, centre_b;  // m; the discs have half the distance for radius
  contact::Vector2<double> velocity_a;          // m/s
  contact::Vector2<double> velocity_b;
  double mass_a, mass_b;  // kg
  double restitution;
  double way;  // 0: the book's; 1: the lecture's steps, without the test for approach; 2: the whole
               // velocity reversed; 3: the book's with an axis that is not normalised
};

struct Output {
  double problem;
  double radius;
  contact::Vector2<double> touch;  // contact point
  contact::Vector2<double> axis;   // from B to A
  double normal_a, normal_b;       // normal components, m/s
  contact::Vector2<double> along_a, tangential_a, along_b, tangential_b;
  double approach;  // 1 if they approach
  contact::Vector2<double> after_a, after_b;
  contact::Vector2<double> impulse_a;                                          // on A, N·s
  contact::Vector2<double> p_a, p_b, p_before, p_a_after, p_b_after, p_after;  // kg·m/s
  double energy_before, energy_after;                                          // J
  double product_after;  // of the velocities afterwards: 0 if they are perpendicular
  double wrong;          // the chosen method does not give the book's velocities
  double a_stops;        // goal of a question: A was fast, and is almost at rest
};

using Vector = contact::Vector2<double>;

Output compute(const Input& in) {
  Output out{};
  for (const double x :
       {in.centre_a.x(), in.centre_a.y(), in.centre_b.x(), in.centre_b.y(), in.velocity_a.x(),
        in.velocity_a.y(), in.velocity_b.x(), in.velocity_b.y(), in.mass_a, in.mass_b}) {
    if (std::abs(x) > 1e100) out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && in.centre_a == in.centre_b) {
    out.problem = contact::figure::coincident_points;
  }
  if (out.problem == 0 && (!(in.mass_a > 0) || !(in.mass_b > 0))) {
    out.problem = contact::figure::not_positive;
  }
  if (out.problem == 0 && (in.mass_a < 1e-100 || in.mass_b < 1e-100)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem == 0 && in.restitution > 1) out.problem = contact::figure::too_large;
  if (out.problem == 0 && in.restitution < 0) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  out.radius = (in.centre_b - in.centre_a).norm() / 2;
  out.touch = (in.centre_a + in.centre_b) / 2;
  const auto a = contact::disc<double>(in.mass_a, out.radius, in.centre_a, in.velocity_a);
  const auto b = contact::disc<double>(in.mass_b, out.radius, in.centre_b, in.velocity_b);
  out.axis = *contact::line_of_centres(a.centre, b.centre);
  const auto parts_a = contact::components(a.velocity, out.axis);
  const auto parts_b = contact::components(b.velocity, out.axis);
  out.normal_a = parts_a.normal;
  out.normal_b = parts_b.normal;
  out.along_a = out.axis * parts_a.normal;
  out.along_b = out.axis * parts_b.normal;
  out.tangential_a = parts_a.tangential;
  out.tangential_b = parts_b.tangential;
  out.approach = contact::approaching(a, b) ? 1 : 0;

  const auto book = contact::collide_discs(a, b, in.restitution);
  auto after = book;
  // Step c of the lecture, with e and along any n.
  const auto step_c = [&](const Vector& n) {
    const double m = a.mass + b.mass;
    const double p = a.mass * n.dot(a.velocity) + b.mass * n.dot(b.velocity);
    const double w = in.restitution * n.dot(a.velocity - b.velocity);
    after.velocity_a = a.velocity + n * ((p - w * b.mass) / m - n.dot(a.velocity));
    after.velocity_b = b.velocity + n * ((p + w * a.mass) / m - n.dot(b.velocity));
  };
  if (in.way == 1) {
    // WRONG: no test for approach. It is right for discs that approach; for discs that separate it
    // reverses the normal components, so that they pass through each other.
    step_c(out.axis);
  } else if (in.way == 3 && out.approach == 1) {
    // WRONG: with an axis of length L each projection is L times too large, and used L times: the
    // impulse comes out L² times what it should be.
    step_c(a.centre - b.centre);
  } else if (in.way == 2) {
    // WRONG: the tangential components are reversed too, although no force acts there; and the
    // masses and the other velocity do not matter, so that momentum is not conserved.
    after.velocity_a = -in.restitution * a.velocity;
    after.velocity_b = -in.restitution * b.velocity;
  }
  out.after_a = after.velocity_a;
  out.after_b = after.velocity_b;
  out.impulse_a = in.mass_a * (after.velocity_a - a.velocity);
  out.p_a = in.mass_a * a.velocity;
  out.p_b = in.mass_b * b.velocity;
  out.p_before = out.p_a + out.p_b;
  out.p_a_after = in.mass_a * after.velocity_a;
  out.p_b_after = in.mass_b * after.velocity_b;
  out.p_after = out.p_a_after + out.p_b_after;
  out.energy_before = contact::kinetic_energy(a) + contact::kinetic_energy(b);
  auto a_after = a;
  auto b_after = b;
  a_after.velocity = after.velocity_a;
  b_after.velocity = after.velocity_b;
  out.energy_after = contact::kinetic_energy(a_after) + contact::kinetic_energy(b_after);
  out.product_after = after.velocity_a.dot(after.velocity_b);
  const double speed = a.velocity.norm() + b.velocity.norm();
  out.wrong = (after.velocity_a - book.velocity_a).norm() > 1e-9 * speed ||
                      (after.velocity_b - book.velocity_b).norm() > 1e-9 * speed
                  ? 1
                  : 0;
  out.a_stops = in.way == 0 && a.velocity.norm() >= 1 && after.velocity_a.norm() <= 0.2 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(centre_a, centre_b, velocity_a, velocity_b, mass_a, mass_b, restitution, way),
       Output,
       FIELDS(problem, radius, touch, axis, normal_a, normal_b, along_a, tangential_a, along_b,
              tangential_b, approach, after_a, after_b, impulse_a, p_a, p_b, p_before, p_a_after,
              p_b_after, p_after, energy_before, energy_after, product_after, wrong, a_stops))
