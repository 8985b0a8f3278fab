// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/summary_keys.hpp"

#include "base/file.hpp"
#include "base/text.hpp"

namespace tether {
namespace {

/// Sides in force_on of $flow.
constexpr int force_side_count = 10;

/// The kinds of runs that write a key: "points, flows", or "all".
std::string kinds_text(unsigned of) {
  using namespace runs_of;
  if (of == all) return "all";
  constexpr std::array<std::pair<unsigned, const char*>, 6> kinds{{{points, "points"},
                                                                   {bars, "bars"},
                                                                   {solids, "bodies"},
                                                                   {rigid, "rigid body"},
                                                                   {flows, "flows"},
                                                                   {boxes, "boxes"}}};
  std::string text;
  for (const auto& [kind, word] : kinds) {
    if ((of & kind) != 0) text += (text.empty() ? "" : ", ") + std::string(word);
  }
  return text;
}

/// The solutions that a figure of merit is of: "spring, piston".
std::string solutions_text(const FigureRow& row) {
  std::string text;
  for (const auto& [kind, word] : words<ReferenceKind>) {
    if ((row.solutions & bit(kind)) != 0) text += (text.empty() ? "" : ", ") + std::string(word);
  }
  return text;
}

/// A row of either list in words.
struct KeyText {
  std::string key, of;
  Dimension dimension;
  std::string meaning;
};

std::vector<KeyText> all_rows() {
  std::vector<KeyText> rows;
  for (const SummaryRow& row : summary_rows) {
    const std::string when = row.when.empty() ? "" : fmt::format(": {}", row.when);
    rows.push_back({std::string(row.name), kinds_text(row.of) + when, row.dimension, std::string(row.meaning)});
  }
  rows.push_back({"drag_1, lift_1 ...", "flows: force_on, speed and length of $flow", Dimension::number,
                  "coefficients of drag and lift at the end"});
  for (const FigureRow& row : figure_rows) {
    const std::string name(row.name),
        keys = row.profile ? "error_" + name : fmt::format("{0}, exact_{0}, error_{0}", name);
    rows.push_back({keys, "$reference: " + solutions_text(row), row.dimension, std::string(row.meaning)});
  }
  return rows;
}

}  // namespace

std::vector<std::string> summary_keys(unsigned of) {
  std::vector<std::string> keys;
  for (const SummaryRow& row : summary_rows) {
    if ((row.of & of) != 0) keys.emplace_back(row.name);
  }
  for (int k = 1; k <= force_side_count && (of & runs_of::flows) != 0; ++k)
    keys.insert(keys.end(), {fmt::format("drag_{}", k), fmt::format("lift_{}", k)});
  return keys;
}

std::vector<std::string> figure_keys(ReferenceKind reference) {
  std::vector<std::string> keys;
  for (const FigureRow& row : figure_rows) {
    if ((row.solutions & bit(reference)) == 0) continue;
    const std::string name(row.name);
    if (!row.profile) keys.insert(keys.end(), {name, "exact_" + name});
    keys.push_back("error_" + name);
  }
  return keys;
}

std::string keys_listing() {
  std::string text;
  for (const KeyText& row : all_rows())
    text += fmt::format("{:<28} {:<17} {} ({})\n", row.key, dimension_text(row.dimension), row.meaning, row.of);
  return text;
}

std::string keys_markdown() {
  std::string text = "| key | dimension | of | meaning |\n|---|---|---|---|\n";
  for (const KeyText& row : all_rows())
    text += fmt::format("| {} | {} | {} | {} |\n", row.key, dimension_text(row.dimension), row.of, row.meaning);
  return text;
}

Summary read_summary(const std::filesystem::path& path) {
  Summary summary;
  for (const auto& line : split_lines(read_file(path))) {
    const auto equals = line.find(" = ");
    if (line.starts_with('#') || equals == std::string::npos) continue;
    summary.emplace_back(line.substr(0, equals), line.substr(equals + 3));
  }
  return summary;
}

}  // namespace tether
