/// @file
/// Kept edges of polygons in integers, right or with one mistake that people make: what the test of
/// the exercise compares with and recognises.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "keep_the_witness.hpp"

namespace witness_with_mistakes {

using exercise::Answer;
using exercise::Kept;
using exercise::Step;
using Polygon = std::vector<Eigen::Vector2d>;

/// A vertex in whole numbers.
struct Vertex {
  std::int64_t x = 0, y = 0;
};

inline Vertex vertex(const Polygon& polygon, std::size_t i) {
  const Eigen::Vector2d& v = polygon[i % polygon.size()];
  return {static_cast<std::int64_t>(v.x()), static_cast<std::int64_t>(v.y())};
}

/// Positive if r is to the left of the line from p to q, negative if it is to the right.
inline std::int64_t side(const Vertex& p, const Vertex& q, const Vertex& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// When an edge counts as separating.
enum class Separates { rightly, if_touching, if_some_to_the_right, if_all_to_the_left };

inline bool edge_separates(const Polygon& polygon, std::size_t i, const Polygon& other,
                           Separates when = Separates::rightly) {
  const Vertex p = vertex(polygon, i), q = vertex(polygon, i + 1);
  std::size_t right = 0, left = 0, on = 0;
  for (std::size_t j = 0; j < other.size(); ++j) {
    const std::int64_t s = side(p, q, vertex(other, j));
    ++(s < 0 ? right : s > 0 ? left : on);
  }
  switch (when) {
    case Separates::if_touching:
      return left == 0;
    case Separates::if_some_to_the_right:
      return right > 0;
    case Separates::if_all_to_the_left:
      return left == other.size();
    case Separates::rightly:
      break;
  }
  return right == other.size();
}

/// What is done with the edge that was kept.
enum class Use {
  rightly,
  ignored,       ///< all edges are tested in order
  believed,      ///< it separates, whatever the vertices say
  alone,         ///< no other edge is tested
  tested_twice,  ///< once alone and once in order
  from_it,       ///< the others are tested from it on, round and round
  neighbours,    ///< of the others, only the two next to it are tested
  of_a_alone,    ///< the edge of A with this number is tested, or with what is left modulo m
  modulo,        ///< a number that no edge has is that of the edge which it leaves modulo m + n
  counted        ///< a number that no edge has counts as an edge that was tested
};

/// Which number is returned if an edge separates, and if none does.
enum class Returned {
  rightly,
  nothing_if_kept,  ///< −1 if the edge that was kept still separates
  kept_if_meeting,  ///< the number that was kept, if no edge separates
  own_number_in_b,  ///< an edge of B has the number that it has in B
  last_that_separates
};

struct Ways {
  Separates separates = Separates::rightly;
  Use use = Use::rightly;
  Returned returned = Returned::rightly;
  bool a_alone = false;         ///< the edges of B are not tested
  bool all_tested = false;      ///< the tests go on after an edge that separates
  bool last_uncounted = false;  ///< the edge that separates is not counted
};

/// The numbers of the edges in the order in which they are tested.
inline std::vector<int> in_order(int m, int n, int witness, const Ways& ways) {
  const int all = ways.a_alone ? m : m + n;
  const bool is_kept = witness >= 0 && witness < all;
  std::vector<int> numbers;
  if (is_kept && ways.use != Use::ignored) numbers.push_back(witness);
  if (is_kept && ways.use == Use::alone) return numbers;
  if (is_kept && ways.use == Use::neighbours) {
    const int first = witness < m ? 0 : m, count = witness < m ? m : n;
    numbers.push_back(first + (witness - first + 1) % count);
    numbers.push_back(first + (witness - first + count - 1) % count);
    return numbers;
  }
  const int start = is_kept && ways.use == Use::from_it ? witness : 0;
  for (int i = 0; i < all; ++i) {
    const int number = (start + i) % all;
    if (is_kept && number == witness && ways.use != Use::ignored && ways.use != Use::tested_twice)
      continue;
    numbers.push_back(number);
  }
  return numbers;
}

inline Answer test_pair(const Polygon& a, const Polygon& b, int witness, const Ways& ways = {}) {
  const int m = static_cast<int>(a.size()), n = static_cast<int>(b.size()), given = witness;
  const auto separated_by = [&](int number) {
    return number < m ? edge_separates(a, static_cast<std::size_t>(number), b, ways.separates)
                      : edge_separates(b, static_cast<std::size_t>(number - m), a, ways.separates);
  };
  if (ways.use == Use::modulo && witness >= 0) witness %= m + n;
  const bool is_kept = witness >= 0 && witness < m + n;
  if (is_kept && ways.use == Use::of_a_alone) witness %= m;
  if (is_kept && ways.use == Use::believed) return {true, witness, 0};
  Answer answer{false, -1, ways.use == Use::counted && !is_kept && given != -1 ? 1 : 0};
  for (const int number : in_order(m, n, witness, ways)) {
    ++answer.tested;
    if (!separated_by(number)) continue;
    if (answer.apart && ways.returned != Returned::last_that_separates) continue;
    answer.apart = true;
    answer.witness = number;
    if (ways.last_uncounted) --answer.tested;
    if (!ways.all_tested && ways.returned != Returned::last_that_separates) break;
  }
  if (!answer.apart && ways.returned == Returned::kept_if_meeting) answer.witness = given;
  if (answer.apart && ways.returned == Returned::nothing_if_kept && answer.witness == given)
    answer.witness = -1;
  if (ways.returned == Returned::own_number_in_b && answer.witness >= m) answer.witness -= m;
  return answer;
}

/// How the number of an edge is changed for the other order.
enum class Exchange {
  rightly,
  not_at_all,
  by_own_edges,  ///< the number of A's edges is added to a number of A
  none_as_edge,  ///< −1 as well
  added_to_both  ///< the number of B's edges is added to a number of B as well
};

inline int exchanged(int witness, int m, int n, Exchange how = Exchange::rightly) {
  if (how == Exchange::not_at_all) return witness;
  if (how == Exchange::none_as_edge) return witness < m ? witness + n : witness - m;
  if (witness < 0 || witness >= m + n) return -1;
  if (how == Exchange::by_own_edges) return witness < m ? witness + m : witness - m;
  if (how == Exchange::added_to_both) return witness + n;
  return witness < m ? witness + n : witness - m;
}

/// Which number a pair begins with.
enum class Begin {
  rightly,
  not_at_all,          ///< none
  by_position,         ///< that of the kept pair with the same index in the list
  from_the_last_pair,  ///< that of the pair which was tested before
  in_one_order,        ///< none if the pair was kept in the other order
  not_renumbered,      ///< as kept, also in the other order
  counts_exchanged     ///< renumbered with the numbers of edges of the other order
};

/// What a step returns.
enum class Result {
  rightly,
  old_pairs_too,  ///< pairs that are not near as well
  meeting_kept,   ///< pairs that meet as well, with −1
  old_order,      ///< pairs and numbers as they were kept, in the other order
  old_witness,    ///< the edge that was kept, whatever was found
  last_count      ///< how many edges were tested for the last pair
};

inline Step test_pairs(const std::vector<Polygon>& polygons,
                       const std::vector<std::array<int, 2>>& near, const std::vector<Kept>& kept,
                       Begin begin = Begin::rightly, Result result = Result::rightly) {
  Step step{{}, {}, 0};
  int before = -1;
  for (std::size_t at = 0; at < near.size(); ++at) {
    const auto [i, j] = near[at];
    const Polygon &a = polygons[static_cast<std::size_t>(i)],
                  &b = polygons[static_cast<std::size_t>(j)];
    const int m = static_cast<int>(a.size()), n = static_cast<int>(b.size());
    int witness = -1;
    bool in_other_order = false;
    for (const Kept& one : kept) {
      if (one.first == i && one.second == j) witness = one.witness;
      if (one.first != j || one.second != i || begin == Begin::in_one_order) continue;
      in_other_order = true;
      witness =
          begin == Begin::counts_exchanged
              ? witness_with_mistakes::exchanged(one.witness, m, n)
              : witness_with_mistakes::exchanged(
                    one.witness, n, m,
                    begin == Begin::not_renumbered ? Exchange::not_at_all : Exchange::rightly);
    }
    if (begin == Begin::not_at_all) witness = -1;
    if (begin == Begin::by_position) witness = at < kept.size() ? kept[at].witness : -1;
    if (begin == Begin::from_the_last_pair) witness = before;
    const Answer answer = witness_with_mistakes::test_pair(a, b, witness);
    before = answer.witness;
    step.tested = answer.tested + (result == Result::last_count ? 0 : step.tested);
    if (!answer.apart) step.meeting.push_back({i, j});
    if (answer.apart && in_other_order && result == Result::old_order)
      step.kept.push_back({j, i, witness_with_mistakes::exchanged(answer.witness, m, n)});
    else if (answer.apart && witness >= 0 && result == Result::old_witness)
      step.kept.push_back({i, j, witness});
    else if (answer.apart || result == Result::meeting_kept)
      step.kept.push_back({i, j, answer.witness});
  }
  if (result != Result::old_pairs_too) return step;
  for (const Kept& one : kept) {
    const bool is_near = std::any_of(near.begin(), near.end(), [&](const auto& pair) {
      return (pair[0] == one.first && pair[1] == one.second) ||
             (pair[0] == one.second && pair[1] == one.first);
    });
    if (!is_near) step.kept.push_back(one);
  }
  return step;
}

}  // namespace witness_with_mistakes
