// Signs are decided without rounding. Every test asks for a hit somewhere, so "nothing, always"
// earns nothing.
#include "ray_cylinder.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <04_rays/exact_lines.hpp>

namespace {

using namespace contact::testing;
using exact::Interval;
using exercise::Cylinder;
using exercise::Entry;
using Found = std::optional<Entry>;
using Ray = contact::Ray<double>;
using Vector = Eigen::Vector3d;

/// The t in the infinite cylinder and the t between the planes of the caps.
struct Parts {
  std::optional<Interval> wall, caps;
};

Parts parts(const Ray& ray, const Cylinder& cylinder) {
  using contact::Exact;
  const exact::Vector m = exact::exactly(ray.origin) - exact::exactly(cylinder.start);
  const exact::Vector d = exact::exactly(ray.direction);
  const exact::Vector w = exact::exactly(cylinder.end) - exact::exactly(cylinder.start);
  const exact::Vector wd = exact::cross(w, d), wm = exact::cross(w, m);
  const Exact r = cylinder.radius, ww = exact::dot(w, w);
  return {
      exact::at_most_zero(exact::dot(wd, wd), exact::dot(wd, wm), exact::dot(wm, wm) - r * r * ww),
      exact::between(exact::dot(w, m), exact::dot(w, d), Exact(0.0), ww)};
}

Vector cap_normal(const Ray& ray, const Cylinder& cylinder) {
  const Vector w = (cylinder.end - cylinder.start).normalized();
  return w.dot(ray.direction) > 0 ? Vector(-w) : w;
}

Vector wall_normal(const Ray& ray, const Cylinder& cylinder, double t) {
  const Vector w = (cylinder.end - cylinder.start).normalized();
  const Vector p = ray.origin + t * ray.direction - cylinder.start;
  return (p - p.dot(w) * w).normalized();
}

Found right(const Ray& ray, const Cylinder& cylinder) {
  const auto [wall, caps] = parts(ray, cylinder);
  if (!wall || !caps) return std::nullopt;
  if (std::max(wall->entry, caps->entry) > std::min(wall->exit, caps->exit)) return std::nullopt;
  if (wall->sign_of_exit < 0 || caps->sign_of_exit < 0) return std::nullopt;
  if (wall->sign_of_entry < 0 && caps->sign_of_entry < 0) return Entry{0, Vector::Zero()};
  if (caps->entry > wall->entry) return Entry{caps->entry, cap_normal(ray, cylinder)};
  return Entry{wall->entry, wall_normal(ray, cylinder, wall->entry)};
}

enum class Mistake {
  direction_normalised,
  axis_length_forgotten,
  sphere_normal,
  normal_not_unit,
  caps_left_out,
  cylinder_without_end,
  cap_as_a_plane,
  parallel_called_a_miss,
  perpendicular_called_a_miss,
  hits_behind_origin,
  start_inside_missed,
  exit_for_entry,
  touching_rejected,
};
constexpr std::string_view kIds[] = {
    "direction-normalised", "axis-length-forgotten",  "sphere-normal",
    "normal-not-unit",      "caps-left-out",          "cylinder-without-end",
    "cap-as-a-plane",       "parallel-called-a-miss", "parallel-called-a-miss",
    "hits-behind-origin",   "start-inside-missed",    "exit-for-entry",
    "touching-rejected"};

/// The textbook's way with one mistake in it.
Found mistaken(const Ray& ray, const Cylinder& cylinder, Mistake mistake) {
  const auto is = [mistake](Mistake other) { return mistake == other; };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Vector d = is(Mistake::direction_normalised) ? ray.direction.normalized() : ray.direction;
  const Vector axis = cylinder.end - cylinder.start, m = ray.origin - cylinder.start;
  // Divided by its length, or not.
  const Vector u = is(Mistake::axis_length_forgotten) ? axis : axis.normalized();
  const auto beside = [&](const Vector& v) { return Vector(v - v.dot(u) * u); };
  const double a = beside(d).squaredNorm(), b = beside(d).dot(beside(m));
  const double c = beside(m).squaredNorm() - cylinder.radius * cylinder.radius;
  double wall_entry = -infinity, wall_exit = infinity;
  if (ray.direction.cross(axis).isZero(0)) {
    if (c > 0 || is(Mistake::parallel_called_a_miss)) return std::nullopt;
  } else {
    const double discriminant = b * b - a * c;
    if (discriminant < 0 && !is(Mistake::cap_as_a_plane)) return std::nullopt;
    if (is(Mistake::touching_rejected) && discriminant <= 1e-12 * b * b) return std::nullopt;
    wall_entry = (-b - std::sqrt(discriminant)) / a;
    wall_exit = (-b + std::sqrt(discriminant)) / a;
  }
  const double height = m.dot(u), along = d.dot(u), length = axis.norm();
  double cap_entry = -infinity, cap_exit = infinity;
  if (ray.direction.dot(axis) == 0) {
    if (is(Mistake::perpendicular_called_a_miss)) return std::nullopt;
    if ((height < 0 || height > length) && !is(Mistake::cylinder_without_end)) return std::nullopt;
  } else {
    cap_entry = (along > 0 ? -height : length - height) / along;
    cap_exit = (along > 0 ? length - height : -height) / along;
  }
  if (is(Mistake::cylinder_without_end)) {
    cap_entry = -infinity;
    cap_exit = infinity;
  }
  double entry = std::max(wall_entry, cap_entry), exit = std::min(wall_exit, cap_exit);
  if (is(Mistake::caps_left_out) && cap_entry > wall_entry) return std::nullopt;
  if (is(Mistake::cap_as_a_plane) && cap_entry > 0 && !(wall_entry >= cap_entry && entry <= exit))
    return Entry{cap_entry, cap_normal(ray, cylinder)};
  if (entry > exit) return std::nullopt;
  if (exit < 0 && !is(Mistake::hits_behind_origin)) return std::nullopt;
  if (entry < 0 && is(Mistake::start_inside_missed)) return std::nullopt;
  if (entry < 0 && is(Mistake::exit_for_entry)) {
    return Entry{exit, wall_exit < cap_exit ? wall_normal(ray, cylinder, exit)
                                            : Vector(-cap_normal(ray, cylinder))};
  }
  if (entry < 0) return Entry{0, Vector::Zero()};
  const Vector p = m + entry * d;
  if (cap_entry > wall_entry) {
    const Vector normal = cap_normal(ray, cylinder);
    return Entry{entry, is(Mistake::normal_not_unit) ? Vector(length * normal) : normal};
  }
  if (is(Mistake::normal_not_unit)) return Entry{entry, beside(p)};
  if (is(Mistake::sphere_normal)) return Entry{entry, p.normalized()};
  return Entry{entry, beside(p).normalized()};
}

/// Asks once. `mistakes` are those that this input tells from everything else.
void check_for(const Ray& ray, const Cylinder& cylinder, const std::vector<Mistake>& mistakes) {
  std::vector<Suspect<Found>> suspects;
  for (const Mistake mistake : mistakes) {
    suspects.push_back({kIds[static_cast<std::size_t>(mistake)],
                        [&ray, &cylinder, mistake] { return mistaken(ray, cylinder, mistake); }});
  }
  const Found expected = right(ray, cylinder);
  // Not less than a thousand times what textbook arithmetic is off by where the ray is at least a
  // hundredth of a radius from touching, or touches in round numbers.
  const double size = (ray.origin - cylinder.start).norm() + cylinder.radius +
                      (cylinder.end - cylinder.start).norm();
  const double off = 0x1p-33 * size;
  ask("Where does the ray enter the cylinder?")
      .given("ray", ray)
      .given("cylinder", cylinder)
      .suspects(std::move(suspects))
      // From the middle of the axis, and not from the nearest point of the axis.
      .suspect_if("sphere-normal",
                  [&](const Found& got) {
                    if (!got || !expected || expected->normal.isZero(0)) return false;
                    const Vector middle = (cylinder.start + cylinder.end) / 2;
                    const Vector p = ray.origin + expected->t * ray.direction;
                    const Vector radial = (p - middle).normalized();
                    return (got->normal.normalized() - radial).norm() < 1e-9 &&
                           (radial - expected->normal).norm() > 1e-6;
                  })
      .answer([&] { return exercise::ray_cylinder(ray, cylinder); })
      .close_to(expected,
                within(Entry{off / ray.direction.norm(), Vector::Constant(off / cylinder.radius)}));
}
void check(const Ray& ray, const Cylinder& cylinder) {
  check_for(ray, cylinder,
            {Mistake::direction_normalised, Mistake::axis_length_forgotten, Mistake::sphere_normal,
             Mistake::normal_not_unit, Mistake::hits_behind_origin, Mistake::exit_for_entry});
}

/// Along z, from 1 to 5.
const Cylinder kUpright{{2, -1, 1}, {2, -1, 5}, 2};
const Cylinder kSmall{{0, 0, 0}, {0, 0, 0.5}, 0.5};
/// Its axis has length 9, in the direction (1, 2, 2) / 3.
const Cylinder kOblique{{1, 0, -1}, {4, 6, 5}, 3};

}  // namespace

