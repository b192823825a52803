// How tight is a bounding volume, and what does it cost to make, to carry along with its body and
// to compare? Each method of the chapter on sets of points and on five shapes, and how often
// volumes meet whose bodies do not.
#include <support/ladder.hpp>

#include <07_bounding_volumes/placed_shapes.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <contact/carried_points.hpp>
#include <contact/carried_volumes.hpp>
#include <contact/enclosing_radius.hpp>
#include <contact/grown_sphere.hpp>
#include <contact/measured_shapes.hpp>
#include <contact/moving_volumes.hpp>
#include <contact/pairs_spared.hpp>
#include <contact/principal_axes.hpp>
#include <contact/slab_volumes.hpp>
#include <contact/smallest_box.hpp>
#include <contact/smallest_sphere.hpp>
#include <contact/volume_kinds.hpp>
#include <contact/welzl_sphere.hpp>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace {

using contact::Aabb;
using contact::BoundingVolume;
using contact::Kdop;
using contact::Mesh;
using contact::OrientedBox;
using contact::Sphere;
using contact::VolumeKind;
using Point = contact::Vector3<double>;
using Points = std::vector<Point>;

ladder::Method rounded(const char* id, const char* title, const char* scalar) {
  return {.id = id, .title = title, .scalar = scalar, .exact = false};
}
/// What is proven to contain every point, or never to call bodies apart that meet.
ladder::Method conservative(const char* id, const char* title, const char* scalar = "double") {
  return {.id = id, .title = title, .scalar = scalar, .exact = true};
}

namespace spheres {

/// The same numbers in float and in double: the conversion is not timed.
struct Input {
  std::vector<contact::Vector3<float>> in_float;
  Points in_double;
};
using Asked = std::shared_ptr<const Input>;

struct Answer {
  Sphere<double> sphere;
  Asked of = {};  ///< in the true answer
};

Asked made(std::vector<contact::Vector3<float>> points) {
  auto input = std::make_shared<Input>();
  for (const auto& p : points) input->in_double.push_back(p.cast<double>());
  input->in_float = std::move(points);
  return input;
}

/// The radius of the smallest sphere, and the sphere itself as stored.
Answer truth(const Asked& input) {
  const auto smallest = contact::smallest_sphere<double>(input->in_double);
  return {{smallest.sphere.centre, std::sqrt(smallest.radius_squared)}, input};
}

/// Wrong is a sphere that has a point outside. The error is how much larger its radius is than the
/// smallest, as a share of that.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.wrong = !std::all_of(right.of->in_double.begin(), right.of->in_double.end(),
                               [&got](const Point& p) { return contact::contains(got.sphere, p); });
  if (right.sphere.radius > 0) {
    verdict.error = std::max(0.0, got.sphere.radius / right.sphere.radius - 1);
  }
  return verdict;
}

ladder::Example shown(const Asked& input, const Answer& got, const Answer& right,
                      const ladder::Method&) {
  ladder::Example example;
  const auto& points = input->in_float;
  example.facts.push_back(ladder::number("points", static_cast<double>(points.size())));
  for (std::size_t i = 0; i < points.size() && points.size() <= 8; ++i) {
    example.facts.push_back(ladder::numbers("point " + std::to_string(i), points[i]));
  }
  example.facts.push_back(ladder::numbers("centre, this method", got.sphere.centre));
  example.facts.push_back(ladder::number("radius, this method", got.sphere.radius));
  example.facts.push_back(ladder::number("the smallest radius", right.sphere.radius));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (contact::contains(got.sphere, input->in_double[i])) continue;
    example.facts.push_back(ladder::numbers("a point outside", points[i]));
    break;
  }
  example.note = "The figures show points in the plane.";
  return example;
}

/// Without one of the points, or without half of them.
std::vector<Asked> simpler(const Asked& input) {
  std::vector<Asked> all;
  const std::size_t n = input->in_float.size();
  const std::size_t step = n > 16 ? n / 2 : 1;
  for (std::size_t start = 0; n > 1 && start < n; start += step) {
    auto rest = input->in_float;
    const auto first = rest.begin() + static_cast<std::ptrdiff_t>(start);
    rest.erase(first, first + static_cast<std::ptrdiff_t>(std::min(step, n - start)));
    if (!rest.empty()) all.push_back(made(std::move(rest)));
  }
  return all;
}

