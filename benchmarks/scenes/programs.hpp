/// @file
/// The same scenes for several programs, each behind one interface. Their headers stay in their own
/// files. SI units; z is up. A program of the plane moves in x and z, and y is 0.
#pragma once

#include <array>
#include <memory>
#include <vector>

namespace scene_programs {

using Column = std::array<double, 3>;

/// What a body does at a moment.
struct Motion {
  Column place{};     ///< of its centre, m
  Column velocity{};  ///< m/s
};

/// All points x with normal · x ≤ offset are matter.
struct Wall {
  Column normal{};    ///< unit vector, out of the matter
  double offset = 0;  ///< m
};

/// Smooth, perfectly elastic balls of one size and mass.
struct Balls {
  int dimension = 3;  ///< 2: the plane of x and z
  double radius = 0.5;
  double gravity = 10;
  std::vector<Wall> walls;
  double plate = 0;  ///< thickness of a plate about the plane x = 0, 20 m wide; 0: there is none
  bool bullets = false;  ///< ask the program for continuous detection, if it has it
  std::vector<Motion> balls;
};

/// Cubes of edge 1 m on a floor, each on the one below, at rest.
struct Stack {
  int boxes = 10;
  double friction = 0.5;
  double gravity = 10;
};

/// A scene in a program.
class Run {
 public:
  Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  virtual ~Run() = default;
  virtual void step(double seconds) = 0;
  virtual std::vector<Motion> read() const = 0;
  /// The largest overlap that the program itself saw between steps, m.
  virtual double overlap_between_steps() const { return 0; }
};

std::unique_ptr<Run> bullet(const Balls& scene);
std::unique_ptr<Run> bullet(const Stack& scene);
std::unique_ptr<Run> ode(const Balls& scene);
std::unique_ptr<Run> ode(const Stack& scene);
std::unique_ptr<Run> box2d(const Balls& scene);
std::unique_ptr<Run> box2d(const Stack& scene);
/// The book's balls from event to event. A plate is two walls that only one side meets: the book
/// has no plates here, so the ball must not come round it.
std::unique_ptr<Run> book(const Balls& scene);
/// The book's boxes as their plan says: without rotation and friction, which two mirrors rule out.
std::unique_ptr<Run> book(const Stack& scene);
/// The same with rotation and friction, and without sleep.
std::unique_ptr<Run> book_with_everything(const Stack& scene);

}  // namespace scene_programs
