// How many of the fifteen axes are tried until one separates two boxes in motion, with and without
// a kept axis: the mean over all steps in which the boxes are disjoint.
#include <array>
#include <cmath>
#include <contact/box_axes.hpp>
#include <contact/oriented_box.hpp>
#include <contact/quaternion.hpp>
#include <cstdio>

namespace {

using contact::OrientedBox;
using contact::Vector3;

// The axis that proves two boxes disjoint, or -1, and how many were tried. `first` is tried first.
struct Tried {
  int axis = -1;
  int count = 0;
};
Tried separating_axis(const OrientedBox<double>& a, const OrientedBox<double>& b, int first) {
  Tried tried;
  for (int i = first < 0 ? 0 : -1; i < contact::box_axis_count; ++i) {
    if (i == first) continue;
    const int k = i < 0 ? first : i;
    ++tried.count;
    if (contact::detail::sign_of_separation(a, b, k) == 1) {
      tried.axis = k;
      return tried;
    }
  }
  return tried;
}

// A box on its way past another one, along path p, after a distance s, in m. It turns by 1 rad a m.
OrientedBox<double> falling(int p, double s) {
  OrientedBox<double> box;
  box.half_lengths = {1, 0.6, 0.4};
  box.centre = {-2.4 + 0.6 * (p % 9), -2.4 + 0.6 * (p / 9), 4 - s};
  box.axes =
      contact::matrix_of(contact::from_axis_angle<double>(Vector3<double>(2, 1, 2) / 3, s + p));
  return box;
}

}  // namespace

int main() {
  OrientedBox<double> fixed;
  fixed.half_lengths = {1, 0.5, 0.7};
  fixed.axes =
      contact::matrix_of(contact::from_axis_angle<double>(Vector3<double>(1, 2, 2) / 3, 0.5));
  std::printf("step, m    axes, fresh    axes, with a witness    witness sufficed\n");
  for (const double step : {0.001, 0.01, 0.1, 0.5, 1.0, 2.0}) {
    int disjoint = 0, fresh = 0, kept = 0, sufficed = 0;
    for (int path = 0; path < 81; ++path) {
      int axis = -1;
      for (int i = 0; i * step < 8; ++i) {
        const OrientedBox<double> box = falling(path, i * step);
        const Tried plain = separating_axis(box, fixed, -1);
        if (plain.axis < 0) continue;
        const Tried first = separating_axis(box, fixed, axis);
        ++disjoint;
        fresh += plain.count;
        kept += first.count;
        sufficed += axis >= 0 && first.axis == axis ? 1 : 0;
        axis = first.axis;
      }
    }
    std::printf("%7.3f %14.2f %23.2f %17.1f %%\n", step, double(fresh) / disjoint,
                double(kept) / disjoint, 100.0 * sufficed / disjoint);
  }
}
