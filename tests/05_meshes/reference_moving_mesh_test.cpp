// A segment against a moving mesh: the delta matrix, the chord bound and its hypotheses, and the
// certified answer, against fractions, intervals of many bits and finely sampled paths.
#include <05_meshes/moving_truth.hpp>
#include <05_meshes/solid_truth.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/moving_mesh.hpp>
#include <contact/moving_mesh_certified.hpp>

#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace {

using contact::CoordinateFrame;
using contact::Matrix3;
using contact::Matrix4;
using contact::Mesh;
using contact::MotionAnswer;
using contact::MotionVerdict;
using contact::RigidMotion;
using contact::Segment;
using contact::Vector3;
using generators::Random;
using moving_truth::drawn;
using oracle::Interval;
using oracle::Rational;
using Long = Vector3<long double>;

// ---------------------------------------------------------------- input

Matrix3<double> turned(const Vector3<double>& rotation) {
  return contact::matrix_of(contact::exponential<double>(rotation));
}
CoordinateFrame<double> drawn_frame(Random& random, double far) {
  const Vector3<double> origin = drawn(random, far);
  return {origin, turned(drawn(random, 3))};
}
RigidMotion<double> drawn_motion(Random& random, double angle) {
  RigidMotion<double> motion;
  motion.start = drawn_frame(random, 2);
  motion.displacement = drawn(random, 2);
  motion.rotation = drawn(random, angle);
  return motion;
}
Segment<double> drawn_path(Random& random, double size) {
  const Vector3<double> start = drawn(random, size);
  return {start, drawn(random, size)};
}

// ---------------------------------------------------------------- truth

Long lengthened(const Vector3<double>& v) { return {v.x(), v.y(), v.z()}; }

/// v turned by −angle about the axis k.
Long turned_back(const Long& v, const Long& k, long double angle) {
  const long double c = std::cos(angle), s = std::sin(angle);
  return v * c - k.cross(v) * s + k * (k.dot(v) * (1 - c));
}

/// The path in the body with any law for the fractions of rotation and of both translations.
struct Law {
  std::function<long double(long double)> rotation = [](long double s) { return s; };
  std::function<long double(long double)> origin = [](long double s) { return s; };
  std::function<long double(long double)> point = [](long double s) { return s; };
};
Long sampled_path(const RigidMotion<double>& motion, const Segment<double>& path, long double s,
                  const Law& law = {}) {
  const Long at = lengthened(path.start) +
                  law.point(s) * (lengthened(path.end) - lengthened(path.start)) -
                  lengthened(motion.start.origin) - law.origin(s) * lengthened(motion.displacement);
  Long y;
  for (int k = 0; k < 3; ++k) y[k] = lengthened(motion.start.axes.col(k)).dot(at);
  const Long r = lengthened(motion.rotation);
  const long double angle = std::sqrt(r.dot(r));
  return angle > 0 ? turned_back(y, r / angle, law.rotation(s) * angle) : y;
}

/// The largest distance of a curve from its chord at the same fraction, sampled.
long double deviation(const std::function<Long(long double)>& curve, int samples = 200) {
  const Long start = curve(0), end = curve(1);
  long double most = 0;
  for (int i = 0; i <= samples; ++i) {
    const long double s = static_cast<long double>(i) / samples;
    const Long off = curve(s) - (start + s * (end - start));
    most = std::max(most, std::sqrt(off.dot(off)));
  }
  return most;
}
long double deviation(const RigidMotion<double>& motion, const Segment<double>& path,
                      const Law& law = {}) {
  return deviation([&](long double s) { return sampled_path(motion, path, s, law); });
}

