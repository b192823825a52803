/// @file
/// Planar impacts with dry friction: restitution by Newton, by Poisson and by Stronge, and two
/// shortcuts. None has tangential restitution: friction stops the slip and never drives it back.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>

#include <contact/rigid_impulse.hpp>
#include <contact/vector.hpp>

namespace contact {

// [planar-contact]
/// A contact in the plane of its normal n and one tangent t: the velocity of A's point relative to
/// B's, and the inverse effective mass, which says how an impulse on A changes it.
///
/// After an impulse (p_t, p_n) the slip is u_t + k_tt p_t + k_tn p_n, and the normal velocity
/// u_n + k_tn p_t + k_nn p_n. If k_tn is not 0, friction changes the normal velocity, and the
/// normal impulse the slip: then the laws of restitution differ.
template <Ring S>
struct PlanarContact {
  S slip = S(0);    ///< u_t, m/s
  S normal = S(0);  ///< u_n, m/s; negative: closing
  S k_tt = S(0);    ///< 1/kg, greater than 0
  S k_tn = S(0);    ///< 1/kg, with k_tn² < k_tt k_nn
  S k_nn = S(0);    ///< 1/kg, greater than 0
};

/// The contact of two bodies in the plane of its normal and a tangent.
///
/// It describes the contact completely only if the bodies move in that plane and it is a plane of
/// symmetry of both. In general the direction of the slip changes during the impact, and the
/// impulse is the solution of a differential equation.
/// @param tangent unit vector, perpendicular to the normal
template <Scalar S>
PlanarContact<S> planar_contact(const RigidBody<S>& a, const RigidBody<S>& b,
                                const ContactPoint<S>& at, const Vector3<S>& tangent) {
  const Vector3<S> u = velocity_at(a, at.point) - velocity_at(b, at.point);
  return {u.dot(tangent), normal_velocity(a, b, at),
          inverse_effective_mass<S>(a, b, at.point, tangent, tangent),
          inverse_effective_mass<S>(a, b, at.point, tangent, at.normal),
          inverse_effective_mass<S>(a, b, at.point, at.normal, at.normal)};
}
// [/planar-contact]

/// The state of an impact after some impulse.
template <Ring S>
struct ImpactPoint {
  S tangential = S(0);  ///< impulse so far along t, N·s
  S impulse = S(0);     ///< impulse so far along n, N·s
  S slip = S(0);        ///< m/s
  S normal = S(0);      ///< m/s
};

/// An impact from first to last touch, as points between which everything changes linearly.
template <Ring S>
struct Impact {
  std::array<ImpactPoint<S>, 4>
      path{};             ///< first touch; where the slip stops; greatest compression
  std::size_t count = 0;  ///< how many of them there are
  /// The last touch.
  const ImpactPoint<S>& end() const { return path[count - 1]; }
};

namespace detail {

/// An impact in progress, by Routh's method: the normal impulse p grows monotonically with time,
/// and Coulomb's law holds at each moment.
template <Scalar S>
class Routh {
 public:
  Routh(const PlanarContact<S>& contact, const S& friction)
      : contact_(contact), friction_(friction) {
    impact_.path[0] = {S(0), S(0), contact.slip, contact.normal};
    impact_.count = 1;
    choose();
  }

  // [routh]
  /// The friction for each unit of normal impulse: μ against the slip; without slip, what keeps the
  /// contact sticking, if that is at most μ; else the contact begins to slip in the direction in
  /// which the normal impulse drives it.
  void choose() {
    const auto& [u_t, u_n, k_tt, k_tn, k_nn] = contact_;
    const S& slip = now().slip;
    const S size = k_tn < S(0) ? S(-k_tn) : k_tn;
    if (slip != S(0)) {
      pull_ = slip > S(0) ? S(-friction_) : friction_;
    } else if (size <= friction_ * k_tt) {
      pull_ = -(k_tn / k_tt);
      slip_rate_ = S(0);
      normal_rate_ = k_nn + k_tn * pull_;
      return;
    } else {
      pull_ = k_tn > S(0) ? S(-friction_) : friction_;
    }
    slip_rate_ = k_tt * pull_ + k_tn;
    normal_rate_ = k_nn + k_tn * pull_;
  }
  // [/routh]

  /// How much normal impulse it takes until the slip stops; nothing if it does not.
  std::optional<S> until_stop() const {
    const S& slip = now().slip;
    if (slip == S(0) || slip_rate_ == S(0) || (slip > S(0)) == (slip_rate_ > S(0))) {
      return std::nullopt;
    }
    return -(slip / slip_rate_);
  }

