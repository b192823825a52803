/// @file
/// Which four points hold a body, and which point is which of the step before: exact answers, and
/// methods as they are often written.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/manifold_ids.hpp>
#include <contact/manifold_reduction.hpp>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "hard_regions.hpp"
#include "support/hard_cases.hpp"

namespace hard_choices {

using hard_cases::Case;
using hard_cases::Json;
using hard_regions::Manifold;
using hard_regions::outline;
using hard_regions::Point;
using hard_regions::Points;
using oracle::Rational;
using V = contact::Vector3<double>;
using Numbers = std::vector<std::size_t>;

// ----------------------------------------------------------------------------------- four points

/// "points": x, y and distance of each, with the normal (0, 0, 1).
inline Manifold given(const Case& c) {
  Manifold m{V(0, 0, 1), {}};
  const std::vector<double> all = c.numbers("points");
  for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
    m.points.push_back(
        {V(all[i], all[i + 1], 0), all[i + 2], {contact::vertex_feature(int(i / 3)), {}}});
  }
  return m;
}
inline std::size_t deepest(const Manifold& m) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < m.points.size(); ++i) {
    if (m.points[i].distance < m.points[best].distance) best = i;
  }
  return best;
}
inline Points<Rational> hull_of(const Manifold& m, const Numbers& chosen) {
  Points<Rational> flat;
  for (const std::size_t i : chosen) {
    flat.push_back({oracle::exact(m.points[i].point.x()), oracle::exact(m.points[i].point.y())});
  }
  return outline(flat);
}
inline Rational twice_the_area(const Points<Rational>& hull) {
  Rational sum(0);
  for (std::size_t i = 1; i + 1 < hull.size(); ++i) {
    sum += hard_regions::orientation<Rational>(hull[0], hull[i], hull[i + 1]);
  }
  return sum;
}
inline bool contains(const Points<Rational>& hull, const Point<Rational>& p) {
  if (hull.size() < 3) return false;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (hard_regions::orientation<Rational>(hull[i], hull[(i + 1) % hull.size()], p) < 0) {
      return false;
    }
  }
  return true;
}
inline Point<Rational> load_of(const Case& c) {
  const V load = c.vector("load");
  return {oracle::exact(load.x()), oracle::exact(load.y())};
}
inline Numbers everything(const Manifold& m) {
  Numbers all(m.points.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return all;
}

/// The largest area of four points with the deepest that contain the load if all points do; if the
/// deepest is inside the outline, of the other three.
inline Rational largest(const Case& c, const Manifold& m) {
  const std::size_t first = deepest(m), n = m.points.size();
  const Points<Rational> whole = hull_of(m, everything(m));
  const bool must = contains(whole, load_of(c));
  const Point<Rational> there = hull_of(m, {first})[0];
  const bool inside = std::find(whole.begin(), whole.end(), there) == whole.end();
  Rational best(0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      for (std::size_t l = 0; l < k; ++l) {
        const auto hull = hull_of(m, inside ? Numbers{i, k, l} : Numbers{first, i, k, l});
        if (must && !contains(hull, load_of(c))) continue;
        best = std::max(best, twice_the_area(hull));
      }
    }
  }
  return best / 2;
}

inline void add_four(hard_cases::Runner& runner) {
  runner.question("four points", [](const Case& c) {
    const Manifold m = given(c);
    return Json{{"class", "a"},
                {"area", hard_cases::hex(oracle::nearest(largest(c, m)))},
                {"deepest", deepest(m)}};
  });
  const auto method = [&runner](const char* name, auto choose) {
    runner.method("four points", name, [choose](const Case& c, const Json&) {
      const Manifold m = given(c);
      const Numbers chosen = choose(c, m);
      const auto hull = hull_of(m, chosen);
      const bool must = contains(hull_of(m, everything(m)), load_of(c));
      return chosen.size() <= 4 &&
             std::find(chosen.begin(), chosen.end(), deepest(m)) != chosen.end() &&
             (!must || contains(hull, load_of(c))) &&
             twice_the_area(hull) / 2 >= largest(c, m) * Rational(1 - 0x1p-40);
    });
  };
  const auto sorted = [](const Manifold& m, auto value) {
    Numbers all = everything(m);
    std::stable_sort(all.begin(), all.end(),
                     [&](std::size_t i, std::size_t k) { return value(i) < value(k); });
    return all;
  };
  method("the first four", [](const Case&, const Manifold&) { return Numbers{0, 1, 2, 3}; });
  method("the four deepest", [=](const Case&, const Manifold& m) {
    Numbers all = sorted(m, [&](std::size_t i) { return m.points[i].distance; });
    all.resize(4);
    return all;
  });
  method("the extremes along x and y", [=](const Case&, const Manifold& m) {
    const Numbers x = sorted(m, [&](std::size_t i) { return m.points[i].point.x(); });
    const Numbers y = sorted(m, [&](std::size_t i) { return m.points[i].point.y(); });
    std::set<std::size_t> chosen{x.front(), x.back(), y.front(), y.back()};
    return Numbers(chosen.begin(), chosen.end());
  });
  method("every other one", [](const Case&, const Manifold& m) {
    Numbers chosen;
    for (std::size_t i = 0; i < m.points.size() && chosen.size() < 4; i += 2) chosen.push_back(i);
    return chosen;
  });
  // The deepest, the farthest from it, and the farthest from their line on both sides.
  method("deepest, farthest, and beside", [](const Case&, const Manifold& m) {
    const std::size_t first = deepest(m);
    const auto at = [&](std::size_t i) { return m.points[i].point; };
    std::size_t second = first;
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      if ((at(i) - at(first)).norm() > (at(second) - at(first)).norm()) second = i;
    }
    std::set<std::size_t> chosen{first, second};
    for (const double sign : {1.0, -1.0}) {
      std::size_t best = first;
      double most = 0;
      for (std::size_t i = 0; i < m.points.size(); ++i) {
        const double beside = sign * (at(second) - at(first)).cross(V(at(i) - at(first))).z();
        if (beside > most) best = i;
        most = std::max(most, beside);
      }
      chosen.insert(best);
    }
    return Numbers(chosen.begin(), chosen.end());
  });
  method("book", [](const Case& c, const Manifold& m) {
    Numbers chosen;
    for (const auto& p : contact::reduced_manifold(m, c.vector("load")).points) {
      chosen.push_back(std::size_t(p.features.of_a.first));
    }
    return chosen;
  });
}

