// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_words.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <openssl/crypto.h>
#include <CLI/Version.hpp>
#include <algorithm>
#include <boost/version.hpp>
#include <filesystem>
#include <iterator>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "commands.hpp"

namespace tether {
namespace {

constexpr const char* help = "help";

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  names.emplace_back(help);
  return names;
}

const CLI::App* find_command(const CLI::App& app, const std::string& name) {
  const auto all = app.get_subcommands([&name](const CLI::App* command) { return command->get_name() == name; });
  return all.empty() ? nullptr : all.front();
}

/// "--out" of "--out" and of "--out=DIR".
std::string option_name(const std::string& word) { return word.substr(0, word.find('=')); }

/// Returns whether the value of an option is the next word: the command says so where it has such an option, else some
/// command, or a run. `--log` of a run names a file, that of `plot` stands alone.
bool takes_next_word(const CLI::App& app, const CLI::App* command, const std::string& word) {
  if (word.find('=') != std::string::npos) return false;
  const auto wants = [&word](const CLI::App& one) {
    const auto* option = one.get_option_no_throw(word);
    return option != nullptr && option->get_items_expected_max() > 0;
  };
  if (command != nullptr && command->get_option_no_throw(word) != nullptr) return wants(*command);
  const auto all = app.get_subcommands([](const CLI::App*) { return true; });
  return wants(app) || std::any_of(all.begin(), all.end(), [&](const CLI::App* each) { return wants(*each); });
}

bool is_option(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

/// The first word that is neither an option nor an option's value, where it names a command.
const CLI::App* command_among(const CLI::App& app, const std::vector<std::string>& words) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (!is_option(words[k])) return find_command(app, words[k]);
    if (takes_next_word(app, nullptr, words[k])) ++k;
  }
  return nullptr;
}

/// The deck that follows an option without its value must not be taken for that.
[[noreturn]] void refuse_without_value(const std::string& option) {
  throw InputError(fmt::format("{} is not followed by a value; nothing was run", option),
                   option == "--restart" ? "--restart FILE goes on from a checkpoint, a file checkpoint-N.nc in the "
                                           "run's folder"
                                         : "tether --help says what each option takes");
}

/// A command line taken apart: options with their values as they stand, and the words between them.
struct Words {
  std::vector<std::string> options, names, others;
};

Words take_apart(const CLI::App& app, const std::vector<std::string>& words) {
  Words parts;
  bool options = true;
  const CLI::App* command = command_among(app, words);
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (options && word == "--") {
      options = false;
    } else if (options && is_option(word)) {
      parts.options.push_back(option_name(word));
      parts.others.push_back(word);
      if (!takes_next_word(app, command, word)) continue;
      if (k + 1 == words.size() || words[k + 1].starts_with("--")) refuse_without_value(word);
      parts.others.push_back(words[++k]);
    } else {
      parts.names.push_back(word);
    }
  }
  return parts;
}

/// A word that could be one of a command, and names no file: a deck has an ending or stands in a folder.
bool names_nothing(const std::string& word) {
  std::error_code ignored;  // of names that no file can have
  return word.find_first_of("./") == std::string::npos && !std::filesystem::exists(word, ignored);
}

/// A deck's value that stands there without its option, as the second one after one --set.
void refuse_values(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto equals = name.find('='), dot = name.find('.');
    std::error_code ignored;  // of names that no file can have
    if (equals == std::string::npos || dot > equals || std::filesystem::exists(name, ignored)) continue;
    throw InputError(
        fmt::format("{} is no file, and a deck's value stands after --set; nothing was run", in_quotes(name)),
        fmt::format("Repeat --set for each value: --set {}", name));
  }
}

[[noreturn]] void refuse_word(const CLI::App& app, const std::string& word, bool first) {
  const auto names = commands_of(app);
  if (!first && std::find(names.begin(), names.end(), word) != names.end())
    throw InputError(fmt::format("'{}' is a command and stands before the deck", word),
                     fmt::format("tether {} DECK", word));
  const std::string near = nearest_name(lower(word.substr(0, 40)), names);
  throw InputError(fmt::format("{} is no command and names no file; nothing was run", in_quotes(word)),
                   fmt::format("{}The commands are {}; tether DECK runs a deck.",
                               near.empty() ? "" : fmt::format("Did you mean '{}'? ", near), command_names(app)));
}

