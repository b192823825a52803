// Which boxes of a list touch? Each method of the chapter on lists that favour one or another, and
// what an order kept from the step before saves as the boxes move farther in a step.
#include <support/ladder.hpp>

#include <algorithm>
#include <contact/broad_phase_cost.hpp>
#include <contact/moving_boxes.hpp>
#include <contact/sweep_and_prune.hpp>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace {

using contact::Aabb;
using contact::BoxPair;
using contact::IncrementalSweep;
using contact::PairSearch;
using Vector = contact::Vector3<double>;
using Boxes = std::vector<Aabb<double>>;

ladder::Method rounded(const char* id, const char* title, const char* scalar) {
  return {.id = id, .title = title, .scalar = scalar, .exact = false};
}
/// What is proven to find every pair, and no other.
ladder::Method exact(const char* id, const char* title) {
  return {.id = id, .title = title, .scalar = "double", .exact = true};
}

/// By which fat boxes are larger on each side, m.
constexpr double margin = 0.05;

/// What methods keep from step to step, as the step before has left it. Each answer begins with a
/// copy, which is timed with it.
struct Kept {
  IncrementalSweep<double> sweep;
  contact::SweepAndPrune<double> three_axes = {};
  contact::BoxTree<double> tree;
  contact::FatBoxPairs<double> fat{margin};

  explicit Kept(const Boxes& before)
      : sweep(contact::best_sweep_axis<double>(before)), tree(before) {
    sweep.update(before);
    three_axes.update(before);
    fat.update(before);
  }
};

/// What the methods are asked.
struct Input {
  Boxes boxes;
  std::vector<Aabb<float>> in_float;  ///< each coordinate rounded to the nearest
  Kept kept;
};
using Asked = std::shared_ptr<const Input>;
using Answer = std::vector<BoxPair>;

Asked made(Boxes boxes, const Boxes& before) {
  std::vector<Aabb<float>> in_float;
  for (const Aabb<double>& box : boxes)
    in_float.push_back({box.low.cast<float>(), box.high.cast<float>()});
  return std::make_shared<const Input>(Input{std::move(boxes), std::move(in_float), Kept(before)});
}

Vector anywhere(generators::Random& random, double low, double high) {
  const double x = random.uniform(low, high);
  const double y = random.uniform(low, high);
  const double z = random.uniform(low, high);
  return {x, y, z};
}

/// The boxes one step earlier or later: each moved by up to `step` on each axis.
Boxes moved(generators::Random& random, Boxes boxes, const Vector& step) {
  for (Aabb<double>& box : boxes) {
    const Vector by = anywhere(random, -1, 1).cwiseProduct(step);
    box.low += by;
    box.high += by;
  }
  return boxes;
}

/// Boxes with edges of 0.5 to 1 m. Their positions fill a cube in which each has 3.4 m³.
Boxes uniform(generators::Random& random, int count) {
  const double side = 1.5 * std::cbrt(double(count));
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const Vector low = anywhere(random, 0, side);
    boxes.push_back({low, low + anywhere(random, 0.5, 1)});
  }
  return boxes;
}

Answer all_pairs(const Asked& input) { return contact::all_pairs<double>(input->boxes).pairs; }

/// The number of pairs that are in one list only.
std::size_t differing(const Answer& got, const Answer& right) {
  Answer pairs;
  std::set_symmetric_difference(got.begin(), got.end(), right.begin(), right.end(),
                                std::back_inserter(pairs));
  return pairs.size();
}

/// Wrong is a list that lacks a pair or has one too many; the error is how many these are, as a
/// share of the pairs that touch.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  const std::size_t wrong = differing(got, right);
  verdict.wrong = wrong > 0;
  if (!right.empty()) verdict.error = double(wrong) / double(right.size());
  return verdict;
}

/// The first pair that only one of two lists has, with its boxes.
void tell_pair(ladder::Example& example, const Input& input, const char* name, const Answer& in,
               const Answer& not_in) {
  Answer pairs;
  std::set_difference(in.begin(), in.end(), not_in.begin(), not_in.end(),
                      std::back_inserter(pairs));
  if (pairs.empty()) return;
  example.facts.push_back(ladder::number(name, double(pairs.size())));
  for (const std::uint32_t i : {pairs.front().a, pairs.front().b}) {
    const std::string box = "box " + std::to_string(i);
    example.facts.push_back(ladder::numbers(box + ", from", input.boxes[i].low));
    example.facts.push_back(ladder::numbers(box + ", to", input.boxes[i].high));
  }
}

ladder::Example shown(const Asked& input, const Answer& got, const Answer& right,
                      const ladder::Method&) {
  ladder::Example example;
  example.facts.push_back(ladder::number("boxes", double(input->boxes.size())));
  example.facts.push_back(ladder::number("pairs that touch", double(right.size())));
  tell_pair(example, *input, "pairs not found", right, got);
  tell_pair(example, *input, "pairs found that do not touch", got, right);
  example.note = "The figures show discs in the plane.";
  return example;
}

