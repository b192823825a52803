// contact watch: after each save, which tests pass and the first failure whole.

#include <array>
#include <ctime>
#include <map>

#include "../../grading/progress/progress.hpp"
#include "../../grading/run/run.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "report.hpp"
#include "watch_files.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Book;
using grading::Exercise;

// An editor that writes in place first empties the file; give it this long to fill it again.
constexpr std::uint64_t empty_file_milliseconds = 50;

struct Watched {
  const Exercise* exercise = nullptr;
  FileState checked;  ///< the state that the last verdict is about
  bool pending = false;
};

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%H:%M:%S", &parts);
  return text.data();
}

class Watch {
 public:
  Watch(Context& context, const std::vector<std::string>& names, bool poll)
      : book_(context.book()),
        loop_(context.loop()),
        limits_(grading::limits_from_environment()),
        progress_(book_.work()),
        always_poll_(poll) {
    for (const Exercise* exercise : book_.chosen(names)) {
      Watched watched;
      watched.exercise = exercise;
      files_[book_.work_file(*exercise)] = watched;
    }
  }

  void run() {
    if (files_.empty())
      throw grading::BookError("there is nothing to watch: the book has no exercises yet");
    make_copies();
    if (!progress_.notice().empty()) note(progress_.notice());
    std::vector<fs::path> paths;
    for (auto& [path, watched] : files_) {
      watched.checked = state_of(path);
      paths.push_back(path);
    }
    const FileWatcher watcher(loop_, paths, always_poll_,
                              [this](const fs::path& file) { saved(file); });
    for (const fs::path& folder : watcher.polled())
      note(style_.dim("Saves in " + shown(folder) +
                      " are polled five times a second: no events arrive from there."));
    if (files_.size() == 1) check(files_.begin()->first, files_.begin()->second);
    say_ready();
    while (true) {
      bool checked = false;
      for (auto& [path, watched] : files_) {
        if (!watched.pending) continue;
        check(path, watched);
        checked = true;
      }
      if (!checked) loop_.run_once();
    }
  }

 private:
  void make_copies() {
    std::map<fs::path, std::vector<std::string>> made;
    for (const auto& [path, watched] : files_) {
      if (start_exercise(book_, *watched.exercise))
        made[path.parent_path()].push_back(path.filename().string());
    }
    for (const auto& [folder, names] : made) {
      std::string text = "Made in " + shown(folder) + "/:";
      for (const std::string& name : names) text += " " + name;
      say(wrapped(text, 0));
    }
  }

  void say_ready() {
    if (files_.size() == 1)
      say(style_.dim("Watching " + shown(files_.begin()->first) +
                     ": save it to check it. Ctrl-C ends."));
    else
      say(style_.dim("Watching " + std::to_string(files_.size()) + " files in " +
                     shown(book_.work()) + "/: save one to check it. Ctrl-C ends."));
  }

  // Called from the loop, also while a check runs.
  void saved(const fs::path& file) {
    const auto found = files_.find(file);
    if (found == files_.end()) return;
    if (state_of(file) == found->second.checked) return;
    found->second.pending = true;
    if (file == checking_) loop_.cancel();
  }

  void check(const fs::path& path, Watched& watched) {
    watched.pending = false;
    FileState state = state_of(path);
    if (!state.exists || state.size == 0) {
      wait(empty_file_milliseconds);
      state = state_of(path);
    }
    if (!state.exists) return;
    watched.checked = state;
    checking_ = path;
    loop_.clear_cancel();
    try {
      const grading::BuildDescription build =
          grading::ready_build(loop_, book_, {watched.exercise});
      const grading::Verdict verdict = grading::check_file(loop_, book_, build, *watched.exercise,
                                                           path, limits_, progress_.known());
      checking_.clear();
      // Saved again while it was compiled: the verdict is about a file that is gone.
      if (!(state_of(path) == state)) {
        watched.pending = true;
        return;
      }
      say("\n" + style_.dim("-- " + time_of_day() + " --"));
      say(report(verdict, style_, {}));
      progress_.record(verdict);
    } catch (const grading::Cancelled&) {
      watched.pending = true;
    } catch (const grading::BookError& error) {
      note(style_.bad("contact: ") + error.what());
    }
    checking_.clear();
    loop_.clear_cancel();
  }

  void wait(std::uint64_t milliseconds) {
    const std::uint64_t end = uv_hrtime() + milliseconds * 1'000'000;
    while (uv_hrtime() < end) {
      loop_.poll();
      uv_sleep(2);
    }
  }

  const Book& book_;
  grading::Loop& loop_;
  grading::Limits limits_;
  grading::Progress progress_;
  bool always_poll_;
  Style style_{stdout};
  std::map<fs::path, Watched> files_;
  fs::path checking_;
};

}  // namespace

void add_watch(Command app, Action& action) {
  auto names = std::make_shared<std::vector<std::string>>();
  auto poll = std::make_shared<bool>(false);
  const Command command =
      app.add_subcommand("watch", "Check a copy each time you save it, until Ctrl-C");
  command.add_option("exercise", *names,
                     "Exercises or chapters; all if none is named. Missing copies are made");
  command.add_flag("--poll", *poll,
                   "Poll for saves five times a second instead of waiting for events");
  command.callback([&action, names, poll] {
    action = [names, poll](Context& context) {
      Watch(context, *names, *poll).run();
      return static_cast<int>(exit_passed);
    };
  });
}

}  // namespace contact::cli
