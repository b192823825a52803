#pragma once

// One file per command. Each adds its options to the command line and gives the function to run.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "../grading/book/book.hpp"
#include "../grading/process/run_process.hpp"
#include "command_line.hpp"
#include "exit_codes.hpp"

namespace contact::cli {

/// What a command needs, read only when a command runs, so that --help works anywhere.
class Context {
 public:
  [[nodiscard]] const grading::Book& book();
  /// Reads the book again, after files of it changed.
  void reread_book();
  [[nodiscard]] grading::Loop& loop();

 private:
  std::unique_ptr<grading::Book> book_;
  std::unique_ptr<grading::Loop> loop_;
};

/// The command that was chosen; main() runs it after parsing.
using Action = std::function<int(Context&)>;

void add_list(Command app, Action& action);
void add_start(Command app, Action& action);
void add_check(Command app, Action& action);
void add_watch(Command app, Action& action);
void add_hint(Command app, Action& action);
void add_ask(Command app, Action& action);
void add_solution(Command app, Action& action);
void add_reset(Command app, Action& action);
void add_progress(Command app, Action& action);
void add_export(Command app, Action& action);
void add_import(Command app, Action& action);
void add_ladder(Command app, Action& action);
void add_scene(Command app, Action& action);
void add_plan(Command app, Action& action);
void add_simulate(Command app, Action& action);
void add_new(Command app, Action& action);
void add_where(Command app, Action& action);
void add_grade(Command app, Action& action);
void add_grade_worker(Command app, Action& action);
void add_doctor(Command app, Action& action);
void add_dev(Command app, Action& action);
/// Under `dev`: grading, one unit at a time.
void add_dev_grade(Command dev, Action& action);

/// What a reader types before a command: "./contact", and in a pack --pack with its folder.
std::string program_as_typed();

/// Copies the pristine stub to the student's folder unless a copy is there. Returns whether it made
/// one.
bool start_exercise(const grading::Book& book, const grading::Exercise& exercise);
/// Writes the student's copy, and records which form it begins from.
void write_copy(const grading::Book& book, const grading::Exercise& exercise,
                const std::string& text, const std::string& form);

/// The file of a scene: `word` is its path, or the name of a scene of the book.
/// @throws grading::UnknownName, with the nearest names, if it is neither.
std::filesystem::path scene_path(const std::string& word);

/// Saves a text that is about to be replaced in work/.kept under a new name. Returns its path.
std::filesystem::path keep_aside(const grading::Book& book, const std::string& chapter,
                                 const std::string& name, const std::string& text);

}  // namespace contact::cli
