// inertia.hpp against integrals and the parallel-axis theorem, in exact fractions.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rigid_body.hpp>
#include <limits>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

using contact::Matrix3;
using contact::Vector3;
using contact::VertexIndices;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using reference::direction;
using reference::Matrix;
using reference::positive;
using reference::rational_rotation;
using reference::u;
using reference::vector;
using support::contains;
using support::refusal;

namespace {

/// The Boole rule over [a, b]: exact for polynomials up to the fifth degree.
template <class F>
Rational integral(const F& f, const Rational& a, const Rational& b) {
  const Rational h = (b - a) / 4;
  return 2 * h / 45 *
         (7 * f(a) + 32 * f(Rational(a + h)) + 12 * f(Rational(a + 2 * h)) +
          32 * f(Rational(a + 3 * h)) + 7 * f(b));
}

const std::vector<VertexIndices> box_triangles{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                               {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                               {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

std::vector<Vector> box_corners(const Vector& size, const Vector& centre, const Matrix& rotation) {
  std::vector<Vector> corners;
  for (int k = 0; k < 8; ++k) {
    const Vector c{(k & 1 ? 1 : -1) * size.x() / 2, (k & 2 ? 1 : -1) * size.y() / 2,
                   (k & 4 ? 1 : -1) * size.z() / 2};
    corners.push_back(centre + Vector(rotation * c));
  }
  return corners;
}

}  // namespace

TEST_CASE("solids of revolution have the moments found by slicing, in exact fractions") {
  // A slice at z is a disc of radius ρ: ½ dm ρ² about the axis, dm (ρ²/4 + z²) about a
  // perpendicular one. With a density of 1/π a slice has the mass ρ² dz; ρ² is a polynomial of z,
  // so the integrals are exact.
  Random random(1701);
  for (int i = 0; i < 40; ++i) {
    const Rational r = positive(random);
    const Rational h = positive(random);
    const Rational half = h / 2;
    const auto inside = [&](const Rational&) { return Rational(r * r); };
    const auto cap = [&](const Rational& z) { return Rational(r * r - (z - half) * (z - half)); };
    const auto sum = [&](const auto& f, bool with_middle, bool with_caps) {
      Rational total = 0;
      if (with_middle) {
        total += integral([&](const Rational& z) { return f(inside(z), z); }, -half, half);
      }
      if (with_caps) {
        total +=
            2 * integral([&](const Rational& z) { return f(cap(z), z); }, half, Rational(half + r));
      }
      return total;
    };
    const auto weight = [](const Rational& s, const Rational&) { return s; };
    const auto along = [](const Rational& s, const Rational&) { return Rational(s * s / 2); };
    const auto transverse = [](const Rational& s, const Rational& z) {
      return Rational(s * (s / 4 + z * z));
    };
    const Matrix cylinder = contact::cylinder_inertia<Rational>(sum(weight, true, false), r, h);
    CHECK(cylinder(2, 2) == sum(along, true, false));
    CHECK(cylinder(0, 0) == sum(transverse, true, false));
    const Matrix capsule = contact::capsule_inertia<Rational>(sum(weight, true, true), r, h);
    CHECK(capsule(2, 2) == sum(along, true, true));
    CHECK(capsule(0, 0) == sum(transverse, true, true));
    CHECK(capsule(1, 1) == capsule(0, 0));
    // Without its cylinder it is a sphere.
    const Rational m = positive(random);
    CHECK(contact::capsule_inertia<Rational>(m, r, 0) == contact::sphere_inertia<Rational>(m, r));
    CHECK(contact::sphere_inertia<Rational>(m, r)(0, 0) == 2 * m * r * r / 5);
  }
}

TEST_CASE("a mesh of a box has the box's mass, centre of mass and tensor, in exact fractions") {
  Random random(1702);
  for (int i = 0; i < 20; ++i) {
    const Vector size{positive(random), positive(random), positive(random)};
    const Rational density = positive(random);
    const Vector centre = vector(random);
    const Matrix turn = rational_rotation(random);
    const auto got =
        contact::mesh_mass<Rational>(density, box_corners(size, centre, turn), box_triangles);
    REQUIRE(got.has_value());
    CHECK(got->mass == density * size.x() * size.y() * size.z());
    CHECK(got->centre == centre);
    const Matrix right =
        contact::rotated<Rational>(contact::box_inertia<Rational>(got->mass, size), turn);
    CHECK(got->inertia == right);
    // A box's moment about x by integration over y and z.
    const Rational by_hand = density * size.x() *
                             (size.z() * integral([](const Rational& y) { return Rational(y * y); },
                                                  -size.y() / 2, size.y() / 2) +
                              size.y() * integral([](const Rational& z) { return Rational(z * z); },
                                                  -size.z() / 2, size.z() / 2));
    CHECK(contact::box_inertia<Rational>(got->mass, size)(0, 0) == by_hand);
  }
  // Inside out, flat, or nothing at all.
  std::vector<VertexIndices> reversed = box_triangles;
  for (VertexIndices& corners : reversed) std::swap(corners[0], corners[1]);
  const auto corners = box_corners({1, 1, 1}, {0, 0, 0}, Matrix::Identity());
  CHECK_FALSE(contact::mesh_mass<Rational>(1, corners, reversed).has_value());
  CHECK_FALSE(contact::mesh_mass<Rational>(1, box_corners({1, 1, 0}, {0, 0, 0}, Matrix::Identity()),
                                           box_triangles)
                  .has_value());
  CHECK_FALSE(contact::mesh_mass<Rational>(1, corners, {}).has_value());
}

TEST_CASE("a mesh far from the origin keeps the digits of its vertices") {
  Random random(1703);
  for (int i = 0; i < 20; ++i) {
    const Vector3<double> far{random.magnitude(20, 24), random.magnitude(20, 24), 0};
    std::vector<Vector3<double>> vertices;
    std::vector<Vector> stored;
    for (const Vector& corner : box_corners({2, 3, 1}, Vector::Zero(), Matrix::Identity())) {
      vertices.push_back(far + oracle::nearest(corner));
      stored.push_back(oracle::exact(vertices.back()));
    }
    const auto got = contact::mesh_mass<double>(1, vertices, box_triangles);
    const auto right = contact::mesh_mass<Rational>(1, stored, box_triangles);
    REQUIRE(got.has_value());
    for (int k = 0; k < 3; ++k) {
      CHECK(oracle::error(got->inertia(k, k), right->inertia(k, k)) <= 1e-13);
      // γ(22) of the magnitudes of twelve tetrahedra about a point near the centre, a few times the
      // tensor's own 6.5; and the centre of mass to the spacing of doubles there.
      CHECK(oracle::error(got->centre(k), right->centre(k)) <= 0x1p-28);
    }
  }
}

TEST_CASE("the parallel-axis theorem and composite bodies, in exact fractions") {
  Random random(1704);
  for (int i = 0; i < 40; ++i) {
    // Two boxes end to end are one box.
    const Vector size{positive(random), positive(random), positive(random)};
    const Rational mass = positive(random);
    const Rational share = Rational(random.integer(1, 9)) / 10;
    const Rational left = size.x() * share;
    const Rational right = size.x() - left;
    const Vector corner = vector(random);
    const auto part = [&](const Rational& length, const Rational& start) {
      const Rational m = mass * length / size.x();
      return contact::MassProperties<Rational>{
          m, corner + Vector(start + length / 2, 0, 0),
          contact::box_inertia<Rational>(m, {length, size.y(), size.z()})};
    };
    const auto whole = contact::combine<Rational>({part(left, 0), part(right, left)});
    REQUIRE(whole.has_value());
    CHECK(whole->mass == mass);
    CHECK(whole->centre == corner + Vector(size.x() / 2, 0, 0));
    CHECK(whole->inertia == contact::box_inertia<Rational>(mass, size));
    // m |ω × d|² is twice the kinetic energy that the offset adds.
    const Vector d = vector(random);
    const Vector w = vector(random);
    const Vector moved = Vector(w.cross(d));
    const Vector added = contact::parallel_axis<Rational>(mass, d) * w;
    CHECK(w.dot(added) == mass * moved.dot(moved));
  }
  CHECK_FALSE(contact::combine<double>({}).has_value());
}

TEST_CASE("principal axes give the tensor back") {
  Random random(1705);
  for (int i = 0; i < 400; ++i) {
    Vector3<double> moments{std::abs(random.magnitude(-20, 20)),
                            std::abs(random.magnitude(-20, 20)),
                            std::abs(random.magnitude(-20, 20))};
    if (random.chance(0.3)) moments.y() = moments.x();
    const Matrix3<double> turn = contact::matrix_of(
        contact::exponential<double>(Vector3<double>(direction(random) * random.uniform(0, 3))));
    const Matrix3<double> inertia = contact::rotated<double>(moments.asDiagonal(), turn);
    const auto got = contact::principal_axes<double>(inertia);
    const double largest = moments.maxCoeff();
    // At most 12 iterations of three rotations, each a few roundings of the largest entry.
    const double room = 400 * u * largest;
    const Matrix3<double> again = contact::rotated<double>(got.moments.asDiagonal(), got.rotation);
    CHECK((again - inertia).cwiseAbs().maxCoeff() <= room);
    CHECK((got.rotation.transpose() * got.rotation - Matrix3<double>::Identity())
              .cwiseAbs()
              .maxCoeff() <= 400 * u);
    CHECK(got.rotation.determinant() > 0);
    CHECK((got.moments.x() <= got.moments.y() && got.moments.y() <= got.moments.z()));
  }
}

TEST_CASE("constructions refuse bad input, naming it") {
  const Vector3<double> zero(0, 0, 0);
  const Matrix3<double> one = Matrix3<double>::Identity();
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, inf, nan, 5e-324}) {
    CHECK(contains(refusal([&] { contact::rigid_body<double>(bad, one, zero, zero, zero); }),
                   "mass = "));
  }
  CHECK(contains(refusal([&] { contact::rigid_body<double>(1, -one, zero, zero, zero); }),
                 "positive definite"));
  Matrix3<double> skew = one;
  skew(0, 1) = 0.1;
  CHECK(contains(refusal([&] { contact::rigid_body<double>(1, skew, zero, zero, zero); }),
                 "symmetric"));
  skew(0, 1) = nan;
  CHECK(
      contains(refusal([&] { contact::rigid_body<double>(1, skew, zero, zero, zero); }), "finite"));
  CHECK(contains(refusal([&] {
                   contact::rigid_body<double>(1, one, zero, {nan, 0, 0}, zero);
                 }),
                 "velocity"));
  CHECK(contains(refusal([&] {
                   contact::immovable<double>(zero, zero, {0, inf, 0});
                 }),
                 "angular_velocity"));
  CHECK(contains(refusal([&] {
                   contact::rigid_body_from_axes<double>(1, {1, 0, 1}, one, zero, zero, zero);
                 }),
                 "moments = 0"));
  CHECK(contains(refusal([&] {
                   contact::rigid_body_from_axes<double>(1, {1, 1, 1}, Matrix3<double>(one * nan),
                                                         zero, zero, zero);
                 }),
                 "rotation"));
  CHECK(contains(refusal([] { contact::sphere_inertia<double>(1, 0); }), "radius = 0"));
  CHECK(contains(refusal([] { contact::box_inertia<double>(1, {1, -2, 1}); }), "size = -2"));
  CHECK(contains(refusal([] { contact::cylinder_inertia<double>(1, 1, 0); }), "height = 0"));
  CHECK(contains(refusal([] { contact::capsule_inertia<double>(1, 1, -1); }), "height = -1"));
  CHECK(contains(refusal([&] { contact::mesh_mass<double>(0, {zero}, {}); }), "density"));
  CHECK(contains(refusal([&] { contact::mesh_mass<double>(1, {{inf, 0, 0}}, {}); }), "vertices"));
  CHECK(contains(refusal([&] {
                   contact::mesh_mass<double>(1, {zero}, {{0, 0, 1}});
                 }),
                 "triangles = 1"));
}