/// `called` is the app of the command, or the whole for a run.
void check_options(const CLI::App& called, const std::string& who, const std::vector<std::string>& options) {
  std::vector<std::string> known;
  for (const auto* option : called.get_options()) {
    if (!option->get_positional()) known.push_back("--" + option->get_single_name());
  }
  for (const auto& option : options) {
    if (called.get_option_no_throw(option) != nullptr) continue;
    const std::string near = nearest_name(option.substr(0, 40), known);
    throw InputError(fmt::format("{} has no option {}", who, in_quotes(option)),
                     fmt::format("{}{} --help lists its options.",
                                 near.empty() ? "" : fmt::format("Did you mean '{}'? ", near), who));
  }
}

/// check, plan and sweep take one deck each.
void check_count(const CLI::App& command, const std::vector<std::string>& names) {
  std::size_t most = 0;
  std::string wanted;
  for (const auto* option : command.get_options()) {
    if (!option->get_positional()) continue;
    wanted = option->get_name(true);
    most += static_cast<std::size_t>(option->get_items_expected_max());
  }
  if (names.size() <= most) return;
  std::string all;
  for (const auto& name : names) all += " " + in_quotes(name);
  if (most == 0)
    throw InputError(fmt::format("tether {} takes no names, not{}", command.get_name(), all),
                     fmt::format("tether {} --help says what it takes", command.get_name()));
  throw InputError(fmt::format("tether {} takes one {}, not {}:{}", command.get_name(), wanted, names.size(), all),
                   fmt::format("Call it once for each: tether {} {}", command.get_name(), names.front()));
}

std::vector<std::string> of_help(const CLI::App& app, const std::vector<std::string>& names) {
  if (names.empty()) return {"--help"};
  if (find_command(app, names.front()) == nullptr) refuse_word(app, names.front(), true);
  return {names.front(), "--help"};
}

/// Options first; what could be taken for one comes after "--".
std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& names) {
  if (std::any_of(names.begin(), names.end(), [](const auto& name) { return name.starts_with('-'); }))
    words.emplace_back("--");
  words.insert(words.end(), names.begin(), names.end());
  return words;
}

}  // namespace

std::string command_names(const CLI::App& app) {
  std::string text;
  for (const auto& name : commands_of(app)) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<std::string> ordered_words(const CLI::App& app, const std::vector<std::string>& words) {
  auto [options, names, others] = take_apart(app, words);
  if (std::find(options.begin(), options.end(), "--version") != options.end()) return {"--version"};
  const std::string first = names.empty() ? "" : names.front();
  if (first == help) return of_help(app, {names.begin() + 1, names.end()});
  if (const CLI::App* command = find_command(app, first)) {
    names.erase(names.begin());
    check_options(*command, "tether " + first, options);
    if (command->get_option_no_throw("--set") != nullptr) refuse_values(names);
    if (std::find(options.begin(), options.end(), "--help") == options.end()) check_count(*command, names);
    others.insert(others.begin(), first);
    return joined(std::move(others), names);
  }
  if (names_nothing(first) && !names.empty()) refuse_word(app, first, true);
  check_options(app, "tether", options);
  refuse_values(names);
  const auto lost = std::find_if(names.begin(), names.end(), names_nothing);
  if (lost != names.end()) refuse_word(app, *lost, false);
  return joined(std::move(others), names);
}

namespace {

/// "4.9.0": what stands before the date of its build.
std::string netcdf_version() {
  const std::string text = nc_inq_libvers();
  return text.substr(0, text.find(' '));
}

}  // namespace

std::string version_text() {
  return fmt::format("tether {} ({})\nnetcdf {}\nfmt {}.{}.{}\nCLI11 {}\nBoost {}.{}\n{}", program_version(),
                     git_hash(), netcdf_version(), FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                     CLI11_VERSION, BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                     OpenSSL_version(OPENSSL_VERSION));
}

}  // namespace tether
