// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/kept_memory.hpp"

#include <malloc.h>

namespace tether {

void keep_freed_memory() {
  mallopt(M_MMAP_MAX, 0);         // nothing has a mapping of its own, which would go with it
  mallopt(M_TRIM_THRESHOLD, -1);  // and the heap does not shrink
}

}  // namespace tether
