// A corner enters a floor of tiles: what points and what segments on the perimeter see, and the
// normal by each rule.
#include <contact/perimeter.hpp>
#include <cstdio>

using contact::Polygon;
using contact::Vector2;

int main() {
  const Polygon<double> floor{{-1, -1}, {1, -1}, {1, 0}, {0.5, 0}, {0, 0}, {-0.5, 0}, {-1, 0}};
  const Polygon<double> body{{0.125, -0.1875}, {1.125, 0.8125}, {0.125, 1.8125}, {-0.875, 0.8125}};

  std::printf("%-22s %7s %7s\n", "on the body", "tests", "found");
  for (const double spacing : {1.0, 0.25, 0.0625}) {
    const auto points = contact::perimeter_points(body, spacing);
    const auto hits = contact::hit_points(points, floor);
    std::printf("points every %-9g %7lld %7zu\n", spacing, static_cast<long long>(hits.tests),
                hits.points.size());
  }
  const auto contact = contact::perimeter_contact(body, floor);
  std::printf("%-22s %7lld %7zu\n\n", "segments", static_cast<long long>(contact.found.tests),
              contact.found.hits.size());

  std::printf("%-22s %-16s %s\n", "common point", "by the floor", "nearer end");
  for (const auto& hit : contact.found.hits) {
    const Vector2<double> of_hit = contact::normal_of_hit_segment(contact, hit);
    const Vector2<double> by_end = contact::normal_by_nearer_end(contact, hit);
    std::printf("(%7.4f, %7.4f)     (%5.2f, %5.2f)   (%5.2f, %5.2f)\n", hit.crossing.point.x(),
                hit.crossing.point.y(), of_hit.x(), of_hit.y(), by_end.x(), by_end.y());
  }
  const auto face = contact::face_of_least_penetration(contact);
  std::printf("least penetration: (%.2f, %.2f), %.4f m deep\n", face->normal.x(), face->normal.y(),
              face->depth);
}
