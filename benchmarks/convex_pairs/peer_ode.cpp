// ODE: its contacts, of which one is asked for.
#include <ode/ode.h>

#include "peers.hpp"

namespace {

using peers::Kind;
using peers::Shape;

/// ODE is one for the whole program, and its shapes live as long.
dGeomID placed(const Shape& from) {
  static const int started = dInitODE2(0);
  static_cast<void>(started);
  const peers::Numbers& h = from.half_lengths;
  dGeomID made = nullptr;
  if (from.kind == Kind::sphere) made = dCreateSphere(nullptr, from.radius);
  if (from.kind == Kind::capsule) made = dCreateCapsule(nullptr, from.radius, 2 * h[2]);
  if (from.kind == Kind::box) made = dCreateBox(nullptr, 2 * h[0], 2 * h[1], 2 * h[2]);
  if (from.kind == Kind::cylinder) made = dCreateCylinder(nullptr, from.radius, 2 * h[2]);
  dMatrix3 turn{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) turn[4 * i + k] = from.axes[k][i];
  }
  dGeomSetPosition(made, from.centre[0], from.centre[1], from.centre[2]);
  dGeomSetRotation(made, turn);
  return made;
}

bool meet(dGeomID a, dGeomID b) {
  dContactGeom contact;
  return dCollide(a, b, 1 | CONTACTS_UNIMPORTANT, &contact, sizeof contact) > 0;
}

bool takes(Kind a, Kind b) {
  const auto known = [](Kind k) {
    return k == Kind::sphere || k == Kind::capsule || k == Kind::box || k == Kind::cylinder;
  };
  return known(a) && known(b);
}

}  // namespace

std::vector<peers::PairTest> peers::ode_pairs() { return {pair_test("ODE", takes, placed, meet)}; }
