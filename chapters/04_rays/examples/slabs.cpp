// A box by its slabs: the interval of each, and rays that run in a face.
#include <contact/ray_box.hpp>
#include <cstdio>

using contact::Aabb;
using contact::Ray;

const Aabb<double> box{{0, 0, 0}, {2, 2, 2}};

void intervals(const Ray<double>& ray) {
  for (int k = 0; k < 3; ++k) {
    const double a = (box.low(k) - ray.origin(k)) / ray.direction(k);
    const double b = (box.high(k) - ray.origin(k)) / ray.direction(k);
    std::printf("slab of %c: from %5.2f to %5.2f\n", "xyz"[k], a < b ? a : b, a < b ? b : a);
  }
  const auto found = contact::passage(ray, box);
  std::printf("in the box: from %5.2f to %5.2f, in by face %d, out by face %d\n", found->entry,
              found->exit, found->entry_face, found->exit_face);
}

void row(const char* name, const Ray<double>& ray) {
  const auto said = [&](const auto& found) {
    return found && contact::first_hit(ray, *found) ? "hit" : "no hit";
  };
  std::printf("%-21s%-10s%-12s%-9s%s\n", name,
              said(contact::passage_by_slabs_with_division(ray, box)),
              said(contact::passage_by_branchless_slabs(ray, box)),
              said(contact::passage_by_padded_slabs(ray, box)),
              contact::hits_box(ray, box) ? "hit" : "no hit");
}

int main() {
  intervals({{-1, 3, 1}, {2, -1.5, 0.25}});
  std::printf("\n%-21s%-10s%-12s%-9s%s\n", "", "division", "branchless", "padded", "book");
  row("in the lower face", {{0, 1, -1}, {0, 0, 1}});
  row("the same, with -0", {{0, 1, -1}, {-0.0, 0, 1}});
  row("in the upper face", {{2, 1, -1}, {0, 0, 1}});
  row("the same, with -0", {{2, 1, -1}, {-0.0, 0, 1}});
  row("along an edge", {{2, 2, -1}, {0, 0, 1}});
  row("beside the face", {{2, 3, -1}, {0, 0, 1}});
}
