// What each broad phase costs for n = 64 to 16,384 boxes of the same density: steps, which are
// counted, and times, which the page measures by calling this program.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/broad_phase_cost.hpp>
#include <contact/figure.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

using Vector = contact::Vector3<double>;
using Boxes = std::vector<contact::Aabb<double>>;

constexpr std::size_t methods = 4;
constexpr int first_power = 6, last_power = 14;
constexpr std::size_t sizes = last_power - first_power + 1;

struct Input {
  double space;    // 0 a cube, 1 a floor, 2 a corridor
  double spread;   // of the edges: 0 all of 1 m, 1 from 0.25 m to 4 m, 2 one box contains all
  double density;  // boxes of 1 m that touch one, on average: 0 a tenth, 1 one, 2 ten
  double shown;    // 0 steps, 1 times
  double at;       // log₂ of the n whose numbers are shown
  double run;      // 0: the answer; 1 + 4 k + m: method m runs for 2^(6 + k) boxes, to be timed
  double measured_for;                          // the `setting` in which the times were measured
  std::array<double, methods * sizes> time_ms;  // of method m for 2^(6 + k) boxes: [4 k + m]; or 0
};

struct Output {
  double problem;
  double setting;  // space, spread and density as one number, greater than 0
  double repeats;  // of a run that is to be timed
  double n;        // the one whose numbers are shown
  std::array<double, methods * sizes> steps;            // like time_ms
  std::array<double, methods * sizes> times;            // those of the setting, or 0
  std::array<double, methods> steps_at, time_at;        // of n
  std::array<double, methods> steps_power, time_power;  // exponents of n; 0 if there is none
  double touching;                                      // pairs at n
  double predicted, quickest;  // methods at n; quickest −1 if a time is missing
  double in_time;              // 1 if the setting has times
  double linear_and_square;    // goal of a question: a method with an exponent below 1.1 of its
                               // times, and all pairs above 1.8
};

namespace {

/// A multiple of 2^-32 in [0, 1), from a counter (splitmix64's mixer).
double random_share(std::uint64_t& counter) {
  std::uint64_t z = (counter += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 32) * 0x1p-32;
}

/// The cube root of x ≥ 1 by Newton's method, which gives the same bits everywhere.
double cube_root(double x) {
  double root = x;
  for (int i = 0; i < 100; ++i) root = (2 * root + x / (root * root)) / 3;
  return root;
}

/// log₂ x, likewise: x = 2^e m with 1/√2 < m < √2, and the series of atanh.
double log_2(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.7071067811865476) {
    m *= 2;
    --exponent;
  }
  const double z = (m - 1) / (m + 1);
  double sum = 0;
  for (int k = 25; k >= 1; k -= 2) sum = sum * z * z + 1.0 / k;
  return exponent + 2.8853900817779268 * z * sum;
}

struct Setting {
  int space, spread, density;
  auto operator<=>(const Setting&) const = default;
  double number() const { return 1 + space + 3 * spread + 9 * density; }
};

Boxes made(const Setting& setting, int power) {
  const int n = 1 << power;
  constexpr std::array<double, 3> touched{0.1, 1, 10};
  constexpr std::array<double, 6> edges{0.25, 0.5, 0.75, 1, 1.5, 4};
  // Two cubes of 1 m overlap if their positions differ by less than 1 m on each axis: in 8 m³.
  const double room = n / touched[std::size_t(setting.density)];
  Vector side = Vector::Constant(cube_root(8 * room));
  if (setting.space == 1) side = {std::sqrt(4 * room), std::sqrt(4 * room), 0};
  if (setting.space == 2) side = {2 * room, 0, 0};
  std::uint64_t counter = 1;
  Boxes boxes;
  for (int i = 0; i < n; ++i) {
    Vector low;
    for (int k = 0; k < 3; ++k) low(k) = side(k) * random_share(counter);
    const double edge = setting.spread == 1 ? edges[std::size_t(i) % edges.size()] : 1;
    boxes.push_back({low, low + Vector::Constant(edge)});
  }
  if (setting.spread == 2) boxes.back() = {Vector::Zero(), side + Vector::Ones()};
  return boxes;
}

const Boxes& boxes_of(const Setting& setting, int power) {
  static std::map<std::pair<Setting, int>, Boxes> kept;
  if (!kept.empty() && kept.begin()->first.first != setting) kept.clear();
  const auto [entry, is_new] = kept.try_emplace({setting, power});
  if (is_new) entry->second = made(setting, power);
  return entry->second;
}

/// What is computed for a setting, once.
struct Answer {
  std::array<double, methods * sizes> steps{};
  std::array<double, sizes> touching{}, predicted{};
};

