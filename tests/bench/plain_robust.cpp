// SPDX-License-Identifier: GPL-3.0-or-later
// The robust step of one body as a plain loop: PROGRAM elastic|gas|gas-ledger|elastic-axis|gas-axis [cells ...], see
// plain::Words.
#include "robust.hpp"

namespace {

template <plain::Features f>
class Robust {
 public:
  explicit Robust(const plain::Block& block) : nodes_(block), body_(block, points_of(block)) {
    for (std::size_t p = 0; p < body_.size(); ++p) body_.map(p, nodes_);
  }
  std::size_t size() const { return body_.size(); }
  void step() {
    nodes_.begin();
    for (std::size_t p = 0; p < body_.size(); ++p) body_.pull(p, body_.at(p, nodes_), nodes_);
    nodes_.solve(body_.P.dt);
    for (std::size_t p = 0; p < body_.size(); ++p) body_.move(p, nodes_);
  }
  plain::Totals totals() const {
    plain::Totals totals;
    nodes_.add_to(totals);
    if constexpr (f.ledger) body_.add_energy_to(totals, nodes_.h);
    return totals;
  }

 private:
  plain::Nodes<f> nodes_;
  plain::Body<f> body_;
};

}  // namespace

int main(int argc, char** argv) {
  const plain::Words words(argc, argv);
  if (words.kind == "elastic") return plain::time_loop<Robust<plain::Features{}>>(words);
  if (words.kind == "gas") return plain::time_loop<Robust<plain::Features{.gas = true}>>(words);
  if (words.kind == "gas-ledger") return plain::time_loop<Robust<plain::Features{.gas = true, .ledger = true}>>(words);
  if (words.kind == "elastic-axis") return plain::time_loop<Robust<plain::Features{.axis = true}>>(words);
  if (words.kind == "gas-axis") return plain::time_loop<Robust<plain::Features{.gas = true, .axis = true}>>(words);
  return 2;
}
