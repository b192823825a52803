// Compares the book's broad phases with those of Bullet, CGAL, FCL, Coal, ODE and Box3D on families
// of boxes: time of the processor, pairs found, pairs missed, and how the time grows with the
// number of boxes. Then says in how many settings broad_phase_cost() predicts the cheapest method.
// usage:
//   phase_peers [N] [runs]              N boxes of each family
//   phase_peers --settings [runs]       the predictions only
//   phase_peers --growth [runs]         the exponents only: 1,000 to 30,000 boxes
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/broad_phase_cost.hpp>
#include <contact/sweep_and_prune.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../comparison.hpp"
#include "box_scenes.hpp"
#include "peers.hpp"

namespace {

using box_scenes::Boxes;
using box_scenes::Family;
using contact::BoxPair;
using contact::BroadPhase;
using Pairs = std::vector<BoxPair>;
using View = std::span<const contact::Aabb<double>>;

/// The pairs as the book gives them: each once, in increasing order. That two lists are equal says
/// that none is missed, invented or reported twice.
Pairs ordered(const peers::Pairs& found) {
  Pairs pairs;
  pairs.reserve(found.size());
  for (const auto& [a, b] : found) pairs.push_back({std::min(a, b), std::max(a, b)});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// A line of a table: what it takes, and its pairs against the right ones.
struct Way {
  std::string name;
  std::function<double(Pairs&)> ask;  ///< the time in ms; the pairs are ordered after the clock
};

template <class Find>
double timed(const Find& find) {
  const double start = comparison::processor_time();
  find();
  return (comparison::processor_time() - start) * 1e-6;
}

/// Of right ones, how many are not in found; each list is ordered and has no pair twice.
std::size_t missing(const Pairs& right, const Pairs& found) {
  std::size_t missed = 0;
  for (const BoxPair& pair : right) {
    if (!std::binary_search(found.begin(), found.end(), pair)) ++missed;
  }
  return missed;
}

std::vector<peers::BroadPhase> all_peers() {
  std::vector<peers::BroadPhase> all;
  [[maybe_unused]] const auto add = [&all](const std::vector<peers::BroadPhase>& phases) {
    all.insert(all.end(), phases.begin(), phases.end());
  };
#ifdef CONTACT_HAS_BULLET
  add(peers::bullet_phases());
#endif
#ifdef CONTACT_HAS_BOX3D
  add(peers::box3d_phases());
#endif
#ifdef CONTACT_HAS_CGAL
  add(peers::cgal_phases());
#endif
#ifdef CONTACT_HAS_COAL
  add(peers::coal_phases());
#endif
#ifdef CONTACT_HAS_FCL
  add(peers::fcl_phases());
#endif
#ifdef CONTACT_HAS_ODE
  add(peers::ode_phases());
#endif
  return all;
}

constexpr std::array<BroadPhase, 4> methods{BroadPhase::all_pairs, BroadPhase::sweep,
                                            BroadPhase::grid, BroadPhase::tree};
const char* name(BroadPhase method) {
  constexpr std::array<const char*, 4> names{"all pairs", "sweep", "grid", "tree"};
  return names[static_cast<std::size_t>(method)];
}

Way book_way(const Boxes& boxes, BroadPhase method) {
  return {std::string("Contact Hours, ") + name(method), [&boxes, method](Pairs& pairs) {
            return timed([&] { pairs = contact::touching_pairs(View(boxes), method).pairs; });
          }};
}

/// Boxes that are seen for the first time: the others build what they keep, too.
std::vector<Way> fresh_ways(const Boxes& boxes, const peers::Boxes& plain) {
  std::vector<Way> ways;
  for (const BroadPhase method :
       {BroadPhase::grid, BroadPhase::tree, BroadPhase::sweep, BroadPhase::all_pairs}) {
    ways.push_back(book_way(boxes, method));
  }
  for (const peers::BroadPhase& phase : all_peers()) {
    if (boxes.size() > phase.max_boxes) continue;
    ways.push_back({phase.name, [phase, &plain](Pairs& pairs) {
                      peers::Pairs found;
                      const double ms = timed([&] { phase.make()->find(plain, found); });
                      pairs = ordered(found);
                      return ms;
                    }});
  }
  return ways;
}

/// A step from one position to another, and later back: what is kept is used.
std::vector<Way> moving_ways(const std::array<const Boxes*, 2>& boxes,
                             const std::array<peers::Boxes, 2>& plain) {
  std::vector<Way> ways;
  // Each way begins at the first positions, then asks about the second and the first in turns.
  const auto turns = [](auto& step) { return step = 1 - step; };
  const auto sweep = std::make_shared<contact::IncrementalSweep<double>>(
      contact::best_sweep_axis(View(*boxes[0])));
  sweep->update(*boxes[0]);
  ways.push_back({"Contact Hours, incremental sweep",
                  [sweep, boxes, turns, step = std::size_t{0}](Pairs& pairs) mutable {
                    const Boxes& now = *boxes[turns(step)];
                    return timed([&] { pairs = sweep->update(now).pairs; });
                  }});
  const auto pruned = std::make_shared<contact::SweepAndPrune<double>>();
  pruned->update(*boxes[0]);
  ways.push_back({"Contact Hours, sweep and prune",
                  [pruned, boxes, turns, step = std::size_t{0}](Pairs& pairs) mutable {
                    const Boxes& now = *boxes[turns(step)];
                    return timed([&] { pairs = pruned->update(now).pairs; });
                  }});
  const int axis = sweep->axis();
  ways.push_back({"Contact Hours, fresh sweep, same axis",
                  [axis, boxes, turns, step = std::size_t{0}](Pairs& pairs) mutable {
                    const View now(*boxes[turns(step)]);
                    return timed([&] { pairs = contact::sweep_pairs(now, axis).pairs; });
                  }});
  for (const BroadPhase method : {BroadPhase::sweep, BroadPhase::grid, BroadPhase::tree}) {
    ways.push_back({std::string("Contact Hours, fresh ") + name(method),
                    [method, boxes, turns, step = std::size_t{0}](Pairs& pairs) mutable {
                      const View now(*boxes[turns(step)]);
                      return timed([&] { pairs = contact::touching_pairs(now, method).pairs; });
                    }});
  }
  for (const peers::BroadPhase& phase : all_peers()) {
    if (boxes[0]->size() > phase.max_boxes) continue;
    const std::shared_ptr<peers::Search> search = phase.make();
    peers::Pairs found;
    search->find(plain[0], found);
    ways.push_back(
        {phase.name, [search, &plain, turns, step = std::size_t{0}](Pairs& pairs) mutable {
           const peers::Boxes& now = plain[turns(step)];
           peers::Pairs got;
           const double ms = timed([&] { search->find(now, got); });
           pairs = ordered(got);
           return ms;
         }});
  }
  return ways;
}

/// A way that takes more is timed only once, ms.
constexpr double patience = 500;

/// Asks all ways in turns. The first round warms up and is judged: after it, boxes that move are at
/// `right`.
/// @return the median of each way, ms
std::vector<double> compare(const std::string& title, std::vector<Way>& ways, const Pairs& right,
                            int runs) {
  std::vector<std::vector<double>> times(ways.size());
  std::vector<Pairs> found(ways.size());
  for (int run = 0; run <= runs; ++run) {
    for (std::size_t w = 0; w < ways.size(); ++w) {
      if (run > 1 && times[w].front() > patience) continue;
      Pairs pairs;
      const double ms = ways[w].ask(pairs);
      if (run == 0) found[w] = pairs;
      if (run > 0) times[w].push_back(ms);
    }
  }
  std::printf("%s, %zu pairs touch\n  %-38s %9s %19s %9s %8s %8s\n", title.c_str(), right.size(),
              "", "ms", "least - most", "pairs", "missed", "excess");
  std::vector<double> medians;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const comparison::Spread time = comparison::spread(times[w]);
    const std::size_t missed = missing(right, found[w]);
    std::printf("  %-38s %9.3f %8.3f - %8.3f %9zu %8zu %8zu\n", ways[w].name.c_str(), time.median,
                time.least, time.most, found[w].size(), missed,
                found[w].size() + missed - right.size());
    medians.push_back(time.median);
  }
  std::printf("\n");
  std::fflush(stdout);
  return medians;
}

void compare_step(Family family, std::size_t n, double most, int runs) {
  const Boxes boxes = box_scenes::make(family, n, 1);
  const Boxes after = box_scenes::moved(boxes, most, 2);
  const std::array<peers::Boxes, 2> plain{box_scenes::plain(boxes), box_scenes::plain(after)};
  std::vector<Way> moving = moving_ways({&boxes, &after}, plain);
  const std::string title = std::string(box_scenes::name(family)) + ", " + std::to_string(n) +
                            " boxes, moved by up to 1/" + std::to_string(std::lround(1 / most)) +
                            " m";
  compare(title, moving, contact::all_pairs(View(after)).pairs, runs);
}

void compare_family(Family family, std::size_t n, int runs) {
  const Boxes boxes = box_scenes::make(family, n, 1);
  const peers::Boxes plain = box_scenes::plain(boxes);
  std::vector<Way> fresh = fresh_ways(boxes, plain);
  compare(std::string(box_scenes::name(family)) + ", " + std::to_string(n) + " boxes, new", fresh,
          contact::all_pairs(View(boxes)).pairs, runs);
  compare_step(family, n, 1.0 / 16, runs);
  if (family == Family::uniform) compare_step(family, n, 1.0 / 256, runs);
}

/// The exponent of time over number, by least squares of the logarithms.
double exponent(const std::vector<double>& counts, const std::vector<double>& times) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const double n = static_cast<double>(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double u = std::log(counts[i]), v = std::log(times[i]);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

void compare_growth(Family family, int runs) {
  const std::vector<double> counts{1000, 3000, 10000, 30000};
  std::vector<std::string> names;
  std::vector<std::vector<double>> medians;
  for (const double count : counts) {
    const Boxes boxes = box_scenes::make(family, static_cast<std::size_t>(count), 1);
    const peers::Boxes plain = box_scenes::plain(boxes);
    std::vector<Way> ways = fresh_ways(boxes, plain);
    std::erase_if(ways, [](const Way& way) {
      return way.name == "Contact Hours, all pairs" || way.name == "Bullet, bt32BitAxisSweep3" ||
             way.name.starts_with("ODE") || way.name.ends_with("sweep and prune") ||
             way.name.ends_with("sorted list");
    });
    names.clear();
    for (const Way& way : ways) names.push_back(way.name);
    medians.resize(ways.size());
    for (std::size_t w = 0; w < ways.size(); ++w) {
      std::vector<double> times;
      for (int run = 0; run <= runs; ++run) {
        Pairs pairs;
        const double ms = ways[w].ask(pairs);
        if (run > 0) times.push_back(ms);
      }
      medians[w].push_back(comparison::spread(times).median);
    }
  }
  std::printf("%s: ms for 1,000, 3,000, 10,000 and 30,000 new boxes, and the exponent\n",
              box_scenes::name(family));
  for (std::size_t w = 0; w < names.size(); ++w) {
    std::printf("  %-38s %9.3f %9.3f %9.3f %9.3f %7.3f\n", names[w].c_str(), medians[w][0],
                medians[w][1], medians[w][2], medians[w][3], exponent(counts, medians[w]));
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// Whether the cheapest method by broad_phase_cost() is the fastest that is measured.
void compare_settings(int runs) {
  std::printf("the cheapest method, predicted and measured, ms\n  %7s %6s %9s %10s %10s", "boxes",
              "sizes", "m³ a box", "predicted", "fastest");
  for (const BroadPhase method : methods) std::printf(" %10s", name(method));
  std::printf(" %8s\n", "loss");
  int right = 0, close = 0, all = 0;
  for (const box_scenes::Setting& setting : box_scenes::settings()) {
    // Of few boxes there are many lists, so that the clock has something to measure, and the
    // processor cannot learn the outcomes of all comparisons.
    box_scenes::Random random(7);
    std::vector<Boxes> lists(std::max<std::size_t>(1, 100000 / (setting.count * setting.count)));
    for (Boxes& boxes : lists) {
      boxes = box_scenes::in_a_cube(random, setting.count, setting.room, setting.spread);
    }
    std::array<std::vector<double>, 4> elapsed;
    for (int run = 0; run <= runs; ++run) {
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const double ms = timed([&] {
          for (const Boxes& boxes : lists) contact::touching_pairs(View(boxes), methods[m]);
        });
        if (run > 0) elapsed[m].push_back(ms / static_cast<double>(lists.size()));
      }
    }
    std::array<double, 4> medians{};
    for (std::size_t m = 0; m < methods.size(); ++m) {
      medians[m] = comparison::spread(elapsed[m]).median;
    }
    const auto fastest = static_cast<std::size_t>(std::min_element(medians.begin(), medians.end()) -
                                                  medians.begin());
    const auto cost = contact::broad_phase_cost(View(lists.front()));
    const auto predicted = static_cast<std::size_t>(cost.cheapest());
    const double loss = medians[predicted] / medians[fastest];
    ++all;
    if (predicted == fastest) ++right;
    if (loss <= 1.1) ++close;
    std::printf("  %7zu %6d %9.2f %10s %10s", setting.count, 1 << setting.spread, setting.room,
                name(methods[predicted]), name(methods[fastest]));
    for (const double ms : medians) std::printf(" %10.4f", ms);
    std::printf(" %7.2f×\n     by the model:  %*s", loss, 23, "");
    for (const double units : {cost.all_pairs, cost.sweep, cost.grid, cost.tree}) {
      std::printf(" %10.0f", units);
    }
    std::printf("\n");
  }
  std::printf(
      "the fastest is predicted in %d of %d settings, or one within a tenth of it in %d\n\n", right,
      all, close);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view option = argc > 1 ? argv[1] : "";
  const int runs = static_cast<int>(comparison::number(argc, argv, 2, 9));
  if (!option.starts_with("--")) {
    const std::size_t count = comparison::number(argc, argv, 1, 10000);
    for (const Family family : box_scenes::all) compare_family(family, count, runs);
  }
  if (option != "--settings") {
    compare_growth(Family::uniform, runs);
    if (option != "--growth") compare_growth(Family::clusters, runs);
  }
  if (option != "--growth") compare_settings(runs);
  comparison::leave(0);
}
