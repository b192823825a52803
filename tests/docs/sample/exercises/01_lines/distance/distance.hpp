#pragma once

namespace exercise {

/// The distance of (x, y) from the line a x + b y = c, in metres.
double distance(double a, double b, double c, double x, double y);

}  // namespace exercise
