// ODE: spaces of boxes that are not rotated.
#include <ode/ode.h>

#include <algorithm>

#include "peers.hpp"

namespace {

enum class Kind { hash, quadtree, sweep };

class Space : public peers::Search {
 public:
  explicit Space(Kind kind) : kind_(kind) {
    static const int started = dInitODE2(0);
    static_cast<void>(started);
  }
  ~Space() override {
    if (space_ != nullptr) dSpaceDestroy(space_);  // with its boxes
  }

  void find(const peers::Boxes& boxes, peers::Pairs& pairs) override {
    pairs.clear();
    if (space_ == nullptr) space_ = space_for(boxes);
    const bool fresh = geoms_.empty();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto& [low, high] = boxes[i];
      if (fresh) {
        geoms_.push_back(dCreateBox(space_, high[0] - low[0], high[1] - low[1], high[2] - low[2]));
        dGeomSetData(geoms_.back(), reinterpret_cast<void*>(i));
      }
      dGeomSetPosition(geoms_[i], (low[0] + high[0]) / 2, (low[1] + high[1]) / 2,
                       (low[2] + high[2]) / 2);
    }
    dSpaceCollide(space_, &pairs, add);
  }

 private:
  /// The quadtree divides a region that is given, and the hash a range of sizes.
  dSpaceID space_for(const peers::Boxes& boxes) const {
    if (kind_ == Kind::sweep) return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    if (kind_ == Kind::hash) return dHashSpaceCreate(nullptr);
    dVector3 middle{}, half{};
    for (std::size_t k = 0; k < 3; ++k) {
      double least = boxes.front().low[k], most = boxes.front().high[k];
      for (const peers::Limits& box : boxes) {
        least = std::min(least, box.low[k]);
        most = std::max(most, box.high[k]);
      }
      middle[k] = (least + most) / 2;
      half[k] = (most - least) / 2;
    }
    int depth = 1;  // about one box for each leaf
    while (depth < 8 && (std::size_t{1} << (2 * depth)) < boxes.size()) ++depth;
    return dQuadTreeSpaceCreate(nullptr, middle, half, depth);
  }
  /// A space hands over boxes that need not touch: it leaves the test to dCollide.
  static void add(void* to, dGeomID a, dGeomID b) {
    dReal x[6], y[6];
    dGeomGetAABB(a, x);
    dGeomGetAABB(b, y);
    for (int k = 0; k < 6; k += 2) {
      if (x[k] > y[k + 1] || y[k] > x[k + 1]) return;
    }
    const auto index = [](dGeomID geom) {
      return static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(dGeomGetData(geom)));
    };
    static_cast<peers::Pairs*>(to)->push_back({index(a), index(b)});
  }

  Kind kind_;
  dSpaceID space_ = nullptr;
  std::vector<dGeomID> geoms_;
};

}  // namespace

std::vector<peers::BroadPhase> peers::ode_phases() {
  std::vector<BroadPhase> phases{phase<Space>("ODE, hash space", Kind::hash),
                                 phase<Space>("ODE, quadtree space", Kind::quadtree),
                                 phase<Space>("ODE, sweep and prune space", Kind::sweep)};
  for (BroadPhase& phase : phases) phase.max_boxes = 10000;
  return phases;
}
