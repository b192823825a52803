#include <support/observed.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace contact::testing {
namespace {

using Leaf = Leaves::Leaf;
using Near = std::function<bool(std::size_t, double, double)>;

struct Factor {
  double by;
  std::string_view words;
};

constexpr std::array<Factor, 14> kFactors{{
    {2, "twice"},
    {0.5, "half of"},
    {4, "four times"},
    {0.25, "a quarter of"},
    {3, "three times"},
    {1.0 / 3, "a third of"},
    {1000, "1000 times"},
    {0.001, "a thousandth of"},
    {std::numbers::pi, "π times"},
    {2 * std::numbers::pi, "2π times"},
    {180 / std::numbers::pi, "180/π times"},
    {std::numbers::pi / 180, "π/180 times"},
    {std::numbers::sqrt2, "√2 times"},
    {1 / std::numbers::sqrt2, "1/√2 times"},
}};

bool alike(const Leaf& a, const Leaf& b, std::size_t real, const Near& near) {
  if (a.is != b.is) return false;
  if (a.is == Leaf::Is::real) return near(real, a.number, b.number);
  return a.is == Leaf::Is::integer ? a.number == b.number : a.text == b.text;
}

/// Which of the doubles each leaf is.
std::vector<std::size_t> real_indices(const Leaves& of) {
  std::vector<std::size_t> indices;
  std::size_t next = 0;
  for (const Leaf& leaf : of.all) indices.push_back(leaf.is == Leaf::Is::real ? next++ : 0);
  return indices;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

std::string not_finite(const Leaves& got, const Leaves& right) {
  const auto any = [](const Leaves& of, auto predicate) {
    return std::any_of(of.all.begin(), of.all.end(),
                       [&](const Leaf& leaf) { return predicate(leaf.number); });
  };
  const auto nan = [](double x) { return std::isnan(x); };
  const auto infinite = [](double x) { return std::isinf(x); };
  if (any(got, nan) && !any(right, nan))
    return "There is a NaN in your answer. Which operation gives it: 0/0, 0 · ∞, ∞ − ∞, the root "
           "of a negative number, the arccosine of a number above 1?";
  if (any(got, infinite) && !any(right, infinite))
    return "There is an infinity in your answer. Which divisor is 0 for this input?";
  return "";
}

/// The entries of a list, each as its leaves.
std::vector<std::vector<Leaf>> entries_of(const Leaves& list) {
  std::vector<std::vector<Leaf>> entries(list.entries);
  for (const Leaf& leaf : list.all) entries[leaf.entry].push_back(leaf);
  return entries;
}

using Entry = std::vector<Leaf>;

std::string about_lists(const Leaves& got, const Leaves& right, const Near& near) {
  const std::vector<Entry> ours = entries_of(got);
  const std::vector<Entry> wanted = entries_of(right);
  // The tolerance may differ from entry to entry: the strictest that a pair could have is used.
  const auto same = [&](const Entry& a, const Entry& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!alike(a[i], b[i], 0, near)) return false;
    }
    return true;
  };
  const auto within = [&](const std::vector<Entry>& few, const std::vector<Entry>& many) {
    std::size_t next = 0;
    for (const Entry& entry : many)
      if (next < few.size() && same(few[next], entry)) ++next;
    return next == few.size();
  };
  const auto counted = [](std::size_t n) {
    return n == 1 ? std::string{"one entry"} : std::to_string(n) + " entries";
  };
  if (ours.empty()) return "Your list is empty, and the right one is not.";
  if (ours.size() < wanted.size() && within(ours, wanted))
    return "What is in your list is right and in the right order, but " +
           counted(wanted.size() - ours.size()) +
           (wanted.size() - ours.size() == 1 ? " is" : " are") + " missing.";
  if (ours.size() > wanted.size() && within(wanted, ours))
    return "All that belongs into your list is there, in the right order, and " +
           counted(ours.size() - wanted.size()) + " too many.";
  if (ours.size() == wanted.size() && ours.size() > 1) {
    std::vector<bool> used(wanted.size(), false);
    std::size_t matched = 0;
    for (const Entry& entry : ours) {
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!used[i] && same(entry, wanted[i])) {
          used[i] = true;
          ++matched;
          break;
        }
      }
    }
    if (matched == ours.size()) return "Your list has the right entries in another order.";
  }
  return "";
}

