// Box3D: the distance of two sets of points with radii by GJK, in float.
#include <box3d/box3d.h>

#include "peers.hpp"

namespace {

using peers::Kind;
using peers::Shape;

struct Cloud {
  std::vector<b3Vec3> points;
  float radius = 0;
};

b3Vec3 vector(const peers::Numbers& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

Cloud cloud_of(const Shape& from) {
  Cloud made{{}, static_cast<float>(from.radius)};
  for (const auto& p : from.points) made.points.push_back(vector(p));
  if (!from.points.empty()) return made;
  const bool first = from.kind == Kind::box || from.kind == Kind::lozenge;
  const bool third = from.kind == Kind::box || from.kind == Kind::capsule;
  for (int k = 0; k < 8; ++k) {
    if ((!first && (k & 3) != 0) || (!third && (k & 4) != 0)) continue;
    peers::Numbers p = from.centre;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i < 2 ? !first : !third) continue;
      const double h = (k >> i & 1) != 0 ? from.half_lengths[i] : -from.half_lengths[i];
      for (std::size_t c = 0; c < 3; ++c) p[c] += from.axes[i][c] * h;
    }
    made.points.push_back(vector(p));
  }
  return made;
}

peers::Witness measure(const Cloud& a, const Cloud& b) {
  b3DistanceInput input{};
  input.proxyA = {a.points.data(), static_cast<int>(a.points.size()), a.radius};
  input.proxyB = {b.points.data(), static_cast<int>(b.points.size()), b.radius};
  input.transform = b3Transform_identity;
  input.useRadii = true;
  b3SimplexCache cache{};
  const b3DistanceOutput found = b3ShapeDistance(&input, &cache, nullptr, 0);
  return {found.distance > 0, found.distance, {-found.normal.x, -found.normal.y, -found.normal.z}};
}
bool meet(const Cloud& a, const Cloud& b) { return !(measure(a, b).distance > 0); }

bool takes(Kind a, Kind b) {
  const auto round = [](Kind k) { return k == Kind::cylinder || k == Kind::ellipsoid; };
  return !round(a) && !round(b);
}

}  // namespace

std::vector<peers::PairTest> peers::box3d_pairs() {
  return {pair_test("Box3D, GJK in float", takes, cloud_of, meet, measure)};
}
