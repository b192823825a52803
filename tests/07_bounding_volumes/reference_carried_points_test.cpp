#include <07_bounding_volumes/carried_truth.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/carried_points.hpp>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace carried_points_test {

using carried_truth::any_frame;
using carried_truth::image;
using contact::CoordinateFrame;
using contact::Kdop;
using contact::kdop_of_carried;
using contact::Vector3;
using generators::Random;
using oracle::Rational;

template <class S>
using Points = std::vector<Vector3<S>>;

template <class S>
Kdop<S> around(const Points<S>& points, const CoordinateFrame<S>& frame, int k = 26) {
  return kdop_of_carried<S>(contact::kdop_normals<S>(k), points, frame);
}
template <class S>
int images_outside(const Kdop<S>& dop, const Points<S>& points, const CoordinateFrame<S>& frame) {
  int outside = 0;
  for (const auto& p : points) {
    outside += carried_truth::inside(dop, image(frame, oracle::exact(p))) ? 0 : 1;
  }
  return outside;
}

template <class S>
void contains_images(std::uint64_t seed, S scale) {
  Random random(seed);
  for (int i = 0; i < generators::tried(88); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    INFO(volume_families::name(family) << ", set " << i);
    const auto points =
        volume_families::scaled<S>(volume_families::points<S>(random, family, 12), scale);
    CoordinateFrame<S> frame = any_frame<S>(random);
    frame.origin *= scale;
    REQUIRE(images_outside(around<S>(points, frame), points, frame) == 0);
  }
}

TEST_CASE("slabs made again contain the exact images") {
  contains_images<double>(1, 1);
  contains_images<float>(2, 1);
}

TEST_CASE("slabs made again contain the exact images at other scales") {
  contains_images<double>(3, 1e150);
  contains_images<double>(4, 1e-150);
  contains_images<double>(5, 1e-310);
  contains_images<float>(6, 1e20F);
  contains_images<float>(7, 1e-40F);
}

TEST_CASE("slabs made again are wider than the smallest by some ulps of the coordinates") {
  Random random(8);
  for (int i = 0; i < generators::tried(110); ++i) {
    const auto family =
        volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
    const auto points = volume_families::points<double>(random, family, 12);
    const auto frame = any_frame<double>(random);
    const Kdop<double> dop = around<double>(points, frame);
    Rational size = 0;  // of the largest |A||p| + |o|
    for (const auto& p : points) {
      const Vector3<double> all = frame.axes.cwiseAbs() * p.cwiseAbs() + frame.origin.cwiseAbs();
      size = std::max(size, oracle::exact(3 * all.maxCoeff()));
    }
    for (std::size_t k = 0; k < dop.normals.size(); ++k) {
      std::vector<Rational> at;
      for (const auto& p : points) {
        at.push_back(oracle::exact(dop.normals[k]).dot(image(frame, oracle::exact(p))));
      }
      const auto [low, high] = std::minmax_element(at.begin(), at.end());
      INFO(volume_families::name(family) << ", normal " << k);
      REQUIRE(*low - oracle::exact(dop.low[k]) <= 64 * rounding::u<double>() * size);
      REQUIRE(oracle::exact(dop.high[k]) - *high <= 64 * rounding::u<double>() * size);
    }
  }
}

TEST_CASE("a box made again is the first three slabs") {
  Random random(9);
  const auto points = volume_families::points<double>(random, volume_families::Family::in_box, 20);
  const auto frame = any_frame<double>(random);
  const auto box = contact::aabb_of_carried_points<double>(points, frame);
  const Kdop<double> dop = around<double>(points, frame);
  for (int k = 0; k < 3; ++k) {
    CHECK(box.low[k] == dop.low[static_cast<std::size_t>(k)]);
    CHECK(box.high[k] == dop.high[static_cast<std::size_t>(k)]);
  }
}

TEST_CASE(
    "slabs made again refuse no point, no normal, 0 as a normal, what is not finite, overflow") {
  const auto frame = CoordinateFrame<double>{};
  const auto normals = contact::kdop_normals<double>(6);
  const Points<double> one{{1, 2, 3}};
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(kdop_of_carried<double>(normals, Points<double>{}, frame), std::invalid_argument);
  CHECK_THROWS_AS(kdop_of_carried<double>({}, one, frame), std::invalid_argument);
  CHECK_THROWS_AS(kdop_of_carried<double>({{0, 0, 0}}, one, frame), std::invalid_argument);
  CHECK_THROWS_AS(around<double>({{1, 2, infinity}}, frame), std::invalid_argument);
  auto bad = frame;
  bad.origin.x() = std::nan("");
  CHECK_THROWS_AS(around<double>(one, bad), std::invalid_argument);
  CHECK_THROWS_AS(around<double>({{1.7e308, 1.7e308, 0}}, frame), std::invalid_argument);
}

}  // namespace carried_points_test
