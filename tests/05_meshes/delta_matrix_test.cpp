// The poses of most tests have whole numbers, or 0.6 and 0.8. A tolerance of 1e-10 is several
// hundred times what rounding makes of numbers below 100 in a dozen operations.
#include "delta_matrix.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

namespace {

using namespace contact::testing;
using exercise::Motion;
using Matrix = Eigen::Matrix4d;
using Segment = contact::Segment<double>;
using Vector = Eigen::Vector3d;

constexpr double kTolerance = 1e-10;

Eigen::Matrix3d rotation(const Matrix& pose) { return pose.topLeftCorner<3, 3>(); }
Vector translation(const Matrix& pose) { return pose.topRightCorner<3, 1>(); }

Matrix pose(const Eigen::Matrix3d& axes, const Vector& position) {
  Matrix result = Matrix::Identity();
  result.topLeftCorner<3, 3>() = axes;
  result.topRightCorner<3, 1>() = position;
  return result;
}

Eigen::Matrix3d turned_back(const Matrix& m) { return m.transpose().topLeftCorner<3, 3>(); }
Matrix inverse(const Matrix& m) { return pose(turned_back(m), -(turned_back(m) * translation(m))); }
Matrix with_negated_translation(const Matrix& m) { return pose(turned_back(m), -translation(m)); }
Matrix transposed(const Matrix& m) { return m.transpose(); }

Vector moved(const Matrix& m, const Vector& p, double w = 1) {
  const Eigen::Vector4d result = m * Eigen::Vector4d(p.x(), p.y(), p.z(), w);
  return result.head<3>();
}

double angle(const Motion& body) {
  const Eigen::Matrix3d r = rotation(body.after) * turned_back(body.before);
  const Vector sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  return std::atan2(sine.norm(), r.trace() - 1);
}

void check_delta(const Motion& body) {
  const auto by = [&](auto&& turn_back) { return Matrix(body.after * turn_back(body.before)); };
  ask("What is the delta matrix of the body?")
      .given("body", body)
      .suspect("delta-for-rows", [&] { return Matrix(inverse(body.before) * body.after); })
      .suspect("inverse-by-transpose", [&] { return by(transposed); })
      .suspect("translation-only-negated", [&] { return by(with_negated_translation); })
      .suspect("translations-subtracted",
               [&] {
                 return pose(rotation(body.after) * turned_back(body.before),
                             translation(body.after) - translation(body.before));
               })
      .answer([&] { return exercise::delta_matrix(body); })
      .close_to(by(inverse), within(kTolerance));
}

/// Where B sees the vertex if it takes its poses back by `turn_back`, with w for the fourth
/// coordinate of the vertex.
template <class TurnBack>
Segment seen(const Motion& a, const Motion& b, const Vector& vertex, TurnBack&& turn_back,
             double w = 1) {
  return {moved(turn_back(b.before) * a.before, vertex, w),
          moved(turn_back(b.after) * a.after, vertex, w)};
}

void check_segment(const Motion& a, const Motion& b, const Vector& vertex) {
  const Segment right = seen(a, b, vertex, inverse);
  ask("Which segment does B see?")
      .given("a", a)
      .given("b", b)
      .given("vertex", vertex)
      .suspect("inverse-by-transpose", [&] { return seen(a, b, vertex, transposed); })
      .suspect("translation-only-negated",
               [&] { return seen(a, b, vertex, with_negated_translation); })
      .suspect("point-as-direction", [&] { return seen(a, b, vertex, inverse, 0); })
      .suspect("segment-left-in-the-world",
               [&] {
                 return Segment{moved(a.before, vertex), moved(a.after, vertex)};
               })
      .suspect("poses-in-reverse-order",
               [&] {
                 return Segment{moved(a.before * inverse(b.before), vertex),
                                moved(a.after * inverse(b.after), vertex)};
               })
      .suspect("later-pose-at-both-ends",
               [&] {
                 return Segment{moved(inverse(b.after) * a.before, vertex), right.end};
               })
      .answer([&] { return exercise::segment_seen(a, b, vertex); })
      .close_to(right, within(kTolerance));
}

/// How a bound is computed: the right one as it is.
struct Formula {
  double share_of_alpha = 1;
  double share_of_beta = 1;
  double coriolis = 2;
  bool from_the_world = false;  ///< the distance is that from the world's origin
};

double bound(const Motion& a, const Motion& b, const Vector& vertex, const Formula& by) {
  const double alpha = by.share_of_alpha * angle(a), beta = by.share_of_beta * angle(b);
  const Vector origins =
      translation(a.after) - translation(a.before) - translation(b.after) + translation(b.before);
  const auto distance = [&](const Matrix& of_a, const Matrix& of_b) {
    const Vector origin = by.from_the_world ? Vector(0, 0, 0) : translation(of_b);
    return (moved(of_a, vertex) - origin).norm();
  };
  const double own = alpha * alpha * vertex.norm();
  const double speed = origins.norm() + alpha * vertex.norm();
  const double farthest =
      std::max(distance(a.before, b.before), distance(a.after, b.after)) + own / 8;
  return (own + by.coriolis * beta * speed + beta * beta * farthest) / 8;
}

void check_bound(const Motion& a, const Motion& b, const Vector& vertex,
                 double tolerance = kTolerance) {
  const double right = bound(a, b, vertex, {});
  // An arccosine near 1 is off by about the square root of the rounding errors of its argument.
  const double doubtful = 4e-8;
  const double moved_by = (translation(a.after) - translation(a.before)).norm();
  const double smallest = std::min(angle(a), angle(b));
  const auto by = [&](const Formula& formula) { return bound(a, b, vertex, formula); };
  ask("How far from the segment may B see the vertex?")
      .given("a", a)
      .given("b", b)
      .given("vertex", vertex)
      .suspect("coriolis-left-out", [&] { return by({.coriolis = 0}); })
      .suspect("coriolis-counted-once", [&] { return by({.coriolis = 1}); })
      .suspect("half-the-angle", [&] { return by({.share_of_alpha = 0.5, .share_of_beta = 0.5}); })
      .suspect("distance-from-the-world", [&] { return by({.from_the_world = true}); })
      .suspect("rotation-of-a-left-out", [&] { return by({.share_of_alpha = 0}); })
      .suspect_if("angle-from-the-trace",
                  [&](const double& got) {
                    if (smallest > 0.01) return false;
                    return std::abs(got - right) < doubtful * moved_by / 4;
                  })
      .answer([&] { return exercise::chord_bound(a, b, vertex); })
      .close_to(right, within(tolerance));
}

const Eigen::Matrix3d kUpright = Eigen::Matrix3d::Identity();
/// By a quarter turn about z, and about x; and by the angle with the cosine 0.6 about y.
const Eigen::Matrix3d kLeft{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
const Eigen::Matrix3d kTilted{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
const Eigen::Matrix3d kAslant{{0.6, 0, 0.8}, {0, 1, 0}, {-0.8, 0, 0.6}};

Motion at_rest(const Matrix& at) { return {at, at}; }

}  // namespace

TEST_CASE("the delta matrix of a body that only translates") {
  check_delta({pose(kUpright, {1, 2, 3}), pose(kUpright, {5, -1, 2})});
  check_delta({pose(kLeft, {1, 2, 3}), pose(kLeft, {4, -1, 2})});
  check_delta({pose(kAslant, {1, 2, 3}), pose(kAslant, {1, -8, 0})});
  check_delta(at_rest(pose(kTilted, {-7, 2, 3})));
}

TEST_CASE("the delta matrix of a body that also rotates") {
  check_delta({pose(kUpright, {1, 2, 3}), pose(kLeft, {1, 2, 3})});
  check_delta({pose(kUpright, {1, 2, 3}), pose(kTilted, {5, -1, 2})});
  check_delta({pose(kLeft, {1, 2, 3}), pose(kTilted, {4, -1, 2})});
  check_delta({pose(kAslant, {-3, 4, 12}), pose(kLeft * kAslant, {0, 0, 0})});
}

TEST_CASE("B sees the vertex in its own frame, then and now") {
  const Vector vertex(1, 2, 0);
  check_segment({pose(kUpright, {1, 0, 7}), pose(kUpright, {3, 4, 7})},
                {pose(kUpright, {2, 2, 2}), pose(kLeft, {-1, 2, 5})}, vertex);
  check_segment({pose(kTilted, {1, 0, 7}), pose(kAslant, {3, 4, 7})},
                {pose(kLeft, {2, 2, 2}), pose(kTilted, {-1, 2, 5})}, {3, -1, 2});
  // Both carried by one motion: B sees the vertex at rest.
  check_segment({pose(kUpright, {4, 0, 0}), pose(kLeft, {0, 4, 0})},
                {pose(kUpright, {0, 0, 0}), pose(kLeft, {0, 0, 0})}, vertex);
}

TEST_CASE("the bound is 0 if no body rotates, and grows with the angle of B") {
  const Motion a{pose(kUpright, {1, 0, 7}), pose(kUpright, {3, 4, 7})};
  check_bound(a, {pose(kLeft, {2, 2, 2}), pose(kLeft, {-1, 2, 5})}, {1, 2, 3});
  check_bound(a, {pose(kUpright, {2, 2, 2}), pose(kLeft, {-1, 2, 5})}, {1, 2, 3});
  check_bound(a, {pose(kLeft, {2, 2, 2}), pose(kTilted, {-1, 2, 5})}, {1, 2, 3});
  check_bound(at_rest(pose(kTilted, {2, 2, 2})),
              {pose(kLeft, {9, 2, 2}), pose(kLeft * kAslant, {7, 2, 5})}, {1, 2, 3});
}

TEST_CASE("the bound counts the rotation of A") {
  check_bound({pose(kUpright, {1, 0, 7}), pose(kLeft, {3, 4, 7})},
              at_rest(pose(kTilted, {2, 2, 2})), {1, 2, 3});
  check_bound({pose(kLeft, {1, 0, 7}), pose(kTilted, {3, 4, 7})},
              {pose(kUpright, {2, 2, 2}), pose(kAslant, {-1, 2, 5})}, {1, 2, 3});
  check_bound({pose(kUpright, {1, 0, 7}), pose(kLeft, {3, 4, 7})},
              {pose(kUpright, {1, 0, 7}), pose(kLeft, {3, 4, 7})}, {3, 0, 4});
}

TEST_CASE("the bound of a small rotation is accurate") {
  // cos θ is 1 in double, and sin θ is θ.
  const double theta = std::ldexp(1.0, -30);
  const Eigen::Matrix3d small{{1, -theta, 0}, {theta, 1, 0}, {0, 0, 1}};
  check_bound({pose(kUpright, {0, 0, 0}), pose(kUpright, {0, 3000, 4000})},
              {pose(kUpright, {0, 0, 0}), pose(small, {0, 0, 0})}, {0, 0, 0}, 1e-13);
  check_bound({pose(kLeft, {0, 0, 0}), pose(kLeft, {0, 3000, 4000})},
              {pose(kTilted, {0, 0, 0}), pose(small * kTilted, {0, 0, 0})}, {0, 0, 0}, 1e-13);
}

namespace {

/// What a random pose is made of.
struct RandomPose {
  Eigen::Quaterniond orientation;
  Vector position;
};
/// Two of them for each body, and a vertex of A.
struct Case {
  RandomPose a_before, a_after, b_before, b_after;
  Vector vertex;
};

Matrix pose(const RandomPose& random_pose) {
  return pose(random_pose.orientation.toRotationMatrix(), random_pose.position);
}
Motion a_of(const Case& c) { return {pose(c.a_before), pose(c.a_after)}; }
Motion b_of(const Case& c) { return {pose(c.b_before), pose(c.b_after)}; }

/// The contract allows them, and the angles are neither small nor near π.
bool beyond_doubt(const Case& c) {
  for (const RandomPose& random_pose : {c.a_before, c.a_after, c.b_before, c.b_after}) {
    if (!(std::abs(random_pose.orientation.norm() - 1) < 1e-15)) return false;
    if (!(random_pose.position.cwiseAbs().maxCoeff() <= 16)) return false;
  }
  const auto clear = [](const Motion& body) { return angle(body) > 0.3 && angle(body) < 2.8; };
  return clear(a_of(c)) && clear(b_of(c)) && c.vertex.cwiseAbs().maxCoeff() <= 8;
}

void check(const Case& c) {
  check_delta(b_of(c));
  check_segment(a_of(c), b_of(c), c.vertex);
  check_bound(a_of(c), b_of(c), c.vertex);
}

}  // namespace

TEST_CASE("random motions agree") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  const auto random_pose = [&] {
    const Vector v = vector(1);
    const double w = random.uniform(-1, 1);
    const Eigen::Quaterniond turn = Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized();
    return RandomPose{turn, vector(16)};
  };
  for (int asked = 0; asked < 100;) {
    const Case c{random_pose(), random_pose(), random_pose(), random_pose(), vector(8)};
    if (!beyond_doubt(c)) continue;
    ++asked;
    shrinkable(check, beyond_doubt, c);
  }
}
