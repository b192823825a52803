// Right answers come from exact arithmetic on the numbers as they are stored. Every test expects a
// hit and a miss.
#include "segment_plane.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using Hit = contact::RayHit<double>;
using Plane = contact::Plane<double>;
using Segment = contact::Segment<double>;
using Vector = Eigen::Vector3d;

std::optional<Hit> exact_hit(const Segment& segment, const Plane& plane) {
  using V = contact::Vector3<Exact>;
  const V n = plane.normal.cast<Exact>();
  const V start = segment.start.cast<Exact>(), end = segment.end.cast<Exact>();
  const Exact d0 = n.dot(start) - Exact(plane.offset), d1 = n.dot(end) - Exact(plane.offset);
  if (d0.sign() * d1.sign() > 0 || (d0 - d1).sign() == 0) return std::nullopt;
  const Exact way = d0 - d1;
  const auto coordinate = [&](int i) {
    return quotient<double>(start[i] * way + d0 * (end[i] - start[i]), way);
  };
  return Hit{quotient<double>(d0, way), {coordinate(0), coordinate(1), coordinate(2)}};
}

/// A distance is off by 4 u (|n·x| term by term + |k|), so t by twice that over |d₀ − d₁| and a few
/// u; the point by t's error along the segment and a few u of its coordinates. 16 instead of 8.
std::optional<Hit> bound(const Segment& segment, const Plane& plane) {
  const double start = plane.normal.cwiseAbs().dot(segment.start.cwiseAbs());
  const double end = plane.normal.cwiseAbs().dot(segment.end.cwiseAbs());
  const double way = std::abs(plane.normal.dot(segment.end - segment.start));
  if (way == 0) return Hit{};
  const double t = 16 * 0x1p-53 * ((start + end + 2 * std::abs(plane.offset)) / way + 1);
  const double largest = std::max(segment.start.norm(), segment.end.norm());
  return Hit{t, Vector::Constant(t * (segment.end - segment.start).norm() + 8 * 0x1p-53 * largest)};
}

enum class Mistake {
  one_sided,
  fraction_from_the_end,
  hits_beyond_the_end,
  touching_rejected,
  product_of_signs,
  metres_for_fraction,
  absolute_epsilon
};

std::optional<Hit> mistaken(const Segment& segment, const Plane& plane, Mistake mistake) {
  const double d0 = plane.normal.dot(segment.start) - plane.offset;
  const double d1 = plane.normal.dot(segment.end) - plane.offset;
  if (d0 == d1) return std::nullopt;
  if (std::abs(d0 - d1) < 1e-9 && mistake == Mistake::absolute_epsilon) return std::nullopt;
  double t = d0 / (d0 - d1);
  switch (mistake) {
    case Mistake::one_sided:
      if (d0 < 0 || d1 > 0) return std::nullopt;
      break;
    case Mistake::fraction_from_the_end:
      if (t < 0 || t > 1) return std::nullopt;
      t = 1 - t;
      break;
    case Mistake::hits_beyond_the_end:
      if (t < 0) return std::nullopt;
      break;
    case Mistake::touching_rejected:
      if (t <= 0 || t >= 1) return std::nullopt;
      break;
    case Mistake::product_of_signs:
      if (d0 * d1 > 0) return std::nullopt;
      break;
    case Mistake::metres_for_fraction: {
      const double metres = t * (segment.end - segment.start).norm();
      if (metres < 0 || metres > 1) return std::nullopt;
      t = metres;
      break;
    }
    case Mistake::absolute_epsilon:
      if (t < 0 || t > 1) return std::nullopt;
      break;
  }
  return Hit{t, segment.start + t * (segment.end - segment.start)};
}

void check(const Segment& segment, const Plane& plane,
           std::initializer_list<Mistake> mistakes = {}) {
  constexpr std::string_view kIds[] = {
      "one-sided",        "fraction-from-the-end", "hits-beyond-the-end", "touching-rejected",
      "product-of-signs", "metres-for-fraction",   "absolute-epsilon"};
  std::vector<Suspect<std::optional<Hit>>> suspects;
  for (const Mistake mistake : mistakes) {
    suspects.push_back({kIds[static_cast<std::size_t>(mistake)],
                        [&segment, &plane, mistake] { return mistaken(segment, plane, mistake); }});
  }
  const auto not_a_number = [](const std::optional<Hit>& hit) {
    return hit && !(std::isfinite(hit->t) && hit->point.allFinite());
  };
  ask("Where does the segment meet the plane?")
      .given("segment", segment)
      .given("plane", plane)
      .suspects(std::move(suspects))
      .suspect_if("division-by-zero", not_a_number)
      .answer([&] { return exercise::segment_plane(segment, plane); })
      .close_to(exact_hit(segment, plane), within(bound(segment, plane)));
}