TEST_CASE("a ray enters through the wall") {
  // So short that each mistaken formula has a hit, and each another one.
  check({{-2, -1, 1.25}, {2, 0, 0.125}}, {{2, -1, 1}, {2, -1, 3}, 2});
  check({{-4, -1, 2}, {2, 0, 0.5}}, kUpright);
  check({{3, 8, 4.5}, {0, -1, -0.25}}, kUpright);
  check({{-8, 6, 1}, {4, -1, 0.5}}, kOblique);
  check({{9, -3, 8}, {-2, 2, -2}}, kOblique);
  check({{2, 9, 3}, {0, -3, 0.5}}, {{2, -1, 5}, {2, -1, 1}, 2});
}

TEST_CASE("a ray enters through a cap") {
  const auto check_cap = [](const Ray& ray, const Cylinder& cylinder) {
    check_for(ray, cylinder, {Mistake::caps_left_out, Mistake::cylinder_without_end});
  };
  check_cap({{0, -1, -2}, {0.5, 0, 1}}, kUpright);
  check_cap({{2, 2, 9}, {0, -0.5, -1}}, kUpright);
  check_cap({{0, -5, -5}, {1, 3, 3}}, kOblique);
  check_cap({{6, 10, 8}, {-2, -4, -3}}, kOblique);
  check_cap({{0.25, 0, -3}, {-0.0625, 0, 2}}, kSmall);
  check_cap({{0, -1, -2}, {0.5, 0, 1}}, {{2, -1, 5}, {2, -1, 1}, 2});
}