// [counted]
/// Comparisons of boxes, and the other steps that a method counts: entries in cells, comparisons of
/// the tree's nodes. Sorting is not among them.
void count(const Boxes& boxes, std::size_t k, Answer& answer) {
  const auto all = [](const contact::PairSearch& search) {
    return double(search.box_tests + search.other_steps);
  };
  const int axis = contact::best_sweep_axis<double>(boxes);
  const contact::PairSearch by_tree = contact::tree_pairs<double>(boxes);
  const std::array<double, methods> steps{double(contact::pair_count(boxes.size())),
                                          double(contact::overlaps_on_axis<double>(boxes, axis)),
                                          all(contact::grid_pairs<double>(boxes)), all(by_tree)};
  for (std::size_t m = 0; m < methods; ++m) answer.steps[methods * k + m] = steps[m];
  answer.touching[k] = double(by_tree.pairs.size());
  answer.predicted[k] = double(contact::broad_phase_cost<double>(boxes).cheapest());
}
// [/counted]

const Answer& answer_of(const Setting& setting) {
  static std::map<Setting, Answer> kept;
  const auto [entry, is_new] = kept.try_emplace(setting);
  for (std::size_t k = 0; k < sizes && is_new; ++k)
    count(boxes_of(setting, first_power + int(k)), k, entry->second);
  return entry->second;
}

/// The slope of the line that fits log₂ of a method's costs over log₂ n best, by least squares from
/// n = 512 on; 0 if one of the costs is missing.
double power_of(const std::array<double, methods * sizes>& costs, std::size_t method) {
  constexpr std::size_t from = 3;
  double sum = 0, squares = 0;
  const double middle = double(from + sizes - 1) / 2;
  for (std::size_t k = from; k < sizes; ++k) {
    const double cost = costs[methods * k + method];
    if (!(cost > 0)) return 0;
    sum += (double(k) - middle) * log_2(cost);
    squares += (double(k) - middle) * (double(k) - middle);
  }
  return sum / squares;
}

/// Runs a method as often as out.repeats says, for the page's clock.
void run(const Setting& setting, std::size_t index, Output& out) {
  const auto method = static_cast<contact::BroadPhase>(index % methods);
  const int power = first_power + static_cast<int>(index / methods);
  const Boxes& boxes = boxes_of(setting, power);
  const int spared = method == contact::BroadPhase::all_pairs ? 21 - 2 * power : 14 - power;
  out.repeats = spared > 0 ? double(1 << spared) : 1;
  for (int i = 0; i < int(out.repeats); ++i)
    out.touching = double(contact::touching_pairs<double>(boxes, method).pairs.size());
}

int choice(double x, int last) { return static_cast<int>(std::clamp(x, 0.0, double(last))); }

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const Setting setting{choice(in.space, 2), choice(in.spread, 2), choice(in.density, 2)};
  out.setting = setting.number();
  if (in.run >= 1) {
    run(setting, std::size_t(choice(in.run - 1, methods * sizes - 1)), out);
    return out;
  }
  const int power =
      static_cast<int>(std::clamp(std::round(in.at), double(first_power), double(last_power)));
  const auto shown = static_cast<std::size_t>(power - first_power);
  const Answer& answer = answer_of(setting);
  out.n = double(1 << power);
  out.steps = answer.steps;
  out.touching = answer.touching[shown];
  out.predicted = answer.predicted[shown];
  if (in.measured_for == out.setting) out.times = in.time_ms;
  for (double& time : out.times) {
    if (!(time > 0 && time < 1e9)) time = 0;
    if (time > 0) out.in_time = 1;
  }
  out.quickest = 0;
  for (std::size_t m = 0; m < methods; ++m) {
    const std::size_t index = methods * shown + m;
    out.steps_at[m] = out.steps[index];
    out.time_at[m] = out.times[index];
    out.steps_power[m] = power_of(out.steps, m);
    out.time_power[m] = power_of(out.times, m);
    if (out.time_at[m] == 0) out.quickest = -1;
    if (out.quickest >= 0 && out.time_at[m] < out.time_at[std::size_t(out.quickest)])
      out.quickest = double(m);
    if (m > 0 && out.time_power[m] > 0 && out.time_power[m] < 1.1 && out.time_power[0] > 1.8)
      out.linear_and_square = 1;
  }
  return out;
}

FIGURE(Input, FIELDS(space, spread, density, shown, at, run, measured_for, time_ms), Output,
       FIELDS(problem, setting, repeats, n, steps, times, steps_at, time_at, steps_power,
              time_power, touching, predicted, quickest, in_time, linear_and_square))
