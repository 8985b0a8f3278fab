// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "deck/particle_file.hpp"
#include "laws/elastic.hpp"
#include "laws/hyperelastic.hpp"
#include "laws/material.hpp"

namespace tether {

/// The word of region r's elastic law: that of $reg, which holds for points and meshes alike, or on a mesh that of
/// $fem; nothing where a region of points has none.
std::string law_word(const Deck& deck, int r);

/// Returns what the deck says of the elastic region r, which `plane` holds across.
ElasticConstants elastic_constants(const Deck& deck, int r, Plane plane);

/// Reports where $reg and $fem give a region of a mesh different laws.
void check_law_words(const Deck& deck, int r, Diagnostics& diagnostics);

/// The law of a table that has this word.
template <class Table, std::size_t k = 0>
std::optional<Table> law_of_word(std::string_view word, const ElasticConstants& given) {
  if constexpr (k == std::variant_size_v<Table>) {
    return std::nullopt;
  } else {
    using Law = std::variant_alternative_t<k, Table>;
    return word == Law::word ? std::optional<Table>(Law::of(given)) : law_of_word<Table, k + 1>(word, given);
  }
}

/// The law of region r (from 1) by ipath(4, r), with the constants of matr and $fluid; $mpm density wins over it.
std::optional<Material> region_material(const Deck& deck, int r, Diagnostics& diagnostics);

/// The law of a particle file by its own ipath(4) and constants.
std::optional<Material> file_material(const Deck& deck, const ParticleFile& file, Diagnostics& diagnostics);

/// The law of membrane b (from 1) with Young's modulus E and Poisson's ratio nu.
Membrane membrane_law(const Deck& deck, int b, double E, double nu);

}  // namespace tether