TEST_CASE("the wall ends at the caps") {
  const auto check_ends = [](const Ray& ray, const Cylinder& cylinder) {
    check_for(ray, cylinder, {Mistake::cylinder_without_end});
  };
  check_ends({{-4, -1, 3}, {2, 0, 0.5}}, kUpright);
  check_ends({{-4, -1, 4.25}, {2, 0, 0.5}}, kUpright);
  check_ends({{-4, -1, 6}, {2, 0, 0.5}}, kUpright);
  check_ends({{-4, -1, 0}, {2, 0, -0.5}}, kUpright);
  check_ends({{9.5, 13, 0}, {-1, -1, 2}}, kOblique);
  check_ends({{-4.5, -7, 4}, {1, 1, -2}}, kOblique);
}

TEST_CASE("a cap ends at the wall") {
  const auto check_disc = [](const Ray& ray, const Cylinder& cylinder) {
    check_for(ray, cylinder, {Mistake::cap_as_a_plane});
  };
  check_disc({{1, -1, -2}, {0.25, 0, 1}}, kUpright);
  check_disc({{7, -1, -2}, {1, 0.5, 1}}, kUpright);
  check_disc({{5, 2, 9}, {0.25, 1, -1}}, kUpright);
  check_disc({{-9, -3, -5}, {-1, 3, 3}}, kOblique);
  check_disc({{9, 3, 9}, {1, -2, -3}}, kOblique);
}

TEST_CASE("a ray may be parallel or perpendicular to the axis") {
  const auto check_special = [](const Ray& ray, const Cylinder& cylinder) {
    check_for(ray, cylinder,
              {Mistake::parallel_called_a_miss, Mistake::perpendicular_called_a_miss});
  };
  check_special({{3, 0, -3}, {0, 0, 2}}, kUpright);
  check_special({{2, -1, 9}, {0, 0, -2}}, kUpright);
  check_special({{5, 0, -3}, {0, 0, 2}}, kUpright);
  check_special({{2, 1, -7}, {1, 2, 2}}, {{1, 0, -1}, {4, 6, 5}, 6});
  check_special({{-4, -1, 2}, {2, 0, 0}}, kUpright);
  check_special({{2, 9, 4}, {0, -4, 0}}, kUpright);
  check_special({{-4, -1, 6}, {2, 0, 0}}, kUpright);
  check_special({{-4, -1, 0.5}, {2, 0, 0}}, kUpright);
  check_special({{0.75, 0, -3}, {0, 0, 2}}, kSmall);
  check_special({{-2, 0.25, 0.25}, {1, 0, 0}}, kSmall);
  check_special({{-2, 10, -2}, {2, -2, 1}}, kOblique);
}

