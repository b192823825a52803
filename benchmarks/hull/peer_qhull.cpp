// Qhull with its default handling of nearly flat facets: it merges them.
#include <cstdio>

#include "peers.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

peers::Counts peers::qhull(const std::vector<double>& coordinates) {
  qhT data;
  qhT* qh = &data;
  std::vector<double> copy = coordinates;
  char command[] = "qhull";
  qh_zero(qh, stderr);
  FILE* nothing = std::fopen("/dev/null", "w");
  const int count = static_cast<int>(copy.size() / 3);
  Counts counts;
  if (qh_new_qhull(qh, 3, count, copy.data(), False, command, nothing, nothing) == 0) {
    counts.vertices = static_cast<std::size_t>(qh->num_vertices);
    counts.faces = static_cast<std::size_t>(qh->num_facets);
  }
  qh_freeqhull(qh, !qh_ALL);
  int left = 0, total = 0;
  qh_memfreeshort(qh, &left, &total);
  if (nothing != nullptr) std::fclose(nothing);
  return counts;
}