Answer answer_of(const auto& sphere) {
  return {{sphere.centre.template cast<double>(), static_cast<double>(sphere.radius)}};
}

ladder::Ladder<Asked, Answer> experiment() {
  ladder::Ladder<Asked, Answer> ladder("Which sphere around points?", truth, judge);
  ladder.at_most(2000);
  using volume_families::Family;
  const auto family = [&ladder](const char* id, const char* title, Family of, bool by_error) {
    ladder.family(
        id, title,
        [of](generators::Random& random) {
          return made(volume_families::points<float>(random, of, 100));
        },
        by_error);
  };
  family("sphere-box", "in a box", Family::in_box, false);
  family("sphere-ball", "on a ball", Family::on_ball, false);
  family("sphere-grid", "on a grid", Family::grid, false);
  family("sphere-line", "nearly on a line", Family::collinear, false);
  family("sphere-far", "10⁶ from the origin", Family::far_6, false);
  family("size-box", "in a box, how large", Family::in_box, true);
  family("size-mesh", "of a mesh, how large", Family::mesh_vertices, true);

  const auto in_both = [&ladder](auto method, const ladder::Method& of_float,
                                 const ladder::Method& of_double) {
    ladder.method(of_float, [method](const Asked& input) {
      return answer_of(method(std::span<const contact::Vector3<float>>(input->in_float)));
    });
    ladder.method(of_double, [method](const Asked& input) {
      return answer_of(method(std::span<const Point>(input->in_double)));
    });
  };
  in_both([](const auto& points) { return contact::sphere_grown_as_given(points); },
          rounded("given-float", "the lecture's", "float"),
          rounded("given-double", "the lecture's", "double"));
  in_both([](const auto& points) { return contact::grown_sphere(points); },
          conservative("grown-float", "the lecture's centre, enclosing", "float"),
          conservative("grown-double", "the lecture's centre, enclosing"));
  in_both([](const auto& points) { return contact::centroid_sphere(points); },
          conservative("centroid-float", "about the centroid", "float"),
          conservative("centroid-double", "about the centroid"));
  ladder.method(conservative("box-centre", "about the centre of the AABB"), [](const Asked& input) {
    return answer_of(contact::box_centre_sphere<double>(input->in_double));
  });
  in_both([](const auto& points) { return contact::welzl_sphere(points); },
          rounded("welzl-float", "smallest, Welzl's", "float"),
          rounded("welzl-double", "smallest, Welzl's", "double"));
  in_both([](const auto& points) { return contact::smallest_sphere(points).sphere; },
          conservative("smallest-float", "smallest, decided exactly", "float, then exact"),
          conservative("smallest-double", "smallest, decided exactly", "double, then exact"));
  ladder.recommend("smallest-double");
  ladder.show(shown);
  ladder.simplify(simpler);
  return ladder;
}

}  // namespace spheres

