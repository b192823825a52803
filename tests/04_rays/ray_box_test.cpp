// Which of two t is larger is decided without rounding. Every test asks for a hit somewhere, so
// "nothing, always" earns nothing. Ties are only asked for where no method rounds.
#include "ray_box.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <04_rays/exact_lines.hpp>

namespace {

using namespace contact::testing;
using exercise::Box;
using exercise::Entry;
using Found = std::optional<Entry>;
using Ray = contact::Ray<double>;
using Vector = Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A quotient with a positive divisor.
struct Fraction {
  contact::Exact over, under{1.0};

  friend bool operator<(const Fraction& x, const Fraction& y) {
    return (x.over * y.under - y.over * x.under).sign() < 0;
  }
};

Found right(const Ray& ray, const Box& box) {
  std::optional<Fraction> latest, earliest;
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    const contact::Exact along = ray.direction[k];
    Fraction near{contact::Exact(box.low[k]) - ray.origin[k], abs(along)};
    Fraction far{contact::Exact(box.high[k]) - ray.origin[k], abs(along)};
    if (along.sign() == 0) {
      if (near.over.sign() > 0 || far.over.sign() < 0) return std::nullopt;
      continue;
    }
    if (along.sign() < 0) {
      std::swap(near.over, far.over);
      near.over = -near.over;
      far.over = -far.over;
    }
    if (!latest || *latest < near) {
      latest = near;
      axis = k;
    }
    if (!earliest || far < *earliest) earliest = far;
  }
  if (earliest && (*earliest < *latest || earliest->over.sign() < 0)) return std::nullopt;
  if (!latest || latest->over.sign() < 0) return Entry{0, -1};
  return Entry{quotient<double>(latest->over, latest->under), axis};
}

enum class Mistake {
  direction_normalised,
  first_slab_entered,
  slab_ends_not_exchanged,
  absolute_epsilon,
  hits_behind_origin,
  start_inside_missed,
  exit_for_entry,
  parallel_called_a_miss,
  parallel_slab_skipped,
  touching_rejected,
  tie_to_the_highest_axis,
};
constexpr std::string_view kIds[] = {
    "direction-normalised", "first-slab-entered",     "slab-ends-not-exchanged",
    "absolute-epsilon",     "hits-behind-origin",     "start-inside-missed",
    "exit-for-entry",       "parallel-called-a-miss", "parallel-slab-skipped",
    "touching-rejected",    "tie-to-the-highest-axis"};

/// The slabs with one mistake in them.
Found mistaken(const Ray& ray, const Box& box, Mistake mistake) {
  const auto is = [mistake](Mistake other) { return mistake == other; };
  Vector d = ray.direction;
  if (is(Mistake::direction_normalised)) d.normalize();
  Entry latest{-kInfinity, -1}, first{kInfinity, -1}, earliest{kInfinity, -1};
  for (int k = 0; k < 3; ++k) {
    const double from = ray.origin[k];
    if (d[k] == 0 || (is(Mistake::absolute_epsilon) && std::abs(d[k]) < 1e-6)) {
      if (is(Mistake::parallel_called_a_miss)) return std::nullopt;
      if (is(Mistake::parallel_slab_skipped)) continue;
      if (from < box.low[k] || from > box.high[k]) return std::nullopt;
      if (is(Mistake::touching_rejected) && (from == box.low[k] || from == box.high[k]))
        return std::nullopt;
      continue;
    }
    double entry = (box.low[k] - from) / d[k], exit = (box.high[k] - from) / d[k];
    if (d[k] < 0 && !is(Mistake::slab_ends_not_exchanged)) std::swap(entry, exit);
    if (entry > latest.t || (is(Mistake::tie_to_the_highest_axis) && entry == latest.t))
      latest = {entry, k};
    if (entry < first.t) first = {entry, k};
    if (exit < earliest.t) earliest = {exit, k};
  }
  if (latest.t > earliest.t) return std::nullopt;
  if (is(Mistake::touching_rejected) && (latest.t >= earliest.t || earliest.t <= 0))
    return std::nullopt;
  if (earliest.t < 0 && !is(Mistake::hits_behind_origin)) return std::nullopt;
  if (latest.t < 0 && is(Mistake::start_inside_missed)) return std::nullopt;
  if (latest.t < 0 && is(Mistake::exit_for_entry)) return earliest;
  if (is(Mistake::first_slab_entered)) latest = first;
  if (latest.t < 0) return Entry{0, -1};
  return latest;
}

