#include "run_output.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include <contact/plan/plan_bounds.hpp>
#include <contact/scene/scene_file.hpp>

#include "../../grading/book/book.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

std::string three(const Vector3<double>& v, const char* between) {
  return shortest_text(v.x()) + between + shortest_text(v.y()) + between + shortest_text(v.z());
}

bool is_xyz(const fs::path& path) { return path.extension() == ".xyz"; }

bool is_listed(const SceneBody& body) {
  return !std::holds_alternative<HalfSpaceShape>(body.shape);
}

/// Whether orientations must be written: some bodies are not balls.
bool has_poses(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const SceneBody& body) {
    return is_listed(body) && !std::holds_alternative<BallShape>(body.shape);
  });
}

/// A number as its bits, so that the same number is read back.
std::string bits_text(double x) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  return text.data();
}
double from_bits(const nlohmann::json& json) {
  const auto text = json.get<std::string>();
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') throw std::runtime_error("\"" + text + "\" is not a number");
  return x;
}

}  // namespace

GrowingFile::GrowingFile(fs::path path, std::optional<std::uintmax_t> keep)
    : path_(std::move(path)) {
  if (keep) {
    std::error_code error;
    const std::uintmax_t there = fs::file_size(path_, error);
    if (error || there < *keep) {
      throw std::runtime_error(path_.string() + " is shorter than when the run was saved: " +
                               std::to_string(*keep) + " bytes are needed");
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

std::string trajectory_heading(const fs::path& path, const Scene& scene) {
  if (is_xyz(path)) return "";
  return std::string("time,body,x,y,z") + (has_poses(scene) ? ",qx,qy,qz,qw" : "") +
         (scene.output.velocities ? ",vx,vy,vz" : "") + "\n";
}

std::string trajectory_frame(const fs::path& path, const RunView& view) {
  const std::vector<SceneBody>& bodies = view.scene.bodies;
  const auto count = std::count_if(bodies.begin(), bodies.end(), is_listed);
  const bool velocities = view.scene.output.velocities;
  const bool poses = has_poses(view.scene);
  const std::string time = shortest_text(view.run.now());
  const bool xyz = is_xyz(path);
  const char* const between = xyz ? " " : ",";
  std::string text;
  if (xyz) {
    text += std::to_string(count) + "\nProperties=species:S:1:pos:R:3:radius:R:1:id:I:1";
    text += std::string(poses ? ":orientation:R:4" : "") + (velocities ? ":velo:R:3" : "");
    text += " Time=" + time + " pbc=\"F F F\"\n";
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!is_listed(bodies[i])) continue;
    if (xyz)
      text += "X " + three(view.run.position(i), between) + between +
              shortest_text(outer_radius(bodies[i].shape)) + between + std::to_string(i);
    else
      text += time + between + bodies[i].name + between + three(view.run.position(i), between);
    if (poses) {
      const Quaternion<double> lies = view.run.orientation(i);
      text += between + three(lies.v, between) + between + shortest_text(lies.w);
    }
    if (velocities) text += between + three(view.run.velocity(i), between);
    text += "\n";
  }
  return text;
}

std::string hits_heading() { return "time,first,second,x,y,z,impulse_x,impulse_y,impulse_z\n"; }

std::string hit_line(const Scene& scene, const SceneHit& hit) {
  return shortest_text(hit.time) + "," + scene.bodies[hit.first].name + "," +
         scene.bodies[hit.second].name + "," + three(hit.point, ",") + "," +
         three(hit.impulse, ",") + "\n";
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
  const SceneCheckpoint& state = checkpoint.state;
  nlohmann::json numbers = nlohmann::json::array();
  for (const double number : state.numbers) numbers.push_back(bits_text(number));
  const SceneRunCounts& counts = state.counts;
  nlohmann::json doubts = nlohmann::json::array();
  for (const double since : counts.doubts.times()) doubts.push_back(bits_text(since));
  nlohmann::json json{{"format", "contact-checkpoint/3"},
                      {"scene", checkpoint.scene},
                      {"plan", checkpoint.plan},
                      {"kind", state.kind},
                      {"time", bits_text(state.now)},
                      {"frames", checkpoint.frames},
                      {"output_size", checkpoint.output_size},
                      {"events_size", checkpoint.events_size},
                      {"counts",
                       {counts.steps, counts.substeps, counts.hits, counts.pairs, counts.contacts,
                        counts.iterations, counts.crossings, counts.rests, counts.crowded_steps}},
                      {"largest_overlap", bits_text(counts.largest_overlap)},
                      {"rest_error", bits_text(counts.rest_error)},
                      {"doubts", doubts},
                      {"numbers", numbers},
                      {"integers", state.integers}};
  if (state.fallback)
    json["fallback"] = {{"time", bits_text(state.fallback->time)}, {"why", state.fallback->why}};
  grading::write_text(file, json.dump() + "\n");
}

RunCheckpoint read_checkpoint(const fs::path& file) {
  try {
    const nlohmann::json json = nlohmann::json::parse(grading::read_text(file));
    if (json.at("format") != "contact-checkpoint/3") throw std::runtime_error("unknown format");
    RunCheckpoint checkpoint;
    checkpoint.scene = json.at("scene").get<std::string>();
    checkpoint.plan = json.at("plan").get<std::string>();
    checkpoint.frames = json.at("frames").get<std::uint64_t>();
    checkpoint.output_size = json.at("output_size").get<std::uintmax_t>();
    checkpoint.events_size = json.at("events_size").get<std::uintmax_t>();
    SceneCheckpoint& state = checkpoint.state;
    state.kind = json.at("kind").get<std::string>();
    state.now = from_bits(json.at("time"));
    SceneRunCounts& counts = state.counts;
    std::size_t at = 0;
    for (std::uint64_t* const count :
         {&counts.steps, &counts.substeps, &counts.hits, &counts.pairs, &counts.contacts,
          &counts.iterations, &counts.crossings, &counts.rests, &counts.crowded_steps})
      *count = json.at("counts").at(at++).get<std::uint64_t>();
    counts.largest_overlap = from_bits(json.at("largest_overlap"));
    counts.rest_error = from_bits(json.at("rest_error"));
    for (std::size_t i = 0; i < run_doubts; ++i)
      counts.doubts.add(static_cast<RunDoubt>(i), from_bits(json.at("doubts").at(i)));
    for (const nlohmann::json& number : json.at("numbers"))
      state.numbers.push_back(from_bits(number));
    state.integers = json.at("integers").get<std::vector<std::int64_t>>();
    if (json.contains("fallback"))
      state.fallback = SceneFallback{from_bits(json.at("fallback").at("time")),
                                     json.at("fallback").at("why").get<std::string>()};
    return checkpoint;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() +
                             " is not a checkpoint of contact simulate: " + error.what());
  }
}

}  // namespace contact::cli
