// The certified answer for a moving point and a moving mesh: never wrong, exact for translations,
// undecided only next to a contact.
#include <05_meshes/moving_truth.hpp>
#include <05_meshes/solid_truth.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/moving_mesh_certified.hpp>

#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace {

using contact::Mesh;
using contact::MotionAnswer;
using contact::MotionVerdict;
using contact::RigidMotion;
using contact::Segment;
using contact::Vector3;
using generators::Random;
using moving_truth::drawn;
using oracle::Rational;
using Long = Vector3<long double>;

Vector3<double> whole(Random& random, int most) {
  const int x = random.integer(-most, most);
  const int y = random.integer(-most, most);
  return Vector3<double>(x, y, random.integer(-most, most));
}

/// The path in the body, with 64 bits.
class LongPath {
 public:
  LongPath(const RigidMotion<double>& motion, const Segment<double>& path) {
    const auto as = [](const Vector3<double>& v) { return Long(v.x(), v.y(), v.z()); };
    const Long start = as(path.start) - as(motion.start.origin);
    const Long travel = (as(path.end) - as(path.start)) - as(motion.displacement);
    for (int k = 0; k < 3; ++k) {
      start_[k] = as(motion.start.axes.col(k)).dot(start);
      rate_[k] = as(motion.start.axes.col(k)).dot(travel);
    }
    const Long r = as(motion.rotation);
    angle_ = std::sqrt(r.dot(r));
    axis_ = angle_ > 0 ? Long(r / angle_) : r;
  }
  Long at(long double s) const {
    const Long y = start_ + s * rate_;
    const long double c = std::cos(s * angle_), sine = std::sin(s * angle_);
    return y * c - axis_.cross(y) * sine + axis_ * (axis_.dot(y) * (1 - c));
  }

 private:
  Long start_, rate_, axis_;
  long double angle_ = 0;
};

/// How far inside a triangle's edges the path crosses its plane between two times, at the best of
/// its crossings: a fraction of the triangle's size, negative if outside; −1 if it does not cross.
long double best_crossing(const LongPath& path, const contact::Triangle<double>& t, double from,
                          double to) {
  const auto as = [](const Vector3<double>& v) { return Long(v.x(), v.y(), v.z()); };
  const std::array<Long, 3> v{as(t.a), as(t.b), as(t.c)};
  const Long n = (v[1] - v[0]).cross(Long(v[2] - v[0]));
  const auto height = [&](long double s) { return n.dot(path.at(s) - v[0]); };
  long double best = -1;
  constexpr int parts = 256;
  for (int i = 0; i < parts; ++i) {
    const long double width = static_cast<long double>(to) - from;
    long double low = from + width * i / parts, high = from + width * (i + 1) / parts;
    const bool rises = height(low) <= 0;
    if ((height(high) <= 0) == rises) continue;
    for (int step = 0; step < 70; ++step) {
      const long double middle = (low + high) / 2;
      ((height(middle) <= 0) == rises ? low : high) = middle;
    }
    long double least = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Long edge = v[(k + 1) % 3] - v[k];
      least = std::min(least, n.cross(edge).dot(path.at(low) - v[k]) / n.dot(n));
    }
    best = std::max(best, least);
  }
  return best;
}

struct Count {
  int hit = 0, free = 0, undecided = 0;
};

/// Checks an answer against the path in 64 bits: the crossing that a hit claims exists, and where
/// the path is said to be free no triangle is crossed by more than rounding.
void verify(const RigidMotion<double>& motion, const Segment<double>& path,
            const Mesh<double>& mesh, const MotionAnswer& answer, Count& count, Random& random) {
  const LongPath exact(motion, path);
  REQUIRE(answer.from >= 0);
  REQUIRE(answer.to <= 1);
  if (answer.verdict == MotionVerdict::hit) {
    ++count.hit;
    REQUIRE(answer.from <= answer.to);
    if (answer.triangle >= 0) {
      const auto triangle = contact::triangle_of(mesh, std::size_t(answer.triangle));
      REQUIRE(best_crossing(exact, triangle, answer.from, answer.to) >= 0);
    } else {
      const auto winding = [&](double s) {
        const Long q = exact.at(s);
        const Vector3<double> rounded(double(q.x()), double(q.y()), double(q.z()));
        return solid_truth::winding(oracle::exact(rounded), mesh, random);
      };
      REQUIRE(winding(answer.from).has_value());
      REQUIRE(winding(answer.from) != winding(answer.to));
    }
  } else {
    ++(answer.verdict == MotionVerdict::free ? count.free : count.undecided);
  }
  const double end = answer.verdict == MotionVerdict::free ? 1 : answer.from;
  for (std::size_t i = 0; i < mesh.triangles.size() && end > 0; ++i) {
    REQUIRE(best_crossing(exact, contact::triangle_of(mesh, i), 0, end) < 1e-15L);
  }
}

