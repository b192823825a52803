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
    "grade", "Grade a folder of submissions, each kept apart from everything else",
    "contact-grade"};
inline constexpr Elsewhere grade_worker_command{
    "grade-worker", "Grade units as `contact grade` says", "contact-grade"};
inline constexpr Elsewhere ladder_command{
    "ladder", "Accuracy against time of a chapter's methods, measured here", "contact-authors"};
inline constexpr Elsewhere scene_command{
    "scene", "Scenes: whether a file is one, and which the book has", "contact-scenes"};
inline constexpr Elsewhere plan_command{
    "plan", "Which effects a scene calls for, with the numbers that decide", "contact-scenes"};
inline constexpr Elsewhere simulate_command{
    "simulate",
    "Runs scenes as their plans decide: by a formula, from event to event, or step by step",
    "contact-scenes"};
inline constexpr Elsewhere new_command{
    "new", "For authors: make the folders of a chapter or an exercise", "contact-authors"};
inline constexpr Elsewhere where_command{
    "where", "Every file of an exercise or a chapter, one a line, from the root on",
    "contact-authors"};
inline constexpr Elsewhere doctor_command{
    "doctor", "What is installed, what is missing and what to do", "contact-authors"};
inline constexpr Elsewhere dev_command{
    "dev", "For authors: prove that the whole tree does what it must", "contact-authors"};

/// All that are built here, in the order of `contact --help`; the worker's is hidden.
const std::vector<Elsewhere>& commands_elsewhere();

/// Becomes the program of the command that argv names, if another program has it; else returns.
/// @throws std::runtime_error if that program is not there, or cannot be started
void go_elsewhere(int argc, char** argv);

}  // namespace contact::cli
