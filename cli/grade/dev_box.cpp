// contact dev box: runs one command in a box and says how it ended.

#include "dev_box.hpp"

#include <nlohmann/json.hpp>

#include "../../grading/sandbox/box.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

struct Options {
  std::string kind = "answer";
  std::vector<std::string> command;
  std::vector<std::string> shown;
  std::string writable;
  std::string folder = "/";
  grading::BoxLimits limits;
  int times = 1;
};

grading::BoxKind kind_of(const std::string& name) {
  if (name == "compile") return grading::BoxKind::compile;
  return name == "judge" ? grading::BoxKind::judge : grading::BoxKind::answer;
}

// "HOST=BOX", or one path that is the same in both.
grading::BoxMount mount_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return {fs::absolute(text), fs::absolute(text)};
  return {fs::absolute(text.substr(0, equals)), text.substr(equals + 1)};
}

std::string_view words(grading::Ended ended) {
  switch (ended) {
    case grading::Ended::time:
      return "time";
    case grading::Ended::idle:
      return "idle";
    case grading::Ended::output:
      return "output";
    case grading::Ended::unwanted:
      return "unwanted";
    case grading::Ended::by_itself:
      break;
  }
  return "by_itself";
}

int run(Context& context, const Options& options) {
  const grading::Machine machine = grading::find_machine(context.loop());
  const grading::Seat seat(machine);
  grading::BoxSpec spec;
  spec.kind = kind_of(options.kind);
  spec.command = options.command;
  for (const std::string& shown : options.shown) spec.read_only.push_back(mount_of(shown));
  if (!options.writable.empty()) {
    spec.writable = mount_of(options.writable);
    seat.give(spec.writable.host);
  }
  spec.system = spec.kind != grading::BoxKind::answer;
  spec.folder = options.folder;
  spec.limits = options.limits;
  const auto start = std::chrono::steady_clock::now();
  grading::BoxEnd end;
  for (int i = 0; i < options.times; ++i)
    end = grading::run_box(context.loop(), machine, seat, spec);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say(nlohmann::json{{"format", "contact-dev-box/1"},
                     {"level", grading::words(machine.level)},
                     {"exit_code", end.process.exit_code},
                     {"signal", end.process.signal},
                     {"ended", words(end.process.ended)},
                     {"out_of_memory", end.out_of_memory},
                     {"cpu_seconds", end.cpu_seconds},
                     {"seconds", seconds / options.times},
                     {"output", end.process.output},
                     {"errors", end.process.errors}}
          .dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  return end.process.succeeded() ? exit_passed : exit_not_passed;
}

}  // namespace

void add_dev_box(Command dev, Action& action) {
  auto options = std::make_shared<Options>();
  const Command box =
      dev.add_subcommand("box", "Run a command in a sandbox, and print as JSON how it ended");
  box.add_option("command", options->command,
                 "The program, as the sandbox sees it, and its arguments")
      .required();
  box.add_option("--kind", options->kind, "The purpose of the sandbox")
      .one_of({"answer", "judge", "compile"});
  box.add_option("--show", options->shown, "HOST=BOX: a file or folder it may read").one_value();
  box.add_option("--writable", options->writable, "HOST=BOX: a folder it may write to");
  box.add_option("--folder", options->folder, "Where it starts");
  box.add_option("--cpu", options->limits.cpu_seconds, "Seconds of processor time");
  box.add_option("--wall", options->limits.wall_seconds, "Seconds of elapsed time");
  box.add_option("--idle", options->limits.idle_seconds,
                 "Seconds for which all processes may sleep");
  box.add_option("--memory", options->limits.memory_mb, "Megabytes");
  box.add_option("--processes", options->limits.processes, "Number of processes and threads");
  box.add_option("--output", options->limits.output_bytes, "Bytes that it may print");
  box.add_option("--file-size", options->limits.files_mb, "Megabytes of its /tmp and of one file");
  box.add_option("--files", options->limits.files, "Files in its /tmp");
  box.add_option("--times", options->times, "Number of runs; the time is the mean");
  box.callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