TEST_CASE("a cylinder behind the start is missed, and a ray may start inside") {
  const auto check_start = [](const Ray& ray, const Cylinder& cylinder) {
    check_for(ray, cylinder,
              {Mistake::hits_behind_origin, Mistake::start_inside_missed, Mistake::exit_for_entry});
  };
  check_start({{-4, -1, 2}, {2, 0, 0.5}}, kUpright);
  check_start({{-4, -1, 2}, {-2, 0, -0.5}}, kUpright);
  check_start({{2.5, -1, 8}, {0.25, 0, 1}}, kUpright);
  check_start({{2.5, -1, 2}, {0.25, 0, 1}}, kUpright);
  check_start({{2.5, -1, 2}, {2, 1, 0.5}}, kUpright);
  check_start({{3, 0, 4}, {0, 0, 1}}, kUpright);
  check_start({{3, 0, 4}, {0, 1, 0}}, kUpright);
  check_start({{3, 3, 2}, {1, -1, 3}}, kOblique);
  check_start({{9, 12, 12}, {1, 2, 3}}, kOblique);
}

TEST_CASE("a ray that touches the wall is in the cylinder at one point") {
  const auto check_touching = [](const Ray& ray) {
    check_for(ray, kUpright, {Mistake::touching_rejected});
  };
  check_touching({{-4, -1, 2}, {2, 0, 0.5}});
  check_touching({{-4, 1, 2}, {2, 0, 0.25}});
  check_touching({{4, 7, 4}, {0, -2, 0}});
  check_touching({{0, -9, 4}, {0, 2, -0.25}});
  check_touching({{-4, -3, 2}, {2, 0, 1}});
  check_touching({{-4, -3, 2}, {2, 0, 0.25}});
}

TEST_CASE("random rays agree with exact arithmetic") {
  const auto beyond_doubt = [](const Ray& ray, const Cylinder& cylinder) {
    const Vector w = cylinder.end - cylinder.start, d = ray.direction;
    const double length = w.norm(), speed = d.norm(), r = cylinder.radius;
    if (!(length > 0.1 && r > 0.1 && speed > 1e-3)) return false;
    const double sine = w.cross(d).norm() / (length * speed);
    const double cosine = std::abs(w.dot(d)) / (length * speed);
    if (!(sine > 0.05 && cosine > 0.05)) return false;
    const double apart = std::abs(w.cross(d).normalized().dot(ray.origin - cylinder.start));
    if (!(std::abs(apart - r) > 0.01 * r)) return false;
    const auto [wall, caps] = parts(ray, cylinder);
    std::vector<double> all{0, caps->entry, caps->exit};
    if (wall) {
      all.push_back(wall->entry);
      all.push_back(wall->exit);
    }
    std::sort(all.begin(), all.end());
    const auto close = [speed](double x, double y) { return (y - x) * speed < 1e-3; };
    return std::adjacent_find(all.begin(), all.end(), close) == all.end();
  };
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 500;) {
    const Vector start = vector(8), end = vector(8);
    const Cylinder cylinder{start, end, random.uniform(0.1, 4)};
    const Vector middle = (start + end) / 2;
    const Vector origin = asked % 5 == 0 ? Vector(middle + vector(2)) : vector(16);
    // One draw a statement: clang and gcc evaluate the terms of a sum in different orders.
    const Vector along = random.uniform(-0.6, 0.6) * (end - start);
    const Vector beside = 1.2 * cylinder.radius * vector(1);
    const Vector aim = middle + along + beside;
    const Ray ray{origin, random.magnitude(-3, 3) * (aim - origin)};
    if (!beyond_doubt(ray, cylinder)) continue;
    ++asked;
    shrinkable(check, beyond_doubt, ray, cylinder);
  }
}