TEST_CASE("the certified answer is right for random motions, and decided") {
  Random random(521);
  const std::array<Mesh<double>, 4> meshes{
      contact::box_mesh({-1, -1, -1}, {1, 1, 1}), contact::star_mesh(0.5, 1.2, 0),
      contact::octahedron_mesh(1), contact::torus_mesh(1, 0.4, 5, 4)};
  Count count;
  int by_chord_wrong = 0;
  for (int i = 0; i < generators::tried(800); ++i) {
    const Mesh<double>& mesh = meshes[std::size_t(i % 4)];
    RigidMotion<double> motion;
    motion.start.origin = drawn(random, 2);
    motion.start.axes = contact::matrix_of(contact::exponential<double>(drawn(random, 3)));
    motion.displacement = drawn(random, 2);
    motion.rotation = drawn(random, i % 3 == 0 ? 8 : i % 3 == 1 ? 1 : 0.01);
    const Vector3<double> start = drawn(random, 3);
    const Segment<double> path{start, drawn(random, 3)};
    const MotionAnswer answer = contact::certified_moving_hit(path, mesh, motion);
    verify(motion, path, mesh, answer, count, random);
    const bool chord = contact::moving_by_substeps(path, mesh, motion, 1).has_value();
    by_chord_wrong += answer.verdict != MotionVerdict::undecided &&
                              chord != (answer.verdict == MotionVerdict::hit)
                          ? 1
                          : 0;
  }
  CHECK(count.hit > generators::tried(50));
  CHECK(count.free > generators::tried(100));
  CHECK(count.undecided == 0);
  CHECK(by_chord_wrong > generators::tried(20));
}

TEST_CASE("paths aimed at vertices and edges are decided or undecided, never wrong") {
  Random random(522);
  const Mesh<double> box = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  const Mesh<double> star = contact::star_mesh(0.5, 1.2, 0);
  Count count;
  for (int i = 0; i < generators::tried(400); ++i) {
    const Mesh<double>& mesh = i % 2 == 0 ? box : star;
    RigidMotion<double> motion;
    motion.start.origin = drawn(random, 1);
    motion.displacement = drawn(random, 2);
    motion.rotation = drawn(random, i % 3 == 0 ? 3 : 0.1);
    const auto& triangle =
        mesh.triangles[std::size_t(random.integer(0, static_cast<int>(mesh.triangles.size()) - 1))];
    const Vector3<double> a = mesh.vertices[std::size_t(triangle[0])];
    const Vector3<double> b = mesh.vertices[std::size_t(triangle[1])];
    const double s = random.uniform(0.1, 0.9), along = i % 4 == 0 ? 0.0 : random.uniform();
    const Vector3<double> aim = a * (1 - along) + b * along;
    const Vector3<double> at = contact::position_in_world(contact::frame_at(motion, s), aim);
    const Vector3<double> start = at + drawn(random, 2);
    const Segment<double> path{start, start + (at - start) / s};
    verify(motion, path, mesh, contact::certified_moving_hit(path, mesh, motion), count, random);
  }
  CHECK(count.hit > generators::tried(100));
  CHECK(count.undecided > 0);
}

TEST_CASE("scales from 1e-150 to 1e150 give the same answers") {
  Random random(523);
  for (int i = 0; i < generators::tried(100); ++i) {
    const Mesh<double> box = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
    RigidMotion<double> motion;
    motion.start.origin = drawn(random, 2);
    motion.displacement = drawn(random, 2);
    motion.rotation = drawn(random, 2);
    const Vector3<double> start = drawn(random, 3);
    const Segment<double> path{start, drawn(random, 3)};
    const MotionAnswer plain = contact::certified_moving_hit(path, box, motion);
    for (const int power : {-500, -90, 90, 500}) {
      const double scale = std::ldexp(1.0, power);
      RigidMotion<double> scaled = motion;
      scaled.start.origin *= scale;
      scaled.displacement *= scale;
      Mesh<double> mesh = box;
      for (Vector3<double>& vertex : mesh.vertices) vertex *= scale;
      const MotionAnswer answer =
          contact::certified_moving_hit({path.start * scale, path.end * scale}, mesh, scaled);
      REQUIRE(answer.verdict == plain.verdict);
      REQUIRE(answer.from == plain.from);
      REQUIRE(answer.to == plain.to);
    }
  }
}

/// Whether a segment meets the surface of a box, exactly: it meets the box and is not strictly
/// inside as a whole.
bool meets_surface(const oracle::Vector& p, const oracle::Vector& q, int half) {
  Rational low(0), high(1);
  bool within = true;
  for (int k = 0; k < 3; ++k) {
    within = within && abs(p[k]) < half && abs(q[k]) < half;
    const Rational d = q[k] - p[k];
    if (d == 0) {
      if (abs(p[k]) > half) return false;
      continue;
    }
    const Rational s = (-half - p[k]) / d, t = (half - p[k]) / d;
    low = std::max(low, std::min(s, t));
    high = std::min(high, std::max(s, t));
  }
  return low <= high && !within;
}

