// The end of a rod meets a rough floor: five laws of impact, in the plane of the tangential and the
// normal impulse.
#include <contact/figure.hpp>
#include <contact/impact_friction.hpp>

using Plane = Eigen::Vector2d;
using Vector = contact::Vector3<double>;

struct Input {
  Plane top;                // upper end of the rod; the lower one is at the origin, on the floor, m
  Plane tip;                // velocity of the lower end, m/s
  double angular_velocity;  // rad/s
  double friction;          // μ
  double e;
  double law;  // 0 Newton, 1 Poisson, 2 Stronge, 3 joint, 4 clamped
};

struct Output {
  double problem;
  Plane centre, velocity;           // of the centre of mass, before
  double k_tt, k_tn, k_nn;          // inverse effective mass, 1/kg; the rod has 1 kg
  std::array<double, 4> along, up;  // the path of the impulse; its last point repeated
  Plane tip_after;                  // velocity of the lower end afterwards
  Plane velocity_after;             // of the centre of mass
  double angular_velocity_after;
  double asked, got;             // e, and −u_n'/u_n
  std::array<double, 5> energy;  // after over before, for each law; 0: no answer
  std::array<double, 5> end_along, end_up;
  Plane stop_from, stop_to;  // two points of the line on which the slip is 0
  Plane turn_from, turn_to;  // and of that on which the normal velocity is 0
  double stops, turns;       // whether the slip stops, and reverses
  double gains;              // goal of a question
};

Output compute(const Input& in) {
  Output out{};
  const double length = std::sqrt(in.top.dot(in.top));
  if (!(length > 0) || !(in.friction >= 0) || !(in.e >= 0)) {
    out.problem = contact::figure::not_positive;
  }
  for (const double x :
       {in.top.x(), in.top.y(), in.tip.x(), in.tip.y(), in.angular_velocity, in.friction, in.e}) {
    if (std::abs(x) > 1e30) out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && length < 1e-3) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  out.centre = in.top / 2;
  const double inertia = contact::rod_inertia<double>(1, length);
  const Vector angular_velocity(0, 0, in.angular_velocity);
  const Vector r(-out.centre.x(), -out.centre.y(), 0);  // from the centre to the floor
  const Vector v = Vector(in.tip.x(), in.tip.y(), 0) - Vector(angular_velocity.cross(r));
  out.velocity = {v.x(), v.y()};
  const Vector zero(0, 0, 0);
  const auto rod =
      contact::rigid_body<double>(1, contact::detail::diagonal<double>(inertia, inertia, inertia),
                                  Vector(-r), v, angular_velocity);
  const auto floor = contact::immovable<double>(zero, zero, zero);
  const auto c = contact::planar_contact<double>(rod, floor, {zero, {0, 1, 0}}, {1, 0, 0});
  out.k_tt = c.k_tt;
  out.k_tn = c.k_tn;
  out.k_nn = c.k_nn;

  const double before = contact::kinetic_energy(rod);
  const auto joint = contact::joint_impact(c, in.e, in.friction);
  const std::array<contact::Impact<double>, 5> impacts{
      contact::newton_impact(c, in.e, in.friction), contact::poisson_impact(c, in.e, in.friction),
      contact::stronge_impact(c, in.e, in.friction),
      joint ? *joint : contact::Impact<double>{{}, 1},
      contact::clamped_impact(c, in.e, in.friction)};
  for (std::size_t k = 0; k < 5; ++k) {
    const auto& impact = impacts[k];
    out.end_along[k] = impact.end().tangential;
    out.end_up[k] = impact.end().impulse;
    const bool answered = k != 3 || joint;
    out.energy[k] = before > 0 && answered ? 1 + contact::energy_change(impact) / before : 0;
  }
  const auto chosen =
      static_cast<std::size_t>(in.law >= 0 && in.law <= 4 ? std::nearbyint(in.law) : 0);
  const auto& impact = impacts[chosen];
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& point = impact.path[k < impact.count ? k : impact.count - 1];
    out.along[k] = point.tangential;
    out.up[k] = point.impulse;
  }
  for (std::size_t k = 1; k < impact.count; ++k) {
    if (c.slip != 0 && impact.path[k].slip == 0) out.stops = 1;
    if (c.slip * impact.path[k].slip < 0) out.turns = 1;
  }
  const auto after =
      contact::after_impulse<double>(rod, {impact.end().tangential, impact.end().impulse, 0}, zero);
  const Vector tip = contact::velocity_at(after, zero);
  out.tip_after = {tip.x(), tip.y()};
  out.velocity_after = {after.velocity.x(), after.velocity.y()};
  out.angular_velocity_after = after.angular_velocity.z();
  out.asked = in.e;
  out.got = c.normal < 0 ? -tip.y() / c.normal : 0;
  // u_t + k_tt p_t + k_tn p_n = 0 and u_n + k_tn p_t + k_nn p_n = 0, from p_n = 0 to 3 and along.
  const auto on_stop = [&](double p) { return Plane(-(c.slip + c.k_tn * p) / c.k_tt, p); };
  out.stop_from = on_stop(0);
  out.stop_to = on_stop(3);
  const auto on_turn = [&](double p) { return Plane(p, -(c.normal + c.k_tn * p) / c.k_nn); };
  out.turn_from = on_turn(-2);
  out.turn_to = on_turn(2);
  out.gains = in.e <= 1 && (chosen == 0 || chosen == 3) && out.energy[chosen] >= 1.3;
  return out;
}

FIGURE(Input, FIELDS(top, tip, angular_velocity, friction, e, law), Output,
       FIELDS(problem, centre, velocity, k_tt, k_tn, k_nn, along, up, tip_after, velocity_after,
              angular_velocity_after, asked, got, energy, end_along, end_up, stop_from, stop_to,
              turn_from, turn_to, stops, turns, gains))
