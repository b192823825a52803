// CGAL: its streamed segment trees, which choose between recursion and a sweep. It keeps nothing
// from step to step.
#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>

#include "peers.hpp"

namespace {

using Plain = CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_EXPLICIT>;
struct Box : Plain {
  Box(std::array<double, 3> low, std::array<double, 3> high, std::uint32_t i)
      : Plain(low.data(), high.data()), index(i) {}
  std::uint32_t index;
};

class Segments : public peers::Search {
 public:
  void find(const peers::Boxes& boxes, peers::Pairs& pairs) override {
    pairs.clear();
    std::vector<Box> made;
    made.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      made.emplace_back(boxes[i].low, boxes[i].high, i);
    }
    CGAL::box_self_intersection_d(made.begin(), made.end(), [&pairs](const Box& a, const Box& b) {
      pairs.push_back({a.index, b.index});
    });
  }
};

}  // namespace

std::vector<peers::BroadPhase> peers::cgal_phases() {
  return {phase<Segments>("CGAL, box_self_intersection_d")};
}
