// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace tether {

/// [+-]digits, the whole text; what does not fit is the largest or smallest long long. Else nothing.
std::optional<long long> parse_integer(std::string_view text);

/// A Fortran real, the whole text: [+-] (d+[.d*] | .d+) [(e|d|q)[+-]d+ | [+-]d+], or inf, infinity, nan, in any case.
/// So 1.d-4 and 1.5+3 (= 1500) are numbers. 1e400 gives infinity. Else nothing.
/// Source: Fortran 2018, 13.7.2.3.2, as gfortran's namelist reader takes it.
std::optional<double> parse_real(std::string_view text);

}  // namespace tether
