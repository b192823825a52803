#include "run_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <variant>

#include <nlohmann/json.hpp>

#include "../grading/book.hpp"
#include "scenes/scene_file.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

std::string three(const Vector3<double>& v, const char* between) {
  return shortest_text(v.x()) + between + shortest_text(v.y()) + between + shortest_text(v.z());
}

bool is_xyz(const fs::path& path) { return path.extension() == ".xyz"; }

const BallShape& shape_of(const RunView& view, std::size_t ball) {
  return std::get<BallShape>(view.scene.bodies[view.balls.ball_body[ball]].shape);
}

const SceneBody& partner_body(const RunView& view, std::size_t partner) {
  const std::size_t count = view.balls.ball_body.size();
  return view.scene.bodies[partner < count ? view.balls.ball_body[partner]
                                           : view.balls.wall_body[partner - count]];
}

/// A number as its bits, so that what is read is what was written.
std::string bits_text(double x) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  return text.data();
}
double from_bits(const nlohmann::json& json) {
  const auto text = json.get<std::string>();
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') throw std::runtime_error("\"" + text + "\" is no number");
  return x;
}
nlohmann::json vector_json(const Vector3<double>& v) {
  return {bits_text(v.x()), bits_text(v.y()), bits_text(v.z())};
}
Vector3<double> vector_from(const nlohmann::json& json) {
  return {from_bits(json.at(0)), from_bits(json.at(1)), from_bits(json.at(2))};
}

}  // namespace

GrowingFile::GrowingFile(fs::path path, std::optional<std::uintmax_t> keep)
    : path_(std::move(path)) {
  if (keep) {
    std::error_code error;
    const std::uintmax_t there = fs::file_size(path_, error);
    if (error || there < *keep) {
      throw std::runtime_error(path_.string() + " is shorter than when the run was kept: " +
                               std::to_string(*keep) + " bytes are wanted");
    }
    fs::resize_file(path_, *keep);
    size_ = *keep;
    stream_.open(path_, std::ios::binary | std::ios::app);
  } else {
    stream_.open(path_, std::ios::binary | std::ios::trunc);
  }
  if (!stream_) throw std::runtime_error(path_.string() + " cannot be written");
}

void GrowingFile::add(const std::string& text) {
  stream_ << text;
  size_ += text.size();
  if (!stream_) throw std::runtime_error(path_.string() + " cannot be written to its end");
}

void GrowingFile::flush() {
  stream_.flush();
  if (!stream_) throw std::runtime_error(path_.string() + " cannot be written to its end");
}

bool is_trajectory_name(const fs::path& path) {
  return path.extension() == ".xyz" || path.extension() == ".csv";
}

std::string trajectory_heading(const fs::path& path, const SceneOutput& output) {
  if (is_xyz(path)) return "";
  return std::string("time,body,x,y,z") + (output.velocities ? ",vx,vy,vz" : "") + "\n";
}

std::string trajectory_frame(const fs::path& path, const RunView& view) {
  const std::size_t count = view.balls.ball_body.size();
  const bool velocities = view.scene.output.velocities;
  const std::string time = shortest_text(view.run.now());
  std::string text;
  if (is_xyz(path)) {
    text += std::to_string(count) + "\nProperties=species:S:1:pos:R:3:radius:R:1:id:I:1";
    text += std::string(velocities ? ":velo:R:3" : "") + " Time=" + time + " pbc=\"F F F\"\n";
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t body = view.balls.ball_body[i];
    if (is_xyz(path)) {
      text += "X " + three(view.run.position(i), " ") + " ";
      text += shortest_text(shape_of(view, i).radius) + " " + std::to_string(body);
      if (velocities) text += " " + three(view.run.velocity(i), " ");
    } else {
      text += time + "," + view.scene.bodies[body].name + "," + three(view.run.position(i), ",");
      if (velocities) text += "," + three(view.run.velocity(i), ",");
    }
    text += "\n";
  }
  return text;
}

std::string hits_heading() { return "time,first,second,x,y,z,impulse_x,impulse_y,impulse_z\n"; }

std::string hit_line(const RunView& view, const HardSphereHit& hit) {
  const Vector3<double> centre = view.run.position(hit.ball);
  const double radius = shape_of(view, hit.ball).radius;
  const SceneBody& partner = partner_body(view, hit.partner);
  Vector3<double> point;
  if (const auto* wall = std::get_if<HalfSpaceShape>(&partner.shape)) {
    point = centre - wall->normal * radius;
  } else {
    const double other = std::get<BallShape>(partner.shape).radius;
    point = centre + (view.run.position(hit.partner) - centre) * (radius / (radius + other));
  }
  return shortest_text(hit.time) + "," + partner_body(view, hit.ball).name + "," + partner.name +
         "," + three(point, ",") + "," + three(hit.impulse, ",") + "\n";
}