TEST_CASE("translations are decided exactly, touching included") {
  Random random(524);
  const Mesh<double> box = contact::box_mesh({-2, -2, -2}, {2, 2, 2});
  int hits = 0;
  for (int i = 0; i < generators::tried(6000); ++i) {
    RigidMotion<double> motion;
    const bool on_grid = i % 2 == 0;
    motion.start.origin = on_grid ? whole(random, 3) : drawn(random, 3);
    motion.displacement = on_grid ? whole(random, 3) : drawn(random, 3);
    if (i % 4 == 1) {
      motion.start.axes = contact::matrix_of(contact::exponential<double>(drawn(random, 3)));
    } else if (i % 4 == 2) {
      motion.start.axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    }
    const Vector3<double> start = on_grid ? whole(random, 5) : drawn(random, 4);
    Segment<double> path{start, on_grid ? whole(random, 5) : drawn(random, 4)};
    if (i % 8 == 3) path.end = path.start + motion.displacement;  // at rest in the body
    const oracle::Vector from = oracle::exact(path.start) - oracle::exact(motion.start.origin);
    const oracle::Vector to = oracle::exact(path.end) - oracle::exact(motion.start.origin) -
                              oracle::exact(motion.displacement);
    oracle::Vector p, q;
    for (int k = 0; k < 3; ++k) {
      const oracle::Vector axis = oracle::exact(Vector3<double>(motion.start.axes.col(k)));
      p[k] = axis.dot(from);
      q[k] = axis.dot(to);
    }
    const MotionAnswer answer = contact::certified_moving_hit(path, box, motion);
    const bool hit = meets_surface(p, q, 2);
    REQUIRE(answer.verdict == (hit ? MotionVerdict::hit : MotionVerdict::free));
    hits += hit ? 1 : 0;
    if (hit) {
      // At from nothing is met yet, up to `to` there is a contact.
      const auto until = [&](double s) {
        return meets_surface(p, oracle::Vector(p + (q - p) * oracle::exact(s)), 2);
      };
      REQUIRE(until(answer.to));
      if (answer.from > 0) REQUIRE_FALSE(until(std::nextafter(answer.from, 0.0)));
    }
  }
  CHECK(hits > generators::tried(1000));
}

TEST_CASE(
    "what is not finite is undecided; an empty mesh is free; triangles without area are free") {
  const Mesh<double> box = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  RigidMotion<double> motion;
  motion.rotation = {0, 0, 1};
  const Segment<double> path{{-3, 0, 0}, {3, 0, 0}};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Segment<double> other = path;
    other.end.y() = bad;
    CHECK(contact::certified_moving_hit(other, box, motion).verdict == MotionVerdict::undecided);
    RigidMotion<double> moved = motion;
    moved.rotation.x() = bad;
    CHECK(contact::certified_moving_hit(path, box, moved).verdict == MotionVerdict::undecided);
    moved = motion;
    moved.start.axes(1, 2) = bad;
    CHECK(contact::certified_moving_hit(path, box, moved).verdict == MotionVerdict::undecided);
    Mesh<double> mesh = box;
    mesh.vertices[3].z() = bad;
    CHECK(contact::certified_moving_hit(path, mesh, motion).verdict == MotionVerdict::undecided);
  }
  CHECK(contact::certified_moving_hit(path, {}, motion).verdict == MotionVerdict::free);
  const Mesh<double> needle{{{0, 0, -1}, {0, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}};
  CHECK(contact::certified_moving_hit(path, needle, RigidMotion<double>{}).verdict ==
        MotionVerdict::free);
}

TEST_CASE("a whole turn with both poses equal: the chord sees nothing, the certified answer does") {
  const Mesh<double> blade = contact::box_mesh({-0.1, 1, -0.1}, {0.1, 3, 0.1});
  RigidMotion<double> motion;
  motion.rotation = {0, 0, 2 * std::acos(-1.0)};
  const Segment<double> path{{2, 0, 0}, {2, 0, 0}};
  CHECK_FALSE(contact::moving_by_substeps(path, blade, motion, 1));
  const MotionAnswer answer = contact::certified_moving_hit(path, blade, motion);
  CHECK(answer.verdict == MotionVerdict::hit);
  // The point comes in through the face x = −0.1.
  const double first = 0.75 - std::asin(0.05) / (2 * std::acos(-1.0));
  CHECK(answer.from <= first);
  CHECK(answer.to >= first);
  CHECK(answer.to - answer.from <= 0x1p-20);
}

TEST_CASE("any finite numbers give an answer") {
  Random random(525);
  const Mesh<double> box = contact::box_mesh({-1, -1, -1}, {1, 1, 1});
  for (int i = 0; i < generators::tried(300); ++i) {
    RigidMotion<double> motion;
    motion.start.origin = generators::any_vector(random);
    motion.displacement = generators::any_vector(random);
    motion.rotation = generators::any_vector(random);
    const Vector3<double> start = generators::any_vector(random);
    const Segment<double> path{start, generators::any_vector(random)};
    const MotionAnswer answer = contact::certified_moving_hit(path, box, motion, 16);
    REQUIRE(answer.from >= 0);
    REQUIRE(answer.to <= 1);
    REQUIRE(answer.chords <= 16);
    REQUIRE(contact::chord_bound(motion, path) >= 0);
    motion.rotation = Vector3<double>::Zero();
    REQUIRE(contact::certified_moving_hit(path, box, motion).verdict != MotionVerdict::undecided);
  }
}

}  // namespace
