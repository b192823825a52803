#pragma once

// The command line, over CLI11. That library is included in one file only, because including it
// takes the compiler six seconds.

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsewhere.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace contact::cli {

/// An option of a command, or one of its words.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  const Option& required() const;
  /// Not both of them.
  const Option& excludes(const Option& other) const;
  const Option& one_of(const std::vector<std::string>& words) const;
  const Option& existing_file() const;
  const Option& positive() const;
  const Option& between(int least, int most) const;
  /// Several values in one word.
  const Option& separated_by(char separator) const;
  /// One value per use of an option that may be given several times.
  const Option& one_value() const;
  /// So many values, each a word of its own.
  const Option& values(int count) const;
  /// Its value may be missing: then it is this one.
  const Option& alone(const std::string& value) const;
  /// How help names its value.
  const Option& type_name(const std::string& name) const;
  /// What help shows instead of CLI11's description of the value.
  const Option& option_text(const std::string& text) const;

 private:
  CLI::Option* option_;
};

/// A command, with its options and the commands under it. It points into a CommandLine.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  [[nodiscard]] Command add_subcommand(const std::string& name, const std::string& what) const;
  [[nodiscard]] Command add_subcommand(const Elsewhere& command) const {
    return add_subcommand(command.name, command.what);
  }
  /// Instantiated in command_line.cpp for the types that are used.
  template <class T>
  Option add_option(const std::string& names, T& value, const std::string& what) const;
  Option add_flag(const std::string& names, bool& value, const std::string& what) const;
  /// Run when the command was chosen and its options are read.
  void callback(const std::function<void()>& chosen) const;
  /// One of the commands under it must be named.
  void require_subcommand() const;
  /// Help does not show it.
  void hide() const;

 private:
  CLI::App* app_;
};

/// For a callback: something is missing that only this combination of options asks for. The text is
/// the whole message, with a command that has it.
class MissingOption : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All of it.
class CommandLine {
 public:
  CommandLine(const std::string& what, const std::string& name, const std::string& version,
              const std::string& footer);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine();

  [[nodiscard]] Command top() const;
  /// True if a command is to be run. Otherwise help, the version or what is wrong was printed, and
  /// `exit_code` says how to end.
  [[nodiscard]] bool parse(int argc, char** argv, int& exit_code) const;

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace contact::cli
