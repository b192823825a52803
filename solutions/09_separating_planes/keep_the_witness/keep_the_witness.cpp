#include "keep_the_witness.hpp"

namespace exercise {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

// Whether all vertices of the other polygon are to the right of edge i, none on its line.
bool separates(const Polygon& polygon, std::size_t i, const Polygon& other) {
  const Eigen::Vector2d& start = polygon[i];
  const Eigen::Vector2d along = polygon[(i + 1) % polygon.size()] - start;
  return std::all_of(other.begin(), other.end(), [&](const Eigen::Vector2d& p) {
    return along.x() * (p.y() - start.y()) < along.y() * (p.x() - start.x());
  });
}

int edges(const Polygon& polygon) { return static_cast<int>(polygon.size()); }

}  // namespace

Answer test_pair(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b,
                 int witness) {
  //? The edge is looked up in the polygons as they are now: only its number was kept.
  //? gap: number - m
  const int m = edges(a), n = edges(b);
  const auto separated_by = [&](int number) {
    return number < m ? separates(a, static_cast<std::size_t>(number), b)
                      : separates(b, static_cast<std::size_t>(number - m), a);
  };
  //? The edge that was kept decides alone only if it still separates.
  //? gap: {true, witness, 1}
  const bool is_kept = witness >= 0 && witness < m + n;
  if (is_kept && separated_by(witness)) return {true, witness, 1};
  //? It is not tested again.
  //? gap: number == witness
  int tested = is_kept ? 1 : 0;
  for (int number = 0; number < m + n; ++number) {
    if (number == witness) continue;
    ++tested;
    if (separated_by(number)) return {true, number, tested};
  }
  //? No edge separates them, whatever was kept.
  return {false, -1, tested};
}

int exchanged(int witness, int edges_of_a, int edges_of_b) {
  //? The edges of B come first, so that those of A have larger numbers.
  //? gap: witness + edges_of_b
  //? gap: witness - edges_of_a
  if (witness < 0 || witness >= edges_of_a + edges_of_b) return -1;
  return witness < edges_of_a ? witness + edges_of_b : witness - edges_of_a;
}

Step test_pairs(const std::vector<std::vector<Eigen::Vector2d>>& polygons,
                const std::vector<std::array<int, 2>>& near, const std::vector<Kept>& kept) {
  //? Each pair adds to the two lists and to the count.
  Step step{{}, {}, 0};
  for (const auto& [i, j] : near) {
    //? The pair may have been kept in the other order, or not at all.
    //? gap: exchanged(one.witness, edges(b), edges(a))
    const Polygon &a = polygons[static_cast<std::size_t>(i)],
                  &b = polygons[static_cast<std::size_t>(j)];
    int witness = -1;
    for (const Kept& one : kept) {
      if (one.first == i && one.second == j) witness = one.witness;
      if (one.first == j && one.second == i) witness = exchanged(one.witness, edges(b), edges(a));
    }
    //? What is kept is what this step found.
    //? gap: {i, j, answer.witness}
    const Answer answer = test_pair(a, b, witness);
    step.tested += answer.tested;
    if (answer.apart)
      step.kept.push_back({i, j, answer.witness});
    else
      step.meeting.push_back({i, j});
  }
  return step;
}

}  // namespace exercise