/// M in fractions, with the stored axes.
oracle::Vector carried_exactly(const CoordinateFrame<double>& pose0,
                               const CoordinateFrame<double>& pose1, const Vector3<double>& a) {
  const oracle::Vector from = oracle::exact(a) - oracle::exact(pose0.origin);
  oracle::Vector in_body;
  for (int k = 0; k < 3; ++k) {
    in_body[k] = oracle::exact(Vector3<double>(pose0.axes.col(k))).dot(from);
  }
  oracle::Vector carried = oracle::exact(pose1.origin);
  for (int k = 0; k < 3; ++k) {
    carried += oracle::exact(Vector3<double>(pose1.axes.col(k))) * in_body[k];
  }
  return carried;
}

// ---------------------------------------------------------------- the delta matrix

TEST_CASE("rows and columns carry the same point, within the bound") {
  Random random(501);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const double far = std::ldexp(1.0, random.integer(-300, 60));
    const CoordinateFrame<double> pose0 = drawn_frame(random, far);
    const CoordinateFrame<double> pose1 = drawn_frame(random, far * (i % 2 == 0 ? 1 : 8));
    const double near = i % 3 == 0 ? far : std::ldexp(1.0, random.integer(-300, 60));
    const Vector3<double> a = pose0.origin + drawn(random, near);
    const Matrix4<double> m0 = contact::homogeneous_matrix(pose0);
    const Matrix4<double> m1 = contact::homogeneous_matrix(pose1);
    const Vector3<double> column =
        contact::carried_column<double>(contact::delta_matrix<double>(m0, m1), a);
    const Vector3<double> row = contact::carried_row<double>(
        a, contact::delta_matrix_rows<double>(m0.transpose(), m1.transpose()));
    const Vector3<double> body = contact::carried_in_body<double>(pose0, pose1, a);
    const oracle::Vector right = carried_exactly(pose0, pose1, a);
    REQUIRE(oracle::error(column, right) <= contact::delta_matrix_rounding(pose0, pose1, a));
    REQUIRE(oracle::error(row, right) <= contact::delta_matrix_rounding(pose0, pose1, a));
    REQUIRE(oracle::error(body, right) <= contact::carried_in_body_rounding(pose0, pose1, a));
  }
}

TEST_CASE("the product in the order for rows is another motion for columns") {
  CoordinateFrame<double> pose0, pose1;
  pose0.origin = {1, 0, 0};
  pose1.origin = {1, 0, 0};
  pose1.axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // a quarter turn about the body's own origin
  const Matrix4<double> m0 = contact::homogeneous_matrix(pose0);
  const Matrix4<double> m1 = contact::homogeneous_matrix(pose1);
  const Vector3<double> a(2, 0, 0);
  CHECK(contact::carried_column<double>(contact::delta_matrix<double>(m0, m1), a) ==
        Vector3<double>(1, 1, 0));
  const Matrix4<double> wrong = contact::inverse_of_frame_matrix<double>(m0) * m1;
  CHECK(contact::carried_column<double>(wrong, a) == Vector3<double>(0, 2, 0));
  CHECK(contact::carried_column<double>(wrong, Vector3<double>(1, 0, 0)) ==
        Vector3<double>(0, 1, 0));  // right for the point's coordinates in the body
}

TEST_CASE("the delta matrix loses digits far from the world's origin, the body's frame does not") {
  CoordinateFrame<double> pose0, pose1;
  pose0.origin = {0x1p40, 0x1p40, 0};
  pose0.axes = turned({0.3, -0.2, 0.9});
  pose1 = {pose0.origin, turned({0.1, 0.5, -0.7})};
  const Segment<double> path{pose0.origin + Vector3<double>(1, 2, 3), pose0.origin};
  const Segment<double> chord = contact::chord_in_body<double>(path, pose0, pose1);
  const Vector3<double> plain = pose0.axes.transpose() * Vector3<double>(1, 2, 3);
  CHECK((chord.start - plain).cwiseAbs().maxCoeff() == 0);
  const Matrix4<double> delta = contact::delta_matrix<double>(contact::homogeneous_matrix(pose0),
                                                              contact::homogeneous_matrix(pose1));
  const Vector3<double> carried = contact::carried_column<double>(delta, path.start);
  const double lost = (contact::position_in_frame(pose1, carried) - plain).cwiseAbs().maxCoeff();
  CHECK(lost > 1e-6);
  CHECK(lost < 1e-2);
}

