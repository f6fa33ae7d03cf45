// The options of a subcommand as a table: one row an option, in the order of its help page.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace circumspect::cli {

// Adds an option with this name and meaning, and says where its value goes.
using Place = std::function<CLI::Option*(CLI::App&, const std::string&, const std::string&)>;

struct OptionRow {
  std::string
      name;  // "--seed" or "-o,--output"; without dashes, what is named by its place in the command line
  std::string value;  // what stands behind the name in the help page, as N; flags have none
  Place place;
  std::string meaning;
  std::string contradicts = {};  // the name of a row before it, beside which it must not stand
};

inline void add_options(CLI::App& command, const std::vector<OptionRow>& rows) {
  for (const OptionRow& row : rows) {
    CLI::Option* const option = row.place(command, row.name, row.meaning);
    if (!row.value.empty()) option->option_text(row.value);
    if (!row.contradicts.empty()) option->excludes(command.get_option(row.contradicts));
  }
}

// The places outlive the command.
template <class Value>
Place into(Value& place) {
  return [&place](CLI::App& command, const std::string& name, const std::string& meaning) {
    return command.add_option(name, place, meaning);
  };
}

// `check` refuses values, or replaces words by what they stand for.
template <class Value>
Place into(Value& place, const CLI::Validator& check) {
  return [&place, check](CLI::App& command, const std::string& name, const std::string& meaning) {
    return command.add_option(name, place, meaning)->transform(check);
  };
}

// It must be given.
template <class Value>
Place required(Value& place) {
  return [&place](CLI::App& command, const std::string& name, const std::string& meaning) {
    return command.add_option(name, place, meaning)->required();
  };
}

// Several values, with commas between them.
template <class Value>
Place listed(Value& place) {
  return [&place](CLI::App& command, const std::string& name, const std::string& meaning) {
    return command.add_option(name, place, meaning)->delimiter(',');
  };
}
template <class Value>
Place listed(Value& place, const CLI::Validator& check) {
  return [&place, check](CLI::App& command, const std::string& name, const std::string& meaning) {
    return command.add_option(name, place, meaning)->delimiter(',')->transform(check);
  };
}

inline Place flag(bool& place) {
  return [&place](CLI::App& command, const std::string& name, const std::string& meaning) {
    return command.add_flag(name, place, meaning);
  };
}

// A text that `read` makes something of, or says what is wrong with.
inline Place read_by(std::function<std::string(const std::string&)> read) {
  return [read = std::move(read)](CLI::App& command, const std::string& name,
                                  const std::string& meaning) {
    const auto refuse = [read, name](const std::string& text) {
      const std::string fault = read(text);
      if (!fault.empty()) throw CLI::ValidationError(name, fault);
    };
    return command.add_option_function<std::string>(name, refuse, meaning);
  };
}

}  // namespace circumspect::cli