namespace {

/// Energy, momentum or angular momentum of a ball; what makes a ball's spin is never changed.
double moving_quantity(const RunView& view, std::size_t ball, const std::string& quantity) {
  const SceneBody& body = view.scene.bodies[view.balls.ball_body[ball]];
  const Vector3<double> x = view.run.position(ball);
  const Vector3<double> v = view.run.velocity(ball);
  const Vector3<double> turning = body.inertia * body.spin;
  if (quantity == "energy")
    return body.mass * v.dot(v) / 2 + body.spin.dot(turning) / 2 -
           body.mass * view.scene.gravity.dot(x);
  const int axis = quantity.back() - 'x';
  if (quantity.starts_with("momentum")) return body.mass * v(axis);
  return Vector3<double>(x.cross(v) * body.mass + turning)(axis);
}

double gap_of(const RunView& view, std::size_t ball) {
  double least = std::numeric_limits<double>::infinity();
  const Vector3<double> x = view.run.position(ball);
  const double radius = shape_of(view, ball).radius;
  for (std::size_t k = 0; k < view.balls.ball_body.size(); ++k) {
    if (k == ball) continue;
    least = std::min(least, (view.run.position(k) - x).norm() - radius - shape_of(view, k).radius);
  }
  for (const HardWall& wall : view.balls.setup.walls)
    least = std::min(least, wall.normal.dot(x) - wall.offset - radius);
  return least;
}

}  // namespace

double quantity_now(const RunView& view, const SceneExpectation& wanted) {
  if (wanted.quantity == "events") return static_cast<double>(view.run.counts().hits);
  const std::vector<std::size_t>& bodies = view.balls.ball_body;
  const auto of_all = [&](auto start, auto join) {
    double result = start;
    for (std::size_t i = 0; i < view.run.moving(); ++i) {
      if (!wanted.body.empty() && view.scene.bodies[bodies[i]].name != wanted.body) continue;
      result = join(result, i);
    }
    return result;
  };
  if (wanted.quantity == "gap") {
    return of_all(std::numeric_limits<double>::infinity(),
                  [&](double least, std::size_t i) { return std::min(least, gap_of(view, i)); });
  }
  if (wanted.quantity == "energy" || wanted.quantity.find("momentum") != std::string::npos) {
    return of_all(0.0, [&](double sum, std::size_t i) {
      return sum + moving_quantity(view, i, wanted.quantity);
    });
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const SceneBody& body = view.scene.bodies[bodies[i]];
    if (body.name != wanted.body) continue;
    if (wanted.quantity == "speed") return view.run.velocity(i).norm();
    const int axis = wanted.quantity.back() - 'x';
    if (wanted.quantity.starts_with("position")) return view.run.position(i)(axis);
    if (wanted.quantity.starts_with("velocity")) return view.run.velocity(i)(axis);
    return body.spin(axis);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::string scene_number(const Scene& scene) {
  Scene moves = scene;
  moves.expect.clear();
  // FNV-1a.
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : scenes::text_of_scene(moves)) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3u;
  }
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

void write_checkpoint(const fs::path& file, const RunCheckpoint& checkpoint) {
  const HardSphereCheckpoint& state = checkpoint.state;
  nlohmann::json balls = nlohmann::json::array();
  for (const HardSphereCheckpoint::Ball& ball : state.balls) {
    balls.push_back({vector_json(ball.position), vector_json(ball.velocity), bits_text(ball.time),
                     ball.last, ball.lies_on, ball.short_flights});
  }
  const nlohmann::json json{{"format", "contact-checkpoint/1"},
                            {"scene", checkpoint.scene},
                            {"time", bits_text(state.now)},
                            {"at_once", state.at_once},
                            {"frames", checkpoint.frames},
                            {"output_size", checkpoint.output_size},
                            {"events_size", checkpoint.events_size},
                            {"hits", state.counts.hits},
                            {"crossings", state.counts.crossings},
                            {"stale", state.counts.stale},
                            {"rests", state.counts.rests},
                            {"largest_overlap", bits_text(state.counts.largest_overlap)},
                            {"rest_error", bits_text(state.counts.rest_error)},
                            {"balls", balls}};
  grading::write_text(file, json.dump() + "\n");
}

RunCheckpoint read_checkpoint(const fs::path& file) {
  try {
    const nlohmann::json json = nlohmann::json::parse(grading::read_text(file));
    if (json.at("format") != "contact-checkpoint/1") throw std::runtime_error("unknown format");
    RunCheckpoint checkpoint;
    checkpoint.scene = json.at("scene").get<std::string>();
    checkpoint.frames = json.at("frames").get<std::uint64_t>();
    checkpoint.output_size = json.at("output_size").get<std::uintmax_t>();
    checkpoint.events_size = json.at("events_size").get<std::uintmax_t>();
    HardSphereCheckpoint& state = checkpoint.state;
    state.now = from_bits(json.at("time"));
    state.at_once = json.at("at_once").get<std::uint64_t>();
    state.counts.hits = json.at("hits").get<std::uint64_t>();
    state.counts.crossings = json.at("crossings").get<std::uint64_t>();
    state.counts.stale = json.at("stale").get<std::uint64_t>();
    state.counts.rests = json.at("rests").get<std::uint64_t>();
    state.counts.largest_overlap = from_bits(json.at("largest_overlap"));
    state.counts.rest_error = from_bits(json.at("rest_error"));
    for (const nlohmann::json& ball : json.at("balls")) {
      state.balls.push_back({vector_from(ball.at(0)), vector_from(ball.at(1)),
                             from_bits(ball.at(2)), ball.at(3).get<std::int32_t>(),
                             ball.at(4).get<std::int32_t>(), ball.at(5).get<std::int32_t>()});
    }
    return checkpoint;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() +
                             " is no checkpoint of contact simulate: " + error.what());
  }
}

}  // namespace contact::cli