TEST_CASE(
    "the three ways to ask agree on a mesh that is not grazed, and the present pose does not") {
  const Mesh<double> mesh = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  Random random(502);
  int hits = 0, missed = 0, invented = 0;
  for (int i = 0; i < 400; ++i) {
    const CoordinateFrame<double> pose0 = drawn_frame(random, 4), pose1 = drawn_frame(random, 4);
    const Segment<double> path = drawn_path(random, 4);
    const auto body = contact::segment_against_moving_mesh<double>(path, mesh, pose0, pose1);
    const Matrix4<double> delta = contact::delta_matrix<double>(contact::homogeneous_matrix(pose0),
                                                                contact::homogeneous_matrix(pose1));
    const auto world = contact::segment_against_mesh_by_delta<double>(
        path, contact::transformed(mesh, pose1), delta);
    REQUIRE(body.has_value() == world.has_value());
    const bool present =
        contact::segment_against_present_mesh<double>(path, mesh, pose1).has_value();
    hits += body.has_value() ? 1 : 0;
    missed += body.has_value() && !present ? 1 : 0;
    invented += !body.has_value() && present ? 1 : 0;
    if (body) CHECK(std::abs(body->hit.t - world->hit.t) < 1e-12);
  }
  CHECK(hits > 50);
  CHECK(missed > 20);
  CHECK(invented > 10);
}

TEST_CASE("in float and in double the chords give the same hits, except next to an edge") {
  const Mesh<double> mesh = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  const Mesh<float> mesh_in_float = contact::rounded_mesh<float>(mesh);
  Random random(509);
  int hits = 0, different = 0;
  for (int i = 0; i < 400; ++i) {
    const RigidMotion<double> motion = drawn_motion(random, 1);
    const Segment<double> path = drawn_path(random, 3);
    const RigidMotion<float> motion_in_float{
        {motion.start.origin.cast<float>(), motion.start.axes.cast<float>()},
        motion.displacement.cast<float>(),
        motion.rotation.cast<float>()};
    const auto hit = contact::moving_by_substeps<double>(path, mesh, motion, 5);
    const auto hit_in_float = contact::moving_by_substeps<float>(generators::rounded<float>(path),
                                                                 mesh_in_float, motion_in_float, 5);
    hits += hit ? 1 : 0;
    different += hit.has_value() != hit_in_float.has_value() ? 1 : 0;
    if (hit && hit_in_float) CHECK(std::abs(hit->time - double(hit_in_float->time)) < 1e-3);
  }
  CHECK(hits > 50);
  CHECK(different <= 1);
  CHECK_FALSE(contact::moving_by_substeps<double>({}, mesh, RigidMotion<double>{}, 0));
}

// ---------------------------------------------------------------- motions and paths

TEST_CASE("motion_between leads from one pose to the other, and equal axes do not rotate") {
  Random random(503);
  for (int i = 0; i < generators::tried(5000); ++i) {
    const CoordinateFrame<double> pose0 = drawn_frame(random, 2);
    CoordinateFrame<double> pose1 = drawn_frame(random, 2);
    if (i % 4 == 0) {
      const double small = std::ldexp(1.0, -random.integer(1, 60));
      pose1.axes = pose0.axes * turned(drawn(random, small));
    }
    const RigidMotion<double> motion = contact::motion_between(pose0, pose1);
    const CoordinateFrame<double> end = contact::frame_at(motion, 1.0);
    REQUIRE((end.axes - pose1.axes).cwiseAbs().maxCoeff() < 32 * 0x1p-53);
    REQUIRE((end.origin - pose1.origin).cwiseAbs().maxCoeff() < 8 * 0x1p-53);
    REQUIRE(contact::frame_at(motion, 0.0).axes == pose0.axes);
    const double angle = std::sqrt(motion.rotation.dot(motion.rotation));
    REQUIRE(angle < 3.1415926535897936);
    pose1.axes = pose0.axes;
    REQUIRE(contact::motion_between(pose0, pose1).rotation == Vector3<double>::Zero());
  }
}

