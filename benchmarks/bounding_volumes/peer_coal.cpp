// Coal: its box along the principal axes, and its tests of two boxes and of two k-DOPs.
#include <coal/BV/AABB.h>
#include <coal/BV/OBB.h>
#include <coal/BV/kDOP.h>
#include <coal/internal/BV_fitter.h>

#include "peers.hpp"

namespace {

coal::Vec3s vector(const peers::Numbers& p) { return {p[0], p[1], p[2]}; }
peers::Numbers numbers(const coal::Vec3s& v) { return {v[0], v[1], v[2]}; }

std::vector<coal::Vec3s> points_of(const peers::Points& from) {
  std::vector<coal::Vec3s> points;
  for (const peers::Numbers& p : from) points.push_back(vector(p));
  return points;
}

template <class Volume>
Volume fitted(std::vector<coal::Vec3s> points) {
  Volume volume;
  coal::fit(points.data(), static_cast<unsigned>(points.size()), volume);
  return volume;
}

peers::Box box_of(std::vector<coal::Vec3s>& points) {
  coal::OBB volume;
  coal::fit(points.data(), static_cast<unsigned>(points.size()), volume);
  return {numbers(volume.To),
          {numbers(volume.axes.col(0)), numbers(volume.axes.col(1)), numbers(volume.axes.col(2))},
          numbers(volume.extent)};
}

bool overlap(const auto& first, const auto& second) { return first.overlap(second); }

template <short k>
peers::PairTest<peers::Points> kdop_test(const char* name) {
  return peers::pair_test<peers::Points>(
      name, [](const peers::Points& points) { return fitted<coal::KDOP<k>>(points_of(points)); },
      [](const auto& first, const auto& second) { return overlap(first, second); });
}

}  // namespace

std::vector<peers::Fit<peers::Box>> peers::coal_boxes() {
  return {fit<Box>("Coal, fit of an OBB", points_of, box_of)};
}

std::vector<peers::PairTest<peers::Limits>> peers::coal_limits_pairs() {
  return {pair_test<Limits>(
      "Coal, AABB",
      [](const Limits& limits) { return ::coal::AABB(vector(limits.low), vector(limits.high)); },
      [](const auto& first, const auto& second) { return overlap(first, second); })};
}

std::vector<peers::PairTest<peers::Box>> peers::coal_box_pairs() {
  return {pair_test<Box>(
      "Coal, OBB",
      [](const Box& box) {
        ::coal::OBB volume;
        volume.To = vector(box.centre);
        for (std::size_t i = 0; i < 3; ++i) {
          volume.axes.col(static_cast<Eigen::Index>(i)) = vector(box.axes[i]);
        }
        volume.extent = vector(box.half_lengths);
        return volume;
      },
      [](const auto& first, const auto& second) { return overlap(first, second); })};
}

std::vector<peers::PairTest<peers::Points>> peers::coal_kdop_pairs() {
  return {kdop_test<16>("Coal, 16-DOP"), kdop_test<18>("Coal, 18-DOP"),
          kdop_test<24>("Coal, 24-DOP")};
}