// z = 3, seen from above; and an oblique plane, as stored.
const Plane kLevel{{0, 0, 1}, 3};
const Plane kLeaning{{0.6, 0, 0.8}, 2};

}  // namespace

TEST_CASE("a segment through the plane meets it at a fraction of its length") {
  // A segment of one metre first: an answer that is right here and wrong next measures t in metres.
  check({{0, 0, 3.25}, {0, 0, 2.25}}, kLevel, {Mistake::fraction_from_the_end});
  check({{0, 0, 4}, {8, 4, 0}}, kLevel,
        {Mistake::fraction_from_the_end, Mistake::metres_for_fraction});
  check({{1, 2, 11}, {1, 2, 2}}, kLevel, {Mistake::fraction_from_the_end});
  check({{5, 1, 5}, {-5, 1, -2}}, kLeaning, {Mistake::fraction_from_the_end});
  check({{1, 2, 11}, {1, 2, 4}}, kLevel, {Mistake::hits_beyond_the_end});
}

TEST_CASE("a segment on one side of the plane does not meet it") {
  check({{0, 0, 4}, {8, 4, 0}}, kLevel);
  check({{0, 0, 9}, {8, 4, 4}}, kLevel, {Mistake::hits_beyond_the_end});
  check({{0, 0, 4}, {8, 4, 9}}, kLevel);
  check({{0, 0, -5}, {8, 4, 2}}, kLevel, {Mistake::hits_beyond_the_end});
}

TEST_CASE("the plane is met from the front and from the back") {
  check({{0, 0, 4}, {8, 4, 0}}, kLevel);
  check({{8, 4, 0}, {0, 0, 4}}, kLevel, {Mistake::one_sided});
  check({{0, 0, 5}, {8, 4, 4}}, kLevel);
}

TEST_CASE("an end on the plane counts") {
  check({{0, 0, 5}, {8, 4, 4}}, kLevel);
  check({{1, 2, 3}, {1, 2, -5}}, kLevel, {Mistake::touching_rejected});
  check({{1, 2, 3.5}, {1, 2, 3}}, kLevel, {Mistake::touching_rejected});
  // From back to front a miss has another cause as well.
  check({{1, 2, 3}, {1, 2, 5}}, kLevel);
  check({{1, 2, -7}, {4, 2, 3}}, kLevel);
}

TEST_CASE("a segment in the plane, or of no length, has no single point") {
  check({{0, 0, 4}, {8, 4, 0}}, kLevel);
  check({{0, 0, 3}, {8, 4, 3}}, kLevel);
  check({{0, 0, 5}, {8, 4, 5}}, kLevel);
  check({{1, 2, 3}, {1, 2, 3}}, kLevel);
  check({{1, 2, 4}, {1, 2, 4}}, kLevel);
}

TEST_CASE("tiny distances keep their signs") {
  const Plane floor{{0, 0, 1}, 0};
  check({{0, 0, 1}, {1, 0, -1}}, floor);
  check({{0, 0, 0x1p-600}, {1, 0, -0x1p-600}}, floor, {Mistake::absolute_epsilon});
  // The same at a size whose products are not zero: a failure here is not due to the size.
  check({{0, 0, 4}, {1, 0, 8}}, floor);
  check({{0, 0, 8}, {1, 0, 2}}, floor, {Mistake::hits_beyond_the_end});
  check({{0, 0, 0x1p-600}, {1, 0, 0x1p-599}}, floor, {Mistake::product_of_signs});
  check({{0, 0, -0x1p-598}, {1, 0, -0x1p-600}}, floor, {Mistake::product_of_signs});
}

TEST_CASE("random segments agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&] {
    return Vector{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8)};
  };
  for (int asked = 0; asked < 500;) {
    const Segment segment{vector(), vector()};
    const Vector normal = vector();
    if (normal.norm() < 1) continue;
    const Plane plane{normal.normalized(), random.uniform(-6, 6)};
    // An end within rounding error of the plane may be classified either way.
    const double d0 = plane.normal.dot(segment.start) - plane.offset;
    const double d1 = plane.normal.dot(segment.end) - plane.offset;
    if (std::min({std::abs(d0), std::abs(d1), std::abs(d0 - d1)}) < 1e-3) continue;
    ++asked;
    // Only mistakes that return a number: a miss has too many causes here.
    check(segment, plane, {Mistake::fraction_from_the_end, Mistake::hits_beyond_the_end});
  }
}