/// Asks once. `mistakes` are those that this input tells from everything else.
void check_for(const Ray& ray, const Box& box, const std::vector<Mistake>& mistakes) {
  std::vector<Suspect<Found>> suspects;
  for (const Mistake mistake : mistakes) {
    suspects.push_back({kIds[static_cast<std::size_t>(mistake)],
                        [&ray, &box, mistake] { return mistaken(ray, box, mistake); }});
  }
  const Found expected = right(ray, box);
  // In the plane of a face: 0 is multiplied by the reciprocal of 0, or divided by 0.
  const auto in_a_face = [&](const Found& got) {
    for (int k = 0; k < 3; ++k) {
      const bool on = ray.origin[k] == box.low[k] || ray.origin[k] == box.high[k];
      if (on && ray.direction[k] == 0 && expected) return !got || std::isnan(got->t);
    }
    return false;
  };
  // A division and a subtraction are rounded, and perhaps a reciprocal.
  const double allowed = expected ? 0x1p-48 * (expected->t + std::abs(expected->t)) : 0;
  ask("Where does the ray enter the box?")
      .given("ray", ray)
      .given("box", box)
      .suspects(std::move(suspects))
      .suspect_if("zero-times-infinity", [&](const Found& got) { return in_a_face(got); })
      .answer([&] { return exercise::ray_box(ray, box); })
      .close_to(expected, within(allowed));
}
void check(const Ray& ray, const Box& box) {
  check_for(
      ray, box,
      {Mistake::direction_normalised, Mistake::first_slab_entered, Mistake::slab_ends_not_exchanged,
       Mistake::hits_behind_origin, Mistake::exit_for_entry, Mistake::tie_to_the_highest_axis});
}

const Box kBox{{2, -1, -2}, {6, 3, 4}};

}  // namespace

TEST_CASE("a ray enters the box when it has entered all slabs") {
  check({{0, -4, -5}, {1, 2, 2}}, kBox);
  check({{-6, -2.5, -3}, {4, 1, 1}}, kBox);
  check({{1, -6, -4}, {0.5, 2, 2}}, kBox);
  check({{0, -4, -12}, {1, 2, 4}}, kBox);
  check({{-8, -3, -4}, {2, 1, 1}}, kBox);
  check({{0, -4, -8}, {0.5, 1, 4}}, kBox);
}

TEST_CASE("a ray may go down an axis") {
  check({{4, 7, -1}, {0.25, -2, 0.5}}, kBox);
  check({{8, 1, 9}, {-1, 0.25, -2}}, kBox);
  check({{10, 8, 8.5}, {-2, -2, -2}}, kBox);
  check({{7, 0, 1}, {-1, -1, 4}}, kBox);
}

TEST_CASE("t is in multiples of the direction, however short") {
  for (const double length : {1.0, 0x1p-30, 0x1p30, 0x1p-300}) {
    const Vector direction = length * Vector(1, 2, 2);
    check_for({{0, -4, -5}, direction}, kBox,
              {Mistake::direction_normalised, Mistake::absolute_epsilon});
  }
}

TEST_CASE("a box behind the start or beside the ray is missed") {
  check({{0, -4, -5}, {1, 2, 2}}, kBox);
  check({{8, 12, 10}, {1, 2, 2}}, kBox);
  check({{0, -4, -5}, {-1, -2, -2}}, kBox);
  check({{0, 0, -6}, {1, 2, 2}}, kBox);
  check({{0, -4, 2}, {1, 2, 2}}, kBox);
  check({{3, -4, -6}, {4, 2, 2}}, kBox);
}

TEST_CASE("a ray that starts in the box is in it at once") {
  const auto check_inside = [](const Ray& ray) {
    check_for(ray, kBox, {Mistake::start_inside_missed, Mistake::exit_for_entry});
  };
  check_inside({{3, 0, 1}, {1, 2, 4}});
  check_inside({{3, 0, 1}, {-1, -2, 1}});
  check_inside({{5, 2.5, -1.5}, {1, -0.5, 0.25}});
}

