/// @file
/// Boxes on a plane in other programs, each behind one class. Their headers stay in their own
/// files.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace peers {

using Numbers = std::array<double, 3>;

/// A solid box of uniform density, not rotated at the start.
struct Box {
  double mass = 1;   ///< kg
  Numbers size{};    ///< lengths of the edges, m
  Numbers centre{};  ///< at the start, m
  Numbers velocity{};
};

/// Boxes above the plane z = 0. Every pair has the same friction and restitution.
struct Scene {
  std::vector<Box> boxes;
  double gravity = 10;  ///< m/s²
  double friction = 0;
  double restitution = 0;
  double step = 1.0 / 60;  ///< s
};

/// A box after a step.
struct Motion {
  Numbers centre{}, velocity{}, angular_velocity{};
};

/// A scene in a program.
class World {
 public:
  World() = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  virtual ~World() = default;
  virtual void step() = 0;
  virtual std::vector<Motion> read() const = 0;
};

/// @param iterations of the solver, or substeps; 0: as the program comes
using Make = std::function<std::unique_ptr<World>(const Scene&, int iterations)>;

struct Program {
  std::string name;
  Make make;
  std::string counts;  ///< what its number counts: "iterations", "substeps"; empty: it has none
  bool plane_only = false;  ///< it knows the plane y = 0 only
};

std::vector<Program> bullet_programs();
std::vector<Program> ode_programs();
std::vector<Program> box2d_v3_programs();
std::vector<Program> box3d_programs();
std::vector<Program> jolt_programs();

}  // namespace peers
