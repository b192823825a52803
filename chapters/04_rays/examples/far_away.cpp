// A ball of radius 1 from further and further away, by all methods of the chapter: how far the
// entry is from the start of the ball, in front of its centre; right is 0.8.
#include <cmath>
#include <contact/ray_sphere.hpp>
#include <cstdio>

using contact::Ray;
using contact::Sphere;
using contact::Vector3;

/// The line passes 0.6 above the centre, so it enters 0.8 in front of it.
template <class S>
Ray<S> ray_from(double distance) {
  return {Vector3<S>(S(-distance), S(0.6), S(0)), Vector3<S>(1, 0, 0)};
}

/// How far in front of the centre the line enters.
template <class S>
void print(double distance, const std::optional<contact::Passage<S>>& found) {
  if (found) {
    std::printf("%10.6f", distance - double(found->entry));
  } else {
    std::printf("%10s", "no hit");
  }
}

int main() {
  std::printf("%8s%10s%10s%10s%10s%10s\n", "from", "lecture", "textbook", "nearest", "book",
              "textbook");
  std::printf("%8s%10s%10s%10s%10s%10s\n", "", "", "", "point", "", "in float");
  const Sphere<double> ball{{0, 0, 0}, 1};
  const Sphere<float> ball_in_float{{0, 0, 0}, 1};
  for (const int power : {1, 3, 4, 6, 7, 8, 9}) {
    const double distance = std::pow(10, power);
    const Ray<double> ray = ray_from<double>(distance);
    std::printf("10^%d    ", power);
    print<double>(distance, contact::passage_by_lecture(ray, ball));
    print<double>(distance, contact::passage_by_textbook(ray, ball));
    print<double>(distance, contact::passage_by_nearest_point(ray, ball));
    print<double>(distance, contact::passage(ray, ball));
    print<float>(distance, contact::passage_by_textbook(ray_from<float>(distance), ball_in_float));
    std::printf("\n");
  }
}