/// Without a share of the boxes, or without one.
std::vector<Asked> simpler(const Asked& input) {
  std::vector<Asked> all;
  const std::size_t n = input->boxes.size();
  const std::size_t step = n > 24 ? n / 4 : 1;
  for (std::size_t start = 0; n > 2 && start < n; start += step) {
    Boxes rest = input->boxes;
    const auto first = rest.begin() + static_cast<std::ptrdiff_t>(start);
    rest.erase(first, first + static_cast<std::ptrdiff_t>(std::min(step, n - start)));
    all.push_back(made(rest, rest));
  }
  return all;
}

/// How grids are often written: each box is entered in the cell of its centre only, and compared
/// with the boxes of that cell and of its 26 neighbours. A box larger than a cell is missed.
Answer centres_and_neighbours(const Asked& input) {
  struct Centre {
    std::uint64_t cell;
    std::uint32_t box;
    bool operator<(const Centre& other) const { return cell < other.cell; }
  };
  const Boxes& boxes = input->boxes;
  const auto grid = contact::grid_for<double>(boxes);
  std::vector<Centre> centres;
  std::vector<std::array<std::uint32_t, 3>> cells;
  const auto key = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (std::uint64_t{x} << 42) | (std::uint64_t{y} << 21) | z;
  };
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const Vector centre = boxes[i].low / 2 + boxes[i].high / 2;
    std::array<std::uint32_t, 3> cell{};
    for (int k = 0; k < 3; ++k) {
      // One is added, so that every cell has neighbours.
      cell[std::size_t(k)] = 1 + contact::grid_cell(centre(k), grid.origin(k), grid.cell_edge);
    }
    cells.push_back(cell);
    centres.push_back({key(cell[0], cell[1], cell[2]), i});
  }
  std::stable_sort(centres.begin(), centres.end());
  Answer pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const auto [x, y, z] = cells[i];
    for (std::uint32_t neighbour = 0; neighbour < 27; ++neighbour) {
      const std::uint64_t cell =
          key(x + neighbour / 9 - 1, y + neighbour / 3 % 3 - 1, z + neighbour % 3 - 1);
      auto in_cell = std::lower_bound(centres.begin(), centres.end(), Centre{cell, 0});
      for (; in_cell != centres.end() && in_cell->cell == cell; ++in_cell) {
        if (i < in_cell->box && contact::boxes_touch(boxes[i], boxes[in_cell->box]))
          pairs.push_back({i, in_cell->box});
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

namespace lists {

constexpr int count = 1000;

Boxes clusters(generators::Random& random) {
  Boxes boxes;
  Vector centre = Vector::Zero();
  for (int i = 0; i < count; ++i) {
    if (i % 100 == 0) centre = anywhere(random, -1000, 1000);
    const Vector low = centre + anywhere(random, 0, 6);
    boxes.push_back({low, low + anywhere(random, 0.5, 1)});
  }
  return boxes;
}

Boxes one_huge(generators::Random& random) {
  Boxes boxes = uniform(random, count);
  boxes[std::size_t(random.integer(0, count - 1))] = {Vector::Constant(-1), Vector::Constant(20)};
  return boxes;
}

/// Of 0.2 m × 0.2 m × 8 m, along one of the axes each.
Boxes rods(generators::Random& random) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const Vector low = anywhere(random, 0, 15);
    Vector extent = Vector::Constant(0.2);
    extent(random.integer(0, 2)) = 8;
    boxes.push_back({low, low + extent});
  }
  return boxes;
}

/// All on one line, which is not an axis that a method prefers without looking.
Boxes line(generators::Random& random) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const Vector low(0, 0, random.uniform(0, 0.7 * count));
    boxes.push_back({low, low + anywhere(random, 0.5, 1)});
  }
  return boxes;
}

/// The box of each body over a step: of both ends.
Boxes moving(generators::Random& random) {
  Boxes boxes = uniform(random, count);
  for (Aabb<double>& box : boxes) {
    const Vector by = anywhere(random, -1, 1);
    box = contact::enclosing_box(box, Aabb<double>{box.low + by, box.high + by});
  }
  return boxes;
}

/// Cubes on a lattice: faces that coincide, or that are 10⁻⁹ m apart.
Boxes lattice(generators::Random& random) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    Vector low(i % 10, i / 10 % 10, i / 100);
    const Vector high = low + Vector::Ones();
    for (int k = 0; k < 3; ++k) low(k) += random.chance(0.5) ? 1e-9 : 0;
    boxes.push_back({low, high});
  }
  return boxes;
}