// ---------------------------------------------------------------------------------- the same point

/// The boxes of the step before are "a_then" and "b_then"; without, they have not moved.
struct Steps {
  hard_regions::Body a, b, a_then, b_then;
  Manifold now, then;
};
inline Steps steps(const Case& c) {
  const auto body = [&](const char* name) {
    hard_boxes::Box box = hard_boxes::box(c, name);
    return hard_regions::of_box(box);
  };
  const auto before = [&](const char* name, const char* then) {
    return c.has(std::string(then) + "_half") ? body(then) : body(name);
  };
  Steps s{body("a"), body("b"), before("a", "a_then"), before("b", "b_then"), {}, {}};
  s.now = hard_regions::manifold(s.a, s.b, c.number("margin"));
  s.then = hard_regions::manifold(s.a_then, s.b_then, c.number("margin"));
  return s;
}
/// The corners of A (0 to 7) and of B (8 to 15) above or below a contact point, to within 2^-16, in
/// fractions.
inline std::set<int> corners_at(const V& p, const hard_regions::Body& a,
                                const hard_regions::Body& b) {
  std::set<int> found;
  for (int k = 0; k < 16; ++k) {
    const auto& body = k < 8 ? a : b;
    const oracle::Vector d = body.exact[std::size_t(k % 8)] - oracle::exact(p);
    if (d.x() * d.x() + d.y() * d.y() <= Rational(0x1p-32)) found.insert(k);
  }
  return found;
}
/// For each point the previous point at the same corner, or −1.
inline std::vector<int> same_corners(const Steps& s) {
  std::vector<int> matched;
  for (const auto& p : s.now.points) {
    matched.push_back(-1);
    const std::set<int> here = corners_at(p.point, s.a, s.b);
    if (here.empty()) throw std::invalid_argument("a contact point of the case is no corner");
    for (std::size_t k = 0; k < s.then.points.size(); ++k) {
      for (const int corner : corners_at(s.then.points[k].point, s.a_then, s.b_then)) {
        if (here.count(corner) > 0) matched.back() = int(k);
      }
    }
  }
  return matched;
}

inline void add_same(hard_cases::Runner& runner) {
  runner.question("same point", [](const Case& c) {
    return Json{{"class", "a"}, {"previous", same_corners(steps(c))}};
  });
  const auto method = [&runner](const char* name, auto match) {
    runner.method("same point", name, [match](const Case& c, const Json& answer) {
      const Steps s = steps(c);
      return Json(match(s.now, s.then, c.number("radius"))) == answer.at("previous");
    });
  };
  const auto nearest = [](const Manifold& now, const Manifold& then, double radius) {
    std::vector<int> matched;
    for (const auto& p : now.points) {
      double least = radius;
      matched.push_back(-1);
      for (std::size_t k = 0; k < then.points.size(); ++k) {
        const double here = (p.point - then.points[k].point).norm();
        if (!(here <= least)) continue;
        least = here;
        matched.back() = int(k);
      }
    }
    return matched;
  };
  method("the same position in the list", [](const Manifold& now, const Manifold& then, double) {
    std::vector<int> matched;
    for (std::size_t i = 0; i < now.points.size(); ++i) {
      matched.push_back(i < then.points.size() ? int(i) : -1);
    }
    return matched;
  });
  method("the nearest within the radius", nearest);
  method("the nearest, however far", [=](const Manifold& now, const Manifold& then, double) {
    return nearest(now, then, std::numeric_limits<double>::infinity());
  });
  method("features alone", [](const Manifold& now, const Manifold& then, double) {
    std::vector<int> matched;
    for (const auto& p : now.points) {
      matched.push_back(-1);
      for (std::size_t k = 0; k < then.points.size(); ++k) {
        if (then.points[k].features == p.features) matched.back() = int(k);
      }
    }
    return matched;
  });
  method("book", [](const Manifold& now, const Manifold& then, double radius) {
    return contact::matched_points(now, then, radius);
  });
}

inline void add(hard_cases::Runner& runner) {
  add_four(runner);
  add_same(runner);
}

}  // namespace hard_choices