TEST_CASE("the enclosed path contains the path, at a precision of 200 bits") {
  Random random(504);
  const auto interval = [](double x) { return Interval(oracle::exact(x), 200); };
  for (int i = 0; i < generators::tried(300); ++i) {
    const double angle = i % 3 == 0 ? 1e-9 : i % 3 == 1 ? 3 : 100;
    const RigidMotion<double> motion = drawn_motion(random, angle);
    const Segment<double> path = drawn_path(random, i % 2 == 0 ? 3 : 1e6);
    const double s = std::ldexp(random.integer(0, 1024), -10);
    const auto sample = contact::detail::EnclosedPath(motion, path).sample(s);

    std::array<Interval, 3> y, k, q;
    Interval square = interval(0);
    for (std::size_t j = 0; j < 3; ++j) {
      y[j] = interval(0);
      for (int row = 0; row < 3; ++row) {
        const Interval at = interval(path.start[row]) - interval(motion.start.origin[row]) +
                            interval(s) * (interval(path.end[row]) - interval(path.start[row]) -
                                           interval(motion.displacement[row]));
        y[j] = y[j] + interval(motion.start.axes(row, int(j))) * at;
      }
      k[j] = interval(motion.rotation[int(j)]);
      square = square + k[j] * k[j];
    }
    const Interval whole = sqrt(square);
    for (Interval& x : k) x = x / whole;
    const Interval c = cos(interval(s) * whole), sine = sin(interval(s) * whole);
    const Interval along = (k[0] * y[0] + k[1] * y[1] + k[2] * y[2]) * (interval(1) - c);
    Rational off(0);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t l = (j + 1) % 3, m = (j + 2) % 3;
      q[j] = y[j] * c - (k[l] * y[m] - k[m] * y[l]) * sine + k[j] * along;
      const oracle::Enclosure enclosed = oracle::enclose(q[j] - interval(sample.at[int(j)]));
      off +=
          std::max(Rational(enclosed.low * enclosed.low), Rational(enclosed.high * enclosed.high));
    }
    const Rational error = oracle::exact(sample.error);
    REQUIRE(off <= error * error);
    const double size = i % 2 == 0 ? 8 : 4e6;
    REQUIRE(sample.error < size * 0x1p-53 * (200 + 10 * angle));
    // The plain path is as near.
    const Vector3<double> plain = contact::path_in_body<double>(motion, path, s);
    REQUIRE((plain - sample.at).cwiseAbs().maxCoeff() < size * 0x1p-53 * (200 + 10 * angle));
  }
}

TEST_CASE("sine and cosine are within the bound that the proofs use") {
  Random random(505);
  for (int i = 0; i < generators::tried(3000); ++i) {
    const double x = i % 2 == 0 ? random.uniform(-7, 7) : random.magnitude(-40, 40);
    const contact::detail::EnclosedSineCosine got{contact::RunningError(x)};
    const Interval exact(oracle::exact(x), 200);
    const Rational room = oracle::exact(got.sine.bound);
    const auto sine = oracle::enclose(sin(exact)), cosine = oracle::enclose(cos(exact));
    REQUIRE(oracle::exact(sine.error(got.sine.value)) <= room);
    REQUIRE(oracle::exact(cosine.error(got.cosine.value)) <= room);
  }
}

// ---------------------------------------------------------------- the chord bound

