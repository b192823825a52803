// A ball of radius 0.25 m, 3.25 m from a wall, at 6 m/s, in a step of 1 s: contact after half of
// the step, as in the lecture's example.
#include <contact/moving_sphere_plane.hpp>
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>
#include <cstdio>

int main() {
  const double step = 1;  // s
  const auto wall = contact::plane_from_normal_and_point<double>({-1, 0, 0}, {3.25, 0, 0});
  const contact::Sphere<double> ball{{0, 1, 0}, 0.25};
  const contact::Vector3<double> velocity(6, 0, 0);
  const contact::Vector3<double> displacement = velocity * step;

  const auto touch = contact::moving_sphere_plane(ball, displacement, wall);
  std::printf("offset plane: touches at t = %g, %g s, centre x = %g m, contact point x = %g m\n",
              touch->t, touch->t * step, touch->centre.x(), touch->point.x());

  const auto centre =
      contact::segment_plane<double>({ball.centre, ball.centre + displacement}, wall);
  std::printf("centre alone: t = %.4f, the ball is then %.2f m deep in the wall\n", centre->t,
              centre->point.x() + ball.radius - 3.25);

  const contact::Vector3<double> rest(0, 0, 0);
  std::printf("at rest: %s\n", contact::moving_sphere_plane(ball, rest, wall)
                                   ? "a hit"
                                   : "no hit, and no division by 0");
}