/// What the questions about shapes share.
namespace shapes {

using placed_shapes::all;
using placed_shapes::Placed;
using placed_shapes::size_of;
using placed_shapes::Volume;
using Asked = std::shared_ptr<const Placed>;

struct Answer {
  Volume volume;
  Asked of = {};  ///< in the true answer
};
Answer truth(const Asked& input) { return {{}, input}; }
/// The volume that counts as no error, m³.
using Least = double (*)(const Placed& body, const Volume& got);

/// Wrong is a volume that has a vertex outside; the error is how much larger it is than it need be.
auto judge(Least least) {
  return [least](const Answer& got, const Answer& right) {
    ladder::Verdict verdict;
    const Points& vertices = right.of->vertices;
    verdict.wrong = !std::all_of(vertices.begin(), vertices.end(), [&got](const Point& p) {
      return placed_shapes::holds(got.volume, p);
    });
    verdict.error = std::max(0.0, size_of(got.volume) / least(*right.of, got.volume) - 1);
    return verdict;
  };
}

auto shown(Least least) {
  return [least](const Asked& input, const Answer& got, const Answer&, const ladder::Method&) {
    const auto& axes = input->frame.axes;
    ladder::Example example;
    example.facts = {{"shape", all()[static_cast<std::size_t>(input->shape)].name},
                     ladder::numbers("its x axis", Point(axes.col(0))),
                     ladder::numbers("its y axis", Point(axes.col(1))),
                     ladder::numbers("its z axis", Point(axes.col(2))),
                     ladder::number("volume, m³", size_of(got.volume)),
                     ladder::number("without error, m³", least(*input, got.volume))};
    example.note = "In the figure of tightness you can turn the same shape.";
    return example;
  };
}

/// One family for each shape.
void families(ladder::Ladder<Asked, Answer>& ladder, const std::string& prefix) {
  for (std::size_t i = 0; i < all().size(); ++i) {
    ladder.family(prefix + all()[i].name, all()[i].name, [i](generators::Random& random) {
      return std::make_shared<const Placed>(placed_shapes::placed(random, static_cast<int>(i)));
    });
  }
}

}  // namespace shapes

namespace making {

using shapes::Answer;
using shapes::Asked;

Mesh<double> hull_of(const Points& points) {
  return contact::mesh_of(contact::convex_hull(points), points);
}
double of_hull(const shapes::Placed& body, const shapes::Volume&) {
  return contact::mesh_volume(hull_of(body.vertices)).value;
}

ladder::Ladder<Asked, Answer> experiment() {
  ladder::Ladder<Asked, Answer> ladder(
      "How much larger than the hull, and what does it cost to make?", shapes::truth,
      shapes::judge(of_hull));
  ladder.at_most(8);
  shapes::families(ladder, "make-");
  const auto method = [&ladder](const ladder::Method& about, auto make) {
    ladder.method(about, [make](const Asked& input) { return Answer{make(*input)}; });
  };
  const auto of_points = [&method](const ladder::Method& about, auto make) {
    method(about, [make](const shapes::Placed& body) {
      return make(std::span<const Point>(body.vertices));
    });
  };
  of_points(conservative("grown", "the lecture's sphere"),
            [](auto points) { return contact::grown_sphere<double>(points); });
  of_points(conservative("smallest", "the smallest sphere"),
            [](auto points) { return contact::smallest_sphere<double>(points).sphere; });
  of_points(conservative("aabb", "AABB"),
            [](auto points) { return contact::aabb_of_points<double>(points); });
  method(conservative("object-box", "the box of the object's frame"),
         [](const shapes::Placed& body) {
           const Mesh<double>& mesh = shapes::all()[static_cast<std::size_t>(body.shape)].mesh;
           return contact::carried(contact::aabb_of_points<double>(mesh.vertices), body.frame);
         });
  of_points(conservative("principal", "principal axes"),
            [](auto points) { return contact::principal_box<double>(points); });
  of_points(conservative("smallest-box", "a smallest box"),
            [](auto points) { return contact::smallest_box<double>(points); });
  const auto slabs = [&of_points](const char* id, const char* title, int k) {
    of_points(conservative(id, title), [k](auto points) {
      return contact::kdop_of_points<double>(contact::kdop_normals<double>(k), points);
    });
  };
  slabs("dop-14", "14-DOP", 14);
  slabs("dop-18", "18-DOP", 18);
  slabs("dop-26", "26-DOP", 26);
  method(conservative("hull", "the hull"), [](const auto& body) { return hull_of(body.vertices); });
  ladder.show(shapes::shown(of_hull));
  ladder.recommend("dop-26");
  return ladder;
}

}  // namespace making