TEST_CASE("the path is within the chord bound, for one chord and for substeps") {
  Random random(506);
  for (int i = 0; i < generators::tried(3000); ++i) {
    const RigidMotion<double> motion = drawn_motion(random, i % 2 == 0 ? 3 : 0.05);
    const Segment<double> path = drawn_path(random, 4);
    const double bound = contact::chord_bound(motion, path);
    REQUIRE(deviation(motion, path) <= static_cast<long double>(bound) * (1 + 1e-12L));
    // The formula with the distances from the origin is never smaller.
    const Vector3<double> start = path.start - motion.start.origin;
    const Vector3<double> travel = path.end - path.start - motion.displacement;
    const Vector3<double> end = start + travel;
    const double plain = contact::chord_bound<double>(
        std::sqrt(motion.rotation.dot(motion.rotation)),
        std::sqrt(std::max(start.dot(start), end.dot(end))), std::sqrt(travel.dot(travel)));
    REQUIRE(bound <= plain * (1 + 1e-12));
    const int n = random.integer(2, 9);
    const double fine = contact::chord_bound(motion, path, n);
    REQUIRE(std::abs(fine * n * n - bound) <= 1e-12 * bound);
    for (int j = 0; j < n; ++j) {
      const auto part = [&](long double s) { return sampled_path(motion, path, (j + s) / n); };
      REQUIRE(deviation(part, 20) <= static_cast<long double>(fine) * (1 + 1e-12L) + 1e-15L);
    }
  }
}

TEST_CASE("the chord bound is attained by each of its terms") {
  RigidMotion<double> motion;
  motion.rotation = {0, 0, 0.01};
  // An arc: the point does not move, and the sagitta is r (1 − cos θ/2).
  const Segment<double> at_rest{{2, 0, 0}, {2, 0, 0}};
  CHECK(contact::chord_bound(motion, at_rest) == 0.01 * (0.01 * 2) / 8);
  CHECK(deviation(motion, at_rest) > 0.9999 * contact::chord_bound(motion, at_rest));
  // Through the axis: the Coriolis term alone, up to θ/8 of it.
  const Segment<double> through{{-1, 0, 0}, {1, 0, 0}};
  CHECK(deviation(motion, through) > 0.99 * contact::chord_bound(motion, through));
  // For random motions the bound is a few times too large at most, in the median.
  Random random(507);
  int within_four = 0;
  for (int i = 0; i < 1000; ++i) {
    const RigidMotion<double> some = drawn_motion(random, 0.5);
    const Segment<double> path = drawn_path(random, 4);
    within_four += deviation(some, path) * 4 > contact::chord_bound(some, path) ? 1 : 0;
  }
  CHECK(within_four > 900);
}

TEST_CASE("the chord bound scales with the lengths, and is infinite if a number is not finite") {
  Random random(513);
  for (int i = 0; i < 300; ++i) {
    RigidMotion<double> motion = drawn_motion(random, 3);
    Segment<double> path = drawn_path(random, 4);
    const double bound = contact::chord_bound(motion, path);
    const int power = random.integer(-900, 900);
    for (Vector3<double>* v :
         {&motion.start.origin, &motion.displacement, &path.start, &path.end}) {
      for (int k = 0; k < 3; ++k) (*v)[k] = std::ldexp((*v)[k], power);
    }
    REQUIRE(contact::chord_bound(motion, path) == std::ldexp(bound, power));
  }
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int where = 0; where < 18; ++where) {
      RigidMotion<double> motion = drawn_motion(random, 3);
      Segment<double> path = drawn_path(random, 4);
      const std::array<Vector3<double>*, 5> vectors{&motion.rotation, &motion.displacement,
                                                    &motion.start.origin, &path.start, &path.end};
      if (where < 15) {
        (*vectors[std::size_t(where / 3)])[where % 3] = bad;
      } else {
        motion.start.axes(where - 15, where - 15) = bad;
      }
      REQUIRE(contact::chord_bound(motion, path) == std::numeric_limits<double>::infinity());
    }
  }
}

