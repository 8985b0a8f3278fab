# SPDX-License-Identifier: GPL-3.0-or-later
# The manual page of section 1 from what --help prints, of the program and of each of its commands. Values: PROGRAM, VERSION,
# OUT.
function(help_of text)
  execute_process(COMMAND ${PROGRAM} ${ARGN} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\\" "\\e" help "${help}")
  string(REGEX REPLACE "\n([.'])" "\n\\\\&\\1" help "${help}")
  string(REPLACE "-" "\\-" help "${help}")
  set(${text} "${help}" PARENT_SCOPE)
endfunction()

help_of(whole)
set(page ".TH TETHER 1 \"\" \"tether ${VERSION}\" \"User commands\"
.SH NAME
tether \\- fluid and structure on one deck
.SH DESCRIPTION
.nf
${whole}.fi
")
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE listing)
string(REGEX MATCH "Subcommands:\n.*" listing "${listing}")
string(REGEX MATCHALL "\n  [a-z]+" commands "${listing}")
foreach(command ${commands})
  string(STRIP "${command}" command)
  help_of(one ${command})
  string(TOUPPER ${command} title)
  string(APPEND page ".SH ${title}\n.nf\n${one}.fi\n")
endforeach()
string(APPEND page ".SH SEE ALSO\nThe guides are in /usr/share/tether/decks/README.md.\n")
file(CONFIGURE OUTPUT ${OUT} CONTENT "${page}" @ONLY)
