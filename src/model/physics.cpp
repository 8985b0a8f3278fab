// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/physics.hpp"

#include <stdexcept>
#include <utility>

namespace tether {
namespace {

template <class One>
constexpr bool has_solids = requires(One one) {
  one.solids;
};

}  // namespace

const Solids* solids_of(const Physics& physics) {
  return std::visit(
      []<class One>(const One& one) -> const Solids* {
        if constexpr (has_solids<One>) return one.solids.get();
        return nullptr;
      },
      physics);
}

void set_solids(Physics& physics, std::shared_ptr<const Solids> solids) {
  std::visit(
      [&]<class One>(One& one) {
        if constexpr (has_solids<One>)
          one.solids = std::move(solids);
        else
          throw std::logic_error("points have no bodies on a mesh");
      },
      physics);
}

}  // namespace tether