TEST_CASE("translations have a bound of exactly 0, and a straight path") {
  Random random(508);
  for (int i = 0; i < 500; ++i) {
    RigidMotion<double> motion = drawn_motion(random, 1);
    motion.rotation = Vector3<double>::Zero();
    const Segment<double> path = drawn_path(random, 100);
    REQUIRE(contact::chord_bound(motion, path) == 0);
    REQUIRE(deviation(motion, path) < 1e-15L);
  }
}

TEST_CASE("each hypothesis of the chord bound is needed") {
  RigidMotion<double> motion;
  motion.rotation = {0, 0, 0.1};
  const Segment<double> at_rest{{2, 0, 0}, {2, 0, 0}}, through{{-1, 0, 0}, {1, 0, 0}};
  const long double bound = contact::chord_bound(motion, at_rest);
  const auto square = [](long double s) { return s * s; };

  SECTION("a rotation at constant rate") {
    Law law;
    law.rotation = square;
    CHECK(deviation(motion, at_rest, law) > 10 * bound);
  }
  SECTION("an origin at constant velocity") {
    Law law;
    law.origin = square;
    RigidMotion<double> moving;
    moving.displacement = {1, 0, 0};
    CHECK(contact::chord_bound(moving, at_rest) == 0);
    CHECK(deviation(moving, at_rest, law) > 0.24L);
  }
  SECTION("a point at constant velocity") {
    Law law;
    law.point = square;
    CHECK(deviation(RigidMotion<double>{}, through, law) > 0.49L);
  }
  SECTION("a rotation about the body's origin") {
    // About (100, 0, 0) instead, so that the origin moves on an arc. The point moves straight from
    // the origin's start to its end: with a straight origin it would stay there.
    const Long centre(100, 0, 0), axis(0, 0, 1);
    const long double angle = 0.01L;
    const Long end = centre + turned_back(Long(-centre), axis, -angle);
    const auto path = [&](long double s) {
      return Long(centre + turned_back(Long(s * end - centre), axis, s * angle));
    };
    RigidMotion<double> straight;
    straight.rotation = {0, 0, double(angle)};
    straight.displacement = {double(end.x()), double(end.y()), 0};
    const Segment<double> with_it{{0, 0, 0}, straight.displacement};
    CHECK(std::sqrt(path(1).dot(path(1))) < 1e-15L);
    CHECK(contact::chord_bound(straight, with_it) == 0);
    CHECK(deviation(path) > 1e-3L);
  }
  SECTION("a fixed axis") {
    // First about x, then about y: the same final orientation as a rotation about one axis.
    const Long point(0, 0, 2);
    const auto two = [&](long double s) {
      const Long half = turned_back(point, Long(1, 0, 0), 0.1L * std::min(1.0L, 2 * s));
      return turned_back(half, Long(0, 1, 0), 0.1L * std::max(0.0L, 2 * s - 1));
    };
    const double angle = 0.1 * std::sqrt(2.0);
    CHECK(deviation(two) > 5 * contact::chord_bound<double>(angle, 2, 0));
  }
  SECTION("the whole angle, not modulo a turn") {
    RigidMotion<double> more = motion;
    more.rotation.z() = 0.1 + 2 * std::acos(-1.0);
    CHECK(deviation(more, at_rest) > 100 * bound);
    CHECK(deviation(more, at_rest) <=
          static_cast<long double>(contact::chord_bound(more, at_rest)));
  }
  SECTION("the term θ² r") {
    CHECK(deviation(motion, at_rest) > contact::chord_bound<double>(0.1, 0, 0));
  }
  SECTION("the term 2 θ d") {
    CHECK(deviation(motion, through) > 10 * contact::chord_bound<double>(0.1, 1, 0));
  }
  SECTION("the factor 2 of it") {
    CHECK(deviation(motion, through) > 1.5 * contact::chord_bound<double>(0.1, 1, 2 / 2));
  }
}

}  // namespace
