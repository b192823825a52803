// Box3D: its tree in float, built at once, then asked about each box. A box that has left its old
// one is moved in the tree.
#include <box3d/box3d.h>

#include "peers.hpp"

namespace {

b3AABB limits(const peers::Limits& box) {
  const auto vector = [](const std::array<double, 3>& p) {
    return b3Vec3{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  };
  return {vector(box.low), vector(box.high)};
}

class Tree : public peers::Search {
 public:
  ~Tree() override { b3DynamicTree_Destroy(&tree_); }

  void find(const peers::Boxes& boxes, peers::Pairs& pairs) override {
    pairs.clear();
    const bool fresh = proxies_.empty();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (fresh) {
        proxies_.push_back(
            b3DynamicTree_CreateProxy(&tree_, limits(boxes[i]), B3_DEFAULT_CATEGORY_BITS, i));
      } else {
        b3DynamicTree_MoveProxy(&tree_, proxies_[i], limits(boxes[i]));
      }
    }
    b3DynamicTree_Rebuild(&tree_, fresh);
    Question question{0, &pairs};
    for (; question.box < boxes.size(); ++question.box) {
      b3DynamicTree_Query(&tree_, limits(boxes[question.box]), B3_DEFAULT_MASK_BITS, false, add,
                          &question);
    }
  }

 private:
  struct Question {
    std::uint32_t box;
    peers::Pairs* pairs;
  };
  static bool add(int, std::uint64_t found, void* context) {
    const auto* question = static_cast<const Question*>(context);
    const auto other = static_cast<std::uint32_t>(found);
    if (question->box < other) question->pairs->push_back({question->box, other});
    return true;
  }

  b3DynamicTree tree_ = b3DynamicTree_Create(16);
  std::vector<int> proxies_;
};

}  // namespace

std::vector<peers::BroadPhase> peers::box3d_phases() {
  return {phase<Tree>("Box3D, b3DynamicTree in float")};
}
