/// @file
/// Impacts with dry friction in a plane: what restitution means then, by Newton, Poisson and
/// Stronge, and two shortcuts.
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
/// A contact seen in the plane of its normal n and one tangent t: the velocity of A's point as seen
/// from B's, and how it answers to an impulse on A.
///
/// After an impulse (p_t, p_n) the slip is u_t + k_tt p_t + k_tn p_n, and the normal velocity
/// u_n + k_tn p_t + k_nn p_n. If k_tn is not 0, friction changes the normal velocity, and the
/// normal impulse the slip: that is where the laws part.
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
/// It is the whole contact only if nothing pushes the point out of that plane: if the bodies move
/// in the plane, and it is a plane of symmetry of both. In general the slip turns while it lasts,
/// and the impulse is the solution of a differential equation.
/// @param tangent unit vector, at right angles to the normal
template <Scalar S>
PlanarContact<S> planar_contact(const RigidBody<S>& a, const RigidBody<S>& b,
                                const ContactPoint<S>& at, const Vector3<S>& tangent) {
  const Vector3<S> u = velocity_at(a, at.point) - velocity_at(b, at.point);
  return {u.dot(tangent), normal_velocity(a, b, at), response<S>(a, b, at.point, tangent, tangent),
          response<S>(a, b, at.point, tangent, at.normal),
          response<S>(a, b, at.point, at.normal, at.normal)};
}
// [/planar-contact]

/// The state of an impact when so much impulse has passed.
template <Ring S>
struct ImpactPoint {
  S tangential = S(0);  ///< impulse so far along t, N·s
  S impulse = S(0);     ///< impulse so far along n, N·s
  S slip = S(0);        ///< m/s
  S normal = S(0);      ///< m/s
};

/// An impact from the first touch to the last, as points between which all grows evenly.
template <Ring S>
struct Impact {
  std::array<ImpactPoint<S>, 4> path{};  ///< first touch; where the slip stops; largest compression
  std::size_t count = 0;                 ///< how many of them there are
  /// The last touch.
  const ImpactPoint<S>& end() const { return path[count - 1]; }
};

namespace detail {

/// An impact under way. The normal impulse p grows as time does, and Coulomb's law holds at each
/// moment of it (Routh).
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
  /// Which way friction pushes, for each unit of normal impulse: against the slip with all of μ; if
  /// nothing slips, as hard as it takes to keep it so, if μ allows that; else the contact begins to
  /// slip, the way that the normal impulse pushes it.
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

  /// To where the normal velocity is 0: the largest compression.
  void compress() {
    for (;;) {
      const auto stop = until_stop();
      // Where friction presses the bodies together faster than the impulse parts them
      // (normal_rate_ not positive), the slip stops first: k_tt k_nn > k_tn².
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

  /// On from the largest compression, until `left(slope, speed)` more impulse has passed.
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
/// @warning With friction it can gain energy, since a slip that stops or turns changes what a unit
/// of normal impulse does, and the law looks at the two ends only.
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
/// An impact by Poisson's law: the normal impulse after the largest compression is e times that
/// before it.
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
/// An impact by Stronge's law: the normal impulse gives back e² of the work that it took to
/// compress.
///
/// So the normal part never brings energy, and friction takes some: the kinetic energy cannot grow.
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
    // u dp + ½ rate dp² = what is left of the work
    const S left = all - detail::normal_work(routh.impact(), turn, routh.impact().count - 1);
    if (!(left > S(0))) return S(0);
    return S(2) * left / (now.normal + std::sqrt(now.normal * now.normal + S(2) * rate * left));
  });
  return routh.impact();
}
// [/stronge]

// [joint]
/// The shortcut of Whittaker's time: Newton's law for the normal velocity, and one ratio of
/// impulses for the whole impact. If both points can end at rest along t with |p_t| ≤ μ p_n, they
/// do; if not, the impulse is μ p_n against the slip at the first touch.
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
/// The shortcut of many games: the normal impulse as if there were no friction, then a tangential
/// impulse that stops the slip, cut off at μ times the normal one.
///
/// @warning The second step changes the normal velocity that the first has set: it misses e unless
/// k_tn is 0, and the bodies may even go on closing.
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
/// What an impact does to the kinetic energy of both bodies: the impulse times the mean of the
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
