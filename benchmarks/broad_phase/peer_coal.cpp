// Coal: managers of collision objects. Each object is a box that is not rotated.
#include <coal/broadphase/broadphase.h>
#include <coal/shape/geometric_shapes.h>

#include "peers.hpp"

namespace {

struct Collect : coal::CollisionCallBackBase {
  explicit Collect(peers::Pairs& to) : pairs(to) {}
  bool collide(coal::CollisionObject* a, coal::CollisionObject* b) override {
    const auto index = [](const coal::CollisionObject* object) {
      return static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(object->getUserData()));
    };
    pairs.push_back({index(a), index(b)});
    return false;
  }
  peers::Pairs& pairs;
};

template <class Manager>
class Managed : public peers::Search {
 public:
  void find(const peers::Boxes& boxes, peers::Pairs& pairs) override {
    pairs.clear();
    const bool fresh = objects_.empty();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      coal::Vec3s middle, size;
      for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        middle(k) = (boxes[i].low[axis] + boxes[i].high[axis]) / 2;
        size(k) = boxes[i].high[axis] - boxes[i].low[axis];
      }
      if (fresh) {
        objects_.push_back(
            std::make_unique<coal::CollisionObject>(std::make_shared<coal::Box>(size)));
        objects_.back()->setUserData(reinterpret_cast<void*>(i));
        all_.push_back(objects_.back().get());
      }
      objects_[i]->setTranslation(middle);
      objects_[i]->computeAABB();
    }
    if (fresh) {
      manager_.registerObjects(all_);
      manager_.setup();
    } else {
      manager_.update();
    }
    Collect collect(pairs);
    manager_.collide(&collect);
  }

 private:
  std::vector<std::unique_ptr<coal::CollisionObject>> objects_;
  std::vector<coal::CollisionObject*> all_;
  Manager manager_;
};

}  // namespace

std::vector<peers::BroadPhase> peers::coal_phases() {
  return {
      phase<Managed<coal::DynamicAABBTreeCollisionManager>>("Coal, dynamic tree"),
      phase<Managed<coal::DynamicAABBTreeArrayCollisionManager>>("Coal, dynamic tree in an array"),
      phase<Managed<coal::SaPCollisionManager>>("Coal, sweep and prune"),
      phase<Managed<coal::SSaPCollisionManager>>("Coal, sorted list")};
}
