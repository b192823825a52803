#include "slabs_overlap.hpp"

namespace exercise {

std::vector<Slab> slabs_of(const std::vector<Eigen::Vector3d>& directions,
                           const std::vector<Eigen::Vector3d>& vertices) {
  //? One slab for each direction, in the same order.
  std::vector<Slab> slabs;
  for (const Eigen::Vector3d& n : directions) {
    //? Start from a vertex: any other number may be outside of the body.
    //? gap: n.dot(vertices.front())
    const double start = n.dot(vertices.front());
    Slab slab{start, start};
    //? Each vertex may lower the one plane or raise the other one.
    //? gap: n.dot(p)
    for (const Eigen::Vector3d& p : vertices) {
      const double d = n.dot(p);
      slab.low = std::min(slab.low, d);
      slab.high = std::max(slab.high, d);
    }
    slabs.push_back(slab);
  }
  return slabs;
}

bool between_each_pair(const std::vector<Eigen::Vector3d>& directions,
                       const std::vector<Slab>& slabs, const Eigen::Vector3d& point) {
  //? One plane with the point on its other side is enough to reject it.
  //? gap: directions[i].dot(point)
  //? gap: d < slabs[i].low || d > slabs[i].high
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const double d = directions[i].dot(point);
    if (d < slabs[i].low || d > slabs[i].high) return false;
  }
  return true;
}

int first_separating(const std::vector<Slab>& first, const std::vector<Slab>& second) {
  //? Two slabs are apart if one ends before the other begins. Either may be the one.
  //? gap: first[i].high < second[i].low || second[i].high < first[i].low
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i].high < second[i].low || second[i].high < first[i].low) return static_cast<int>(i);
  }
  return -1;
}

std::vector<Slab> moved(const std::vector<Eigen::Vector3d>& directions,
                        const std::vector<Slab>& slabs, const Eigen::Vector3d& displacement) {
  //? n · (p + d) = n · p + n · d: both planes move by the same, of either sign.
  //? gap: directions[i].dot(displacement)
  std::vector<Slab> after;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const double by = directions[i].dot(displacement);
    after.push_back({slabs[i].low + by, slabs[i].high + by});
  }
  return after;
}

}  // namespace exercise
