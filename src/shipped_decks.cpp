// SPDX-License-Identifier: GPL-3.0-or-later
#include "shipped_decks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "deck/spelling.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;

/// Longer titles are cut after a word.
constexpr std::size_t longest_title = 100;

/// Returns where the first sentence ends: before a line or after a full stop that a capital follows.
std::size_t end_of_sentence(const std::string& header) {
  for (std::size_t k = 1; k + 1 < header.size(); ++k) {
    const bool capital = std::isupper(static_cast<unsigned char>(header[k + 1])) != 0;
    if (capital && (header[k] == '\n' || (header[k] == ' ' && header[k - 1] == '.'))) return k;
  }
  return header.size();
}

/// The first sentence of a deck's header, without the lines in quotes that the thesis' decks begin with.
std::string title_of(const std::string& text) {
  std::string header;
  for (const std::string& line : split_lines(text.substr(0, text.find('$')))) {
    const bool quoted = line.find_first_of("\"'") == line.find_first_not_of(" ");
    if (!quoted) header += line + "\n";
  }
  if (const auto rest = header.find_first_not_of("' "); rest != std::string::npos) header = header.substr(rest);
  std::string title(trim(header.substr(0, end_of_sentence(header))));
  std::replace(title.begin(), title.end(), '\n', ' ');
  if (title.size() <= longest_title) return title;
  return title.substr(0, title.rfind(' ', longest_title)) + " ...";
}

std::string name_of(const fs::path& deck, const fs::path& decks) {
  return deck.lexically_relative(decks).replace_extension().generic_string();
}

/// Names a file where all are next to each other.
std::string flat_name(const fs::path& file, const fs::path& decks) {
  const fs::path inside = file.lexically_relative(decks);
  if (*inside.begin() == "..") return file.filename().string();
  std::string name = inside.generic_string();
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

/// The files that are to be written, by their names.
class Copies {
 public:
  explicit Copies(fs::path decks) : decks_(std::move(decks)) {}

  /// A deck's text, and with it all that it names.
  void add_deck(const fs::path& deck) {
    const std::string name = flat_name(deck, decks_);
    if (texts_.contains(name)) return;
    texts_[name] = "";  // so that a deck that names itself comes to an end
    texts_[name] = with_flat_names(read_file(deck), deck.parent_path());
  }
  const std::map<std::string, std::string>& texts() const { return texts_; }

 private:
  /// Every text in quotes that is the way to a file of the decks' becomes that file's name.
  std::string with_flat_names(const std::string& text, const fs::path& from) {
    std::string result;
    std::size_t done = 0;
    for (std::size_t open = text.find('\''); open != std::string::npos; open = text.find('\'', done)) {
      const std::size_t close = text.find('\'', open + 1);
      if (close == std::string::npos) break;
      result += text.substr(done, open + 1 - done);
      done = open + 1;  // an apostrophe of the header opens nothing
      const auto file = file_named(text.substr(done, close - done), from);
      if (file) result += add_file(*file), done = close;
    }
    return result + text.substr(done);
  }

  std::optional<fs::path> file_named(const std::string& quoted, const fs::path& from) const {
    if (quoted.find('.') == std::string::npos || quoted.find('\n') != std::string::npos) return std::nullopt;
    std::error_code none;
    fs::path file = (from / quoted).lexically_normal();
    if (!fs::is_regular_file(file, none)) return std::nullopt;
    return file;
  }

  std::string add_file(const fs::path& file) {
    const std::string name = flat_name(file, decks_);
    if (file.extension() == ".in")
      add_deck(file);
    else
      texts_[name] = read_file(file);
    return name;
  }

  fs::path decks_;
  std::map<std::string, std::string> texts_;
};

void refuse_unknown(const std::vector<ShippedDeck>& all, const std::string& name) {
  std::vector<std::string> names;
  for (const ShippedDeck& deck : all) names.push_back(deck.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  const std::string word = lower(name.substr(0, 40)), near = nearest_name(word, names);
  std::erase_if(names,
                [&](const std::string& other) { return other != near && other.find(word) == std::string::npos; });
  throw InputError(
      fmt::format("there is no deck {}", in_quotes(name)),
      names.empty() ? "tether decks lists them" : fmt::format("Did you mean '{}'?", fmt::join(names, "' or '")));
}

}  // namespace

std::vector<ShippedDeck> shipped_decks(const fs::path& folder) {
  std::vector<ShippedDeck> found;
  for (const auto& file : fs::recursive_directory_iterator(folder / "decks")) {
    const bool of_numbers = file.path().parent_path().filename() == "published";  // other decks' published numbers
    if (file.path().extension() == ".in" && !of_numbers)
      found.push_back({name_of(file.path(), folder / "decks"), title_of(read_file(file.path()))});
  }
  std::sort(found.begin(), found.end(), [](const ShippedDeck& a, const ShippedDeck& b) {
    const bool deep_a = a.name.find('/') != std::string::npos, deep_b = b.name.find('/') != std::string::npos;
    return deep_a != deep_b ? deep_b : a.name < b.name;
  });
  return found;
}

std::vector<fs::path> copy_shipped_deck(const fs::path& folder, const std::string& name, const fs::path& into) {
  refuse_unknown(shipped_decks(folder), name);
  const fs::path deck = folder / "decks" / (name + ".in");
  Copies copies(folder / "decks");
  copies.add_deck(deck);
  for (const auto& [file, text] : copies.texts()) {
    if (fs::exists(into / file))
      throw FileError(fmt::format("{}: is there already; nothing was copied", (into / file).string()));
  }
  std::error_code reason;
  fs::create_directories(into, reason);
  if (reason) throw FileError(fmt::format("{}: the folder cannot be made: {}", into.string(), reason.message()));
  std::vector<fs::path> written{into / flat_name(deck, folder / "decks")};
  for (const auto& [file, text] : copies.texts()) {
    write_file(into / file, text);
    if (into / file != written.front()) written.push_back(into / file);
  }
  return written;
}

}  // namespace tether