namespace carrying {

using shapes::Answer;
using shapes::Asked;

/// The volumes of a shape in its own frame, made once.
struct Made {
  Sphere<double> sphere;
  Aabb<double> aabb;
  OrientedBox<double> box;
  Kdop<double> dop_14, dop_26;
  Mesh<double> hull;
  double radius;  ///< from the origin of the frame
};
const Made& made(int shape) {
  static const std::vector<Made> all = [] {
    std::vector<Made> of_shapes;
    for (const auto& [name, mesh] : shapes::all()) {
      const std::span<const Point> points = mesh.vertices;
      const auto slabs = [&points](int k) {
        return contact::kdop_of_points<double>(contact::kdop_normals<double>(k), points);
      };
      of_shapes.push_back({contact::smallest_sphere<double>(points).sphere,
                           contact::aabb_of_points<double>(points),
                           contact::smallest_box<double>(points), slabs(14), slabs(26),
                           making::hull_of(mesh.vertices),
                           contact::enclosing_radius<double>(Point::Zero(), points)});
    }
    return of_shapes;
  }();
  return all[static_cast<std::size_t>(shape)];
}

/// Of the same kind, made anew in the new pose; of a sphere, a box or the hull the one that was
/// carried, which fits in every pose alike.
double made_anew(const shapes::Placed& body, const shapes::Volume& got) {
  const Made& before = made(body.shape);
  const std::span<const Point> points = body.vertices;
  return std::visit(
      [&]<class V>(const V& of) -> double {
        if constexpr (std::is_same_v<V, Aabb<double>>) {
          return contact::volume(contact::aabb_of_points<double>(points));
        } else if constexpr (std::is_same_v<V, Kdop<double>>) {
          return contact::volume(contact::kdop_of_points<double>(of.normals, points));
        } else if constexpr (std::is_same_v<V, Mesh<double>>) {
          return contact::mesh_volume(before.hull).value;
        } else if constexpr (std::is_same_v<V, OrientedBox<double>>) {
          return contact::volume(before.box);
        } else {
          return contact::volume(before.sphere);
        }
      },
      got);
}

ladder::Ladder<Asked, Answer> experiment() {
  ladder::Ladder<Asked, Answer> ladder(
      "How much does it grow in a new pose, and what does that cost?", shapes::truth,
      shapes::judge(made_anew));
  ladder.at_most(20);
  shapes::families(ladder, "carry-");
  const auto method = [&ladder](const ladder::Method& about, auto carry) {
    ladder.method(about, [carry](const Asked& input) {
      return Answer{carry(made(input->shape), input->frame)};
    });
  };
  method(conservative("carried-sphere", "the sphere, carried"),
         [](const Made& of, const auto& frame) { return contact::carried(of.sphere, frame); });
  method(conservative("carried-box", "a box, carried"),
         [](const Made& of, const auto& frame) { return contact::carried(of.box, frame); });
  method(conservative("any-aabb", "AABB of every orientation"),
         [](const Made& of, const auto& frame) {
           return contact::aabb_in_any_orientation<double>(frame.origin, of.radius);
         });
  method(
      conservative("carried-aabb", "AABB of the carried AABB"),
      [](const Made& of, const auto& frame) { return contact::aabb_of_carried(of.aabb, frame); });
  method(conservative("again-aabb", "AABB, again from the hull"),
         [](const Made& of, const auto& frame) {
           return contact::aabb_of_carried_points<double>(of.hull.vertices, frame);
         });
  method(conservative("carried-dop-14", "14-DOP, carried"),
         [](const Made& of, const auto& frame) { return contact::carried(of.dop_14, frame); });
  method(conservative("again-dop-14", "14-DOP, again from the hull"),
         [](const Made& of, const auto& frame) {
           return contact::kdop_of_carried<double>(of.dop_14.normals, of.hull.vertices, frame);
         });
  method(conservative("carried-dop-26", "26-DOP, carried"),
         [](const Made& of, const auto& frame) { return contact::carried(of.dop_26, frame); });
  method(conservative("again-dop-26", "26-DOP, again from the hull"),
         [](const Made& of, const auto& frame) {
           return contact::kdop_of_carried<double>(of.dop_26.normals, of.hull.vertices, frame);
         });
  method(rounded("carried-hull", "the hull, vertices rounded", "double"),
         [](const Made& of, const auto& frame) { return contact::transformed(of.hull, frame); });
  ladder.show(shapes::shown(made_anew));
  ladder.recommend("carried-box");
  return ladder;
}

}  // namespace carrying

