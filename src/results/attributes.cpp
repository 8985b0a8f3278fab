// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/attributes.hpp"

#include "base/version.hpp"

namespace tether {

void write_provenance(NetcdfFile& file, const Provenance& provenance) {
  file.global_attribute("Conventions", "CF-1.10");
  file.global_attribute("title", provenance.title);
  file.global_attribute("history", provenance.command);
  file.global_attribute("program", "tether " + program_version());
  file.global_attribute("git_hash", git_hash());
  file.global_attribute("deck", provenance.deck_text);
  file.global_attribute("deck_sha256", provenance.deck_sha256);
  file.global_attribute(run_attribute, provenance.run_sha256);
}

std::size_t provenance_room(const Provenance& provenance) {
  constexpr std::size_t names_and_versions = 4096;
  return provenance.title.size() + provenance.command.size() + provenance.deck_text.size() + names_and_versions;
}

int define_quantity(NetcdfFile& file, const Quantity& quantity, const std::vector<int>& dimensions, Units units) {
  const int variable = file.number_variable(quantity.name, dimensions);
  file.attribute(variable, "units", unit_text(quantity.dimension, units));
  file.attribute(variable, "long_name", quantity.meaning);
  return variable;
}

}  // namespace tether
