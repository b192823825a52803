// GEOS counts crossings, with orientations in double-double arithmetic where a filter is not
// certain.
#include <geos/algorithm/PointLocation.h>
#include <geos/algorithm/locate/IndexedPointInAreaLocator.h>
#include <geos/geom/CoordinateSequence.h>
#include <geos/geom/Geometry.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LineString.h>
#include <geos/geom/Polygon.h>
#include <geos/io/WKTReader.h>

#include <cstdio>
#include <memory>
#include <string>

#include "peers.hpp"

using geos::geom::Coordinate;

static std::vector<Coordinate> pairs(const std::vector<double>& coordinates) {
  std::vector<Coordinate> points;
  for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2)
    points.emplace_back(coordinates[i], coordinates[i + 1]);
  return points;
}

namespace {

/// A polygon with the factory that it needs for its life. It is made from text, because the
/// functions that make one from coordinates differ between versions.
struct Shape {
  geos::geom::GeometryFactory::Ptr factory = geos::geom::GeometryFactory::create();
  std::unique_ptr<geos::geom::Geometry> geometry;
  const geos::geom::CoordinateSequence* coordinates = nullptr;
  std::unique_ptr<geos::algorithm::locate::IndexedPointInAreaLocator> locator;

  explicit Shape(const std::vector<double>& polygon) {
    std::vector<Coordinate> ring = pairs(polygon);
    ring.push_back(ring.front());
    std::string text = "POLYGON ((";
    for (const Coordinate& v : ring) {
      char pair[64];
      std::snprintf(pair, sizeof pair, "%.17g %.17g", v.x, v.y);
      text += (text.back() == '(' ? "" : ", ") + std::string(pair);
    }
    geometry = geos::io::WKTReader(*factory).read(text + "))");
    coordinates =
        dynamic_cast<geos::geom::Polygon&>(*geometry).getExteriorRing()->getCoordinatesRO();
    locator = std::make_unique<geos::algorithm::locate::IndexedPointInAreaLocator>(*geometry);
    const Coordinate first = ring.front();
    locator->locate(&first);  // makes the index
  }
};

/// Without a branch, as for the other programs.
peers::Place place(geos::geom::Location location) {
  using geos::geom::Location;
  static_assert(static_cast<int>(Location::INTERIOR) == 0 &&
                static_cast<int>(Location::EXTERIOR) == 2);
  return static_cast<peers::Place>(2 - static_cast<int>(location));
}

/// Shared, because a std::function must be copyable.
std::shared_ptr<std::vector<Shape>> make_shapes(const peers::Questions& questions) {
  auto shapes = std::make_shared<std::vector<Shape>>();
  shapes->reserve(questions.polygons.size());
  for (const std::vector<double>& polygon : questions.polygons) shapes->emplace_back(polygon);
  return shapes;
}

}  // namespace

peers::Locate peers::geos(const Questions& questions) {
  return [shapes = make_shapes(questions), at = pairs(questions.points)](auto& places) {
    in_turn(*shapes, at, places, [](const Shape& shape, const Coordinate& p) {
      return place(geos::algorithm::PointLocation::locateInRing(p, *shape.coordinates));
    });
  };
}

peers::Locate peers::geos_indexed(const Questions& questions) {
  return [shapes = make_shapes(questions), at = pairs(questions.points)](auto& places) {
    in_turn(*shapes, at, places, [](const Shape& shape, const Coordinate& p) {
      return place(shape.locator->locate(&p));
    });
  };
}