TEST_CASE("a ray parallel to a face is in that slab always or never") {
  const auto check_parallel = [](const Ray& ray) {
    check_for(ray, kBox, {Mistake::parallel_called_a_miss, Mistake::parallel_slab_skipped});
  };
  check_parallel({{0, 1, -4}, {1, 0, 2}});
  check_parallel({{0, 1, -4}, {1, -0.0, 2}});
  check_parallel({{4, 1, 8}, {0, 0, -2}});
  check_parallel({{3, 2, 1}, {0, 0, -2}});
  check_parallel({{0, 5, -4}, {1, 0, 2}});
  check_parallel({{0, -2, -4}, {1, -0.0, 2}});
  check_parallel({{7, 1, 8}, {0, 0, -2}});
  check_parallel({{4, -1.5, 8}, {0, 0, -2}});
  check_parallel({{1, 1, 8}, {-0.0, 0, -2}});
}

TEST_CASE("touching a corner, an edge or a flat box counts") {
  const auto check_touching = [](const Ray& ray, const Box& box) {
    check_for(ray, box, {Mistake::touching_rejected, Mistake::tie_to_the_highest_axis});
  };
  // Through an edge, into the box.
  check_touching({{0, -3, 0}, {2, 2, 0.5}}, kBox);
  check_touching({{4, 5, 6}, {0.25, -1, -1}}, kBox);
  // Past an edge, and past a corner.
  check_touching({{0, 1, 1}, {1, -1, 0.5}}, kBox);
  check_touching({{4, 4, 0}, {2, -1, 4}}, kBox);
  check_touching({{0, -3, -4}, {2, 2, 2}}, kBox);
  // The start is on a face: into the box, and away from it.
  check_touching({{2, 1, 1}, {1, 2, 2}}, kBox);
  check_touching({{6, 1, 1}, {1, 2, 2}}, kBox);
  check_touching({{1, 1, -2}, {0.5, 0.5, 1}}, {{0, 0, 0}, {3, 3, 0}});
  check_touching({{-1, -2, -2}, {1, 2, 2}}, {{1, 2, 2}, {1, 2, 2}});
}

TEST_CASE("a ray in the plane of a face touches the box") {
  const auto check_in_a_face = [](const Ray& ray, const Box& box) {
    check_for(ray, box, {Mistake::touching_rejected});
  };
  for (const double zero : {0.0, -0.0}) {
    check_in_a_face({{0, -1, -4}, {1, zero, 2}}, kBox);
    check_in_a_face({{0, 3, -4}, {1, zero, 2}}, kBox);
    check_in_a_face({{8, -1, 5}, {-1, zero, -2}}, kBox);
    check_in_a_face({{6, 1, 8}, {zero, 0.25, -2}}, kBox);
    check_in_a_face({{2, 1, 8}, {zero, 0.25, -2}}, kBox);
    check_in_a_face({{4, 7, 4}, {0.25, -1, zero}}, kBox);
    check_in_a_face({{4, 7, -2}, {0.25, -1, zero}}, kBox);
    // Along an edge, and from a corner away.
    check_in_a_face({{6, 3, 9}, {zero, zero, -2}}, kBox);
    check_in_a_face({{2, -9, 4}, {zero, 2, zero}}, kBox);
    check_in_a_face({{6, 3, 4}, {zero, zero, 2}}, kBox);
    // In the plane, and beside the face.
    check_in_a_face({{0, 3, -9}, {1, zero, 1}}, kBox);
    // In a flat box.
    check_in_a_face({{-2, 1, 0}, {1, 0.25, zero}}, {{0, 0, 0}, {3, 3, 0}});
  }
}

TEST_CASE("random rays agree with exact arithmetic") {
  // No two of the t are nearly the same, nor is one nearly 0.
  const auto beyond_doubt = [](const Ray& ray, const Box& box) {
    if (!((box.high - box.low).minCoeff() > 0)) return false;
    std::vector<double> all{0};
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(ray.direction[k]) > 1e-3)) return false;
      all.push_back((box.low[k] - ray.origin[k]) / ray.direction[k]);
      all.push_back((box.high[k] - ray.origin[k]) / ray.direction[k]);
    }
    std::sort(all.begin(), all.end());
    const auto close = [](double x, double y) { return y - x < 1e-6; };
    return std::adjacent_find(all.begin(), all.end(), close) == all.end();
  };
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 500;) {
    const Vector centre = vector(8), half = vector(4).cwiseAbs();
    const Box box{centre - half, centre + half};
    const Vector origin = asked % 5 == 0 ? Vector(centre + vector(3)) : vector(12);
    const Vector aim = centre + 1.5 * vector(1).cwiseProduct(half);
    const Ray ray{origin, random.magnitude(-3, 3) * (aim - origin)};
    if (!beyond_doubt(ray, box)) continue;
    ++asked;
    shrinkable(check, beyond_doubt, ray, box);
  }
}
