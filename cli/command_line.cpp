#include "command_line.hpp"

#include <CLI/CLI.hpp>

#include "exit_codes.hpp"

namespace contact::cli {

const Option& Option::required() const {
  option_->required();
  return *this;
}

const Option& Option::excludes(const Option& other) const {
  option_->excludes(other.option_);
  return *this;
}

const Option& Option::one_of(const std::vector<std::string>& words) const {
  option_->check(CLI::IsMember(words));
  return *this;
}

const Option& Option::existing_file() const {
  option_->check(CLI::ExistingFile);
  return *this;
}

const Option& Option::positive() const {
  option_->check(CLI::Validator(
      [](const std::string& text) {
        long number = 0;
        if (CLI::detail::lexical_cast(text, number) && number > 0) return std::string();
        return text + " is not a whole number from 1";
      },
      "POSITIVE"));
  return *this;
}

const Option& Option::between(int least, int most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

const Option& Option::separated_by(char separator) const {
  option_->delimiter(separator);
  return *this;
}

const Option& Option::one_value() const {
  option_->allow_extra_args(false);
  return *this;
}

const Option& Option::values(int count) const {
  option_->expected(count);
  return *this;
}

const Option& Option::alone(const std::string& value) const {
  option_->expected(0, 1)->default_str(value);
  return *this;
}

const Option& Option::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

const Option& Option::option_text(const std::string& text) const {
  option_->option_text(text);
  return *this;
}

Command Command::add_subcommand(const std::string& name, const std::string& what) const {
  return Command(app_->add_subcommand(name, what));
}

template <class T>
Option Command::add_option(const std::string& names, T& value, const std::string& what) const {
  return Option(app_->add_option(names, value, what));
}

#define INSTANTIATED(T) \
  template Option Command::add_option(const std::string&, T&, const std::string&) const
INSTANTIATED(int);
INSTANTIATED(long);
INSTANTIATED(unsigned);
INSTANTIATED(unsigned long);
INSTANTIATED(double);
INSTANTIATED(std::string);
INSTANTIATED(std::vector<std::string>);
#undef INSTANTIATED

Option Command::add_flag(const std::string& names, bool& value, const std::string& what) const {
  return Option(app_->add_flag(names, value, what));
}

void Command::callback(const std::function<void()>& chosen) const {
  app_->callback([chosen] {
    try {
      chosen();
    } catch (const MissingOption& missing) {
      throw CLI::RequiredError(missing.what(), CLI::ExitCodes::RequiredError);
    }
  });
}

void Command::require_subcommand() const { app_->require_subcommand(1); }

void Command::hide() const { app_->group(""); }

CommandLine::CommandLine(const std::string& what, const std::string& name,
                         const std::string& version, const std::string& footer)
    : app_(std::make_unique<CLI::App>(what, name)) {
  app_->require_subcommand(1);
  app_->footer(footer);
  app_->get_formatter()->column_width(30);
  app_->set_version_flag("--version", version);
}

CommandLine::~CommandLine() = default;

Command CommandLine::top() const { return Command(app_.get()); }

bool CommandLine::parse(int argc, char** argv, int& exit_code) const {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    exit_code = app_->exit(error) == 0 ? exit_passed : exit_usage;
    return false;
  }
  return true;
}

}  // namespace contact::cli
