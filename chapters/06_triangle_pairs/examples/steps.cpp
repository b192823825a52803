// What six methods say about pairs of triangles, and in which step the lecture's decides.
#include <cmath>
#include <contact/pair_methods.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/triangles_meet.hpp>
#include <cstdio>

namespace {

using Triangle = contact::Triangle<double>;

/// An answer, with a star if it is wrong.
const char* word(bool meet, bool right) {
  if (meet) return right ? "meet" : "meet*";
  return right ? "apart*" : "apart";
}

void compare(const char* title, const Triangle& t, const Triangle& u) {
  const bool right = contact::triangles_meet(t, u);
  const auto steps = contact::meet_by_steps(t, u);
  std::printf("%-26s %-7s%4d  %-9s %-6s  %-6s  %-11s  %s\n", title,
              steps.coplanar ? "none" : word(steps.meet, right), steps.decided_in,
              word(contact::meet_by_intervals(t, u), right),
              word(contact::meet_by_edges(t, u), right), word(contact::meet_by_axes(t, u), right),
              word(contact::meet_by_orientations(t, u), right), word(right, right));
}

}  // namespace

int main() {
  std::printf("%-26s %-7s%4s  %-9s %-6s  %-6s  %-11s  %s\n", "", "steps", "step", "intervals",
              "edges", "axes", "orientation", "exact");
  // [pairs]
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Triangle crossing{{1, 1, -1}, {1, 1, 3}, {5, 5, 1}};
  compare("crossing", t, crossing);
  compare("a plane between", t, {{1, 1, 1}, {1, 1, 3}, {5, 5, 1}});
  compare("beside each other", t, {{3, 3, -1}, {3, 3, 3}, {5, 5, 1}});
  compare("in one plane, overlapping", t, {{1, 1, 0}, {5, 1, 0}, {1, 5, 0}});
  compare("in one plane, apart", t, {{3, 3, 0}, {5, 3, 0}, {3, 5, 0}});

  // In tenths, which doubles round.
  const Triangle tip{{0.4, 1, 0.3}, {0.8, 0, 0.4}, {0, 0.2, 0.2}};
  compare("a vertex in common", tip, {{0.7, 0.2, 0.1}, {1, 0, 0.9}, {0.4, 1, 0.3}});
  const Triangle edge{{0.6, 0.4, 0.6}, {1, 0.7, 1}, {0.1, 0.5, 0.5}};
  Triangle near{{0.8, 0.55, 0.8}, {0.2, 0.7, 0.1}, {0.7, 0.1, 0.6}};
  compare("a vertex beside an edge", near, edge);
  near.a.z() = std::nextafter(0.8, 1);
  compare("the same, one ulp further", near, edge);
  // [/pairs]

  const auto found = contact::meet_by_steps(crossing, t);
  std::printf("\ncrossing: p = (%g, %g, %g), q = (%g, %g, %g)\n", found.p.x(), found.p.y(),
              found.p.z(), found.q.x(), found.q.y(), found.q.z());
  std::printf("* is wrong; step 0: no answer in one plane\n");
}
