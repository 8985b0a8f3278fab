// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether::fem {

/// When the corrections of Newton's method share the factors of a matrix, and when they need new ones. New factors have
/// to lead on; kept ones have to lead on so fast that new ones are not cheaper.
///
/// | state | event | what follows |
/// |---|---|---|
/// | none | a correction is due | new ones are made |
/// | new | the residual fell fast | kept |
/// | new | the residual fell slowly, or grew | slow: new ones are made for the next correction |
/// | kept | the residual fell fast | kept |
/// | kept | the residual fell slowly | slow |
/// | kept | the residual grew | none: the correction is taken back |
/// | new | they are no factors of the matrix itself (GMRES) | none, after this correction |
/// | slow | the next step begins | kept: it tries them |
/// | any | the matrix is another one's | none |
class KeptFactors {
 public:
  /// A step begins; its factors are those of the step before unless the matrix is `another` one's.
  void begin_step(bool another);
  void drop() { there_ = false; }

  /// Returns whether the next correction needs new ones.
  bool are_due() const { return !there_ || slow_; }
  /// New ones were made; they last for more than this very iterate where they are factors of the matrix itself.
  void made(bool done, bool lasting);
  /// Judges them by a correction after which the residual is `ratio` of what it was, and `left` tolerances. False where
  /// the correction is to be taken back.
  bool lead_on(double ratio, double left);

 private:
  bool there_ = false, new_ = false, slow_ = false;
};

}  // namespace tether::fem
