// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// All answers are rational in the stored numbers (class (a)). Pairs, cells and numbers are right or
// wrong; a pair that is reported twice is wrong. In "periodic pairs" a box and its images at all
// multiples of the period are one. An enclosing box is right if it contains what it should; the
// answer is the tightest box of doubles, and a box that is more than four ulps wider is wrong too.
#include "support/hard_cases.hpp"

#include <algorithm>
#include <cmath>
#include <contact/broad_phase_cost.hpp>
#include <contact/regions.hpp>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <vector>

#include "hard_boxes.hpp"
#include "hard_periods.hpp"
#include "hard_steps.hpp"

using contact::BoxPair;
using hard_boxes::as_json;
using hard_boxes::Box;
using hard_boxes::Boxes;
using hard_boxes::pairs_by;
using hard_boxes::read_boxes;
using hard_boxes::V;
using hard_cases::Case;
using hard_cases::Json;
using oracle::Rational;

namespace {

/// Borders at 0, ±1, … ±4 m on each axis.
contact::Regions<double> whole_regions() {
  std::vector<double> borders;
  for (int i = -4; i <= 4; ++i) borders.push_back(i);
  return contact::Regions<double>({borders, borders, borders});
}

void add_pairs(hard_cases::Runner& runner) {
  runner.question("pairs", [](const Case& c) {
    const auto pairs = pairs_by(hard_boxes::stored_boxes(c), hard_boxes::touch_exactly);
    return Json{{"class", "a"}, {"pairs", as_json(pairs)}};
  });
  const auto method = [&runner](const char* name, auto find) {
    runner.method("pairs", name, [find](const Case& c, const Json& answer) {
      return as_json(find(read_boxes(c))) == answer.at("pairs");
    });
  };
  method("strictly less", [](const Boxes& boxes) {
    return pairs_by(boxes, [](const Box& a, const Box& b) {
      for (int k = 0; k < 3; ++k) {
        if (!(a.low(k) < b.high(k)) || !(b.low(k) < a.high(k))) return false;
      }
      return true;
    });
  });
  method("centres and half sizes", [](const Boxes& boxes) {
    return pairs_by(boxes, [](const Box& a, const Box& b) {
      for (int k = 0; k < 3; ++k) {
        const double apart = std::abs((a.low(k) + a.high(k)) / 2 - (b.low(k) + b.high(k)) / 2);
        if (!(apart <= (a.high(k) - a.low(k)) / 2 + (b.high(k) - b.low(k)) / 2)) return false;
      }
      return true;
    });
  });
  method("boxes as floats", [](const Boxes& boxes) {
    return pairs_by(boxes, [](const Box& a, const Box& b) {
      for (int k = 0; k < 3; ++k) {
        if (static_cast<float>(a.high(k)) < static_cast<float>(b.low(k)) ||
            static_cast<float>(b.high(k)) < static_cast<float>(a.low(k)))
          return false;
      }
      return true;
    });
  });
  method("one cell of 1 m for each centre", [](const Boxes& boxes) {
    // A box is entered only in the cell of its centre, and compared with the 27 cells around it.
    const auto cell = [](const Box& box, int k) {
      return std::floor(box.low(k) / 2 + box.high(k) / 2);
    };
    return pairs_by(boxes, [cell](const Box& a, const Box& b) {
      for (int k = 0; k < 3; ++k) {
        if (std::abs(cell(a, k) - cell(b, k)) > 1) return false;
      }
      return contact::boxes_touch(a, b);
    });
  });
  method("a sweep that ends before it begins", [](const Boxes& boxes) {
    // Ends and beginnings in one list; of equal ones the end comes first, so a touch is missed.
    std::vector<std::tuple<double, int, std::uint32_t>> events;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      events.emplace_back(boxes[i].low.x(), 1, i);
      events.emplace_back(boxes[i].high.x(), 0, i);
    }
    std::sort(events.begin(), events.end());
    std::vector<std::uint32_t> open;
    std::vector<BoxPair> pairs;
    for (const auto& [at, begins, i] : events) {
      if (begins == 0) {
        open.erase(std::remove(open.begin(), open.end(), i), open.end());
        continue;
      }
      for (const std::uint32_t j : open) {
        if (contact::boxes_touch(boxes[i], boxes[j]))
          pairs.push_back({std::min(i, j), std::max(i, j)});
      }
      open.push_back(i);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  });
  method("cells of 1 m, a half-open range", hard_boxes::half_open_ranges);
  method("cells of 1 m, 32-bit numbers", hard_boxes::cells_of_32_bits);
  method("cells of 1 m, converted to int", hard_boxes::around_truncated_middle);
  method("reported in each common cell", hard_boxes::reported_in_each_cell);
  method("a sweep that stops at a miss", hard_boxes::stop_at_first_miss);
  method("a sweep over the middles", hard_boxes::sorted_by_middles);
  method("within 1e-6 m", hard_boxes::within_a_margin);
  method("a common volume", hard_boxes::with_common_volume);
  method("one region each", [](const Boxes& boxes) {
    return contact::pairs_of_one_region_each<double>(boxes, whole_regions()).pairs;
  });
  method("book: regions", [](const Boxes& boxes) {
    return contact::region_pairs<double>(boxes, whole_regions()).pairs;
  });
  using Method = contact::BroadPhase;
  const std::vector<std::pair<const char*, Method>> book{{"book: all pairs", Method::all_pairs},
                                                         {"book: grid", Method::grid},
                                                         {"book: sweep", Method::sweep},
                                                         {"book: tree", Method::tree}};
  for (const auto& [name, which] : book) {
    method(name, [which = which](const Boxes& boxes) {
      return contact::touching_pairs<double>(boxes, which).pairs;
    });
  }
}

/// The largest double that is at most x, and the smallest that is at least x.
double down(const Rational& x) {
  const double near = oracle::nearest(x);
  const double infinity = std::numeric_limits<double>::infinity();
  if (near == infinity) return std::numeric_limits<double>::max();
  if (near == -infinity) return near;
  return oracle::exact(near) > x ? std::nextafter(near, -infinity) : near;
}
double up(const Rational& x) { return -down(Rational(-x)); }

struct ExactBox {
  oracle::Vector low, high;
};

/// A sphere and its displacement, in fractions; the displacement is 0 if there is none.
ExactBox exact_box(const Case& c) {
  const auto sphere = oracle::exact(c.sphere("sphere"));
  ExactBox box;
  for (int k = 0; k < 3; ++k) {
    const Rational way = c.has("displacement") ? oracle::exact(c.vector("displacement")(k)) : 0;
    box.low(k) = sphere.centre(k) + std::min(Rational(0), way) - sphere.radius;
    box.high(k) = sphere.centre(k) + std::max(Rational(0), way) + sphere.radius;
  }
  return box;
}

void add_enclosure(hard_cases::Runner& runner) {
  runner.question("enclosure", [](const Case& c) {
    const ExactBox box = exact_box(c);
    return Json{
        {"class", "a"},
        {"low", hard_cases::hex(V(down(box.low.x()), down(box.low.y()), down(box.low.z())))},
        {"high", hard_cases::hex(V(up(box.high.x()), up(box.high.y()), up(box.high.z())))}};
  });
  const auto method = [&runner](const char* name, auto enclose) {
    runner.method("enclosure", name, [enclose](const Case& c, const Json& answer) {
      const auto read = [&](const char* field, std::size_t k) {
        return std::strtod(answer.at(field).at(k).get<std::string>().c_str(), nullptr);
      };
      const V way = c.has("displacement") ? c.vector("displacement") : V(0, 0, 0);
      const Box got = enclose(c.sphere("sphere"), way);
      const ExactBox right = exact_box(c);
      // Four ulps of the largest term.
      const double size = std::max({c.sphere("sphere").centre.cwiseAbs().maxCoeff(),
                                    way.cwiseAbs().maxCoeff(), c.sphere("sphere").radius});
      const double room = std::ldexp(size, -50);
      for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (!std::isfinite(got.low(k)) || !std::isfinite(got.high(k))) return false;
        if (oracle::exact(got.low(k)) > right.low(k)) return false;
        if (oracle::exact(got.high(k)) < right.high(k)) return false;
        if (read("low", at) - got.low(k) > room || got.high(k) - read("high", at) > room)
          return false;
      }
      return true;
    });
  };
  using Sphere = contact::Sphere<double>;
  method("centre ± radius, rounded", [](const Sphere& s, const V& way) -> Box {
    const V end = s.centre + way;
    const V margin = V::Constant(s.radius);
    return {V(s.centre.cwiseMin(end) - margin), V(s.centre.cwiseMax(end) + margin)};
  });
  method("a margin of 1e-9 m", [](const Sphere& s, const V& way) -> Box {
    const V end = s.centre + way;
    const V margin = V::Constant(s.radius + 1e-9);
    return {V(s.centre.cwiseMin(end) - margin), V(s.centre.cwiseMax(end) + margin)};
  });
  method("where it ends", [](const Sphere& s, const V& way) -> Box {
    return contact::aabb_of_sphere<double>({s.centre + way, s.radius});
  });
  method("book", [](const Sphere& s, const V& way) -> Box {
    if (way == V(0, 0, 0)) return contact::aabb_of_sphere(s);
    return contact::aabb_of_swept_sphere(s, way);
  });
}

