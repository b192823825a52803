// drop_dimension.hpp against rational arithmetic.
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/drop_dimension.hpp>
#include <support/generators.hpp>
#include <support/oracle.hpp>

TEST_CASE("the cross product of two projections is the dropped coordinate of the cross product") {
  generators::Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const auto p = oracle::exact(generators::point(random, generators::Family::random));
    const auto q = oracle::exact(generators::point(random, generators::Family::random));
    const oracle::Vector full = p.cross(q);
    for (int k = 0; k < 3; ++k) {
      REQUIRE(contact::cross2<oracle::Rational>(contact::drop_dimension(p, k),
                                                contact::drop_dimension(q, k)) == full[k]);
    }
    const int largest = contact::largest_dimension(full);
    for (int k = 0; k < 3; ++k) REQUIRE(abs(full[largest]) >= abs(full[k]));
  }
}

TEST_CASE("of equal coordinates the first is the largest") {
  REQUIRE(contact::largest_dimension(contact::Vector3<double>(2, -2, 2)) == 0);
  REQUIRE(contact::largest_dimension(contact::Vector3<double>(1, -3, 3)) == 1);
  REQUIRE(contact::largest_dimension(contact::Vector3<double>(0, 0, 0)) == 0);
}