  void advance(const S& by, bool stops) {
    ImpactPoint<S> next = now();
    next.tangential = next.tangential + pull_ * by;
    next.impulse = next.impulse + by;
    next.slip = stops ? S(0) : S(next.slip + slip_rate_ * by);
    next.normal = next.normal + normal_rate_ * by;
    impact_.path[impact_.count++] = next;
    if (stops) choose();
  }

  /// To greatest compression, where the normal velocity is 0.
  void compress() {
    for (;;) {
      const auto stop = until_stop();
      // Where friction closes the contact faster than the normal impulse opens it (normal_rate_ not
      // positive: jamming), the slip stops first, because k_tt k_nn > k_tn².
      if (normal_rate_ > S(0)) {
        const S by = -(now().normal / normal_rate_);
        if (!stop || by <= *stop) {
          advance(by, stop && by == *stop);
          impact_.path[impact_.count - 1].normal = S(0);
          return;
        }
      }
      if (!stop) return;  // no such contact: k_tn² is not below k_tt k_nn
      advance(*stop, true);
    }
  }

  /// On from greatest compression. `left(now, rate)` is the normal impulse that is still to come.
  template <class Left>
  void restitute(const Left& left) {
    for (;;) {
      const auto stop = until_stop();
      const S by = left(now(), normal_rate_);
      if (!stop || by <= *stop) {
        advance(by, false);
        return;
      }
      advance(*stop, true);
    }
  }

  const ImpactPoint<S>& now() const { return impact_.path[impact_.count - 1]; }
  const Impact<S>& impact() const { return impact_; }