namespace comparing {

/// Bodies of one shape, with all volumes of each: 120 pairs.
constexpr int bodies = 16;
struct Input {
  std::array<std::vector<BoundingVolume>, contact::all_volume_kinds.size()> volumes;
  std::vector<char> meet;
};
using Asked = std::shared_ptr<const Input>;
/// 1 for pairs that may meet.
using Answer = std::vector<char>;

template <class Pair>
Answer each_pair(const Pair& pair) {
  Answer answer;
  for (std::size_t i = 0; i < bodies; ++i) {
    for (std::size_t j = 0; j < i; ++j) answer.push_back(pair(i, j) ? 1 : 0);
  }
  return answer;
}

Asked made(generators::Random& random, std::size_t shape) {
  static const std::vector<std::vector<BoundingVolume>> of_shapes = [] {
    std::vector<std::vector<BoundingVolume>> all;
    for (const auto& [name, mesh] : shapes::all()) {
      all.push_back(contact::pairs_spared_detail::volumes_of(mesh));
    }
    return all;
  }();
  auto input = std::make_shared<Input>();
  std::vector<contact::MeshTree<double>> solids;
  for (const auto& body : contact::scattered_bodies(bodies, 1, 24, random.bits())) {
    for (std::size_t k = 0; k < input->volumes.size(); ++k) {
      input->volumes[k].push_back(contact::carried(of_shapes[shape][k], body.frame));
    }
    solids.emplace_back(contact::transformed(shapes::all()[shape].mesh, body.frame));
  }
  input->meet = each_pair([&solids](std::size_t i, std::size_t j) {
    return contact::solids_meet(solids[i], solids[j]);
  });
  return input;
}

/// Wrong is a scene with bodies that meet and were called apart. The error is the share of false
/// alarms among the pairs that are apart.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  int apart = 0, alarms = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    verdict.wrong = verdict.wrong || got[i] < right[i];
    apart += right[i] == 0;
    alarms += got[i] > right[i];
  }
  if (apart > 0) verdict.error = double(alarms) / apart;
  return verdict;
}

ladder::Example shown(const Asked&, const Answer& got, const Answer& right, const ladder::Method&) {
  const auto count = [](const Answer& answer) {
    return static_cast<double>(std::count(answer.begin(), answer.end(), 1));
  };
  ladder::Example example;
  example.facts = {ladder::number("pairs", static_cast<double>(right.size())),
                   ladder::number("pairs of bodies that meet", count(right)),
                   ladder::number("pairs of volumes that may meet", count(got))};
  example.note = "The figures show one body or two.";
  return example;
}

ladder::Ladder<Asked, Answer> experiment() {
  ladder::Ladder<Asked, Answer> ladder(
      "Which of 120 pairs of bodies may meet?", [](const Asked& input) { return input->meet; },
      judge);
  ladder.at_most(10);
  for (std::size_t i = 0; i < shapes::all().size(); ++i) {
    const char* name = shapes::all()[i].name;
    ladder.family(std::string("meet-") + name, name,
                  [i](generators::Random& random) { return made(random, i); });
  }
  for (std::size_t k = 0; k < contact::all_volume_kinds.size(); ++k) {
    const VolumeKind kind = contact::all_volume_kinds[k];
    const std::string id = "meet-kind-" + std::to_string(k);
    ladder.method(conservative(id.c_str(), contact::name_of(kind)), [k](const Asked& input) {
      const std::vector<BoundingVolume>& of = input->volumes[k];
      return each_pair(
          [&of](std::size_t i, std::size_t j) { return contact::may_meet(of[i], of[j]); });
    });
  }
  ladder.show(shown);
  ladder.recommend("meet-kind-8");
  return ladder;
}

}  // namespace comparing

ladder::Parts experiment() {
  ladder::Parts parts("Bounding volumes: how tight, and what do they cost?");
  parts.add(spheres::experiment());
  parts.add(making::experiment());
  parts.add(carrying::experiment());
  parts.add(comparing::experiment());
  return parts;
}

}  // namespace

LADDER(experiment)
