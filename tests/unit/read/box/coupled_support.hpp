// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/coupled.hpp"
#include "read/path.hpp"
#include "unit/read/scene_support.hpp"

namespace tether::test {

/// A scene of a box of 8 x 4 cells, 0 .. 2 by 0 .. 1, of a fluid of density 2; `coupled`, what else $coupled says, is
/// line 5, `others` begin on line 7, and `in` is what else $in says.
inline Built box(const std::string& coupled, const std::string& others = "", const std::string& in = "",
                 const std::vector<std::string>& overrides = {}) {
  Built built;
  const std::string text = "$in\nnx=9,ny=5,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=2.,tstep=.01," + in +
                           "\n$\n$coupled density=2.,\n" + coupled + "\n$\n" + others;
  const Deck deck = read_deck(text, "a.in", overrides, built.diagnostics);
  built.scene = build_scene(deck, std::nullopt, path_of(deck, built.diagnostics), built.diagnostics);
  return built;
}

/// A body of 2 x 2 squares, .5 .. 1 by .25 .. .75, each of two triangles; `fem` is what $fem says. Line 7 is $reg.
inline std::string square_body(const std::string& fem = "") {
  return "$reg nreg=1,nvi=4,xvi(1,1)=.5,1.,1.,.5,yvi(1,1)=.25,.25,.75,.75,densir=5.,matr(1,1)=100.,.3 $\n"
         "$mesh element='p1',cells(1,1)=2,2 $\n$fem " +
         fem + " $\n";
}

/// The same in space, from z = .25 to .75, and what makes the box four cells deep, 0 .. 1.
inline std::string cube_body(const std::string& fem = "") {
  return "$reg nreg=1,nvi=4,xvi(1,1)=.5,1.,1.,.5,yvi(1,1)=.25,.25,.75,.75,densir=5.,matr(1,1)=100.,.3 $\n"
         "$mesh element='p1',cells(1,1)=2,2,2,z(1,1)=.25,.75 $\n$fem " +
         fem + " $\n";
}
const std::string depth = "nz=5,zback=0.,zfront=1.,";

}  // namespace tether::test
