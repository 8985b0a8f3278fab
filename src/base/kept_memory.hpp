// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// Lets the process keep the memory that it frees. Steps make and drop arrays of one size again and again; by glibc's
/// own rules large ones go back to the kernel each time, which then clears their pages anew: in space that was up to a
/// third of a step. To be called before anything large is made.
void keep_freed_memory();

}  // namespace tether