std::string about_numbers(const Leaves& got, const Leaves& right, const Near& near) {
  const std::vector<std::size_t> real = real_indices(got);
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < got.all.size(); ++i) {
    if (!alike(got.all[i], right.all[i], real[i], near)) wrong.push_back(i);
  }
  if (wrong.empty()) return "";
  const bool numbers = std::all_of(wrong.begin(), wrong.end(),
                                   [&](std::size_t i) { return got.all[i].is != Leaf::Is::other; });
  // All that is not zero: a factor does not show in a zero.
  const bool whole = std::all_of(right.all.begin(), right.all.end(), [&](const Leaf& leaf) {
    const auto i = static_cast<std::size_t>(&leaf - right.all.data());
    return (leaf.is != Leaf::Is::other && leaf.number == 0) ||
           std::find(wrong.begin(), wrong.end(), i) != wrong.end();
  });
  std::vector<std::string> names;
  for (const std::size_t i : wrong) names.push_back(got.all[i].name);
  const bool few = !whole && names.size() <= 3;
  const std::string what = joined(names);
  const std::string rest = few ? " The rest is right." : "";
  const auto every = [&](auto holds) {
    return numbers && std::all_of(wrong.begin(), wrong.end(), [&](std::size_t i) {
             return holds(i, got.all[i].number, right.all[i].number);
           });
  };
  const auto close = [&](std::size_t i, double a, double b) {
    return std::isfinite(a) && std::isfinite(b) && b != 0 &&
           (got.all[i].is == Leaf::Is::real ? near(real[i], a, b) : a == b);
  };
  if ((whole || few) && every([&](std::size_t i, double a, double b) { return close(i, -a, b); }))
    return whole ? "Your answer is the right one with the opposite sign."
                 : "The sign of " + what + " is wrong." + rest;
  if (wrong.size() == 1 && every([](std::size_t, double a, double b) { return a == 0 && b != 0; }))
    return (names[0].empty() ? "Your answer" : names[0]) + " is 0, and should not be." + rest;
  const Leaf& leaf = got.all[wrong[0]];
  const double a = leaf.number;
  const double b = right.all[wrong[0]].number;
  if (wrong.size() == 1 && leaf.is == Leaf::Is::integer && std::abs(a - b) == 1)
    return (leaf.name.empty() ? "Your answer" : leaf.name) + " is too " +
           (a > b ? "large" : "small") + " by one." + rest;
  if (whole || few) {
    for (const Factor& factor : kFactors) {
      const auto scaled = [&](std::size_t i, double x, double y) {
        return got.all[i].is == Leaf::Is::real && close(i, x / factor.by, y);
      };
      if (every(scaled))
        return (whole ? "Your answer is " : what + (wrong.size() == 1 ? " is " : " are ")) +
               std::string{factor.words} + " what is right." + rest;
    }
  }
  if (wrong.size() == 1 && leaf.is == Leaf::Is::real && a != 0) {
    if (close(wrong[0], 1 / a, b))
      return (leaf.name.empty() ? "Your answer" : leaf.name) +
             " is the reciprocal of what is right." + rest;
    if (a > 0 && close(wrong[0], std::sqrt(a), b))
      return (leaf.name.empty() ? "Your answer" : leaf.name) + " is the square of what is right." +
             rest;
    if (close(wrong[0], a * a, b))
      return (leaf.name.empty() ? "Your answer" : leaf.name) + " is the root of what is right." +
             rest;
  }
  if (wrong.size() == 2 && numbers && close(wrong[0], a, right.all[wrong[1]].number) &&
      close(wrong[1], got.all[wrong[1]].number, b))
    return joined(names) + " are exchanged." + rest;
  const auto rounded = [&](std::size_t i, double x, double y) {
    return got.all[i].is == Leaf::Is::real && y != 0 && std::abs(x - y) <= 1e-6 * std::abs(y);
  };
  if (every(rounded))
    return "Your answer agrees in its first six digits, but is not as accurate as it has to be.";
  if (few) return "Only " + what + (wrong.size() == 1 ? " is" : " are") + " wrong.";
  return "";
}

}  // namespace

std::string observed(const Leaves& got, const Leaves& right, const Near& near) {
  if (got.nothing && !right.nothing) return "There is an answer here, and you return none.";
  if (right.nothing && !got.nothing) return "There is no answer here, and you return one.";
  if (std::string text = not_finite(got, right); !text.empty()) return text;
  if (got.is_list && right.is_list) {
    if (std::string text = about_lists(got, right, near); !text.empty()) return text;
  }
  if (got.shape != right.shape || got.all.size() != right.all.size()) return "";
  return about_numbers(got, right, near);
}

}  // namespace contact::testing