 private:
  PlanarContact<S> contact_;
  S friction_;
  S pull_ = S(0);         // tangential impulse for each unit of normal impulse
  S slip_rate_ = S(0);    // change of the slip for the same
  S normal_rate_ = S(0);  // change of the normal velocity for the same
  Impact<S> impact_;
};

/// Work of the normal impulse, ∫ u_n dp, between two points of the path.
template <Scalar S>
S normal_work(const Impact<S>& impact, std::size_t from, std::size_t to) {
  S work(0);
  for (std::size_t i = from; i < to; ++i) {
    const auto& a = impact.path[i];
    const auto& b = impact.path[i + 1];
    work = work + (a.normal + b.normal) * (b.impulse - a.impulse) / S(2);
  }
  return work;
}

}  // namespace detail

// [newton]
/// An impact by Newton's law: the normal velocity afterwards is −e times that before.
///
/// @warning With friction it can gain energy: where the slip stops or reverses, the effect of a
/// unit of normal impulse changes, and the law considers only the beginning and the end.
/// @param contact closing; if it is not, the impact ends as it begins
/// @param e coefficient of restitution, from 0 to 1
/// @param friction coefficient μ, not negative
template <Scalar S>
Impact<S> newton_impact(const PlanarContact<S>& contact, const S& e, const S& friction) {
  detail::Routh<S> routh(contact, friction);
  if (!(contact.normal < S(0))) return routh.impact();
  routh.compress();
  routh.restitute([&](const ImpactPoint<S>& now, const S& rate) {
    return S((-(e * contact.normal) - now.normal) / rate);
  });
  return routh.impact();
}
// [/newton]

// [poisson]
/// An impact by Poisson's law: the normal impulse after greatest compression is e times that before
/// it.
/// @param contact, e, friction as in newton_impact()
template <Scalar S>
Impact<S> poisson_impact(const PlanarContact<S>& contact, const S& e, const S& friction) {
  detail::Routh<S> routh(contact, friction);
  if (!(contact.normal < S(0))) return routh.impact();
  routh.compress();
  const S whole = (S(1) + e) * routh.now().impulse;
  routh.restitute([&](const ImpactPoint<S>& now, const S&) { return S(whole - now.impulse); });
  return routh.impact();
}
// [/poisson]

// [stronge]
/// An impact by Stronge's law: during restitution the normal impulse gives back e² of the work that
/// it absorbed during compression.
///
/// So for e from 0 to 1 the normal impulse adds no energy in all, and friction dissipates: the
/// kinetic energy does not grow.
/// @param contact, e, friction as in newton_impact()
/// @see Stronge, *Rigid body collisions with friction*, Proceedings of the Royal Society A 431
/// (1990)
template <std::floating_point S>
Impact<S> stronge_impact(const PlanarContact<S>& contact, const S& e, const S& friction) {
  detail::Routh<S> routh(contact, friction);
  if (!(contact.normal < S(0))) return routh.impact();
  routh.compress();
  const std::size_t turn = routh.impact().count - 1;
  const S all = -e * e * detail::normal_work(routh.impact(), 0, turn);
  routh.restitute([&](const ImpactPoint<S>& now, const S& rate) {
    // u dp + ½ rate dp² = the work still to be given back
    const S left = all - detail::normal_work(routh.impact(), turn, routh.impact().count - 1);
    if (!(left > S(0))) return S(0);
    return S(2) * left / (now.normal + std::sqrt(now.normal * now.normal + S(2) * rate * left));
  });
  return routh.impact();
}
// [/stronge]

// [joint]
/// The shortcut of Whittaker's textbook: Newton's law for the normal velocity, and one ratio of
/// impulses for the whole impact. If the slip can end at 0 with |p_t| ≤ μ p_n, it does; if not, the
/// tangential impulse is μ p_n against the initial slip.
///
/// @warning It can gain energy, more than newton_impact(): Kane and Levinson's double pendulum.
/// @param contact, e, friction as in newton_impact()
/// @return path of two points, or nothing if neither of the two is possible
template <Scalar S>
std::optional<Impact<S>> joint_impact(const PlanarContact<S>& contact, const S& e,
                                      const S& friction) {
  Impact<S> impact;
  impact.path[0] = {S(0), S(0), contact.slip, contact.normal};
  impact.count = 1;
  if (!(contact.normal < S(0))) return impact;
  const auto& [u_t, u_n, k_tt, k_tn, k_nn] = contact;
  const S leave = -(e * u_n);
  const S rise = leave - u_n;
  const S det = k_tt * k_nn - k_tn * k_tn;
  const S p_n = (k_tt * rise + k_tn * u_t) / det;
  const S p_t = -((k_nn * u_t + k_tn * rise) / det);
  impact.count = 2;
  if (p_n >= S(0) && p_t <= friction * p_n && -(friction * p_n) <= p_t) {
    impact.path[1] = {p_t, p_n, S(0), leave};
    return impact;
  }
  const S pull = u_t > S(0) ? S(-friction) : friction;
  const S rate = k_nn + k_tn * pull;
  if (u_t == S(0) || !(S(0) < rate)) return std::nullopt;
  const S p = rise / rate;
  impact.path[1] = {pull * p, p, u_t + (k_tt * pull + k_tn) * p, leave};
  return impact;
}
// [/joint]

// [clamped]
/// The shortcut of many games: the normal impulse without friction, then a tangential impulse that
/// stops the slip, clamped at μ times the normal one.
///
/// @warning The second step changes the normal velocity that the first has set: the result misses e
/// unless k_tn is 0, and the bodies may even go on closing.
/// @param contact, e, friction as in newton_impact()
/// @return path of three points: first touch, after the normal impulse, after the tangential one
template <Scalar S>
Impact<S> clamped_impact(const PlanarContact<S>& contact, const S& e, const S& friction) {
  Impact<S> impact;
  impact.path[0] = {S(0), S(0), contact.slip, contact.normal};
  impact.count = 1;
  if (!(contact.normal < S(0))) return impact;
  const auto& [u_t, u_n, k_tt, k_tn, k_nn] = contact;
  const S p_n = -((S(1) + e) * u_n) / k_nn;
  const S slip = u_t + k_tn * p_n;
  const S most = friction * p_n;
  S p_t = -(slip / k_tt);
  if (p_t > most) p_t = most;
  if (p_t < -most) p_t = -most;
  impact.path[1] = {S(0), p_n, slip, -(e * u_n)};
  impact.path[2] = {p_t, p_n, slip + k_tt * p_t, S(-(e * u_n)) + k_tn * p_t};
  impact.count = 3;
  return impact;
}
// [/clamped]

// [energy]
/// The change of the kinetic energy of both bodies: the impulse times the mean of the relative
/// velocities before and after, p · (u + u')/2.
/// @return J; negative if energy is lost
template <Scalar S>
S energy_change(const Impact<S>& impact) {
  const auto& before = impact.path[0];
  const auto& after = impact.end();
  return ((before.slip + after.slip) * after.tangential +
          (before.normal + after.normal) * after.impulse) /
         S(2);
}
// [/energy]

}  // namespace contact
