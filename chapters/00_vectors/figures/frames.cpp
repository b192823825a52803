// A wagon and a point beside it: one position, and its coordinates in the world and in the wagon.
#include <cmath>
#include <contact/figure.hpp>
#include <contact/frame.hpp>

struct Input {
  contact::Vector2<double> origin;   // of the wagon, m
  contact::Vector2<double> forward;  // in which it faces, m
  contact::Vector2<double> point;    // m
};

struct Output {
  double problem;
  contact::Vector2<double> x_axis, y_axis;  // of the wagon, in the world
  contact::Vector2<double> as_position;     // the point in the wagon's frame
  contact::Vector2<double> as_direction;    // the same two numbers as a velocity, in its frame
  contact::Vector2<double> corner;          // as far ahead as the point, in the world
  double ahead_and_left;                    // goal of a question: 2 ahead, 1 to the left
};

Output compute(const Input& in) {
  using contact::Vector3;
  Output out{};
  for (const auto* v : {&in.origin, &in.forward, &in.point}) {
    if (v->cwiseAbs().maxCoeff() > 1e15) out.problem = contact::figure::too_large;
  }
  const double length = in.forward.norm();
  if (!(length > 1e-15)) out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;

  const auto flat = [](const contact::Vector2<double>& v) {
    return Vector3<double>(v.x(), v.y(), 0);
  };
  contact::CoordinateFrame<double> wagon;
  wagon.origin = flat(in.origin);
  wagon.axes.col(0) = flat(in.forward) / length;
  wagon.axes.col(2) = Vector3<double>(0, 0, 1);
  wagon.axes.col(1) = Vector3<double>(wagon.axes.col(2)).cross(Vector3<double>(wagon.axes.col(0)));

  out.x_axis = wagon.axes.col(0).head<2>();
  out.y_axis = wagon.axes.col(1).head<2>();
  out.as_position = contact::position_in_frame(wagon, flat(in.point)).head<2>();
  out.as_direction = contact::direction_in_frame(wagon, flat(in.point)).head<2>();
  out.corner =
      contact::position_in_world(wagon, Vector3<double>(out.as_position.x(), 0, 0)).head<2>();
  out.ahead_and_left =
      (out.as_position - contact::Vector2<double>(2, 1)).cwiseAbs().maxCoeff() <= 0.1 &&
              std::abs(out.y_axis.x()) >= 0.25
          ? 1
          : 0;
  return out;
}

FIGURE(Input, FIELDS(origin, forward, point), Output,
       FIELDS(problem, x_axis, y_axis, as_position, as_direction, corner, ahead_and_left))
