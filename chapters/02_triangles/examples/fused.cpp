// The effect of a fused multiply-add on a watertight test. The second version below is the first as
// a compiler that may contract products and sums compiles it; both are in float. Rays are shot at
// the shared edge of two triangles.
#include <cmath>
#include <contact/barycentric.hpp>
#include <contact/shapes.hpp>
#include <cstdint>
#include <cstdio>

using contact::Vector2;
using contact::Vector3;

namespace {

// [as-written]
float side_as_written(const Vector2<float>& p, const Vector2<float>& q) {
  return p.x() * q.y() - p.y() * q.x();
}
float shear_as_written(float x, float slope, float z) { return x - slope * z; }
// [/as-written]

// [contracted]
float side_contracted(const Vector2<float>& p, const Vector2<float>& q) {
  return std::fma(p.x(), q.y(), -(p.y() * q.x()));  // one product is rounded, the other is not
}
float shear_contracted(float x, float slope, float z) { return std::fma(-slope, z, x); }
// [/contracted]

/// The result of the three edge functions, without t: whether the ray from o along d passes a b c
/// on one side.
template <class Side, class Shear>
bool passes(const Vector3<float>& o, const Vector3<float>& d, const Vector3<float>& a,
            const Vector3<float>& b, const Vector3<float>& c, Side side, Shear shear) {
  const int z = contact::largest_dimension(d), x = (z + 1) % 3, y = (z + 2) % 3;
  const auto seen = [&](const Vector3<float>& corner) {
    const Vector3<float> p = corner - o;
    return Vector2<float>(shear(p[x], d[x] / d[z], p[z]), shear(p[y], d[y] / d[z], p[z]));
  };
  const Vector2<float> pa = seen(a), pb = seen(b), pc = seen(c);
  const float u = side(pb, pc), v = side(pc, pa), w = side(pa, pb);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

struct Random {
  std::uint64_t state = 1;
  float coordinate() {  // in [-1, 1)
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<float>(static_cast<std::int64_t>(state) >> 40) * 0x1p-23f;
  }
  Vector3<float> point() {
    const float x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }
};

}  // namespace

int main() {
  Random random;
  int rays = 0, lost_as_written = 0, lost_contracted = 0;
  while (rays < 100000) {
    const Vector3<float> o = random.point(), a = random.point(), b = random.point();
    const Vector3<float> c = random.point(), d = random.point();
    const Vector3<float> target = a + (0.5f + 0.4f * random.coordinate()) * (b - a);
    const Vector3<float> direction = target - o;
    const Vector3<double> across = (b - a).cast<double>().cross(direction.cast<double>());
    const double of_c = across.dot((c - a).cast<double>()),
                 of_d = across.dot((d - a).cast<double>());
    if (!(of_c > 0.01 && of_d < -0.01))
      continue;  // the other vertices are on either side of the edge: no gap
    ++rays;
    const auto lost = [&](auto side, auto shear) {
      return !passes(o, direction, a, b, c, side, shear) &&
             !passes(o, direction, b, a, d, side, shear);
    };
    lost_as_written += lost(side_as_written, shear_as_written);
    lost_contracted += lost(side_contracted, shear_contracted);
  }
  std::printf("of %d rays between two triangles, lost as written: %d, lost when contracted: %d\n",
              rays, lost_as_written, lost_contracted);
}
