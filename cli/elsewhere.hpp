#pragma once

// The commands of the other programs, which are separate so that a check of an exercise need not
// wait until they are compiled.

#include <string>
#include <vector>

namespace contact::cli {

/// A command of another program in the same folder.
struct Elsewhere {
  const char* name;
  const char* what;
  const char* program;
};

inline constexpr Elsewhere grade_command{
    "grade", "Grade a folder of submissions, each in a sandbox", "contact-grade"};
inline constexpr Elsewhere grade_worker_command{
    "grade-worker", "Grade units as `contact grade` says", "contact-grade"};
inline constexpr Elsewhere ladder_command{
    "ladder", "Measure accuracy against time of a chapter's methods", "contact-authors"};
inline constexpr Elsewhere scene_command{"scene", "Scenes: check a file, or list those of the book",
                                         "contact-scenes"};
inline constexpr Elsewhere plan_command{
    "plan", "Which effects a scene needs, with the deciding numbers", "contact-scenes"};
inline constexpr Elsewhere simulate_command{
    "simulate",
    "Runs scenes as their plans decide: by a formula, from event to event, or step by step",
    "contact-scenes"};
inline constexpr Elsewhere new_command{
    "new", "For authors: create the folders of a chapter, an exercise or a pack",
    "contact-authors"};
inline constexpr Elsewhere where_command{
    "where", "List the files of an exercise or a chapter, relative to the root", "contact-authors"};
inline constexpr Elsewhere doctor_command{
    "doctor", "What is installed, what is missing and what to do", "contact-authors"};
inline constexpr Elsewhere dev_command{"dev", "For authors: check the whole repository",
                                       "contact-authors"};

/// All that are built here, in the order of `contact --help`; the worker's is hidden.
const std::vector<Elsewhere>& commands_elsewhere();

/// Becomes the program of the command that argv names, if another program has it; else returns.
/// @throws std::runtime_error if that program is not there, or cannot be started
void go_elsewhere(int argc, char** argv);

}  // namespace contact::cli
