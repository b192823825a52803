// Bullet: its tree alone, its tree with the cache of pairs, and its sweep on three axes.
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <optional>

#include "peers.hpp"

namespace {

using peers::Boxes;
using peers::Limits;
using peers::Pairs;

btVector3 vector(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }
btDbvtVolume volume(const Limits& box) {
  return btDbvtVolume::FromMM(vector(box.low), vector(box.high));
}
void* as_pointer(std::size_t i) { return reinterpret_cast<void*>(i + 1); }
std::uint32_t as_index(const void* p) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(p) - 1);
}
bool touch(const btVector3& low_a, const btVector3& high_a, const btVector3& low_b,
           const btVector3& high_b) {
  for (int k = 0; k < 3; ++k) {
    if (low_a[k] > high_b[k] || low_b[k] > high_a[k]) return false;
  }
  return true;
}

/// The tree without margins: each leaf is inserted, later replaced where it has moved.
class Tree : public peers::Search {
 public:
  void find(const Boxes& boxes, Pairs& pairs) override {
    pairs.clear();
    if (leaves_.empty()) {
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        leaves_.push_back(tree_.insert(volume(boxes[i]), as_pointer(i)));
      }
    } else {
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        btDbvtVolume moved = volume(boxes[i]);
        tree_.update(leaves_[i], moved);
      }
    }
    struct Collect : btDbvt::ICollide {
      explicit Collect(Pairs& to) : pairs(to) {}
      void Process(const btDbvtNode* a, const btDbvtNode* b) override {
        if (a != b) pairs.push_back({as_index(a->data), as_index(b->data)});
      }
      Pairs& pairs;
    } collect(pairs);
    tree_.collideTT(tree_.m_root, tree_.m_root, collect);
  }

 private:
  btDbvt tree_;
  std::vector<btDbvtNode*> leaves_;
};

/// The pairs of a cache, whose boxes may have margins: those that touch.
void collect(btOverlappingPairCache& cache, Pairs& pairs) {
  const btBroadphasePairArray& found = cache.getOverlappingPairArray();
  for (int k = 0; k < found.size(); ++k) {
    const btBroadphaseProxy* a = found[k].m_pProxy0;
    const btBroadphaseProxy* b = found[k].m_pProxy1;
    if (touch(a->m_aabbMin, a->m_aabbMax, b->m_aabbMin, b->m_aabbMax)) {
      pairs.push_back({as_index(a->m_clientObject), as_index(b->m_clientObject)});
    }
  }
}

void update(btBroadphaseInterface& phase, std::vector<btBroadphaseProxy*>& proxies,
            const Boxes& boxes, Pairs& pairs) {
  pairs.clear();
  if (proxies.empty()) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      proxies.push_back(phase.createProxy(vector(boxes[i].low), vector(boxes[i].high), 0,
                                          as_pointer(i), 1, 1, nullptr));
    }
  } else {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      phase.setAabb(proxies[i], vector(boxes[i].low), vector(boxes[i].high), nullptr);
    }
  }
  phase.calculateOverlappingPairs(nullptr);
  collect(*phase.getOverlappingPairCache(), pairs);
}

/// As btDynamicsWorld uses it: boxes that have moved get a margin.
class Dbvt : public peers::Search {
 public:
  void find(const Boxes& boxes, Pairs& pairs) override { update(phase_, proxies_, boxes, pairs); }

 private:
  btDbvtBroadphase phase_;
  std::vector<btBroadphaseProxy*> proxies_;
};

/// A sweep on three axes, with coordinates rounded outward to 32 bits of a range that is given.
class Sweep : public peers::Search {
 public:
  void find(const Boxes& boxes, Pairs& pairs) override {
    if (!phase_) {
      phase_.emplace(btVector3(-limit, -limit, -limit), btVector3(limit, limit, limit),
                     static_cast<unsigned>(boxes.size() + 1));
    }
    update(*phase_, proxies_, boxes, pairs);
  }

 private:
  static constexpr double limit = 1 << 16;  // m
  std::optional<bt32BitAxisSweep3> phase_;
  std::vector<btBroadphaseProxy*> proxies_;
};

}  // namespace

std::vector<peers::BroadPhase> peers::bullet_phases() {
  std::vector<BroadPhase> phases{phase<Tree>("Bullet, btDbvt"),
                                 phase<Dbvt>("Bullet, btDbvtBroadphase"),
                                 phase<Sweep>("Bullet, bt32BitAxisSweep3")};
  // Each new proxy moves through the three sorted lists.
  phases.back().max_boxes = 3000;
  return phases;
}
