// libccd: GJK and minkowski portal refinement over support functions. A radius is added to the
// support.
#include <ccd/ccd.h>

#include <cmath>

#include "peers.hpp"

namespace {

using peers::Kind;
using peers::Numbers;
using peers::Shape;

double dot(const Numbers& a, const Numbers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void add(Numbers& to, const Numbers& v, double times) {
  for (std::size_t i = 0; i < 3; ++i) to[i] += v[i] * times;
}

Numbers farthest(const Shape& s, const Numbers& n) {
  Numbers p = s.centre;
  const Numbers along{dot(s.axes[0], n), dot(s.axes[1], n), dot(s.axes[2], n)};
  const auto corner = [&](std::size_t i) {
    add(p, s.axes[i], along[i] < 0 ? -s.half_lengths[i] : s.half_lengths[i]);
  };
  switch (s.kind) {
    case Kind::sphere:
      break;
    case Kind::capsule:
      corner(2);
      break;
    case Kind::lozenge:
      corner(0), corner(1);
      break;
    case Kind::box:
      corner(0), corner(1), corner(2);
      break;
    case Kind::cylinder: {
      corner(2);
      const double across = std::hypot(along[0], along[1]);
      if (across > 0) {
        add(p, s.axes[0], s.radius * along[0] / across);
        add(p, s.axes[1], s.radius * along[1] / across);
      }
      return p;
    }
    case Kind::ellipsoid: {
      Numbers turned{};
      for (std::size_t i = 0; i < 3; ++i) turned[i] = along[i] * s.half_lengths[i];
      const double length = std::sqrt(dot(turned, turned));
      for (std::size_t i = 0; i < 3; ++i) add(p, s.axes[i], s.half_lengths[i] * turned[i] / length);
      return p;
    }
    default: {
      p = s.points[0];
      double most = dot(p, n);
      for (const Numbers& q : s.points) {
        const double here = dot(q, n);
        if (here > most) {
          most = here;
          p = q;
        }
      }
    }
  }
  if (s.radius > 0) add(p, n, s.radius / std::sqrt(dot(n, n)));
  return p;
}

void support(const void* body, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Numbers p = farthest(*static_cast<const Shape*>(body),
                             {direction->v[0], direction->v[1], direction->v[2]});
  ccdVec3Set(point, p[0], p[1], p[2]);
}
void centre(const void* body, ccd_vec3_t* point) {
  const auto& s = *static_cast<const Shape*>(body);
  Numbers p = s.centre;
  if (!s.points.empty()) {
    p = {};
    for (const Numbers& q : s.points) add(p, q, 1.0 / static_cast<double>(s.points.size()));
  }
  ccdVec3Set(point, p[0], p[1], p[2]);
}

ccd_t settings() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = centre;
  ccd.max_iterations = 100;
  return ccd;
}

Shape same(const Shape& s) { return s; }
bool any(Kind, Kind) { return true; }

}  // namespace

std::vector<peers::PairTest> peers::ccd_pairs() {
  return {pair_test("libccd, GJK", any, same,
                    [](const Shape& a, const Shape& b) {
                      const ccd_t ccd = settings();
                      return ccdGJKIntersect(&a, &b, &ccd) != 0;
                    }),
          pair_test("libccd, MPR", any, same, [](const Shape& a, const Shape& b) {
            const ccd_t ccd = settings();
            return ccdMPRIntersect(&a, &b, &ccd) != 0;
          })};
}