ladder::Ladder<Asked, Answer> experiment() {
  ladder::Ladder<Asked, Answer> ladder("Which of 1,000 boxes touch?", all_pairs, judge);
  ladder.at_most(4);
  const auto family = [&ladder](const char* id, const char* title, auto make) {
    ladder.family(id, title, [make](generators::Random& random) {
      Boxes boxes = make(random);
      const Boxes before = moved(random, boxes, Vector::Constant(0.01));
      return made(std::move(boxes), before);
    });
  };
  family("uniform", "uniform", [](generators::Random& random) { return uniform(random, count); });
  family("clusters", "ten clusters", clusters);
  family("one-huge", "one that contains all", one_huge);
  family("rods", "long rods", rods);
  family("line", "on a line", line);
  family("moving", "over a step", moving);
  family("lattice", "faces coincide, or 10⁻⁹ m apart", lattice);

  ladder.method(exact("all-pairs", "all pairs"), all_pairs);
  ladder.method(exact("sweep", "sort and sweep"), [](const Asked& input) {
    return contact::sweep_pairs<double>(input->boxes).pairs;
  });
  ladder.method(exact("incremental", "the sweep, with the order kept"), [](const Asked& input) {
    IncrementalSweep<double> sweep = input->kept.sweep;
    return sweep.update(input->boxes).pairs;
  });
  ladder.method(rounded("centres", "the centre’s cell and its neighbours", "double"),
                centres_and_neighbours);
  ladder.method(
      rounded("grid-float", "grid, boxes rounded to float", "float"),
      [](const Asked& input) { return contact::grid_pairs<float>(input->in_float).pairs; });
  ladder.method(exact("grid", "grid"),
                [](const Asked& input) { return contact::grid_pairs<double>(input->boxes).pairs; });
  ladder.method(exact("tree", "tree"),
                [](const Asked& input) { return contact::tree_pairs<double>(input->boxes).pairs; });
  ladder.method(exact("predicted", "the one predicted to be cheapest"), [](const Asked& input) {
    const auto cost = contact::broad_phase_cost<double>(input->boxes);
    return contact::touching_pairs<double>(input->boxes, cost.cheapest()).pairs;
  });
  ladder.recommend("grid");
  ladder.show(shown);
  ladder.simplify(simpler);
  return ladder;
}

}  // namespace lists

namespace steps {

constexpr int count = 2000;
/// The mean edge of the boxes, m.
constexpr double edge = 0.75;

/// In a cube most of the time goes to comparisons, of boxes that overlap on the axis.
Boxes cube(generators::Random& random) { return uniform(random, count); }

/// In a corridor, which is long on one axis, hardly any boxes overlap on it, and sorting costs
/// most.
Boxes corridor(generators::Random& random) {
  Boxes boxes = cube(random);
  const double length = count * edge;
  for (Aabb<double>& box : boxes) {
    const Vector to(random.uniform(0, length), box.low.y() / 8, box.low.z() / 8);
    box = {to, to + (box.high - box.low)};
  }
  return boxes;
}

ladder::Ladder<Asked, Answer> experiment() {
  ladder::Ladder<Asked, Answer> ladder("What does an order kept from the last step save?",
                                       all_pairs, judge);
  ladder.at_most(2);
  const auto family = [&ladder](const char* id, const char* title, auto make, Vector step) {
    ladder.family(id, title, [make, step](generators::Random& random) {
      Boxes before = make(random);
      Boxes boxes = moved(random, before, step * edge);
      return made(std::move(boxes), before);
    });
  };
  family("step-0", "in a cube, at rest", cube, Vector::Constant(0));
  family("step-1-1000", "steps of 0.001 of an edge", cube, Vector::Constant(0.001));
  family("step-1-100", "0.01 of an edge", cube, Vector::Constant(0.01));
  family("step-1-10", "0.1 of an edge", cube, Vector::Constant(0.1));
  family("step-1", "an edge", cube, Vector::Constant(1));
  family("corridor-1-100", "in a corridor, 0.01 of an edge", corridor, Vector::Constant(0.01));
  family("corridor-100", "100 edges along the corridor", corridor, {100, 0.1, 0.1});
  ladder.method(exact("step-sweep", "sorted anew"), [](const Asked& input) {
    return contact::sweep_pairs<double>(input->boxes, input->kept.sweep.axis()).pairs;
  });
  ladder.method(exact("step-incremental", "the order kept"), [](const Asked& input) {
    IncrementalSweep<double> sweep = input->kept.sweep;
    return sweep.update(input->boxes).pairs;
  });
  ladder.method(exact("step-prune", "orders on three axes and pairs kept"), [](const Asked& input) {
    contact::SweepAndPrune<double> sweep = input->kept.three_axes;
    return sweep.update(input->boxes).pairs;
  });
  ladder.method(exact("step-grid", "grid, made anew"),
                [](const Asked& input) { return contact::grid_pairs<double>(input->boxes).pairs; });
  ladder.method(exact("step-tree", "tree, made anew"),
                [](const Asked& input) { return contact::tree_pairs<double>(input->boxes).pairs; });
  ladder.method(exact("step-refit", "tree, refitted"), [](const Asked& input) {
    contact::BoxTree<double> tree = input->kept.tree;
    tree.refit(input->boxes);
    return tree.pairs().pairs;
  });
  ladder.method(exact("step-fat", "pairs of fat boxes kept"), [](const Asked& input) {
    contact::FatBoxPairs<double> fat = input->kept.fat;
    return fat.update(input->boxes).pairs;
  });
  ladder.show(shown);
  ladder.recommend("step-fat");
  return ladder;
}

}  // namespace steps

ladder::Parts experiment() {
  ladder::Parts parts("Broad phase: which boxes touch, and what does it cost to know?");
  parts.add(lists::experiment());
  parts.add(steps::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
