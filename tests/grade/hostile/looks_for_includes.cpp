// Tries:     asks the preprocessor which files there are: the tests, the solution, secrets,
//            other submissions
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed
// Reduced:   that a file is there may be seen, and stops the compiler
//[attack
#if __has_include("/etc/passwd")
#warning "GOT IT: /etc/passwd"
#endif
#if __has_include("/etc/shadow")
#warning "GOT IT: /etc/shadow"
#endif
#if __has_include("@SECRET@")
#warning "GOT IT: @SECRET@"
#endif
#if __has_include("@ROOT@/tests/01_planes/signed_distance_test.cpp")
#warning "GOT IT: @ROOT@/tests/01_planes/signed_distance_test.cpp"
#endif
#if __has_include("@ROOT@/solutions/01_planes/signed_distance/signed_distance.cpp")
#warning "GOT IT: @ROOT@/solutions/01_planes/signed_distance/signed_distance.cpp"
#endif
#if __has_include("@ROOT@/tests/support/exercise.hpp")
#warning "GOT IT: @ROOT@/tests/support/exercise.hpp"
#endif
#if __has_include("@RESULTS@/results.json")
#warning "GOT IT: @RESULTS@/results.json"
#endif
#if __has_include("@NEIGHBOUR@")
#warning "GOT IT: @NEIGHBOUR@"
#endif
#if __has_include("/proc/self/environ")
#warning "GOT IT: /proc/self/environ"
#endif
#if __has_include("/proc/self/cmdline")
#warning "GOT IT: /proc/self/cmdline"
#endif
#if __has_include("../../tests/01_planes/signed_distance_test.cpp") || __has_include("../tests.o")
#warning "GOT IT: the tests"
#endif
#if __has_include(<catch2/catch_test_macros.hpp>) || __has_include(<support/exercise.hpp>)
#warning "GOT IT: the tests' headers"
#endif
#if __has_include(<contact/remote.hpp>) || __has_include(<contact/host.hpp>)
#warning "GOT IT: the grader's headers"
#endif
//]attack
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
