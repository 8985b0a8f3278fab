# SPDX-License-Identifier: GPL-3.0-or-later
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed OR NOT hash)
  set(hash "unknown")
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#pragma once
#define TETHER_VERSION \"${VERSION}\"
#define TETHER_GIT_HASH \"${hash}\"
")
