/// @file
/// Other programs' tests of triangle pairs and of pairs of meshes, each behind one function. Their
/// headers stay in their own files.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace peers {

using Numbers = std::array<double, 3>;
using Corners = std::array<Numbers, 3>;

/// 1 where the two triangles of a pair meet, 0 where not.
using Answers = std::vector<char>;

/// A test of pairs: given all pairs once, before the clock starts, it keeps them in the other
/// program's types, and answers as often as it is asked.
using Ask = std::function<void(Answers&)>;
struct PairTest {
  std::string name;
  std::function<Ask(const std::vector<std::array<Corners, 2>>&)> prepare;
};

/// do_intersect of Triangle_3: exact predicates, and exact numbers behind intervals.
std::vector<PairTest> cgal_pairs();
/// What each asks of two triangles at the leaves of its trees: FCL its separating axes, Coal the
/// distance by GJK.
std::vector<PairTest> fcl_pairs();
std::vector<PairTest> coal_pairs();

struct MeshOfNumbers {
  std::vector<Numbers> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// Pairs of triangles by their numbers, the first of the first mesh, in any order.
using Found = std::vector<std::pair<int, int>>;

/// Another program's answers for two meshes. What it builds over them is made by build(), whose
/// time is taken, too; without build() everything is made for each question.
struct MeshTest {
  std::string name;
  std::function<void()> build;
  std::function<bool()> any;        ///< whether two triangles meet
  std::function<void(Found&)> all;  ///< all pairs that meet
};
/// The pairs of one mesh that have more in common than the vertices that they share.
struct SelfTest {
  std::string name;
  std::function<void(Found&)> all;
};

/// The polygon mesh processing package by sorted boxes, and the tree of boxes.
std::vector<MeshTest> cgal_meshes(const MeshOfNumbers& first, const MeshOfNumbers& second);
std::vector<SelfTest> cgal_self(const MeshOfNumbers& mesh);
/// Trees of oriented boxes.
std::vector<MeshTest> fcl_meshes(const MeshOfNumbers& first, const MeshOfNumbers& second);
std::vector<MeshTest> coal_meshes(const MeshOfNumbers& first, const MeshOfNumbers& second);

/// The test of a program that keeps the pairs it finds in a `Result`.
/// @param make a model of each mesh: what is timed as building
/// @param collide (models, most pairs, Result&): finds as many pairs at most
template <class Result, class Make, class Collide>
MeshTest tree_test(std::string name, Make make, Collide collide) {
  auto models = std::make_shared<decltype(make())>();
  const auto any = [models, collide] {
    Result result;
    collide(*models, 1, result);
    return result.isCollision();
  };
  const auto all = [models, collide](Found& found) {
    Result result;
    collide(*models, std::numeric_limits<int>::max(), result);
    found.clear();
    for (std::size_t i = 0; i < result.numContacts(); ++i) {
      const auto& contact = result.getContact(i);
      found.emplace_back(static_cast<int>(contact.b1), static_cast<int>(contact.b2));
    }
  };
  return {std::move(name), [models, make] { *models = make(); }, any, all};
}

/// A test that keeps each pair as `convert` makes it, and asks `meet` of it.
template <class Convert, class Meet>
PairTest pair_test(std::string name, Convert convert, Meet meet) {
  return {std::move(name), [convert, meet](const std::vector<std::array<Corners, 2>>& pairs) {
            using Kept = decltype(convert(pairs.front()[0]));
            auto kept = std::make_shared<std::vector<std::array<Kept, 2>>>();
            for (const auto& [first, second] : pairs) {
              kept->push_back({convert(first), convert(second)});
            }
            return Ask([kept, meet](Answers& answers) {
              for (std::size_t i = 0; i < kept->size(); ++i) {
                answers[i] = meet((*kept)[i][0], (*kept)[i][1]) ? 1 : 0;
              }
            });
          }};
}

}  // namespace peers
