// FCL: managers of collision objects. Each object is a box that is not rotated.
#include <fcl/broadphase/broadphase_SSaP.h>
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/geometry/shape/box.h>

#include "peers.hpp"

namespace {

template <class Manager>
class Managed : public peers::Search {
 public:
  void find(const peers::Boxes& boxes, peers::Pairs& pairs) override {
    pairs.clear();
    const bool fresh = objects_.empty();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      fcl::Vector3d middle, size;
      for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        middle(k) = (boxes[i].low[axis] + boxes[i].high[axis]) / 2;
        size(k) = boxes[i].high[axis] - boxes[i].low[axis];
      }
      if (fresh) {
        objects_.push_back(
            std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Boxd>(size)));
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
    manager_.collide(&pairs, add);
  }

 private:
  static bool add(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* to) {
    const auto index = [](const fcl::CollisionObjectd* object) {
      return static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(object->getUserData()));
    };
    static_cast<peers::Pairs*>(to)->push_back({index(a), index(b)});
    return false;
  }

  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  std::vector<fcl::CollisionObjectd*> all_;
  Manager manager_;
};

}  // namespace

std::vector<peers::BroadPhase> peers::fcl_phases() {
  return {
      phase<Managed<fcl::DynamicAABBTreeCollisionManagerd>>("FCL, dynamic tree"),
      phase<Managed<fcl::DynamicAABBTreeCollisionManager_Arrayd>>("FCL, dynamic tree in an array"),
      phase<Managed<fcl::SaPCollisionManagerd>>("FCL, sweep and prune"),
      phase<Managed<fcl::SSaPCollisionManagerd>>("FCL, sorted list")};
}
