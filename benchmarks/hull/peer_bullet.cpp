// Bullet's hull for collision shapes: it rounds the points to a grid of whole numbers first.
#include <LinearMath/btConvexHullComputer.h>

#include "peers.hpp"

peers::Counts peers::bullet(const std::vector<double>& coordinates) {
  btConvexHullComputer computer;
  computer.compute(coordinates.data(), 3 * static_cast<int>(sizeof(double)),
                   static_cast<int>(coordinates.size() / 3), 0.0, 0.0);
  return {static_cast<std::size_t>(computer.vertices.size()),
          static_cast<std::size_t>(computer.faces.size())};
}
