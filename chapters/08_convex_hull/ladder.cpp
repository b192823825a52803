// What do right hulls cost? Gift wrapping and the incremental algorithm, in float, double and exact
// arithmetic, against the number of points and the share of them that are vertices.
#include <support/ladder.hpp>

#include <contact/convex_hull.hpp>
#include <contact/gift_wrapping.hpp>

namespace {

using Point = contact::Vector3<double>;

/// Every coordinate is a float, so that every method gets the same points.
struct Input {
  std::vector<Point> points;
};

/// What is compared: the vertices and the number of faces, or of triangles.
struct Answer {
  bool closed = false;
  bool only_triangles = false;
  std::vector<int> corners;
  std::size_t faces = 0, triangles = 0;
};

Point narrow(const Point& p) { return p.cast<float>().cast<double>(); }

Point in_cube(generators::Random& random) {
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
  return {x, y, random.uniform(-1, 1)};
}
Point in_ball(generators::Random& random) {
  for (;;) {
    const Point p = in_cube(random);
    if (p.squaredNorm() <= 1) return p;
  }
}
Point on_sphere(generators::Random& random) {
  for (;;) {
    const Point p = in_cube(random);
    const double square = p.squaredNorm();
    if (square <= 1 && square > 0.01) return p / std::sqrt(square);
  }
}

/// A share of the points is on the sphere and the others are well inside, so the share of vertices
/// is known.
auto with_share(double share) {
  return [share](generators::Random& random) {
    return random.chance(share) ? on_sphere(random) : Point(in_ball(random) / 4);
  };
}

template <class Draw>
Input many(generators::Random& random, int count, Draw draw) {
  Input input;
  for (int i = 0; i < count; ++i) input.points.push_back(narrow(draw(random)));
  return input;
}

Point on_grid(generators::Random& random) {
  const double x = random.integer(0, 3), y = random.integer(0, 3);
  return {x, y, double(random.integer(0, 3))};
}
/// Rounded sums of tenths: points near a plane.
Point nearly_flat(generators::Random& random) {
  const double x = random.integer(-10, 10) / 10.0, y = random.integer(-10, 10) / 10.0;
  return {x, y, 0.3 * x + 0.7 * y};
}
/// Half of the points share the greatest height.
Point tied_top(generators::Random& random) {
  const double x = random.integer(-8, 8), y = random.integer(-8, 8);
  return {x, y, random.chance(0.5) ? 8.0 : double(random.integer(-8, 7))};
}

Answer of_hull(const contact::Hull& hull) {
  Answer answer{hull.closed, false, hull.vertices, static_cast<std::size_t>(hull.face_count()), 0};
  // A face with k vertices has k - 2 triangles.
  answer.triangles = hull.face_vertices.size() - 2 * answer.faces;
  return answer;
}
Answer of_triangles(const contact::Wrapping& wrapping) {
  Answer answer{wrapping.closed, true, {}, 0, wrapping.triangles.size()};
  for (const auto& t : wrapping.triangles)
    answer.corners.insert(answer.corners.end(), t.begin(), t.end());
  std::sort(answer.corners.begin(), answer.corners.end());
  answer.corners.erase(std::unique(answer.corners.begin(), answer.corners.end()),
                       answer.corners.end());
  return answer;
}

ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.wrong =
      !got.closed || got.corners != right.corners ||
      (got.only_triangles ? got.triangles != right.triangles : got.faces != right.faces);
  return verdict;
}

constexpr std::size_t shown_points = 8;
constexpr double epsilon = 1e-6;

