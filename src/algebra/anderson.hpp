// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

namespace tether {

/// Finds x with f(x) = 0 from what f was at the guesses so far: the next one is where the residual would be least if f
/// were linear, and goes on from there by the residual. For a linear f it is about GMRES. Source: H. F. Walker, P. Ni,
/// SIAM J. Numer. Anal. 49 (2011) 1715-1735, Anderson acceleration.
///
/// An f that is not quite linear makes each change from guess to guess known to a part of itself alone: large changes
/// that are to cancel leave that part. So the least residual is sought with that part of each share's change added to
/// it (ridge regression).
class AndersonMixing {
 public:
  /// Residuals are measured with these weights, a number each; as many guesses are kept. Of a change of f the part
  /// `bent` is not linear.
  AndersonMixing(std::vector<double> weight, int kept, double bent)
      : weight_(std::move(weight)), kept_(kept), bent_(bent) {}

  /// Takes f(x) and sets x to the next guess.
  void next(std::span<const double> f, std::span<double> x);

 private:
  Eigen::VectorXd shares_of(const Eigen::VectorXd& residual, Eigen::Index columns) const;

  std::vector<double> weight_;
  int kept_, count_ = 0;
  double bent_;
  Eigen::VectorXd last_x_, last_f_;
  Eigen::MatrixXd dx_, df_;  // changes from guess to guess, f's weighted; the oldest is written over
};

}  // namespace tether
