// How pairs of bodies lie to each other, and whether the proof passes its check.
#include <cmath>
#include <contact/certificates.hpp>
#include <contact/convex_bodies.hpp>
#include <contact/proximity.hpp>
#include <cstdio>

namespace {

using contact::Proximity;
using contact::Vector3;

const char* name_of(Proximity state) {
  switch (state) {
    case Proximity::disjoint:
      return "disjoint";
    case Proximity::touching:
      return "touching";
    case Proximity::overlapping:
      return "overlapping";
    default:
      return "undecided";
  }
}

template <class A, class B>
void tell(const char* bodies, const A& a, const B& b) {
  const contact::CertifiedProximity found = contact::certified_proximity(a, b);
  const bool plane = contact::separates_weakly(found.plane, a, b);
  const bool point = contact::meeting_proved(found.common, a, b);
  std::printf("%-34s %-12s %-6s %-6s", bodies, name_of(found.state), plane ? "yes" : "no",
              point ? "yes" : "no");
  if (found.state == Proximity::undecided) {
    double bound = 1;
    while (bound / 10 > found.high - found.low) bound /= 10;
    std::printf(" the interval is shorter than %.0e m", bound);
  }
  std::printf("\n");
}

}  // namespace

int main() {
  std::printf("%-34s %-12s %-6s %-6s\n", "bodies", "case", "plane", "point");
  contact::OrientedBox<double> box;
  box.half_lengths = {2, 1, 1};
  contact::OrientedBox<double> above = box;
  above.centre = {0.5, 0, 2};
  tell("box on a box", above, box);
  above.centre.z() = std::nextafter(2.0, 3.0);
  tell("the same, an ulp higher", above, box);
  above.centre.z() = std::nextafter(2.0, 1.0);
  tell("the same, an ulp lower", above, box);

  const contact::Capsule<double> capsule{{{3, 4, 0}, {3, 4, 5}}, 4};
  tell("capsule and ball, 4 + 1 = 5 m", capsule, contact::Sphere<double>{{0, 0, 0}, 1});
  const contact::Triangle<double> flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const contact::Triangle<double> same_plane{{1, 1, 0}, {5, 1, 0}, {1, 5, 0}};
  tell("two triangles in one plane", flat, same_plane);
  const contact::Triangle<double> through{{1, 1, -1}, {1, 1, 1}, {3, 3, 1}};
  tell("a triangle through the other", flat, through);

  const auto cylinder = contact::cylinder_from_segment<double>({0, 0, 0}, {0, 0, 2}, 1);
  const auto ellipsoid = contact::ellipsoid_from_axes<double>(
      {3, 0, 1}, contact::Matrix3<double>::Identity(), {2, 1, 1});
  tell("cylinder and ellipsoid, touching", cylinder, ellipsoid);
  auto oblique = ellipsoid;
  oblique.centre = {2, 1.5, 2};
  tell("cylinder and ellipsoid, deeper", cylinder, oblique);
}