/// One point less, as long as the figure has too few points; then half the size, if that is large.
std::vector<Input> simpler(const Input& input) {
  std::vector<Input> all;
  if (input.points.size() > shown_points) {
    for (std::size_t i = 0; i < input.points.size(); ++i) {
      all.push_back(input);
      all.back().points.erase(all.back().points.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return all;
  }
  const auto large = [](const Point& p) { return p.cwiseAbs().maxCoeff() > 1.5; };
  if (std::none_of(input.points.begin(), input.points.end(), large)) return all;
  all.push_back(input);
  for (Point& p : all.back().points) p /= 2;
  return all;
}

/// The number of a method in the figure, or -1.
double in_figure(const std::string& id) {
  static const std::array<const char*, 7> ids{"grow-exact",   "slide",      "angles-double",
                                              "grow-epsilon", "grow-float", "grow-double",
                                              "wrap-double"};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (id == ids[i]) return static_cast<double>(i);
  }
  return -1;
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  const auto told = [](const char* name, const Answer& answer) {
    std::string words;
    if (!answer.closed) words = "not closed; ";
    words += answer.only_triangles ? std::to_string(answer.triangles) + " triangles"
                                   : std::to_string(answer.faces) + " faces";
    words += ", vertices";
    for (const int corner : answer.corners) words += " " + std::string(1, char('a' + corner));
    return ladder::Fact{name, words};
  };
  ladder::Example example;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const contact::Vector3<float> p = input.points[i].cast<float>();
    example.facts.push_back(ladder::numbers(std::string(1, char('a' + i)), p));
  }
  example.facts.push_back(told("this method", got));
  example.facts.push_back(told("exact", right));
  if (got.only_triangles)
    example.facts.push_back({"exact, in triangles", std::to_string(right.triangles)});
  const double way = in_figure(method.id);
  if (input.points.size() != shown_points) {
    example.note =
        "The figure shows eight points, and the method is right on all sets of eight of these that "
        "were tried.";
  } else if (way < 0) {
    example.note = "The figure does not have this method.";
  } else if (got.closed && got.corners == right.corners && got.triangles == right.triangles) {
    example.note =
        "Only the number of faces is wrong: the figure draws triangles, and these are the same.";
  } else {
    example.figure = "wrapping";
    for (std::size_t i = 0; i < shown_points; ++i)
      example.fields.push_back(ladder::field(std::string(1, char('a' + i)), input.points[i]));
    example.fields.push_back({"method", {way}});
    example.fields.push_back({"epsilon", {epsilon}});
    example.fields.push_back({"shown", {24}});
    example.fields.push_back({"flat", {0}});
  }
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  const auto truth = [](const Input& input) {
    return of_hull(contact::gift_wrap_with<contact::ExactSides>(input.points));
  };
  ladder::Ladder<Input, Answer> ladder("What is the hull of these points?", truth, judge);
  const auto family = [&ladder](const char* id, const char* title, int count, auto draw) {
    ladder.family(id, title,
                  [count, draw](generators::Random& random) { return many(random, count, draw); });
  };
  family("ball-8", "8 points in a ball", 8, in_ball);
  family("ball-24", "24 points in a ball", 24, in_ball);
  family("ball-72", "72 points in a ball", 72, in_ball);
  family("sphere-8", "8 points on a sphere", 8, on_sphere);
  family("sphere-24", "24 points on a sphere", 24, on_sphere);
  family("sphere-72", "72 points on a sphere", 72, on_sphere);
  family("share-quarter", "72 points, a quarter of them vertices", 72, with_share(0.25));
  family("share-half", "72 points, half of them vertices", 72, with_share(0.5));
  family("grid", "16 points of a grid, many equal", 16, on_grid);
  family("flat", "16 points near a plane", 16, nearly_flat);
  family("top", "16 points, half of them at the top", 16, tied_top);

  const auto add = [&ladder](const char* id, const char* title, const char* scalar, bool exact,
                             auto method) {
    ladder.method({.id = id, .title = title, .scalar = scalar, .exact = exact},
                  [method](const Input& input) { return method(input.points); });
  };
  using Points = std::vector<Point>;
  add("slide", "wrapping, angles as on the slide", "double", false, [](const Points& p) {
    return of_triangles(contact::wrap_by_angles<double>(p, contact::FoldAngle::unsigned_));
  });
  add("angles-float", "wrapping, signed angles", "float", false, [](const Points& p) {
    return of_triangles(contact::wrap_by_angles<float>(p, contact::FoldAngle::signed_));
  });
  add("angles-double", "wrapping, signed angles", "double", false, [](const Points& p) {
    return of_triangles(contact::wrap_by_angles<double>(p, contact::FoldAngle::signed_));
  });
  add("wrap-double", "wrapping, orientation", "double", false, [](const Points& p) {
    return of_hull(contact::gift_wrap_with<contact::RoundedSides<double>>(p));
  });
  add("wrap-exact", "wrapping, orientation", "double, then exact", true,
      [](const Points& p) { return of_hull(contact::gift_wrap(p)); });
  add("grow-float", "incremental", "float", false, [](const Points& p) {
    return of_hull(contact::convex_hull_with<contact::RoundedSides<float>>(p));
  });
  add("grow-double", "incremental", "double", false, [](const Points& p) {
    return of_hull(contact::convex_hull_with<contact::RoundedSides<double>>(p));
  });
  add("grow-epsilon", "incremental, epsilon 1e-6", "double", false, [](const Points& p) {
    return of_hull(contact::convex_hull_with<contact::RoundedSides<double>>(p, epsilon));
  });
  add("grow-exact", "incremental, filtered", "double, then exact", true,
      [](const Points& p) { return of_hull(contact::convex_hull(p)); });
  add("grow-unfiltered", "incremental, no filter", "exact", true, [](const Points& p) {
    return of_hull(contact::convex_hull_with<contact::UnfilteredSides>(p));
  });
  ladder.recommend("grow-exact");
  ladder.show(shown);
  ladder.simplify(simpler);
  return ladder;
}

}  // namespace

LADDER(experiment)
