// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "model/flow.hpp"
#include "read/path.hpp"
#include "unit/read/scene_support.hpp"

namespace tether::test {

/// A scene of these groups; they begin on line 4.
inline Built build_flow(const std::string& groups, const std::vector<std::string>& overrides = {}) {
  Built built;
  const std::string text =
      "$in\nnx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,tmax=2.,tstep=.01,wl=1,wr=1,wb=1,wt=1\n$\n" + groups;
  const Deck deck = read_deck(text, "a.in", overrides, built.diagnostics);
  built.scene = build_scene(deck, std::nullopt, path_of(deck, built.diagnostics), built.diagnostics);
  return built;
}

/// A channel of 4 x 2 cells, 0 .. 2 by 0 .. 1, of density 3 and viscosity .5; `flow`, what $flow says, is line 8.
inline Built channel(const std::string& flow, const std::string& others = "",
                     const std::vector<std::string>& overrides = {}) {
  return build_flow(
      "$reg nreg=1,nvi=4,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,1.,1.,densir=3.,matr(1,1)=.5 $\n"
      "$mesh cells(1,1)=4,2 $\n$fem law='fluid' $\n$flow\n" +
          flow + "\n$\n" + others,
      overrides);
}

/// The same with an elastic body as region 1, .5 .. 1 by .25 .. .75, and the fluid as region 2; `flow` is line 11.
inline Built channel_with_body(const std::string& flow, const std::string& fem = "",
                               const std::vector<std::string>& overrides = {}) {
  return build_flow(
      "$reg nreg=2,nvi=4,4\nxvi(1,1)=.5,1.,1.,.5\nyvi(1,1)=.25,.25,.75,.75\nxvi(1,2)=0.,2.,2.,0.,"
      "yvi(1,2)=0.,0.,1.,1.\ndensir=5.,3.,matr(1,1)=100.,.3,matr(1,2)=.5 $\n$mesh cells(1,1)=2,2,cells(1,2)=4,2 "
      "$\n$fem law(2)='fluid'" +
          fem + " $\n$flow " + flow + "\n$\n",
      overrides);
}

/// A ring of four blocks about the origin, from radius 1 to 2, side 'axle' within and 'rim' without.
inline Built ring(const std::string& element, int cells, const std::string& flow, const std::string& body = "",
                  const std::vector<std::string>& overrides = {}) {
  const std::string a = ".7071067811865476,", b = "1.4142135623730951,", c = "-" + a, d = "-" + b;
  std::string reg, mesh;
  const std::array<std::string, 4> x{a + b + b + a, a + b + d + c, c + d + d + c, c + d + b + a};
  const std::array<std::string, 4> y{c + d + b + a, a + b + b + a, a + b + d + c, c + d + d + c};
  for (int r = 1; r <= 4; ++r) {
    const auto k = static_cast<std::size_t>(r - 1);
    reg += fmt::format("xvi(1,{0})={1}\nyvi(1,{0})={2}\nmatr(1,{0})=1.,\n", r, x[k], y[k]);
    mesh += fmt::format(
        "cells(1,{0})=1,{1},edge(2,{0})='arc',edge(4,{0})='arc',side(2,{0})='rim',side(4,{0})='axle',\n", r, cells);
  }
  return build_flow(
      fmt::format("$reg nreg={0},nvi={0}*4,densir={0}*1.,\n{1}{2}$\n$mesh {3}$\n$fem law=4*'fluid' $\n$flow "
                  "element='{4}',{5} $\n",
                  body.empty() ? 4 : 5, reg, body, mesh, element, flow),
      overrides);
}

/// The side of that name.
inline const FlowSide& side_of(const Flow& flow, const std::string& name) {
  return *std::find_if(flow.sides.begin(), flow.sides.end(), [&](const FlowSide& side) { return side.name == name; });
}

}  // namespace tether::test
