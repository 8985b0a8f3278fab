# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of tether's commands and options for bash, which asks the program itself for them.
_tether() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} commands options
  commands=$(tether --help 2>/dev/null | sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p')
  if [[ $COMP_CWORD -eq 1 && $word != -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word"; compgen -f -X '!*.in' -- "$word"; compgen -d -- "$word")
    return
  fi
  [[ " ${commands//$'\n'/ } " == *" $command "* ]] || command=
  if [[ $word == -* ]]; then
    options=$(tether ${command:+"$command"} --help 2>/dev/null | grep -oE '^  (-h,)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif [[ $command == decks && ${COMP_WORDS[COMP_CWORD-1]} == get ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(tether decks 2>/dev/null | cut -d' ' -f1)" -- "$word")
  elif [[ $command == decks ]]; then
    mapfile -t COMPREPLY < <(compgen -W get -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -o filenames -F _tether tether