/// The number of comparisons of a sweep along x: the pairs that overlap there.
void add_cost(hard_cases::Runner& runner) {
  runner.question("sweep cost", [](const Case& c) {
    const auto pairs = pairs_by(read_boxes(c), [](const Box& a, const Box& b) {
      return std::max(oracle::exact(a.low.x()), oracle::exact(b.low.x())) <=
             std::min(oracle::exact(a.high.x()), oracle::exact(b.high.x()));
    });
    return Json{{"class", "a"}, {"tests", pairs.size()}};
  });
  const auto method = [&runner](const char* name, auto count) {
    runner.method("sweep cost", name, [count](const Case& c, const Json& answer) {
      return count(read_boxes(c)) == answer.at("tests").get<double>();
    });
  };
  method("n log₂ n", [](const Boxes& boxes) {
    const auto n = double(boxes.size());
    return n * std::log2(n);
  });
  method("mean size over spread", [](const Boxes& boxes) {
    const auto profile = contact::profile_of<double>(boxes);
    return std::round(contact::expected_sweep_tests(profile, 0));
  });
  method("book",
         [](const Boxes& boxes) { return double(contact::overlaps_on_axis<double>(boxes, 0)); });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("10_broad_phase");
  add_pairs(runner);
  hard_periods::ask_pairs(runner);
  hard_periods::ask_cells(runner);
  hard_periods::ask_neighbours(runner);
  hard_steps::ask_steps(runner);
  hard_steps::ask_throughout(runner);
  add_enclosure(runner);
  add_cost(runner);
  return runner.run(argc, argv);
}
